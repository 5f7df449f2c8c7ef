#include "rigor/contact/system/contact_kinematics.hpp"

#include "rigor/core/index.hpp"
#include "rigor/geometry/contacts/cavity_contacts.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/shape/convex_core.hpp"
#include "rigor/geometry/shape/support.hpp"
#include "rigor/math/dense.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

namespace rigor {

Vec3 relative_velocity(const Contact& contact, const BodyKinetics& A, const BodyKinetics& B) {
  const Vec3 p_W = contact.p_W();
  return frame_with_z(contact.point.n_W).transpose() * (B.velocity_at(p_W) - A.velocity_at(p_W));
}

namespace {

/// How the contact itself moves: ṅ [rad/s] and the tangential velocities of the witness points on their
/// bodies [m/s].
struct WitnessMotion {
  Vec3 n_rate;
  Vec3 s_A;
  Vec3 s_B;
};

/// Flat directions of a surface as columns in the tangent plane.
Eigen::Matrix<double, 2, Eigen::Dynamic> flat_directions(const SurfaceCurvature& surface,
                                                         const Eigen::Matrix<double, 3, 2>& T) {
  if (surface.flat_count == 2) return Mat2::Identity();
  if (surface.flat_count == 1) return (T.transpose() * surface.flat_W).normalized();
  return Eigen::Matrix<double, 2, 0>();
}

/// The general case: unknowns ṅ (2) and the components α, β along the flat directions, by one small linear
/// system in units of the length ℓ (so that it does not depend on the unit of length).
WitnessMotion witness_motion_general(const Contact& contact, const BodyKinetics& A, const BodyKinetics& B,
                                     const Vec3& u_W) {
  // The tangent plane, and the unit of length ℓ.
  const ContactPoint& point = contact.point;
  const Mat3 C = frame_with_z(point.n_W);
  const Eigen::Matrix<double, 3, 2> T = C.leftCols<2>();
  const double length = (point.p_WA - A.x).norm() + (point.p_WB - B.x).norm();
  const double unit = length > 0 ? length : 1;

  // Curvature, flat directions and rates (of normals fixed to the bodies, of sliding) in the tangent plane.
  const Mat2 H_A = T.transpose() * point.curvature_A.radius_W * T / unit;
  const Mat2 H_B = T.transpose() * point.curvature_B.radius_W * T / unit;
  const Eigen::Matrix<double, 2, Eigen::Dynamic> D_A = flat_directions(point.curvature_A, T);
  const Eigen::Matrix<double, 2, Eigen::Dynamic> D_B = flat_directions(point.curvature_B, T);
  const Vec2 n_rate_A = T.transpose() * A.w.cross(point.n_W);
  const Vec2 n_rate_B = T.transpose() * B.w.cross(point.n_W);
  const Vec2 u_t = T.transpose() * u_W / unit;

  // The equations of acceleration_bias: u_t + s_B - s_A = g ṅ, then Dᵀ (ṅ - ω × n) = 0 of both bodies.
  const Eigen::Index flats_A = D_A.cols(), flats_B = D_B.cols(), size = 2 + flats_A + flats_B;
  MatX system = MatX::Zero(size, size);
  VecX right(size);
  system.topLeftCorner<2, 2>() = -(point.gap / unit * Mat2::Identity() + H_A + H_B);
  system.block(0, 2, 2, flats_A) = -D_A;
  system.block(0, 2 + flats_A, 2, flats_B) = D_B;
  system.block(2, 0, flats_A, 2) = D_A.transpose();
  system.block(2 + flats_A, 0, flats_B, 2) = D_B.transpose();
  right << -u_t - H_A * n_rate_A - H_B * n_rate_B, D_A.transpose() * n_rate_A, D_B.transpose() * n_rate_B;

  // Where several motions solve them, the smallest one.
  const VecX solution = least_norm_solution(system, right);
  const Vec2 n_rate = solution.head<2>();
  const Vec2 s_A = unit * (H_A * (n_rate - n_rate_A) + D_A * solution.segment(2, flats_A));
  const Vec2 s_B = unit * (-H_B * (n_rate - n_rate_B) + D_B * solution.tail(flats_B));
  return {T * n_rate, T * s_A, T * s_B};
}

WitnessMotion witness_motion(const Contact& contact, const BodyKinetics& A, const BodyKinetics& B) {
  const ContactPoint& point = contact.point;
  const Vec3& n = point.n_W;
  const Vec3 u_W = B.velocity_at(point.p_WB) - A.velocity_at(point.p_WA);
  const Vec3 u_t = u_W - n.dot(u_W) * n;

  // A face carries the normal with it; the other surface follows, the face gives way.
  if (point.curvature_B.flat_count == 2) {
    const Vec3 n_rate = B.w.cross(n);
    const Vec3 s_A = point.curvature_A.radius_W * (n_rate - A.w.cross(n));
    return {n_rate, s_A, point.gap * n_rate - u_t + s_A};
  }
  if (point.curvature_A.flat_count == 2) {
    const Vec3 n_rate = A.w.cross(n);
    const Vec3 s_B = -(point.curvature_B.radius_W * (n_rate - B.w.cross(n)));
    return {n_rate, u_t + s_B - point.gap * n_rate, s_B};
  }
  return witness_motion_general(contact, A, B, u_W);
}

}  // namespace

Vec3 acceleration_bias(const Contact& contact, const BodyKinetics& A, const BodyKinetics& B) {
  const ContactPoint& point = contact.point;

  // How the normal and the witness points move.
  const WitnessMotion motion = witness_motion(contact, A, B);
  const Vec3 u_W = B.velocity_at(contact.p_W()) - A.velocity_at(contact.p_W());

  // The point midway between the witness points, along the normal from both, moves on the bodies a little
  // otherwise than they do.
  const Vec3 &n = point.n_W, of_gap_B = 0.5 * point.gap * (B.w.cross(n) - motion.n_rate),
             of_gap_A = 0.5 * point.gap * (A.w.cross(n) - motion.n_rate);

  // d/dt of Cᵀ (v_B + ω_B × r_B - v_A - ω_A × r_A) without v̇ and ω̇.
  const Vec3 of_B = B.w.cross(B.w.cross(contact.p_W() - B.x) + motion.s_B + of_gap_B);
  const Vec3 of_A = A.w.cross(A.w.cross(contact.p_W() - A.x) + motion.s_A - of_gap_A);
  Vec3 bias = frame_with_z(point.n_W).transpose() * (of_B - of_A);
  bias.z() += motion.n_rate.dot(u_W);
  return bias;
}

Vec3 normal_rate(const Contact& contact, const BodyKinetics& A, const BodyKinetics& B) {
  return witness_motion(contact, A, B).n_rate;
}

double feature_rate(const Contact& contact, const BodyKinetics& A, const BodyKinetics& B) {
  // A point that slides over a face moves on one body only, and the contact stays what it is.
  const WitnessMotion motion = witness_motion(contact, A, B);
  const double speed = std::min(motion.s_A.norm(), motion.s_B.norm());
  // Bodies that are moved have their origins anywhere.
  double arm = 0;
  for (const BodyKinetics* body : {&A, &B})
    if (body->inverse_mass > 0) arm = std::max(arm, (contact.p_W() - body->x).norm());
  return std::max(motion.n_rate.norm(), arm > 0 ? speed / arm : 0.0);
}

namespace {

/// The same material point after its body moved.
Vec3 carried_point(const Pose& before, const Pose& after, const Vec3& p_W) {
  return after.R * (before.R.transpose() * (p_W - before.p)) + after.p;
}
/// The same material direction after its body moved.
Vec3 carried_direction(const Pose& before, const Pose& after, const Vec3& d_W) {
  return after.R * (before.R.transpose() * d_W);
}

bool has_core(const Shape& shape) {
  return !is_unbounded(shape) && !std::holds_alternative<Mesh>(shape);
}

/// Of a core of rings whether its sides are parallel to the axis: a cylinder.
bool is_cylinder(const ConvexCore& core) {
  return core.kind == ConvexCore::Kind::rings && core.rings.empty() && core.size.x() == core.size.y();
}

/// Radius of a shape whose surface lies at one distance from a core (ball, capsule, side of a cylinder); 0
/// for others.
double round_radius(const Shape& shape) {
  if (!has_core(shape)) return 0;
  const ConvexCore core = make_core(shape);
  return is_cylinder(core) ? core.size.x() : core.radius;
}

/// Whether the surface at the contact is part of such a round surface (not a cylinder's rim or cap).
bool is_round(const BodyShape& shape, const SurfaceCurvature& surface) {
  if (surface.radius_W.isZero(0) || round_radius(shape.shape) == 0) return false;
  return !is_cylinder(make_core(shape.shape)) || surface.flat_count == 1;
}

/// A rim, or the end of a line on a ruled side, that leans on a face: a circle about an axis, seen in W.
struct LeaningCircle {
  Vec3 axis, middle;  ///< Unit; origin of the shape, which the axis passes.
  double radius;
};

/// Such a circle through p_W, if the contact is at one: its normal rotates about the axis, so neither at a
/// face nor at an edge, nor at the tip of a cone.
std::optional<LeaningCircle> leaning_circle(const BodyShape& shape, const SurfaceCurvature& surface,
                                            const Pose& X_WB, const Vec3& p_W) {
  if (!has_core(shape.shape) || surface.flat_count > 0 || surface.radius_W.isZero(0)) return std::nullopt;
  const ConvexCore core = make_core(shape.shape);
  if (core.kind != ConvexCore::Kind::rings) return std::nullopt;
  const Pose X_WS = X_WB * shape.X_BS;
  const Vec3 axis = X_WS.R.col(2);
  if (is_cylinder(core)) return LeaningCircle{axis, X_WS.p, core.size.x()};
  const Vec3 p_S = p_W - X_WS.p;
  return LeaningCircle{axis, X_WS.p, (p_S - p_S.dot(axis) * axis).norm()};
}

/// Where the surface that leans on a face touches now; m_W0 and m_W are its outward normals before and now.
Vec3 leaning_point(const BodyShape& shape, const SurfaceCurvature& surface, const Vec3& p_W0,
                   const std::pair<Vec3, Vec3>& normals, const std::pair<Pose, Pose>& poses) {
  const auto& [m_W0, m_W] = normals;
  const auto& [before, after] = poses;
  if (is_round(shape, surface)) {
    const double radius = round_radius(shape.shape);
    return carried_point(before, after, p_W0 - radius * m_W0) + radius * m_W;
  }
  if (surface.radius_W.isZero(0) || surface.flat_count > 0) return carried_point(before, after, p_W0);
  if (const std::optional<LeaningCircle> then = leaning_circle(shape, surface, before, p_W0)) {
    // The circle about the axis on which it touched, at the point farthest along the normal.
    const Pose X_WS = after * shape.X_BS;
    const Vec3 axis = X_WS.R.col(2);
    // Of a normal that is the axis but for rounding what is left is rounding, too: square to the axis it is
    // made once more.
    Vec3 outward = (m_W - m_W.dot(axis) * axis).normalized();
    outward -= outward.dot(axis) * axis;
    return X_WS.p + (p_W0 - then->middle).dot(then->axis) * axis + then->radius * outward.normalized();
  }
  const Pose X_WS = after * shape.X_BS;
  return X_WS * support_point(shape.shape, X_WS.R.transpose() * m_W);
}

/// Closest points of two edges that their bodies carry along.
ContactPoint crossed_edges(const ContactPoint& old, const std::pair<Pose, Pose>& A,
                           const std::pair<Pose, Pose>& B) {
  // The lines now, p + α a and q + β b, and their common normal on the same side as before.
  ContactPoint point = old;
  const Vec3 a = carried_direction(A.first, A.second, old.curvature_A.flat_W);
  const Vec3 b = carried_direction(B.first, B.second, old.curvature_B.flat_W);
  const Vec3 p = carried_point(A.first, A.second, old.p_WA);
  const Vec3 q = carried_point(B.first, B.second, old.p_WB);
  Vec3 n = a.cross(b).normalized();
  const Vec3 n_before = old.curvature_A.flat_W.cross(old.curvature_B.flat_W);
  if (n_before.dot(old.n_W) < 0) n = -n;
  // (q + β b) - (p + α a) is along n.
  const Vec3 d = q - p;
  const double ab = a.dot(b), determinant = 1 - ab * ab;
  // Parallel edges have no crossing: the old points, which the bodies carry.
  if (!(determinant > 0)) {
    point.p_WA = p;
    point.p_WB = q;
    point.n_W = carried_direction(A.first, A.second, old.n_W);
    point.gap = point.n_W.dot(q - p);
    return point;
  }
  const double alpha = (d.dot(a) - ab * d.dot(b)) / determinant;
  const double beta = (ab * d.dot(a) - d.dot(b)) / determinant;
  point.p_WA = p + alpha * a;
  point.p_WB = q + beta * b;
  point.n_W = n;
  point.gap = n.dot(point.p_WB - point.p_WA);
  point.curvature_A.flat_W = a;
  point.curvature_B.flat_W = b;
  return point;
}

/// Whether the point is a corner of the face of B that carries the normal (share_normals_of_faces).
bool is_corner_of_face(const ContactPoint& point) {
  return point.curvature_B.flat_count == 2 && point.curvature_A.flat_count == 0 &&
         !point.curvature_A.flat_W.isZero(0);
}

/// The contact with its bodies exchanged, but with the same feature.
ContactPoint reversed(ContactPoint point) {
  std::swap(point.p_WA, point.p_WB);
  std::swap(point.curvature_A, point.curvature_B);
  point.n_W = -point.n_W;
  return point;
}

/// Of a cavity on A: the same ball of B, whose centre its body carries.
ContactPoint rolled_in_cavity(const Cavity& cavity, const Pose& X_WS, const ContactPoint& old, double radius,
                              const std::pair<Pose, Pose>& B) {
  const Vec3 p_W = carried_point(B.first, B.second, old.p_WB + radius * old.n_W);
  ContactPoint point = cavity_contact(cavity, X_WS, p_W, radius);
  point.feature = old.feature;
  return point;
}

/// The curvature at the contact after the body moved, which now is at p_W with the outward normal m_W: round
/// surfaces look the same along every normal, an ellipsoid's is that of the point with this normal, others
/// are carried with the body.
SurfaceCurvature carried_curvature(const BodyShape& shape, const SurfaceCurvature& old,
                                   const std::pair<Pose, Pose>& poses, const std::pair<Vec3, Vec3>& touch) {
  const auto& [before, after] = poses;
  const auto& [p_W, m_W] = touch;
  // Carried with the body.
  const Mat3 rotation = after.R * before.R.transpose();
  SurfaceCurvature surface{rotation * old.radius_W * rotation.transpose(), old.flat_count,
                           rotation * old.flat_W};

  // The rim of a cylinder, or a ring of a solid of revolution.
  if (const std::optional<LeaningCircle> now = leaning_circle(shape, old, after, p_W)) {
    // The point of a circle of radius r farthest along m moves by r / |m - (m·a) a| along the circle.
    const Vec3 outward = m_W - m_W.dot(now->axis) * now->axis;
    // Along the axis all of the circle is as far: the surface there is flat, and has no such point.
    constexpr double along_axis = 1e-9;
    if (outward.norm() <= along_axis) return surface;
    const Vec3 along = now->axis.cross(outward).normalized();
    surface.radius_W = now->radius / outward.norm() * along * along.transpose();
    return surface;
  }

  // An ellipsoid: at the point with this normal.
  if (std::holds_alternative<Ellipsoid>(shape.shape)) {
    const Mat3 R_WS = (after * shape.X_BS).R;
    surface.radius_W =
        R_WS * piece_curvature(make_core(shape.shape), 0, R_WS.transpose() * m_W) * R_WS.transpose();
    return surface;
  }

  // Round surfaces: one radius around the normal, or across the flat direction.
  if (!is_round(shape, old)) return surface;
  const double radius = round_radius(shape.shape);
  if (old.flat_count == 0) {
    surface.radius_W = radius * (Mat3::Identity() - m_W * m_W.transpose());
  } else {
    const Vec3 across = m_W.cross(surface.flat_W);
    surface.radius_W = radius * across * across.transpose();
  }
  return surface;
}

}  // namespace

ContactPoint tracked_contact(const Model& model, const Contact& contact, const Pose& X_WA0, const Pose& X_WB0,
                             const Pose& X_WA, const Pose& X_WB) {
  // A ball in a cavity rolls: from the centre that its body carries.
  const ContactPoint& old = contact.point;
  const BodyShape& shape_A = model.body(contact.body_A).shapes[at(contact.shape_A)];
  const BodyShape& shape_B = model.body(contact.body_B).shapes[at(contact.shape_B)];
  if (const Cavity* cavity = std::get_if<Cavity>(&shape_A.shape))
    return rolled_in_cavity(*cavity, X_WA * shape_A.X_BS, old, round_radius(shape_B.shape), {X_WB0, X_WB});
  if (const Cavity* cavity = std::get_if<Cavity>(&shape_B.shape)) {
    return reversed(rolled_in_cavity(*cavity, X_WB * shape_B.X_BS, reversed(old), round_radius(shape_A.shape),
                                     {X_WA0, X_WA}));
  }

  // Two edges that cross.
  const bool are_edges = old.curvature_A.flat_count == 1 && old.curvature_B.flat_count == 1 &&
                         old.curvature_A.radius_W.isZero(0) && old.curvature_B.radius_W.isZero(0);
  if (are_edges) return crossed_edges(old, {X_WA0, X_WA}, {X_WB0, X_WB});

  // A face carries its normal, and the other surface leans on it; without a face the closest points are
  // found anew.
  ContactPoint point = old;
  if (is_corner_of_face(old)) {
    // The corner where its body carries it, and what is over it along the normal of its face.
    point.n_W = carried_direction(X_WB0, X_WB, old.n_W);
    point.p_WB = carried_point(X_WB0, X_WB, old.p_WB);
    const Vec3 other = carried_direction(X_WA0, X_WA, old.curvature_A.flat_W);
    point.gap = other.dot(point.p_WB - carried_point(X_WA0, X_WA, old.p_WA)) / other.dot(point.n_W);
    point.p_WA = point.p_WB - point.gap * point.n_W;
  } else if (old.curvature_B.flat_count == 2) {
    point.n_W = carried_direction(X_WB0, X_WB, old.n_W);
    point.p_WA = leaning_point(shape_A, old.curvature_A, old.p_WA, {old.n_W, point.n_W}, {X_WA0, X_WA});
    const Vec3 on_face = carried_point(X_WB0, X_WB, old.p_WB);
    point.gap = point.n_W.dot(on_face - point.p_WA);
    point.p_WB = point.p_WA + point.gap * point.n_W;
  } else if (old.curvature_A.flat_count == 2) {
    point.n_W = carried_direction(X_WA0, X_WA, old.n_W);
    point.p_WB = leaning_point(shape_B, old.curvature_B, old.p_WB, {-old.n_W, -point.n_W}, {X_WB0, X_WB});
    const Vec3 on_face = carried_point(X_WA0, X_WA, old.p_WA);
    point.gap = point.n_W.dot(point.p_WB - on_face);
    point.p_WA = point.p_WB - point.gap * point.n_W;
  } else {
    const DistanceResult found =
        signed_distance(shape_A.shape, X_WA * shape_A.X_BS, shape_B.shape, X_WB * shape_B.X_BS);
    point.n_W = found.n_W;
    point.p_WA = found.p_WA;
    point.p_WB = found.p_WB;
    point.gap = found.distance;
  }

  // The curvatures there.
  point.curvature_A = carried_curvature(shape_A, old.curvature_A, {X_WA0, X_WA}, {point.p_WA, point.n_W});
  point.curvature_B = carried_curvature(shape_B, old.curvature_B, {X_WB0, X_WB}, {point.p_WB, -point.n_W});
  return point;
}

}  // namespace rigor
