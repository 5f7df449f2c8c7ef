#include "rigor/study/plan/parameter_reader.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/core/suggestion.hpp"
#include "rigor/io/files/scalar_text.hpp"
#include "rigor/study/formula/formula.hpp"
#include "rigor/study/plan/study_keys.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

namespace rigor {

namespace {

std::optional<double> number_or_angle(const YamlNode& node) {
  if (node.kind != YamlNode::Kind::scalar || node.is_quoted) return std::nullopt;
  if (const std::optional<double> number = parse_number(node.text).value) return number;
  return parse_angle(node.text);
}

/// The listed values; each is finite.
void read_values(const ObjectReader& reader, Parameter& parameter) {
  parameter.kind = Parameter::Kind::list;
  for (const YamlNode* const node : reader.list("values")) {
    const std::optional<double> value = number_or_angle(*node);
    if (value && std::isfinite(*value)) {
      parameter.values.push_back(*value);
    } else {
      reader.errors().add(
          *node, reader.whose() + ": a value must be a number or an angle, found " + found_text(*node));
    }
  }
  if (parameter.values.empty()) reader.fail("values", "values is empty, it needs at least one");
}

/// The range as an interval, or as `count` values from its lowest to its highest.
void read_interval(const ObjectReader& reader, Parameter& parameter) {
  parameter.kind = Parameter::Kind::interval;
  const std::optional<std::array<double, 2>> range = reader.range("range");
  const std::optional<double> count = reader.number("count");
  parameter.is_logarithmic = reader.flag("log").value_or(false);
  if (!range) return;
  parameter.low = (*range)[0];
  parameter.high = (*range)[1];
  if (!(parameter.low < parameter.high))
    return reader.fail("range", "range is empty: its lowest value must be below its highest");
  if (parameter.is_logarithmic && !(parameter.low > 0))
    return reader.fail("range", "range must be > 0, since it is logarithmic");
  if (!count) return;
  parameter.kind = Parameter::Kind::list;
  parameter.count = static_cast<std::uint64_t>(*count);
}

void read_distribution(const ObjectReader& reader, const std::string& distribution, Parameter& parameter) {
  parameter.mean = reader.number("mean").value_or(0);
  parameter.deviation = reader.number("deviation").value_or(1);
  parameter.low_corner = reader.vector("low").value_or(Vec3(0, 0, 0));
  parameter.high_corner = reader.vector("high").value_or(Vec3(1, 1, 1));
  parameter.center = reader.vector("center").value_or(Vec3(0, 0, 0));
  parameter.radius = reader.number("radius").value_or(1);
  if (distribution == "normal") parameter.kind = Parameter::Kind::normal;
  if (distribution == "lognormal") parameter.kind = Parameter::Kind::lognormal;
  if (distribution == "orientation") parameter.kind = Parameter::Kind::orientation;
  if (distribution == "sphere") parameter.kind = Parameter::Kind::sphere;
  if (distribution != "box") return;
  parameter.kind = Parameter::Kind::box;
  if (!(parameter.low_corner.array() <= parameter.high_corner.array()).all())
    reader.fail("low", "low must not be above high in any coordinate");
}

/// Which keys go with which way to say what a parameter is.
struct ParameterForm {
  const char* key;
  std::vector<std::string> others;
};
const std::vector<ParameterForm>& parameter_forms() {
  static const std::vector<ParameterForm> forms = {
      {"values", {}},
      {"range", {"count", "log", "distribution"}},
      {"distribution", {"range", "log", "mean", "deviation", "low", "high", "center", "radius"}},
      {"formula", {}}};
  return forms;
}

/// Reports keys that do not go with what the parameter is.
void check_form(const ObjectReader& reader, const ParameterForm& form) {
  for (const Key& key : study_key_table("parameter").keys) {
    if (key.name == "name" || key.name == "key" || key.name == "keys" || key.name == form.key) continue;
    const bool goes = std::find(form.others.begin(), form.others.end(), key.name) != form.others.end();
    if (reader.has(key.name) && !goes)
      reader.fail(key.name, key.name + " does not go with " + std::string(form.key));
  }
}

}  // namespace

void check_formula_name(const ObjectReader& object, const std::string& name) {
  const bool has_letters = !name.empty() && std::isalpha(static_cast<unsigned char>(name[0])) &&
                           std::all_of(name.begin(), name.end(), [](char c) {
                             return c == '_' || std::isalnum(static_cast<unsigned char>(c));
                           });
  static const std::set<std::string> taken = {"pi", "t"};
  if (!has_letters || taken.count(name))
    object.fail("name", "the name " + quoted_text(name) +
                            " must be a letter, then letters, digits and _, and neither 't' nor 'pi'");
}

std::vector<std::string> read_texts(const ObjectReader& object, const char* key) {
  const YamlNode* const node = object.find(key);
  if (!node) return {};
  if (node->kind == YamlNode::Kind::scalar) return {node->text};
  std::vector<std::string> texts;
  for (const YamlNode* const entry : object.list(key)) {
    if (entry->kind == YamlNode::Kind::scalar) {
      texts.push_back(entry->text);
    } else {
      object.errors().add(
          *entry, object.whose() + ": " + key + " must be a list of texts, found " + found_text(*entry));
    }
  }
  return texts;
}

void check_formula(const ObjectReader& object, const char* key, const std::string& formula,
                   const std::vector<std::string>& names) {
  try {
    const Formula read(formula);
    for (const std::string& used : read.names()) {
      if (std::find(names.begin(), names.end(), used) == names.end())
        object.fail(key, "formula " + quoted_text(formula) + ": unknown name " + quoted_text(used) +
                             suggestion(used, names));
    }
  } catch (const InputError& error) {
    object.fail(key, error.messages().front());
  }
}

Parameter read_parameter(const YamlNode& node, std::size_t index, SceneErrors& errors) {
  const ObjectReader reader(node, study_key_table("parameter"), whose_text("parameter", node, index), errors);
  Parameter parameter;
  parameter.where = errors.where(node);
  if (const std::optional<std::string> name = reader.text("name")) {
    parameter.name = *name;
    check_formula_name(reader, *name);
  }
  parameter.keys = read_texts(reader, "keys");
  if (const std::optional<std::string> key = reader.text("key")) parameter.keys.push_back(*key);
  const std::string distribution = reader.text("distribution").value_or("");
  if (reader.has("values")) {
    check_form(reader, parameter_forms()[0]);
    read_values(reader, parameter);
  } else if (reader.has("range")) {
    check_form(reader, parameter_forms()[1]);
    if (!distribution.empty() && distribution != "uniform")
      reader.fail("range", "range goes with the distribution uniform only");
    read_interval(reader, parameter);
  } else if (reader.has("formula")) {
    check_form(reader, parameter_forms()[3]);
    parameter.kind = Parameter::Kind::formula;
    parameter.formula = reader.text("formula").value_or("0");
  } else if (reader.has("distribution")) {
    check_form(reader, parameter_forms()[2]);
    if (distribution == "uniform") reader.fail("distribution", "uniform needs a range");
    read_distribution(reader, distribution, parameter);
  } else {
    errors.add(node, reader.whose() + ": it needs one of values, range, distribution and formula");
  }
  return parameter;
}

}  // namespace rigor
