#include "rigor/sim/audit/audit.hpp"

#include "rigor/bulk/sleep/sleep.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/sim/audit/contact_snapshot.hpp"
#include "rigor/sim/method/scheme_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

namespace rigor {

namespace {

bool is_kinematic(const Model& model, int body) {
  return body != world_body && model.body(body).motion == MotionType::kinematic;
}

/// Whether there is work that the many-body path does not know: of motors, and of kinematic bodies on joints
/// and springs.
bool has_unknown_work(const Model& model) {
  for (const Joint& joint : model.joints()) {
    if (is_kinematic(model, joint.body_A) || is_kinematic(model, joint.body_B)) return true;
    for (const JointAxis& axis : joint.axes) {
      if (axis.motor) return true;
    }
  }
  for (const Force& force : model.forces()) {
    const Spring* const spring = std::get_if<Spring>(&force);
    if (spring && (is_kinematic(model, spring->body_A) || is_kinematic(model, spring->body_B))) return true;
  }
  return false;
}

}  // namespace

Auditor::Auditor(std::shared_ptr<const Model> model, const Method& method, const State& start)
    : model_(std::move(model)), environment_(*model_), start_time_(start.t), time_(start.t) {
  ResolvedMethod resolved = resolve_scheme(*model_, method);
  method_ = resolved.method;
  scheme_reason_ = std::move(resolved.scheme_reason);
  initial_ = energy_ = mechanical_energy(*model_, environment_, start);
  lowest_ = initial_.total();
  observe(start, {});
}

void Auditor::observe(const State& state, const AdvanceReport& report) {
  AdvanceReport without_events = report;
  without_events.events.clear();
  sum_.add(without_events);
  energy_ = mechanical_energy(*model_, environment_, state);
  const double balance = energy_.total() - sum_.work;
  max_increase_ = std::max(max_increase_, balance - lowest_);
  lowest_ = std::min(lowest_, balance);
  energy_scale_ = std::max({energy_scale_, energy_.kinetic, std::abs(energy_.total() - initial_.total()),
                            std::abs(energy_.potential - initial_.potential), std::abs(sum_.work)});
  // What forces hand over and contacts take back in a step is never seen in a body at rest, but its rounding.
  const double span = method_.scheme == Scheme::event_driven ? 0 : state.t - time_;
  time_ = state.t;
  double momentum = 0, angular_momentum = 0, turning = 0;
  for (int i = 0; i < model_->body_count(); ++i) {
    momentum += state.linear_momentum(i).norm();
    angular_momentum +=
        state.angular_momentum(i).norm() + state.position(i).norm() * state.linear_momentum(i).norm();
    const Body& body = model_->body(i);
    const double radius = body.bounding_radius;
    if (body.motion == MotionType::dynamic && span > 0) {
      const double speed = span * environment_.steady_acceleration(i).norm();
      momentum += body.mass * speed;
      angular_momentum += body.mass * speed * (state.position(i).norm() + model_->length_scale());
      energy_scale_ = std::max(energy_scale_, 0.5 * body.mass * speed * speed);
    }
    turning += state.angular_momentum(i).norm() /
               (radius > 0 && std::isfinite(radius) ? radius : model_->length_scale());
  }
  // What moves between the outputs only is seen by its impacts.
  for (const MotionEvent& event : report.events) {
    momentum = std::max(momentum, event.j_W.norm());
    angular_momentum = std::max(angular_momentum, event.p_W.norm() * event.j_W.norm());
  }
  // Of wheels that only turn, the linear momentum is the rounding of what their parts have.
  constexpr double rounding_share = 1e-6;
  momentum_scale_ = std::max({momentum_scale_, momentum, rounding_share * turning});
  angular_momentum_scale_ = std::max(angular_momentum_scale_, angular_momentum);
}

Audit Auditor::audit(const State& state) const {
  Audit audit;
  audit.scene = model_->name();
  audit.method = method_;
  audit.scheme_reason = scheme_reason_;
  audit.sim_time = state.t - start_time_;
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
    const Pose X_WL = Pose{rotation_matrix(q_WB), state.position(i)} * body.X_BL;
    audit.bodies.push_back({body.name, X_WL.p, quaternion_of(X_WL.R), linear_velocity(*model_, state, i),
                            angular_velocity(*model_, state, i)});
  }
  for (const JointReaction& forces : joint_snapshot(*model_, method_, state)) {
    audit.joints.push_back({model_->joint(forces.joint).name, forces.coordinates, forces.rates,
                            forces.force_W, forces.torque_W});
  }
  audit.sleeping_count =
      static_cast<int>(std::count(state.quiet_time.begin(), state.quiet_time.end(), asleep));
  judge(audit);
  return audit;
}

void Auditor::judge(Audit& audit) const {
  // Energy and momentum of what is solved exactly hold to rounding; integrated phases to their tolerance. A
  // millionth is what no method that deserves its name exceeds; the energy of springs that steps of a fifth
  // of their time scale integrate is a thousandth off.
  constexpr double share = 1e-6;
  const bool is_penalty = method_.scheme == Scheme::penalty;
  const bool is_substep = method_.scheme == Scheme::time_stepping && method_.solver == SolverMethod::substep;
  const double energy_share = is_penalty || is_substep ? 1e-3 : share;
  const auto check = [&](const char* what, double value, double bound, const char* unit) {
    if (value > bound) {
      audit.violations.push_back(
          fmt::format("{} is {:.3g} {}, the tolerance is {:.3g} {}", what, value, unit, bound, unit));
    }
  };
  const bool knows_work = !is_substep || !has_unknown_work(*model_);
  double lift = 0;  // Its contacts push bodies that overlap apart, also upwards.
  for (int i = 0; is_substep && i < model_->body_count(); ++i)
    lift += model_->body(i).mass * environment_.steady_acceleration(i).norm() * model_->length_scale();
  if (knows_work) {
    check("unexplained rise of energy", audit.max_increase, energy_share * (energy_scale_ + lift), "J");
  }
  // Springs carry the weights of bodies at rest in many small impulses: their roundings add up.
  double carried = 0, carried_moment = 0;
  for (std::size_t i = 0; is_penalty && i < audit.bodies.size(); ++i) {
    const double impulse = model_->body(static_cast<int>(i)).mass * model_->g_W().norm() * audit.sim_time;
    carried += 1e-12 * impulse;
    carried_moment += 1e-12 * impulse * (audit.bodies[i].position.norm() + model_->length_scale());
  }
  // Velocities of 32 bits are rounded in each sweep, at some ten contacts: errors walk at random. Joints are
  // swept as often as contacts.
  const double sweeps = static_cast<double>(audit.report.steps) * audit.report.max_iterations *
                        (model_->joints().empty() ? 1 : 2);
  const double momentum_share = is_substep ? 0x1p-24 * std::sqrt(10 * sweeps) : share;
  check("error of linear momentum", audit.linear_momentum_error, momentum_share * momentum_scale_ + carried,
        "kg m/s");
  check("error of angular momentum", audit.angular_momentum_error,
        share * angular_momentum_scale_ + carried_moment, "kg m²/s");
  const double joint_share = is_substep ? 1e-2 : 1e-9;
  check("drift of joints", audit.report.max_joint_drift, joint_share * std::max(1.0, model_->length_scale()),
        "m or rad");
  // Several impacts at once press deeper than the one that a spring is made for; of a spring of given
  // stiffness nothing is promised.
  if (is_substep) {
    // Its contacts give way; deeper than this they have failed.
    check("penetration", audit.report.max_penetration, 0.05 * model_->length_scale(), "m");
  } else if (!is_penalty) {
    check("penetration", audit.report.max_penetration, method_.contact_tolerance, "m");
  } else if (method_.stiffness == 0) {
    check("penetration", audit.report.max_penetration,
          std::max(method_.contact_tolerance, 2 * method_.penalty_depth), "m");
  }

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
  const auto report_paradox = [&](const ParadoxCount& count, const char* what, const char* resolved) {
    if (count.instants == 0) return;
    audit.warnings.push_back(fmt::format(
        "{} at {} and {} at t = {:.6g} s, {}: {} (Painlevé's paradox)", what, model_->body(count.body_A).name,
        model_->body(count.body_B).name, count.first,
        count.instants == 1 ? "once" : fmt::format("the first of {} times", count.instants), resolved));
  };
  report_paradox(audit.report.inconsistent, "no finite contact force", "impulses resolve it");
  report_paradox(audit.report.indeterminate, "more than one possible contact force",
                 "the motion may go on in several ways and one was taken");
  if (audit.report.coarse_steps > 0) {
    audit.warnings.push_back(fmt::format(
        "{} steps were of first order or above their error tolerance: slip or contact modes changed "
        "faster than time resolves",
        audit.report.coarse_steps));
  }
}

}  // namespace rigor
