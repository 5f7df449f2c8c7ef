#include "bulk/joint_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigor::joint_loops_test {
namespace {

using tests::JointRun;

constexpr double kStep = 1.0 / 60;

void add_wheel(const std::string& name, const Vec3& center, double moment, ModelBuilder& builder) {
  builder.add_body(tests::bulk_body(name, center, 1, Vec3(moment, moment, moment)));
  builder.add_joint(
      {.name = "hinge of " + name, .type = JointType::hinge, .bodies = {"world", name}, .anchors = {center}});
}

TEST(BulkGears, WheelsTurnInProportionAndShareTheirMomenta) {
  ModelBuilder builder;
  add_wheel("a", Vec3(0, 0, 0), 2, builder);
  add_wheel("b", Vec3(1, 0, 0), 3, builder);
  builder.add_joint(
      {.name = "gear", .type = JointType::gear, .joints = {"hinge of a", "hinge of b"}, .parameter = -0.5});
  JointRun run(builder.build());
  run.set(0, Vec3::Zero(), Vec3(0, 0, 4));
  run.run(10, kStep, 4);
  // 2 (ω_a - 4) = 0.5 λ, 3 ω_b = λ, ω_b = -ω_a / 2 with the impulse of the gear λ on b: 2.75 ω_a = 8.
  EXPECT_NEAR(run.spin(0).z(), 8 / 2.75, 1e-4);  // 32 bits over 2,400 substeps.
  EXPECT_NEAR(run.spin(1).z(), -4 / 2.75, 1e-4);
  // Angles too, whole turns apart: half of those of a.
  const auto angle = [&](int i) {
    const Quat& q = run.bodies.q[static_cast<std::size_t>(i)];
    return 2 * std::atan2(q.z(), q.w());
  };
  EXPECT_NEAR(std::remainder(angle(1) + 0.5 * angle(0), std::numbers::pi), 0, 1e-4);
}

/// Two rods of 1 m and 1 kg hang from the world, 1 m apart, and the third joins their ends: hinges about y,
/// the first with that axis.
std::shared_ptr<const Model> four_bar(const Vec3& g_W, const JointAxis& first = {}) {
  ModelBuilder builder;
  builder.set_gravity(g_W);
  const Vec3 moments(0.08, 0.08, 0.001);
  builder.add_body(tests::bulk_body("left", Vec3(0, 0, -0.5), 1, moments));
  builder.add_body(tests::bulk_body("right", Vec3(1, 0, -0.5), 1, moments));
  builder.add_body(tests::bulk_body("coupler", Vec3(0.5, 0, -1), 1, Vec3(0.001, 0.08, 0.08)));
  const auto hinge = [&](const std::string& a, const std::string& b, const Vec3& p,
                         const JointAxis& along = {}) {
    builder.add_joint({.name = a + b,
                       .type = JointType::hinge,
                       .bodies = {a, b},
                       .anchors = {p},
                       .axis = Vec3::UnitY(),
                       .axes = {along}});
  };
  hinge("world", "left", Vec3(0, 0, 0), first);
  hinge("world", "right", Vec3(1, 0, 0));
  hinge("left", "coupler", Vec3(0, 0, -1));
  hinge("right", "coupler", Vec3(1, 0, -1));
  return builder.build();
}

/// Angle after t of the rods of that linkage, which hang down at first and turn by `rate`: with
/// 2 (I + m l²/4) + m l² = 1.66 kg m²,  1.66 a'' = -2 m g l sin a.
double four_bar_angle(double rate, double t) {
  double a = 0;
  const int steps = 20000;
  const double h = t / steps;
  for (int i = 0; i < steps; ++i) {  // Leapfrog: off by (h ω)² t.
    rate -= 0.5 * h * 2 * 9.81 / 1.66 * std::sin(a);
    a += h * rate;
    rate -= 0.5 * h * 2 * 9.81 / 1.66 * std::sin(a);
  }
  return a;
}

TEST(BulkLoops, AFourBarLinkageSwingsLikeThePendulumThatItIs) {
  const auto error_of = [&](int substeps) {
    JointRun run(four_bar(Vec3(0, 0, -9.81)));
    // The rods turn about y, so that their ends go towards -x.
    run.set(0, Vec3(-1, 0, 0), Vec3(0, 2, 0));
    run.set(1, Vec3(-1, 0, 0), Vec3(0, 2, 0));
    run.set(2, Vec3(-2, 0, 0), Vec3::Zero());
    double worst = 0;
    for (int i = 0; i < 60; ++i) {
      run.step(kStep, substeps);
      worst = std::max(worst, run.error());
    }
    // Two corrections leave (ω h)² of what turning by ω h moves an end off; 32 bits.
    EXPECT_LE(worst, 2e-6) << substeps;
    return std::abs(std::asin(0.5 - run.bodies.x[2].x()) - four_bar_angle(2, 1));
  };
  // At most of first order in h; 32 bits of displacements.
  const double coarse = error_of(2), fine = error_of(8);
  EXPECT_LE(coarse, 2e-4);
  EXPECT_LE(fine, 0.25 * coarse + 2e-6);
}

TEST(BulkLoops, AFourBarLinkageKeepsItsEnergy) {
  JointRun run(four_bar(Vec3::Zero()));
  run.set(0, Vec3(-0.5, 0, 0), Vec3(0, 1, 0));
  run.set(1, Vec3(-0.5, 0, 0), Vec3(0, 1, 0));
  run.set(2, Vec3(-1, 0, 0), Vec3::Zero());
  const double before = run.energy();
  EXPECT_NEAR(before, 0.83, 1e-6);
  run.run(0.5, kStep, 8);  // Not through the place where all bars are in line.
  EXPECT_NEAR(run.energy(), before, 1e-4 * before);
}

TEST(BulkLoops, ADamperSlowsALoopExponentially) {
  JointAxis axis;
  axis.damping = 1.66;  // Of a linkage of 1.66 kg m²: rate 1/s.
  JointRun run(four_bar(Vec3::Zero(), axis));
  run.set(0, Vec3(-0.25, 0, 0), Vec3(0, 0.5, 0));
  run.set(1, Vec3(-0.25, 0, 0), Vec3(0, 0.5, 0));
  run.set(2, Vec3(-0.5, 0, 0), Vec3::Zero());
  run.run(1, kStep, 4);
  EXPECT_NEAR(run.spin(0).y(), 0.5 * std::exp(-1),
              0.5 * std::exp(-1) / 480 * 1.1);  // First order: h/2 relative.
}

TEST(BulkLoops, ALimitStopsALoop) {
  JointAxis axis;
  axis.upper = 0.3;
  JointRun run(four_bar(Vec3::Zero(), axis));
  run.set(0, Vec3(-0.5, 0, 0), Vec3(0, 1, 0));
  run.set(1, Vec3(-0.5, 0, 0), Vec3(0, 1, 0));
  run.set(2, Vec3(-1, 0, 0), Vec3::Zero());
  run.run(1, kStep, 4);
  EXPECT_NEAR(run.bodies.x[2].x(), 0.5 - std::sin(0.3), 1e-5);
  EXPECT_LE(run.spin(0).norm(), 1e-5);
}

TEST(BulkLoops, ATableOnFourBallsSharesItsWeightEvenly) {
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -9.81));
  builder.add_body(tests::bulk_body("table", Vec3::Zero(), 4, Vec3(1, 2, 3)));
  for (int i = 0; i < 4; ++i) {
    builder.add_joint({.name = "j" + std::to_string(i),
                       .type = JointType::ball,
                       .bodies = {"world", "table"},
                       .anchors = {Vec3(i % 2 ? 0.7 : -0.7, i / 2 ? 0.4 : -0.4, 0.1)}});
  }
  JointRun run(builder.build());
  run.run(1, kStep, 4);
  const std::vector<float> impulses = run.impulses();
  const double weight = 4 * 9.81 * kStep / 4;
  for (std::size_t j = 0; j < 4; ++j) {
    // The softness that shares the impulses of redundant rows is 1e-8 of them; 32 bits of velocities.
    EXPECT_NEAR(impulses[6 * j + 2], weight / 4, 1e-5 * weight);
    EXPECT_NEAR(std::hypot(impulses[6 * j], impulses[6 * j + 1]), 0, 1e-5 * weight);
  }
  EXPECT_LE(run.error(), 1e-7);
}

/// Planks of 0.5 m x 2 m and 15 kg between two banks, each held to the next by balls at both its ends; they
/// sag by 1/10.
std::shared_ptr<const Model> plank_bridge(int planks) {
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -9.81));
  const double slope = 0.2, length = 0.5;
  const auto point = [&](int i) {
    const int down = std::min(i, planks - i);
    return Vec3(length * std::cos(slope) * (i - 0.5 * planks), 0, -length * std::sin(slope) * down);
  };
  for (int i = 0; i < planks; ++i) {
    BodyDescription plank = tests::bulk_body("plank" + std::to_string(i), 0.5 * (point(i) + point(i + 1)), 15,
                                             Vec3(5, 0.3125, 5.3));
    const double turn = 2 * i < planks ? slope : -slope;
    plank.q_WU = Quat(std::cos(turn / 2), 0, std::sin(turn / 2), 0);
    builder.add_body(plank);
  }
  for (int i = 0; i <= planks; ++i) {
    for (const double side : {-1.0, 1.0}) {
      builder.add_joint({.name = "j" + std::to_string(i) + (side > 0 ? "l" : "r"),
                         .type = JointType::ball,
                         .bodies = {i == 0 ? "world" : "plank" + std::to_string(i - 1),
                                    i == planks ? "world" : "plank" + std::to_string(i)},
                         .anchors = {point(i) + Vec3(0, side, 0)}});
    }
  }
  return builder.build();
}

TEST(BulkLoops, ABridgeOfPlanksHoldsAndItsRopesShareTheLoad) {
  JointRun run(plank_bridge(20));
  const double before = run.energy();
  double worst = 0, rise = 0;
  for (int i = 0; i < 240; ++i) {
    run.step(kStep, 8);
    worst = std::max(worst, run.error());
    rise = std::max(rise, run.energy() - before);
    const std::vector<float> impulses = run.impulses();
    double largest = 0, uneven = 0;
    for (std::size_t k = 0; k < impulses.size(); k += 12) {
      const auto at = [&](std::size_t j) { return Vec3(impulses[j], impulses[j + 1], impulses[j + 2]); };
      // Both ropes pull alike, but for what they pull each other through the planks.
      largest = std::max(largest, at(k).norm());
      uneven = std::max(uneven, std::hypot((at(k) - at(k + 6)).x(), (at(k) - at(k + 6)).z()));
    }
    EXPECT_LE(uneven, 1e-3 * largest) << i;
  }
  EXPECT_LE(worst, 1e-4);
  // Of 20 planks of 15 kg that can fall by about half a metre.
  EXPECT_LE(rise, 0.01 * 20 * 15 * 9.81 * 0.5);
}

/// 10 x 10 knots of 1 kg with ties of 1 m between neighbours, level, that hang by knots of their first edge.
std::shared_ptr<const Model> net(const std::vector<int>& hooks) {
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -9.81));
  constexpr int n = 10;
  const auto name = [](int i, int k) { return std::to_string(i) + "_" + std::to_string(k); };
  const auto tie = [&](const std::string& a, const std::string& b, const Vec3& p, const Vec3& to) {
    builder.add_joint(
        {.name = a + " " + b, .type = JointType::distance, .bodies = {a, b}, .anchors = {p, to}});
  };
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) {
      builder.add_body(tests::bulk_body(name(i, k), Vec3(i, k, 0), 1, Vec3(0.1, 0.1, 0.1)));
    }
  }
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) {
      if (i + 1 < n) tie(name(i, k), name(i + 1, k), Vec3(i, k, 0), Vec3(i + 1, k, 0));
      if (k + 1 < n) tie(name(i, k), name(i, k + 1), Vec3(i, k, 0), Vec3(i, k + 1, 0));
    }
  }
  for (const int k : hooks) {
    builder.add_joint({.name = "hook" + name(0, k),
                       .type = JointType::ball,
                       .bodies = {"world", name(0, k)},
                       .anchors = {Vec3(0, k, 0)}});
  }
  return builder.build();
}

/// Lets it fall for 2 s.
void expect_holds(const std::shared_ptr<const Model>& model, double most_error) {
  JointRun run(model);
  const double before = run.energy();
  for (int i = 0; i < 120; ++i) {
    run.step(kStep, 8);
    ASSERT_LE(run.error(), most_error) << i;
    // The kick in front makes the energy waver by h v g / 2 = 0.1 J/kg at 10 m/s.
    ASSERT_LE(run.energy(), before + 100 * 0.1) << i;
  }
}

TEST(BulkLoops, ANetHolds) {
  // The ties between the hooks are redundant. 32 bits of metres.
  expect_holds(net({0, 1, 2, 3, 4, 5, 6, 7, 8, 9}), 1e-6);
}

TEST(BulkLoops, ATautNetDoesNotJump) {
  // The edge between two hooks is straight, so that its ties cannot carry its weight: no velocities make up
  // for what rounding makes it too long by.
  expect_holds(net({0, 9}), 1e-3);
}

TEST(BulkJoints, TakeBackWhatTheyHaveChanged) {
  // Solved from velocities that repeat what joints changed before, the answer is that without them.
  const Executor executor(1);
  const auto solved = [&](bool repeats) {
    JointRun run(tests::rod_chain(3, Vec3(0, 0, -9.81)));
    run.run(0.2, kStep, 4);
    begin_bulk_step(*run.model, Executor(1), run.bodies);
    run.joints.prepare(run.bodies, kStep, executor);
    const Vec3 v(1, 2, 3), w(0, 1, 0);
    run.set(1, v, w);
    run.joints.solve(JointPass::places, executor);
    const Vec3 v_change = run.velocity(1) - v;
    EXPECT_GE(v_change.norm(), 0.1);
    if (!repeats) return run.velocity(1);
    run.joints.solve(JointPass::places_anew, executor);
    return run.velocity(1);
  };
  EXPECT_LE((solved(true) - solved(false)).norm(), 2e-5);  // 32 bits.
}

}  // namespace
}  // namespace rigor::joint_loops_test
