#include "rigor/sim/islands/mode_change.hpp"

#include "rigor/contact/impact/joint_stops.hpp"
#include "rigor/contact/resting/rolling_friction.hpp"
#include "rigor/math/roots.hpp"
#include "rigor/sim/method/resting_choice.hpp"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

namespace rigor {

namespace {

bool is_among(const Contact& contact, const std::vector<Contact>& others) {
  return std::any_of(others.begin(), others.end(),
                     [&](const Contact& other) { return other.key() == contact.key(); });
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
      contact_tolerance_(method.contact_tolerance),
      time_tolerance_(method.time_tolerance),
      slip_tolerance_(slip_tolerance(method)),
      direction_tolerance_(direction_tolerance(method)),
      resting_velocity_(method.resting_velocity),
      resting_(resting_choice(method)) {}

/// The island somewhere in its step.
struct ModeChangeSearch::Instant {
  double t;
  ContactSystem system;
};

ModeChangeSearch::Instant ModeChangeSearch::at(const Island& island, const IslandStep& step,
                                               double theta) const {
  std::vector<BodyPhase> phases;
  for (const DensePhase& dense : step.dense) phases.push_back(dense.at(theta));
  const double t = island.begin + theta * step.h;
  return {t, assembler_.assemble(island, t, theta == 1 ? std::span<const BodyPhase>(step.end) : phases)};
}

std::vector<Wrench> ModeChangeSearch::wrenches(const Island& island, const Instant& instant) const {
  return with_rolling_friction(instant.system, island.states,
                               assembler_.environment_wrenches(instant.system, instant.t),
                               direction_tolerance_, resting_velocity_);
}

/// Speed along its slip of each sliding contact; infinite for the others.
std::vector<double> ModeChangeSearch::slip_speeds(const Island& island, const Instant& instant) const {
  std::vector<double> speeds(island.states.size(), std::numeric_limits<double>::infinity());
  const VecX u = relative_velocities(instant.system);
  for (std::size_t i = 0; i < island.states.size(); ++i) {
    if (island.states[i].mode != ContactMode::slide || island.states[i].slip_W.isZero(0)) continue;
    const Vec3 slip = instant.system.frames[i].transpose() * island.states[i].slip_W;
    const Vec2 direction = slip.head<2>();
    if (direction.isZero(0)) continue;
    speeds[i] = u.segment<2>(3 * static_cast<Eigen::Index>(i)).dot(direction);
  }
  return speeds;
}

std::optional<ModeChange> ModeChangeSearch::find_slip_end(const Island& island, const IslandStep& step,
                                                          double end) const {
  // Slip that begins from rest may creep back by the uncertainty of the velocities, and no more.
  std::vector<double> levels = slip_speeds(island, at(island, step, 0));
  double uncertainty = 0;
  for (double& level : levels) {
    level = level > 0 ? 0 : 2 * level - slip_tolerance_;
    uncertainty = std::max(uncertainty, -level);
  }

  // The first time at which one of them falls below its level.
  const auto margin = [&](double theta) {
    const std::vector<double> speeds = slip_speeds(island, at(island, step, theta));
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < speeds.size(); ++i) least = std::min(least, speeds[i] - levels[i]);
    return least;
  };
  if (margin(end) >= 0) return std::nullopt;
  const RootBracket root = find_root_itp(margin, 0, end, time_tolerance_ / step.h);
  return ModeChange{ModeChange::Kind::slip_ends, root.hi * step.h,
                    std::max({0.0, root.f_lo, -root.f_hi}) + uncertainty};
}

/// Smallest of λ_n (active contacts) and μ λ_n - |λ_t| (sticking ones), relative to the largest force; a
/// little below zero is allowed for rounding.
double ModeChangeSearch::force_margin(const Island& island, const Instant& instant) const {
  constexpr double rounding = 1e-10;

  // The contact forces there, relative to the largest.
  const VecX lambda = contact_forces(instant.system, island.states, wrenches(island, instant),
                                     direction_tolerance_, resting_);
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

/// All contacts of the pairs in contact.
std::vector<Contact> ModeChangeSearch::contacts_of_pairs(const Island& island, const Instant& instant) const {
  std::set<std::pair<int, int>> pairs;
  for (const Contact& contact : island.contacts) {
    if (!contact.stop) pairs.insert({contact.body_A, contact.body_B});
  }
  std::vector<Contact> contacts;
  for (const auto& [a, b] : pairs) {
    const std::vector<Contact> found = find_contacts(model_, a, b, instant.system.of(a).pose(),
                                                     instant.system.of(b).pose(), contact_tolerance_);
    contacts.insert(contacts.end(), found.begin(), found.end());
  }
  return contacts;
}

/// Least gap of the pairs in contact, above the lowest that each may have [m]: at active contacts half the
/// tolerance below zero, for errors of the step. Further points land a little below zero; where one is there
/// as the step begins, it has come back when it is as low again.
double ModeChangeSearch::overlap_margin(const Island& island, const Instant& instant,
                                        const std::vector<Contact>& at_start) const {
  const double landing = -0.01 * contact_tolerance_, rounding = 1e-5 * contact_tolerance_;
  double margin = std::numeric_limits<double>::infinity();
  for (const Contact& contact : contacts_of_pairs(island, instant)) {
    double lowest = is_among(contact, island.contacts) ? -0.5 * contact_tolerance_ : landing;
    const auto before = std::find_if(at_start.begin(), at_start.end(),
                                     [&](const Contact& other) { return other.key() == contact.key(); });
    if (before != at_start.end()) lowest = std::min(lowest, before->point.gap - rounding);
    margin = std::min(margin, contact.point.gap - lowest);
  }
  return margin;
}

std::vector<double> ModeChangeSearch::clearances(const Island& island, const Instant& instant) const {
  return limit_clearances(model_, assembler_.joints_of(island.bodies), instant.system.bodies,
                          instant.system.kinetics, island.contacts);
}

std::optional<ModeChange> ModeChangeSearch::find_limit(const Island& island, const IslandStep& step) const {
  if (!has_limits(model_, assembler_.joints_of(island.bodies))) return std::nullopt;
  constexpr int probes = 8, most_halvings = 40;

  // Each limit by itself, before the first that was found.
  const std::vector<double> start = clearances(island, at(island, step, 0));
  double end = 1;
  std::optional<ModeChange> first;
  for (std::size_t i = 0; i < start.size(); ++i) {
    const auto clearance = [&](double theta) { return clearances(island, at(island, step, theta))[i]; };
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
  const std::vector<Contact> at_start = contacts_of_pairs(island, at(island, step, 0));
  const auto overlap = [&](double theta) {
    return overlap_margin(island, at(island, step, theta), at_start);
  };
  for (const double probe : {0.5 * end, end}) {
    if (overlap(probe) >= 0) continue;
    const RootBracket root = find_root_bisection(overlap, 0, probe, time_tolerance_ / step.h);
    return ModeChange{ModeChange::Kind::overlap, root.hi * step.h};
  }
  return std::nullopt;
}

std::optional<ModeChange> ModeChangeSearch::find_meeting(const Island& island, const IslandStep& step) const {
  const std::optional<ModeChange> limit = find_limit(island, step);
  const std::optional<ModeChange> overlap = find_overlap(island, step, limit ? limit->h / step.h : 1);
  return overlap ? overlap : limit;
}

std::optional<ModeChange> ModeChangeSearch::find(const Island& island, const IslandStep& step) const {
  std::optional<ModeChange> first;
  // Where the step has no end there is nothing to search; the stepper says so.
  const auto is_finite = [](const BodyPhase& phase) {
    return phase.x.allFinite() && phase.q.coeffs().allFinite() && phase.P.allFinite() && phase.L.allFinite();
  };
  if (!std::all_of(step.end.begin(), step.end.end(), is_finite)) return first;
  if (island.contacts.empty() && !has_limits(model_, assembler_.joints_of(island.bodies))) return first;
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
  const auto force = [&](double theta) { return force_margin(island, at(island, step, theta)); };
  const auto signature = [&](double theta) {
    return modes_hold(island, at(island, step, theta)) ? 1.0 : -1.0;
  };
  for (const double probe : {0.5 * end, end}) {
    if (force(probe) >= 0 || signature(probe) > 0) continue;
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
