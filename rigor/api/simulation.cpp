#include "rigor/api/simulation.hpp"

#include "rigor/api/engine.hpp"
#include "rigor/api/simulation_parts.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/limits.hpp"
#include "rigor/sim/report/energy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace rigor {

namespace {

Scene scene_of(std::shared_ptr<const Model> model, const Method& method, double step) {
  Scene scene;
  scene.name = model ? model->name() : std::string();
  scene.model = std::move(model);
  scene.method = method;
  scene.run.step = step;
  return scene;
}

/// By how much a time may miss a multiple of the interval and be one: late in a run the time itself is not
/// known better.
double rounding_at(double interval, double t) {
  constexpr double share_of_interval = 1e-9, share_of_time = 4 * std::numeric_limits<double>::epsilon();
  return std::max(share_of_interval * interval, share_of_time * t);
}

bool is_multiple(double interval, double t) {
  return std::abs(std::remainder(t, interval)) <= rounding_at(interval, t);
}

/// The multiple of the interval after t. Where intervals are lost in the rounding of t, the next time that
/// there is.
double next_multiple(double interval, double t) {
  const double next = (std::floor((t + rounding_at(interval, t)) / interval) + 1) * interval;
  return std::max(next, std::nextafter(t, std::numeric_limits<double>::infinity()));
}

}  // namespace

Simulation::Simulation(Scene scene, bool separate)
    : parts_(std::make_unique<Parts>(std::move(scene), separate)) {}

Simulation::Simulation(std::shared_ptr<const Model> model, const Method& method, double step)
    : Simulation(scene_of(std::move(model), method, step)) {}

Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&& other) noexcept = default;
Simulation& Simulation::operator=(Simulation&& other) noexcept = default;

Simulation Simulation::clone() const {
  Simulation copy(scene(), true);
  copy.restore(save());
  copy.set_controller(parts_->controller, parts_->period);
  return copy;
}

double Simulation::time() const {
  return parts_->state().t;
}

double Simulation::step_length() const {
  return scene().run.step;
}

void Simulation::step() {
  const double h = step_length();
  advance_to(is_multiple(h, time()) ? next_multiple(h, time()) : time() + h);
}

void Simulation::advance_to(double t) {
  Parts& parts = *parts_;
  parts.refuse_in_controller("advance");
  if (!(std::isfinite(t) && t >= time())) {
    throw InputError(fmt::format(
        "the time to advance to is {} s, must be at least that of the simulation, {} s", t, time()));
  }
  while (time() < t) {
    double until = t;
    if (parts.controller) {
      if (is_multiple(parts.period, time())) parts.control(*this);
      // What is left beyond the last instant is a rounding of it.
      const double next = next_multiple(parts.period, time());
      if (next < t && !(t - next < rounding_at(parts.period, t))) until = next;
    }
    std::vector<BodyLoad> loads = parts.loads;
    loads.insert(loads.end(), parts.control_loads.begin(), parts.control_loads.end());
    parts.changed();
    parts.engine.advance(until, loads);
  }
  parts.loads.clear();
  if (parts.controller && is_multiple(parts.period, time())) parts.control_loads.clear();
}

void Simulation::reset() {
  parts_->refuse_in_controller("reset");
  parts_->loads.clear();
  parts_->control_loads.clear();
  parts_->engine.reset();
  parts_->changed();
}

void Simulation::set_interrupt(std::function<bool()> interrupt) {
  parts_->engine.set_interrupt(std::move(interrupt));
}

void Simulation::set_controller(Controller controller, double period) {
  const std::string fault = range_error("the period of the controller", period, limits::interval, "s");
  if (period != 0 && !fault.empty()) throw InputError(fault + ", or 0: that of the steps");
  parts_->controller = std::move(controller);
  parts_->period = period > 0 ? period : step_length();
  parts_->control_loads.clear();
}

const Scene& Simulation::scene() const {
  return parts_->engine.scene();
}

const Model& Simulation::model() const {
  return parts_->engine.model();
}

int Simulation::body_count() const {
  return model().body_count();
}

int Simulation::joint_count() const {
  return static_cast<int>(model().joints().size());
}

BodyHandle Simulation::body(std::string_view name) const {
  return {parts_->index_of(BodyReference(name))};
}

JointHandle Simulation::joint(std::string_view name) const {
  return {parts_->index_of(JointReference(name))};
}

const std::string& Simulation::name(BodyHandle body) const {
  return model().body(parts_->index_of(BodyReference(body))).name;
}

const std::string& Simulation::name(JointHandle joint) const {
  return model().joint(parts_->index_of(JointReference(joint))).name;
}

Pose Simulation::pose(const BodyReference& body) const {
  const int i = parts_->index_of(body);
  const State& state = parts_->state();
  return Pose{rotation_matrix(state.orientation(i)), state.position(i)} * model().body(i).X_BU;
}

Vec3 Simulation::position(const BodyReference& body) const {
  return pose(body).p;
}

Quat Simulation::orientation(const BodyReference& body) const {
  return quaternion_of(pose(body).R);
}

Vec3 Simulation::velocity(const BodyReference& body) const {
  return linear_velocity(model(), parts_->state(), parts_->index_of(body));
}

Vec3 Simulation::angular_velocity(const BodyReference& body) const {
  return rigor::angular_velocity(model(), parts_->state(), parts_->index_of(body));
}

bool Simulation::is_asleep(const BodyReference& body) const {
  const int i = parts_->index_of(body);
  const std::vector<float>& quiet = parts_->state().quiet_time;
  return !quiet.empty() && std::isinf(quiet[at(i)]);
}

const Rows<3>& Simulation::positions() const {
  return parts_->tables().positions;
}
const Rows<4>& Simulation::orientations() const {
  return parts_->tables().orientations;
}
const Rows<3>& Simulation::velocities() const {
  return parts_->tables().velocities;
}
const Rows<3>& Simulation::angular_velocities() const {
  return parts_->tables().angular_velocities;
}

std::vector<TouchingPoint> Simulation::contacts() const {
  return parts_->engine.contacts();
}

JointReaction Simulation::joint_forces(const JointReference& joint) const {
  return joint_forces()[at(parts_->index_of(joint))];
}

std::vector<JointReaction> Simulation::joint_forces() const {
  return parts_->engine.joint_forces();
}

JointReaction Simulation::joint_motion(const JointReference& joint) const {
  return joint_motions()[at(parts_->index_of(joint))];
}

std::vector<JointReaction> Simulation::joint_motions() const {
  return parts_->engine.joint_motions();
}

std::vector<MotionEvent> Simulation::take_events() {
  return parts_->engine.take_events();
}

const SceneQueries& Simulation::queries() const {
  return parts_->queries();
}

Audit Simulation::audit() const {
  return parts_->engine.audit();
}

double Simulation::energy() const {
  return parts_->engine.energy();
}

std::string Simulation::save() const {
  return parts_->engine.save({parts_->loads, parts_->control_loads});
}

void Simulation::restore(std::string_view bytes) {
  parts_->refuse_in_controller("restore");
  SimulationEngine::WaitingLoads loads = parts_->engine.restore(bytes);
  parts_->loads = std::move(loads.given);
  parts_->control_loads = std::move(loads.of_control);
  parts_->changed();
}

}  // namespace rigor
