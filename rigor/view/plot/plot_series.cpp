#include "rigor/view/plot/plot_series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace rigor {

namespace {

/// A vector that the trajectory stores for each body.
struct BodyQuantity {
  std::string_view name, unit;
  std::vector<double> StoredTrajectory::*values;
  std::string_view components;
  bool has_length;
};
const std::array<BodyQuantity, 4> body_quantities = {{
    {"position", "m", &StoredTrajectory::position, "xyz", true},
    {"velocity", "m/s", &StoredTrajectory::velocity, "xyz", true},
    {"angular_velocity", "rad/s", &StoredTrajectory::angular_velocity, "xyz", true},
    {"orientation", "1", &StoredTrajectory::orientation, "wxyz", false},
}};

/// A quantity that the trajectory stores for each joint: a number for each coordinate, or a vector.
struct JointQuantity {
  std::string_view name, unit;  ///< For a quantity of coordinates but the effort, the suffix of their unit.
  std::vector<double> StoredTrajectory::*values;
  bool is_vector;
};
const std::array<JointQuantity, 5> joint_quantities = {{
    {"coordinate", "", &StoredTrajectory::joint_coordinate, false},
    {"rate", "/s", &StoredTrajectory::joint_rate, false},
    {"effort", "", &StoredTrajectory::joint_effort, false},
    {"force", "N", &StoredTrajectory::joint_force, true},
    {"torque", "N m", &StoredTrajectory::joint_torque, true},
}};

constexpr std::array<std::string_view, 4> energies = {"kinetic", "potential", "elastic", "total"};
/// Suffixes of the keys of a vector: its length, then its components.
const std::array<std::string, 4> vector_endings = {"", ".x", ".y", ".z"};

PlotSeries energy_series(const Recording& recording, std::size_t which) {
  PlotSeries series{"", "energy", "J", {}};
  const std::vector<double>& energy = recording.motion.energy;
  for (std::size_t row = 0; row + 2 < energy.size(); row += 3)
    series.values.push_back(which < 3 ? energy[row + which]
                                      : energy[row] + energy[row + 1] + energy[row + 2]);
  return series;
}

/// ending: 0 for the length, 1 to 3 for x, y, z.
double component(const Vec3& v, std::size_t ending) {
  return ending == 0 ? v.norm() : v[static_cast<long>(ending) - 1];
}

PlotSeries momentum_series(const Recording& recording, std::size_t ending) {
  PlotSeries series{"", "momentum", "kg m/s", {}};
  const std::size_t n = recording.motion.bodies.size();
  for (std::size_t row = 0; row < recording.frame_count(); ++row) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t body = 0; body < n; ++body)
      sum += recording.model->body(static_cast<int>(body)).mass *
             Vec3::Map(&recording.motion.velocity[3 * (row * n + body)]);
    series.values.push_back(component(sum, ending));
  }
  return series;
}

PlotSeries body_series(const Recording& recording, int body, const BodyQuantity& quantity,
                       std::size_t ending) {
  PlotSeries series{"", std::string(quantity.name), std::string(quantity.unit), {}};
  const std::vector<double>& values = recording.motion.*quantity.values;
  const std::size_t n = recording.motion.bodies.size(), width = quantity.components.size();
  for (std::size_t row = 0; row < recording.frame_count(); ++row) {
    const double* const v = &values[width * (row * n + static_cast<std::size_t>(body))];
    series.values.push_back(quantity.has_length ? component(Vec3::Map(v), ending) : v[ending]);
  }
  return series;
}

std::vector<std::string> endings_of(const BodyQuantity& quantity) {
  std::vector<std::string> endings;
  if (quantity.has_length) endings.push_back("");
  for (const char c : quantity.components) endings.push_back(fmt::format(".{}", c));
  return endings;
}

/// The parts of a key of a body.
struct BodyKey {
  std::string body;
  const BodyQuantity* quantity;
  std::size_t ending;  ///< Of endings_of(quantity).
};
std::optional<BodyKey> parse_body_key(std::string_view key) {
  constexpr std::string_view prefix = "body.";
  if (!key.starts_with(prefix)) return {};
  for (const BodyQuantity& quantity : body_quantities) {
    const std::vector<std::string> endings = endings_of(quantity);
    for (std::size_t i = 0; i < endings.size(); ++i) {
      // Names may contain points, so the quantity is what follows the last ones.
      const std::string tail = fmt::format(".{}{}", quantity.name, endings[i]);
      if (!key.ends_with(tail) || key.size() <= prefix.size() + tail.size()) continue;
      return BodyKey{std::string(key.substr(prefix.size(), key.size() - prefix.size() - tail.size())),
                     &quantity, i};
    }
  }
  return {};
}

std::optional<PlotSeries> find_body_series(const Recording& recording, std::string_view key) {
  const std::optional<BodyKey> parts = parse_body_key(key);
  const std::optional<int> body = parts ? recording.model->find_body(parts->body) : std::nullopt;
  if (!body) return {};
  return body_series(recording, *body, *parts->quantity, parts->ending);
}

/// The parts of a key of a joint.
struct JointKey {
  std::string joint;
  const JointQuantity* quantity;
  std::string ending;  ///< Suffix after the quantity.
};
bool may_end(const JointQuantity& quantity, std::string_view ending) {
  if (quantity.is_vector)
    return std::find(vector_endings.begin(), vector_endings.end(), ending) != vector_endings.end();
  return ending.empty() || (ending[0] == '[' && ending.find('.') == std::string_view::npos);
}
std::optional<JointKey> parse_joint_key(std::string_view key) {
  for (const JointQuantity& quantity : joint_quantities) {
    // Names may contain points, so the last part that fits is the quantity.
    const std::string middle = fmt::format(".{}", quantity.name);
    const std::size_t at = key.rfind(middle);
    if (at == std::string_view::npos || at == 0) continue;
    const std::string_view ending = key.substr(at + middle.size());
    if (!may_end(quantity, ending)) continue;
    return JointKey{std::string(key.substr(0, at)), &quantity, std::string(ending)};
  }
  return {};
}

/// Suffixes of the keys of a joint with this many coordinates: for a vector as vector_endings, else "" or
/// [0], [1], ...; none if the trajectory does not hold the quantity.
std::vector<std::string> endings_of(const Recording& recording, const JointQuantity& quantity,
                                    std::size_t coordinates) {
  if ((recording.motion.*quantity.values).empty()) return {};
  if (quantity.is_vector) return {vector_endings.begin(), vector_endings.end()};
  if (coordinates == 1) return {""};
  std::vector<std::string> endings;
  for (std::size_t k = 0; k < coordinates; ++k) endings.push_back(fmt::format("[{}]", k));
  return endings;
}

/// The k-th coordinate of a joint, its rate, or the effort of its motor.
PlotSeries coordinate_series(const Recording& recording, std::size_t joint, const JointQuantity& quantity,
                             std::size_t k) {
  const StoredTrajectory& motion = recording.motion;
  const std::vector<int>& owners = motion.coordinate_joint;
  const auto first = std::lower_bound(owners.begin(), owners.end(), static_cast<int>(joint));
  const std::size_t column = static_cast<std::size_t>(first - owners.begin()) + k;
  const bool turns = is_angle(recording.model->joint(static_cast<int>(joint)).type, static_cast<int>(k));
  const std::string unit = turns ? "rad" : "m";
  const bool is_effort = quantity.values == &StoredTrajectory::joint_effort;
  PlotSeries series{"",
                    std::string(quantity.name),
                    is_effort ? effort_unit(unit) : fmt::format("{}{}", unit, quantity.unit),
                    {}};
  for (std::size_t row = 0; row < recording.frame_count(); ++row)
    series.values.push_back((motion.*quantity.values)[row * owners.size() + column]);
  return series;
}

PlotSeries joint_vector_series(const Recording& recording, std::size_t joint, const JointQuantity& quantity,
                               std::size_t ending) {
  const StoredTrajectory& motion = recording.motion;
  PlotSeries series{"", std::string(quantity.name), std::string(quantity.unit), {}};
  for (std::size_t row = 0; row < recording.frame_count(); ++row) {
    const double* const v = &(motion.*quantity.values)[3 * (row * motion.joints.size() + joint)];
    series.values.push_back(component(Vec3::Map(v), ending));
  }
  return series;
}

std::optional<PlotSeries> find_joint_series(const Recording& recording, std::string_view key) {
  const std::optional<JointKey> parts = parse_joint_key(key);
  if (!parts) return {};
  const std::vector<std::string>& names = recording.motion.joints;
  const auto found = std::find(names.begin(), names.end(), parts->joint);
  if (found == names.end()) return {};
  const std::size_t joint = static_cast<std::size_t>(found - names.begin());
  const std::size_t coordinates = recording.model->joint(static_cast<int>(joint)).axes.size();
  const std::vector<std::string> endings = endings_of(recording, *parts->quantity, coordinates);
  const auto ending = std::find(endings.begin(), endings.end(), parts->ending);
  if (ending == endings.end()) return {};
  const std::size_t k = static_cast<std::size_t>(ending - endings.begin());
  return parts->quantity->is_vector ? joint_vector_series(recording, joint, *parts->quantity, k)
                                    : coordinate_series(recording, joint, *parts->quantity, k);
}

std::optional<PlotSeries> find_scene_series(const Recording& recording, std::string_view key) {
  for (std::size_t i = 0; i < energies.size(); ++i) {
    if (key == fmt::format("energy.{}", energies[i])) return energy_series(recording, i);
  }
  for (std::size_t i = 0; i < vector_endings.size(); ++i) {
    if (key == fmt::format("momentum{}", vector_endings[i])) return momentum_series(recording, i);
  }
  if (key == "penetration" && !recording.motion.penetration.empty())
    return PlotSeries{"", "penetration", "m", recording.motion.penetration};
  return {};
}

}  // namespace

std::optional<PlotSeries> find_series(const Recording& recording, std::string_view key) {
  std::optional<PlotSeries> series = find_scene_series(recording, key);
  if (!series) series = find_body_series(recording, key);
  if (!series) series = find_joint_series(recording, key);
  if (series) series->key = key;
  return series;
}

std::optional<std::string> body_of_key(std::string_view key) {
  const std::optional<BodyKey> parts = parse_body_key(key);
  if (!parts) return {};
  return parts->body;
}

std::optional<std::string> joint_of_key(std::string_view key) {
  const std::optional<JointKey> parts = parse_joint_key(key);
  if (!parts) return {};
  return parts->joint;
}

std::vector<std::string> plot_keys(const Recording& recording) {
  std::vector<std::string> keys;
  keys.reserve(energies.size() + vector_endings.size());
  for (const std::string_view energy : energies) keys.push_back(fmt::format("energy.{}", energy));
  for (const std::string& ending : vector_endings) keys.push_back(fmt::format("momentum{}", ending));
  if (!recording.motion.penetration.empty()) keys.push_back("penetration");
  for (const std::string& body : recording.motion.bodies) {
    for (const BodyQuantity& quantity : body_quantities) {
      for (const std::string& ending : endings_of(quantity))
        keys.push_back(fmt::format("body.{}.{}{}", body, quantity.name, ending));
    }
  }
  for (std::size_t joint = 0; joint < recording.motion.joints.size(); ++joint) {
    const std::size_t coordinates = recording.model->joint(static_cast<int>(joint)).axes.size();
    for (const JointQuantity& quantity : joint_quantities) {
      for (const std::string& ending : endings_of(recording, quantity, coordinates))
        keys.push_back(fmt::format("{}.{}{}", recording.motion.joints[joint], quantity.name, ending));
    }
  }
  return keys;
}

}  // namespace rigor
