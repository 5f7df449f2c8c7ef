#pragma once

#include "rigor/dynamics/environment.hpp"
#include "rigor/geometry/broad_phase/aabb_tree.hpp"
#include "rigor/geometry/rays/inner_points.hpp"
#include "rigor/model/state.hpp"
#include "rigor/sim/report/advance_report.hpp"
#include "rigor/sim/witness/body_path.hpp"

#include <optional>
#include <span>
#include <vector>

namespace rigor {

/// Watches whether a body goes into or through another, by another way than the search for contacts: rays.
/// Points well inside each shape are followed along the paths of the bodies, as seen from every other body
/// that may collide with theirs; where such a point enters the solid of the other, the bodies have passed
/// into each other by more than any contact allows. It knows nothing of distances, contacts and predictions.
///
/// A path is followed in chords that stay within a quarter of the point's clearance of it and turn by less
/// than half a radian, so that what is found has happened. Bodies that overlap from the start are left alone
/// until they part.
class PassageWitness {
 public:
  explicit PassageWitness(std::shared_ptr<const Model> model);

  /// Enters into the report what was found along these paths, one of each body; bodies without pieces stayed
  /// where they were, outside of every path.
  void watch(std::span<const BodyPath> paths, AdvanceReport& report);
  /// The same for one step from one State to another. A body that flew gets its flight, one that contacts
  /// have led a straight way; where that makes many turns about an axis that is not known, only points count
  /// that the rotation hardly moves.
  void watch(const State& before, const State& after, AdvanceReport& report);

 private:
  /// A shape's inner point on its body.
  struct Marker {
    Vec3 p_B;
    double clearance;
  };
  /// A shape of a body.
  struct Solid {
    int body, shape;
  };
  template <class Pieces>
  void watch_ways(std::span<const Aabb> ways, const Pieces& pieces, AdvanceReport& report);
  PathPiece way_of(int body, const State& before, const State& after) const;
  std::optional<double> entry_of(int a, const Solid& solid, const BodyPath& of_a, const BodyPath& of_b) const;

  std::shared_ptr<const Model> model_;
  Environment environment_;
  std::vector<std::vector<Marker>> markers_;  ///< Of each body.
  std::vector<double> offset_;   ///< Of each body: its farthest marker from the centre of mass [m].
  std::vector<Solid> solid_of_;  ///< All shapes of all bodies,
  std::vector<Aabb> solids_;     ///< and the boxes that hold them; those of fixed bodies stay.
  AabbTree tree_;
  long watches_ = 0;
};

}  // namespace rigor
