#include "rigor/io/scene/method_reader.hpp"

#include "rigor/io/files/scalar_text.hpp"

#include <string>

namespace rigor {

namespace {

/// Largest number of outputs of a run: more would fill any disk.
constexpr double most_outputs = 1e8;

}  // namespace

RunSettings read_run(const ObjectReader& scene) {
  RunSettings run;
  if (!scene.has("run")) return run;
  const ObjectReader reader(*scene.find("run"), key_table("run"), "run", scene.errors());
  run.duration = reader.number("duration").value_or(run.duration);
  run.step = reader.number("step").value_or(run.step);
  run.output_interval = reader.number("output_interval").value_or(run.output_interval);
  run.seed = static_cast<std::uint64_t>(reader.number("seed").value_or(static_cast<double>(run.seed)));
  const double outputs = run.duration / run.output_interval;
  if (outputs > most_outputs) {
    reader.fail("output_interval", "duration / output_interval gives " + number_text(outputs) +
                                       " outputs, must be at most " + number_text(most_outputs));
  }
  return run;
}

Method read_method(const ObjectReader& scene) {
  Method method;
  if (!scene.has("method")) return method;
  const ObjectReader reader(*scene.find("method"), key_table("method"), "method", scene.errors());
  for (const std::string& key : method_choice_keys()) {
    const YamlNode* const value = reader.find(key);
    if (!value) continue;
    if (value->kind != YamlNode::Kind::scalar) {
      reader.fail(key, key + " must be a text, found " + found_text(*value));
      continue;
    }
    const std::string error = set_method_choice(key, value->text, method);
    if (!error.empty()) reader.fail(key, error);
  }
  for (const MethodNumber& number : method_numbers()) {
    method.*number.member = reader.number(number.key).value_or(method.*number.member);
  }
  for (const std::string& message : check_combination(method)) reader.fail("integrator", message);
  return method;
}

}  // namespace rigor
