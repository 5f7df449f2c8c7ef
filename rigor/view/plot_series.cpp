#include "rigor/view/plot_series.hpp"

#include <fmt/format.h>

#include <array>

namespace rigor {

namespace {

/// A vector of each body that the trajectory stores.
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

constexpr std::array<std::string_view, 4> energies = {"kinetic", "potential", "elastic", "total"};
/// Ending of a vector's keys: its length, then its components.
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

/// A key of a body, taken apart.
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
      // Names may have points: the quantity is what stands at the end.
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
  if (series) series->key = key;
  return series;
}

std::optional<std::string> body_of_key(std::string_view key) {
  const std::optional<BodyKey> parts = parse_body_key(key);
  if (!parts) return {};
  return parts->body;
}

std::vector<std::string> plot_keys(const Recording& recording) {
  std::vector<std::string> keys;
  for (const std::string_view energy : energies) keys.push_back(fmt::format("energy.{}", energy));
  for (const std::string& ending : vector_endings) keys.push_back(fmt::format("momentum{}", ending));
  if (!recording.motion.penetration.empty()) keys.push_back("penetration");
  for (const std::string& body : recording.motion.bodies) {
    for (const BodyQuantity& quantity : body_quantities) {
      for (const std::string& ending : endings_of(quantity))
        keys.push_back(fmt::format("body.{}.{}{}", body, quantity.name, ending));
    }
  }
  return keys;
}

}  // namespace rigor
