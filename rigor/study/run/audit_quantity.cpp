#include "rigor/study/run/audit_quantity.hpp"

#include "rigor/io/trajectory/audit_tree.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>

namespace rigor {

namespace {

using Json = nlohmann::ordered_json;

/// Not known where the audit does not know the work: it balances no energy then.
double if_balanced(const Audit& audit, double value) {
  return audit.knows_work ? value : std::numeric_limits<double>::quiet_NaN();
}

struct ShortName {
  std::string_view name;
  double (*value)(const Audit& audit);
};
constexpr std::array<ShortName, 17> short_names = {{
    {"impacts", [](const Audit& a) { return static_cast<double>(a.report.impacts); }},
    {"resting", [](const Audit& a) { return static_cast<double>(a.report.resting); }},
    {"separations", [](const Audit& a) { return static_cast<double>(a.report.separations); }},
    {"slip_to_stick", [](const Audit& a) { return static_cast<double>(a.report.slip_to_stick); }},
    {"steps", [](const Audit& a) { return static_cast<double>(a.report.steps); }},
    {"dissipated", [](const Audit& a) { return if_balanced(a, a.dissipated); }},
    {"max_increase", [](const Audit& a) { return if_balanced(a, a.max_increase); }},
    {"work", [](const Audit& a) { return if_balanced(a, a.report.work); }},
    {"impact_loss", [](const Audit& a) { return a.report.impact_loss; }},
    {"impact_gain", [](const Audit& a) { return a.report.impact_gain; }},
    {"friction_loss", [](const Audit& a) { return a.report.friction_loss; }},
    {"momentum_error", [](const Audit& a) { return a.linear_momentum_error; }},
    {"angular_momentum_error", [](const Audit& a) { return a.angular_momentum_error; }},
    {"penetration", [](const Audit& a) { return a.report.max_penetration; }},
    {"joint_drift", [](const Audit& a) { return a.report.max_joint_drift; }},
    {"violations", [](const Audit& a) { return static_cast<double>(a.violations.size()); }},
    {"end_time", [](const Audit& a) { return a.end_time; }},
}};

const ShortName* find_short(std::string_view name) {
  const auto found = std::ranges::find(short_names, name, &ShortName::name);
  return found == short_names.end() ? nullptr : &*found;
}

/// Numbers, what is true or not, and what is not known.
bool is_quantity(const Json& json) {
  return json.is_number() || json.is_boolean() || json.is_null();
}

const Json* find_path(const Json& json, std::string_view path) {
  if (path.empty()) return is_quantity(json) ? &json : nullptr;
  if (json.is_array()) {
    const std::size_t end = std::min(path.find('.'), path.size());
    std::size_t index = 0;
    const auto [rest, error] = std::from_chars(path.data(), path.data() + end, index);
    if (error != std::errc() || rest != path.data() + end || index >= json.size()) return nullptr;
    return find_path(json[index], path.substr(std::min(end + 1, path.size())));
  }
  if (!json.is_object()) return nullptr;
  // Names of bodies and joints may have points.
  for (const auto& [key, value] : json.items()) {
    if (!path.starts_with(key) || (path.size() > key.size() && path[key.size()] != '.')) continue;
    if (const Json* const found = find_path(value, path.substr(std::min(key.size() + 1, path.size()))))
      return found;
  }
  return nullptr;
}

void add_paths(const Json& json, const std::string& path, std::vector<std::string>& paths) {
  const std::string before = path.empty() ? path : path + ".";
  if (json.is_object()) {
    for (const auto& [key, value] : json.items()) add_paths(value, before + key, paths);
  } else if (json.is_array()) {
    for (std::size_t i = 0; i < json.size(); ++i) add_paths(json[i], before + std::to_string(i), paths);
  } else if (is_quantity(json)) {
    paths.push_back(path);
  }
}

/// The audit of nothing: its keys are those of every run of the model, but for parts that `auto` hands over.
Json empty_audit(const Model& model) {
  const std::shared_ptr<const Model> own(&model, [](const Model*) {});
  ResolvedMethod choice{Method{}, {}};
  choice.method.scheme = Scheme::event_driven;
  choice.method.sleeping = true;
  const State start = make_initial_state(model);
  return audit_tree(Auditor(own, choice, start).audit(start));
}

}  // namespace

bool has_audit_quantity(const Model& model, std::string_view name) {
  return find_short(name) || (!name.empty() && find_path(empty_audit(model), name));
}

std::vector<std::string> audit_quantity_names(const Model& model) {
  std::vector<std::string> names;
  names.reserve(std::size(short_names));
  for (const ShortName& own : short_names) names.emplace_back(own.name);
  add_paths(empty_audit(model), "", names);
  return names;
}

double audit_quantity(const Audit& audit, std::string_view name) {
  if (const ShortName* const own = find_short(name)) return own->value(audit);
  const Json tree = audit_tree(audit);
  const Json* const found = find_path(tree, name);
  if (!found || found->is_null()) return std::numeric_limits<double>::quiet_NaN();
  return found->is_boolean() ? static_cast<double>(found->get<bool>()) : found->get<double>();
}

}  // namespace rigor
