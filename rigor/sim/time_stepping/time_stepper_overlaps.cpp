#include "rigor/core/index.hpp"
#include "rigor/sim/islands/displacement.hpp"
#include "rigor/sim/report/energy.hpp"
#include "rigor/sim/time_stepping/reaches.hpp"
#include "rigor/sim/time_stepping/time_stepper.hpp"

#include <algorithm>

namespace rigor {

/// Bodies that overlap at the start of a scene, by no more than counts as touching, are put apart before the
/// first step: what lifts them is work, and no energy that a step adds.
void TimeStepper::admit_overlaps(State& state) {
  const double before = mechanical_energy(*model_, environment_, state).total();
  const Cluster start = cluster_in(state);
  Trial trial{.h = 0, .struck = start, .end = start, .reaches = {}, .near = {}};
  if (correct_overlaps(state, trial) > method_.contact_tolerance) return;
  write(trial.end, state);
  report_.work += mechanical_energy(*model_, environment_, state).total() - before;
}

/// By body: whether it is elsewhere than it was before.
std::vector<bool> TimeStepper::moved_since(const Cluster& before, const Cluster& now) const {
  std::vector<bool> is_moved(at(model_->body_count()), false);
  for (std::size_t i = 0; i < now.bodies.size(); ++i)
    is_moved[at(now.bodies[i])] = !is_same_phase(before.phases[i], now.phases[i]);
  return is_moved;
}

/// Bodies that overlap are moved apart until they touch, by the smallest displacements; momenta stay, and so
/// does the angular momentum about the origin. Returns the overlap that is left [m].
double TimeStepper::correct_overlaps(const State& state, Trial& trial) {
  constexpr int most_passes = 40;
  const double tolerable = 0.2 * method_.contact_tolerance;
  std::vector<double> reaches(at(model_->body_count()), 0.0);
  const Cluster before = trial.end;
  Cluster& end = trial.end;
  State moved = state;
  double largest = 0;
  for (int pass = 0;; ++pass) {
    write(end, moved);
    const bool is_known = pass == 0 && trial.at_end;
    std::vector<Contact> contacts =
        is_known ? *trial.at_end
                 : contacts_.at_end(moved, contacts_.touching_pairs(moved), ways_, moved_since(before, end));
    double deepest = 0;
    for (const Contact& contact : contacts) deepest = std::max(deepest, -contact.point.gap);
    trial.touching_after = contacts_.touching(contacts);
    if (deepest <= tolerable || pass == most_passes) return deepest;
    largest = std::max(largest, deepest);
    // Nearby bodies may be in the way of what is moved.
    if (pass > 0) contacts = contacts_.at(moved, reaches);
    for (std::size_t i = 0; i < end.bodies.size(); ++i) {
      const int body = end.bodies[i];
      reaches[at(body)] =
          std::max(reaches[at(body)],
                   2 * (largest + reach_between(model_->body(body), before.phases[i], end.phases[i])));
    }
    if (pass == 0 && deepest > method_.contact_tolerance) continue;

    // Each part that overlaps, by the smallest displacement.
    for (Cluster& part : connected_parts(end, contacts, environment_)) {
      double of_part = 0;
      for (const Contact& contact : part.contacts) of_part = std::max(of_part, -contact.point.gap);
      if (of_part <= tolerable) continue;
      const ContactSystem system = assembler_.assemble(part, part.contacts);
      const std::vector<double> lowest(part.contacts.size(), 0.0);
      apply_displacement(separating_impulses(system, lowest), system, part.bodies, part.phases);
      project_joints(part, trial.report);
      for (std::size_t i = 0; i < part.bodies.size(); ++i) end.phase_of(part.bodies[i]) = part.phases[i];
    }
  }
}

}  // namespace rigor
