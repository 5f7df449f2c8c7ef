#include "apps/compare_plan.hpp"

#include "apps/usage_error.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/core/quoted.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace rigor {

namespace {

/// The mistakes of all combinations.
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
      // A message about a varied value names it already.
      const bool tells_whose = mistake.run_count == run_count || mistake.message.starts_with("--vary ");
      messages.push_back(mistake.message + (tells_whose ? "" : whose(mistake)));
    }
    throw InputError(std::move(messages));
  }

 private:
  struct Mistake {
    std::string message;
    std::string label;  ///< Of the first run that has it.
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
    if (suffix == ".json" || suffix == ".csv") continue;
    throw UsageError(
        fmt::format("output {} shows at most {} runs, and these are {}; .json and .csv take them all",
                    quoted_text(output), most_drawn_runs, run_count));
  }
}

PlannedRun planned_run(const CompareOptions& options, const std::vector<Variation>& variations,
                       const Combination& values) {
  std::vector<std::string> overrides = options.overrides;
  for (std::size_t i = 0; i < values.size(); ++i) overrides.push_back(variations[i].key + "=" + values[i]);
  PlannedRun run{
      values, combination_label(variations, values), read_scene(options.scene, overrides, values.size()), {}};
  if (options.duration) run.scene.run.duration = *options.duration;
  run.start = make_run_start(options.scene, run.scene, options.separate);
  return run;
}

}  // namespace

ComparePlan read_compare_plan(const CompareOptions& options) {
  const std::vector<Variation> variations = read_variations(options);
  const std::vector<Combination> all = combinations(variations, most_compared_runs);
  check_drawn(options.outputs, all.size());
  ComparePlan plan;
  for (const Variation& variation : variations) plan.keys.push_back(variation.key);
  PlanErrors errors;
  for (const Combination& values : all) {
    try {
      plan.runs.push_back(planned_run(options, variations, values));
    } catch (const InputError& error) {
      errors.add(combination_label(variations, values), error.messages());
    }
  }
  errors.check(all.size());
  for (const PlannedRun& run : plan.runs) {
    for (const std::string& warning : run.scene.warnings) {
      if (std::find(plan.warnings.begin(), plan.warnings.end(), warning) == plan.warnings.end())
        plan.warnings.push_back(warning);
    }
  }
  return plan;
}

}  // namespace rigor
