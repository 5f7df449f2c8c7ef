#include "rigor/sim/report/advance_report.hpp"

#include "rigor/contact/system/work_done.hpp"
#include "rigor/core/work_count.hpp"
#include "rigor/model/model.hpp"

#include <algorithm>

namespace rigor {

void PairInstants::add(const PairInstants& later) {
  // The first of both is kept.
  const long sum = instants + later.instants;
  if (later.instants > 0 && (instants == 0 || later.first < first)) *this = later;
  instants = sum;
}

std::string SchemeSpan::name() const {
  const bool is_soft = scheme == Scheme::time_stepping && solver == SolverMethod::substep;
  return scheme_name(scheme) + (is_soft ? " (substep)" : "");
}

void SchemeSpan::add(const SchemeSpan& later) {
  end = later.end;
  energy = later.energy;
  work += later.work;
  rise = std::max(rise, later.rise);
  impacts += later.impacts;
  end_cause = later.end_cause;
}

void AdvanceReport::note_problem(std::size_t contact_count, int iterations) {
  const double count = static_cast<double>(contact_count);
  ++problems;
  effort += count * count * (1 + iterations);
  // Impacts are solved where they act: their cost grows with the contacts, not with the square.
  constexpr double operations = 10;  // Of a contact in an iteration.
  count_work(static_cast<std::uint64_t>(operations * count * (1 + iterations)));
}

void AdvanceReport::note_span(const SchemeSpan& span) {
  if (!spans.empty() && spans.back().continues_in(span)) {
    spans.back().add(span);
  } else {
    spans.push_back(span);
  }
}

void AdvanceReport::book(const WorkDone& done) {
  work += done.supplied;
  motor_work += done.motors;
  friction_loss += done.friction;
}

void AdvanceReport::note_penetration(double depth, int A, int B, double t) {
  if (depth <= max_penetration) return;
  max_penetration = depth;
  penetration_A = A;
  penetration_B = B;
  penetration_time = t;
}

void AdvanceReport::note_passage(int A, int B, double t) {
  passages.add({1, A, B, t});
}

void AdvanceReport::note_overlap(const Model& model, double depth, int A, int B, double t) {
  note_penetration(depth, A, B, t);
  const double share = depth / std::min(model.body(A).thickness, model.body(B).thickness);
  if (share > worst_overlap.share) worst_overlap = {share, depth, A, B, t};
}

void AdvanceReport::note_joint_drift(double drift, int joint) {
  if (!(drift > max_joint_drift)) return;
  max_joint_drift = drift;
  drift_joint = joint;
}

void AdvanceReport::add(const AdvanceReport& later) {
  reason = later.reason;
  detail = later.detail;
  bodies = later.bodies;
  steps += later.steps;
  impacts += later.impacts;
  resting += later.resting;
  separations += later.separations;
  slip_to_stick += later.slip_to_stick;
  distance_queries += later.distance_queries;
  problems += later.problems;
  effort += later.effort;
  step_work += later.step_work;
  for (const SchemeSpan& span : later.spans) note_span(span);
  events.insert(events.end(), later.events.begin(), later.events.end());
  toi_bracket = std::max(toi_bracket, later.toi_bracket);
  note_penetration(later.max_penetration, later.penetration_A, later.penetration_B, later.penetration_time);
  passages.add(later.passages);
  if (later.worst_overlap.share > worst_overlap.share) worst_overlap = later.worst_overlap;
  note_joint_drift(later.max_joint_drift, later.drift_joint);
  max_joint_projection = std::max(max_joint_projection, later.max_joint_projection);
  work += later.work;
  motor_work += later.motor_work;
  impact_loss += later.impact_loss;
  impact_gain += later.impact_gain;
  damping_loss += later.damping_loss;
  friction_loss += later.friction_loss;
  projection_loss += later.projection_loss;
  momentum_error += later.momentum_error;
  angular_momentum_error += later.angular_momentum_error;
  moved_momentum = std::max(moved_momentum, later.moved_momentum);
  moved_angular_momentum = std::max(moved_angular_momentum, later.moved_angular_momentum);
  moved_energy = std::max(moved_energy, later.moved_energy);
  rounded_momentum += later.rounded_momentum;
  max_residual = std::max(max_residual, later.max_residual);
  max_iterations = std::max(max_iterations, later.max_iterations);
  fallbacks += later.fallbacks;
  if (later.force_uncertainty.share > force_uncertainty.share) force_uncertainty = later.force_uncertainty;
  coarse_steps += later.coarse_steps;
  inconsistent.add(later.inconsistent);
  indeterminate.add(later.indeterminate);
  quaternion_drift = std::max(quaternion_drift, later.quaternion_drift);
}

}  // namespace rigor
