#include "rigor/sim/witness/passage_witness.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/core/rounding.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/geometry/rays/ray_cast.hpp"

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
          const Body& solid)
      : of_marker_(of_marker),
        p_B_(p_B),
        offset_(p_B.norm()),
        clearance_(clearance),
        of_solid_(of_solid),
        solid_(solid) {}

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
      if (const auto early = between(ta, a, tm, m, halvings + 1)) return early;
      return between(tm, m, tb, b, halvings + 1);
    }
    if (a == b) return std::nullopt;
    const std::optional<double> share = entry_of_chord(a, b);
    if (!share) return std::nullopt;
    return ta + *share * (tb - ta);
  }

  std::optional<double> entry_of_chord(const Vec3& a, const Vec3& b) const {
    std::optional<double> first;
    for (const BodyShape& shape : solid_.shapes) {
      for (const RayHit& hit : find_ray_hits(shape.shape, shape.X_BS, {a, b - a, 1})) {
        if (goes_in(shape.shape, hit) && (!first || hit.fraction < *first)) first = hit.fraction;
      }
    }
    return first;
  }

  const PathPiece& of_marker_;
  Vec3 p_B_;
  double offset_, clearance_;
  const PathPiece& of_solid_;
  const Body& solid_;
};

Aabb box_of(const BodyPath& path, double margin) {
  Aabb box{Vec3::Constant(kInfinity), Vec3::Constant(-kInfinity)};
  for (const PathPiece& piece : path) box = box.united(piece.centre_box(piece.begin(), piece.end()));
  return box.grown(margin);
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
    markers_.push_back(std::move(markers));
    offset_.push_back(offset);
  }
}

/// The first time at which a marker of body a enters body b.
std::optional<double> PassageWitness::entry_of(int a, int b, const BodyPath& of_a,
                                               const BodyPath& of_b) const {
  std::optional<double> first;
  // Where pieces of both overlap in time; both lists are in order.
  for (auto i = of_a.begin(), j = of_b.begin(); i != of_a.end() && j != of_b.end() && !first;) {
    const double begin = std::max(i->begin(), j->begin()), end = std::min(i->end(), j->end());
    for (const Marker& marker : markers_[at(a)]) {
      // What the unknown orientation of either body would move is not followed.
      const double sway = i->knows_orientation() ? 0 : marker.p_B.norm();
      if (!(end > begin) || !j->knows_orientation() || sway > 0.25 * marker.clearance) continue;
      const Pursuit pursuit(*i, marker.p_B, marker.clearance, *j, model_->body(b));
      const std::optional<double> entry = pursuit.first_entry(begin, first ? *first : end);
      if (entry) first = entry;
    }
    i->end() < j->end() ? ++i : ++j;
  }
  return first;
}

void PassageWitness::watch(std::span<const BodyPath> paths, AdvanceReport& report) {
  // The boxes that hold the solids along their paths.
  std::vector<BoxItem> solids;
  for (int i = 0; i < model_->body_count(); ++i) {
    if (paths[at(i)].empty() || model_->body(i).shapes.empty()) continue;
    solids.push_back({i, box_of(paths[at(i)], model_->body(i).bounding_radius)});
  }
  tree_.clear();
  tree_.build(solids);

  // Each body's markers against the solids whose boxes its way meets.
  std::vector<int> near;
  for (int a = 0; a < model_->body_count(); ++a) {
    if (markers_[at(a)].empty() || paths[at(a)].empty()) continue;
    poll_interrupt();
    tree_.overlapping(box_of(paths[at(a)], offset_[at(a)]), near);
    for (const int b : near) {
      if (b == a || !model_->may_collide(a, b)) continue;
      const auto entry = entry_of(a, b, paths[at(a)], paths[at(b)]);
      if (entry) report.note_passage(a, b, *entry);
    }
  }
}

PathPiece PassageWitness::way_of(int i, const State& before, const State& after) const {
  const Body& body = model_->body(i);
  const double h = after.t - before.t;
  StraightWay way =
      straight_way(before.position(i), before.orientation(i), after.position(i), after.orientation(i),
                   angular_velocity(*model_, before, i), angular_velocity(*model_, after, i), h);
  way.keeps_axis = body.motion != MotionType::dynamic;
  if (way.keeps_axis) return {before.t, after.t, way};

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
  std::vector<BodyPath> paths(at(model_->body_count()));
  for (int i = 0; i < model_->body_count(); ++i) {
    if (model_->body(i).shapes.empty()) continue;
    // What is not finite stops the run by itself.
    if (!after.position(i).allFinite() || !after.orientation(i).coeffs().allFinite()) continue;
    if (!after.angular_momentum(i).allFinite()) continue;
    paths[at(i)].push_back(way_of(i, before, after));
  }
  watch(paths, report);
}

}  // namespace rigor
