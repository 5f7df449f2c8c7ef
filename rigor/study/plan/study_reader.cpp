#include "rigor/study/plan/study_reader.hpp"

#include "rigor/core/input_error.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/core/suggestion.hpp"
#include "rigor/io/files/scalar_text.hpp"
#include "rigor/io/files/text_file.hpp"
#include "rigor/study/formula/formula.hpp"
#include "rigor/study/plan/outcome_reader.hpp"
#include "rigor/study/plan/parameter_reader.hpp"
#include "rigor/study/plan/study_keys.hpp"
#include "rigor/study/sampling/even_points.hpp"

#include <algorithm>

namespace rigor {

namespace {

/// Index of a text in the list of the choices of an enumeration.
template <typename Enum>
Enum choice_of(const std::vector<std::string>& names, const std::optional<std::string>& text, Enum fallback) {
  if (!text) return fallback;
  return static_cast<Enum>(std::find(names.begin(), names.end(), *text) - names.begin());
}

std::vector<std::string> parameter_names(const StudyPlan& plan) {
  std::vector<std::string> names;
  for (const Parameter& parameter : plan.parameters) names.push_back(parameter.name);
  return names;
}

void read_parameters(const ObjectReader& reader, StudyPlan& plan) {
  std::size_t index = 0;
  for (const YamlNode* const node : reader.list("parameters")) {
    if (reader.errors().is_full()) return;
    Parameter parameter = read_parameter(*node, index++, reader.errors());
    const std::vector<std::string> above = plan.columns(), names = parameter_names(plan);
    const std::string whose = "parameter " + quoted_text(parameter.name);
    if (std::find(names.begin(), names.end(), parameter.name) != names.end())
      reader.errors().add(*node, whose + ": there is another one of this name");
    if (parameter.kind == Parameter::Kind::formula)
      check_formula(ObjectReader(*node, study_key_table("parameter"), whose, reader.errors()), "formula",
                    parameter.formula, above);
    plan.parameters.push_back(std::move(parameter));
  }
  if (plan.parameters.empty() && reader.has("parameters"))
    reader.fail("parameters", "a study needs at least one parameter");
}

/// Reports texts within a value that are no formulas of the parameters.
void check_texts(const ObjectReader& reader, const YamlNode& node, const std::vector<std::string>& names) {
  for (const YamlNode::Entry& entry : node.entries) check_texts(reader, *entry.value, names);
  if (node.kind != YamlNode::Kind::scalar || parse_number(node.text).value) return;
  try {
    const Formula formula(node.text);
    for (const std::string& used : formula.names()) {
      if (std::find(names.begin(), names.end(), used) == names.end())
        reader.errors().add(node, "assign: formula " + quoted_text(node.text) + ": unknown name " +
                                      quoted_text(used) + suggestion(used, names));
    }
  } catch (const InputError& error) {
    reader.errors().add(node, "assign: " + error.messages().front());
  }
}

std::vector<Assignment> read_assignments(const ObjectReader& reader, const char* key) {
  std::vector<Assignment> assignments;
  const YamlNode* const node = reader.find(key);
  if (!node) return assignments;
  if (node->kind != YamlNode::Kind::map) {
    reader.fail(key, std::string(key) + " must be a mapping of keys of the scene to values");
    return assignments;
  }
  for (const YamlNode::Entry& entry : node->entries) assignments.push_back({entry.key, entry.value});
  return assignments;
}

void read_outcomes(const ObjectReader& reader, StudyPlan& plan) {
  std::size_t index = 0;
  std::vector<std::string> names = plan.columns();
  for (const YamlNode* const node : reader.list("outcomes")) {
    if (reader.errors().is_full()) return;
    Outcome outcome = read_outcome(*node, index++, names, reader.errors());
    if (std::find(names.begin(), names.end(), outcome.name) != names.end())
      reader.errors().add(*node, "outcome " + quoted_text(outcome.name) +
                                     ": a parameter or an outcome has this name already");
    if (plan.scene.empty() && outcome.kind != Outcome::Kind::formula &&
        outcome.kind != Outcome::Kind::cpu_time)
      reader.errors().add(
          *node, "outcome " + quoted_text(outcome.name) + ": without a scene an outcome is a formula");
    names.push_back(outcome.name);
    plan.outcomes.push_back(std::move(outcome));
  }
  if (plan.outcomes.empty() && reader.has("outcomes") && plan.kind != StudyKind::chaos)
    reader.fail("outcomes", "a study needs at least one outcome");
}

void read_expected(const ObjectReader& reader, StudyPlan& plan) {
  std::size_t index = 0;
  for (const YamlNode* const node : reader.list("expect")) {
    const ObjectReader expected(*node, study_key_table("expected finding"),
                                "expected finding " + std::to_string(index++), reader.errors());
    plan.expected.push_back({expected.text("finding").value_or(""), expected.number("value").value_or(0),
                             expected.number("tolerance")});
  }
}

/// Reports a name that is not that of a parameter of one number that can be moved: an interval, or for
/// neighbours any but a formula.
void check_moved_name(const ObjectReader& reader, const char* key, const std::string& name,
                      const StudyPlan& plan) {
  std::vector<std::string> names;
  for (const Parameter& parameter : plan.parameters) {
    const bool is_interval = parameter.kind == Parameter::Kind::interval;
    const bool is_number = parameter.coordinates() == 1;
    if (plan.kind == StudyKind::bisection ? is_interval : is_number) names.push_back(parameter.name);
  }
  if (name.empty())
    return reader.fail(key, "the key '" + std::string(key) + "' is missing: the name of a parameter");
  if (std::find(names.begin(), names.end(), name) == names.end())
    reader.fail(key, std::string(key) + ": no parameter that can be moved is called " + quoted_text(name) +
                         suggestion(name, names));
}

/// What each kind of study needs of its parameters.
void check_kind(const ObjectReader& reader, const StudyPlan& plan) {
  const std::string kind = study_kind_names()[static_cast<std::size_t>(plan.kind)];
  const bool has_grid =
      plan.kind == StudyKind::sweep || plan.kind == StudyKind::bisection || plan.kind == StudyKind::chaos;
  const bool is_search = plan.kind == StudyKind::minimise || plan.kind == StudyKind::maximise;
  int intervals = 0;
  for (const Parameter& parameter : plan.parameters) {
    if (parameter.kind == Parameter::Kind::interval) ++intervals;
    if (parameter.is_list() && parameter.value_count() > 1 && !has_grid)
      reader.errors().add_text(parameter.where + "parameter " + quoted_text(parameter.name) +
                               ": several values are for sweeps, bisections and chaos, not for " + kind);
  }
  if (plan.kind == StudyKind::bisection) {
    check_moved_name(reader, "search", plan.search, plan);
    if (plan.condition.empty())
      reader.fail("condition", "the key 'condition' is missing: a formula of outcomes");
  }
  if (plan.kind == StudyKind::chaos) check_moved_name(reader, "perturb", plan.perturbed, plan);
  if (is_search && intervals == 0) reader.fail("parameters", kind + " needs a parameter with a range");
  const bool needs_sobol = plan.kind == StudyKind::sensitivity || plan.sampling == Sampling::sobol;
  if (needs_sobol && 2 * plan.coordinate_count() > most_sobol_dimensions())
    reader.fail("parameters", "too many parameters for Sobol's sequence");
  if (plan.kind == StudyKind::morris && plan.levels % 2 != 0) reader.fail("levels", "levels must be even");
  if (plan.scene.empty() && plan.kind == StudyKind::chaos) reader.fail("scene", "chaos needs a scene");
}

void read_settings(const ObjectReader& reader, StudyPlan& plan) {
  plan.kind = choice_of(study_kind_names(), reader.text("kind"), StudyKind::sweep);
  plan.sampling = choice_of(sampling_names(), reader.text("sampling"), Sampling::random);
  const auto whole = [&](const char* key, std::uint64_t fallback) {
    return static_cast<std::uint64_t>(reader.number(key).value_or(static_cast<double>(fallback)));
  };
  plan.seed = whole("seed", 1);
  plan.runs = whole("runs", 1000);
  plan.repeats = whole("repeats", 1);
  plan.starts = static_cast<int>(whole("starts", 1));
  plan.levels = static_cast<int>(whole("levels", 4));
  plan.varies_seed = reader.flag("vary_seed").value_or(false);
  plan.confidence = reader.number("confidence").value_or(plan.confidence);
  plan.half_width = reader.number("half_width");
  plan.tolerance = reader.number("tolerance").value_or(plan.tolerance);
  plan.perturbation = reader.number("perturbation").value_or(plan.perturbation);
  plan.bound = reader.number("bound").value_or(plan.bound);
  plan.cpu_limit = reader.number("cpu_limit");
  plan.outcome = reader.text("outcome").value_or("");
  plan.search = reader.text("search").value_or("");
  plan.condition = reader.text("condition").value_or("");
  plan.perturbed = reader.text("perturb").value_or("");
}

/// The study of a scene; null if the document is no such scene.
const YamlNode* find_scene_study(const YamlNode& root) {
  const YamlNode::Entry* const study = root.find("rigor_study") ? nullptr : root.find("study");
  return study ? study->value.get() : nullptr;
}

std::vector<std::string> outcome_names(const StudyPlan& plan) {
  std::vector<std::string> names;
  for (const Outcome& outcome : plan.outcomes) names.push_back(outcome.name);
  return names;
}

}  // namespace

StudyPlan parse_study(const std::string& text, const std::filesystem::path& path) {
  const YamlSources sources{{path.string()}};
  const YamlNode::Pointer root = parse_yaml(text, 0, sources);
  SceneErrors errors(sources);
  const YamlNode* const in_scene = find_scene_study(*root);
  if (!in_scene && root->find("rigor") && !root->find("rigor_study"))
    throw InputError(sources.where(*root) +
                     "the scene has no 'study': write one into it, or a study file for it");
  const ObjectReader reader(in_scene ? *in_scene : *root,
                            in_scene ? scene_study_table() : study_key_table("study"), "the study", errors);
  StudyPlan plan;
  plan.file = path;
  plan.text = text;
  if (in_scene) {
    plan.scene = path;
  } else {
    reader.number("rigor_study");
    if (const std::optional<std::string> scene = reader.text("scene"))
      plan.scene = path.parent_path() / *scene;
  }
  plan.name = reader.text("name").value_or(path.stem().string());
  read_settings(reader, plan);
  read_parameters(reader, plan);
  plan.settings = read_assignments(reader, "set");
  plan.assignments = read_assignments(reader, "assign");
  for (const Assignment& assignment : plan.assignments)
    check_texts(reader, *assignment.value, plan.columns());
  read_outcomes(reader, plan);
  read_expected(reader, plan);
  if (!plan.outcome.empty() && !plan.find_outcome(plan.outcome))
    reader.fail("outcome", "no outcome is called " + quoted_text(plan.outcome) +
                               suggestion(plan.outcome, outcome_names(plan)));
  if (!plan.condition.empty()) {
    std::vector<std::string> names = plan.columns();
    for (std::string& name : outcome_names(plan)) names.push_back(std::move(name));
    check_formula(reader, "condition", plan.condition, names);
  }
  check_kind(reader, plan);
  if (errors.count() > 0) throw InputError(errors.sorted_messages());
  return plan;
}

StudyPlan read_study(const std::filesystem::path& path) {
  return parse_study(read_text_file(path, YamlLimits{}.max_bytes), path);
}

bool is_scene_with_study(const std::filesystem::path& path) {
  const std::string text = read_text_file(path, YamlLimits{}.max_bytes);
  return find_scene_study(*parse_yaml(text, 0, YamlSources{{path.string()}})) != nullptr;
}

}  // namespace rigor
