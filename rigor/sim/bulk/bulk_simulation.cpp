#include "rigor/sim/bulk/bulk_simulation.hpp"

#include "rigor/bulk/state/prescribed_bodies.hpp"
#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/carried_state.hpp"

#include <cstddef>
#include <utility>

namespace rigor {

BulkSimulation::BulkSimulation(std::shared_ptr<const Model> model)
    : BulkSimulation(std::move(model), Options{}) {}

BulkSimulation::BulkSimulation(std::shared_ptr<const Model> model, const Options& options)
    : model_(std::move(model)), options_(options) {
  RIGOR_ASSERT(options.step > 0 && options.substeps >= 1 && options.threads >= 1);
  start(make_initial_state(*model_));
  name_all();
}

BulkSimulation::~BulkSimulation() = default;

/// Makes a world of the model in this State.
void BulkSimulation::start(const State& state) {
  BulkSettings settings;
  settings.substeps = options_.substeps;
  settings.threads = options_.threads;
  settings.sleeping = options_.sleeping;
  settings.measures = options_.measures;
  queries_.reset();
  world_ = std::make_unique<BulkWorld>(model_, settings);
  if (may_touch_) world_->set_contact_filter(may_touch_);
  set_state(state);
}

BulkStepReport BulkSimulation::step() {
  settle_joints();
  world_->settle_changes();
  before_ = world_->memory();
  centers_ = world_->bodies().x;
  is_asked_ = false;
  changed_.clear();
  kept_contacts_.reset();
  BulkStepReport report = world_->step(options_.step);
  sensors_.update(*model_, world_->bodies(), body_ids_);
  return report;
}

State BulkSimulation::state() const {
  State state = template_;
  settle_joints();
  world_->settle_changes();
  world_->write(state);
  return state;
}

void BulkSimulation::set_state(const State& state) {
  RIGOR_ASSERT(state.body_count() == model_->body_count());
  // Changes of joints are of the world before: the State is of the Model with them.
  settle_joints();
  template_ = state;
  world_->read(state);
  centers_ = world_->bodies().x;
  before_ = world_->memory();
  is_asked_ = false;
}

Pose BulkSimulation::pose(int body) const {
  const std::size_t k = at(body);
  return Pose{rotation_matrix(world_->bodies().q[k]), centre(body)} * model_->body(body).X_BU;
}

Vec3 BulkSimulation::velocity(int body) const {
  const float* v = world_->bodies().motion[at(body)].v;
  return Vec3(v[0], v[1], v[2]);
}

Vec3 BulkSimulation::angular_velocity(int body) const {
  const float* w = world_->bodies().motion[at(body)].w;
  return Vec3(w[0], w[1], w[2]);
}

void BulkSimulation::apply_force(int body, const Vec3& f_W) {
  world_->add_wrench(body, {f_W, Vec3::Zero()});
}

void BulkSimulation::apply_force(int body, const Vec3& f_W, const Vec3& p_W) {
  world_->add_wrench(body, {f_W, (p_W - centre(body)).cross(f_W)});
}

void BulkSimulation::apply_torque(int body, const Vec3& tau_W) {
  world_->add_wrench(body, {Vec3::Zero(), tau_W});
}

void BulkSimulation::apply_impulse(int body, const Vec3& j_W) {
  world_->add_impulse(body, {j_W, Vec3::Zero()});
}

void BulkSimulation::apply_impulse(int body, const Vec3& j_W, const Vec3& p_W) {
  world_->add_impulse(body, {j_W, (p_W - centre(body)).cross(j_W)});
}

void BulkSimulation::apply_angular_impulse(int body, const Vec3& l_W) {
  world_->add_impulse(body, {Vec3::Zero(), l_W});
}

void BulkSimulation::move_to(int body, const Pose& X_WU) {
  const Pose X_WB = X_WU * model_->body(body).X_BU.inverse();
  world_->set_target(body, X_WB.p, quaternion_of(X_WB.R));
}

void BulkSimulation::set_pose(int body, const Pose& X_WU) {
  const Body& own = model_->body(body);
  RIGOR_ASSERT(own.motion == MotionType::dynamic || PrescribedBodies::is_free(own));
  world_->set_pose(body, X_WU * own.X_BU.inverse());
  is_asked_ = false;
}

void BulkSimulation::set_velocity(int body, const Vec3& v_W, const Vec3& w_W) {
  RIGOR_ASSERT(model_->body(body).motion == MotionType::dynamic);
  world_->set_velocity(body, v_W, w_W);
}

void BulkSimulation::set_model(std::shared_ptr<const Model> model) {
  const State carried = carried_state(*model_, state(), *model);
  // The queries of the old model go before it does.
  queries_.reset();
  model_ = std::move(model);
  editor_.reset();
  changed_.clear();
  kept_contacts_.reset();
  start(carried);
  name_all();
}

void BulkSimulation::set_contact_filter(std::function<bool(int, int)> may_touch) {
  may_touch_ = std::move(may_touch);
  world_->set_contact_filter(may_touch_);
}

std::vector<ContactEvent> BulkSimulation::events() const {
  std::vector<ContactEvent> all = contact_events(before_, world_->memory());
  std::erase_if(all,
                [this](const ContactEvent& event) { return is_new(event.body_A) || is_new(event.body_B); });
  return all;
}

const SceneQueries& BulkSimulation::queries() const {
  if (queries_ && is_asked_) return *queries_;
  // Poses are all that it asks of a State.
  State poses = template_;
  world_->write_bodies(poses);
  if (queries_)
    queries_->update(poses);
  else
    queries_ = std::make_unique<SceneQueries>(*model_, poses);
  is_asked_ = true;
  return *queries_;
}

}  // namespace rigor
