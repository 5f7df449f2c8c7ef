#include "rigor/io/scene/scene_keys.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/model/limits.hpp"
#include "rigor/sim/method/method.hpp"

#include <algorithm>

namespace rigor {

namespace {

Key method_choice_key(const std::string& name) {
  Key key{name, ValueType::choice, "", "-", {}, "see `rigor methods`", method_values(name)};
  key.fallback = method_choice(Method{}, name);
  if (key.choices == std::vector<std::string>{"false", "true"}) {
    key.type = ValueType::flag;
    key.choices.clear();
  }
  return key;
}

Key later(const std::string& name, ValueType type, const std::string& meaning, const std::string& instead) {
  Key key{name, type, "", "-", {}, meaning};
  key.is_available = false;
  key.instead = instead;
  return key;
}

KeyTable method_table() {
  KeyTable table{"method", "method", "", {}};
  for (const std::string& name : method_choice_keys()) table.keys.push_back(method_choice_key(name));
  for (const MethodNumber& number : method_numbers()) {
    table.keys.push_back({std::string(number.key), ValueType::number, std::string(number.unit),
                          std::string(number.fallback), number.range, std::string(number.meaning)});
  }
  return table;
}

KeyTable scene_table() {
  return {
      "scene",
      "a scene",
      "",
      {
          {"rigor", ValueType::whole, "", "required", {1, 1}, "version of the scene format"},
          {"name", ValueType::text, "", "the file's name", {}, "name of the scene"},
          {"world", ValueType::object, "", "-", {}, "gravity", {}, "world"},
          {"run", ValueType::object, "", "-", {}, "duration, step, outputs and seed", {}, "run"},
          {"method", ValueType::object, "", "-", {}, "methods of the simulation", {}, "method"},
          {"materials", ValueType::objects, "", "-", {}, "surfaces and densities, by name", {}, "material"},
          {"pairs", ValueType::objects, "", "-", {}, "coefficients of pairs of materials", {}, "pair"},
          {"bodies", ValueType::objects, "", "required", {}, "the bodies, by name", {}, "body"},
          {"exclude", ValueType::name_pairs, "", "-", {}, "pairs of bodies that pass through each other"},
          {"forces", ValueType::objects, "", "-", {}, "forces besides gravity and contacts", {}, "force"},
          {"joints", ValueType::objects, "", "-", {}, "joints between bodies", {}, "joint"},
          {"expect", ValueType::objects, "", "-", {}, "known places, for `rigor compare`", {}, "expectation"},
          {"study", ValueType::object, "", "-", {}, "what `rigor study` asks of this scene"},
          later("sweep", ValueType::object, "settings of ensembles", "write 'study' with 'kind: sweep'"),
      }};
}

}  // namespace

const Key* KeyTable::find(std::string_view name) const {
  const auto found = std::find_if(keys.begin(), keys.end(), [&](const Key& key) { return key.name == name; });
  return found == keys.end() ? nullptr : &*found;
}

std::vector<std::string> KeyTable::names() const {
  std::vector<std::string> names;
  for (const Key& key : keys) {
    if (key.is_available) names.push_back(key.name);
  }
  return names;
}

namespace {

KeyTable world_table() {
  return {"world",
          "world",
          "",
          {
              {"gravity", ValueType::vector, "m/s²", "[0, 0, -9.80665]", limits::gravity,
               "acceleration of free fall"},
          }};
}

KeyTable run_table() {
  const Range interval = limits::interval;
  return {"run",
          "run",
          "",
          {
              {"duration", ValueType::number, "s", "10", {0, 1e9, true}, "simulated time"},
              {"step", ValueType::number, "s", "0.01", interval, "target step"},
              {"output_interval", ValueType::number, "s", "0.01", interval, "time between outputs"},
              {"seed", ValueType::whole, "", "1", {0, 9007199254740992.0}, "seed of all random numbers"},
          }};
}

KeyTable material_table() {
  return {"material",
          "a material",
          "",
          {
              {"name",
               ValueType::text,
               "",
               "required",
               {},
               "name; `default` applies to shapes without a material"},
              {"density", ValueType::number, "kg/m³", "1000", limits::density, "density"},
              {"friction", ValueType::number, "", "0.5", limits::friction, "Coulomb's coefficient"},
              {"restitution", ValueType::number, "", "0", limits::restitution, "coefficient of restitution"},
              {"tangential_restitution", ValueType::number, "", "0", limits::restitution,
               "restitution of slip in an impact: 1 for a superball, 0 for friction alone"},
              {"rolling_friction", ValueType::number, "m", "0", limits::length,
               "arm of the moment that resists rolling"},
              {"torsional_friction", ValueType::number, "m", "0", limits::length,
               "arm of the moment that resists spinning"},
              {"static_friction", ValueType::number, "", "`friction`", limits::friction,
               "coefficient while sticking, until slip begins; at least `friction`"},
          }};
}

KeyTable pair_table() {
  return {
      "pair",
      "a pair",
      "",
      {
          {"between", ValueType::names, "", "required", {}, "names of the two materials"},
          {"friction", ValueType::number, "", "√(a b)", limits::friction, "instead of the materials'"},
          {"restitution", ValueType::number, "", "max(a, b)", limits::restitution,
           "instead of the materials'"},
          {"tangential_restitution", ValueType::number, "", "max(a, b)", limits::restitution,
           "instead of the materials'"},
          {"rolling_friction", ValueType::number, "m", "√(a b)", limits::length, "instead of the materials'"},
          {"torsional_friction", ValueType::number, "m", "√(a b)", limits::length,
           "instead of the materials'"},
          {"static_friction", ValueType::number, "", "√(a b)", limits::friction,
           "instead of the materials'; equal to `friction` if only that is given"},
      }};
}

KeyTable expectation_table() {
  return {
      "expectation",
      "an expectation",
      "",
      {
          {"body", ValueType::text, "", "required", {}, "name of the body"},
          {"time", ValueType::number, "s", "required", {0, 1e9}, "time of the known pose"},
          {"position", ValueType::vector, "m", "-", limits::position,
           "position of the body's origin at that time"},
          {"orientation", ValueType::quaternion, "", "-", {}, "orientation of the body's frame at that time"},
          {"error", ValueType::number, "m", "0", limits::length, "uncertainty of `position` itself"},
      }};
}

}  // namespace

std::vector<KeyTable> top_key_tables() {
  return {scene_table(),    world_table(), run_table(),        method_table(),
          material_table(), pair_table(),  expectation_table()};
}

const std::vector<KeyTable>& key_tables() {
  static const std::vector<KeyTable> tables = [] {
    std::vector<KeyTable> all;
    for (const auto& part :
         {top_key_tables(), body_key_tables(), shape_key_tables(), force_key_tables(), joint_key_tables()}) {
      all.insert(all.end(), part.begin(), part.end());
    }
    return all;
  }();
  return tables;
}

const KeyTable& key_table(std::string_view object) {
  const std::vector<KeyTable>& tables = key_tables();
  const auto found =
      std::find_if(tables.begin(), tables.end(), [&](const KeyTable& t) { return t.object == object; });
  RIGOR_ASSERT(found != tables.end());
  return *found;
}

std::vector<std::string> types_of(std::string_view family) {
  std::vector<std::string> types;
  for (const KeyTable& table : key_tables()) {
    if (table.family == family) types.push_back(table.object);
  }
  return types;
}

}  // namespace rigor
