#include "rigor/sim/bulk/bulk_simulation.hpp"

#include "sim/time_stepping_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace rigor::bulk_simulation_test {
namespace {

constexpr double g = 9.81, kStep = 1.0 / 60;

/// A builder with the floor (body 0) and gravity.
ModelBuilder with_floor(double restitution = 0) {
  return test::stepping_builder(restitution, 0.5, Vec3(0, 0, -g));
}

BodyDescription kinematic(const std::string& name, const Shape& shape, const Vec3& x) {
  BodyDescription body = test::stepping_body(name, shape, x);
  body.motion = MotionType::kinematic;
  body.mass.reset();
  return body;
}

TEST(BulkSimulation, ForcesActForOneStepAndImpulsesAtOnce) {
  ModelBuilder builder = with_floor();
  const Shape box = Box{Vec3(0.5, 0.3, 0.2)};
  for (int i = 0; i < 4; ++i)
    builder.add_body(test::stepping_body("b" + std::to_string(i), box, Vec3(0, 5 * i, 50)));
  const std::shared_ptr<const Model> model = builder.build();
  BulkSimulation simulation(model);
  simulation.apply_force(1, Vec3(60, 0, 0));
  simulation.apply_force(1, Vec3(0, 120, 0));
  simulation.apply_force(2, Vec3(60, 0, 0), simulation.pose(2).p + Vec3(0, 0, 0.1));
  simulation.apply_torque(3, Vec3(0, 0, 6));
  simulation.apply_impulse(4, Vec3(1, 0, 0), simulation.pose(4).p + Vec3(0, 0.2, 0));
  const Vec3 moments = model->body(1).moments;
  EXPECT_NEAR(simulation.angular_velocity(4).z(), -0.2 / moments.z(), 1e-6 / moments.z());
  simulation.step();
  // m = 1 kg; a 60th of a second. Velocities and displacements are rounded in 32 bits, eight times.
  const double rounding = 1e-6;
  EXPECT_LT((simulation.velocity(1) - Vec3(1, 2, -g * kStep)).norm(), rounding);
  EXPECT_NEAR(simulation.velocity(2).x(), 1, rounding);
  EXPECT_NEAR(simulation.angular_velocity(2).y(), 0.1 / moments.y(), rounding / moments.y());
  EXPECT_NEAR(simulation.angular_velocity(3).z(), 0.1 / moments.z(), rounding / moments.z());
  EXPECT_NEAR(simulation.velocity(4).x(), 1, rounding);
  simulation.step();
  EXPECT_NEAR(simulation.velocity(1).x(), 1, rounding);
}

TEST(BulkSimulation, WorkOfGivenForcesIsReported) {
  ModelBuilder builder = with_floor();
  builder.add_body(test::stepping_body("b", Box{Vec3(0.5, 0.3, 0.2)}, Vec3(0, 0, 50)));
  BulkSimulation simulation(builder.build(), {.measures = true});
  simulation.set_velocity(1, Vec3(2, 0, 0), Vec3(0, 0, 3));
  simulation.apply_force(1, Vec3(6, 0, 0));
  simulation.apply_torque(1, Vec3(0, 0, 0.5));
  const double before = 0.5 * 4 + 0.5 * simulation.model().body(1).moments.z() * 9;
  const BulkStepReport report = simulation.step();
  const Vec3 v = simulation.velocity(1);
  const double w = simulation.angular_velocity(1).z();
  const double after = 0.5 * v.x() * v.x() + 0.5 * simulation.model().body(1).moments.z() * w * w;
  // Velocities and displacements in 32 bits, a few roundings a substep.
  EXPECT_GT(after - before, 0.2);
  EXPECT_NEAR(report.work, after - before, 20 * before * std::ldexp(1, -24));
}

TEST(BulkSimulation, ContactImpulsesAreTheChangeOfMomentum) {
  // A heap that falls: of each body the momentum changes by gravity and by its contacts. (Of 80 such heaps,
  // at heights of 0.3 m and more, there are two in which the bound of energies takes something from a motion
  // against the floor: one is that of 0.3 m.)
  ModelBuilder builder = with_floor(0.3);
  const int count = 12;
  for (int i = 0; i < count; ++i) {
    BodyDescription body = test::stepping_body("b" + std::to_string(i), Box{Vec3(0.3, 0.25, 0.2)},
                                               Vec3(0.1 * (i % 3), 0.05 * i, 0.31 + 0.55 * i));
    body.mass = 1 + i;
    builder.add_body(body);
  }
  const std::shared_ptr<const Model> model = builder.build();
  BulkSimulation simulation(model, {.sleeping = false, .measures = true});
  double largest = 0, most_carried = 0;
  for (int k = 0; k < 120; ++k) {
    std::vector<Vec3> change;
    for (int i = 0; i <= count; ++i) change.push_back(-model->body(i).mass * simulation.velocity(i));
    const BulkStepReport report = simulation.step();
    for (int i = 1; i <= count; ++i)
      change[static_cast<std::size_t>(i)] +=
          model->body(i).mass * (simulation.velocity(i) + Vec3(0, 0, g * kStep));
    for (const BulkContact& contact : simulation.contacts()) {
      change[static_cast<std::size_t>(contact.body_A)] += contact.impulse_W();
      change[static_cast<std::size_t>(contact.body_B)] -= contact.impulse_W();
      most_carried = std::max(most_carried, contact.normal_impulse());
    }
    for (int i = 1; i <= count; ++i) largest = std::max(largest, change[static_cast<std::size_t>(i)].norm());
    EXPECT_LT(report.momentum_error.norm(), 1e-3) << "step " << k;
  }
  EXPECT_GT(most_carried, 5);
  // Impulses up to 30 N s and momenta up to 100 kg m/s in 32 bits, rounded a hundred times a step.
  EXPECT_LT(largest, 1e-3);
}

TEST(BulkSimulation, ContactsHaveThePointsNormalAndFrictionOfABlockThatIsPulled) {
  ModelBuilder builder = with_floor();
  builder.add_body(test::stepping_body("block", Box{Vec3(0.5, 0.3, 0.1)}, Vec3(1, 2, 0.1)));
  BulkSimulation simulation(builder.build());
  for (int k = 0; k < 60; ++k) {
    simulation.apply_force(1, Vec3(2, 0, 0));
    simulation.step();
  }
  const std::vector<BulkContact> contacts = simulation.contacts();
  ASSERT_EQ(contacts.size(), 1u);
  const BulkContact& contact = contacts[0];
  EXPECT_EQ(contact.key(), (ContactKey{0, 1, 0, 0, 0}));
  EXPECT_LT((contact.n_W - Vec3::UnitZ()).norm(), 1e-6);
  ASSERT_EQ(contact.point_count, 4);
  const double weight = g * kStep;
  EXPECT_NEAR(contact.normal_impulse(), weight, 1e-4 * weight);
  // It sticks: friction is what pulls, the other way.
  EXPECT_LT((contact.friction_impulse_W - Vec3(-2 * kStep, 0, 0)).norm(), 1e-4 * weight);
  EXPECT_LT((contact.center_W - Vec3(1, 2, 0)).norm(), 1e-3);
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec3 arm = contact.points[k].p_W - Vec3(1, 2, 0);
    EXPECT_LT((arm.cwiseAbs() - Vec3(0.5, 0.3, 0)).norm(), 1e-3);
    EXPECT_GE(contact.points[k].normal_impulse, 0);
  }
  // A friction force at the floor, 0.1 m below the centre, tips it: more is carried in front, by 2 N · 0.1 m.
  double moment = 0;
  for (const BulkContact::Point& point : contact.points) moment += (point.p_W.x() - 1) * point.normal_impulse;
  EXPECT_NEAR(moment, 2 * kStep * 0.1, 1e-3 * weight);
}

TEST(BulkSimulation, BallThatIsDroppedHitsOnceAndRestsAndLeaves) {
  ModelBuilder builder = with_floor();
  builder.add_body(test::stepping_body("ball", Sphere{0.5}, Vec3(0, 0, 1.5)));
  BulkSimulation simulation(builder.build(), {.measures = true});
  int begins = 0, ends = 0, impacts = 0;
  std::vector<BulkContact> hits;
  double change = 0;  // Of the velocity, in the step of the hit.
  const auto steps = [&](int count) {
    for (int k = 0; k < count; ++k) {
      const double before = simulation.velocity(1).z();
      impacts += static_cast<int>(simulation.step().impacts.size());
      for (const ContactEvent& event : simulation.events())
        ++(event.kind == ContactEvent::Kind::begin ? begins : ends);
      for (const BulkContact& hit : simulation.hits(1)) {
        hits.push_back(hit);
        change = simulation.velocity(1).z() - before;
      }
    }
  };
  steps(60);
  EXPECT_EQ(begins, 1);
  EXPECT_EQ(ends, 0);
  EXPECT_EQ(impacts, 1);
  ASSERT_EQ(hits.size(), 1u);
  // √(2 g 1 m), up to a step before, and half a substep late as symplectic falls are.
  EXPECT_NEAR(hits[0].approach_speed, std::sqrt(2 * g), g * kStep * (1 + 1.0 / 8));
  EXPECT_NEAR(hits[0].normal_impulse(), change + g * kStep, 1e-5);
  simulation.apply_impulse(1, Vec3(0, 0, 3));
  steps(5);
  EXPECT_EQ(ends, 1);
}

TEST(BulkSimulation, KinematicBodyArrivesExactlyAndPushesWithItsVelocity) {
  ModelBuilder builder = with_floor();
  builder.add_body(kinematic("paddle", Box{Vec3(0.1, 0.5, 0.3)}, Vec3(0, 0, 0.4)));
  builder.add_body(test::stepping_body("ball", Sphere{0.3}, Vec3(0.6, 0, 0.3)));
  const std::shared_ptr<const Model> model = builder.build();
  BulkSimulation simulation(model);
  Pose last;
  for (int k = 1; k <= 60; ++k) {
    const double angle = 0.2 * k / 60;
    last = {Eigen::AngleAxisd(angle, Vec3::UnitX()).toRotationMatrix(), Vec3(2.0 * k / 60, 0, 0.4)};
    simulation.move_to(1, last);
    simulation.step();
  }
  EXPECT_EQ(simulation.pose(1).p, last.p);
  EXPECT_LT((simulation.pose(1).R - last.R).norm(), 1e-15);
  EXPECT_NEAR(simulation.velocity(1).x(), 2, 1e-5);
  EXPECT_NEAR(simulation.angular_velocity(1).x(), 0.2, 1e-5);
  // The ball goes before it.
  EXPECT_GT(simulation.pose(2).p.x(), 2.4 - 0.01);
  EXPECT_NEAR(simulation.velocity(2).x(), 2, 0.05);
  // Then it stays, and a State takes it along.
  const State state = simulation.state();
  simulation.step();
  EXPECT_EQ(simulation.pose(1).p, last.p);
  BulkSimulation other(model);
  other.set_state(deserialise(serialise(state)));
  other.step();
  EXPECT_EQ(other.state(), simulation.state());
}

TEST(BulkSimulation, LiftedLoadGetsTheWorkOfTheLift) {
  ModelBuilder builder = with_floor();
  builder.add_body(kinematic("lift", Box{Vec3(0.5, 0.5, 0.05)}, Vec3(0, 0, 1)));
  builder.add_body(test::stepping_body("load", Box{Vec3(0.2, 0.2, 0.2)}, Vec3(0.1, 0.1, 1.25)));
  BulkSimulation simulation(builder.build(), {.measures = true});
  for (int k = 0; k < 60; ++k) simulation.step();
  const double from = simulation.pose(2).p.z();
  double work = 0;
  for (int k = 1; k <= 60; ++k) {
    simulation.move_to(1, {Mat3::Identity(), Vec3(0, 0, 1 + 0.5 * k / 60)});
    work += simulation.step().work;
  }
  const double gained = g * (simulation.pose(2).p.z() - from) + 0.5 * simulation.velocity(2).squaredNorm();
  EXPECT_NEAR(gained, g * 0.5 + 0.5 * 0.25, 0.05);
  // The start is an impact of 0.5 m/s, which takes as much as the load gets: ½ m v².
  EXPECT_NEAR(work, gained + 0.5 * 0.25, 0.02 * gained);
}

TEST(BulkSimulation, ContactFilterLetsBodiesThrough) {
  ModelBuilder builder = with_floor();
  builder.add_body(test::stepping_body("a", Sphere{0.2}, Vec3(0, 0, 0.2)));
  builder.add_body(test::stepping_body("b", Sphere{0.2}, Vec3(0, 0, 0.6)));
  BulkSimulation simulation(builder.build());
  for (int k = 0; k < 120; ++k) simulation.step();
  EXPECT_TRUE(simulation.is_asleep(2));
  simulation.set_contact_filter([](int a, int b) { return a == 0 || b == 0; });
  for (int k = 0; k < 60; ++k) simulation.step();
  EXPECT_NEAR(simulation.pose(2).p.z(), 0.2, 2e-3);
}

TEST(BulkSimulation, RaysSeeTheBodiesWhereTheyAre) {
  ModelBuilder builder = with_floor();
  builder.add_body(test::stepping_body("a", Sphere{0.2}, Vec3(0, 0, 1.2)));
  builder.add_body(test::stepping_body("b", Sphere{0.2}, Vec3(4, 0, 0.2)));
  BulkSimulation simulation(builder.build());
  const Ray down{Vec3(0, 0, 3), Vec3(0, 0, -1)};
  const Shape probe = Sphere{0.1};
  for (int k = 0; k < 200; ++k) {
    const std::optional<BodyRayHit> hit = simulation.queries().first_hit(down);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->on.body, 1);
    EXPECT_NEAR(hit->hit.p_W.z(), simulation.pose(1).p.z() + 0.2, 1e-9);
    const std::optional<BodyCastHit> met = simulation.queries().cast(
        {&probe, {Mat3::Identity(), Vec3(-1, 0, simulation.pose(1).p.z())}, Vec3(5, 0, 0)});
    ASSERT_TRUE(met);
    EXPECT_EQ(met->on.body, 1);
    EXPECT_NEAR(met->hit.fraction, 0.7 / 5, 1e-9);
    simulation.step();
  }
  simulation.set_pose(2, {Mat3::Identity(), Vec3(0, 0, 2)});
  EXPECT_EQ(simulation.queries().first_hit(down)->on.body, 2);
}

/// Two heaps far from each other, and what is in between.
ModelBuilder two_heaps() {
  ModelBuilder builder = with_floor();
  for (const double x : {0.0, 100.0}) {
    for (int i = 0; i < 8; ++i)
      builder.add_body(test::stepping_body((x > 0 ? "far" : "near") + std::to_string(i),
                                           Box{Vec3(0.3, 0.25, 0.2)},
                                           Vec3(x + 0.05 * i, 0.03 * i, 0.3 + 0.5 * i)));
  }
  return builder;
}

TEST(BulkSimulation, BodiesComeAndGoAndTheOthersKeepTheirBits) {
  for (const bool sleeping : {false, true}) {
    ModelBuilder builder = two_heaps();
    const BulkSimulation::Options options{.sleeping = sleeping};
    BulkSimulation changed(builder.build(), options), same(builder.build(), options);
    for (int k = 0; k < 300; ++k) {
      // Things happen to the near heap only.
      if (k == 40) builder.add_body(test::stepping_body("new", Sphere{0.3}, Vec3(0.2, 0, 6)));
      if (k == 150) builder.remove_body("near2");
      if (k == 160) builder.remove_body("new");
      if (k == 40 || k == 150 || k == 160) changed.set_model(builder.build());
      changed.step();
      same.step();
      for (int i = 0; i < 8; ++i) {
        const std::string name = "far" + std::to_string(i);
        const int a = *changed.model().find_body(name), b = *same.model().find_body(name);
        ASSERT_EQ(changed.pose(a).p, same.pose(b).p) << name << ", step " << k;
        ASSERT_EQ(changed.velocity(a), same.velocity(b)) << name << ", step " << k;
        ASSERT_EQ(changed.is_asleep(a), same.is_asleep(b)) << name << ", step " << k;
      }
    }
    EXPECT_EQ(changed.model().body_count(), 16);
  }
}

TEST(BulkSimulation, TakingABodyAwayWakesWhatItCarried) {
  ModelBuilder builder = with_floor();
  for (int i = 0; i < 4; ++i)
    builder.add_body(
        test::stepping_body("cube" + std::to_string(i), Box{Vec3(0.5, 0.5, 0.5)}, Vec3(0, 0, 0.5 + i)));
  builder.add_body(test::stepping_body("other", Box{Vec3(0.5, 0.5, 0.5)}, Vec3(10, 0, 0.5)));
  BulkSimulation simulation(builder.build());
  for (int k = 0; k < 240; ++k) simulation.step();
  ASSERT_TRUE(simulation.is_asleep(4));
  builder.remove_body("cube1");
  simulation.set_model(builder.build());
  simulation.step();
  EXPECT_FALSE(simulation.is_asleep(2));
  EXPECT_FALSE(simulation.is_asleep(3));
  EXPECT_TRUE(simulation.is_asleep(4));
  for (int k = 0; k < 120; ++k) simulation.step();
  EXPECT_NEAR(simulation.pose(3).p.z(), 2.5, 0.02);
}

TEST(BulkSimulation, FloorThatIsTakenAwayWakesAll) {
  ModelBuilder builder = with_floor();
  builder.add_body(test::stepping_body("a", Box{Vec3(0.5, 0.5, 0.5)}, Vec3(0, 0, 0.5)));
  BulkSimulation simulation(builder.build());
  for (int k = 0; k < 120; ++k) simulation.step();
  ASSERT_TRUE(simulation.is_asleep(1));
  builder.remove_body("floor");
  simulation.set_model(builder.build());
  for (int k = 0; k < 30; ++k) simulation.step();
  EXPECT_LT(simulation.pose(0).p.z(), -0.5);
}

TEST(BulkSimulation, MeasuresChangeTheReportAndNothingElse) {
  ModelBuilder builder = with_floor(0.5);
  builder.add_body(test::stepping_body("ball", Sphere{0.5}, Vec3(0, 0, 1)));
  builder.add_body(test::stepping_body("box", Box{Vec3(0.5, 0.3, 0.2)}, Vec3(0.2, 0, 2)));
  const std::shared_ptr<const Model> model = builder.build();
  BulkSimulation off(model), on(model, {.measures = true});
  std::size_t impacts = 0;
  for (int k = 0; k < 90; ++k) {
    const BulkStepReport plain = off.step(), measured = on.step();
    impacts += measured.impacts.size();
    EXPECT_TRUE(plain.impacts.empty());
    EXPECT_EQ(plain.work, 0);
    EXPECT_EQ(plain.max_overlap, measured.max_overlap);
    ASSERT_EQ(off.contacts().size(), on.contacts().size());
    for (std::size_t i = 0; i < on.contacts().size(); ++i)
      EXPECT_EQ(off.contacts()[i].impulse_W(), on.contacts()[i].impulse_W());
    EXPECT_EQ(off.hits(0.1).size(), on.hits(0.1).size());
    EXPECT_EQ(off.events(), on.events());
  }
  EXPECT_GE(impacts, 2u);
  EXPECT_EQ(off.state(), on.state());
}

}  // namespace
}  // namespace rigor::bulk_simulation_test
