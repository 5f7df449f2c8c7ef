#include "rigor/sim/witness/watched_pairs.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/rounding.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace rigor {

namespace {

/// Of the radius of a body: by how much its room is larger than what was predicted, and by how much its
/// points may turn in a step so that it is expected to go on turning little.
constexpr double least_share = 0.06, most_share = 0.3, steady_share = 0.01;
/// For how many steps it is predicted: some more than the last room lasted.
constexpr double least_ahead = 2, most_ahead = 12, ahead_factor = 1.5;
/// A room is left soon, or lasts, in steps.
constexpr int soon = 4, long_after = 12;

Aabb no_box() {
  return {Vec3::Constant(kInfinity), Vec3::Constant(-kInfinity)};
}

/// Box in W of markers of a body. What has none, as a sheet, is at its body: nothing meets it by them, and
/// all boxes are finite.
Aabb box_of(std::span<const Marker> markers, const Pose& X_WB) {
  if (markers.empty()) return {X_WB.p, X_WB.p};
  Aabb box = no_box();
  for (const Marker& marker : markers) {
    const Vec3 p_W = X_WB * marker.p_B;
    box = box.united({p_W, p_W});
  }
  return box;
}

/// The smallest gap between the markers of A and the enclosures of B [m].
double gap_of(const MarkedBody& A, const Pose& X_BA, const MarkedBody& B) {
  double least = kInfinity;
  for (const Marker& marker : A.markers) {
    const Vec3 p_B = X_BA * marker.p_B;
    for (const Enclosure& enclosure : B.enclosures) least = std::min(least, enclosure.gap(p_B));
  }
  return least;
}

void build(std::span<const Aabb> boxes, AabbTree& tree) {
  std::vector<BoxItem> items;
  for (std::size_t k = 0; k < boxes.size(); ++k) items.push_back({static_cast<int>(k), boxes[k]});
  tree.build(items);
}

Aabb sum(const Aabb& a, const Aabb& b) {
  return {a.lower + b.lower, a.upper + b.upper};
}

}  // namespace

WatchedPairs::WatchedPairs(std::shared_ptr<const Model> model,
                           std::vector<std::shared_ptr<const MarkedBody>> marked)
    : model_(std::move(model)), marked_(std::move(marked)) {
  rooms_.resize(marked_.size());
  has_left_.assign(marked_.size(), 0);
  paired_in_.assign(marked_.size(), 0);
  for (int i = 0; i < model_->body_count(); ++i) {
    const Body& body = model_->body(i);
    const Pose X_WB{rotation_matrix(body.q_WB), body.p_WB};
    first_solid_.push_back(solid_of_.size());
    for (int k = 0; k < static_cast<int>(body.shapes.size()); ++k) {
      const BodyShape& shape = body.shapes[at(k)];
      solid_of_.push_back({i, k});
      solid_boxes_.push_back(axis_aligned_box(shape.shape, X_WB * shape.X_BS));
      marker_boxes_.push_back(box_of(marked_[at(i)]->markers_of(k), X_WB));
    }
    if (body.motion != MotionType::fixed && !body.shapes.empty()) moving_.push_back(i);
  }
  first_solid_.push_back(solid_of_.size());
}

void WatchedPairs::forget(int body) {
  rooms_[at(body)] = Room{};
}

const std::vector<WatchedPairs::Pair>& WatchedPairs::meeting(const State& before, const State& after,
                                                             const std::vector<StepMove>& moves) {
  // Bodies that leave their rooms get others.
  left_.clear();
  for (const int i : moving_) {
    if (leaves_room(i, after, moves[at(i)])) left_.push_back(i);
  }
  for (const int i : left_) {
    has_left_[at(i)] = 1;
    make_room(i, before, after, moves[at(i)]);
  }

  // Their pairs are dropped; the others go on with what is left of their gaps.
  meeting_.clear();
  std::size_t count = 0;
  for (KeptPair& pair : kept_) {
    if ((has_left_[at(pair.a)] | has_left_[at(pair.b)]) != 0) continue;
    if (may_meet(pair, before, moves)) meeting_.push_back({pair.a, pair.b});
    kept_[count++] = pair;
  }
  kept_.resize(count);

  // New pairs have no gap yet.
  if (!left_.empty()) update_trees();
  for (const int i : left_) pair_anew(i);
  for (std::size_t k = count; k < kept_.size(); ++k) {
    if (may_meet(kept_[k], before, moves)) meeting_.push_back({kept_[k].a, kept_[k].b});
  }
  for (const int i : left_) has_left_[at(i)] = 0;
  std::sort(meeting_.begin(), meeting_.end());
  return meeting_;
}

/// The way is in the box of the centres if both of its ends are, but for its arc.
bool WatchedPairs::leaves_room(int i, const State& after, const StepMove& move) {
  Room& room = rooms_[at(i)];
  const Vec3 x = after.position(i);
  room.turn_left -= move.turn;
  ++room.steps;
  // What is no number leaves.
  return !(room.turn_left >= 0 && move.arc <= room.arc && (room.centres.lower.array() <= x.array()).all() &&
           (x.array() <= room.centres.upper.array()).all());
}

/// Where a body goes on as in this step, and is as much faster then as it has become since its last room, if
/// that is not more than it has.
Vec3 WatchedPairs::path_ahead(const Room& room, const Vec3& d) {
  if (room.steps == 0) return least_ahead * d;
  const double steps = std::clamp(ahead_factor * room.steps, least_ahead, most_ahead);
  const Vec3 gain = 0.5 * steps / room.steps * (d - room.first);
  const double most = d.norm(), more = gain.norm();
  return steps * (d + (more > most ? most / more : 1) * gain);
}

void WatchedPairs::make_room(int i, const State& before, const State& after, const StepMove& move) {
  const MarkedBody& marked = *marked_[at(i)];
  const double radius = model_->body(i).bounding_radius;
  Room& room = rooms_[at(i)];
  // Who soon left the last room gets a larger one.
  if (room.steps > 0 && room.steps < soon) room.share = std::min(2 * room.share, most_share);
  if (room.steps > long_after) room.share = std::max(0.5 * room.share, least_share);
  const double spare = room.share * radius;
  // The box holds this step and what is ahead.
  const Vec3 from = before.position(i), to = after.position(i), ahead = to + path_ahead(room, move.d);
  room.centres = Aabb{from.cwiseMin(to).cwiseMin(ahead), from.cwiseMax(to).cwiseMax(ahead)}.grown(spare);
  room.first = move.d;
  room.steps = 0;

  // A body that turns much may have any orientation. The others have the one of the end, up to the turn that
  // is left to them and the one of this step.
  const bool is_steady = move.turn <= steady_share * radius && std::isfinite(radius);
  room.turn_left = is_steady ? spare : kInfinity;
  room.arc = std::max(spare, move.arc);
  const Pose X_WB{rotation_matrix(after.orientation(i)), Vec3::Zero()};
  const double turn = spare + move.turn;
  for (std::size_t k = first_solid_[at(i)]; k < first_solid_[at(i) + 1]; ++k) {
    const int shape = solid_of_[k].shape;
    if (is_steady) {
      marker_boxes_[k] = sum(room.centres, box_of(marked.markers_of(shape), X_WB).grown(turn));
      solid_boxes_[k] = sum(room.centres, marked.enclosures[at(shape)].box(X_WB).grown(turn));
    } else {
      marker_boxes_[k] = room.centres.grown(marked.offset + room.arc);
      solid_boxes_[k] = room.centres.grown(radius + room.arc);
    }
  }
}

/// The trees are made anew now and then: they get worse the farther the boxes move.
void WatchedPairs::update_trees() {
  constexpr long most_moves = 64;  // Of each box.
  constexpr std::size_t few = 32;  // One of so many is put in its place by itself.
  const long count = static_cast<long>(solid_of_.size());
  if (!has_trees_ || moved_boxes_ >= most_moves * count) {
    // What is near by its solid is near by its markers: both trees have the same structure.
    build(solid_boxes_, solid_tree_);
    marker_tree_ = solid_tree_;
    marker_tree_.refit(marker_boxes_);
    has_trees_ = true;
    moved_boxes_ = 0;
  } else if (few * left_.size() > solid_of_.size()) {
    solid_tree_.refit(solid_boxes_);
    marker_tree_.refit(marker_boxes_);
    moved_boxes_ += count;
  } else {
    for (const int i : left_) {
      for (std::size_t k = first_solid_[at(i)]; k < first_solid_[at(i) + 1]; ++k) {
        solid_tree_.set(static_cast<int>(k), solid_boxes_[k]);
        marker_tree_.set(static_cast<int>(k), marker_boxes_[k]);
      }
    }
  }
}

/// Adds the pairs of a body that left its room: of its markers with other solids, and of its solids with
/// other markers.
void WatchedPairs::pair_anew(int i) {
  ++pairing_;
  const auto add = [&](int solid) {
    const int other = solid_of_[at(solid)].body;
    if (other == i || paired_in_[at(other)] == pairing_) return;
    paired_in_[at(other)] = pairing_;
    // Of two that left, the first has found the other.
    if ((has_left_[at(other)] != 0 && other < i) || !model_->may_collide(i, other)) return;
    kept_.push_back({std::min(i, other), std::max(i, other), 0});
  };
  for (std::size_t k = first_solid_[at(i)]; k < first_solid_[at(i) + 1]; ++k) {
    solid_tree_.overlapping(marker_boxes_[k], near_);
    for (const int solid : near_) add(solid);
    marker_tree_.overlapping(solid_boxes_[k], near_);
    // Unbounded solids are in this tree by the boxes of their solids.
    for (const int solid : near_) {
      if (marker_boxes_[at(solid)].overlaps(solid_boxes_[k])) add(solid);
    }
  }
}

/// Takes the step off the gap, and measures it anew where nothing is left. False proves that no marker enters
/// the other body.
bool WatchedPairs::may_meet(KeptPair& pair, const State& before, const std::vector<StepMove>& moves) const {
  const StepMove &A = moves[at(pair.a)], &B = moves[at(pair.b)];
  const double approach = (A.d - B.d).norm() + A.turn + B.turn;
  pair.gap -= approach;
  if (pair.gap > 0) return false;
  pair.gap = gap(pair.a, pair.b, before) - approach;
  if (pair.gap > 0) return false;
  pair.gap = 0;
  // Balls round bodies that pass beside each other, on straight ways up to their arcs.
  const Vec3 begin = before.position(pair.a) - before.position(pair.b), d = A.d - B.d;
  const double square = d.squaredNorm();
  const double nearest = square > 0 ? std::clamp(-begin.dot(d) / square, 0.0, 1.0) : 0;
  const double reach = model_->body(pair.a).bounding_radius + model_->body(pair.b).bounding_radius;
  return !((begin + nearest * d).norm() > reach + A.arc + B.arc);
}

/// The smallest gap between the markers of one and the enclosures of the other [m].
double WatchedPairs::gap(int a, int b, const State& state) const {
  const MarkedBody &A = *marked_[at(a)], &B = *marked_[at(b)];
  // What no rotation moves is seen without it.
  Pose X_AB{Mat3::Identity(), state.position(b) - state.position(a)};
  if (A.turning > 0 || B.turning > 0) {
    const Pose X_WA{rotation_matrix(state.orientation(a)), state.position(a)};
    const Pose X_WB{rotation_matrix(state.orientation(b)), state.position(b)};
    X_AB = X_WA.inverse() * X_WB;
  }
  return std::min(gap_of(A, X_AB.inverse(), B), gap_of(B, X_AB, A));
}

}  // namespace rigor
