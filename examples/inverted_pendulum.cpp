// A controller of one's own: a cart on a rail holds a pole upright by pushing itself to and fro, 100 times a
// second.
#include <rigor/rigor.hpp>

#include <cmath>
#include <iostream>

using namespace rigor;

int main() {
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -9.80665));
  builder.add_body({.name = "cart", .mass = 1, .shapes = {{Box{Vec3(0.2, 0.1, 0.05)}}}});
  builder.add_body({.name = "pole",
                    .p_WU = Vec3(0.025, 0, 0.4992),
                    .q_WU = Quat(Eigen::AngleAxisd(0.05, Vec3::UnitY())),
                    .mass = 0.1,
                    .shapes = {{Capsule{0.01, 0.49}}}});
  builder.add_joint(
      {.name = "rail", .type = JointType::slider, .bodies = {"world", "cart"}, .axis = Vec3::UnitX()});
  builder.add_joint({.name = "pivot",
                     .type = JointType::hinge,
                     .bodies = {"cart", "pole"},
                     .anchors = {Vec3::Zero()},
                     .axis = Vec3::UnitY()});
  Simulation sim(builder.build());

  const JointHandle rail = sim.joint("rail"), pivot = sim.joint("pivot");
  sim.set_controller(
      [&](Simulation& own) {
        // Full state feedback; the pole began 0.05 rad from upright.
        const JointReaction cart = own.joint_motion(rail), pole = own.joint_motion(pivot);
        const double angle = 0.05 + pole.coordinates[0];
        own.set_motor_effort(rail,
                             3.2 * cart.coordinates[0] + 5 * cart.rates[0] + 36 * angle + 9 * pole.rates[0]);
      },
      0.01);
  sim.advance_to(8.0);

  const double angle = 0.05 + sim.joint_motion(pivot).coordinates[0];
  const Audit audit = sim.audit();
  std::cout << "angle " << angle << " rad, cart at " << sim.joint_motion(rail).coordinates[0] << " m, work "
            << audit.report.work << " J\n";
  return std::abs(angle) < 1e-3 && audit.violations.empty() ? 0 : 1;
}
