#include "rigor/sim/islands/mode_change.hpp"

#include "rigor/contact/impact/joint_stops.hpp"
#include "rigor/contact/resting/rolling_friction.hpp"
#include "rigor/math/roots.hpp"
#include "rigor/sim/method/resting_choice.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <utility>

namespace rigor {

namespace {

/// A function of a place in the step that remembers its values: searches ask for the ends of their brackets
/// several times, and each value takes the whole island there. Copies share what they remember.
template <class Value>
class Remembered {
 public:
  explicit Remembered(std::function<Value(double)> function) : function_(std::move(function)) {}
  const Value& operator()(double theta) const {
    const auto known = values_->find(theta);
    return known != values_->end() ? known->second : values_->emplace(theta, function_(theta)).first->second;
  }

 private:
  std::function<Value(double)> function_;
  std::shared_ptr<std::map<double, Value>> values_ = std::make_shared<std::map<double, Value>>();
};

/// Whether f falls to zero between the two places; false where it is no number, as in a motion that
/// overflows.
bool falls(const ScalarFunction& f, double from, double to) {
  return f(from) >= 0 && f(to) <= 0;
}

bool has_limits(const Model& model, const std::vector<int>& joints) {
  return std::any_of(joints.begin(), joints.end(), [&](int joint) {
    const std::vector<JointAxis>& axes = model.joint(joint).axes;
    return std::any_of(axes.begin(), axes.end(), [](const JointAxis& axis) { return axis.is_limited(); });
  });
}

}  // namespace

ModeChangeSearch::ModeChangeSearch(const Model& model, const ContactSystemAssembler& assembler,
                                   const Method& method)
    : model_(model),
      assembler_(assembler),
      overlaps_(model, method),
      contact_tolerance_(method.contact_tolerance),
      time_tolerance_(method.time_tolerance),
      slip_tolerance_(slip_tolerance(method)),
      direction_tolerance_(direction_tolerance(method)),
      resting_velocity_(method.resting_velocity),
      resting_(resting_choice(method)) {}

namespace {

std::vector<BodyPhase> phases_at(const IslandStep& step, double theta) {
  if (theta == 1) return step.end;
  std::vector<BodyPhase> phases;
  for (const DensePhase& dense : step.dense) phases.push_back(dense.at(theta));
  return phases;
}

}  // namespace

/// The island somewhere in its step.
struct ModeChangeSearch::Instant {
  double t;
  ContactSystem system;
};

ModeChangeSearch::Instant ModeChangeSearch::at(const Island& island, const IslandStep& step,
                                               double theta) const {
  const double t = island.begin + theta * step.h;
  return {t, assembler_.assemble(island, t, phases_at(step, theta))};
}

std::vector<Wrench> ModeChangeSearch::wrenches(const Island& island, const Instant& instant) const {
  return with_rolling_friction(instant.system, island.states,
                               assembler_.environment_wrenches(instant.system, instant.t),
                               direction_tolerance_, resting_velocity_);
}

/// Speed along its slip of each sliding contact; infinite for the others.
std::vector<double> ModeChangeSearch::slip_speeds(const Island& island, const IslandStep& step,
                                                  double theta) const {
  std::vector<double> speeds(island.states.size(), std::numeric_limits<double>::infinity());
  const ContactSystem system =
      assembler_.assemble_contacts(island, island.begin + theta * step.h, phases_at(step, theta));
  const VecX u = relative_velocities(system);
  for (std::size_t i = 0; i < island.states.size(); ++i) {
    if (island.states[i].mode != ContactMode::slide || island.states[i].slip_W.isZero(0)) continue;
    const Vec3 slip = system.frames[i].transpose() * island.states[i].slip_W;
    const Vec2 direction = slip.head<2>();
    if (direction.isZero(0)) continue;
    speeds[i] = u.segment<2>(3 * static_cast<Eigen::Index>(i)).dot(direction);
  }
  return speeds;
}

std::optional<ModeChange> ModeChangeSearch::find_slip_end(const Island& island, const IslandStep& step,
                                                          double end) const {
  // Slip that begins from rest may creep back by the uncertainty of the velocities, and no more.
  std::vector<double> levels = slip_speeds(island, step, 0);
  double uncertainty = 0;
  for (double& level : levels) {
    level = level > 0 ? 0 : 2 * level - slip_tolerance_;
    uncertainty = std::max(uncertainty, -level);
  }

  // The first time at which one of them falls below its level.
  const Remembered<double> margin([&](double theta) {
    const std::vector<double> speeds = slip_speeds(island, step, theta);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < speeds.size(); ++i) least = std::min(least, speeds[i] - levels[i]);
    return least;
  });
  if (!(margin(end) < 0) || !falls(margin, 0, end)) return std::nullopt;
  const RootBracket root = find_root_itp(margin, 0, end, time_tolerance_ / step.h);
  return ModeChange{ModeChange::Kind::slip_ends, root.hi * step.h,
                    std::max({0.0, root.f_lo, -root.f_hi}) + uncertainty};
}

double ModeChangeSearch::reversed_slip(const Island& island, const IslandStep& step) const {
  double fastest = 0;
  for (const double speed : slip_speeds(island, step, 1)) fastest = std::max(fastest, -speed);
  return fastest;
}

double ModeChangeSearch::force_margin(const Island& island, const Instant& instant) const {
  return margin_of(island, contact_forces(instant.system, island.states, wrenches(island, instant),
                                          direction_tolerance_, resting_));
}

/// Smallest of λ_n (active contacts) and μ λ_n - |λ_t| (sticking ones), relative to the largest force; a
/// little below zero is allowed for rounding.
double ModeChangeSearch::margin_of(const Island& island, const VecX& lambda) const {
  constexpr double rounding = 1e-10;
  const double scale = lambda.cwiseAbs().maxCoeff();
  if (scale == 0) return rounding;

  // How far each is inside its cone.
  double margin = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < island.states.size(); ++i) {
    if (island.states[i].mode == ContactMode::open) continue;
    const Vec3 force = lambda.segment<3>(3 * static_cast<Eigen::Index>(i)) / scale;
    margin = std::min(margin, force.z());
    if (island.states[i].mode == ContactMode::stick) {
      margin = std::min(margin, island.contacts[i].friction * force.z() - force.head<2>().norm());
    }
  }
  return margin + rounding;
}

std::vector<double> ModeChangeSearch::clearances(const Island& island, const IslandStep& step,
                                                 double theta) const {
  const ContactSystemAssembler::Bodies bodies =
      assembler_.bodies_at(island.begin + theta * step.h, island.bodies, phases_at(step, theta));
  return limit_clearances(model_, assembler_.joints_of(island.bodies), bodies.indices, bodies.kinetics,
                          island.contacts);
}

std::optional<ModeChange> ModeChangeSearch::find_limit(const Island& island, const IslandStep& step) const {
  if (!has_limits(model_, assembler_.joints_of(island.bodies))) return std::nullopt;
  constexpr int probes = 8, most_halvings = 40;

  // Each limit by itself, before the first that was found.
  const Remembered<std::vector<double>> known([&](double theta) { return clearances(island, step, theta); });
  const std::vector<double> start = known(0);
  double end = 1;
  std::optional<ModeChange> first;
  for (std::size_t i = 0; i < start.size(); ++i) {
    const auto clearance = [&](double theta) { return known(theta)[i]; };
    // What leaves from a limit, or from a little beyond it, is back when it is as far again.
    double level = std::min(0.0, start[i]);
    const double lowest = level - 0.01 * contact_tolerance_;
    double lo = 0;
    for (int k = 1; k <= probes; ++k) {
      const double probe = end * k / probes;
      if (clearance(probe) >= level) {
        lo = probe;
        continue;
      }
      if (lo == 0) lo = probe;
      for (int halvings = 0; halvings < most_halvings && clearance(lo) <= level; ++halvings) lo *= 0.5;
      if (clearance(lo) <= level) {
        // It never left: it creeps by the uncertainty of the velocities.
        if (clearance(probe) >= lowest) break;
        lo = 0;
        level = lowest;
      }
      const auto above = [&](double theta) { return clearance(theta) - level; };
      if (!falls(above, lo, probe)) break;
      end = find_root_itp(above, lo, probe, time_tolerance_ / step.h).hi;
      first = ModeChange{ModeChange::Kind::overlap, end * step.h};
      break;
    }
  }
  return first;
}

/// Whether the modes can still be, whatever the distribution of redundant forces.
bool ModeChangeSearch::modes_hold(const Island& island, const Instant& instant) const {
  return modes_have_forces(instant.system, island.states, wrenches(island, instant), direction_tolerance_,
                           resting_);
}

std::optional<ModeChange> ModeChangeSearch::find_overlap(const Island& island, const IslandStep& step,
                                                         double end) const {
  const std::optional<double> theta = overlaps_.find(island, step, end);
  if (!theta) return std::nullopt;
  return ModeChange{ModeChange::Kind::overlap, *theta * step.h};
}

std::optional<ModeChange> ModeChangeSearch::find_meeting(const Island& island, const IslandStep& step) const {
  if (!step.is_finite()) return std::nullopt;
  const std::optional<ModeChange> limit = find_limit(island, step);
  const std::optional<ModeChange> overlap = find_overlap(island, step, limit ? limit->h / step.h : 1);
  return overlap ? overlap : limit;
}

bool ModeChangeSearch::may_find(const Island& island) const {
  return !island.contacts.empty() || has_limits(model_, assembler_.joints_of(island.bodies));
}

std::optional<ModeChange> ModeChangeSearch::find(const Island& island, const IslandStep& step) const {
  std::optional<ModeChange> first;
  // A motion that is not finite has no modes: the stepper stops where it begins.
  if (!step.is_finite()) return first;
  if (!may_find(island)) return first;
  const double tolerance = time_tolerance_ / step.h;
  double end = 1;
  const auto shorten = [&](ModeChange::Kind kind, double theta) {
    first = ModeChange{kind, theta * step.h};
    end = theta;
  };

  if (const std::optional<ModeChange> limit = find_limit(island, step)) {
    first = limit;
    end = limit->h / step.h;
  }
  if (island.contacts.empty()) return first;
  // Slip first: beyond the end of a slip its friction has the wrong direction and nothing else counts.
  if (const std::optional<ModeChange> slip = find_slip_end(island, step, end)) {
    first = slip;
    end = slip->h / step.h;
  }
  if (const std::optional<ModeChange> overlap = find_overlap(island, step, end)) {
    first = overlap;
    end = overlap->h / step.h;
  }

  // Forces last: probes at the middle and at the end, then the root between.
  const Remembered<double> force([&](double theta) {
    if (theta == 1 && step.end_forces.size() > 0) return margin_of(island, step.end_forces);
    return force_margin(island, at(island, step, theta));
  });
  const Remembered<double> signature(
      [&](double theta) { return modes_hold(island, at(island, step, theta)) ? 1.0 : -1.0; });
  for (const double probe : {0.5 * end, end}) {
    if (!(force(probe) < 0) || signature(probe) > 0) continue;
    const bool is_bracketed = force(0) > 0;
    if (is_bracketed) {
      shorten(ModeChange::Kind::force_limit, find_root_itp(force, 0, probe, tolerance).hi);
    } else if (signature(0) > 0) {
      shorten(ModeChange::Kind::force_limit, find_root_bisection(signature, 0, probe, tolerance).hi);
    }
    break;
  }
  return first;
}

}  // namespace rigor
