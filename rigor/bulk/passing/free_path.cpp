#include "rigor/bulk/passing/free_path.hpp"

#include "rigor/core/index.hpp"
#include "rigor/geometry/convex/convex_distance.hpp"
#include "rigor/geometry/convex/simplex.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/geometry/motion/mesh_advance.hpp"
#include "rigor/geometry/motion/mesh_convex_advance.hpp"
#include "rigor/geometry/motion/separation_bound.hpp"
#include "rigor/geometry/shape/aabb.hpp"
#include "rigor/geometry/shape/convex_core.hpp"
#include "rigor/geometry/shape/support.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <variant>

namespace rigor {

namespace {

/// Whether the distance to the shape is one along a direction that separates all of it.
bool is_convex(const Shape& shape) {
  return !std::holds_alternative<Mesh>(shape) && !std::holds_alternative<Cavity>(shape);
}

bool is_bounded(const Shape& shape) {
  return is_convex(shape) && !is_unbounded(shape);
}
bool is_mesh(const Shape& shape) {
  return std::holds_alternative<Mesh>(shape);
}

/// Thickness of the thinner one. A sheet has none, but holds what touches it on the side on which its middle
/// is: of it the other's counts [m].
double thinner_of(const ShapePath& A, const ShapePath& B) {
  if (A.thickness == 0 || B.thickness == 0) return std::max(A.thickness, B.thickness);
  return std::min(A.thickness, B.thickness);
}

constexpr double deeper_share = 0.01;  ///< What is deep already may become deeper by this share.

/// What is known of two shapes where the first leg begins.
struct Beginning {
  double level;                      ///< How near they may come [m].
  std::optional<bool> overlap = {};  ///< Unknown where planes have parted them.
};

/// Where two shapes are at the beginning and at the end of their ways. Along a direction the lowest point of
/// a shape follows its chord but for what its rotation bends the ways of its points: those at the distance r
/// from the centre, by no more than r θ²/8.
class BothEnds {
 public:
  struct Places {
    Pose X_WA, X_WB;  ///< Of the shapes.
  };
  BothEnds(const ShapePath& A, const ShapePath& B)
      : A_(A), B_(B), begin_{A.X_WB * A.shape->X_BS, B.X_WB * B.shape->X_BS} {
    const double squared_A = A.dr_W.squaredNorm(), squared_B = B.dr_W.squaredNorm();
    turned_ = A.turning * std::sqrt(squared_A) + B.turning * std::sqrt(squared_B);
    bend_ = (A.turning * squared_A + B.turning * squared_B) / 8;
  }

  const Places& begin() const { return begin_; }
  const Places& end() {
    if (!end_) end_ = {end_of(A_), end_of(B_)};
    return *end_;
  }
  double bend() const { return bend_; }
  /// Whether both, which are bounded and convex, are at least `deepest_now` apart along n at the beginning,
  /// and `deepest` all along.
  bool parts(const Vec3& n, double deepest, double deepest_now) {
    const double now = apart(n, begin_);
    if (now < deepest_now || now - bend_ < deepest) return false;
    // Most are so far apart that it does not matter which way their points turn.
    if (now + std::min(0.0, n.dot(B_.dp_W - A_.dp_W)) - turned_ >= deepest) return true;
    return apart(n, end()) - bend_ >= deepest;
  }

 private:
  static Pose end_of(const ShapePath& path) {
    return TwistMotion(path.X_WB, path.dp_W, path.dr_W).sample(1).X_WB * path.shape->X_BS;
  }
  double apart(const Vec3& n, const Places& places) const {
    return n.dot(places.X_WB.p - places.X_WA.p) -
           support_value(A_.shape->shape, places.X_WA.R.transpose() * n) -
           support_value(B_.shape->shape, places.X_WB.R.transpose() * -n);
  }

  const ShapePath& A_;
  const ShapePath& B_;
  Places begin_;
  std::optional<Places> end_;  ///< Found when it is asked for.
  double turned_;              ///< No point is taken farther against the other body by rotations [m].
  double bend_;                ///< What these bend the ways of points [m].
};

/// Whether the balls about the centres of two bodies that hold their shapes do not meet. The centres go
/// straight.
bool are_balls_apart(const ShapePath& A, const ShapePath& B) {
  const Vec3 from = B.X_WB.p - A.X_WB.p, path = B.dp_W - A.dp_W;
  const double squared = path.squaredNorm();
  const double nearest = squared > 0 ? std::clamp(-from.dot(path) / squared, 0.0, 1.0) : 0;
  const auto radius_of = [](const BodyShape& shape) { return shape.X_BS.p.norm() + shape.radius; };
  const double radii = radius_of(*A.shape) + radius_of(*B.shape);
  return (from + nearest * path).squaredNorm() > radii * radii;
}

/// Whether a plane parts two convex shapes all along their ways, as far as they may overlap: it is seen
/// without their distance. Tried are planes across `likely`, unless that is zero, across the line of their
/// centres, and along the faces of boxes.
bool is_parted_by_plane(const ShapePath& A, const ShapePath& B, const Vec3& likely, double deepest,
                        double deepest_now) {
  if (are_balls_apart(A, B)) return true;
  BothEnds ends(A, B);
  // Shapes that touch are parted best across their contact.
  if (!likely.isZero(0) && ends.parts(likely, deepest, deepest_now)) return true;
  const Vec3 between = ends.begin().X_WB.p - ends.begin().X_WA.p;
  const double length = between.norm();
  // The line of the centres serves balls and whatever is far apart; then come the faces that boxes lie on.
  if (length > 0 && ends.parts(between / length, deepest, deepest_now)) return true;
  for (const bool is_A : {true, false}) {
    if (!std::holds_alternative<Box>((is_A ? A : B).shape->shape)) continue;
    for (int k = 0; k < 3; ++k) {
      const Vec3 n = (is_A ? ends.begin().X_WA : ends.begin().X_WB).R.col(k);
      if (ends.parts(n.dot(between) < 0 ? Vec3(-n) : n, deepest, deepest_now)) return true;
    }
  }
  return false;
}

/// The same of a mesh that does not turn and a convex shape: whether each triangle near its way is parted
/// from it, by its own plane, across the point nearest to the shape's centre, or along their distance at one
/// of the ends. A closed mesh must have its outside towards the centre where it is nearest, so that the shape
/// is not inside.
class MeshPlanes {
 public:
  MeshPlanes(const ShapePath& mesh_path, const ShapePath& path)
      : mesh_(std::get<Mesh>(mesh_path.shape->shape)),
        shape_(path.shape->shape),
        still_{mesh_path.shape, mesh_path.X_WB, Vec3::Zero(), Vec3::Zero(), 0, mesh_path.thickness},
        against_{path.shape, path.X_WB, path.dp_W - mesh_path.dp_W, path.dr_W, path.turning, path.thickness},
        ends_(still_, against_) {
    const Pose X_MW = ends_.begin().X_WA.inverse();
    X_MS_ = {X_MW * ends_.begin().X_WB, X_MW * ends_.end().X_WB};
  }

  bool part(double deepest, double deepest_now) const {
    const Aabb box = axis_aligned_box(shape_, X_MS_[0]).united(axis_aligned_box(shape_, X_MS_[1]));
    const Vec3& c = X_MS_[0].p;
    double nearest = std::numeric_limits<double>::infinity();
    bool is_outside = !mesh_.tree->is_closed;
    for (const int t : mesh_.tree->overlapping(box.grown(ends_.bend()))) {
      const std::array<int, 3>& vertices = mesh_.mesh->triangles[at(t)];
      const std::array<Vec3, 3> corners = {corner(vertices[0]), corner(vertices[1]), corner(vertices[2])};
      const Vec3& outward = mesh_.tree->triangles[at(t)].normal;
      const bool is_front = outward.dot(c - corners[0]) >= 0;
      const Vec3 to_nearest =
          nearest_on_triangle({corners[0] - c, corners[1] - c, corners[2] - c, Vec3::Zero()}, 0, 1, 2).v;
      const double distance = to_nearest.norm();
      if (mesh_.tree->is_closed && distance < nearest) is_outside = is_front;
      nearest = std::min(nearest, distance);
      const auto is_parted_along = [&](const Vec3& n) { return is_parted(n, corners, deepest, deepest_now); };
      if (is_parted_along(is_front ? outward : Vec3(-outward))) continue;
      if (distance > 0 && is_parted_along(-to_nearest / distance)) continue;
      const auto is_parted_by_distance = [&](const Pose& X_MS) {
        return is_parted_along(
            convex_distance(make_points_core(corners), Pose{}, make_core(shape_), X_MS).n_W);
      };
      if (!is_parted_by_distance(X_MS_[0]) && !is_parted_by_distance(X_MS_[1])) return false;
    }
    return is_outside;
  }

 private:
  const Vec3& corner(int v) const { return mesh_.mesh->vertices[at(v)]; }
  /// Whether the shape stays over what reaches highest along n of a triangle, in the frame of the mesh.
  bool is_parted(const Vec3& n, const std::array<Vec3, 3>& corners, double deepest,
                 double deepest_now) const {
    const double highest = std::max({n.dot(corners[0]), n.dot(corners[1]), n.dot(corners[2])});
    const auto height = [&](const Pose& X_MS) {
      return n.dot(X_MS.p) - highest - support_value(shape_, X_MS.R.transpose() * -n);
    };
    const double now = height(X_MS_[0]);
    return now >= deepest_now && now - ends_.bend() >= deepest && height(X_MS_[1]) - ends_.bend() >= deepest;
  }

  const Mesh& mesh_;
  const Shape& shape_;
  ShapePath still_, against_;
  BothEnds ends_;
  std::array<Pose, 2> X_MS_;
};

/// Whether planes show that two shapes stay apart all along their ways, as far as they may overlap.
bool are_parted(const ShapePath& A, const ShapePath& B, const Vec3& likely, double deepest,
                double deepest_now) {
  if (is_bounded(A.shape->shape) && is_bounded(B.shape->shape))
    return is_parted_by_plane(A, B, likely, deepest, deepest_now);
  for (const bool is_A : {true, false}) {
    const ShapePath &mesh = is_A ? A : B, &other = is_A ? B : A;
    if (is_mesh(mesh.shape->shape) && is_bounded(other.shape->shape) && mesh.dr_W.isZero(0))
      return MeshPlanes(mesh, other).part(deepest, deepest_now);
  }
  return false;
}

class Walk {
 public:
  Walk(const ShapePath& A, const ShapePath& B)
      : A_(A),
        B_(B),
        motion_A_(A.X_WB, A.dp_W, A.dr_W),
        motion_B_(B.X_WB, B.dp_W, B.dr_W),
        has_bound_(is_convex(A.shape->shape) && is_convex(B.shape->shape)),
        are_bounded_(is_bounded(A.shape->shape) && is_bounded(B.shape->shape)),
        is_mesh_and_convex_((is_mesh(A.shape->shape) && is_bounded(B.shape->shape)) ||
                            (is_mesh(B.shape->shape) && is_bounded(A.shape->shape))) {
    length_ = (A.dp_W - B.dp_W).norm() + A.turning * A.dr_W.norm() + B.turning * B.dr_W.norm();
    if (!has_bound_) return;
    core_A_ = make_moving_core(A.shape->shape, A.shape->X_BS, A.shape->radius, motion_A_);
    core_B_ = make_moving_core(B.shape->shape, B.shape->X_BS, B.shape->radius, motion_B_);
  }

  /// They may come as near as -`deep_share` of the thinner one's thickness. `beginning` is found where the
  /// first leg begins and kept on the others.
  double free(double deep_share, std::optional<Beginning>& beginning) const {
    constexpr double unseen_share = 0.5;
    constexpr int most_steps = 1000;
    const double thinner = thinner_of(A_, B_);
    // Of two convex shapes the thicker one is not skipped either.
    double unseen = unseen_share * thinner;
    if (has_bound_ && std::isfinite(std::max(A_.thickness, B_.thickness)))
      unseen = unseen_share * std::max(A_.thickness, B_.thickness);

    // Conservative advancement, no shorter than what no shape skips.
    double t = 0, last = 0;
    for (int k = 0; k < most_steps; ++k) {
      const DistanceResult now = distance(t);
      if (!beginning)
        beginning = {std::min(-deep_share * thinner, now.distance - deeper_share * thinner),
                     now.distance < 0};
      const double level = beginning->level;
      if (now.distance < level) return last_free(last, t, level);
      // No point goes farther than length_ in the whole interval.
      double step = (now.distance - level) / length_;
      if (t + step >= 1) return 1;
      // A plane across the direction of the distance may part them to the end; a bound along it allows longer
      // steps.
      if (are_bounded_ && is_rest_parted(t, now.n_W, level)) return 1;
      if (has_bound_) {
        const SeparationBound bound(*core_A_, *core_B_, now.n_W, now.distance, t, 1);
        step = std::max(step, bound.safe_step(1 - t, level));
        if (t + step >= 1) return 1;
      } else if (is_mesh_and_convex_) {
        step = std::max(step, mesh_step(t, now, -level));
        if (t + step >= 1) return 1;
      }
      last = t;
      if (t == 1) return 1;
      t = std::min(1.0, t + std::max(step, unseen / length_));
    }
    return last;
  }
  /// Of the shapes, after the part t of their ways.
  DistanceResult distance(double t) const {
    return signed_distance(A_.shape->shape, motion_A_.sample(t).X_WB * A_.shape->X_BS, B_.shape->shape,
                           motion_B_.sample(t).X_WB * B_.shape->X_BS);
  }

 private:
  /// How far a mesh and a convex shape go from t without overlapping by more than `slack`: what slides along
  /// a triangle is not stopped by it.
  double mesh_step(double t, const DistanceResult& now, double slack) const {
    // The bound wants the mesh first and the normal from it.
    const bool is_A = std::holds_alternative<Mesh>(A_.shape->shape);
    const MovingShape a{&A_.shape->shape, A_.shape->X_BS, &motion_A_},
        b{&B_.shape->shape, B_.shape->X_BS, &motion_B_};
    const Vec3 n_W = is_A ? now.n_W : Vec3(-now.n_W);
    const MeshAdvance from{t, 1, now.distance, 0, slack, slack, std::span(&n_W, 1)};
    return safe_mesh_convex_step(is_A ? a : b, is_A ? b : a, from);
  }
  /// Whether a plane across n parts both on the rest of their ways.
  bool is_rest_parted(double t, const Vec3& n, double level) const {
    const auto rest_of = [&](const ShapePath& path, const TwistMotion& motion) -> ShapePath {
      return {path.shape,          motion.sample(t).X_WB, (1 - t) * path.dp_W,
              (1 - t) * path.dr_W, path.turning,          path.thickness};
    };
    const ShapePath A = rest_of(A_, motion_A_), B = rest_of(B_, motion_B_);
    BothEnds ends(A, B);
    return ends.parts(n, level, level);
  }
  /// Between a time at which they may be there and one at which they overlap too much.
  double last_free(double low, double high, double level) const {
    constexpr int halvings = 20;
    // By bisection: the distance need not be monotonic, but one end is free and the other is not.
    for (int k = 0; k < halvings; ++k) {
      const double middle = 0.5 * (low + high);
      (distance(middle).distance < level ? high : low) = middle;
    }
    return low;
  }

  const ShapePath& A_;
  const ShapePath& B_;
  TwistMotion motion_A_, motion_B_;
  std::optional<MovingCore> core_A_, core_B_;  ///< If both are convex.
  bool has_bound_, are_bounded_, is_mesh_and_convex_;
  double length_;  ///< No point goes farther against the other body [m].
};

/// The part of the way that is free; `beginning` as in Walk.
double free_part(const ShapePath& A, const ShapePath& B, const Vec3& likely, double deep_share,
                 std::optional<Beginning>& beginning) {
  const double thinner = thinner_of(A, B);
  const double deepest = beginning ? beginning->level : -deep_share * thinner;
  if (are_parted(A, B, likely, deepest, beginning ? deepest : deepest + deeper_share * thinner)) {
    if (!beginning) beginning = {deepest};
    return 1;
  }
  return Walk(A, B).free(deep_share, beginning);
}

}  // namespace

FreePath free_path(const ShapePath& A, const ShapePath& B, double deep_share, const Vec3& likely_W) {
  std::optional<Beginning> beginning;
  const double part = free_part(A, B, likely_W, deep_share, beginning);
  return {part, beginning->overlap.value_or(false)};
}

FreePath free_segments(std::span<const PathSegment> legs, double deep_share, const Vec3& likely_W) {
  std::optional<Beginning> beginning;
  double gone = 0;
  for (const PathSegment& leg : legs) {
    const double part = free_part(leg.A, leg.B, likely_W, deep_share, beginning);
    gone += part;
    if (part == 1) continue;
    // Planes have parted them on the first leg, also where they overlapped a little.
    if (!beginning->overlap) beginning->overlap = Walk(legs[0].A, legs[0].B).distance(0).distance < 0;
    break;
  }
  return {gone, beginning && beginning->overlap.value_or(false)};
}

}  // namespace rigor
