// Steps that begin with the forces of the step before.

#include "rigor/sim/time_stepping/last_step_forces.hpp"

#include "rigor/math/rotation.hpp"
#include "rigor/sim/time_stepping/time_stepper.hpp"
#include "sim/time_stepping_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rigor::last_step_forces_test {
namespace {

Contact contact_at(int body_A, int body_B, std::uint64_t feature, const Vec3& p_W) {
  Contact contact{body_A, body_B, 0, 0, {}, 0.5, 0};
  contact.point.feature = feature;
  contact.point.p_WA = contact.point.p_WB = p_W;
  contact.point.n_W = Vec3::UnitZ();
  return contact;
}

ContactForce force_at(const Contact& contact, const Vec3& force_W) {
  return {contact.key(), contact.p_W(), force_W, TouchingPoint::Mode::stick};
}

/// Two contacts of one pair and one of another, in a frame of their own.
ContactSystem system_of_three() {
  ContactSystem system;
  system.contacts = {contact_at(0, 1, 11, Vec3(0, 0, 0)), contact_at(0, 1, 12, Vec3(1, 0, 0)),
                     contact_at(1, 2, 11, Vec3(0, 0, 1))};
  system.frames.assign(3, rotation_exp(Vec3(0, 0, 0.4)).toRotationMatrix());
  return system;
}

TEST(LastStepForces, GoToTheirContactsAsImpulses) {
  const ContactSystem system = system_of_three();
  LastStepForces forces;
  // In no order.
  forces.remember({force_at(system.contacts[2], Vec3(0, 1, 5)), force_at(system.contacts[1], Vec3(1, 0, 3))});
  const VecX lambda = forces.impulses(0.01, system);
  ASSERT_EQ(lambda.size(), 9);
  EXPECT_TRUE(lambda.head<3>().isZero(0));
  EXPECT_LE((system.frames[1] * lambda.segment<3>(3) - 0.01 * Vec3(1, 0, 3)).norm(), 1e-17);
  EXPECT_LE((system.frames[2] * lambda.segment<3>(6) - 0.01 * Vec3(0, 1, 5)).norm(), 1e-17);
}

TEST(LastStepForces, GoToTheNearestContactWhereFeaturesAreOthers) {
  const ContactSystem system = system_of_three();
  LastStepForces forces;
  // Both of them near the first contact of the pair; a pair that has parted has no share.
  forces.remember({force_at(contact_at(0, 1, 77, Vec3(0.1, 0, 0)), Vec3(0, 0, 2)),
                   force_at(contact_at(0, 1, 99, Vec3(0.2, 0, 0)), Vec3(0, 0, 3)),
                   force_at(contact_at(0, 3, 11, Vec3(0, 0, 0)), Vec3(0, 0, 7))});
  const VecX lambda = forces.impulses(1, system);
  ASSERT_EQ(lambda.size(), 9);
  EXPECT_LE((lambda.head<3>() - Vec3(0, 0, 5)).norm(), 1e-15);
  EXPECT_TRUE(lambda.tail<6>().isZero(0));
}

TEST(LastStepForces, OfNoneOfThePairsAreNoStart) {
  const ContactSystem system = system_of_three();
  LastStepForces forces;
  EXPECT_EQ(forces.impulses(1, system).size(), 0);
  ContactForce unknown = force_at(system.contacts[0], Vec3::Constant(std::nan("")));
  unknown.mode = TouchingPoint::Mode::unknown;
  forces.remember({unknown, force_at(contact_at(0, 3, 11, Vec3::Zero()), Vec3::UnitZ())});
  EXPECT_EQ(forces.impulses(1, system).size(), 0);
}

/// A square pyramid of bricks, three layers, whose faces end in the same planes.
std::shared_ptr<const Model> pyramid() {
  ModelBuilder builder = test::stepping_builder(0, 0.5, Vec3(0, 0, -9.81));
  for (int layer = 0; layer < 3; ++layer) {
    const int side = 3 - layer;
    for (int k = 0; k < side * side; ++k) {
      const Vec3 x(0.205 * (k % side - 0.5 * side), 0.205 * (k / side - 0.5 * side), 0.05 + 0.1 * layer);
      builder.add_body(
          test::stepping_body("b" + std::to_string(10 * layer + k), Box{Vec3(0.1, 0.1, 0.05)}, x));
    }
  }
  return builder.build();
}

TEST(LastStepForces, OfBodiesAtRestAreKept) {
  const std::shared_ptr<const Model> model = pyramid();
  Method method;
  method.scheme = Scheme::time_stepping;
  State state = make_initial_state(*model);
  TimeStepper stepper(model, method, 0.01);
  EXPECT_GT(stepper.advance(state, 0.01).max_iterations, 0);
  ASSERT_FALSE(state.events.contacts.empty());
  const AdvanceReport report = stepper.advance(state, 0.03);
  EXPECT_EQ(report.max_iterations, 0);
  EXPECT_LE(report.max_residual, 1e-14);
  for (int body = 0; body < model->body_count(); ++body)
    EXPECT_LE(linear_velocity(*model, state, body).norm(), 1e-14);
}

TEST(LastStepForces, AreInTheState) {
  const std::shared_ptr<const Model> model = pyramid();
  Method method;
  method.scheme = Scheme::time_stepping;
  State state = make_initial_state(*model);
  TimeStepper stepper(model, method, 0.01);
  stepper.advance(state, 0.05);
  // As a file keeps it, and with a stepper that knows nothing.
  State resumed = deserialise(serialise(state));
  TimeStepper fresh(model, method, 0.01);
  EXPECT_EQ(fresh.advance(resumed, 0.1).max_iterations, stepper.advance(state, 0.1).max_iterations);
  EXPECT_EQ(resumed, state);
}

}  // namespace
}  // namespace rigor::last_step_forces_test
