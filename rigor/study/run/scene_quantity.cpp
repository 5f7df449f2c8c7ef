#include "rigor/study/run/scene_quantity.hpp"

#include "rigor/core/index.hpp"
#include "rigor/io/trajectory/trajectory_writer.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/study/run/audit_quantity.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace rigor {

namespace {

using Kind = SceneQuantity::Kind;

struct NamedKind {
  std::string_view name;
  Kind kind;
};
constexpr std::array<NamedKind, 3> vector_kinds = {{{"position", Kind::position},
                                                    {"velocity", Kind::velocity},
                                                    {"angular_velocity", Kind::angular_velocity}}};
constexpr std::array<std::string_view, 4> energy_parts = {"kinetic", "potential", "elastic", "total"};

/// -1 for "", 0 to 2 for ".x" to ".z".
std::optional<int> vector_component(std::string_view ending) {
  if (ending.empty()) return -1;
  if (ending.size() == 2 && ending[0] == '.' && ending[1] >= 'x' && ending[1] <= 'z') return ending[1] - 'x';
  return std::nullopt;
}

std::optional<SceneQuantity> body_quantity(int body, std::string_view rest) {
  if (rest == "tilt") return SceneQuantity{Kind::tilt, body};
  for (const NamedKind& named : vector_kinds) {
    if (!rest.starts_with(named.name)) continue;
    const std::optional<int> component = vector_component(rest.substr(named.name.size()));
    if (component) return SceneQuantity{named.kind, body, *component};
  }
  constexpr std::string_view orientation = "orientation.", letters = "wxyz";
  if (rest.starts_with(orientation) && rest.size() == orientation.size() + 1) {
    const std::size_t component = letters.find(rest.back());
    if (component != std::string_view::npos)
      return SceneQuantity{Kind::orientation, body, static_cast<int>(component)};
  }
  return std::nullopt;
}

/// The body whose name begins the text, with a point behind it, and the rest; names may contain points, so
/// the longest counts.
std::optional<SceneQuantity> of_body(const Model& model, std::string_view text) {
  std::optional<SceneQuantity> best;
  std::size_t length = 0;
  for (int i = 0; i < model.body_count(); ++i) {
    const std::string& name = model.body(i).name;
    if (name.size() < length || !text.starts_with(name) || text.size() <= name.size() ||
        text[name.size()] != '.')
      continue;
    if (const std::optional<SceneQuantity> found = body_quantity(i, text.substr(name.size() + 1)))
      best = found, length = name.size();
  }
  return best;
}

std::optional<SceneQuantity> of_joint(const Model& model, std::string_view text) {
  int first = 0;
  for (std::size_t i = 0; i < model.joints().size(); ++i) {
    const Joint& joint = model.joints()[i];
    const int count = coordinate_count(joint.type);
    for (int k = 0; k < count; ++k) {
      for (const NamedKind named :
           {NamedKind{"coordinate", Kind::coordinate}, NamedKind{"rate", Kind::rate}}) {
        const std::string name = joint.name + "." + std::string(named.name);
        if (text == name + "[" + std::to_string(k) + "]" || (count == 1 && text == name))
          return SceneQuantity{named.kind, first + k};
      }
    }
    first += count;
  }
  return std::nullopt;
}

double part_of(const Vec3& v, int component) {
  return component < 0 ? v.norm() : v[component];
}

/// Pose of the user's frame of a body.
Pose user_pose(const Model& model, const State& state, int body) {
  return Pose{rotation_matrix(state.orientation(body)), state.position(body)} * model.body(body).X_BU;
}

double joint_value(const SceneQuantity& quantity, const Model& model, const State& state) {
  TrajectorySample sample;
  add_joint_motion(model, Method{}, state, sample);
  const std::vector<double>& values =
      quantity.kind == Kind::rate ? sample.joint_rate : sample.joint_coordinate;
  return values.at(at(quantity.index));
}

double energy_part(const Energy& energy, int part) {
  const std::array<double, 4> parts = {energy.kinetic, energy.potential, energy.elastic, energy.total()};
  return parts[at(part)];
}

}  // namespace

std::optional<SceneQuantity> find_quantity(const Model& model, std::string_view name) {
  const auto after = [&](std::string_view prefix) {
    return name.starts_with(prefix) ? std::optional(name.substr(prefix.size())) : std::nullopt;
  };
  if (const auto rest = after("body.")) return of_body(model, *rest);
  if (const auto rest = after("joint.")) return of_joint(model, *rest);
  if (const auto rest = after("energy.")) {
    const auto found = std::find(energy_parts.begin(), energy_parts.end(), *rest);
    if (found != energy_parts.end())
      return SceneQuantity{Kind::energy, static_cast<int>(found - energy_parts.begin())};
  }
  if (const auto rest = after("audit.")) {
    if (has_audit_quantity(model, *rest)) return SceneQuantity{Kind::audit, 0, 0, std::string(*rest)};
  }
  if (const auto rest = after("momentum")) {
    if (const std::optional<int> component = vector_component(*rest))
      return SceneQuantity{Kind::momentum, 0, *component};
  }
  return std::nullopt;
}

std::vector<std::string> quantity_names(const Model& model) {
  std::vector<std::string> names;
  names.reserve(std::size(energy_parts));
  for (const std::string_view part : energy_parts) names.push_back("energy." + std::string(part));
  for (const std::string& part : audit_quantity_names(model)) names.push_back("audit." + part);
  for (const char* const name : {"momentum", "momentum.x", "momentum.y", "momentum.z"})
    names.emplace_back(name);
  for (const Body& body : model.bodies()) {
    const std::string whose = "body." + body.name + ".";
    for (const NamedKind& named : vector_kinds) {
      for (const char* const ending : {"", ".x", ".y", ".z"})
        names.push_back(whose + std::string(named.name) + ending);
    }
    for (const char* const rest :
         {"orientation.w", "orientation.x", "orientation.y", "orientation.z", "tilt"})
      names.push_back(whose + rest);
  }
  for (const Joint& joint : model.joints()) {
    names.push_back("joint." + joint.name + ".coordinate");
    names.push_back("joint." + joint.name + ".rate");
  }
  return names;
}

double quantity_value(const SceneQuantity& quantity, const Model& model, const State& state,
                      const Energy& energy, const Audit* audit) {
  switch (quantity.kind) {
    case Kind::position:
      return part_of(user_pose(model, state, quantity.index).p, quantity.component);
    case Kind::velocity:
      return part_of(linear_velocity(model, state, quantity.index), quantity.component);
    case Kind::angular_velocity:
      return part_of(angular_velocity(model, state, quantity.index), quantity.component);
    case Kind::orientation: {
      const Quat q = quaternion_of(user_pose(model, state, quantity.index).R);
      return std::array<double, 4>{q.w(), q.x(), q.y(), q.z()}[at(quantity.component)];
    }
    case Kind::tilt:
      return std::acos(std::clamp(user_pose(model, state, quantity.index).R(2, 2), -1.0, 1.0));
    case Kind::coordinate:
    case Kind::rate:
      return joint_value(quantity, model, state);
    case Kind::energy:
      return energy_part(energy, quantity.index);
    case Kind::momentum:
      return part_of(total_momentum(model, state).linear, quantity.component);
    case Kind::audit:
      return audit ? audit_quantity(*audit, quantity.path) : std::numeric_limits<double>::quiet_NaN();
  }
  return 0;
}

}  // namespace rigor
