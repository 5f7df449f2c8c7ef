#include "apps/motion_comparison.hpp"

#include "rigor/core/index.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace rigor {

namespace {

Vec3 vector_at(std::span<const double> values, std::size_t row) {
  return Vec3::Map(&values[3 * row]);
}

Quat quaternion_at(std::span<const double> values, std::size_t row) {
  const double* const q = &values[4 * row];
  return {q[0], q[1], q[2], q[3]};
}

void keep_larger(double value, const std::string& body, LargestDifference& largest) {
  if (value > largest.value) largest = {value, body};
}

}  // namespace

bool is_same_output_time(double a, double b) {
  constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();
  return std::abs(a - b) <= rounding * std::max(std::abs(a), std::abs(b));
}

std::map<int, int> common_dynamic_bodies(const Model& model, const Model& reference) {
  std::map<std::string, int> by_name;
  for (int i = 0; i < reference.body_count(); ++i) {
    if (reference.body(i).motion == MotionType::dynamic) by_name[reference.body(i).name] = i;
  }
  std::map<int, int> common;
  for (int i = 0; i < model.body_count(); ++i) {
    const auto twin = by_name.find(model.body(i).name);
    if (model.body(i).motion == MotionType::dynamic && twin != by_name.end()) common[i] = twin->second;
  }
  return common;
}

double rotation_angle(const Quat& from, const Quat& to) {
  const Quat turn = from.conjugate() * to;
  return 2 * std::atan2(turn.vec().norm(), std::abs(turn.w()));
}

void MotionComparison::begin(const Scene& scene) {
  ++run_count_;
  model_ = scene.model;
  next_ = 0;
  common_.reset();
  if (is_first()) {
    reference_.emplace(scene, most_bytes_);
  } else {
    reference_body_ = common_dynamic_bodies(*model_, *reference_->recording().model);
  }
}

void MotionComparison::observe(const State& state, const Energy& energy) {
  if (is_first()) {
    reference_->write(make_sample(*model_, state, energy), {});
    return;
  }
  const std::vector<double>& times = reference_->recording().motion.time;
  while (next_ < times.size() && times[next_] < state.t && !is_same_output_time(times[next_], state.t))
    ++next_;
  if (next_ == times.size() || !is_same_output_time(times[next_], state.t)) return;
  common_ = next_;
  sample_ = make_sample(*model_, state, energy);
}

std::optional<MotionDifference> MotionComparison::finish() {
  if (is_first() || !common_ || reference_body_.empty()) return std::nullopt;
  return difference_at(*common_);
}

MotionDifference MotionComparison::difference_at(std::size_t frame) {
  const StoredTrajectory& reference = reference_->recording().motion;
  MotionDifference difference{.time = reference.time[frame]};
  for (const auto& [body, twin] : reference_body_) {
    const std::size_t own = at(body);
    const std::size_t other = frame * reference.bodies.size() + at(twin);
    const std::string& name = model_->body(body).name;
    const auto distance = [&](const std::vector<double>& mine, const std::vector<double>& theirs) {
      return (vector_at(mine, own) - vector_at(theirs, other)).norm();
    };
    keep_larger(distance(sample_.position, reference.position), name, difference.position);
    keep_larger(
        rotation_angle(quaternion_at(reference.orientation, other), quaternion_at(sample_.orientation, own)),
        name, difference.rotation);
    keep_larger(distance(sample_.velocity, reference.velocity), name, difference.velocity);
    keep_larger(distance(sample_.angular_velocity, reference.angular_velocity), name, difference.spin);
  }
  return difference;
}

}  // namespace rigor
