// What the witness leaves out by its bounds against the same witness along all paths.

#include "rigor/sim/witness/watched_pairs.hpp"

#include "random_vectors.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/sim/witness/passage_witness.hpp"
#include "rigor/sim/witness/step_path.hpp"
#include "sim/time_stepping_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace rigor::watched_pairs_test {
namespace {

constexpr double room = 1;     // Half the side of the room in which the bodies move [m].
constexpr double step = 0.01;  // [s].

Shape random_shape(test::Random& random) {
  const double size = random.uniform(0.03, 0.2);
  const auto share = [&] { return size * random.uniform(0.1, 1); };
  switch (static_cast<int>(random.uniform(0, 5))) {
    case 0:
      return Sphere{size};
    case 1:
      return Box{Vec3(share(), share(), share())};
    case 2:
      return Capsule{share(), size};
    case 3:
      return Cylinder{share(), share()};
    default: {
      std::vector<Vec3> points;
      for (int k = 0; k < 12; ++k) points.push_back(size * random.vector());
      return Convex{std::make_shared<ConvexHull>(std::get<ConvexHull>(make_convex_hull(points)))};
    }
  }
}

/// Bodies of one or two shapes, off their centres of mass too, above a floor; each fifth is fixed.
std::shared_ptr<const Model> random_crowd(test::Random& random) {
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -9.81));
  builder.add_material({"m", 1000, 0, 0});
  BodyDescription floor = test::stepping_body("floor", HalfSpace{Vec3::UnitZ(), 0}, Vec3(0, 0, -0.5 * room));
  floor.motion = MotionType::fixed;
  floor.mass = {};
  builder.add_body(floor);
  for (int i = 0; i < 24; ++i) {
    BodyDescription body =
        test::stepping_body("b" + std::to_string(i), random_shape(random), room * random.vector());
    if (i % 3 == 0)
      body.shapes.push_back({random_shape(random), 0.2 * random.vector(), Quat::Identity(), "m", ""});
    body.q_WU = rotation_exp(3 * random.vector());
    if (i % 5 == 4) {
      body.motion = MotionType::fixed;
      body.mass = {};
    }
    builder.add_body(body);
  }
  return builder.build();
}

/// Moves the bodies as no contact would let them: some creep, some fly or spin fast, some jump now and then.
void move_on(const Model& model, test::Random& random, State& state) {
  for (int i = 0; i < model.body_count(); ++i) {
    const Body& body = model.body(i);
    if (body.motion == MotionType::fixed) continue;
    const double speeds[] = {0.01, 0.3, 3, 30}, spins[] = {0, 1, 20, 300};
    const bool jumps = random.uniform(0, 1) < 0.02;
    // Most go on as before; some turn round.
    Vec3 v = state.linear_momentum(i) / body.mass;
    const Quat q = state.orientation(i);
    Vec3 w = angular_velocity(model, state, i);
    if (state.t == 0 || random.uniform(0, 1) < 0.1) {
      v = speeds[i % 4] * random.vector();
      w = spins[(i / 4) % 4] * random.vector();
    }
    Vec3 x = state.position(i) + step * v + (jumps ? Vec3(0.3 * random.vector()) : Vec3::Zero());
    // Those that leave the room come back.
    for (int k = 0; k < 3; ++k) {
      if (std::abs(x[k]) > room) v[k] = -std::copysign(v[k], x[k]);
    }
    const Quat r = (rotation_exp(step * w) * q).normalized();
    const Mat3 R = rotation_matrix(r);
    const Vec3 L = R * body.moments.cwiseProduct(R.transpose() * w);
    state.set_body(i, x, r, body.mass * v, L);
  }
  state.t += step;
}

TEST(WatchedPairs, LeavesOutNothingThatFollowingAllPathsFinds) {
  test::Random random(3);
  long found = 0;
  for (int crowd = 0; crowd < 20; ++crowd) {
    SCOPED_TRACE(crowd);
    const std::shared_ptr<const Model> model = random_crowd(random);
    const Environment environment(*model);
    State state = make_initial_state(*model);
    PassageWitness watched(model), followed(model);
    watched.begin(state);
    for (int k = 0; k < 100; ++k) {
      SCOPED_TRACE(k);
      const State before = state;
      move_on(*model, random, state);
      AdvanceReport report, all;
      watched.watch(state, report);
      std::vector<BodyPath> paths;
      for (int i = 0; i < model->body_count(); ++i)
        paths.push_back({step_path(*model, environment, i, before, state)});
      followed.watch(paths, all);
      ASSERT_EQ(report.passages.instants, all.passages.instants);
      ASSERT_EQ(report.passages.body_A, all.passages.body_A);
      ASSERT_EQ(report.passages.body_B, all.passages.body_B);
      ASSERT_EQ(report.passages.first, all.passages.first);
      found += all.passages.instants;
    }
  }
  EXPECT_GT(found, 1000);
}

TEST(WatchedPairs, AStateFromElsewhereIsLookedAtAnew) {
  ModelBuilder builder;
  builder.set_gravity(Vec3::Zero());
  builder.add_material({"m", 1000, 0, 0});
  BodyDescription plate = test::stepping_body("plate", Box{Vec3(1, 1, 0.01)}, Vec3::Zero());
  plate.motion = MotionType::fixed;
  plate.mass = {};
  builder.add_body(plate);
  builder.add_body(test::stepping_body("ball", Sphere{0.05}, Vec3(0, 0, 5)));
  const std::shared_ptr<const Model> model = builder.build();
  State state = make_initial_state(*model);
  PassageWitness witness(model);
  AdvanceReport report;
  witness.begin(state);
  const auto go_to = [&](double z) {
    state.set_body(1, Vec3(0, 0, z), Quat::Identity(), Vec3::Zero(), Vec3::Zero());
    state.t += step;
    witness.watch(state, report);
  };
  // The gap of 5 m is not used up by these, but it is not that of the ball beside the plate.
  go_to(4.9);
  state.set_body(1, Vec3(0, 0, 0.1), Quat::Identity(), Vec3::Zero(), Vec3::Zero());
  witness.begin(state);
  EXPECT_EQ(report.passages.instants, 0);
  go_to(-0.1);
  EXPECT_EQ(report.passages.instants, 2);
}

}  // namespace
}  // namespace rigor::watched_pairs_test
