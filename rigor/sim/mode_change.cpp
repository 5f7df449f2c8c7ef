#include "rigor/sim/mode_change.hpp"

#include "rigor/contact/joint_stops.hpp"
#include "rigor/math/roots.hpp"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

namespace rigor {

namespace {

/// Whether the contact is one that the island holds.
bool is_active(const Island& island, const Contact& contact) {
  return std::any_of(island.contacts.begin(), island.contacts.end(), [&](const Contact& other) {
    return other.body_A == contact.body_A && other.body_B == contact.body_B &&
           other.shape_A == contact.shape_A && other.shape_B == contact.shape_B &&
           other.point.feature == contact.point.feature;
  });
}

bool has_limits(const Model& model, const std::vector<int>& joints) {
  return std::any_of(joints.begin(), joints.end(), [&](int joint) {
    const std::vector<JointAxis>& axes = model.joint(joint).axes;
    return std::any_of(axes.begin(), axes.end(), [](const JointAxis& axis) { return axis.is_limited(); });
  });
}

}  // namespace

ModeChangeSearch::ModeChangeSearch(const Model& model, const IslandIntegrator& integrator,
                                   const Method& method)
    : model_(model),
      integrator_(integrator),
      contact_tolerance_(method.contact_tolerance),
      time_tolerance_(method.time_tolerance),
      direction_tolerance_(direction_tolerance(method)),
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
  return {t,
          integrator_.contact_system(island, t, theta == 1 ? std::span<const BodyPhase>(step.end) : phases)};
}

std::vector<Wrench> ModeChangeSearch::wrenches(const Island& island, const Instant& instant) const {
  return integrator_.with_moments(instant.system, island.states,
                                  integrator_.environment_wrenches(instant.system, instant.t));
}

/// Smallest speed along its slip of the sliding contacts; below zero one of them has stopped.
double ModeChangeSearch::slip_margin(const Island& island, const Instant& instant) const {
  double margin = std::numeric_limits<double>::infinity();
  const VecX u = relative_velocities(instant.system);
  for (std::size_t i = 0; i < island.states.size(); ++i) {
    if (island.states[i].mode != ContactMode::slide || island.states[i].slip_W.isZero(0)) continue;
    const Vec3 slip = instant.system.frames[i].transpose() * island.states[i].slip_W;
    const Vec2 direction = slip.head<2>();
    if (direction.isZero(0)) continue;
    margin = std::min(margin, u.segment<2>(3 * static_cast<Eigen::Index>(i)).dot(direction));
  }
  return margin;
}

/// Smallest of λ_n (active contacts) and μ λ_n - |λ_t| (sticking ones), relative to the largest force; a
/// little below zero is allowed for rounding.
double ModeChangeSearch::force_margin(const Island& island, const Instant& instant) const {
  constexpr double rounding = 1e-10;
  const VecX lambda = contact_forces(instant.system, island.states, wrenches(island, instant),
                                     direction_tolerance_, resting_);
  const double scale = lambda.cwiseAbs().maxCoeff();
  if (scale == 0) return rounding;
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

/// Least gap of the pairs in contact, above what is allowed: at active contacts half the tolerance, for
/// errors of the step; elsewhere `allowance` [m].
double ModeChangeSearch::overlap_margin(const Island& island, const Instant& instant,
                                        double allowance) const {
  double margin = std::numeric_limits<double>::infinity();
  std::set<std::pair<int, int>> pairs;
  for (const Contact& contact : island.contacts) {
    if (!contact.stop) pairs.insert({contact.body_A, contact.body_B});
  }
  for (const auto& [a, b] : pairs) {
    for (const Contact& contact : find_contacts(model_, a, b, instant.system.of(a).pose(),
                                                instant.system.of(b).pose(), contact_tolerance_)) {
      const double allowed = is_active(island, contact) ? 0.5 * contact_tolerance_ : allowance;
      margin = std::min(margin, contact.point.gap + allowed);
    }
  }
  return margin;
}

std::vector<double> ModeChangeSearch::clearances(const Island& island, const Instant& instant) const {
  return limit_clearances(model_, integrator_.joints_of(island.bodies), instant.system.bodies,
                          instant.system.kinetics, island.contacts);
}

std::optional<ModeChange> ModeChangeSearch::find_limit(const Island& island, const IslandStep& step) const {
  if (!has_limits(model_, integrator_.joints_of(island.bodies))) return std::nullopt;
  constexpr int probes = 8, most_halvings = 40;
  const std::vector<double> start = clearances(island, at(island, step, 0));
  double end = 1;
  std::optional<ModeChange> first;
  for (std::size_t i = 0; i < start.size(); ++i) {
    const auto clearance = [&](double theta) { return clearances(island, at(island, step, theta))[i]; };
    // What is at a limit or a little beyond it as it leaves has come back when it is as far again.
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
        // It never left: it creeps on by what the velocities are uncertain.
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
  // Further points of the bodies land where they touch; what overlaps a little from the start, where it comes
  // back to that.
  const double more = 0.01 * contact_tolerance_, most = 0.5 * contact_tolerance_;
  double allowance = more;
  const auto overlap = [&](double theta) {
    return overlap_margin(island, at(island, step, theta), allowance);
  };
  const double margin = overlap(0);
  const bool overlaps = margin <= 0;
  if (overlaps) allowance -= margin;
  if (allowance > most) return std::nullopt;
  for (const double probe : {0.5 * end, end}) {
    if (overlap(probe) >= 0) continue;
    double lo = 0;
    if (overlaps) {
      constexpr int most_halvings = 12;
      lo = 0.5 * probe;
      for (int k = 1; k < most_halvings && overlap(lo) <= 0; ++k) lo *= 0.5;
      if (overlap(lo) <= 0) {
        // It never left.
        lo = 0;
        allowance = std::min(allowance + more, most);
        if (overlap(probe) >= 0) continue;
      }
    }
    const RootBracket root = find_root_bisection(overlap, lo, probe, time_tolerance_ / step.h);
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
  if (island.contacts.empty() && !has_limits(model_, integrator_.joints_of(island.bodies))) return first;
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
  const auto slip = [&](double theta) { return slip_margin(island, at(island, step, theta)); };
  if (slip(end) < 0 && slip(0) > 0) {
    const RootBracket root = find_root_itp(slip, 0, end, tolerance);
    shorten(ModeChange::Kind::slip_ends, root.hi);
    first->slip_speed = std::max(0.0, std::max(root.f_lo, -root.f_hi));
  }
  if (const std::optional<ModeChange> overlap = find_overlap(island, step, end)) {
    first = overlap;
    end = overlap->h / step.h;
  }
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
