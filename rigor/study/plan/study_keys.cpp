#include "rigor/study/plan/study_keys.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/study/plan/study_plan.hpp"

#include <algorithm>

namespace rigor {

namespace {

constexpr Range most_runs{1, 1e8}, positive{0, 1e15, true}, seeds{0, 9007199254740992.0};

KeyTable study_table() {
  return {
      "study",
      "a study",
      "",
      {
          {"rigor_study", ValueType::whole, "", "required", {1, 1}, "version of the format of studies"},
          {"name", ValueType::text, "", "the file's name", {}, "name of the study"},
          {"scene",
           ValueType::text,
           "",
           "-",
           {},
           "scene file, from the folder of the study; none: formulas alone"},
          {"set", ValueType::object, "", "-", {}, "values of the scene in all runs, by key as of `--set`"},
          {"kind", ValueType::choice, "", "required", {}, "what is asked", study_kind_names()},
          {"parameters", ValueType::objects, "", "required", {}, "what varies", {}, "parameter"},
          {"assign",
           ValueType::object,
           "",
           "-",
           {},
           "values of the scene by key; texts in them are formulas of the parameters"},
          {"outcomes", ValueType::objects, "", "required", {}, "what each run gives", {}, "outcome"},
          {"outcome", ValueType::text, "", "the last one", {}, "the outcome that the study is about"},
          {"sampling", ValueType::choice, "", "random", {}, "how points are drawn", sampling_names()},
          {"runs", ValueType::whole, "", "1000", most_runs,
           "Monte Carlo, chaos: the most runs; sensitivity: base points; morris: ways; optimum: the most "
           "runs a start"},
          {"repeats", ValueType::whole, "", "1", most_runs,
           "runs a point, with draws and seeds of their own"},
          {"seed", ValueType::whole, "", "1", seeds, "of everything drawn"},
          {"vary_seed", ValueType::flag, "", "false", {}, "each run has a `run.seed` of its own"},
          {"confidence", ValueType::number, "", "0.95", {0.5, 0.9999}, "of all intervals"},
          {"half_width", ValueType::number, "", "-", positive,
           "Monte Carlo ends when the interval of the outcome is this narrow"},
          {"search", ValueType::text, "", "-", {}, "bisection: the parameter"},
          {"condition",
           ValueType::text,
           "",
           "-",
           {},
           "bisection: formula of outcomes that holds on one side of the threshold"},
          {"tolerance", ValueType::number, "", "0.001", positive,
           "bisection: width of the last bracket; optimum: of the parameters, as a share of their ranges"},
          {"starts", ValueType::whole, "", "1", {1, 1e4}, "optimum: searches from so many points"},
          {"levels", ValueType::whole, "", "4", {2, 64}, "morris: levels of the grid, even"},
          {"perturb", ValueType::text, "", "-", {}, "chaos: the parameter that neighbours differ in"},
          {"perturbation", ValueType::number, "", "1e-9", positive, "chaos: by how much"},
          {"bound", ValueType::number, "m", "0.01", positive,
           "chaos: distance of bodies up to which motions agree"},
          {"cpu_limit", ValueType::number, "s", "-", positive,
           "processor time after which a run is given up"},
          {"expect",
           ValueType::objects,
           "",
           "-",
           {},
           "numbers that the study must find",
           {},
           "expected finding"},
      }};
}

KeyTable parameter_table() {
  return {"parameter",
          "a parameter",
          "",
          {
              {"name", ValueType::text, "", "required", {}, "its name in formulas: letters, digits and _"},
              {"key", ValueType::text, "", "-", {}, "key of the scene, as of `--set`"},
              {"keys", ValueType::objects, "", "-", {}, "several such keys"},
              {"values", ValueType::objects, "", "-", {}, "numbers or angles, one after the other"},
              {"range", ValueType::range, "", "-", {}, "lowest and highest value"},
              {"count", ValueType::whole, "", "-", {2, 1e8}, "that many values evenly over the range"},
              {"log", ValueType::flag, "", "false", {}, "evenly in the logarithm"},
              {"distribution",
               ValueType::choice,
               "",
               "uniform over the range",
               {},
               "what is drawn",
               {"uniform", "normal", "lognormal", "orientation", "box", "sphere"}},
              {"mean", ValueType::number, "", "0", {}, "normal: of the number; lognormal: of its logarithm"},
              {"deviation", ValueType::number, "", "1", positive, "standard deviation of the same"},
              {"low", ValueType::vector, "", "[0, 0, 0]", {}, "box: its lowest corner"},
              {"high", ValueType::vector, "", "[1, 1, 1]", {}, "box: its highest corner"},
              {"center", ValueType::vector, "", "[0, 0, 0]", {}, "sphere: its centre"},
              {"radius", ValueType::number, "", "1", positive, "sphere: its radius"},
              {"formula", ValueType::text, "", "-", {}, "function of the parameters above"},
          }};
}

KeyTable outcome_table() {
  const std::vector<std::string> events = {"impact", "rest", "separation", "slip_to_stick"};
  return {"outcome",
          "an outcome",
          "",
          {
              {"name",
               ValueType::text,
               "",
               "required",
               {},
               "its name in formulas and tables: letters, digits and _"},
              {"value", ValueType::text, "", "-", {}, "formula of quantities of the scene, at an instant"},
              {"at", ValueType::number, "s", "the end", {0, 1e9}, "`value`: when, an output time"},
              {"when",
               ValueType::text,
               "",
               "-",
               {},
               "`value`: at the first output at which this condition holds"},
              {"event", ValueType::choice, "", "-", {}, "`value`: just after this event", events},
              {"min", ValueType::text, "", "-", {}, "smallest value of a formula over all outputs"},
              {"max", ValueType::text, "", "-", {}, "largest value of a formula over all outputs"},
              {"first", ValueType::text, "", "-", {}, "time of the first output at which a condition holds"},
              {"count", ValueType::choice, "", "-", {}, "number of events", events},
              {"time_of", ValueType::choice, "", "-", {}, "time of an event", events},
              {"impulse", ValueType::choice, "", "-", {}, "largest impulse of an impact", {"largest"}},
              {"bodies", ValueType::objects, "", "-", {}, "events of this body, or of these two"},
              {"number", ValueType::whole, "", "1", {1, 1e8}, "`time_of`, `event`: which one"},
              {"face", ValueType::text, "", "-", {}, "body: number of the face that is up at the end"},
              {"cpu_time",
               ValueType::flag,
               "",
               "-",
               {},
               "processor time of the run; differs from run to run of a study"},
              {"formula", ValueType::text, "", "-", {}, "function of parameters and outcomes above"},
              {"else", ValueType::number, "", "nan", {}, "instead of what did not happen"},
          }};
}

KeyTable expectation_table() {
  return {"expected finding",
          "an expected finding",
          "",
          {
              {"finding", ValueType::text, "", "required", {}, "its name in the answer"},
              {"value", ValueType::number, "", "required", {}, "known independently"},
              {"tolerance", ValueType::number, "", "-", positive,
               "largest distance; without it the interval must hold the value"},
          }};
}

}  // namespace

const std::vector<KeyTable>& study_key_tables() {
  static const std::vector<KeyTable> tables = {study_table(), parameter_table(), outcome_table(),
                                               expectation_table()};
  return tables;
}

const KeyTable& study_key_table(std::string_view object) {
  const std::vector<KeyTable>& tables = study_key_tables();
  const auto found = std::find_if(tables.begin(), tables.end(),
                                  [&](const KeyTable& table) { return table.object == object; });
  RIGOR_ASSERT(found != tables.end());
  return *found;
}

const KeyTable& scene_study_table() {
  static const KeyTable table = [] {
    KeyTable keys = study_key_table("study");
    std::erase_if(keys.keys, [](const Key& key) { return key.name == "rigor_study" || key.name == "scene"; });
    return keys;
  }();
  return table;
}

}  // namespace rigor
