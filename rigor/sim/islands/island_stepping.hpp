#pragma once

#include "rigor/sim/islands/island_integrator.hpp"
#include "rigor/sim/islands/mode_change.hpp"
#include "rigor/sim/report/advance_report.hpp"

#include <optional>
#include <vector>

namespace rigor {

/// Bodies whose motion is integrated, over the step that they are in.
struct RunningIsland {
  Island island;
  IslandStep step;
  double end = 0;                    ///< [s].
  double wanted = 0;                 ///< How long the step should have been; 0 at velocity level [s].
  std::optional<ModeChange> change;  ///< What ends the step.
};

/// How far each step of an island goes: as far as the error and the modes of its contacts allow. Where modes
/// end as they begin or slip changes its direction on the spot, each very short step in a row must cover more
/// than the last;
/// when that does not help, steps at velocity level lead out of it (docs/decisions/0003).
///
/// What is remembered of each body (its step size, how short its last steps were) is scratch, dropped by
/// restart().
class IslandStepping {
 public:
  IslandStepping(const Model& model, const ContactSystemAssembler& assembler,
                 const IslandIntegrator& integrator, const Method& method, double target_step);

  /// Forgets all earlier steps.
  void restart();
  /// Whether the next step of these bodies is one at velocity level, if they touch anything.
  bool is_at_velocity_level(const std::vector<int>& bodies) const;
  /// Makes the next steps of these bodies steps at velocity level.
  void go_to_velocity_level(const std::vector<int>& bodies);
  /// Slip slower than this counts as none [m/s]. Where contacts of one body stop one after the other within
  /// no time, it grows with each very short step, so that the last slip stops with the first.
  double slip_tolerance_of(const std::vector<int>& bodies) const;
  /// The next step, of at most h ≤ target step [s].
  RunningIsland take_step(Island island, double h, AdvanceReport& report);
  /// Tells that the step was left after this time, at its end or because of another event [s].
  void note_end(const RunningIsland& running, double elapsed);

 private:
  int crowding_of(const std::vector<int>& bodies) const;
  void note_pace(const Island& island, double longest, const IslandStep& step);
  bool is_asked_within(const Island& island) const;
  double rotation_over(const Island& island, const IslandStep& step) const;
  void take_accurate_step(double h, double resolved, RunningIsland& running, AdvanceReport& report);
  void take_implicit_step(double h, double resolved, RunningIsland& running, AdvanceReport& report);

  const Model& model_;
  const ContactSystemAssembler& assembler_;
  const IslandIntegrator& integrator_;
  ModeChangeSearch mode_changes_;
  double time_tolerance_, contact_tolerance_, slip_tolerance_, direction_tolerance_, target_step_;
  double hopeless_error_;       ///< Of a step, relative to the tolerance: half of its digits are lost.
  std::vector<int> crowding_;   ///< Of each body: short steps in a row.
  std::vector<long> useless_;   ///< Of each body: parts of a step in a row that are too short to be of use.
  std::vector<bool> collides_;  ///< Of each body: whether it may touch any other.
  std::vector<double> step_size_;  ///< Of each body: what the error of its last step suggests [s].
  std::vector<double> slip_time_;  ///< Of each body: where that step began [s]; infinite: none.
};

}  // namespace rigor
