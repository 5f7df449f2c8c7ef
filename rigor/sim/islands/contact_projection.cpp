#include "rigor/sim/islands/contact_projection.hpp"

#include "rigor/sim/islands/displacement.hpp"
#include "rigor/sim/islands/energy_repair.hpp"
#include "rigor/sim/method/resting_choice.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

/// How far any point of the bodies moves at most between the phases [m].
double farthest_move(const Model& model, const std::vector<int>& bodies, const std::vector<BodyPhase>& from,
                     const std::vector<BodyPhase>& to) {
  double farthest = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const double angle = from[i].q.angularDistance(to[i].q);
    const double of_body = (to[i].x - from[i].x).norm() + model.body(bodies[i]).bounding_radius * angle;
    farthest = std::max(farthest, of_body);
  }
  return farthest;
}

}  // namespace

ContactProjection::ContactProjection(const Model& model, const Environment& environment,
                                     const ContactSystemAssembler& assembler, const Method& method)
    : model_(model),
      environment_(environment),
      assembler_(assembler),
      contact_tolerance_(method.contact_tolerance),
      resting_(resting_choice(method)) {}

void ContactProjection::restore_gaps(const Island& island, double t, IslandStep& step) const {
  if (island.contacts.empty()) return;
  const ContactSystem system = assembler_.assemble(island, t, step.end);

  // How far each gap has drifted over the step.
  VecX drift = VecX::Zero(3 * static_cast<Eigen::Index>(island.contacts.size()));
  std::vector<ContactMode> modes;
  for (std::size_t i = 0; i < island.contacts.size(); ++i) {
    const bool holds = !island.contacts[i].stop && island.states[i].mode != ContactMode::open;
    modes.push_back(holds ? ContactMode::slide : ContactMode::open);
    if (holds)
      drift[3 * static_cast<Eigen::Index>(i) + 2] =
          system.contacts[i].point.gap - island.contacts[i].point.gap;
  }
  constexpr double rounding = 1e-15;
  // A contact that is found on other features than before is not the one that drifted.
  const double largest = drift.cwiseAbs().maxCoeff();
  if (largest <= rounding * model_.length_scale() || largest > 0.1 * contact_tolerance_) return;

  // The smallest displacement that takes the drift back.
  const std::vector<BodyPhase> drifted = step.end;
  apply_displacement(normal_impulses(system, drift, modes, resting_), system, island.bodies, step.end);

  // Of contacts that are close together the difference of two drifts may ask for a rotation by far more than
  // they: that would push the bodies into each other elsewhere, and the drift is the smaller harm.
  if (farthest_move(model_, island.bodies, drifted, step.end) > 0.5 * contact_tolerance_) {
    step.end = drifted;
    return;
  }

  // What it has lifted is paid for by the motion; bodies whose motion cannot pay for it stay where the step
  // has left them.
  if (!pay_for_correction(model_, environment_, island, drifted, step)) step.end = drifted;
}

bool ContactProjection::part_pushed(const Island& island, double t, const std::vector<BodyPhase>& before,
                                    std::vector<BodyPhase>& phases) const {
  const double noticeable = 0.01 * contact_tolerance_;
  if (island.contacts.empty() || farthest_move(model_, island.bodies, before, phases) <= noticeable)
    return false;

  // Which of the gaps are lower now than both touching and what they were.
  const ContactSystem then = assembler_.assemble_contacts(island, t, before);
  const ContactSystem now = assembler_.assemble(island, t, phases);
  std::vector<double> lowest;
  bool is_pushed = false;
  for (std::size_t i = 0; i < island.contacts.size(); ++i) {
    lowest.push_back(std::min(0.0, then.contacts[i].point.gap));
    is_pushed = is_pushed || (!island.contacts[i].stop && now.contacts[i].point.gap < lowest[i] - noticeable);
  }
  if (!is_pushed) return false;
  apply_displacement(separating_impulses(now, lowest), now, island.bodies, phases);
  return true;
}

bool ContactProjection::project_positions(Cluster& cluster, bool are_given, AdvanceReport& report) const {
  // Small overlaps may stay.
  double deepest = 0;
  for (const Contact& contact : cluster.contacts) deepest = std::min(deepest, contact.point.gap);
  if (deepest >= -0.2 * contact_tolerance_) return false;

  // The smallest displacement at which no gap is below zero.
  const std::vector<BodyPhase> before = cluster.phases;
  const ContactSystem system = assembler_.assemble(cluster, cluster.contacts);
  apply_displacement(separating_impulses(system, std::vector<double>(cluster.contacts.size(), 0.0)), system,
                     cluster.bodies, cluster.phases);
  const EnergyBalance balance =
      energy_balance(model_, environment_, cluster.t, cluster.bodies, cluster.contacts);
  if (!balance.is_closed) return true;
  const double gained = energy_of_bodies(model_, environment_, cluster.t, cluster.bodies, cluster.phases) -
                        energy_of_bodies(model_, environment_, cluster.t, cluster.bodies, before);
  if (gained <= 0) return true;
  const TakenEnergy taken = take_kinetic_energy(model_, cluster.bodies, gained, balance, cluster.phases);
  // Bodies that hardly move cannot pay. They may stay as they are, unless the overlap is more than is
  // allowed.
  if (taken.energy < gained && deepest > -0.8 * contact_tolerance_) {
    cluster.phases = before;
    return false;
  }
  report.projection_loss += taken.energy;
  report.work += taken.work;
  if (are_given) report.work += std::max(0.0, gained - taken.energy);
  return true;
}

}  // namespace rigor
