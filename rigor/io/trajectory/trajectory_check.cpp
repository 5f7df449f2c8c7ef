#include "rigor/io/trajectory/trajectory_check.hpp"

#include "rigor/core/index.hpp"
#include "rigor/sim/report/advance_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>

namespace rigor {

namespace {

constexpr double unit_tolerance = 1e-4;  // of |q|², far above what 32 bits round

/// No run writes positions beyond it: distances are computed from squares [m].
constexpr double farthest = 1e150;

/// The first number of a dataset that cannot be, as a text; `width` numbers make a row.
std::string number_error(const char* name, const std::vector<double>& values, std::size_t width,
                         double most = std::numeric_limits<double>::max()) {
  const auto bad = std::find_if_not(values.begin(), values.end(),
                                    [most](double value) { return std::abs(value) <= most; });
  if (bad == values.end()) return {};
  return fmt::format("{} in row {} is {}", name, at(bad - values.begin()) / std::max<std::size_t>(1, width),
                     *bad);
}

std::string motion_error(const StoredTrajectory& stored) {
  const std::size_t n = stored.bodies.size();
  const auto time_goes_back = std::adjacent_find(stored.time.begin(), stored.time.end(), std::greater<>());
  std::string error = number_error("the time", stored.time, 1);
  if (error.empty() && time_goes_back != stored.time.end())
    error = fmt::format("the time goes back after row {}", time_goes_back - stored.time.begin());
  if (error.empty()) error = number_error("a position", stored.position, 3 * n, farthest);
  if (error.empty()) error = number_error("an orientation", stored.orientation, 4 * n);
  if (error.empty()) error = number_error("a velocity", stored.velocity, 3 * n);
  if (error.empty()) error = number_error("an angular velocity", stored.angular_velocity, 3 * n);
  if (error.empty()) error = number_error("an energy", stored.energy, 3);
  const std::size_t coordinates = stored.coordinate_joint.size();
  if (error.empty()) error = number_error("a joint's coordinate", stored.joint_coordinate, coordinates);
  if (error.empty()) error = number_error("a joint's rate", stored.joint_rate, coordinates);
  for (std::size_t i = 0; error.empty() && i < stored.orientation.size(); i += 4) {
    double square = 0;
    for (std::size_t k = 0; k < 4; ++k) square += stored.orientation[i + k] * stored.orientation[i + k];
    if (std::abs(square - 1) > unit_tolerance)
      error = fmt::format("an orientation in row {} is not a unit quaternion", i / (4 * n));
  }
  return error;
}

std::string event_error(const StoredTrajectory& stored) {
  std::string error = number_error("the time of an event", stored.event_time, 1);
  if (error.empty()) error = number_error("the point of an event", stored.event_point, 3);
  if (error.empty()) error = number_error("the impulse of an event", stored.event_impulse, 3);
  if (!error.empty()) return error;
  for (const int kind : stored.event_kind) {
    if (kind < 0 || kind > static_cast<int>(MotionEvent::Kind::slip_to_stick))
      return fmt::format("an event is of kind {}, which there is not", kind);
  }
  for (const int body : stored.event_bodies) {
    if (body < -1 || body >= static_cast<int>(stored.bodies.size()))
      return fmt::format("an event names body {} of {}", body, stored.bodies.size());
  }
  return {};
}

}  // namespace

std::string trajectory_error(const StoredTrajectory& stored) {
  const std::string error = motion_error(stored);
  return error.empty() ? event_error(stored) : error;
}

}  // namespace rigor
