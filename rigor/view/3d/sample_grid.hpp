#pragma once

#include "rigor/core/index.hpp"
#include "rigor/view/3d/camera.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace rigor {

/// One edge of a convex outline on the picture, from its upper to its lower end.
struct OutlineEdge {
  double x, y;     ///< Upper end [px].
  double y_lower;  ///< [px].
  double slope;    ///< dx/dy.
  bool is_left;    ///< The interior lies to the right of it.
};

/// Outline of a convex face that is seen from outside.
class Outline {
 public:
  static constexpr int most_corners = 64;

  /// Corners counter-clockwise as one sees them: on the picture, whose y runs down, left edges run down.
  /// At most most_corners.
  explicit Outline(std::span<const Vec2> corners);
  std::span<const OutlineEdge> edges() const { return {edges_, at(count_)}; }

 private:
  OutlineEdge edges_[most_corners];
  int count_ = 0;
};

/// A ball in the camera's frame.
struct ViewSpaceBall {
  Vec3 p_K;       ///< Centre [m].
  double radius;  ///< [m]; the eye is outside.
};

/// A grid with one sample per pixel, at the same offset in each: what is nearest there and how near it is.
/// Whether a sample is inside a face is decided by comparing its place with the face's edges; a sample on
/// the common edge of two faces belongs to exactly one of them.
class SampleGrid {
 public:
  /// offset_x, offset_y: offset of the sample in its pixel, 0 to 1.
  SampleGrid(double offset_x, double offset_y) : offset_x_(offset_x), offset_y_(offset_y) {}

  void clear(int width, int height);
  void fill(const Outline& outline, const NearnessPlane& plane, std::uint32_t id);
  void fill(const ViewSpaceBall& ball, const Projection& projection, std::uint32_t id);
  /// A ball seen along parallel lines, as from the sun: center and radius_px in pixels; its nearness is that
  /// of its center and grows by `radius` towards the eye.
  struct ParallelBall {
    double x, y, radius_px, nearness, radius;
  };
  void fill(const ParallelBall& ball, std::uint32_t id);
  /// All samples where the plane's nearness is positive.
  void fill(const NearnessPlane& plane, std::uint32_t id);

  double offset_x() const { return offset_x_; }
  double offset_y() const { return offset_y_; }
  const float* nearness(int row) const { return &nearness_[start(row)]; }
  /// Only where the nearness is positive; elsewhere the sample sees nothing.
  const std::uint32_t* ids(int row) const { return &ids_[start(row)]; }

 private:
  std::size_t start(int row) const { return at(row) * at(width_); }
  int first_row(double y) const;
  void fill_row(int row, int begin, int end, const NearnessPlane& plane, std::uint32_t id);

  double offset_x_, offset_y_;
  int width_ = 0, height_ = 0;
  std::vector<float> nearness_;
  std::vector<std::uint32_t> ids_;
  std::vector<int> begin_, end_;  ///< Scratch: columns of a face in each row.
};

}  // namespace rigor
