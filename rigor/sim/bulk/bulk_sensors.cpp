#include "rigor/sim/bulk/bulk_sensors.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/shape/aabb.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/shape_checks.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <variant>

namespace rigor {

namespace {

Pose pose_of(const BulkBodies& bodies, int body) {
  return {rotation_matrix(bodies.q[at(body)]), bodies.x[at(body)]};
}

}  // namespace

SensorId BulkSensors::add(SensorDescription description) {
  std::vector<std::string> messages;
  Findings findings("", "sensor", messages);
  ShapeMemory memory;
  const std::string type = shape_type_name(description.shape);
  check_shape(description.shape, false, "its " + type, memory, findings);
  const bool is_convex = !is_unbounded(description.shape) && !std::holds_alternative<Mesh>(description.shape);
  findings.require(is_convex, "its shape is a " + type + ", must be convex and bounded");
  findings.require(description.X_US.p.allFinite() && description.X_US.R.allFinite(),
                   "its pose is not finite");
  if (!messages.empty()) throw InputError(std::move(messages));
  const int place = ids_.lowest_free();
  if (sensors_.size() <= at(place)) sensors_.resize(at(place) + 1);
  sensors_[at(place)] = Sensor{std::move(description), {}};
  return ids_.give(place);
}

bool BulkSensors::remove(const SensorId& sensor) {
  const std::optional<int> place = ids_.place_of(sensor);
  if (!place) return false;
  ids_.retire(*place);
  sensors_[at(*place)] = {};
  return true;
}

const std::vector<BodyId>* BulkSensors::overlaps(const SensorId& sensor) const {
  const std::optional<int> place = ids_.place_of(sensor);
  return place ? &sensors_[at(*place)].overlaps : nullptr;
}

void BulkSensors::update(const Model& model, const BulkBodies& bodies, const BodyTable& ids) {
  events_.clear();
  const std::vector<SensorId> all = ids_.all();
  if (all.empty()) return;
  box_bodies(model, bodies);
  for (const SensorId& id : all) {
    Sensor& sensor = sensors_[at(id.place)];
    const bool is_carried = sensor.own.body != BodyId{};
    if (is_carried && !ids.place_of(sensor.own.body)) {
      // Its body is gone: it feels nothing from now on.
      note(id.place, {});
      remove(id);
      continue;
    }
    std::vector<BodyId> now = find(sensor, model, bodies, ids);
    note(id.place, now);
    sensor.overlaps = std::move(now);
  }
}

/// Boxes around the balls that hold the bodies, in a tree.
void BulkSensors::box_bodies(const Model& model, const BulkBodies& bodies) {
  boxes_.clear();
  boxed_.clear();
  unbounded_.clear();
  double size = 0;
  for (int i = 0; i < bodies.count(); ++i) {
    const Body& body = model.body(i);
    if (body.shapes.empty()) continue;
    if (!std::isfinite(body.bounding_radius)) {
      unbounded_.push_back(i);
      continue;
    }
    if (boxed_.empty()) origin_ = bodies.x[at(i)];
    boxed_.push_back(i);
    const Vec3 &x = bodies.x[at(i)], half = Vec3::Constant(body.bounding_radius);
    boxes_.push_back(enclosing_box({x - half, x + half}, origin_));
    size += 2 * body.bounding_radius;
  }
  if (boxed_.empty()) return;
  const double mean = size / static_cast<double>(boxed_.size());
  tree_.build(boxes_, mean > 0 ? static_cast<float>(mean) : 1.0F);
}

/// The bodies that overlap a sensor, by place.
std::vector<BodyId> BulkSensors::find(const Sensor& sensor, const Model& model, const BulkBodies& bodies,
                                      const BodyTable& ids) {
  const SensorDescription& own = sensor.own;
  const int carrier = ids.place_of(own.body).value_or(-1);
  const Pose X_WS = carrier < 0 ? own.X_US : pose_of(bodies, carrier) * model.body(carrier).X_BU * own.X_US;
  // Bodies that may be near: those of the tree, and those without bounds.
  near_.clear();
  if (!boxed_.empty()) tree_.find_overlaps(enclosing_box(axis_aligned_box(own.shape, X_WS), origin_), near_);
  for (int& near : near_) near = boxed_[at(near)];
  near_.insert(near_.end(), unbounded_.begin(), unbounded_.end());
  std::sort(near_.begin(), near_.end());

  std::vector<BodyId> found;
  for (const int i : near_) {
    const Body& body = model.body(i);
    const bool is_felt =
        (body.group & own.mask) != 0 && (own.feels_fixed || body.motion != MotionType::fixed);
    if (i == carrier || !is_felt) continue;
    const Pose X_WB = pose_of(bodies, i);
    const bool meets = std::any_of(body.shapes.begin(), body.shapes.end(), [&](const BodyShape& shape) {
      if (std::holds_alternative<Cavity>(shape.shape)) return false;
      return signed_distance(own.shape, X_WS, shape.shape, X_WB * shape.X_BS).distance <= 0;
    });
    if (meets) found.push_back(ids.id_of(i));
  }
  return found;
}

/// Notes who came and who went. A body that came into the place of another is another.
void BulkSensors::note(int place, const std::vector<BodyId>& now) {
  const std::vector<BodyId>& before = sensors_[at(place)].overlaps;
  const auto is_in = [](const std::vector<BodyId>& list, const BodyId& body) {
    return std::find(list.begin(), list.end(), body) != list.end();
  };
  for (const BodyId& body : before)
    if (!is_in(now, body)) events_.push_back({SensorEvent::Kind::end, ids_.id_of(place), body});
  for (const BodyId& body : now)
    if (!is_in(before, body)) events_.push_back({SensorEvent::Kind::begin, ids_.id_of(place), body});
}

}  // namespace rigor
