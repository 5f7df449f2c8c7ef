#pragma once

#include "rigor/io/scene/scene_template.hpp"
#include "rigor/study/plan/parameter_values.hpp"
#include "rigor/study/run/outcome_probe.hpp"
#include "rigor/study/run/run_row.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace rigor {

/// The scene of a study with the values that all runs have in common; null if the study has none. Throws
/// InputError.
std::shared_ptr<const SceneTemplate> study_scene(const StudyPlan& plan);

/// Carries out runs of a study, one after the other, on one thread. What a run gives depends on the plan and
/// its task alone, but for its processor time.
class RunExecutor {
 public:
  /// plan must outlive this object.
  RunExecutor(const StudyPlan& plan, std::shared_ptr<const SceneTemplate> scene);

  /// The row of a run; nothing if the interrupt asked for an end. Mistakes that are those of the study, not
  /// of the run, throw InputError.
  std::optional<RunRow> run(const RunTask& task, const std::function<bool()>& interrupt);
  /// The scenes of a run: one, of chaos also its neighbour's. Throws InputError.
  std::vector<Scene> scenes_of(const RunTask& task) const;
  /// What the run puts into the scene.
  std::vector<SceneValue> scene_values(const RunTask& task) const {
    return scene_values(values_.at(task.point), task.run);
  }

 private:
  std::vector<SceneValue> scene_values(const std::vector<double>& values, std::uint64_t run) const;
  Scene neighbour_of(const RunTask& task, const std::vector<double>& values) const;
  YamlNode::Pointer filled(const YamlNode& node, std::size_t& formula,
                           const std::vector<double>& values) const;
  void compile(const YamlNode& node);
  bool look_at_events(const Scene& scene, const std::function<bool()>& interrupt);
  RunRow simulated(const RunTask& task, const Scene& scene, const std::vector<double>& values,
                   const std::function<bool()>& interrupt);
  RunRow simulated_pair(const RunTask& task, const Scene& scene, const std::vector<double>& values,
                        const std::function<bool()>& interrupt);

  const StudyPlan& plan_;
  std::shared_ptr<const SceneTemplate> scene_;
  ParameterValues values_;
  OutcomeProbe probe_;
  std::vector<std::string> columns_;
  bool has_synonyms_ = true;  ///< The scene may have some.
  struct Text {
    Formula formula;
    std::vector<std::size_t> columns;
  };
  std::vector<Text> texts_;  ///< Formulas of all assignments, in the order in which they are met.
};

/// The `run.seed` of a run of a study that varies it.
std::uint64_t run_seed(const StudyPlan& plan, std::uint64_t run);

/// Columns that a study of chaos has before its outcomes: the Lyapunov exponent [1/s], the horizon [s], the
/// distance at the end [m].
const std::vector<std::string>& chaos_columns();
/// Names of the numbers that each run gives: for chaos those above, then the outcomes of the plan.
std::vector<std::string> row_columns(const StudyPlan& plan);

}  // namespace rigor
