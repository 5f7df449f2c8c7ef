#include "rigor/study/plan/outcome_reader.hpp"

#include "rigor/core/input_error.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/core/suggestion.hpp"
#include "rigor/study/formula/formula.hpp"
#include "rigor/study/plan/parameter_reader.hpp"
#include "rigor/study/plan/study_keys.hpp"

#include <algorithm>
#include <limits>

namespace rigor {

namespace {

/// A way to say what an outcome is, with the keys that go with it.
struct OutcomeForm {
  const char* key;
  Outcome::Kind kind;
  std::vector<std::string> others;
};
const std::vector<OutcomeForm>& outcome_forms() {
  static const std::vector<OutcomeForm> forms = {
      {"value", Outcome::Kind::value, {"at", "when", "event", "bodies", "number", "else"}},
      {"min", Outcome::Kind::smallest, {}},
      {"max", Outcome::Kind::largest, {}},
      {"first", Outcome::Kind::first, {"else"}},
      {"count", Outcome::Kind::count, {"bodies"}},
      {"time_of", Outcome::Kind::time_of, {"bodies", "number", "else"}},
      {"impulse", Outcome::Kind::impulse, {"bodies"}},
      {"face", Outcome::Kind::face, {}},
      {"cpu_time", Outcome::Kind::cpu_time, {}},
      {"formula", Outcome::Kind::formula, {"else"}},
  };
  return forms;
}

const OutcomeForm* find_form(const ObjectReader& reader) {
  for (const OutcomeForm& form : outcome_forms()) {
    if (reader.has(form.key)) return &form;
  }
  std::vector<std::string> keys;
  for (const OutcomeForm& form : outcome_forms()) keys.emplace_back(form.key);
  reader.errors().add(reader.node(), reader.whose() + ": it does not say what it is" + suggestion("", keys));
  return nullptr;
}

void check_form_keys(const ObjectReader& reader, const OutcomeForm& form) {
  for (const Key& key : study_key_table("outcome").keys) {
    if (key.name == "name" || key.name == form.key || !reader.has(key.name)) continue;
    if (std::find(form.others.begin(), form.others.end(), key.name) == form.others.end())
      reader.fail(key.name, key.name + " does not go with " + std::string(form.key));
  }
}

/// A formula of quantities of the scene: names with a point are quantities, which are checked later.
std::string scene_formula(const ObjectReader& reader, const char* key, std::vector<std::string> names) {
  const YamlNode* const node = reader.find(key);
  if (!node) return {};
  // A number is a formula too.
  std::string text = node->kind == YamlNode::Kind::scalar ? node->text : reader.text(key).value_or("0");
  try {
    const Formula formula(text);
    for (const std::string& used : formula.names()) {
      if (used.find('.') != std::string::npos) names.push_back(used);
    }
  } catch (const InputError&) {
    // check_formula reports it.
  }
  names.emplace_back("t");
  check_formula(reader, key, text, names);
  return text;
}

void read_event(const ObjectReader& reader, const char* key, Outcome& outcome) {
  outcome.event.kind = outcome.kind == Outcome::Kind::impulse ? "impact" : reader.text(key).value_or("");
  outcome.event.bodies = read_texts(reader, "bodies");
  if (outcome.event.bodies.size() > 2) reader.fail("bodies", "bodies must be one or two names");
}

}  // namespace

Outcome read_outcome(const YamlNode& node, std::size_t index, const std::vector<std::string>& names,
                     SceneErrors& errors) {
  const ObjectReader reader(node, study_key_table("outcome"), whose_text("outcome", node, index), errors);
  Outcome outcome;
  outcome.where = errors.where(node);
  if (const std::optional<std::string> name = reader.text("name")) {
    outcome.name = *name;
    check_formula_name(reader, *name);
  }
  const OutcomeForm* const form = find_form(reader);
  if (!form) return outcome;
  check_form_keys(reader, *form);
  outcome.kind = form->kind;
  outcome.at = reader.number("at");
  outcome.otherwise = reader.number("else");
  outcome.number = static_cast<int>(reader.number("number").value_or(1));
  outcome.when = scene_formula(reader, "when", names);
  const int instants = (outcome.at ? 1 : 0) + (outcome.when.empty() ? 0 : 1) + (reader.has("event") ? 1 : 0);
  if (instants > 1)
    reader.fail(reader.has("event") ? "event" : "when", "only one of 'at', 'when' and 'event' may be given");
  if (form->kind == Outcome::Kind::value && reader.has("event")) read_event(reader, "event", outcome);
  for (const char* const key : {"bodies", "number"}) {
    if (form->kind == Outcome::Kind::value && reader.has(key) && !reader.has("event"))
      reader.fail(key, std::string(key) + " goes with an event");
  }
  switch (outcome.kind) {
    case Outcome::Kind::value:
    case Outcome::Kind::smallest:
    case Outcome::Kind::largest:
    case Outcome::Kind::first:
      outcome.formula = scene_formula(reader, form->key, names);
      break;
    case Outcome::Kind::count:
    case Outcome::Kind::time_of:
    case Outcome::Kind::impulse:
      read_event(reader, form->key, outcome);
      break;
    case Outcome::Kind::face:
      outcome.body = reader.text("face").value_or("");
      break;
    case Outcome::Kind::cpu_time:
      if (!reader.flag("cpu_time").value_or(false)) reader.fail("cpu_time", "cpu_time must be true");
      break;
    case Outcome::Kind::formula:
      outcome.formula = reader.find("formula")->text;
      check_formula(reader, "formula", outcome.formula, names);
      break;
  }
  return outcome;
}

}  // namespace rigor
