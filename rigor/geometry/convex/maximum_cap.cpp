#include "rigor/geometry/convex/maximum_cap.hpp"

#include "rigor/math/rotation.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {
namespace {

using Tangents = Eigen::Matrix<double, 3, 2>;

double smaller_eigenvalue(const Mat2& m) {
  const double half = 0.5 * (m(0, 0) - m(1, 1));
  return 0.5 * (m(0, 0) + m(1, 1)) - std::sqrt(half * half + m(0, 1) * m(0, 1));
}

double larger_eigenvalue(const Mat2& m) {
  return m(0, 0) + m(1, 1) - smaller_eigenvalue(m);
}

/// Number of bisections of the range of cosines.
constexpr int kHalvings = 8;

/// One side of the pair as seen along d. Only an ellipsoid adds roundness.
class RoundSide {
 public:
  RoundSide(const ConvexCore& core, const Vec3& d, const Tangents& tangents) {
    if (core.kind != ConvexCore::Kind::ellipsoid) return;
    // h_E is the support value along d, t the part of the support point across d; the radii of curvature in
    // the tangent plane are (E² - t tᵀ) / h_E.
    largest_ = core.size.maxCoeff();
    smallest_ = core.size.minCoeff();
    const Vec3 p = core_support(core, d).p;
    h_ = d.dot(p);
    const Vec2 across = tangents.transpose() * p;
    across_ = across.norm();
    const Mat2 squares = tangents.transpose() * core.size.cwiseAbs2().asDiagonal() * tangents;
    largest_square_ = larger_eigenvalue(squares);
    radii_ = (squares - across * across.transpose()) / h_;
  }

  /// A lower bound of the radii of curvature along the great circles through d, anywhere within the angle: on
  /// each circle the radius goes as 1 / h_E³, and h_E(θ)² ≤ h_E² + sin²θ (a² - h_E²) + sin 2θ h_E |t|.
  Mat2 radii_within(double cosine, double sine) const {
    if (h_ == 0) return Mat2::Zero();
    const double twice = cosine * cosine < 0.5 ? 1 : 2 * sine * cosine;
    const double rise = std::max(0.0, largest_square_ - h_ * h_);
    const double h_squared = h_ * h_ + sine * sine * rise + twice * h_ * across_;
    const double ratio = h_ / std::min(largest_, std::sqrt(h_squared));
    return ratio * ratio * ratio * radii_;
  }

  /// The smallest radius of curvature of the ellipsoid, c²/a.
  double radius_anywhere() const { return h_ == 0 ? 0 : smallest_ * smallest_ / largest_; }

 private:
  double largest_ = 0;
  double smallest_ = 0;
  double h_ = 0;               ///< Support value along d.
  double across_ = 0;          ///< Distance of the support point from the line along d.
  double largest_square_ = 0;  ///< Of the support values across d.
  Mat2 radii_ = Mat2::Zero();
};

}  // namespace

double cap_cosine(const CorePair& pair, const Separation& maximum) {
  const bool has_ellipsoid =
      pair.a.kind == ConvexCore::Kind::ellipsoid || pair.b.kind == ConvexCore::Kind::ellipsoid;
  if (!has_ellipsoid) return 1;
  const Mat3 R_BA = pair.X_AB.R.transpose();
  const Tangents tangents = frame_with_z(maximum.n).leftCols<2>();
  const RoundSide a(pair.a, maximum.n, tangents);
  const RoundSide b(pair.b, R_BA * -maximum.n, R_BA * tangents);
  const double needed = -maximum.value + pair.rounding;
  // Where even the smallest radii of curvature c²/a sum to the depth, the cap is the whole sphere.
  if (a.radius_anywhere() + b.radius_anywhere() >= needed) return -1;

  // By Sturm's comparison no direction within the angle is better if the radii of curvature there are at
  // least the depth. Their bound falls as the cap grows, so that bisection finds the largest cap.
  double proved = 1;
  double unproved = 0;
  for (int i = 0; i < kHalvings; ++i) {
    const double cosine = 0.5 * (proved + unproved);
    const double sine = std::sqrt(1 - cosine * cosine);
    const Mat2 radii = a.radii_within(cosine, sine) + b.radii_within(cosine, sine);
    (smaller_eigenvalue(radii) >= needed ? proved : unproved) = cosine;
  }
  return proved;
}

}  // namespace rigor
