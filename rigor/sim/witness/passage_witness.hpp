#pragma once

#include "rigor/dynamics/environment.hpp"
#include "rigor/geometry/broad_phase/aabb_tree.hpp"
#include "rigor/model/state.hpp"
#include "rigor/sim/report/advance_report.hpp"
#include "rigor/sim/witness/pursuit.hpp"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace rigor {

/// Watches whether a body goes into or through another, by another way than the search for contacts: rays.
/// Points well inside each shape are followed along the paths of the bodies, as seen from every other body
/// that may collide with theirs (Pursuit); where such a point enters the solid of the other, the bodies have
/// passed into each other by more than any contact allows. It knows nothing of distances, contacts and
/// predictions. Bodies that overlap from the start are left alone until they part.
class PassageWitness {
 public:
  explicit PassageWitness(std::shared_ptr<const Model> model);

  /// Enters into the report what was found along these paths, one of each body; of a body without pieces
  /// nothing is found.
  void watch(std::span<const BodyPath> paths, AdvanceReport& report);
  /// The same for one step from one State to another (step_way).
  void watch(const State& before, const State& after, AdvanceReport& report);

 private:
  /// A shape of a body.
  struct Solid {
    int body, shape;
  };
  void add_markers(int body);
  void add_solids(int body);
  void box_freely(int body, const Aabb& centre_way);
  void box_closely(int body, double turn, const State& before, const State& after);
  template <class Paths>
  void find(const Paths& path_of, AdvanceReport& report);
  std::optional<double> entry_of(int a, const Solid& solid, const BodyPath& of_a, const BodyPath& of_b) const;

  std::shared_ptr<const Model> model_;
  Environment environment_;
  std::vector<std::vector<Marker>> markers_;  ///< Of each body.
  std::vector<double> offset_;            ///< Of each body: its farthest marker from the centre of mass [m].
  std::vector<Solid> solid_of_;           ///< All shapes, body by body.
  std::vector<std::size_t> first_solid_;  ///< Of each body in solid_of_; one more at the end.
  // Of a watch:
  std::vector<Aabb> ways_;    ///< Boxes that hold the markers of each body,
  std::vector<Aabb> solids_;  ///< and those of each shape; those of fixed bodies stay.
  AabbTree tree_;             ///< Of solids_.
  long watches_ = 0;
};

}  // namespace rigor
