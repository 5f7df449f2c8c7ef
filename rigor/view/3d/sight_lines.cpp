#include "rigor/view/3d/sight_lines.hpp"

#include "rigor/core/index.hpp"
#include "rigor/geometry/rays/ray_cast.hpp"

#include <algorithm>

namespace rigor {

namespace {

constexpr std::size_t most_moments = 24, most_shapes = 16;

bool is_plane(const DrawnShape& shape) {
  return std::holds_alternative<HalfSpace>(shape.shape);
}

}  // namespace

SightLines::SightLines(const DrawnScene& scene, std::span<const Pose> poses) {
  const std::size_t n = at(scene.body_count), moments = n > 0 ? poses.size() / n : 0;
  if (moments == 0) return;
  std::vector<const DrawnShape*> moving;
  for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
    const DrawnShape& shape = scene.shapes[i];
    if (shape.is_joint || is_plane(shape)) continue;
    if (shape.can_move) {
      moving.push_back(&shape);
    } else {
      obstacles_.push_back({i, &shape, poses[at(shape.body)] * shape.X_US});
    }
  }
  if (obstacles_.empty() || moving.empty()) return;

  // Evenly chosen moments; of many bodies others at each moment.
  const std::size_t looks = std::min(moments, most_moments), stride = (moving.size() - 1) / most_shapes + 1;
  for (std::size_t look = 0; look < looks; ++look) {
    const std::size_t moment = looks > 1 ? look * (moments - 1) / (looks - 1) : 0;
    for (std::size_t i = look % stride; i < moving.size(); i += stride) {
      const Pose X_WS = poses[moment * n + at(moving[i]->body)] * moving[i]->X_US;
      targets_.push_back({X_WS.p, moving[i]->radius});
    }
  }
}

/// What the body lies on does not hide it: it is looked for where it is nearest to the eye.
Vec3 SightLines::nearest_point(const Target& target, const Vec3& eye) {
  const Vec3 sight = eye - target.center;
  const double length = sight.norm();
  if (!(length > 0)) return target.center;
  return target.center + std::min(0.7 * target.radius, 0.5 * length) / length * sight;
}

bool SightLines::hides(const Obstacle& obstacle, const Vec3& eye, const Vec3& point) {
  // A line that passes the ball around the shape needs no closer look.
  const Vec3 sight = point - eye, to_shape = obstacle.X_WS.p - eye;
  const double share = std::clamp(to_shape.dot(sight) / sight.squaredNorm(), 0.0, 1.0);
  if ((to_shape - share * sight).norm() > obstacle.shape->radius) return false;
  constexpr double just_before = 0.999;
  return find_ray_hit(obstacle.shape->shape, obstacle.X_WS, {eye, sight, just_before}).has_value();
}

double SightLines::hidden_part(const Vec3& eye) const {
  if (targets_.empty()) return 0;
  const auto is_hidden = [&](const Target& target) {
    const Vec3 point = nearest_point(target, eye);
    return std::any_of(obstacles_.begin(), obstacles_.end(),
                       [&](const Obstacle& obstacle) { return hides(obstacle, eye, point); });
  };
  const auto hidden = std::count_if(targets_.begin(), targets_.end(), is_hidden);
  return static_cast<double>(hidden) / static_cast<double>(targets_.size());
}

std::vector<std::size_t> SightLines::hiding(const Vec3& eye) const {
  constexpr double few = 0.04;
  const double least = few * static_cast<double>(targets_.size());
  std::vector<std::size_t> found;
  for (const Obstacle& obstacle : obstacles_) {
    const auto hidden = std::count_if(targets_.begin(), targets_.end(), [&](const Target& target) {
      return hides(obstacle, eye, nearest_point(target, eye));
    });
    if (hidden > 0 && static_cast<double>(hidden) >= least) found.push_back(obstacle.index);
  }
  return found;
}

}  // namespace rigor
