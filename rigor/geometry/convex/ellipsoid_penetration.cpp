#include "rigor/geometry/convex/ellipsoid_penetration.hpp"

#include <array>
#include <limits>

namespace rigor {
namespace {

bool is_ellipsoid(const ConvexCore& core) {
  return core.kind == ConvexCore::Kind::ellipsoid;
}

/// Cores whose support points in all directions near the maximum lie, as a rule, on one smooth piece: an
/// ellipsoid, a point, or one end of a segment.
bool is_smooth(const ConvexCore& core) {
  return is_ellipsoid(core) || core.kind == ConvexCore::Kind::point || core.kind == ConvexCore::Kind::segment;
}

/// The rotation by the smallest angle that takes one unit vector to another, which is not its opposite:
/// Rodrigues' formula with axis × sin θ = from × to, cos θ = from · to.
Mat3 smallest_rotation(const Vec3& from, const Vec3& to) {
  const Vec3 axis = from.cross(to);
  Mat3 cross;
  cross << 0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(), 0;
  return Mat3::Identity() + cross + cross * cross / (1 + from.dot(to));
}

/// Sylvester's criterion: a symmetric matrix is positive definite if its three leading minors are positive.
bool is_positive(const Mat3& m) {
  const double minor = m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0);
  return m(0, 0) > 0 && minor > 0 && m.determinant() > 0;
}

/// Whether the ball of radius `depth` that touches the ellipsoid with the support function |C m| at its point
/// of normal n lies inside that ellipsoid; `height` is |C n|. It does if no eigenvalue of Q = Cᵀ C is less
/// than depth · height.
bool holds_ball(const Mat3& C, double depth, double height) {
  const Mat3 Q = C.transpose() * C;
  const double rounding = 64 * std::numeric_limits<double>::epsilon() * Q.trace();
  return is_positive(Q - (depth * height + rounding) * Mat3::Identity());
}

/// Two ellipsoids with the support functions |A m| and |B m|, A and B symmetric. Their sum holds the
/// ellipsoid |(A + S B) m|, where the rotation S takes B n to A n up to length, so that both touch at n.
bool is_best_of_two(const CorePair& pair, const Vec3& n, double depth) {
  const Mat3 A = pair.a.size.asDiagonal();
  const Mat3& R = pair.X_AB.R;
  const Mat3 B = R * pair.b.size.asDiagonal() * R.transpose();
  // The smallest rotation is ill-conditioned between nearly opposite vectors. The proof is given up there,
  // and a polytope decides.
  const Vec3 An = A * n, Bn = B * n;
  const double h_A = An.norm(), h_B = Bn.norm();
  if (An.dot(Bn) <= -0.9 * h_A * h_B) return false;
  return holds_ball(A + smallest_rotation(Bn / h_B, An / h_A) * B, depth, h_A + h_B);
}

/// An ellipsoid against a point or a segment. The other core holds at least its witness, and is taken as that
/// point alone: the bound for it holds for the whole core.
bool is_best_of_one(const Vec3& radii, const Vec3& n, double depth) {
  return holds_ball(radii.asDiagonal(), depth, radii.cwiseProduct(n).norm());
}

bool is_best(const CorePair& pair, const Vec3& n, double depth) {
  const bool is_round_A = is_ellipsoid(pair.a), is_round_B = is_ellipsoid(pair.b);
  if (is_round_A && is_round_B) return is_best_of_two(pair, n, depth);
  return is_round_A ? is_best_of_one(pair.a.size, n, depth)
                    : is_best_of_one(pair.b.size, pair.X_AB.R.transpose() * n, depth);
}

}  // namespace

std::optional<Penetration> find_ellipsoid_penetration(const CorePair& pair, const Vec3& start) {
  // Only pairs with an ellipsoid and another smooth core have a proof in closed form.
  const bool is_known =
      (is_ellipsoid(pair.a) && is_smooth(pair.b)) || (is_ellipsoid(pair.b) && is_smooth(pair.a));
  if (!is_known) return std::nullopt;
  // Newton's method finds the maximum next to `start`. It counts where the cores overlap and its witnesses
  // are s(n) n apart, which makes it a local maximum.
  const std::array<DifferencePoint, 1> lowest{pair.lowest(start)};
  const std::array<double, 1> weights{1};
  const std::optional<Separation> found = polish_separation(pair, start, {lowest, weights});
  if (!found || !(found->value < 0)) return std::nullopt;
  const bool is_maximum = (found->b - found->a - found->value * found->n).norm() <= pair.rounding;
  // The local maximum is the global one if the ball of the depth lies inside the third ellipsoid. The depth
  // is raised by the rounding, so that the proof holds for the true one.
  if (!is_maximum || !is_best(pair, found->n, pair.rounding - found->value)) return std::nullopt;
  return Penetration{*found, found->value};
}

}  // namespace rigor
