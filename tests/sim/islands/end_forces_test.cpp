// The forces that a step keeps of its last stage are those at its end, however many tries it took.

#include "random_vectors.hpp"
#include "rigor/contact/resting/resting.hpp"
#include "rigor/sim/islands/island_integrator.hpp"
#include "rigor/sim/method/resting_choice.hpp"
#include "sim/time_stepping_scenes.hpp"

#include <gtest/gtest.h>

namespace rigor::end_forces_test {
namespace {

constexpr double half_edge = 0.1;

std::shared_ptr<const Model> cube_on_plane(double friction) {
  ModelBuilder builder = test::stepping_builder(0, friction, Vec3(0, 0, -9.81));
  builder.add_body(test::stepping_body("cube", Box{Vec3::Constant(half_edge)}, Vec3(0, 0, half_edge)));
  return builder.build();
}

TEST(EndForces, AreThoseThatActWhereTheStepEnds) {
  test::Random random(19);
  Method method;
  int shortened = 0;
  for (int k = 0; k < 40; ++k) {
    SCOPED_TRACE(k);
    // A cube slides and spins on its face, now slow, now fast.
    const std::shared_ptr<const Model> model = cube_on_plane(random.uniform(0.1, 0.8));
    const Environment environment(*model);
    const ContactSystemAssembler assembler(*model, environment);
    const IslandIntegrator integrator(*model, environment, assembler, method);
    const double speed = std::pow(10, random.uniform(-2, 0.5));
    Island island;
    island.bodies = {1};
    BodyPhase start;
    start.x = Vec3(0, 0, half_edge);
    start.P = speed * Vec3(random.number(), random.number(), 0);
    start.L = Vec3(0, 0, 0.01 * speed * random.number());
    island.start = {start};
    island.contacts = find_contacts(*model, 0, 1, {}, Pose{Mat3::Identity(), start.x}, 1e-6);
    const ContactSystem system = assembler.assemble(0, island.bodies, island.start, island.contacts);
    island.states = solve_resting(system, assembler.environment_wrenches(system, 0), 1e-9).states;

    const double longest = 0.02;
    const IslandStep step = integrator.controlled_step(island, longest, {1e-9, longest, longest}).step;
    if (step.h < longest) ++shortened;
    ASSERT_EQ(step.end_forces.size(), 3 * static_cast<Eigen::Index>(island.contacts.size()));
    const ContactSystem at_end = assembler.assemble(island, step.h, step.end);
    const VecX forces = contact_forces(at_end, island.states, assembler.environment_wrenches(at_end, step.h),
                                       direction_tolerance(method));
    // To the bit, since nothing prescribed moves: what moves is asked for just before the end.
    EXPECT_EQ(step.end_forces, forces);

    // A try that begins with this length takes the same step.
    const IslandStep again = integrator.step(island, step.h);
    EXPECT_EQ(again.end.front().P, step.end.front().P);
    EXPECT_EQ(again.end.front().L, step.end.front().L);
  }
  EXPECT_GT(shortened, 10);
}

}  // namespace
}  // namespace rigor::end_forces_test
