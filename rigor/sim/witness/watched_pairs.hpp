#pragma once

#include "rigor/core/rounding.hpp"
#include "rigor/geometry/broad_phase/aabb_tree.hpp"
#include "rigor/model/model.hpp"
#include "rigor/model/state.hpp"
#include "rigor/sim/witness/marked_body.hpp"
#include "rigor/sim/witness/step_moves.hpp"

#include <memory>
#include <vector>

namespace rigor {

/// Finds in each step the pairs of bodies of which a marker of one may meet a shape of the other, with little
/// work for those that cannot. Two bounds are kept from step to step:
///
/// - Each body has a room: a box that its centre may not leave and a turn that it may not exceed. While all
///   bodies are in their rooms, only pairs whose boxes meet, grown by the rooms, can come near each other.
///   A body that leaves its room gets another one, ahead of where it goes, and is paired anew.
/// - Each of these pairs has a gap: no marker was nearer to an enclosure of the other body. By each step it
///   gets smaller by no more than they move against each other, |d_A - d_B| + turn_A + turn_B (StepMove), and
///   a marker that starts farther away than that from a shape cannot enter it in the step. When a gap is used
///   up it is measured again.
///
/// What is left out is therefore left out by proof; what is returned depends on the two States alone, up to
/// rounding and the sizes of rooms.
class WatchedPairs {
 public:
  struct Pair {
    int a, b;  ///< a < b.
    bool operator<(const Pair& other) const { return a != other.a ? a < other.a : b < other.b; }
  };

  WatchedPairs(std::shared_ptr<const Model> model, std::vector<std::shared_ptr<const MarkedBody>> marked);

  /// The body is no more where the last step ended.
  void forget(int body);
  /// The pairs that may meet in the step between two States, of which the first is where the last step ended,
  /// in ascending order.
  const std::vector<Pair>& meeting(const State& before, const State& after,
                                   const std::vector<StepMove>& moves);

 private:
  struct Room {
    /// Where the centre of mass may be, up to an arc [m]; at first nowhere.
    Aabb centres{Vec3::Constant(kInfinity), Vec3::Constant(-kInfinity)};
    double turn_left = 0;       ///< How far rotations may still move its points [m].
    double arc = 0;             ///< StepMove::arc is at most this [m].
    double share = 0.06;        ///< Of the radius, by which the box is larger than what was predicted.
    Vec3 first = Vec3::Zero();  ///< Displacement of the step in which it was made [m],
    int steps = 0;              ///< and how many there were since.
  };
  struct KeptPair {
    int a, b;
    double gap;  ///< [m].
  };
  struct Solid {
    int body, shape;
  };
  bool leaves_room(int body, const State& after, const StepMove& move);
  void make_room(int body, const State& before, const State& after, const StepMove& move);
  void update_trees();
  static Vec3 path_ahead(const Room& room, const Vec3& d);
  void pair_anew(int body);
  bool may_meet(KeptPair& pair, const State& before, const std::vector<StepMove>& moves) const;
  double gap(int a, int b, const State& state) const;

  std::shared_ptr<const Model> model_;
  std::vector<std::shared_ptr<const MarkedBody>> marked_;
  std::vector<int> moving_;               ///< Bodies that are not fixed.
  std::vector<Solid> solid_of_;           ///< All shapes, body by body.
  std::vector<std::size_t> first_solid_;  ///< Of each body in solid_of_; one more at the end.
  std::vector<Room> rooms_;               ///< Of each body; fixed ones never leave theirs.
  /// By shape: where its markers are while its body is in its room, and where the shape is.
  std::vector<Aabb> marker_boxes_, solid_boxes_;
  AabbTree marker_tree_, solid_tree_;
  bool has_trees_ = false;
  long moved_boxes_ = 0;  ///< Since the trees were made.
  std::vector<KeptPair> kept_;
  std::vector<Pair> meeting_;
  // Of a step:
  std::vector<int> left_;        ///< Bodies that left their rooms, in ascending order.
  std::vector<char> has_left_;   ///< The same, by body.
  long pairing_ = 0;             ///< How often a body was paired anew,
  std::vector<long> paired_in_;  ///< and by body the last time at which it was one of the others.
  std::vector<int> near_;
};

}  // namespace rigor
