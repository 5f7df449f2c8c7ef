#pragma once

#include <algorithm>
#include <cstddef>

namespace rigor {

/// Speeds below this are rounding: what moves more slowly stands still [m/s].
inline double still_speed(double resting_velocity) {
  return 1e-6 * resting_velocity;
}

/// Contacts that part faster than this carry no force, the others last [m/s].
inline double parting_speed(double resting_velocity) {
  return 1e-3 * resting_velocity;
}

/// Drift of joints [m or rad] that projections of the positions leave in a scene of this length [m].
inline double projected_joint_drift(double length_scale) {
  return 1e-9 * std::max(1.0, length_scale);
}

/// Friction of at least this share of its limit slides: what is closer to the limit is rounding.
inline constexpr double sliding_share = 1 - 1e-9;

/// Sub-steps shorter than this share of the step that they are part of are none.
inline constexpr double least_step_share = 1e-9;

/// The problem of rest is dense: groups of more contacts are not solved for, since it would take a minute.
inline constexpr std::size_t most_contacts_at_rest = 400;

}  // namespace rigor
