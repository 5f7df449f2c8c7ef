#pragma once

#include "rigor/model/state.hpp"
#include "rigor/sim/audit/audit.hpp"
#include "rigor/study/formula/formula.hpp"
#include "rigor/study/plan/study_plan.hpp"
#include "rigor/study/run/scene_quantity.hpp"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace rigor {

/// Takes the outcomes of runs, one run after the other, on one thread.
class OutcomeProbe {
 public:
  /// plan must outlive this object.
  explicit OutcomeProbe(const StudyPlan& plan);

  /// Begins a run with these values of the plan's columns, of a scene with this model (null: of none). Throws
  /// InputError with places in the study file if the scene lacks what the outcomes name.
  void begin(std::shared_ptr<const Model> model, std::vector<double> parameters);
  /// Looks at an output and at what happened since the last one.
  void observe(const State& state, const AdvanceReport& since, const Energy& energy);
  /// Times of the events after which values are wanted that are not taken yet, each once, in order [s].
  /// Known when the run has come to its end.
  std::vector<double> event_times() const;
  /// Takes the values that are wanted after the events of this time.
  void observe_event(double time, const State& state, const Energy& energy);
  /// The outcomes, in the order of the plan. state, audit: of the end; null without a scene.
  std::vector<double> finish(const State* state, const Audit* audit, double cpu_time);

 private:
  /// Where the value of a name of a formula comes from.
  struct Source {
    enum class From { parameter, outcome, quantity, time } from;
    std::size_t index = 0;
    SceneQuantity quantity{};
  };
  struct Bound {
    Formula formula;
    std::vector<Source> sources;
  };
  struct OutcomeTracker {
    std::vector<Bound> formula, when;  ///< One each, or none.
    int body_A = -1, body_B = -1;      ///< Of its events or face.
    double value = 0;
    double event_time = 0;  ///< Of a value at an event; NaN: it has not happened.
    long count = 0;
    bool is_done = false;
  };
  /// An output.
  struct OutputSample {
    const State* state;
    const Energy* energy;
    const Audit* audit;
  };

  void bind(const Model& model);
  Bound bound(const std::string& formula, const Outcome& outcome) const;
  int body_of(const std::string& name, const Outcome& outcome) const;
  double evaluated(const Bound& bound, const OutputSample& sample);
  void observe_value(const Outcome& outcome, const OutputSample& sample, OutcomeTracker& tracker);
  void observe_events(const Outcome& outcome, const AdvanceReport& since, OutcomeTracker& tracker) const;
  double finished(const Outcome& outcome, const OutputSample& end, double cpu_time, OutcomeTracker& tracker);

  const StudyPlan& plan_;
  std::vector<std::string> columns_;
  std::shared_ptr<const Model> model_;
  int bound_bodies_ = -1;  ///< Of the model to which the names are bound.
  std::vector<double> parameters_, arguments_, values_;
  std::vector<OutcomeTracker> trackers_;
};

}  // namespace rigor
