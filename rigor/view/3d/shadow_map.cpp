#include "rigor/view/3d/shadow_map.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/math/rotation.hpp"

#include <limits>

namespace rigor {

void ShadowMap::draw(std::span<const ShownShape> shapes, const Vec3& sun_W, const Region& region, int size) {
  size_ = size;
  texel_ = 2 * region.radius / size;
  // Frame J of the map: a grid point is (x, y) / texel, with the corner of the map and the plane farthest
  // from the sun at zero.
  const Mat3 R_WJ = camera_axes(-sun_W, frame_with_z(sun_W).col(0));
  X_JW_ = Pose{R_WJ.transpose(), Vec3::Constant(region.radius) - R_WJ.transpose() * region.center};
  // Draw the shapes that reach into the region, the ones nearest to the sun first.
  grid_.clear(size, size);
  Occlusion occlusion({&grid_, 1}, size, size);
  for (const ShownShape& placed : nearest_first(shapes)) {
    poll_interrupt();
    if (std::holds_alternative<HalfSpace>(placed.shape->shape)) continue;
    const Vec3 center = X_JW_ * placed.X_WS.p;
    if ((center.array() < -placed.shape->radius).any() ||
        (center.array() > 2 * region.radius + placed.shape->radius).any()) {
      continue;
    }
    if (const Sphere* const sphere = std::get_if<Sphere>(&placed.shape->shape)) {
      draw_ball(placed, sphere->radius);
    } else {
      draw_surface(placed, occlusion);
    }
  }
  find_bounds();
}

void ShadowMap::find_bounds() {
  squares_ = (size_ + square - 1) / square;
  bounds_.clear();
  const std::size_t size = at(size_);
  std::vector<float> lowest(size), highest(size);
  for (int j = 0; j < squares_; ++j) {
    // Reduce each row of squares along its columns first (this loop vectorises), ...
    const int top = j * square, bottom = std::min(top + square + block - 1, size_);
    std::copy_n(grid_.nearness(top), size, lowest.begin());
    std::copy_n(grid_.nearness(top), size, highest.begin());
    for (int y = top + 1; y < bottom; ++y) {
      const float* const row = grid_.nearness(y);
      for (std::size_t x = 0; x < size; ++x) {
        lowest[x] = row[x] < lowest[x] ? row[x] : lowest[x];
        highest[x] = row[x] > highest[x] ? row[x] : highest[x];
      }
    }
    // ... and then along the row.
    for (int i = 0; i < squares_; ++i) {
      const long left = long{i} * square, right = std::min<long>(left + square + block - 1, size_);
      bounds_.push_back({*std::min_element(lowest.begin() + left, lowest.begin() + right),
                         *std::max_element(highest.begin() + left, highest.begin() + right)});
    }
  }
}

void ShadowMap::draw_ball(const ShownShape& placed, double radius) {
  const Vec3 p = X_JW_ * placed.X_WS.p;
  grid_.fill(SampleGrid::ParallelBall{p.x() / texel_, p.y() / texel_, radius / texel_, size_ * texel_ - p.z(),
                                      radius},
             1);
}

std::vector<ShownShape> ShadowMap::nearest_first(std::span<const ShownShape> shapes) const {
  std::vector<std::pair<double, std::size_t>> depths;
  depths.reserve(shapes.size());
  for (std::size_t i = 0; i < shapes.size(); ++i) depths.push_back({X_JW_.R.row(2).dot(shapes[i].X_WS.p), i});
  std::sort(depths.begin(), depths.end());
  std::vector<ShownShape> sorted;
  sorted.reserve(depths.size());
  for (const auto& [depth, i] : depths) sorted.push_back(shapes[i]);
  return sorted;
}

void ShadowMap::draw_surface(const ShownShape& placed, Occlusion& occlusion) {
  const Surface& surface = *placed.shape->surface;
  const Pose X_JS = X_JW_ * placed.X_WS;
  const double far = size_ * texel_;
  // Vertices in texels, and the bounding box of the shape on the map.
  points_.clear();
  PictureBox box{HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL, 0};
  for (const Vec3& vertex : surface.vertices) {
    const Vec3 p = X_JS * vertex;
    points_.push_back({p.x() / texel_, p.y() / texel_, p.z()});
    const Vec3& q = points_.back();
    box = {std::min(box.left, q.x()), std::max(box.right, q.x()), std::min(box.top, q.y()),
           std::max(box.bottom, q.y()), std::max(box.nearness, far - q.z())};
  }
  if (occlusion.hides(box)) return;
  occlusion.add(box);
  for (const Surface::Face& face : surface.faces) {
    const Vec3 normal = X_JS.R * face.normal;
    // Only the faces that point towards the sun are drawn.
    if (normal.z() >= 0) continue;
    corners_.clear();
    for (int i = 0; i < face.count; ++i) {
      const Vec3& p = points_[at(surface.corners[at(face.begin + i)])];
      corners_.push_back(p.head<2>());
    }
    // The plane n·p = d is solved for the depth z; the nearness is far - z.
    const Vec3& p = points_[at(surface.corners[at(face.begin)])];
    const double d = normal.dot(Vec3(texel_ * p.x(), texel_ * p.y(), p.z()));
    grid_.fill(Outline(corners_),
               NearnessPlane{far - d / normal.z(), texel_ * normal.x() / normal.z(),
                             texel_ * normal.y() / normal.z()},
               1);
  }
}

void ShadowMap::set_camera(const Pose& X_KW) {
  const Pose X_JK = X_JW_ * X_KW.inverse();
  const Vec3 scale(1 / texel_, 1 / texel_, -1);
  texels_of_K_.topRows<3>() = (scale.asDiagonal() * X_JK.R).cast<float>();
  texels_at_K_.head<3>() = (scale.cwiseProduct(X_JK.p) + Vec3(0, 0, size_ * texel_)).cast<float>();
}

float ShadowMap::light(const Eigen::Vector3f& p_K, const Eigen::Vector3f& normal_K) const {
  // The lookup is a little above the surface, so that it does not shade itself where the map is coarse.
  constexpr float lift = 2;
  const float texel = static_cast<float>(texel_);
  const Eigen::Vector3f above = p_K + lift * texel * normal_K;
  const Eigen::Vector4f p = texels_of_K_.col(0) * above.x() + texels_of_K_.col(1) * above.y() +
                            texels_of_K_.col(2) * above.z() + texels_at_K_;
  // The 4 × 4 block of texels around the point; outside the map everything is lit.
  const float x = p.x() - 2, y = p.y() - 2;
  if (!(x >= 0 && y >= 0 && x < static_cast<float>(size_ - 4) && y < static_cast<float>(size_ - 4))) return 1;
  const int column = static_cast<int>(x), row = static_cast<int>(y);
  const float fx = x - static_cast<float>(column), fy = y - static_cast<float>(row);
  // Points behind the region are treated as if they were on its back: empty texels have nearness zero.
  const float nearness = std::max(p.z() + texel, 0.0F);
  const Bounds& bounds = bounds_[at(row / square * squares_ + column / square)];
  // The bounds of the block often decide without a look at its texels.
  if (bounds.highest <= nearness) return 1;
  if (bounds.lowest > nearness) return 0;
  // 1 where the map is nearer to the sun, otherwise 0; written so that it vectorises.
  const auto hides = [&](int j) {
    using Texels = Eigen::Array4f;
    const float* const map = grid_.nearness(row + j) + column;
    const Texels step = (Eigen::Map<const Texels>(map) - nearness) * std::numeric_limits<float>::max();
    return Texels(step.max(Texels::Zero()).min(Texels::Ones()));
  };
  // Percentage-closer filtering: inner texels count fully, outer ones by the position in the texel.
  const Eigen::Array4f down = (1 - fy) * hides(0) + hides(1) + hides(2) + fy * hides(3);
  const float hidden = (1 - fx) * down[0] + down[1] + down[2] + fx * down[3];
  return 1 - hidden * (1 / 9.0F);
}

}  // namespace rigor
