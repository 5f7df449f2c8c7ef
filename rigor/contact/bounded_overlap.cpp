#include "rigor/contact/bounded_overlap.hpp"

#include "rigor/contact/moving_body_shape.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/motion/cavity_step.hpp"
#include "rigor/geometry/motion/mesh_advance.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace rigor {

namespace {

/// The step for two convex shapes, or a shape and a half-space; 0 where no direction proves a step.
double separated_step(const MovingBodyShape& a, const MovingBodyShape& b, const DistanceResult& now, double t,
                      double t_end, double slack) {
  const MovingCore of_a = a.core(), of_b = b.core();
  const double span = t_end - t;
  const auto step_along = [&](const PartingDirection& along) {
    return SeparationBound(of_a, of_b, along, now.distance, t, t_end).safe_step(span, -slack);
  };

  // The normal as it is; then one that a face of either body takes along.
  double step = step_along(now.n_W);
  if (b.is_half_space()) return step;
  for (const Motion* motion : {a.motion, b.motion}) {
    const Vec3 w_W = motion->sample(t).w;
    if (step < span && !w_W.isZero(0)) step = std::max(step, step_along({now.n_W, w_W}));
  }
  return step;
}

double shape_step(const MovingBodyShape& a, const MovingBodyShape& b, double t, double t_end, double slack) {
  // Whatever the shapes are: the time in which no two points can approach by the slack.
  const double least = closing_bound(a.part(), b.part(), t, t_end).time_for(slack);
  if (least >= t_end - t) return t_end - t;
  if (b.is_cavity()) return std::max(least, safe_step_in_cavity(b.part(), a.part(), t, t_end, -slack));

  // What a separating direction proves; all parts of a mesh that are near may use the slack.
  const DistanceResult now = signed_distance(a.solid(), a.pose(t), b.solid(), b.pose(t));
  if (now.distance < -slack) return least;
  if (!a.is_mesh() || is_unbounded(b.solid()))
    return std::max(least, separated_step(a, b, now, t, t_end, slack));
  return std::max(least, safe_mesh_step(a.part(), b.part(),
                                        {.t = t,
                                         .t_end = t_end,
                                         .distance = std::max(0.0, now.distance),
                                         .touch = 0,
                                         .slack = slack,
                                         .rest_velocity = std::numeric_limits<double>::infinity(),
                                         .n_W = std::span(&now.n_W, 1)}));
}

}  // namespace

// NOLINTNEXTLINE(readability-function-size): two bodies, each with its motion.
double bounded_overlap_step(const Body& A, const Motion& of_A, const Body& B, const Motion& of_B, double t,
                            double t_end, double slack) {
  double step = t_end - t;
  for (const BodyShape& of_a : A.shapes) {
    for (const BodyShape& of_b : B.shapes) {
      // What is unbounded comes second, meshes first.
      const MovingBodyShape a{&of_a, &of_A}, b{&of_b, &of_B};
      const bool swaps = is_unbounded(of_a.shape) || (b.is_mesh() && !a.is_mesh());
      step =
          std::min(step, swaps ? shape_step(b, a, t, t + step, slack) : shape_step(a, b, t, t + step, slack));
    }
  }
  return step;
}

}  // namespace rigor
