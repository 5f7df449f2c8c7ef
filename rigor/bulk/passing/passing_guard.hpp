#pragma once

#include "rigor/bulk/broad_phase/box_tree.hpp"
#include "rigor/bulk/broad_phase/pair_filter.hpp"
#include "rigor/bulk/graph/islands.hpp"
#include "rigor/bulk/graph/jointed_bodies.hpp"
#include "rigor/bulk/narrow_phase/narrow_phase.hpp"
#include "rigor/bulk/passing/body_boxes.hpp"
#include "rigor/bulk/passing/free_path.hpp"
#include "rigor/bulk/passing/jointed_paths.hpp"
#include "rigor/bulk/state/bulk_bodies.hpp"
#include "rigor/bulk/state/bulk_shape.hpp"
#include "rigor/bulk/state/changed_bodies.hpp"
#include "rigor/bulk/state/shape_ranges.hpp"
#include "rigor/bulk/threads/executor.hpp"
#include "rigor/model/model.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <unordered_map>
#include <vector>

namespace rigor {

/// Keeps bodies from passing through each other within a step (docs/theory/bulk.md, section 9). Contacts are
/// those of the beginning of the step; a body that moves farther than it is thick may meet others elsewhere.
/// It is stopped where it first overlaps one of them by 0.15 of the thinner one's thickness, with its
/// velocity, and the contact there is one of the next step. From where it meets a driven body so, which
/// nothing stops, that takes it along.
class PassingGuard {
 public:
  PassingGuard(const Model& model, int substeps);

  /// After bodies, joints or excluded pairs of the Model have changed. All shapes that it has seen must be
  /// alive still.
  void change(const ChangedBodies& changed);
  /// After the group or mask of a body has changed.
  void set_filter(int body) { filter_.set_body(*model_, body); }

  /// See PairFinder::set_contact_filter.
  void set_contact_filter(std::function<bool(int, int)> may_touch) { may_touch_ = std::move(may_touch); }
  /// How long the next part of a step may be of which h [s] are left, so that bodies of joints turn little
  /// within one, and kinematic ones, which nothing stops, do not pass what they push nor leave the contacts
  /// that were found with it. h unless such a body is near another. pairs: those that may meet within h.
  double longest_part(const BulkBodies& bodies, const std::vector<ShapePair>& pairs, double h) const;
  /// Whether there are kinematic bodies.
  bool has_driven() const { return driven_ > 0; }
  /// Whether the displacements of the last step were numbers: if not, nothing was stopped.
  bool is_finite() const { return is_finite_; }
  /// At the beginning of a step of h [s]: how far bodies go at their present velocities.
  void begin(const BulkBodies& bodies, double h);
  /// Then marks the jointed bodies whose ways within h bend near others: they are to be noted.
  void mark_bent(const BulkBodies& bodies, const std::vector<ShapePair>& pairs, double h,
                 std::vector<char>& marks) const;
  /// After the displacements of each substep, `moving` being the bodies that it has displaced: jointed ones
  /// go on arcs.
  void note(const BulkBodies& bodies, const std::vector<int>& moving) {
    if (has_jointed_) paths_.note(bodies, moving, jointed_.all());
  }

  /// A body that was stopped after this share of its displacement.
  struct Stopped {
    int body;
    double share;
  };
  /// After the last substep: shortens the displacements of bodies that would pass others. pairs, manifolds:
  /// those that were found at the beginning, up to `margin` [m] beyond how far bodies were to go.
  const std::vector<Stopped>& stop(const std::vector<ShapePair>& pairs, const ManifoldList& manifolds,
                                   double margin, const Executor& executor, BulkBodies& bodies);

  /// Whether the world of the step that has begun is small enough to take a step anew in parts where its
  /// contacts end too deep.
  bool may_take_parts() const;
  /// After stop(): whether points of a contact end the step deep in each other, and deeper than they began,
  /// or a pair that overlapped before was stopped. manifolds: of the beginning.
  bool ends_deeper(const std::vector<ShapePair>& pairs, const ManifoldList& manifolds,
                   const BulkBodies& bodies) const;

  /// After the last step has ended: bodies that overlapped before it already, and were to go deeper, keep the
  /// part of their motion against each other that they went. What is left is a motion that no contact sees,
  /// such as the spin of a body that others hold: it would take them deeper in each step to come.
  void calm_jams(BulkBodies& bodies) const;

 private:
  /// A pair that was deep, and the part of its way that it went.
  struct Jam {
    int body_A, body_B;
    double share;
  };
  /// Two shapes whose bodies move far against each other, and how far they may go.
  struct FarPair {
    int body_A, body_B, shape_A, shape_B;
    Vec3 normal_W;  ///< Of their contact at the beginning, from A to B; zero: they had none.
    double share = 1;
    bool is_checked = false;
    bool overlaps = false;  ///< Since the beginning.
  };
  /// What is known of a shape.
  struct ShapeFacts {
    double thickness = 0;     ///< No point of it lies deeper inside, nearly [m].
    double ball_inside = -1;  ///< Radius of the ball inside that a surface cannot lose [m]; -1: a surface.
    double ball_offset = 0;   ///< Of that ball's centre from the body's [m].
    double turning = 0;       ///< How far from the body's centre rotation moves points [m].
    /// How deep a point may be inside where it is thick, as hulls are in their middle, however pointed [m].
    double depth() const { return std::max(thickness, ball_inside); }
  };
  void find_groups();
  void add_body(int body, std::optional<FloatHulls>& hulls);
  const ShapeFacts& facts_of(const Body& body, std::size_t shape, std::optional<FloatHulls>& hulls);
  const ShapeFacts& facts(int body, int shape) const { return facts_[at(ranges_.begin(body) + shape)]; }
  double spin_near(int body, const ShapePair& pair, const BulkBodies& bodies, double h) const;
  double part_of_driven(const ShapePair& pair, bool is_A, const BulkBodies& bodies, double h) const;
  double distance_of(const ShapePair& pair, const BulkBodies& bodies) const;
  double thickness(int body, int shape) const { return facts(body, shape).thickness; }
  double thinner(const ShapePair& pair) const;
  bool keeps_off_surface(const ShapePair& pair, const BulkBodies& bodies) const;
  float reach(int body, const float* linear, const float* angular) const;
  double path_on(int body, int other, const BulkBodies& bodies) const;
  bool is_far(const ShapePair& pair, double least, const BulkBodies& bodies) const;
  bool may_meet(int a, int b, const BulkBodies& bodies) const;
  BodyBoxes::Way way_of(int body, const BulkBodies& bodies) const;
  double share_of(int body, const BulkBodies& bodies) const {
    return bodies.is_dynamic(body) ? shares_[at(jointed_.groups()[at(body)])] : 1;
  }
  float find_reaches(const BulkBodies& bodies);
  float find_contacts(std::size_t pairs, const ManifoldList& manifolds);
  void find_pushed(const std::vector<ShapePair>& pairs, const ManifoldList& manifolds,
                   const BulkBodies& bodies);
  bool is_pushed(const ShapePair& pair) const;
  void find_far(const std::vector<ShapePair>& pairs, const ManifoldList& manifolds, double margin,
                const BulkBodies& bodies);
  void add_escaped(const std::vector<ShapePair>& pairs, double margin, double most, const BulkBodies& bodies);
  void add_followers(const std::vector<ShapePair>& pairs, const std::vector<int>& before,
                     const ManifoldList& manifolds, const BulkBodies& bodies);
  void sort_found();
  template <class NormalOf>
  void add_found(const NormalOf& normal_of);
  Vec3 normal_of(std::size_t pair, const ManifoldList& manifolds) const;
  void sweep_boxes(const BulkBodies& bodies);
  template <class Visit>
  void for_near(int body, const Visit& visit);
  bool bends(int body, const BulkBodies& bodies) const;
  BodyDisplacement point_at(int body, double t, const BulkBodies& bodies) const;
  ShapePath path_between(int body, int shape, double from, double to, const BulkBodies& bodies) const;
  FreePath free_share(const FarPair& pair, const BulkBodies& bodies) const;
  FreePath free_share_of_bent(const FarPair& pair, const BulkBodies& bodies) const;
  bool shorten(const FarPair& pair, BulkBodies& bodies);
  bool is_taken_along(int body, int driver, const BulkBodies& bodies) const;
  void take_along(int body, int driver, double share, BulkBodies& bodies);

  const Model* model_;
  int substeps_;  ///< Of each step.
  PairFilter filter_;
  std::function<bool(int, int)> may_touch_;
  ShapeRanges ranges_;
  std::vector<ShapeFacts> facts_;  ///< Of each shape.
  /// Facts of a shape, which stays where it is in memory as long as they are known.
  struct KnownShape {
    ShapeFacts facts = {};
    BodyShapes owner;
  };
  std::unordered_map<const BodyShape*, KnownShape> known_;
  std::vector<double> turning_;  ///< Of each body: how far from its centre rotation moves points [m].
  std::vector<char> is_driven_;  ///< Whether each body is kinematic.
  int driven_ = 0;               ///< How many bodies are.
  int dynamic_ = 0;              ///< How many forces move in this step.
  JointedBodies jointed_;
  /// That any pair may have at least [m], with those of bodies that are gone: it only saves time.
  double least_thickness_ = std::numeric_limits<double>::infinity();
  double thinnest_surface_ = std::numeric_limits<double>::infinity();  ///< Likewise [m].
  int surfaces_ = 0;  ///< How many shapes have been surfaces.
  bool has_jointed_ = false;
  BodyBoxes boxes_;
  JointedPaths paths_;
  bool may_need_parts_ = false;  ///< Whether there may be joints or kinematic bodies.
  /// Where a body goes at the velocities of the beginning.
  struct Plan {
    float dp[4], dr[4];
  };
  std::vector<Plan> planned_;     ///< Of each body.
  std::vector<float> reach_;      ///< How far points of each body have moved [m].
  std::vector<float> depths_;     ///< Overlap of each pair that was looked for at the beginning [m].
  std::vector<int> contacts_;     ///< A manifold of each of these pairs; -1: it has none.
  BulkIslands islands_;           ///< Of the manifolds, where a driven body moves.
  std::vector<char> is_pushed_;   ///< Whether one touches an island, by its lowest body; empty: none moves.
  std::vector<ShapePair> found_;  ///< That may be in far_ already.
  bool is_swept_ = false;         ///< Whether swept_ is of this step.
  std::vector<FloatBox> swept_;   ///< Boxes that the bodies do not leave in the step.
  BoxTree swept_tree_;            ///< Of swept_.
  long sweeps_ = 0;
  std::vector<int> near_;
  bool is_finite_ = true;
  std::vector<FarPair> far_;    ///< In ascending order.
  std::vector<double> shares_;  ///< Of the displacement of each body, by its group.
  std::vector<int> changes_;    ///< How often the displacement was changed, by its group.
  std::vector<Stopped> stopped_;
  std::vector<Jam> jams_;  ///< Of the last step, in the order in which they were found.
};

}  // namespace rigor
