#pragma once

#include "geometry/random_pairs.hpp"
#include "rigor/geometry/distance/distance.hpp"

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace rigor::test {

/// Reads two convex shapes and their poses from any bytes: sizes from 1e-6 to 1e6 and aspects up to 1e12,
/// places that coincide, touch or lie far away, turns by quarters as well as any.
class PairOfBytes {
 public:
  explicit PairOfBytes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  /// Nothing if the points of a hull have none.
  std::optional<Shape> shape() {
    const int kind = number(7);
    const double unit = std::pow(10, number(13) - 6);
    const double x = unit * length();
    const double y = unit * length();
    const double z = unit * length();
    switch (kind) {
      case 0:
        return Sphere{x};
      case 1:
        return Box{Vec3(x, y, z)};
      case 2:
        return Capsule{x, y};
      case 3:
        return Cylinder{x, y};
      case 4:
        return Cone{x, y};
      case 5:
        return Ellipsoid{Vec3(x, y, z)};
      default:
        return hull(Vec3(x, y, z));
    }
  }

  Pose pose(double size) {
    Pose X;
    const int turn = number(4);
    if (turn == 1) X.R = quarter_turn();
    if (turn > 1) X.R = rotation_matrix(rotation_exp(4 * Vec3(signed_part(), signed_part(), signed_part())));
    const int place = number(5);
    if (place == 1) X.p = 0.25 * size * Vec3(number(9) - 4, number(9) - 4, number(9) - 4);
    if (place == 2) X.p = size * Vec3(signed_part(), signed_part(), signed_part());
    if (place == 3) X.p = 1e-9 * size * Vec3(signed_part(), signed_part(), signed_part());
    if (place == 4) X.p = 1e6 * size * Vec3(signed_part(), signed_part(), signed_part());
    return X;
  }

 private:
  std::uint8_t byte() {
    if (at_ == bytes_.size()) return 0;
    return bytes_[at_++];
  }
  int number(int count) { return byte() % count; }
  /// In [-1, 1).
  double signed_part() { return (byte() * 256 + byte()) / 32768.0 - 1; }
  /// A few equal sizes, or any over six decades.
  double length() {
    const int choice = number(4);
    if (choice < 3) return 0.25 * (choice + 1);
    return std::pow(10, 3 * signed_part());
  }
  Mat3 quarter_turn() {
    Mat3 R = Mat3::Zero();
    const int i = number(3);
    const int j = (i + 1 + number(2)) % 3;
    R(i, 0) = number(2) ? 1 : -1;
    R(j, 1) = number(2) ? 1 : -1;
    R.col(2) = R.col(0).cross(R.col(1));
    return R;
  }
  std::optional<Shape> hull(const Vec3& size) {
    std::vector<Vec3> points;
    const int count = 4 + number(30);
    for (int i = 0; i < count; ++i) {
      points.push_back(size.cwiseProduct(Vec3(signed_part(), signed_part(), signed_part())));
    }
    std::variant<ConvexHull, std::string> result = make_convex_hull(points);
    if (!std::holds_alternative<ConvexHull>(result)) return std::nullopt;
    return Convex{std::make_shared<const ConvexHull>(std::get<ConvexHull>(std::move(result)))};
  }

  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

/// What is wrong with the signed distance of two shapes, by its own promises; empty if nothing is.
inline std::string fault_of_distance(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB) {
  const DistanceResult r = signed_distance(a, X_WA, b, X_WB);
  const DistanceResult q = signed_distance(b, X_WB, a, X_WA);
  const double size =
      X_WA.p.norm() + X_WB.p.norm() + radius_about(a, Vec3::Zero()) + radius_about(b, Vec3::Zero());
  const double rounding = 1e-14 * size;  // Some fifty roundings of the largest length.
  if (!std::isfinite(r.distance) || !r.n_W.allFinite() || !r.p_WA.allFinite() || !r.p_WB.allFinite())
    return "not finite";
  if (std::abs(r.n_W.norm() - 1) > 1e-14) return "the normal is no unit vector";
  // One body twice at one place is the same call both ways.
  const bool may_be_one_call = X_WA.p == X_WB.p && X_WA.R == X_WB.R && r.n_W == q.n_W;
  const bool is_reversed = r.n_W == -q.n_W || may_be_one_call;
  if (r.distance != q.distance || !is_reversed || r.lower != q.lower || r.upper != q.upper)
    return "not the same both ways";
  if (!(r.lower <= r.distance && r.distance <= r.upper)) return "the bounds do not hold the distance";
  if (std::abs(separation_along(r.n_W, a, X_WA, b, X_WB) - r.distance) > rounding)
    return "the normal does not prove the distance";
  if ((r.p_WB - r.p_WA - r.distance * r.n_W).norm() > rounding)
    return "the witnesses are not the distance apart";
  Draw draw(1);
  for (int i = 0; i < 20; ++i) {
    if (separation_along(draw.direction(), a, X_WA, b, X_WB) > r.upper + rounding)
      return "a direction beats the upper bound";
  }
  return "";
}

/// The same for a pair read from bytes.
inline std::string fault_of_bytes(std::span<const std::uint8_t> bytes) {
  PairOfBytes reader(bytes);
  const std::optional<Shape> a = reader.shape();
  const std::optional<Shape> b = reader.shape();
  if (!a || !b) return "";
  const double size = radius_about(*a, Vec3::Zero()) + radius_about(*b, Vec3::Zero());
  const Pose X_WA = reader.pose(size);
  return fault_of_distance(*a, X_WA, *b, reader.pose(size));
}

}  // namespace rigor::test
