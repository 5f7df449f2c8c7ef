#include "rigor/io/scene/time_function_reader.hpp"

#include "rigor/core/input_error.hpp"
#include "rigor/io/files/scalar_text.hpp"
#include "rigor/io/scene/scene_reader.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

namespace rigor {

namespace {

FormulaReader& formula_reader() {
  static FormulaReader reader;
  return reader;
}

std::optional<TimeFunction> read_formula(const ObjectReader& object, std::string_view key,
                                         const std::string& text) {
  if (!formula_reader()) {
    object.fail(key,
                fmt::format("{} is a formula, which this program does not read; write a sine or a table, or "
                            "give a reader of formulas (use_formula_reader)",
                            key));
    return std::nullopt;
  }
  try {
    return formula_reader()(text);
  } catch (const InputError& error) {
    object.fail(key, fmt::format("{}: {}", key, error.messages().front()));
    return std::nullopt;
  }
}

std::optional<TimeFunction> read_table(const ObjectReader& function, const YamlNode& node) {
  for (const char* const other : {"amplitude", "frequency", "phase", "mean"}) {
    if (!function.has(other)) continue;
    function.fail(other, fmt::format("{} is of a sine, but there is a table: give one of them", other));
    return std::nullopt;
  }
  TimeFunction::Table table;
  for (const std::vector<double>& row : function.rows("table")) {
    if (row.size() != 2) {
      function.errors().add(
          node, fmt::format("{}: a row of the table has {} numbers, must have 2: a time and a value",
                            function.whose(), row.size()));
      return std::nullopt;
    }
    table.points.push_back({row[0], row[1]});
  }
  if (table.points.empty()) return std::nullopt;
  return TimeFunction(std::move(table));
}

std::optional<TimeFunction> read_sine(const ObjectReader& function) {
  for (const char* const needed : {"amplitude", "frequency"}) {
    if (function.has(needed)) continue;
    function.fail(
        needed, fmt::format("{} is missing: a sine has amplitude and frequency; else give a table", needed));
    return std::nullopt;
  }
  const std::size_t errors_before = function.errors().count();
  const TimeFunction::Sine sine{function.number("mean").value_or(0), function.number("amplitude").value_or(0),
                                function.number("frequency").value_or(0),
                                function.number("phase").value_or(0)};
  if (function.errors().count() > errors_before) return std::nullopt;
  return TimeFunction(sine);
}

}  // namespace

void use_formula_reader(FormulaReader reader) {
  formula_reader() = std::move(reader);
}

std::optional<TimeFunction> read_time_function(const ObjectReader& object, std::string_view key) {
  const YamlNode* const node = object.find(key);
  if (!node) return std::nullopt;
  if (node->kind == YamlNode::Kind::map) {
    const ObjectReader function(*node, key_table("function"), fmt::format("{} of {}", key, object.whose()),
                                object.errors());
    return function.has("table") ? read_table(function, *node) : read_sine(function);
  }
  if (node->kind == YamlNode::Kind::scalar && is_text(*node)) {
    if (const std::optional<double> angle = parse_angle(node->text)) return TimeFunction(*angle);
    return read_formula(object, key, node->text);
  }
  const std::optional<double> number = object.number(key);
  if (!number) return std::nullopt;
  return TimeFunction(*number);
}

}  // namespace rigor
