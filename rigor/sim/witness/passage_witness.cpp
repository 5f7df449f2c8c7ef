#include "rigor/sim/witness/passage_witness.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/core/rounding.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/geometry/rays/ray_cast.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

constexpr double largest_turn = 0.5;  // Of a chord [rad].
constexpr int most_halvings = 24;

/// Whether a ray that hits there goes from outside into the solid; an open surface has no outside.
bool goes_in(const Shape& shape, const RayHit& hit) {
  const Mesh* mesh = std::get_if<Mesh>(&shape);
  return hit.enters || (mesh != nullptr && !mesh->tree->is_closed);
}

/// One marker as seen from another body, where both have one piece of path.
class Pursuit {
 public:
  Pursuit(const PathPiece& of_marker, const Vec3& p_B, double clearance, const PathPiece& of_solid,
          const Body& solid, const BodyShape& shape)
      : of_marker_(of_marker),
        p_B_(p_B),
        offset_(p_B.norm()),
        clearance_(clearance),
        of_solid_(of_solid),
        solid_(solid),
        shape_(shape) {}

  /// When the marker first enters the solid in [ta, tb] [s].
  std::optional<double> first_entry(double ta, double tb) const {
    return between(ta, seen(ta), tb, seen(tb), 0);
  }

 private:
  Vec3 seen(double t) const { return of_solid_.pose(t).inverse() * Vec3(of_marker_.pose(t) * p_B_); }

  /// Whether the boxes of the marker's way and of the solid's meet.
  bool may_meet(double ta, double tb) const {
    if (std::isinf(solid_.bounding_radius)) return true;
    // The arm of the marker at ta, which turns by no more than a diameter.
    const Vec3 arm_W = of_marker_.pose(ta).R * p_B_;
    const double sway = offset_ * std::min(2.0, of_marker_.angular_speed() * (tb - ta));
    const Aabb centre = of_marker_.centre_box(ta, tb);
    return Aabb{centre.lower + arm_W, centre.upper + arm_W}.grown(sway).overlaps(
        of_solid_.centre_box(ta, tb).grown(solid_.bounding_radius));
  }

  /// Between two instants at which the marker is seen at a and b.
  std::optional<double> between(double ta, const Vec3& a, double tb, const Vec3& b, int halvings) const {
    if (!may_meet(ta, tb)) return std::nullopt;
    const double tm = 0.5 * (ta + tb);
    const Vec3 m = seen(tm);
    const double turn =
        (tb - ta) * std::max(of_solid_.angular_speed(), offset_ > 0 ? of_marker_.angular_speed() : 0.0);
    const bool is_straight = turn <= largest_turn && (m - 0.5 * (a + b)).norm() <= 0.25 * clearance_;
    if (!is_straight && halvings < most_halvings) {
      constexpr int many_chords = 8;
      if (halvings == many_chords) poll_interrupt();
      if (const auto early = between(ta, a, tm, m, halvings + 1)) return early;
      return between(tm, m, tb, b, halvings + 1);
    }
    if (a == b) return std::nullopt;
    const std::optional<double> share = entry_of_chord(a, b);
    if (!share) return std::nullopt;
    return ta + *share * (tb - ta);
  }

  std::optional<double> entry_of_chord(const Vec3& a, const Vec3& b) const {
    for (const RayHit& hit : find_ray_hits(shape_.shape, shape_.X_BS, {a, b - a, 1})) {
      if (goes_in(shape_.shape, hit)) return hit.fraction;
    }
    return std::nullopt;
  }

  const PathPiece& of_marker_;
  Vec3 p_B_;
  double offset_, clearance_;
  const PathPiece& of_solid_;
  const Body& solid_;
  const BodyShape& shape_;
};

Aabb box_of(const BodyPath& path) {
  // Nothing is found of a body without a path, wherever its box is.
  if (path.empty()) return {Vec3::Zero(), Vec3::Zero()};
  Aabb box{Vec3::Constant(kInfinity), Vec3::Constant(-kInfinity)};
  for (const PathPiece& piece : path) box = box.united(piece.centre_box(piece.begin(), piece.end()));
  return box;
}

}  // namespace

PassageWitness::PassageWitness(std::shared_ptr<const Model> model)
    : model_(std::move(model)), environment_(*model_) {
  for (int i = 0; i < model_->body_count(); ++i) {
    std::vector<Marker> markers;
    double offset = 0;
    for (const BodyShape& shape : model_->body(i).shapes) {
      for (const InnerPoint& inner : inner_points(shape.shape)) {
        markers.push_back({shape.X_BS * inner.p_S, inner.clearance});
        // Rounding of the frame must not make the middle of a body one that the rotation moves.
        if (markers.back().p_B.norm() <= 1e-9 * inner.clearance) markers.back().p_B.setZero();
        offset = std::max(offset, markers.back().p_B.norm());
      }
    }
    const Body& body = model_->body(i);
    const Pose X_WB{rotation_matrix(body.q_WB), body.p_WB};
    for (int k = 0; k < static_cast<int>(body.shapes.size()); ++k) {
      const BodyShape& shape = body.shapes[at(k)];
      solid_of_.push_back({i, k});
      solids_.push_back(axis_aligned_box(shape.shape, X_WB * shape.X_BS));
    }
    markers_.push_back(std::move(markers));
    offset_.push_back(offset);
  }
}

/// The first time at which a marker of body a enters a shape of body b.
std::optional<double> PassageWitness::entry_of(int a, const Solid& solid, const BodyPath& of_a,
                                               const BodyPath& of_b) const {
  std::optional<double> first;
  // Where pieces of both overlap in time; both lists are in order.
  for (auto i = of_a.begin(), j = of_b.begin(); i != of_a.end() && j != of_b.end() && !first;) {
    const double begin = std::max(i->begin(), j->begin()), end = std::min(i->end(), j->end());
    for (const Marker& marker : markers_[at(a)]) {
      // What the unknown orientation of either body would move is not followed.
      const double sway = i->knows_orientation() ? 0 : marker.p_B.norm();
      if (!(end > begin) || !j->knows_orientation() || sway > 0.25 * marker.clearance) continue;
      const Body& b = model_->body(solid.body);
      const Pursuit pursuit(*i, marker.p_B, marker.clearance, *j, b, b.shapes[at(solid.shape)]);
      const std::optional<double> entry = pursuit.first_entry(begin, first ? *first : end);
      if (entry) first = entry;
    }
    i->end() < j->end() ? ++i : ++j;
  }
  return first;
}

/// Enters the passages of the pairs of which the box of a body's markers along their ways meets that of a
/// solid. `pieces` gives the path of a body.
template <class Pieces>
void PassageWitness::watch_ways(std::span<const Aabb> ways, const Pieces& pieces, AdvanceReport& report) {
  // The tree is made anew now and then: it gets worse the farther the boxes move.
  constexpr long refits = 64;
  if (watches_++ % refits == 0) {
    std::vector<BoxItem> items;
    for (std::size_t k = 0; k < solids_.size(); ++k) items.push_back({static_cast<int>(k), solids_[k]});
    tree_.clear();
    tree_.build(items);
  } else {
    tree_.refit(solids_);
  }

  // Each body's markers against the solids whose boxes its way meets.
  std::vector<int> near;
  for (int a = 0; a < model_->body_count(); ++a) {
    if (markers_[at(a)].empty()) continue;
    tree_.overlapping(ways[at(a)], near);
    for (const int k : near) {
      const Solid& solid = solid_of_[at(k)];
      if (solid.body == a || !model_->may_collide(a, solid.body)) continue;
      const auto entry = entry_of(a, solid, pieces(a), pieces(solid.body));
      if (entry) report.note_passage(a, solid.body, *entry);
    }
  }
}

void PassageWitness::watch(std::span<const BodyPath> paths, AdvanceReport& report) {
  std::vector<Aabb> ways;
  for (const BodyPath& path : paths) ways.push_back(box_of(path));
  for (std::size_t k = 0; k < solids_.size(); ++k) {
    const Body& body = model_->body(solid_of_[k].body);
    if (body.motion != MotionType::fixed)
      solids_[k] = ways[at(solid_of_[k].body)].grown(body.bounding_radius);
  }
  for (std::size_t i = 0; i < ways.size(); ++i) ways[i] = ways[i].grown(offset_[i]);
  const auto path_of = [&](int body) -> const BodyPath& { return paths[at(body)]; };
  watch_ways(ways, path_of, report);
}

PathPiece PassageWitness::way_of(int i, const State& before, const State& after) const {
  const Body& body = model_->body(i);
  const double h = after.t - before.t;
  StraightWay way =
      straight_way(before.position(i), before.orientation(i), after.position(i), after.orientation(i),
                   angular_velocity(*model_, before, i), angular_velocity(*model_, after, i), h);
  way.keeps_axis = body.motion != MotionType::dynamic;
  constexpr double little = 0.5;  // What turns by less keeps near its axis [rad].
  if (way.keeps_axis || way.turn_W.norm() <= little) return {before.t, after.t, way};

  // The flight with the momenta of the end, after what impacts there may have been at the beginning: if it
  // leads from the one place to the other, it is what happened.
  const BodyInertia inertia{body.mass, body.moments};
  const Vec3 a_W = environment_.steady_acceleration(i);
  const BodyPhase start{before.position(i), before.orientation(i),
                        after.linear_momentum(i) - h * body.mass * a_W, after.angular_momentum(i)};
  const FreeFlight flight(inertia, start, before.t, a_W);
  const BodyPhase end = flight.at(after.t);
  constexpr double same = 1e-6;
  const bool flew =
      (end.x - way.to).norm() <= same * (way.to - way.from).norm() + same * body.bounding_radius &&
      std::abs(end.q.dot(after.orientation(i))) >= 1 - same;
  return flew ? PathPiece(before.t, after.t, Motion::flight(flight, inertia))
              : PathPiece(before.t, after.t, way);
}

void PassageWitness::watch(const State& before, const State& after, AdvanceReport& report) {
  if (!(after.t > before.t)) return;
  // Where the centres go, straight or in flight.
  const double h = after.t - before.t;
  std::vector<Aabb> ways;
  for (int i = 0; i < model_->body_count(); ++i) {
    const Vec3 from = before.position(i), to = after.position(i);
    // What is not finite stops the run by itself.
    if (!to.allFinite() || !after.orientation(i).coeffs().allFinite() ||
        !after.angular_momentum(i).allFinite())
      return;
    const double sag = model_->body(i).motion == MotionType::dynamic
                           ? 0.125 * h * h * environment_.steady_acceleration(i).norm()
                           : 0;
    ways.push_back(Aabb{from.cwiseMin(to), from.cwiseMax(to)}.grown(sag));
  }

  // What turns by little lies within its boxes at both ends, and between them by the sagitta of its arc.
  constexpr double little = 0.5;  // [rad].
  std::size_t k = 0;
  for (int i = 0; i < model_->body_count(); ++i) {
    const Body& body = model_->body(i);
    const std::size_t first = k;
    k += body.shapes.size();
    const bool is_fixed = body.motion == MotionType::fixed;
    const double turn =
        h * std::max(angular_velocity(*model_, before, i).norm(), angular_velocity(*model_, after, i).norm());
    if (!is_fixed && (!(turn <= little) || std::isinf(body.bounding_radius))) {
      std::fill(solids_.begin() + static_cast<std::ptrdiff_t>(first),
                solids_.begin() + static_cast<std::ptrdiff_t>(k), ways[at(i)].grown(body.bounding_radius));
      ways[at(i)] = ways[at(i)].grown(offset_[at(i)]);
      continue;
    }
    const Pose at_begin{rotation_matrix(before.orientation(i)), before.position(i)};
    const Pose at_end{rotation_matrix(after.orientation(i)), after.position(i)};
    for (std::size_t n = first; n < k && !is_fixed; ++n) {
      const BodyShape& shape = body.shapes[n - first];
      solids_[n] = axis_aligned_box(shape.shape, at_begin * shape.X_BS)
                       .united(axis_aligned_box(shape.shape, at_end * shape.X_BS))
                       .grown(turn * turn * body.bounding_radius);
    }
    for (const Marker& marker : markers_[at(i)]) {
      const Vec3 p = at_begin * marker.p_B, q = at_end * marker.p_B;
      ways[at(i)] = ways[at(i)].united({p.cwiseMin(q), p.cwiseMax(q)});
    }
    ways[at(i)] = ways[at(i)].grown(turn * turn * offset_[at(i)]);
  }

  // Paths are made of the few bodies that come near another.
  std::vector<BodyPath> paths(at(model_->body_count()));
  const auto path_of = [&](int body) -> const BodyPath& {
    BodyPath& path = paths[at(body)];
    if (path.empty()) path.push_back(way_of(body, before, after));
    return path;
  };
  watch_ways(ways, path_of, report);
}

}  // namespace rigor
