#include "rigor/view/3d/sample_grid.hpp"

#include "rigor/core/assert.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

/// Smallest integer that is not below the value, clamped to 0 ... limit.
int clamped_ceil(double value, int limit) {
  if (!(value > 0)) return 0;
  if (value >= limit) return limit;
  const int whole = static_cast<int>(value);
  return whole + (value > whole ? 1 : 0);
}

/// Keeps the nearer of two things at a sample. It has no branches, so that loops over it vectorise.
inline void keep_nearer(float here, std::uint32_t id, float& nearness, std::uint32_t& kept_id) {
  const std::uint32_t is_nearer = here > nearness ? ~std::uint32_t{0} : 0;
  nearness = here > nearness ? here : nearness;
  kept_id = (id & is_nearer) | (kept_id & ~is_nearer);
}

/// Bounds of the columns or rows that a ball may cover: those of its outline along one axis of the picture.
///
/// In the plane of the line of sight (z) and the axis (x), the rays that touch the circle about (x, z) of
/// radius r have the slopes (x z ± r √(x² + z² - r²)) / (z² - r²).
struct Bounds {
  double lower, upper;  ///< Slopes.
};
Bounds outline_bounds(double x, double z, double r) {
  const double denominator = z * z - r * r;
  if (z <= r) return {-HUGE_VAL, HUGE_VAL};
  const double reach = r * std::sqrt(x * x + denominator);
  return {(x * z - reach) / denominator, (x * z + reach) / denominator};
}

}  // namespace

Outline::Outline(std::span<const Vec2> corners) {
  RIGOR_ASSERT(corners.size() <= most_corners);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 &a = corners[i], &b = corners[i + 1 < corners.size() ? i + 1 : 0];
    if (a.y() == b.y()) continue;
    const bool runs_down = b.y() > a.y();
    const Vec2 &upper = runs_down ? a : b, &lower = runs_down ? b : a;
    edges_[count_++] = {upper.x(), upper.y(), lower.y(), (lower.x() - upper.x()) / (lower.y() - upper.y()),
                        runs_down};
  }
}

void SampleGrid::clear(int width, int height) {
  width_ = width, height_ = height;
  const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  nearness_.assign(count, 0);
  ids_.resize(count);  // The id of a sample that sees nothing is never read.
  begin_.resize(static_cast<std::size_t>(height));
  end_.resize(static_cast<std::size_t>(height));
}

int SampleGrid::first_row(double y) const {
  return clamped_ceil(y - offset_y_, height_);
}

void SampleGrid::fill(const Outline& outline, const NearnessPlane& plane, std::uint32_t id) {
  // Scan conversion: walk along the edges and note where the face begins and ends in each row.
  int top = height_, bottom = 0;
  for (const OutlineEdge& edge : outline.edges()) {
    const int first = first_row(edge.y), last = first_row(edge.y_lower);
    if (first == last) continue;
    std::vector<int>& side = edge.is_left ? begin_ : end_;
    const double x = edge.x - offset_x_ + (offset_y_ - edge.y) * edge.slope;
    for (int row = first; row < last; ++row)
      side[static_cast<std::size_t>(row)] = clamped_ceil(x + row * edge.slope, width_);
    top = std::min(top, first), bottom = std::max(bottom, last);
  }
  for (int row = top; row < bottom; ++row)
    fill_row(row, begin_[static_cast<std::size_t>(row)], end_[static_cast<std::size_t>(row)], plane, id);
}

void SampleGrid::fill_row(int row, int begin, int end, const NearnessPlane& plane, std::uint32_t id) {
  const float constant =
      static_cast<float>(plane.constant + plane.along_x * offset_x_ + plane.along_y * (row + offset_y_));
  const float along_x = static_cast<float>(plane.along_x);
  float* const nearness = &nearness_[start(row)];
  std::uint32_t* const ids = &ids_[start(row)];
  for (int column = begin; column < end; ++column) {
    const float here = constant + along_x * static_cast<float>(column);
    keep_nearer(here, id, nearness[column], ids[column]);
  }
}

void SampleGrid::fill(const NearnessPlane& plane, std::uint32_t id) {
  for (int row = 0; row < height_; ++row) fill_row(row, 0, width_, plane, id);
}

void SampleGrid::fill(const ViewSpaceBall& ball, const Projection& projection, std::uint32_t id) {
  const double f = projection.focal_length();
  const Bounds across = outline_bounds(ball.p_K.x(), ball.p_K.z(), ball.radius);
  const Bounds down = outline_bounds(ball.p_K.y(), ball.p_K.z(), ball.radius);
  if (ball.p_K.z() <= 0) return;
  const int begin = clamped_ceil(projection.center_x() + f * across.lower - offset_x_, width_);
  const int end = clamped_ceil(projection.center_x() + f * across.upper - offset_x_, width_);
  const int top = first_row(projection.center_y() + f * down.lower);
  const int bottom = first_row(projection.center_y() + f * down.upper);

  // A ray is z d with d = (u, v, 1). With b = d·c and k = |c|² - r², its nearer intersection has
  //   1/z = (b + √D) / k,   D = b² - |d|² k = |d|² r² - |c × d|²,
  // and c × d = c × (d - c/c_z) does not cancel for a small ball.
  const double cx = ball.p_K.x(), cy = ball.p_K.y(), cz = ball.p_K.z(), r = ball.radius;
  const float x = static_cast<float>(cx), y = static_cast<float>(cy), z = static_cast<float>(cz);
  const float r2 = static_cast<float>(r * r),
              inverse_k = static_cast<float>(1 / (ball.p_K.squaredNorm() - r * r));
  const double u_begin = (offset_x_ - projection.center_x()) / f;
  const float u0 = static_cast<float>(u_begin), du = static_cast<float>(1 / f);
  const float e0 = static_cast<float>(u_begin - cx / cz);
  for (int row = top; row < bottom; ++row) {
    const double v_row = (row + offset_y_ - projection.center_y()) / f;
    const float v = static_cast<float>(v_row), ev = static_cast<float>(v_row - cy / cz);
    float* const nearness = &nearness_[start(row)];
    std::uint32_t* const ids = &ids_[start(row)];
    for (int column = begin; column < end; ++column) {
      const float step = du * static_cast<float>(column);
      const float u = u0 + step, eu = e0 + step;
      const float turn = x * ev - y * eu;
      const float D = (u * u + v * v + 1) * r2 - (z * z * (eu * eu + ev * ev) + turn * turn);
      const float here = (u * x + v * y + z + std::sqrt(std::max(D, 0.0F))) * inverse_k;
      keep_nearer(D >= 0 ? here : -1.0F, id, nearness[column], ids[column]);
    }
  }
}

void SampleGrid::fill(const ParallelBall& ball, std::uint32_t id) {
  const int top = first_row(ball.y - ball.radius_px), bottom = first_row(ball.y + ball.radius_px);
  for (int row = top; row < bottom; ++row) {
    const double dy = (row + offset_y_ - ball.y) / ball.radius_px;
    const double half = ball.radius_px * std::sqrt(std::max(0.0, 1 - dy * dy));
    const int begin = clamped_ceil(ball.x - half - offset_x_, width_);
    const int end = clamped_ceil(ball.x + half - offset_x_, width_);
    for (int column = begin; column < end; ++column) {
      const double dx = (column + offset_x_ - ball.x) / ball.radius_px;
      const double height = std::sqrt(std::max(0.0, 1 - dx * dx - dy * dy));
      const float here = static_cast<float>(ball.nearness + ball.radius * height);
      const std::size_t at = start(row) + static_cast<std::size_t>(column);
      if (!(here > nearness_[at])) continue;
      nearness_[at] = here;
      ids_[at] = id;
    }
  }
}

}  // namespace rigor
