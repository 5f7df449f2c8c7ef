#pragma once

#include "rigor/bulk/matching/step_manifolds.hpp"
#include "rigor/bulk/state/bulk_bodies.hpp"
#include "rigor/bulk/threads/executor.hpp"
#include "rigor/geometry/lanes/lane_target.hpp"
#include "rigor/model/model.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace rigor {

/// How far the springs of contacts let bodies lean that stand on each other: the rotation of each body since
/// the place that it would have if the faces on which it stands were flush, as they are where bodies are
/// rigid. Contacts have arms from which it is taken, so that columns and walls do not buckle on their springs
/// (docs/theory/bulk.md, section 3).
///
/// The tilt of a manifold is the slope of the overlaps of its points, those that are apart having none; what
/// stands on it has that tilt, and the tilt of what it stands on. What rotates fast does not stand. All
/// follows from the manifolds and the velocities of the beginning of the step.
class ElasticTilts {
 public:
  explicit ElasticTilts(const Model& model);

  /// After gravity of the Model has changed; after a body has.
  void set_gravity(const Model& model);
  void set_body(const Model& model, int body);

  /// At the beginning of a step of h [s], with its manifolds: sets BulkBodies::tilts.
  void find(const StepManifolds& manifolds, double h, const Executor& executor, BulkBodies& bodies);

 private:
  /// A manifold on which a body stands.
  struct Support {
    TiltRow turn{};  ///< Tilt of the upper body against the lower [rad], and the sum of the overlaps [m].
    int upper = -1, lower = -1;  ///< upper is dynamic.

    bool is_there() const { return turn[3] > 0; }
  };
  void find_supports(const StepManifolds& manifolds, std::size_t begin, std::size_t end, float ahead,
                     const BulkBodies& bodies);
  bool list_by_lower(std::size_t body_count);
  void add_up(std::vector<TiltRow>& tilts);

  LaneTarget target_ = best_lane_target();
  std::array<float, 3> up_{};  ///< Against gravity.
  double gravity_ = 0;         ///< [m/s²].
  /// Of bodies: 1 over the square of the angular speed that halves their tilts [s²]; empty without gravity.
  std::vector<float> slow_;
  std::vector<Support> supports_;   ///< Of each manifold; without weight where nothing stands on it.
  std::vector<int> first_, above_;  ///< Supports of which a body is the lower: above_[first_[i]] and on.
  std::vector<int> pending_;        ///< Of bodies: supports on bodies whose tilt is not known yet.
  std::vector<int> known_;          ///< Bodies whose tilt is known, in the order in which it was found.
};

}  // namespace rigor
