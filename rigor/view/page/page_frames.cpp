#include "rigor/view/page/page_frames.hpp"

#include "rigor/core/index.hpp"
#include "rigor/geometry/shape/aabb.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {

namespace {

/// Size of a chunk: large enough that its first frame costs little, small enough to be decoded instantly.
constexpr int bodies_times_frames = 200000;
constexpr int fewest_frames = 16, most_frames = 256;

/// Velocities are quantised to a part of the largest one of the chunk, angular and linear ones separately.
double velocity_step(double largest, int parts) {
  const bool is_usable = std::isfinite(largest) && largest / parts > std::numeric_limits<double>::min();
  return is_usable ? power_of_two_below(2 * largest / parts) : 1;
}

}  // namespace

PageScale page_scale(const Model& model, const State& start) {
  // Bounding box of the moving bodies at the start, and the smallest of their radii.
  Aabb around{Vec3::Constant(std::numeric_limits<double>::infinity()),
              Vec3::Constant(-std::numeric_limits<double>::infinity())};
  double smallest = std::numeric_limits<double>::infinity();
  int count = 0;
  for (int i = 0; i < model.body_count(); ++i) {
    const Body& body = model.body(i);
    if (body.motion == MotionType::fixed) continue;
    ++count;
    const double radius = std::isfinite(body.bounding_radius) ? body.bounding_radius : 0;
    const Vec3 x = start.position(i);
    around = around.united(Aabb{x, x}.grown(radius));
    if (radius > 0) smallest = std::min(smallest, radius);
  }
  // Without moving bodies any scale will do.
  if (!(around.lower.array() <= around.upper.array()).all())
    return {Vec3::Zero(), 1, power_of_two_below(2e-5), power_of_two_below(8e-5), 1};
  // The steps follow from the extent, but stay small compared with the smallest body.
  const double diagonal = (around.upper - around.lower).norm();
  const double extent = diagonal > 0 ? diagonal : model.length_scale();
  const double step = power_of_two_below(std::min(2e-5 * extent, 2e-3 * smallest));
  PageScale scale{0.5 * (around.lower + around.upper), extent, step / (count <= 64 ? 64 : 1), 4 * step,
                  std::isfinite(smallest) ? smallest : extent};
  constexpr int crowd = 1000, coarsest = 255;
  scale.is_crowd = count > crowd;
  if (scale.is_crowd) {
    const double parts = std::floor(32767 * packing_error / (2 * step / scale.body_radius));
    scale.orientation_parts = static_cast<int>(std::clamp<double>(parts, coarsest, 32767));
    scale.velocity_parts = 256;
  }
  return scale;
}

PackedQuaternion packed(const Quat& q, int parts) {
  // Drop the component of largest magnitude, which follows from the unit norm; a sign makes it positive.
  const std::array<double, 4> all = {q.w(), q.x(), q.y(), q.z()};
  int largest = 0;
  for (int i = 1; i < 4; ++i) {
    if (std::abs(all[at(i)]) > std::abs(all[at(largest)])) largest = i;
  }
  const double sign = all[at(largest)] < 0 ? -1 : 1;
  const double step = 0.70710678118654757 / parts;
  // Quantise the other three.
  PackedQuaternion result{largest, {}};
  std::size_t place = 0;
  for (int i = 0; i < 4; ++i) {
    if (i != largest) result.others[place++] = quantised(sign * all[at(i)] / q.norm(), step);
  }
  return result;
}

PageFrames::PageFrames(const Model& model, const PageScale& scale) : model_(model), scale_(scale) {
  for (int i = 0; i < model.body_count(); ++i) {
    if (model.body(i).motion != MotionType::fixed) moving_.push_back(i);
  }
  const int count = std::max(1, static_cast<int>(moving_.size()));
  chunk_size_ = std::clamp(bodies_times_frames / count, fewest_frames, most_frames);
  columns_.resize(moving_.size());
}

std::optional<PageBlock> PageFrames::add(const State& state) {
  for (std::size_t i = 0; i < moving_.size(); ++i) {
    const int body = moving_[i];
    BodyColumns& columns = columns_[i];
    const Vec3 x = state.position(body) - scale_.origin;
    const PackedQuaternion q = packed(state.orientation(body), scale_.orientation_parts);
    const Vec3 v = linear_velocity(model_, state, body), w = angular_velocity(model_, state, body);
    columns.pose[3].push_back(q.largest);
    for (int k = 0; k < 3; ++k) {
      const std::size_t place = at(k);
      columns.pose[place].push_back(quantised(x[k], scale_.position_step));
      columns.pose[4 + place].push_back(q.others[place]);
      columns.velocity[place].push_back(v[k]);
      columns.velocity[3 + place].push_back(w[k]);
    }
  }
  ++frame_count_;
  if (++frames_in_chunk_ == chunk_size_) return finish();
  return std::nullopt;
}

std::optional<PageBlock> PageFrames::finish() {
  if (frames_in_chunk_ == 0) return std::nullopt;
  // The velocity steps follow from the largest components of the chunk.
  double speed = 0, spin = 0;
  for (const BodyColumns& columns : columns_) {
    for (std::size_t k = 0; k < 6; ++k) {
      double& largest = k < 3 ? speed : spin;
      for (const double value : columns.velocity[k]) largest = std::max(largest, std::abs(value));
    }
  }
  const double speed_step = velocity_step(speed, scale_.velocity_parts),
               spin_step = velocity_step(spin, scale_.velocity_parts);

  // The header of the chunk.
  std::string bytes;
  append_f64(speed_step, bytes);
  append_f64(spin_step, bytes);
  append_u32(static_cast<std::uint32_t>(frames_in_chunk_), bytes);
  append_u32(static_cast<std::uint32_t>(moving_.size()), bytes);
  // Thirteen columns per body: those of the pose are quantised already, those of the velocities are now.
  std::vector<std::int64_t> whole;
  for (BodyColumns& columns : columns_) {
    for (std::vector<std::int64_t>& column : columns.pose) {
      append_column(column, bytes);
      column.clear();
    }
    for (std::size_t k = 0; k < 6; ++k) {
      whole.clear();
      for (const double value : columns.velocity[k])
        whole.push_back(quantised(value, k < 3 ? speed_step : spin_step));
      append_column(whole, bytes);
      columns.velocity[k].clear();
    }
  }
  frames_in_chunk_ = 0;
  return make_page_block("frames", bytes);
}

}  // namespace rigor
