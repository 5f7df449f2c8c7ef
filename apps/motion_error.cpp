#include "apps/motion_error.hpp"

#include "rigor/core/index.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rigor {

namespace {

/// Pose of the body frame B from a row of stored user frames.
struct BodyPlace {
  Vec3 p_WB;
  Quat q_WB;
};

BodyPlace place_of(const Body& body, const double* position, const double* orientation) {
  const Quat q_WU(orientation[0], orientation[1], orientation[2], orientation[3]);
  const Vec3 p_UB = body.X_BU.inverse().p;
  const Vec3 p_WB = Vec3::Map(position) + q_WU * p_UB;
  // The rotation from U to B is the same in both motions, so the rotation of U serves as well.
  return {p_WB, q_WU};
}

}  // namespace

double largest_point_distance(const Vec3& p_WB, const Quat& q_WB, const Vec3& p_WB_other,
                              const Quat& q_WB_other, double radius) {
  const Vec3 offset = p_WB - p_WB_other;
  // sin(θ/2) n.
  const Vec3 rotation = (q_WB * q_WB_other.conjugate()).vec();
  const double half_sine = rotation.norm();
  if (half_sine == 0 || radius == 0) return offset.norm();
  const Vec3 n = rotation / half_sine;
  const double along = offset.dot(n);
  const double across = (offset - along * n).norm();
  return std::hypot(across + 2 * half_sine * radius, along);
}

double point_radius(const Body& body) {
  return std::isfinite(body.bounding_radius) ? body.bounding_radius : 0;
}

double default_error_bound(const Model& model) {
  constexpr double share = 0.01;
  double radius = 0;
  for (const Body& body : model.bodies()) {
    if (body.motion == MotionType::dynamic) radius = std::max(radius, point_radius(body));
  }
  return share * (radius > 0 ? radius : model.length_scale());
}

std::optional<MotionError> ErrorMeasure::error() const {
  return has_time_ ? std::optional(error_) : std::nullopt;
}

void ErrorMeasure::note_time(double t) {
  has_time_ = true;
  error_.compared_until = t;
  if (error_.is_good_throughout) error_.good_until = t;
}

void ErrorMeasure::note_position(double distance, const std::string& body, double t) {
  if (distance > error_.position.value) error_.position = {distance, body, t};
  if (distance > bound_) error_.is_good_throughout = false;
}

void ErrorMeasure::note_angle(double angle, const std::string& body, double t) {
  if (angle > error_.angle.value) error_.angle = {angle, body, t};
}

ErrorOverTime::ErrorOverTime(std::shared_ptr<const Model> model, const Recording& reference, double bound,
                             double horizon)
    : ErrorMeasure(bound),
      model_(std::move(model)),
      reference_(reference),
      horizon_(horizon),
      reference_body_(common_dynamic_bodies(*model_, *reference.model)) {}

void ErrorOverTime::observe(const State& state, const Energy& energy) {
  const StoredTrajectory& motion = reference_.motion;
  const std::vector<double>& times = motion.time;
  while (next_ < times.size() && times[next_] < state.t && !is_same_output_time(times[next_], state.t))
    ++next_;
  const bool is_common = next_ < times.size() && is_same_output_time(times[next_], state.t);
  if (!is_common || reference_body_.empty()) return;
  if (state.t > horizon_ && !is_same_output_time(state.t, horizon_)) return;
  const TrajectorySample sample = make_sample(*model_, state, energy);
  for (const auto& [own, twin] : reference_body_) {
    const std::size_t i = at(own);
    const std::size_t k = next_ * motion.bodies.size() + at(twin);
    const Body& body = model_->body(own);
    const BodyPlace here = place_of(body, &sample.position[3 * i], &sample.orientation[4 * i]);
    const BodyPlace there =
        place_of(reference_.model->body(twin), &motion.position[3 * k], &motion.orientation[4 * k]);
    note_position(largest_point_distance(here.p_WB, here.q_WB, there.p_WB, there.q_WB, point_radius(body)),
                  body.name, state.t);
    note_angle(rotation_angle(there.q_WB, here.q_WB), body.name, state.t);
  }
  note_time(state.t);
}

ErrorAtPlaces::ErrorAtPlaces(std::shared_ptr<const Model> model, std::vector<ExpectedPlace> places,
                             double bound)
    : ErrorMeasure(bound), model_(std::move(model)), places_(std::move(places)) {}

void ErrorAtPlaces::observe(const State& state, const Energy& energy) {
  const auto is_now = [&](const ExpectedPlace& place) { return is_same_output_time(place.time, state.t); };
  if (std::none_of(places_.begin(), places_.end(), is_now)) return;
  const TrajectorySample sample = make_sample(*model_, state, energy);
  for (const ExpectedPlace& place : places_) {
    const std::optional<int> body = model_->find_body(place.body);
    if (!is_now(place) || !body) continue;
    const std::size_t i = at(*body);
    if (place.position)
      note_position((Vec3::Map(&sample.position[3 * i]) - *place.position).norm(), place.body, state.t);
    const double* const q = &sample.orientation[4 * i];
    if (place.orientation)
      note_angle(rotation_angle(*place.orientation, Quat(q[0], q[1], q[2], q[3])), place.body, state.t);
  }
  note_time(state.t);
}

}  // namespace rigor
