// The calls of a BulkSimulation for bodies by their handles, arrays, and sensors.

#include "rigor/bulk/state/prescribed_bodies.hpp"
#include "rigor/core/index.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/sim/bulk/bulk_simulation.hpp"

#include <cstddef>
#include <utility>

namespace rigor {

namespace {

template <class Value, class Read>
std::optional<Value> read_if(const std::optional<int>& body, const Read& read) {
  return body ? std::optional<Value>(read(*body)) : std::nullopt;
}

}  // namespace

std::optional<Pose> BulkSimulation::pose(const BodyId& body) const {
  return read_if<Pose>(index_of(body), [this](int i) { return pose(i); });
}

std::optional<Vec3> BulkSimulation::velocity(const BodyId& body) const {
  return read_if<Vec3>(index_of(body), [this](int i) { return velocity(i); });
}

std::optional<Vec3> BulkSimulation::angular_velocity(const BodyId& body) const {
  return read_if<Vec3>(index_of(body), [this](int i) { return angular_velocity(i); });
}

std::optional<bool> BulkSimulation::is_asleep(const BodyId& body) const {
  return read_if<bool>(index_of(body), [this](int i) { return is_asleep(i); });
}

/// Acts on a dynamic body, if the numbers are finite.
template <class Act>
BulkStatus BulkSimulation::act_on(const BodyId& body, const std::array<Vec3, 2>& numbers, const Act& act) {
  const std::optional<int> i = index_of(body);
  if (!i) return BulkStatus::no_such_body;
  if (model_->body(*i).motion != MotionType::dynamic) return BulkStatus::not_dynamic;
  if (!numbers[0].allFinite() || !numbers[1].allFinite()) return BulkStatus::not_finite;
  act(*i);
  return BulkStatus::done;
}

BulkStatus BulkSimulation::apply_force(const BodyId& body, const Vec3& f_W) {
  return act_on(body, {f_W, Vec3::Zero()}, [&](int i) { apply_force(i, f_W); });
}

BulkStatus BulkSimulation::apply_force(const BodyId& body, const Vec3& f_W, const Vec3& p_W) {
  return act_on(body, {f_W, p_W}, [&](int i) { apply_force(i, f_W, p_W); });
}

BulkStatus BulkSimulation::apply_torque(const BodyId& body, const Vec3& tau_W) {
  return act_on(body, {tau_W, Vec3::Zero()}, [&](int i) { apply_torque(i, tau_W); });
}

BulkStatus BulkSimulation::apply_impulse(const BodyId& body, const Vec3& j_W) {
  return act_on(body, {j_W, Vec3::Zero()}, [&](int i) { apply_impulse(i, j_W); });
}

BulkStatus BulkSimulation::apply_impulse(const BodyId& body, const Vec3& j_W, const Vec3& p_W) {
  return act_on(body, {j_W, p_W}, [&](int i) { apply_impulse(i, j_W, p_W); });
}

BulkStatus BulkSimulation::apply_angular_impulse(const BodyId& body, const Vec3& l_W) {
  return act_on(body, {l_W, Vec3::Zero()}, [&](int i) { apply_angular_impulse(i, l_W); });
}

BulkStatus BulkSimulation::set_velocity(const BodyId& body, const Vec3& v_W, const Vec3& w_W) {
  return act_on(body, {v_W, w_W}, [&](int i) { set_velocity(i, v_W, w_W); });
}

BulkStatus BulkSimulation::wake(const BodyId& body) {
  const std::optional<int> i = index_of(body);
  if (!i) return BulkStatus::no_such_body;
  wake(*i);
  return BulkStatus::done;
}

/// Gives a place to a kinematic body that is led, or to a dynamic one too.
template <class Act>
BulkStatus BulkSimulation::lead(const BodyId& body, const Pose& X_WU, bool is_dynamic_too, const Act& act) {
  const std::optional<int> i = index_of(body);
  if (!i) return BulkStatus::no_such_body;
  const Body& own = model_->body(*i);
  const bool may_be = PrescribedBodies::is_free(own) || (is_dynamic_too && own.motion == MotionType::dynamic);
  if (!may_be) return BulkStatus::not_led;
  if (!X_WU.p.allFinite() || !X_WU.R.allFinite()) return BulkStatus::not_finite;
  act(*i);
  return BulkStatus::done;
}

BulkStatus BulkSimulation::move_to(const BodyId& body, const Pose& X_WU) {
  return lead(body, X_WU, false, [&](int i) { move_to(i, X_WU); });
}

BulkStatus BulkSimulation::set_pose(const BodyId& body, const Pose& X_WU) {
  return lead(body, X_WU, true, [&](int i) { set_pose(i, X_WU); });
}

BodyArrays BulkSimulation::body_arrays() const {
  const std::size_t count = at(model_->body_count());
  BodyArrays arrays{std::vector<char>(count, 0), std::vector<double>(3 * count, 0),
                    std::vector<double>(4 * count, 0), std::vector<double>(3 * count, 0),
                    std::vector<double>(3 * count, 0)};
  for (std::size_t k = 0; k < count; ++k) {
    const int body = static_cast<int>(k);
    if (is_vacant(model_->body(body))) continue;
    const Pose X_WU = pose(body);
    const Quat q = quaternion_of(X_WU.R);
    arrays.is_there[k] = 1;
    Vec3::Map(&arrays.position[3 * k]) = X_WU.p;
    Vec4::Map(&arrays.orientation[4 * k]) = Vec4(q.w(), q.x(), q.y(), q.z());
    Vec3::Map(&arrays.velocity[3 * k]) = velocity(body);
    Vec3::Map(&arrays.angular_velocity[3 * k]) = angular_velocity(body);
  }
  return arrays;
}

ContactArrays BulkSimulation::contact_arrays() const {
  return rigor::contact_arrays(contacts(), options_.step);
}

ContactLoads BulkSimulation::contact_loads() const {
  return rigor::contact_loads(contacts(), centers_, options_.step);
}

SensorId BulkSimulation::add_sensor(const SensorDescription& description) {
  if (description.body != BodyId{} && !is_there(description.body)) return {};
  return sensors_.add(description);
}

BulkStatus BulkSimulation::remove_sensor(const SensorId& sensor) {
  return sensors_.remove(sensor) ? BulkStatus::done : BulkStatus::no_such_sensor;
}

std::optional<std::vector<BodyId>> BulkSimulation::overlaps(const SensorId& sensor) const {
  const std::vector<BodyId>* const found = sensors_.overlaps(sensor);
  return found ? std::optional<std::vector<BodyId>>(*found) : std::nullopt;
}

}  // namespace rigor
