#pragma once

#include "rigor/dynamics/environment.hpp"
#include "rigor/geometry/broad_phase/aabb_tree.hpp"
#include "rigor/model/state.hpp"
#include "rigor/sim/report/advance_report.hpp"
#include "rigor/sim/witness/relative_trajectory.hpp"
#include "rigor/sim/witness/step_moves.hpp"
#include "rigor/sim/witness/watched_pairs.hpp"

#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace rigor {

/// Watches whether a body goes into or through another, by another way than the search for contacts: rays.
/// Points well inside each shape are followed along the paths of the bodies, as seen from every other body
/// that may collide with theirs (RelativeTrajectory); where such a point enters the solid of the other, the
/// bodies have passed into each other by more than any contact allows. It knows nothing of distances,
/// contacts and predictions. Bodies that overlap from the start are left alone until they part.
class PassageWitness {
 public:
  explicit PassageWitness(std::shared_ptr<const Model> model);
  /// Another witness of the same model: what is known of its shapes, which takes long for large meshes, is
  /// shared.
  explicit PassageWitness(const PassageWitness& other);

  /// Enters into the report what was found along these paths, one of each body; of a body without pieces
  /// nothing is found.
  void watch(std::span<const BodyPath> paths, AdvanceReport& report);

  /// From now on steps of these bodies alone are watched, one against another; the others are moved
  /// elsewhere.
  void watch_only(std::vector<bool> is_here) { is_here_ = std::move(is_here); }
  /// Steps that are watched begin at this State.
  void begin(const State& state);
  /// Enters what was found in the step that leads here from where the last one ended, along the ways of
  /// step_path(). Only pairs that WatchedPairs cannot rule out are followed. Pairs of one of these groups (of
  /// each body; -1: of all) have been watched already.
  void watch(const State& after, AdvanceReport& report, std::span<const int> groups = {});

 private:
  /// A shape of a body.
  struct Solid {
    int body, shape;
  };
  void watch_boxes(std::span<const BodyPath> paths);
  void remember(const State& state);
  bool is_watched(int a, int b, std::span<const int> groups) const;
  template <class Paths>
  void enter(int body, const Solid& solid, const Paths& path_of, AdvanceReport& report) const;
  std::optional<double> entry_of(int a, const Solid& solid, const BodyPath& of_a, const BodyPath& of_b) const;

  std::shared_ptr<const Model> model_;
  std::vector<std::shared_ptr<const MarkedBody>> marked_;  ///< By body.
  bool follows_anything_;                                  ///< Some body has markers.
  // Of paths:
  std::vector<Solid> solid_of_;     ///< All shapes, body by body.
  std::vector<Aabb> marker_boxes_;  ///< Boxes that hold the markers of each body,
  std::vector<Aabb> solid_boxes_;   ///< and those of each shape; those of fixed bodies stay.
  AabbTree tree_;                   ///< Of solid_boxes_.
  long watches_ = 0;
  // Of steps:
  std::vector<bool> is_here_;                 ///< By body; empty: all are.
  State before_;                              ///< Where the last step ended: t, x, q, P and L.
  std::unique_ptr<Environment> environment_;  ///< This and the next are made at the first step.
  std::optional<StepMoves> moves_;
  std::optional<WatchedPairs> pairs_;
};

}  // namespace rigor
