#include "rigor/bulk/broad_phase/shape_places.hpp"

#include "rigor/bulk/lanes/float_lanes.hpp"
#include "rigor/core/index.hpp"
#include "rigor/geometry/lanes/lane_target.hpp"
#include "rigor/geometry/shape/aabb.hpp"
#include "rigor/geometry/shape/corner_balls.hpp"
#include "rigor/geometry/shape/support.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>

namespace rigor {

namespace {

struct Float3 {
  float x, y, z;
};

Float3 load(const float* p) {
  return {p[0], p[1], p[2]};
}
Float3 operator-(const Float3& a, const Float3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Float3 operator+(const Float3& a, const Float3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Float3 cross(const Float3& a, const Float3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
float squared(const Float3& a) {
  return a.x * a.x + a.y * a.y + a.z * a.z;
}
float norm(const Float3& a) {
  return std::sqrt(squared(a));
}
void store(const Float3& a, float* p) {
  p[0] = a.x;
  p[1] = a.y;
  p[2] = a.z;
}
Float3 turned(const float* R, const Float3& a) {
  return {R[0] * a.x + R[1] * a.y + R[2] * a.z, R[3] * a.x + R[4] * a.y + R[5] * a.z,
          R[6] * a.x + R[7] * a.y + R[8] * a.z};
}
Float3 turned_back(const float* R, const Float3& a) {
  return {R[0] * a.x + R[3] * a.y + R[6] * a.z, R[1] * a.x + R[4] * a.y + R[7] * a.z,
          R[2] * a.x + R[5] * a.y + R[8] * a.z};
}

/// Writes the rows of the rotation matrix of a unit quaternion.
void set_rotation(const Quat& q_WB, float* R) {
  const float w = static_cast<float>(q_WB.w()), x = static_cast<float>(q_WB.x()),
              y = static_cast<float>(q_WB.y()), z = static_cast<float>(q_WB.z());
  R[0] = 1 - 2 * (y * y + z * z), R[1] = 2 * (x * y - w * z), R[2] = 2 * (x * z + w * y);
  R[3] = 2 * (x * y + w * z), R[4] = 1 - 2 * (x * x + z * z), R[5] = 2 * (y * z - w * x);
  R[6] = 2 * (x * z - w * y), R[7] = 2 * (y * z + w * x), R[8] = 1 - 2 * (x * x + y * y);
}

/// A number a little larger, so that rounding to 32 bits takes nothing away.
float rounded_up(double x) {
  return static_cast<float>(x * (1 + 1e-6));
}

}  // namespace

ShapeBound make_shape_bound(const BodyShape& shape) {
  // The core is the box of the shape less the radius of its round edges.
  const Aabb box = axis_aligned_box(shape.shape, Pose{});
  const Vec3 center_S = 0.5 * (box.lower + box.upper);
  const double radius = corner_radius(shape.shape);
  const Vec3 half = 0.5 * (box.upper - box.lower) - Vec3::Constant(radius);
  const Vec3 center_B = shape.X_BS * center_S;
  ShapeBound bound{};
  bound.is_turned = !shape.X_BS.R.isIdentity(0);
  for (int k = 0; k < 3; ++k) {
    bound.center_B[k] = static_cast<float>(center_B[k]);
    bound.half[k] = rounded_up(std::max(half[k], 0.0));
    for (int j = 0; j < 3; ++j) bound.R_BS[3 * k + j] = static_cast<float>(shape.X_BS.R(k, j));
  }
  // Sizes are rounded up: the bound holds the shape.
  bound.radius = rounded_up(radius);
  bound.reach = rounded_up(std::max(radius_about(shape.shape, center_S) - radius, 0.0));
  bound.is_centred_ball = std::holds_alternative<Sphere>(shape.shape) && center_B.isZero(0);
  return bound;
}

namespace {

BoxAxes axes_of_body(const Quat& q_WB) {
  BoxAxes axes;
  set_rotation(q_WB, axes.row);
  return axes;
}

BoxAxes axes_on_body(const ShapeBound& bound, const BoxAxes& of_body) {
  if (!bound.is_turned) return of_body;
  BoxAxes axes;
  for (int row = 0; row < 3; ++row)
    store(turned_back(bound.R_BS, load(of_body.row + 3 * row)), axes.row + 3 * row);
  return axes;
}

}  // namespace

BoxAxes axes_of(const ShapeBound& bound, const Quat& q_WB) {
  return axes_on_body(bound, axes_of_body(q_WB));
}

namespace {

/// Relative rounding of the numbers that a place and a box are made of, in all.
constexpr float kRoundings = 1e-6f;

/// The place of a shape; arm_W is the centre of its box relative to the centre of the body.
ShapePlace place_of(const ShapeBound& bound, const BulkBodies& bodies, std::size_t body, const Vec3& origin,
                    const Float3& arm_W) {
  const MotionRecord& motion = bodies.motion[body];
  const Float3 w = load(motion.w);
  const Vec3 x = bodies.x[body] - origin;
  const Float3 center =
      Float3{static_cast<float>(x[0]), static_cast<float>(x[1]), static_cast<float>(x[2])} + arm_W;
  ShapePlace place;
  store(center, place.center);
  store(load(motion.v) + cross(w, arm_W), place.u);
  store(w, place.w);
  place.slack = kRoundings * (std::abs(center.x) + std::abs(center.y) + std::abs(center.z) + bound.reach +
                              bound.radius + norm(load(bound.center_B)));
  place.bound = &bound;
  return place;
}

/// The box of a place, swept by its motion over h; extent is half of the core's box along W's axes.
FloatBox swept_box(const ShapePlace& place, const Float3& extent, const MotionRecord& motion, float h,
                   float margin) {
  const ShapeBound& bound = *place.bound;
  // A point at r from the axis goes at most r times the angle, and never farther than 2 r.
  const float angle = std::min(norm(load(place.w)) * h, 2.0f);
  const float turn = angle * (norm(load(bound.center_B)) + bound.reach);
  const float extents[3] = {extent.x, extent.y, extent.z};
  FloatBox box;
  for (int k = 0; k < 3; ++k) {
    const float half = std::min(extents[k], bound.reach) + bound.radius + turn + margin + 2 * place.slack;
    const float shift = motion.v[k] * h;
    box.lower[k] = place.center[k] - half + std::min(shift, 0.0f);
    box.upper[k] = place.center[k] + half + std::max(shift, 0.0f);
  }
  return box;
}

float box_extent(const float* row, const ShapeBound& bound) {
  return std::abs(row[0]) * bound.half[0] + std::abs(row[1]) * bound.half[1] +
         std::abs(row[2]) * bound.half[2];
}

}  // namespace

SweptShape sweep_shape(const ShapeBound& bound, const BulkBodies& bodies, int body, const Vec3& origin,
                       float h, float margin) {
  const std::size_t k = at(body);
  SweptShape swept;
  if (bound.is_centred_ball) {
    swept.place = place_of(bound, bodies, k, origin, {0, 0, 0});
    swept.box = swept_box(swept.place, {0, 0, 0}, bodies.motion[k], h, margin);
    return swept;
  }
  const BoxAxes of_body = axes_of_body(bodies.q[k]);
  swept.place = place_of(bound, bodies, k, origin, turned(of_body.row, load(bound.center_B)));
  const BoxAxes axes = axes_on_body(bound, of_body);
  const Float3 extent{box_extent(axes.row, bound), box_extent(axes.row + 3, bound),
                      box_extent(axes.row + 6, bound)};
  swept.box = swept_box(swept.place, extent, bodies.motion[k], h, margin);
  return swept;
}

namespace {

/// Eight floats from each of eight addresses, transposed.
RIGOR_FLOAT_LANES FloatSquare gather_rows(const std::array<const float*, 8>& from) {
  FloatSquare rows;
  for (int i = 0; i < kLaneCount; ++i) rows.row[i] = load_floats(from[at(i)]);
  return transpose(rows);
}
RIGOR_FLOAT_LANES FloatLanes magnitude(const FloatLanes& x) {
  return x < float_lanes(0) ? -x : x;
}

struct EightShapes {
  const std::array<const ShapeBound*, 8>& bounds;
  const BulkBodies& bodies;
  std::size_t first_body;
  const SweepStep& step;

  /// Sweeps the eight shapes as sweep_shape() does, operation by operation.
  RIGOR_FLOAT_LANES void sweep(ShapePlace* places, FloatBox* boxes) const {
    // Positions and orientations are rounded to 32 bits relative to the origin; the rest is already in 32
    // bits.
    alignas(32) float from_origin[3][kLaneCount], quaternions[4][kLaneCount];
    std::array<const float*, 8> bound_rows, motion_rows;
    for (std::size_t i = 0; i < 8; ++i) {
      const Vec3 x = bodies.x[first_body + i] - step.origin;
      const Quat& q = bodies.q[first_body + i];
      for (int k = 0; k < 3; ++k) from_origin[k][i] = static_cast<float>(x[k]);
      for (int k = 0; k < 4; ++k) quaternions[k][i] = static_cast<float>(q.coeffs()[k]);
      bound_rows[i] = bounds[i]->center_B;
      motion_rows[i] = bodies.motion[first_body + i].v;
    }
    // Rotation matrices from the quaternions, as in set_rotation().
    const FloatLanes one = float_lanes(1), two = float_lanes(2), zero = float_lanes(0);
    const FloatLanes x = load_floats(quaternions[0]), y = load_floats(quaternions[1]),
                     z = load_floats(quaternions[2]), w = load_floats(quaternions[3]);
    const FloatVec3 R[3] = {{one - two * (y * y + z * z), two * (x * y - w * z), two * (x * z + w * y)},
                            {two * (x * y + w * z), one - two * (x * x + z * z), two * (y * z - w * x)},
                            {two * (x * z - w * y), two * (y * z + w * x), one - two * (x * x + y * y)}};
    const FloatSquare bound = gather_rows(bound_rows), motion = gather_rows(motion_rows);
    const FloatVec3 center_B{bound.row[0], bound.row[1], bound.row[2]};
    const FloatVec3 half_S{bound.row[3], bound.row[4], bound.row[5]};
    const FloatLanes reach = bound.row[6], radius = bound.row[7];
    const FloatVec3 v{motion.row[0], motion.row[1], motion.row[2]};
    const FloatVec3 turning{motion.row[4], motion.row[5], motion.row[6]};

    // Centres and their velocities, as in place_of().
    const FloatVec3 arm{dot(R[0], center_B), dot(R[1], center_B), dot(R[2], center_B)};
    const FloatVec3 center =
        FloatVec3{load_floats(from_origin[0]), load_floats(from_origin[1]), load_floats(from_origin[2])} +
        arm;
    const FloatVec3 u = v + cross(turning, arm);
    const FloatLanes arm_length = float_sqrt(dot(center_B, center_B));
    const FloatLanes slack = float_lanes(kRoundings) * (magnitude(center.x) + magnitude(center.y) +
                                                        magnitude(center.z) + reach + radius + arm_length);

    // Boxes, as in swept_box(): the core along W's axes, what rotation adds, and the displacement.
    const FloatLanes h = float_lanes(step.h);
    const FloatLanes angle = float_min(float_sqrt(dot(turning, turning)) * h, two);
    const FloatLanes turn = angle * (arm_length + reach);
    FloatSquare box;
    for (int k = 0; k < 3; ++k) {
      const FloatLanes extent =
          magnitude(R[k].x) * half_S.x + magnitude(R[k].y) * half_S.y + magnitude(R[k].z) * half_S.z;
      const FloatLanes half =
          float_min(extent, reach) + radius + turn + float_lanes(step.margin) + two * slack;
      const FloatLanes shift = motion.row[k] * h;
      const FloatLanes& middle = k == 0 ? center.x : (k == 1 ? center.y : center.z);
      box.row[k] = middle - half + float_min(shift, zero);
      box.row[3 + k] = middle + half + float_max(shift, zero);
    }
    // Back from lanes to one place and one box per body.
    box.row[6] = turning.z;
    box.row[7] = slack;
    const FloatSquare place =
        transpose(FloatSquare{{center.x, center.y, center.z, u.x, u.y, u.z, turning.x, turning.y}});
    box = transpose(box);
    for (int i = 0; i < kLaneCount; ++i) {
      float rest[kLaneCount];
      store_floats(box.row[i], rest);
      std::memcpy(&boxes[i], rest, sizeof(FloatBox));
      store_floats(place.row[i], places[i].center);
      places[i].w[2] = rest[6];
      places[i].slack = rest[7];
      places[i].bound = bounds[at(i)];
    }
  }
};

#if defined(__x86_64__)
[[gnu::target("avx2")]] void sweep_avx2(const EightShapes& shapes, ShapePlace* places, FloatBox* boxes) {
  shapes.sweep(places, boxes);
}
#endif

}  // namespace

void sweep_eight_shapes(const std::array<const ShapeBound*, 8>& bounds, const BulkBodies& bodies,
                        int first_body, const SweepStep& step, ShapePlace* places, FloatBox* boxes) {
  const EightShapes shapes{bounds, bodies, at(first_body), step};
#if defined(__x86_64__)
  if (best_lane_target() == LaneTarget::avx2) return sweep_avx2(shapes, places, boxes);
#endif
  shapes.sweep(places, boxes);
}

namespace {

/// How far the shapes can come to each other; d is from the centre of the large one to that of the small one.
///
/// The distance of the cores changes as fast as their witness points P and Q move along the line n between
/// them. With c the centre of the core of b: velocity_b(Q) - velocity_a(P) = [u_b - velocity_a(c)] + (w_b -
/// w_a) × (Q - c) + w_a × (Q - P), and the last term has no part along n. All n count, also those along which
/// the shapes move apart: a body that is rotated within the step finds its contacts there.
float approach_bound(const ShapePlace& small, const ShapePlace& large, const Float3& d, float h) {
  const Float3 u = load(small.u) - load(large.u) - cross(load(large.w), d);
  const float reach = small.bound->reach;
  const float turning = reach > 0 ? norm(load(small.w) - load(large.w)) * reach : 0;
  return h * (norm(u) + turning);
}

}  // namespace

std::optional<float> find_pair_margin(const PairPlaces& pair, float h, float margin) {
  // The motion is seen from the large shape: its rotation about the small one then costs no margin, that of
  // the small one only its reach.
  const bool is_a_large = pair.b.bound->reach <= pair.a.bound->reach;
  const ShapePlace &small = is_a_large ? pair.b : pair.a, &large = is_a_large ? pair.a : pair.b;
  const ShapeBound &of_small = *small.bound, &of_large = *large.bound;
  const Float3 d = load(small.center) - load(large.center);
  const float pair_margin = margin + approach_bound(small, large, d, h);
  // Balls about both shapes first.
  const float near =
      of_small.reach + of_small.radius + of_large.radius + pair_margin + small.slack + large.slack;
  const float far = near + of_large.reach;
  if (squared(d) > far * far) return std::nullopt;
  // Where both are of about the same size, the box of one tells little more than its ball.
  if (of_large.reach < 2 * (of_small.reach + of_small.radius)) return pair_margin;
  // The ball of the small shape against the box of the large one.
  const BoxAxes axes = axes_of(of_large, is_a_large ? pair.q_WA : pair.q_WB);
  const Float3 local = turned_back(axes.row, d);
  const Float3 outside{std::max(std::abs(local.x) - of_large.half[0], 0.0f),
                       std::max(std::abs(local.y) - of_large.half[1], 0.0f),
                       std::max(std::abs(local.z) - of_large.half[2], 0.0f)};
  if (squared(outside) > near * near) return std::nullopt;
  return pair_margin;
}

}  // namespace rigor
