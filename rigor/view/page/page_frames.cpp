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
  constexpr int few = 16, crowd = 1000, coarsest = 255;
  const bool is_crowd = count > crowd && std::isfinite(smallest);
  const double step =
      power_of_two_below(is_crowd ? 4e-3 * smallest : std::min(2e-5 * extent, 2e-3 * smallest));
  PageScale scale{0.5 * (around.lower + around.upper), extent, step / (count <= few ? 64 : 1), 4 * step,
                  std::isfinite(smallest) ? smallest : extent};
  scale.is_crowd = is_crowd;
  if (is_crowd) {
    const double parts = std::ceil(32767 * packing_error / (2 * step / scale.body_radius));
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

std::shared_ptr<const State> phases_of(const State& state) {
  auto phases = std::make_shared<State>();
  phases->t = state.t;
  phases->x = state.x, phases->q = state.q, phases->P = state.P, phases->L = state.L;
  return phases;
}

PageFrames::PageFrames(const Model& model, const PageScale& scale) : chunk_{model, scale, {}} {
  for (int i = 0; i < model.body_count(); ++i) {
    if (model.body(i).motion != MotionType::fixed) chunk_.moving.push_back(i);
  }
  const int count = std::max(1, static_cast<int>(chunk_.moving.size()));
  chunk_size_ = at(std::clamp(bodies_times_frames / count, fewest_frames, most_frames));
}

std::optional<PagePacking> PageFrames::add(std::shared_ptr<const State> phases) {
  chunk_.states.push_back(std::move(phases));
  ++frame_count_;
  if (chunk_.states.size() == chunk_size_) return finish();
  return std::nullopt;
}

std::optional<PagePacking> PageFrames::finish() {
  if (chunk_.states.empty()) return std::nullopt;
  PagePacking packing = [chunk = chunk_] { return packed_frames(chunk); };
  chunk_.states.clear();
  return packing;
}

}  // namespace rigor
