#include "rigor/sim/witness/passage_witness.hpp"

#include "random_vectors.hpp"
#include "rigor/geometry/decomposition/make_mesh.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"
#include "rigor/math/rotation.hpp"
#include "sim/time_stepping_scenes.hpp"

#include <gtest/gtest.h>

namespace rigor::passage_witness_test {
namespace {

/// Two bodies without gravity; the first is fixed.
std::shared_ptr<const Model> pair_of(const Shape& solid, const Shape& body) {
  ModelBuilder builder;
  builder.set_gravity(Vec3::Zero());
  builder.add_material({"m", 1000, 0, 0});
  BodyDescription fixed = test::stepping_body("solid", solid, Vec3::Zero());
  fixed.motion = MotionType::kinematic;
  fixed.mass = {};
  builder.add_body(fixed);
  builder.add_body(test::stepping_body("body", body, Vec3(0, 0, 10)));
  return builder.build();
}

BodyPath straight(double t, const StraightPath& way) {
  return {PathPiece(0, t, way)};
}

StraightPath still() {
  return {};
}

AdvanceReport watched(const std::shared_ptr<const Model>& model, const StraightPath& solid,
                      const StraightPath& body, double t = 1) {
  AdvanceReport report;
  PassageWitness(model).watch(std::vector{straight(t, solid), straight(t, body)}, report);
  return report;
}

TEST(PassageWitness, NamesThePairAndTheTimeOfABodyThatJumpsThroughAPlate) {
  const auto model = pair_of(Box{Vec3(5, 5, 0.001)}, Sphere{0.05});
  const AdvanceReport report =
      watched(model, still(), {Vec3(0, 0, 3), Vec3(0, 0, -1), Quat::Identity(), Vec3::Zero()}, 2);
  // The plate's middle enters the ball first, then the ball's middle the plate.
  EXPECT_EQ(report.passages.instants, 2);
  EXPECT_EQ(report.passages.body_A, 0);
  EXPECT_EQ(report.passages.body_B, 1);
  EXPECT_NEAR(report.passages.first, 2 * (3 - 0.05) / 4, 1e-12);
}

TEST(PassageWitness, SaysNothingOfBodiesThatTouchOrPassBeside) {
  const auto model = pair_of(Box{Vec3(1, 1, 0.001)}, Sphere{0.05});
  // Along the surface, half as deep in it as it is thick; then beside the edge.
  const double z = 0.001 + 0.05 - 0.0005;
  EXPECT_EQ(watched(model, still(), {Vec3(-2, 0, z), Vec3(2, 0, z), Quat::Identity(), Vec3(0, 90, 0)})
                .passages.instants,
            0);
  EXPECT_EQ(watched(model, still(), {Vec3(1.06, 0, 1), Vec3(1.06, 0, -1), Quat::Identity(), Vec3::Zero()})
                .passages.instants,
            0);
}

/// An open sheet has no inside and no marker there.
TEST(PassageWitness, TakesSheets) {
  const auto sheet = std::make_shared<const TriangleMesh>(
      TriangleMesh{{Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(0, 1, 0)}, {{0, 1, 2}}});
  const auto model = pair_of(make_mesh(sheet), Sphere{0.05});
  PassageWitness witness(model);
  State state = make_initial_state(*model);
  for (const double z : {10.0, 9.0, 1.0, 0.1}) {
    Vec3::Map(&state.x[3]) = Vec3(0, 0, z);
    AdvanceReport report;
    witness.watch(state, report);
    EXPECT_EQ(report.passages.instants, 0);
  }
}

/// Two balls go through each other in a step.
TEST(PassageWitness, OfGroupsThatAreWatchedAlreadyItSeesThatTheyPassEachOther) {
  ModelBuilder builder;
  builder.set_gravity(Vec3::Zero());
  builder.add_material({"m", 1000, 0, 0});
  builder.add_body(test::stepping_body("left", Sphere{0.1}, Vec3(-1, 0, 0)));
  builder.add_body(test::stepping_body("right", Sphere{0.1}, Vec3(1, 0, 0)));
  const std::shared_ptr<const Model> model = builder.build();
  const auto passages = [&](const std::vector<int>& groups, const std::vector<bool>& is_here) {
    State state = make_initial_state(*model);
    PassageWitness witness(model);
    witness.watch_only(is_here);
    witness.begin(state);
    for (const int i : {0, 1})
      state.set_body(i, -state.position(i), Quat::Identity(), Vec3::Zero(), Vec3::Zero());
    state.t = 1;
    AdvanceReport report;
    witness.watch(state, report, groups);
    return report.passages.instants;
  };
  EXPECT_EQ(passages({}, {}), 2);
  EXPECT_EQ(passages({0, 1}, {}), 2);
  EXPECT_EQ(passages({0, 0}, {}), 0);
  EXPECT_EQ(passages({-1, 0}, {}), 0);
  EXPECT_EQ(passages({}, {true, true}), 2);
  EXPECT_EQ(passages({}, {true, false}), 0);
}

TEST(PassageWitness, SeesABladeThatTurnsManyTimesInAStep) {
  const auto model = pair_of(Box{Vec3(1, 0.05, 0.001)}, Sphere{0.02});
  const StraightPath spinning{Vec3::Zero(), Vec3::Zero(), Quat::Identity(), Vec3(0, 60, 0)};
  const StraightPath resting{Vec3(0.5, 0, 0.5), Vec3(0.5, 0, 0.5), Quat::Identity(), Vec3::Zero()};
  const AdvanceReport report = watched(model, spinning, resting);
  EXPECT_EQ(report.passages.instants, 1);
  // The blade's end first points at the body after three eighths of a turn about +y.
  EXPECT_NEAR(report.passages.first * 60, 0.75 * M_PI, 0.01);
  const StraightPath beyond{Vec3(0.8, 0, 0.8), Vec3(0.8, 0, 0.8), Quat::Identity(), Vec3::Zero()};
  EXPECT_EQ(watched(model, spinning, beyond).passages.instants, 0);
}

TEST(PassageWitness, StraightPathMakesTheTurnsThatTheVelocitiesSay) {
  const Quat q = rotation_exp(Vec3(0.3, -0.2, 0.9));
  const Vec3 turn = 21.3 * Vec3(1, 2, -2) / 3;
  const StraightPath path = straight_path({Vec3::Zero(), q, turn / 0.1},
                                          {Vec3::UnitX(), rotation_exp(turn) * q, 1.01 * turn / 0.1}, 0.1);
  EXPECT_LT((path.rotation_W - turn).norm(), 1e-12);
}

/// The deepest that the centre of the body is inside the solid box at one of many instants [m].
double deepest_inside(const Box& box, const StraightPath& solid, const StraightPath& body) {
  constexpr int instants = 20000;
  double deepest = -1e9;
  const PathPiece of_solid(0, 1, solid), of_body(0, 1, body);
  for (int k = 0; k <= instants; ++k) {
    const double t = static_cast<double>(k) / instants;
    const Vec3 p = of_solid.pose(t).inverse() * of_body.pose(t).p;
    deepest = std::max(deepest, (box.half_extents - p.cwiseAbs()).minCoeff());
  }
  return deepest;
}

TEST(PassageWitness, AgreesWithBruteForceOnRandomWays) {
  test::Random random(7);
  constexpr double radius = 0.04;
  int inside = 0;
  for (int k = 0; k < 200; ++k) {
    const Box box{Vec3(random.uniform(0.05, 1), random.uniform(0.05, 1), random.uniform(0.05, 1))};
    const auto model = pair_of(box, Sphere{radius});
    const auto way = [&](double size, double turns) {
      return StraightPath{size * random.vector(), size * random.vector(), rotation_exp(2 * random.vector()),
                          turns * random.vector()};
    };
    const StraightPath solid = way(0.5, random.uniform(0, 10)), body = way(2, 0);
    const double deepest = deepest_inside(box, solid, body);
    // A way that begins inside is left alone.
    const Vec3 start = PathPiece(0, 1, solid).pose(0).inverse() * body.from;
    if ((start.cwiseAbs().array() < box.half_extents.array()).all()) continue;
    // Chords leave the way by a quarter of the radius: within that both answers are right. The box's own
    // markers may enter the ball, which is a passage too, if they come as near to its centre.
    const bool is_found = watched(model, solid, body).passages.instants > 0;
    if (deepest > 0.25 * radius) {
      EXPECT_TRUE(is_found) << "case " << k;
    }
    if (deepest < -1.25 * radius) {
      EXPECT_FALSE(is_found) << "case " << k;
    }
    inside += deepest > 0;
  }
  EXPECT_GT(inside, 20);
}

}  // namespace
}  // namespace rigor::passage_witness_test
