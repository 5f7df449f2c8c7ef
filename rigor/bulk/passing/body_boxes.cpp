#include "rigor/bulk/passing/body_boxes.hpp"

#include "rigor/core/index.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

void BodyBoxes::set_body(int body, const std::optional<Aabb>& box_B) {
  if (at(body) >= boxes_.size()) boxes_.resize(at(body) + 1);
  Box& box = boxes_[at(body)];
  box = {};
  if (!box_B || !box_B->lower.allFinite() || !box_B->upper.allFinite()) return;
  // Larger by more than the rounding to 32 bits.
  constexpr double rounding = 1e-6;
  const Vec3 center = 0.5 * (box_B->lower + box_B->upper), half = 0.5 * (box_B->upper - box_B->lower);
  box = {center.cast<float>(), (half + rounding * (half + center.cwiseAbs())).cast<float>()};
}

bool BodyBoxes::are_parted(const BulkBodies& bodies, int body_A, int body_B, const Way& A,
                           const Way& B) const {
  const Box &a = boxes_[at(body_A)], &b = boxes_[at(body_B)];
  if (!a.is_known() || !b.is_known()) return false;
  const Mat3 R_WA = bodies.q[at(body_A)].toRotationMatrix(), R_WB = bodies.q[at(body_B)].toRotationMatrix();
  // The boxes' centres at the beginning and, but for rotations, at the end.
  const Vec3 first = (bodies.x[at(body_B)] - bodies.x[at(body_A)]) + R_WB * b.center_B.cast<double>() -
                     R_WA * a.center_B.cast<double>(),
             last = first + B.dp_W - A.dp_W;
  const double turned = A.turned + B.turned;
  // Along the axes of a box: it reaches as far as it is long, the other one as its edges do.
  const Mat3 edges = (R_WA.transpose() * R_WB).cwiseAbs();
  const Vec3 half_A = a.half.cast<double>(), half_B = b.half.cast<double>();
  const auto is_beyond = [&](const Mat3& R, const Vec3& reach) {
    const Vec3 from = R.transpose() * first, to = R.transpose() * last;
    for (int k = 0; k < 3; ++k) {
      const double least = std::min(std::abs(from[k]), std::abs(to[k]));
      if (from[k] * to[k] > 0 && least > reach[k] + turned) return true;
    }
    return false;
  };
  return is_beyond(R_WA, half_A + edges * half_B) || is_beyond(R_WB, half_B + edges.transpose() * half_A);
}

std::optional<Aabb> BodyBoxes::swept(const BulkBodies& bodies, int body, const Way& way) const {
  const Box& box = boxes_[at(body)];
  if (!box.is_known()) return std::nullopt;
  const Mat3 R_WB = bodies.q[at(body)].toRotationMatrix();
  const Vec3 begin = R_WB * box.center_B.cast<double>(), end = begin + way.dp_W,
             half = R_WB.cwiseAbs() * box.half.cast<double>();
  return Aabb{begin.cwiseMin(end) - half, begin.cwiseMax(end) + half}.grown(way.turned);
}

}  // namespace rigor
