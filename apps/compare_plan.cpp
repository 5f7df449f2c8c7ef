#include "apps/compare_plan.hpp"

#include "apps/usage_error.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/core/quoted.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace rigor {

namespace {

/// Collects the errors of all combinations.
class PlanErrors {
 public:
  void add(const std::string& label, const std::vector<std::string>& messages) {
    for (const std::string& message : messages) {
      const auto known = std::find_if(mistakes_.begin(), mistakes_.end(),
                                      [&](const Mistake& mistake) { return mistake.message == message; });
      if (known == mistakes_.end()) {
        mistakes_.push_back({message, label, 1});
      } else {
        ++known->run_count;
      }
    }
  }

  /// Throws InputError if there are any.
  void check(std::size_t run_count) const {
    if (mistakes_.empty()) return;
    std::vector<std::string> messages;
    for (const Mistake& mistake : mistakes_) {
      // A message about a varied value already names it.
      const bool tells_whose = mistake.run_count == run_count || mistake.message.starts_with("--vary ");
      messages.push_back(mistake.message + (tells_whose ? "" : whose(mistake)));
    }
    throw InputError(std::move(messages));
  }

 private:
  struct Mistake {
    std::string message;
    std::string label;  ///< Label of the first run that has it.
    std::size_t run_count;
  };

  static std::string whose(const Mistake& mistake) {
    const std::size_t others = mistake.run_count - 1;
    return fmt::format(
        " (with {}{})", mistake.label,
        others == 0 ? "" : fmt::format(" and {} more {}", others, others == 1 ? "run" : "runs"));
  }

  std::vector<Mistake> mistakes_;
};

std::vector<Variation> read_variations(const CompareOptions& options) {
  std::vector<Variation> variations;
  for (const std::string& text : options.variations) variations.push_back(parse_variation(text));
  for (const Variation& variation : variations) {
    for (const std::string& text : options.overrides) {
      if (text.starts_with(variation.key + "="))
        throw UsageError(fmt::format("--set {} has no effect beside --vary {}; leave one of them out", text,
                                     variation.key));
    }
    if (options.duration && variation.key == "run.duration")
      throw UsageError("--duration does not go with --vary run.duration; leave one of them out");
  }
  return variations;
}

void check_drawn(const std::vector<std::string>& outputs, std::size_t run_count) {
  if (run_count <= most_drawn_runs) return;
  for (const std::string& output : outputs) {
    const std::string suffix = std::filesystem::path(output).extension().string();
    // A page holds the motion of the first runs, and the numbers of all of them.
    if (suffix == ".json" || suffix == ".csv" || suffix == ".html") continue;
    throw UsageError(
        fmt::format("output {} shows at most {} runs, and these are {}; .json, .csv and .html take them all",
                    quoted_text(output), most_drawn_runs, run_count));
  }
}

/// "key=value" for the values whose keys are selected.
template <typename IsWanted>
std::vector<std::string> varied_overrides(const std::vector<Variation>& variations, const Combination& values,
                                          IsWanted is_wanted) {
  std::vector<std::string> overrides;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (is_wanted(variations[i].key)) overrides.push_back(variations[i].key + "=" + values[i]);
  }
  return overrides;
}

/// The scene with these values, and its start.
void read_run(const CompareOptions& options, const std::vector<std::string>& varied, PlannedRun& run) {
  std::vector<std::string> overrides = options.overrides;
  overrides.insert(overrides.end(), varied.begin(), varied.end());
  run.scene = read_scene(options.scene, overrides, varied.size());
  if (options.duration) run.scene.run.duration = *options.duration;
  run.start = make_run_start(options.scene, run.scene, options.separate);
}

/// All values of a choice such as "method.scheme"; none for any other key.
std::vector<std::string> choice_values(const std::string& key) {
  constexpr std::string_view method = "method.";
  if (!key.starts_with(method)) return {};
  return method_values(key.substr(method.size()));
}

/// Whether all values of choices exist.
bool has_known_choices(const std::vector<Variation>& variations, const Combination& values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::vector<std::string> known = choice_values(variations[i].key);
    if (!known.empty() && std::find(known.begin(), known.end(), values[i]) == known.end()) return false;
  }
  return true;
}

/// An invalid combination, with the errors that were found.
struct WrongRun {
  std::size_t run;
  std::vector<std::string> messages;
};

/// Whether a combination is invalid only because of choices of its method: they exist, and with other choices
/// it is valid. An error in a scene is a result in a comparison.
bool is_refusal(const std::vector<Variation>& variations, const std::vector<PlannedRun>& runs,
                const PlannedRun& wrong) {
  const auto others = [&](const Combination& values) {
    return varied_overrides(variations, values,
                            [](const std::string& key) { return choice_values(key).empty(); });
  };
  if (!has_known_choices(variations, wrong.values)) return false;
  return std::any_of(runs.begin(), runs.end(), [&](const PlannedRun& run) {
    return run.scene.model && others(run.values) == others(wrong.values);
  });
}

/// The error without the position in the command line, which the label of the run gives.
std::string refusal_text(const std::vector<std::string>& messages) {
  const std::string& first = messages.front();
  const std::size_t place = first.starts_with("--vary ") ? first.find(": ") : std::string::npos;
  const std::string reason = place == std::string::npos ? first : first.substr(place + 2);
  return messages.size() == 1 ? reason : fmt::format("{} (and {} more)", reason, messages.size() - 1);
}

/// Assigns to each run the reference that belongs to its values that are not numerical.
void plan_references(const CompareOptions& options, const std::vector<Variation>& variations,
                     ComparePlan& plan) {
  if (!wants_reference(options, plan.keys)) return;
  std::vector<std::vector<std::string>> groups;
  for (PlannedRun& run : plan.runs) {
    const std::vector<std::string> group = varied_overrides(
        variations, run.values, [](const std::string& key) { return !is_numerical_key(key); });
    const auto known = std::find(groups.begin(), groups.end(), group);
    run.reference = at(known - groups.begin());
    if (known != groups.end()) continue;
    groups.push_back(group);
    plan.references.push_back(plan_reference(options, group));
  }
}

}  // namespace

ComparePlan read_compare_plan(const CompareOptions& options) {
  check_reference_options(options);
  const std::vector<Variation> variations = read_variations(options);
  const std::vector<Combination> all = combinations(variations, most_compared_runs);
  check_drawn(options.outputs, all.size());
  ComparePlan plan;
  for (const Variation& variation : variations) plan.keys.push_back(variation.key);
  std::vector<WrongRun> wrong;
  for (const Combination& values : all) {
    PlannedRun run{.values = values, .label = combination_label(variations, values)};
    try {
      read_run(options, varied_overrides(variations, values, [](const std::string&) { return true; }), run);
    } catch (const InputError& error) {
      run = {.values = values, .label = run.label};
      wrong.push_back({plan.runs.size(), error.messages()});
    }
    plan.runs.push_back(std::move(run));
  }
  PlanErrors mistakes;
  for (const auto& [number, messages] : wrong) {
    PlannedRun& run = plan.runs[number];
    if (is_refusal(variations, plan.runs, run)) {
      run.refusal = refusal_text(messages);
    } else {
      mistakes.add(run.label, messages);
    }
  }
  mistakes.check(all.size());
  plan_references(options, variations, plan);
  for (const PlannedRun& run : plan.runs) {
    for (const std::string& warning : run.scene.warnings) {
      if (std::find(plan.warnings.begin(), plan.warnings.end(), warning) == plan.warnings.end())
        plan.warnings.push_back(warning);
    }
  }
  return plan;
}

}  // namespace rigor
