#include "rigor/sim/audit/audit.hpp"

#include "rigor/bulk/sleep/sleep.hpp"
#include "rigor/core/rounding.hpp"
#include "rigor/dynamics/environment.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/sim/audit/contact_snapshot.hpp"
#include "rigor/sim/audit/promises_of.hpp"
#include "rigor/sim/method/method_use.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace rigor {

namespace {

/// How fast a body's points move by its rotation alone, as a momentum [kg m/s].
double momentum_of_rotation(const Model& model, const State& state, int i) {
  const double radius = model.body(i).bounding_radius;
  return state.angular_momentum(i).norm() /
         (radius > 0 && std::isfinite(radius) ? radius : model.length_scale());
}

/// What two energies and the work between them may differ by from rounding alone [J]. Potentials count from
/// the world's origin: each is a sum of m g·x with roundings of x (1), of its products and their sum (4) and
/// of the sum over bodies, which is compensated (1).
double rounding_of_balance(const Energy& before, const Energy& after, double work) {
  constexpr double roundings = 6;
  return roundings * kUnitRoundoff *
         (std::abs(before.potential) + std::abs(after.potential) + std::abs(work));
}

}  // namespace

bool Audit::uses(std::string_view key) const {
  return uses_choice(method, key) || std::any_of(spans.begin(), spans.end(), [&](const Span& span) {
           Method of_span = method;
           of_span.scheme = span.of.scheme;
           of_span.solver = span.of.solver;
           return uses_choice(of_span, key);
         });
}

Auditor::Auditor(const std::shared_ptr<const Model>& model, const Method& method, const State& start)
    : Auditor(model, resolve_scheme(*model, method), start) {}

Auditor::Auditor(std::shared_ptr<const Model> model, const ResolvedMethod& choice, const State& start)
    : model_(std::move(model)),
      method_(choice.method),
      scheme_reason_(choice.scheme_reason),
      environment_(std::make_shared<const Environment>(*model_)),
      start_time_(start.t),
      time_(start.t) {
  promises_ = promises_of(*model_, method_);
  initial_ = energy_ = mechanical_energy(*model_, *environment_, start);
  lowest_ = lowest_of_span_ = initial_.total();
  observe(start, {});
}

Auditor::Auditor(std::shared_ptr<const Model> model, const ResolvedMethod& choice, const State& state,
                 const Audit& earlier)
    : Auditor(std::move(model), choice, state) {
  start_time_ = earlier.books.start_time;
  initial_ = earlier.initial;
  sum_ = earlier.report;
  lowest_ = earlier.books.lowest;
  lowest_of_span_ = earlier.books.lowest_of_span;
  max_increase_ = earlier.max_increase;
  energy_scale_ = earlier.books.energy_scale;
  momentum_scale_ = earlier.books.momentum_scale;
  angular_momentum_scale_ = earlier.books.angular_momentum_scale;
  given_ = earlier.books.given;
  promises_.knows_work = promises_.knows_work && earlier.books.knows_work;
}

void Auditor::observe(const State& state, const AdvanceReport& report) {
  AdvanceReport sums = report;
  sums.events.clear();
  sums.spans.clear();
  balance_spans(report);
  sum_.add(sums);
  energy_ = mechanical_energy(*model_, *environment_, state);
  const double balance = energy_.total() - sum_.work;
  max_increase_ = std::max(max_increase_, balance - lowest_);
  lowest_ = std::min(lowest_, balance);
  // Jumps of a potential that is defined up to a constant do not count.
  energy_scale_ =
      std::max({energy_scale_, energy_.kinetic, std::abs(energy_.total() - initial_.total() - given_.total()),
                std::abs(energy_.potential - initial_.potential - given_.potential),
                std::abs(sum_.work - given_.total())});
  observe_scales(state, report);
  time_ = state.t;
}

void Auditor::change(std::shared_ptr<const Model> model, const State& state) {
  model_ = std::move(model);
  environment_ = std::make_shared<const Environment>(*model_);
  // What held before is judged by what was promised then.
  promises_ = weaker_of(promises_, promises_of(*model_, method_));
  const Energy before = energy_;
  energy_ = mechanical_energy(*model_, *environment_, state);
  given_.kinetic += energy_.kinetic - before.kinetic;
  given_.potential += energy_.potential - before.potential;
  given_.elastic += energy_.elastic - before.elastic;
  sum_.work += energy_.total() - before.total();
  observe_scales(state, {});
}

void Auditor::balance_spans(const AdvanceReport& report) {
  double balance = energy_.total() - sum_.work, work = sum_.work;
  for (SchemeSpan span : report.spans) {
    // A new span is measured from where it begins.
    if (!sum_.spans.empty() && !sum_.spans.back().continues_in(span)) lowest_of_span_ = balance;
    work += span.work;
    balance = span.energy - work;
    span.rise = std::max(0.0, balance - lowest_of_span_);
    lowest_of_span_ = std::min(lowest_of_span_, balance);
    max_increase_ = std::max(max_increase_, balance - lowest_);
    lowest_ = std::min(lowest_, balance);
    sum_.note_span(span);
  }
}

SchemePromises Auditor::promises_of_span(const SchemeSpan& span) const {
  Method method = method_;
  method.scheme = span.scheme;
  method.solver = span.solver;
  return promises_of(*model_, method);
}

void Auditor::observe_scales(const State& state, const AdvanceReport& report) {
  // A body at rest never shows the momentum that forces give and contacts take back within one step, but it
  // shows its rounding.
  const bool has_steps = std::any_of(report.spans.begin(), report.spans.end(), [&](const SchemeSpan& each) {
    return promises_of_span(each).acts_in_steps;
  });
  const double span = promises_.acts_in_steps || has_steps ? state.t - time_ : 0;
  double momentum = 0, angular_momentum = 0, of_rotation = 0, lightest = kInfinity;
  for (int i = 0; i < model_->body_count(); ++i) {
    momentum += state.linear_momentum(i).norm();
    angular_momentum +=
        state.angular_momentum(i).norm() + state.position(i).norm() * state.linear_momentum(i).norm();
    const Body& body = model_->body(i);
    if (body.motion == MotionType::dynamic) lightest = std::min(lightest, body.mass);
    if (body.motion == MotionType::dynamic && span > 0) {
      const double speed = span * environment_->steady_acceleration(i).norm();
      momentum += body.mass * speed;
      angular_momentum += body.mass * speed * (state.position(i).norm() + model_->length_scale());
      energy_scale_ = std::max(energy_scale_, 0.5 * body.mass * speed * speed);
    }
    of_rotation += momentum_of_rotation(*model_, state, i);
  }
  // What springs have set free moved at least the lightest body, however soon it came to rest.
  const double set_free = initial_.elastic + given_.elastic - energy_.elastic;
  if (set_free > 0 && std::isfinite(lightest))
    momentum = std::max(momentum, std::sqrt(2 * lightest * set_free));
  // Motion that begins and ends between two outputs shows in its impacts only.
  for (const MotionEvent& event : report.events) {
    momentum = std::max(momentum, event.j_W.norm());
    angular_momentum = std::max(angular_momentum, event.p_W.norm() * event.j_W.norm());
  }
  energy_scale_ = std::max(energy_scale_, report.moved_energy);
  momentum = std::max(momentum, report.moved_momentum);
  angular_momentum = std::max(angular_momentum, report.moved_angular_momentum);
  // The linear momentum of wheels that only rotate is the rounding of the momenta of their parts.
  constexpr double rounding_share = 1e-6;
  momentum_scale_ = std::max({momentum_scale_, momentum, rounding_share * of_rotation});
  angular_momentum_scale_ = std::max(angular_momentum_scale_, angular_momentum);
}

Audit Auditor::audit(const State& state) const {
  Audit audit;
  audit.scene = model_->name();
  audit.method = method_;
  audit.scheme_reason = scheme_reason_;
  audit.sim_time = state.t - start_time_;
  audit.end_time = state.t;
  audit.report = sum_;
  audit.initial = initial_;
  audit.final = energy_;
  audit.dissipated = initial_.total() + sum_.work - energy_.total();
  audit.max_increase = max_increase_;
  audit.linear_momentum_error = sum_.momentum_error.norm();
  audit.angular_momentum_error = sum_.angular_momentum_error.norm();
  for (int i = 0; i < model_->body_count(); ++i) {
    const Body& body = model_->body(i);
    const Quat q_WB = state.orientation(i);
    const Pose X_WU = Pose{rotation_matrix(q_WB), state.position(i)} * body.X_BU;
    audit.bodies.push_back({body.name, X_WU.p, quaternion_of(X_WU.R), linear_velocity(*model_, state, i),
                            angular_velocity(*model_, state, i)});
  }
  for (const JointReaction& forces : joint_snapshot(*model_, method_, state)) {
    const Joint& joint = model_->joint(forces.joint);
    audit.joints.push_back({joint.name, forces.coordinates, forces.rates, forces.force_W, forces.torque_W,
                            model_->has_motor(forces.joint) ? forces.efforts : std::vector<double>(),
                            joint.has_unbounded_motor()});
  }
  audit.sleeping_count =
      static_cast<int>(std::count(state.quiet_time.begin(), state.quiet_time.end(), asleep));
  audit.books = {start_time_,     lowest_, energy_scale_,       momentum_scale_, angular_momentum_scale_,
                 lowest_of_span_, given_,  promises_.knows_work};
  judge_spans(audit);
  find_violations(audit);
  find_warnings(audit);
  return audit;
}

/// What each scheme promises of its parts.
void Auditor::judge_spans(Audit& audit) const {
  const double rounding = rounding_of_balance(initial_, energy_, sum_.work);
  for (const SchemeSpan& span : sum_.spans) {
    const SchemePromises promises = promises_of_span(span);
    audit.spans.push_back({span, promises.energy_share * (energy_scale_ + promises.energy_floor) + rounding,
                           promises.penetration, promises.penetration_share, promises.joint_drift});
  }
}

/// What is about the whole run is judged by the weaker promises of the schemes that carried it.
SchemePromises Auditor::promises_of_run() const {
  SchemePromises promises = promises_;
  for (const SchemeSpan& span : sum_.spans) promises = weaker_of(promises, promises_of_span(span));
  return promises;
}

double Auditor::max_increase() const {
  return promises_of_run().knows_work ? max_increase_ : std::numeric_limits<double>::quiet_NaN();
}

void Auditor::find_violations(Audit& audit) const {
  const SchemePromises promises = promises_of_run();
  const auto check = [&](Audit::Promise promise, const char* quantity, double value, double bound,
                         const char* unit) {
    if (value > bound) {
      audit.broken.push_back(promise);
      audit.violations.push_back(
          fmt::format("{} is {:.3g} {}, the tolerance is {:.3g} {}", quantity, value, unit, bound, unit));
    }
  };
  audit.knows_work = promises.knows_work;
  if (promises.knows_work) {
    check(Audit::Promise::energy, "unexplained rise of energy", audit.max_increase,
          promises.energy_share * (energy_scale_ + promises.energy_floor) +
              rounding_of_balance(initial_, energy_, sum_.work),
          "J");
  }
  // Each part of a run that was handed over keeps besides what its own scheme promises.
  for (const Audit::Span& span : audit.spans) {
    if (!audit.was_handed_over() || !promises.knows_work) break;
    const std::string quantity = fmt::format("unexplained rise of energy from {:.6g} to {:.6g} s ({})",
                                             span.of.begin, span.of.end, span.of.name());
    check(Audit::Promise::energy, quantity.c_str(), span.of.rise, span.most_rise, "J");
  }
  // The momenta that the weights of all bodies have given in the run, and their moments.
  double carried = 0, carried_moment = 0;
  for (std::size_t i = 0; promises.weight_share > 0 && i < audit.bodies.size(); ++i) {
    const double impulse = model_->body(static_cast<int>(i)).mass * model_->g_W().norm() * audit.sim_time;
    carried += promises.weight_share * impulse;
    carried_moment +=
        promises.weight_share * impulse * (audit.bodies[i].position.norm() + model_->length_scale());
  }
  // Roundings of velocities in each sweep of the contacts: on the same side, step after step, where bodies
  // rest or roll. They are all that steps in 32 bits leave; what other schemes carried has its own error.
  const double rounding = promises.rounding_share * audit.report.rounded_momentum,
               of_others = promises_.rounding_share > 0 ? 0 : promises.momentum_share * momentum_scale_;
  check(Audit::Promise::momentum, "error of linear momentum", audit.linear_momentum_error,
        rounding + of_others + carried, "kg m/s");
  check(Audit::Promise::momentum, "error of angular momentum", audit.angular_momentum_error,
        promises.momentum_share * angular_momentum_scale_ + carried_moment, "kg m²/s");
  check(Audit::Promise::joints, "drift of joints", audit.report.max_joint_drift, promises.joint_drift,
        "m or rad");
  find_overlaps(promises, audit);
  if (const PairInstants& passages = audit.report.passages; passages.instants > 0) {
    audit.broken.push_back(Audit::Promise::overlap);
    audit.violations.push_back(
        fmt::format("the inside of '{}' went into '{}' at t = {:.6g} s{}: bodies passed each other unseen",
                    model_->body(passages.body_A).name, model_->body(passages.body_B).name, passages.first,
                    passages.instants == 1 ? "" : fmt::format(", the first of {} times", passages.instants)));
  }
  const ForceUncertainty& uncertainty = audit.report.force_uncertainty;
  if (uncertainty.share > promises.force_uncertainty) {
    audit.broken.push_back(Audit::Promise::force_uncertainty);
    audit.violations.push_back(fmt::format(
        "the forces of contacts determine the acceleration of {} at t = {:.6g} s to {:.3g} of that of "
        "its weight only, the tolerance is {:.3g} of it: it carries bodies too heavy for it",
        model_->body(uncertainty.body).name, uncertainty.time, uncertainty.share,
        promises.force_uncertainty));
  }
}

/// Overlaps deeper than the scheme allows, or than the thinner of two bodies bears, with pair and time.
void Auditor::find_overlaps(const SchemePromises& promises, Audit& audit) const {
  const auto text = [&](double depth, int A, int B, double t) {
    return A < 0 || B < 0 ? fmt::format("penetration is {:.3g} m", depth)
                          : fmt::format("penetration of {} and {} is {:.3g} m at t = {:.6g} s",
                                        model_->body(A).name, model_->body(B).name, depth, t);
  };
  const AdvanceReport& report = audit.report;
  if (report.max_penetration > promises.penetration) {
    audit.broken.push_back(Audit::Promise::overlap);
    audit.violations.push_back(fmt::format(
        "{}, the tolerance is {:.3g} m",
        text(report.max_penetration, report.penetration_A, report.penetration_B, report.penetration_time),
        promises.penetration));
  }
  const RelativeOverlap& worst = report.worst_overlap;
  if (worst.share > promises.penetration_share) {
    audit.broken.push_back(Audit::Promise::overlap);
    audit.violations.push_back(fmt::format(
        "{}, {:.3g} of the thickness of the thinner body, the tolerance is {:.3g} of it",
        text(worst.depth, worst.body_A, worst.body_B, worst.time), worst.share, promises.penetration_share));
  }
}

void Auditor::find_warnings(Audit& audit) const {
  if (audit.report.impact_gain > 1e-12 * energy_scale_) {
    audit.warnings.push_back(
        fmt::format("impacts added {:.3g} J: Newton's law with friction can gain energy, and so can several "
                    "impacts by `lcp` or `projection`",
                    audit.report.impact_gain));
  }
  if (audit.report.fallbacks > 0) {
    audit.warnings.push_back(
        fmt::format("{} contact problems did not reach their tolerance; largest residual {:.3g}",
                    audit.report.fallbacks, audit.report.max_residual));
  }
  const auto report_paradox = [&](const PairInstants& count, const char* finding, const char* resolved) {
    if (count.instants == 0) return;
    audit.warnings.push_back(fmt::format(
        "{} at {} and {} at t = {:.6g} s, {}: {} (Painlevé's paradox)", finding,
        model_->body(count.body_A).name, model_->body(count.body_B).name, count.first,
        count.instants == 1 ? "once" : fmt::format("the first of {} times", count.instants), resolved));
  };
  report_paradox(audit.report.inconsistent, "no finite contact force", "impulses resolve it");
  report_paradox(audit.report.indeterminate, "more than one possible contact force",
                 "the motion can continue in several ways and one was chosen");
  if (audit.report.coarse_steps > 0) {
    audit.warnings.push_back(fmt::format(
        "{} steps were of first order or above their error tolerance: slip or contact modes changed "
        "faster than the resolution of time",
        audit.report.coarse_steps));
  }
}

}  // namespace rigor
