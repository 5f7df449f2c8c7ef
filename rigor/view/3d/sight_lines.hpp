#pragma once

#include "rigor/view/3d/drawn_scene.hpp"

#include <span>
#include <vector>

namespace rigor {

/// The lines of sight from an eye to what moves, and what stands still between them.
///
/// Not all bodies at all moments are looked at, but some hundred of these, evenly chosen. Planes hide
/// nothing: they are not drawn from behind.
class SightLines {
 public:
  /// poses: the bodies' user frames at some moments, body_count per moment. The scene must outlive this
  /// object.
  SightLines(const DrawnScene& scene, std::span<const Pose> poses);

  /// Part of the moving bodies at these moments that something hides from the eye [m], from 0 to 1.
  double hidden_part(const Vec3& eye) const;
  /// Indices in DrawnScene::shapes of what stands still and hides more than a few of them, ascending.
  std::vector<std::size_t> hiding(const Vec3& eye) const;

 private:
  struct Obstacle {
    std::size_t index;  ///< In DrawnScene::shapes.
    const DrawnShape* shape;
    Pose X_WS;
  };
  struct Target {
    Vec3 center;    ///< p_W [m].
    double radius;  ///< [m].
  };
  static Vec3 nearest_point(const Target& target, const Vec3& eye);
  static bool hides(const Obstacle& obstacle, const Vec3& eye, const Vec3& point);

  std::vector<Obstacle> obstacles_;
  std::vector<Target> targets_;
};

}  // namespace rigor
