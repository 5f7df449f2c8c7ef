#pragma once

#include "rigor/model/model.hpp"
#include "rigor/model/state.hpp"

#include <vector>

namespace rigor::bench {

/// Where all bodies are: all that an engine is judged by.
struct BulkPoses {
  double t = 0;         ///< [s].
  std::vector<Vec3> x;  ///< Of the centres of mass in W [m].
  std::vector<Quat> q;  ///< q_WB.
};
BulkPoses poses_of(const State& state);

/// What can be said of a scene of many bodies at one instant, in double precision from poses alone: nothing
/// that an engine says of itself goes in. Velocities are what poses of two instants tell.
struct BulkFigures {
  bool is_finite = true;    ///< If not, the rest says nothing.
  int touching_pairs = 0;   ///< Bodies that overlap, by however little.
  int deep_pairs = 0;       ///< Those by more than 1 cm.
  double max_overlap = 0;   ///< [m].
  double mean_overlap = 0;  ///< Of the touching pairs [m].
  double rms_speed = 0;     ///< Of the centres of mass of dynamic bodies [m/s].
  double drift_across = 0;  ///< Farthest from where a body began, across gravity [m].
  double drift_down = 0;    ///< Farthest down or up [m].
  /// Farthest across the upright plane in which the scene began; 0 if it began in none [m].
  double drift_out = 0;
  /// Farthest apart of the two anchors of a ball joint or hinge, and of points 10 cm along a hinge's axes
  /// [m].
  double joint_error = 0;
  double energy = 0;    ///< Kinetic and of gravity, in the middle between the two instants [J].
  int lost_bodies = 0;  ///< Centres lower than all that stands still: they went through it or past it.
};

/// Figures of the poses `now` against those at t = 0. Overlaps are signed distances of geometry/; velocities
/// come from the poses `before`, a step earlier.
BulkFigures bulk_figures(const Model& model, const BulkPoses& start, const BulkPoses& before,
                         const BulkPoses& now);

/// Figures of a run, from those of its samples.
struct BulkQuality {
  BulkFigures end;             ///< Of the last sample.
  double max_overlap = 0;      ///< Of all samples [m].
  double max_joint_error = 0;  ///< Of all samples [m].
  double max_drift_out = 0;    ///< Of all samples [m].
  bool is_finite = true;       ///< In all samples.
  /// Change of the energy since the start by all dynamic bodies' weight times 5 m, the drop to compare with:
  /// in the last sample, and in the last before anything touched.
  double energy_change = 0;
  double free_energy_change = 0;
  double free_time = 0;  ///< Of that sample [s].
  bool stands = true;    ///< Nothing has come down by 1 m, or a fiftieth of the height over 0 that is more.
};

/// Collects the figures of a run.
class BulkJudge {
 public:
  /// `model` must outlive this.
  explicit BulkJudge(const Model& model);
  /// The poses of now and of a step before.
  void look(const BulkPoses& before, const BulkPoses& now);
  const BulkQuality& quality() const { return quality_; }

 private:
  const Model& model_;
  BulkPoses start_;
  double start_energy_ = 0, reference_energy_ = 0;  ///< [J].
  double fall_ = 1;                                 ///< What comes down by more than that has fallen [m].
  bool has_touched_ = false;
  BulkQuality quality_;
};

}  // namespace rigor::bench
