#include "rigor/bulk/passing/body_boxes.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

void BodyBoxes::set_body(int body, const std::optional<Aabb>& box_B) {
  if (at(body) >= boxes_.size()) boxes_.resize(at(body) + 1);
  Box& box = boxes_[at(body)];
  box = {};
  if (!box_B || !box_B->lower.allFinite() || !box_B->upper.allFinite()) return;
  box = {0.5 * (box_B->lower + box_B->upper), 0.5 * (box_B->upper - box_B->lower)};
}

void BodyBoxes::place(const BulkBodies& bodies) {
  placed_.resize(boxes_.size());
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    const Mat3 R_WB = bodies.q[i].toRotationMatrix();
    placed_[i] = {R_WB, R_WB * boxes_[i].center_B};
  }
}

bool BodyBoxes::are_parted(int body_A, int body_B, const Vec3& between_W, const Way& A, const Way& B) const {
  const Box &a = boxes_[at(body_A)], &b = boxes_[at(body_B)];
  if (!a.is_known() || !b.is_known()) return false;
  const Placed &in_A = placed_[at(body_A)], &in_B = placed_[at(body_B)];
  // The boxes' centres at the beginning and, but for rotations, at the end.
  const Vec3 first = between_W + in_B.center_W - in_A.center_W, last = first + B.dp_W - A.dp_W;
  const double turned = A.turned + B.turned;
  // Along the axes of a box: it reaches as far as it is long, the other one as its edges do.
  const Mat3 edges = (in_A.R_WB.transpose() * in_B.R_WB).cwiseAbs();
  const Vec3 reach_A = a.half + edges * b.half, reach_B = b.half + edges.transpose() * a.half;
  const auto is_beyond = [&](const Mat3& R, const Vec3& reach) {
    const Vec3 from = R.transpose() * first, to = R.transpose() * last;
    for (int k = 0; k < 3; ++k) {
      const double least = std::min(std::abs(from[k]), std::abs(to[k]));
      if (from[k] * to[k] > 0 && least > reach[k] + turned) return true;
    }
    return false;
  };
  return is_beyond(in_A.R_WB, reach_A) || is_beyond(in_B.R_WB, reach_B);
}

std::optional<Aabb> BodyBoxes::swept(int body, const Way& way) const {
  const Box& box = boxes_[at(body)];
  if (!box.is_known()) return std::nullopt;
  const Placed& placed = placed_[at(body)];
  const Vec3 half = placed.R_WB.cwiseAbs() * box.half, end = placed.center_W + way.dp_W;
  return Aabb{placed.center_W.cwiseMin(end) - half, placed.center_W.cwiseMax(end) + half}.grown(way.turned);
}

}  // namespace rigor
