#include "rigor/bulk/passing/free_way.hpp"

#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/motion/mesh_advance.hpp"
#include "rigor/geometry/motion/mesh_convex_advance.hpp"
#include "rigor/geometry/motion/separation_bound.hpp"

#include <algorithm>
#include <cmath>
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

class Walk {
 public:
  Walk(const WayOfShape& A, const WayOfShape& B)
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

  double free(double deep_share) const {
    constexpr double deeper_share = 0.05, unseen_share = 0.5;
    constexpr int most_steps = 1000;
    const double thinner = std::min(A_.thickness, B_.thickness);
    // Of two convex shapes the thicker one is not skipped either.
    double unseen = unseen_share * thinner;
    if (has_bound_ && std::isfinite(std::max(A_.thickness, B_.thickness)))
      unseen = unseen_share * std::max(A_.thickness, B_.thickness);

    // Conservative advancement, no shorter than what no shape skips.
    double t = 0, last = 0, level = 0;
    for (int k = 0; k < most_steps; ++k) {
      const DistanceResult now = distance(t);
      if (k == 0) level = std::min(-deep_share * thinner, now.distance - deeper_share * thinner);
      if (now.distance < level) return last_free(last, t, level);
      double step = (now.distance - level) / length_;
      if (t + step >= 1) return 1;
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
    for (int k = 0; k < halvings; ++k) {
      const double middle = 0.5 * (low + high);
      (distance(middle).distance < level ? high : low) = middle;
    }
    return low;
  }

  const WayOfShape& A_;
  const WayOfShape& B_;
  TwistMotion motion_A_, motion_B_;
  MovingCore core_A_, core_B_;
  bool has_bound_, is_mesh_and_convex_;
  double length_;  ///< No point goes farther against the other body [m].
};

}  // namespace

double free_way(const WayOfShape& A, const WayOfShape& B, double deep_share) {
  return Walk(A, B).free(deep_share);
}

}  // namespace rigor
