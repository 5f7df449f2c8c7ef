#include "rigor/sim/islands/joint_projection.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/sorted_unique.hpp"
#include "rigor/math/dense.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/sim/method/tolerances.hpp"
#include "rigor/sim/report/ledger.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace rigor {

void JointProjection::project_positions(double t, const std::vector<int>& bodies,
                                        std::vector<BodyPhase>& phases, AdvanceReport& report) const {
  if (assembler_.joints_of(bodies).empty()) return;
  const std::vector<BodyPhase> start = phases;
  Closed closed = close_joints(t, bodies, true, phases);
  report.max_joint_projection = std::max(report.max_joint_projection, closed.first_residual);
  // Where a motor without a limit of force has driven a loop to where it cannot go on, one of them has to
  // give way.
  // Where two ways to close it meet, Newton's method gains a factor of four only in each iteration.
  constexpr double share = 0.1;
  const double drift = projected_joint_drift(model_.length_scale());
  if (closed.residual > drift && closed.has_motors) {
    std::vector<BodyPhase> without = start;
    if (close_joints(t, bodies, false, without).residual <= std::max(drift, share * closed.residual))
      throw loop_against_motor(bodies);
  }
  report.note_joint_drift(closed.residual, closed.joint);
}

/// Names the motors without a limit of force of these bodies' joints.
Unresolved JointProjection::loop_against_motor(const std::vector<int>& bodies) const {
  std::string names;
  for (const int joint : assembler_.joints_of(bodies)) {
    const Joint& description = model_.joint(joint);
    if (description.has_unbounded_motor())
      names += fmt::format("{}'{}'", names.empty() ? "" : ", ", description.name);
  }
  return {bodies,
          fmt::format("the motor of joint {} has no max_force and drives a loop of joints to where it cannot "
                      "go on; give it a max_force",
                      names)};
}

/// Newton's method on the positions, in the metric of the masses, until the residual no longer falls. All
/// residuals fall along its step at first, whatever they are; where a chain is nearly straight the whole step
/// goes far beyond, so that steps are halved until they gain.
JointProjection::Closed JointProjection::close_joints(double t, const std::vector<int>& bodies,
                                                      bool with_motors,
                                                      std::vector<BodyPhase>& phases) const {
  constexpr int most_iterations = 40;
  constexpr double rounding = 1e-15, least_share = 1e-3;
  const double drift = projected_joint_drift(model_.length_scale());
  Closed closed{0, std::numeric_limits<double>::infinity(), -1, false};
  std::vector<BodyPhase> best = phases;
  std::vector<Vec6> newton(bodies.size(), Vec6::Zero());
  double share = 1;
  for (int iteration = 0; iteration <= most_iterations; ++iteration) {
    const ContactSystem system = assembler_.assemble_joints(t, bodies, phases, with_motors);
    const auto [residual, joint] = system.joints->largest_residual();
    if (iteration == 0) closed.first_residual = residual;
    closed.has_motors = system.joints->has_motors();

    if (residual < closed.residual) {
      // The displacement M⁻¹ Gᵀ λ with G Δ = -g from here.
      closed.residual = residual;
      closed.joint = joint;
      best = phases;
      if (residual <= rounding * model_.length_scale()) break;
      const JointSystem::Response moved = system.joints->respond(
          std::vector<Vec6>(system.bodies.size(), Vec6::Zero()), -system.joints->residuals());
      for (std::size_t i = 0; i < bodies.size(); ++i) newton[i] = moved.a[at(system.local_index(bodies[i]))];
      share = std::min(1.0, 2 * share);
    } else {
      share /= 2;
      if (closed.residual <= drift || share < least_share) break;
    }

    for (std::size_t i = 0; i < bodies.size(); ++i) {
      phases[i].x = best[i].x + share * newton[i].head<3>();
      phases[i].q = (rotation_exp(share * newton[i].tail<3>()) * best[i].q).normalized();
    }
  }
  phases = std::move(best);
  return closed;
}

void JointProjection::restore_momenta(const Island& island, IslandStep& step) const {
  const std::vector<int> joints = assembler_.joints_of(island.bodies);
  const auto is_grounded = [this](int joint) {
    const Joint& description = model_.joint(joint);
    if (description.type == JointType::gear) return false;  // Those that it ties are in the list.
    return description.body_A == world_body || description.body_B == world_body;
  };
  if (joints.empty() || !(island.contacts.empty() || step.is_implicit) ||
      std::any_of(joints.begin(), joints.end(), is_grounded) ||
      !assembler_.jointed_prescribed(island.bodies).empty())
    return;

  // Mass, centre and inertia of the group as one rigid body.
  const auto [bodies, kinetics] = assembler_.bodies_at(island.begin + step.h, island.bodies, step.end);
  double mass = 0;
  Vec3 centre = Vec3::Zero();
  for (const BodyKinetics& body : kinetics) {
    mass += 1 / body.inverse_mass;
    centre += body.x / body.inverse_mass;
  }
  centre /= mass;
  Mat3 inertia = Mat3::Zero();
  for (const BodyKinetics& body : kinetics) {
    const Vec3 arm = body.x - centre;
    inertia +=
        body.inertia + (arm.squaredNorm() * Mat3::Identity() - arm * arm.transpose()) / body.inverse_mass;
  }

  // The momenta that are missing, as a sum of small differences: rounding relative to the sums themselves
  // would add up.
  Vec3 P = step.impulse, L = step.angular_impulse;
  for (std::size_t i = 0; i < island.bodies.size(); ++i) {
    const BodyPhase &start = island.start[i], &end = step.end[i];
    const Vec3 dP = end.P - start.P, dx = end.x - start.x;
    P -= dP;
    L -= (end.L - start.L) + dx.cross(end.P) + start.x.cross(dP);
  }
  L -= centre.cross(P);

  // The rigid motion that carries them.
  const Vec3 v = P / mass, w = symmetric_solution(inertia, L);
  for (std::size_t i = 0; i < island.bodies.size(); ++i) {
    const BodyKinetics& body = kinetics[place_of(bodies, island.bodies[i])];
    step.end[i].P += (v + w.cross(body.x - centre)) / body.inverse_mass;
    step.end[i].L += body.inertia * w;
  }
}

void JointProjection::project_velocities(Cluster& cluster, AdvanceReport& report) const {
  if (assembler_.joints_of(cluster.bodies).empty()) return;
  // Motors without a limit find the joints closed, so that the work of their jump has no part of what closing
  // joints takes. Where all ends is the same.
  if (assembler_.assemble(cluster, {}).joints->has_motors())
    give_rates(assembler_.assemble_joints(cluster.t, cluster.bodies, cluster.phases, false), cluster, report);
  give_rates(assembler_.assemble(cluster, {}), cluster, report);
}

void JointProjection::give_rates(const ContactSystem& system, Cluster& cluster, AdvanceReport& report) const {
  const MomentumScope momentum(model_, cluster.bodies, cluster.phases);
  const EnergyScope energy(EnergyAccount::projection, model_, cluster.bodies, cluster.phases, report);

  // The impulses with which G V = rate.
  const JointReactions reactions =
      with_joint_impulses(system, std::vector<Wrench>(system.bodies.size()), -system.joints->rate_errors());
  add_to_momenta(system, reactions.wrenches, cluster);

  // What they supplied at the mean of the rates before and after, and what of the momenta nothing outside
  // accounts for.
  report.book(work_of_joints(*system.joints, reactions.lambda, 0.5 * system.joints->rate_errors()));
  momentum.book_error({external_wrench(system, VecX(), reactions.lambda)}, report);
}

}  // namespace rigor
