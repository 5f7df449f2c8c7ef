#include "rigor/bulk/passing/free_path.hpp"

#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/motion/mesh_advance.hpp"
#include "rigor/geometry/motion/mesh_convex_advance.hpp"
#include "rigor/geometry/motion/separation_bound.hpp"
#include "rigor/geometry/shape/support.hpp"

#include <algorithm>
#include <cmath>
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

constexpr double deeper_share = 0.01;  ///< What is deep already may become deeper by this share.

/// What is known of two shapes where the first leg begins.
struct Beginning {
  double level;  ///< How near they may come [m].
  bool overlap = false;
};

/// Whether a plane parts two shapes all along their ways, as far as they may overlap: it is seen without
/// their distance. Tried are planes across the line of their centres, and along the faces of boxes.
class PartingPlane {
 public:
  PartingPlane(const ShapePath& A, const ShapePath& B)
      : A_(A), B_(B), X_WA_(A.X_WB * A.shape->X_BS), X_WB_(B.X_WB * B.shape->X_BS) {
    // No point of either shape moves farther than this by the rotations of the bodies.
    turned_ = A.turning * A.dr_W.norm() + B.turning * B.dr_W.norm();
  }
  bool is_there(double deepest, double deepest_now) const {
    if (!is_bounded(A_.shape->shape) || !is_bounded(B_.shape->shape)) return false;
    const Vec3 between = X_WB_.p - X_WA_.p;
    // Along n the shapes are as far apart as their centres less their extents; along the way that changes by
    // the displacements along n and by rotations.
    const auto parts = [&](const Vec3& n) {
      const double now = n.dot(between) - support_value(A_.shape->shape, X_WA_.R.transpose() * n) -
                         support_value(B_.shape->shape, X_WB_.R.transpose() * -n);
      return now >= deepest_now && now + std::min(0.0, n.dot(B_.dp_W - A_.dp_W)) - turned_ >= deepest;
    };
    const double length = between.norm();
    // The line of the centres first, since it serves balls and whatever is far apart; then the faces that
    // boxes lie on.
    if (length > 0 && parts(between / length)) return true;
    for (const bool is_A : {true, false}) {
      if (!std::holds_alternative<Box>((is_A ? A_ : B_).shape->shape)) continue;
      for (int k = 0; k < 3; ++k) {
        const Vec3 n = (is_A ? X_WA_ : X_WB_).R.col(k);
        if (parts(n.dot(between) < 0 ? Vec3(-n) : n)) return true;
      }
    }
    return false;
  }

 private:
  const ShapePath& A_;
  const ShapePath& B_;
  Pose X_WA_, X_WB_;
  double turned_;
};

class Walk {
 public:
  Walk(const ShapePath& A, const ShapePath& B)
      : A_(A),
        B_(B),
        motion_A_(A.X_WB, A.dp_W, A.dr_W),
        motion_B_(B.X_WB, B.dp_W, B.dr_W),
        core_A_(make_moving_core(A.shape->shape, A.shape->X_BS, A.shape->radius, motion_A_)),
        core_B_(make_moving_core(B.shape->shape, B.shape->X_BS, B.shape->radius, motion_B_)),
        has_bound_(is_convex(A.shape->shape) && is_convex(B.shape->shape)),
        is_mesh_and_convex_((is_mesh(A.shape->shape) && is_bounded(B.shape->shape)) ||
                            (is_mesh(B.shape->shape) && is_bounded(A.shape->shape))) {
    length_ = (A.dp_W - B.dp_W).norm() + A.turning * A.dr_W.norm() + B.turning * B.dr_W.norm();
  }

  /// They may come as near as -`deep_share` of the thinner one's thickness. `beginning` is found where the
  /// first leg begins and kept on the others.
  double free(double deep_share, std::optional<Beginning>& beginning) const {
    constexpr double unseen_share = 0.5;
    constexpr int most_steps = 1000;
    const double thinner = std::min(A_.thickness, B_.thickness);
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
      // A bound along the direction of the distance allows longer steps.
      if (has_bound_) {
        const SeparationBound bound(core_A_, core_B_, now.n_W, now.distance, t, 1);
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
  DistanceResult distance(double t) const {
    return signed_distance(A_.shape->shape, motion_A_.sample(t).X_WB * A_.shape->X_BS, B_.shape->shape,
                           motion_B_.sample(t).X_WB * B_.shape->X_BS);
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
  MovingCore core_A_, core_B_;
  bool has_bound_, is_mesh_and_convex_;
  double length_;  ///< No point goes farther against the other body [m].
};

/// The part of the way that is free; `beginning` as in Walk.
double free_part(const ShapePath& A, const ShapePath& B, double deep_share,
                 std::optional<Beginning>& beginning) {
  const double thinner = std::min(A.thickness, B.thickness);
  const double deepest = beginning ? beginning->level : -deep_share * thinner;
  if (PartingPlane(A, B).is_there(deepest, beginning ? deepest : deepest + deeper_share * thinner)) {
    if (!beginning) beginning = {deepest};
    return 1;
  }
  return Walk(A, B).free(deep_share, beginning);
}

}  // namespace

FreePath free_path(const ShapePath& A, const ShapePath& B, double deep_share) {
  std::optional<Beginning> beginning;
  const double part = free_part(A, B, deep_share, beginning);
  return {part, beginning->overlap};
}

FreePath free_segments(std::span<const PathSegment> legs, double deep_share) {
  std::optional<Beginning> beginning;
  double gone = 0;
  for (const PathSegment& leg : legs) {
    const double part = free_part(leg.A, leg.B, deep_share, beginning);
    gone += part;
    if (part < 1) break;
  }
  return {gone, beginning && beginning->overlap};
}

}  // namespace rigor
