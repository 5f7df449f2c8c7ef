#include "rigor/contact/system/contact_kinematics.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/rounding.hpp"
#include "rigor/core/sorted_unique.hpp"
#include "rigor/dynamics/dense_phase.hpp"
#include "rigor/dynamics/drag_flow.hpp"
#include "rigor/dynamics/step_control.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/sim/islands/displacement.hpp"
#include "rigor/sim/islands/energy_repair.hpp"
#include "rigor/sim/islands/island_integrator.hpp"
#include "rigor/sim/islands/joint_projection.hpp"
#include "rigor/sim/islands/too_fast.hpp"
#include "rigor/sim/report/ledger.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rigor {

namespace {

/// Changes of the momenta of bodies, as sums of small differences; L about the origin of W.
struct MomentumChange {
  Vec3 P = Vec3::Zero(), L = Vec3::Zero();
};

MomentumChange momentum_change(const std::vector<BodyPhase>& start, const std::vector<BodyPhase>& end) {
  MomentumChange change;
  for (std::size_t i = 0; i < start.size(); ++i) {
    const Vec3 dP = end[i].P - start[i].P, dx = end[i].x - start[i].x;
    change.P += dP;
    change.L += (end[i].L - start[i].L) + dx.cross(end[i].P) + start[i].x.cross(dP);
  }
  return change;
}

/// A straight path at a constant rate: what happens within the step is over at once.
DensePhase straight_path(const BodyPhase& start, const BodyPhase& end, double h) {
  Quat turn = end.q * start.q.conjugate();
  if (turn.w() < 0) turn.coeffs() *= -1;
  const Eigen::AngleAxisd rotation(turn);
  return quadratic_dense_phase(start, end, (end.x - start.x) / h, rotation.angle() / h * rotation.axis(), h);
}

}  // namespace

ControlledStep IslandIntegrator::stiff_step(const Island& island, double damped,
                                            const StepBounds& bounds) const {
  if (is_only_dragged(island)) return {dragged_step(island, bounds.longest), bounds.longest};

  // Steps that resolve the motion, down to the damped one.
  StepController controller(integrator_order(IntegratorName::rodas));
  double h = bounds.longest;
  IslandStep taken = step(island, h, true);
  while (true) {
    const StepDecision decision = controller.decide(h, taken.error);
    // An estimate that is relative to an end far away accepts anything.
    if (decision.is_accepted && !gains(island, taken))
      return {std::move(taken), std::max(damped, decision.h_next)};
    if (h <= damped) break;
    h = std::max(damped, std::min(0.5 * h, decision.h_next));
    taken = step(island, h, true);
  }

  // What it does not resolve is damped, by a step that adds no energy.
  while (!close_stiff_step(island, taken)) {
    h *= 0.5;
    if (h < bounds.least) throw too_fast(model_, environment_, island.bodies, island.start, h);
    taken = step(island, h, true);
  }
  // Between its ends the method's own polynomial is as unresolved as the motion.
  for (std::size_t i = 0; i < taken.end.size(); ++i)
    taken.dense[i] = straight_path(island.start[i], taken.end[i], taken.h);
  return {std::move(taken), h};
}

IslandStep IslandIntegrator::repeated(const Island& island, double h, const IslandStep& taken) const {
  if (taken.is_implicit) return implicit_step(island, h);
  if (!taken.is_stiff) return step(island, h);
  if (is_only_dragged(island)) return dragged_step(island, h);
  IslandStep again = step(island, h, true);
  if (!(again.error <= 1 && !gains(island, again)) && !close_stiff_step(island, again))
    throw too_fast(model_, environment_, island.bodies, island.start, h);
  return again;
}

/// A body on which nothing but drag acts has a closed form.
bool IslandIntegrator::is_only_dragged(const Island& island) const {
  return island.bodies.size() == 1 && island.contacts.empty() &&
         environment_.is_only_dragged(island.bodies.front());
}

/// Exact where the rates of decay about all axes agree and no torque acts, else of second order in the
/// rotation.
IslandStep IslandIntegrator::dragged_step(const Island& island, double h) const {
  const int index = island.bodies.front();
  const Body& body = model_.body(index);
  const BodyInertia inertia{body.mass, body.moments};
  const BodyPhase& start = island.start.front();
  const BodyKinetics before = dynamic_kinetics(body, start);
  const Wrench force = environment_.undamped_forces(index, view_of(before));
  const BodyPhase end = drag_flow(inertia, environment_.drag(index), force, start, h);

  // What acts comes from outside. A power is known at both ends.
  IslandStep result{h, {end}, {straight_path(start, end, h)}, 0, 0};
  result.is_stiff = true;
  const MomentumChange change = momentum_change(island.start, result.end);
  result.impulse = change.P;
  result.angular_impulse = change.L;
  result.work.supplied = 0.5 * h *
                         (environment_.supplied_power(index, view_of(before)) +
                          environment_.supplied_power(index, view_of(dynamic_kinetics(body, end))));
  constexpr double coarse = 2;  // Above the tolerance of 1.
  const Environment::DragRates rates = environment_.drag(index);
  const bool agree = rates.angular == 0 || body.moments.minCoeff() == body.moments.maxCoeff();
  const bool is_exact = agree && force.tau_W.isZero(0) && result.work.supplied == 0;
  result.error = is_exact ? 0 : coarse;
  return result;
}

/// Whether only gravity acts on the bodies from outside.
bool IslandIntegrator::is_free(const Island& island) const {
  const bool touches =
      std::any_of(island.contacts.begin(), island.contacts.end(), [&](const Contact& contact) {
        return !contact.stop &&
               (!holds(island.bodies, contact.body_A) || !holds(island.bodies, contact.body_B));
      });
  if (touches || !assembler_.jointed_prescribed(island.bodies).empty()) return false;
  for (const int joint : assembler_.joints_of(island.bodies)) {
    if (model_.joint(joint).body_A == world_body || model_.joint(joint).body_B == world_body) return false;
  }
  return std::none_of(island.bodies.begin(), island.bodies.end(), [&](int body) {
    return environment_.has_drag(body) || environment_.is_tied_down(body);
  });
}

double IslandIntegrator::spring_energy_of(const Island& island, double t,
                                          const std::vector<BodyPhase>& phases) const {
  const auto view = [&](int body) {
    if (!holds(island.bodies, body)) return view_of(prescribed_kinetics(model_.body(body), t));
    return view_of(dynamic_kinetics(model_.body(body), phases[place_of(island.bodies, body)]));
  };
  return environment_.spring_energy_of(island.bodies, view);
}

/// Kinetic, potential and elastic energy [J].
double IslandIntegrator::energy_of(const Island& island, double t,
                                   const std::vector<BodyPhase>& phases) const {
  return energy_of_bodies(model_, environment_, t, island.bodies, phases);
}

/// What nothing accounts for of the energy that a step has added, and the size of what it has moved [J].
IslandIntegrator::Gain IslandIntegrator::gain_of(const Island& island, const IslandStep& step) const {
  const auto kinetic = [&](const std::vector<BodyPhase>& phases) {
    return totals_of(model_, island.bodies, phases).T;
  };
  const double before = energy_of(island, island.begin, island.start);
  const double after = energy_of(island, island.begin + step.h, step.end);
  return {after - before - step.work.supplied,
          kinetic(island.start) + kinetic(step.end) + std::abs(step.work.supplied) +
              std::abs(after - before) + spring_energy_of(island, island.begin, island.start),
          kUnitRoundoff * (std::abs(before) + std::abs(after))};
}

bool IslandIntegrator::gains(const Island& island, const IslandStep& step) const {
  constexpr double share = 10, roundings = 32;
  if (moves_prescribed_) return false;
  const Gain gain = gain_of(island, step);
  return !(gain.energy <= share * tolerance_ * gain.scale + roundings * gain.rounding);
}

bool IslandIntegrator::close_stiff_step(const Island& island, IslandStep& step) const {
  constexpr double roundings = 32;
  if (!step.is_finite()) return false;
  // Joints are put back before the books are closed: that stretches springs.
  if (!assembler_.joints_of(island.bodies).empty()) {
    const std::vector<BodyPhase> before = step.end;
    AdvanceReport report;
    JointProjection(model_, assembler_)
        .project_positions(island.begin + step.h, island.bodies, step.end, report);
    keep_angular_momenta(before, step.end);
  }
  // What stands still around the bodies has taken what of the momenta the step has not found; where there is
  // nothing, the bodies get it back.
  const bool is_alone = is_free(island);
  const MomentumChange change = momentum_change(island.start, step.end);
  if (is_alone) {
    give_momenta(model_, island.bodies, step.impulse - change.P, step.angular_impulse - change.L, step.end);
  } else {
    step.impulse = change.P;
    step.angular_impulse = change.L;
  }

  // No energy comes of the step.
  if (moves_prescribed_) return true;
  const Gain gain = gain_of(island, step);
  if (!(gain.energy > 0)) return std::isfinite(gain.energy);
  const EnergyBalance balance{true, is_alone, {}};
  const std::vector<BodyPhase> untouched = step.end;
  const double taken = take_kinetic_energy(model_, island.bodies, gain.energy, balance, step.end).energy;
  if (!is_alone) {
    const MomentumChange given = momentum_change(untouched, step.end);
    step.impulse += given.P;
    step.angular_impulse += given.L;
  }
  return gain.energy - taken <= roundings * gain.rounding;
}

}  // namespace rigor
