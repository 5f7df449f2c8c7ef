#pragma once

#include <array>
#include <cstdint>

namespace rigor {

/// One point of a manifold.
struct ManifoldPoint {
  float p[3];  ///< Midway between the witness points, relative to the centre of body A, along W's axes [m].
  float gap;   ///< [m], negative when overlapping.
  std::uint32_t
      feature;  ///< Names the features that meet; stable while they do, different within a manifold.
};

/// Where two convex shapes touch or nearly do: one normal and up to four points, in ascending order of
/// features.
struct Manifold {
  static constexpr int max_points = 4;

  float normal[3];  ///< Unit, from A to B, in W.
  int point_count = 0;
  std::array<ManifoldPoint, max_points> points;
};

/// A view of a manifold that is stored elsewhere.
struct ManifoldView {
  const float* normal = nullptr;  ///< A fourth number follows, so that lanes may load four.
  const ManifoldPoint* points = nullptr;
  int point_count = 0;

  ManifoldView() = default;
  ManifoldView(const float* n, const ManifoldPoint* p, int count)
      : normal(n), points(p), point_count(count) {}
  /// A view of a manifold that outlives it.
  explicit ManifoldView(const Manifold& manifold)
      : ManifoldView(manifold.normal, manifold.points.data(), manifold.point_count) {}
};

}  // namespace rigor
