#include "rigor/dynamics/environment.hpp"

#include <algorithm>
#include <iterator>

namespace rigor {

namespace {

std::size_t index(int body) {
  return static_cast<std::size_t>(body);
}

void sort_and_unite(std::vector<int>& bodies) {
  std::sort(bodies.begin(), bodies.end());
  bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
}

}  // namespace

Environment::Environment(const Model& model, PointSprings springs, bool with_joints)
    : model_(&model),
      steady_accelerations_(index(model.body_count()), Vec3::Zero()),
      is_forced_(index(model.body_count()), false),
      partners_(index(model.body_count())),
      joint_partners_(index(model.body_count())),
      springs_of_(index(model.body_count())),
      joint_springs_of_(index(model.body_count())),
      body_forces_(index(model.body_count())),
      torques_(index(model.body_count())) {
  for (int i = 0; i < model.body_count(); ++i) {
    const Body& body = model.body(i);
    if (body.motion == MotionType::dynamic)
      steady_accelerations_[index(i)] = body.gravity_scale * model.g_W();
    linear_drag_.push_back(body.linear_drag + body.mass * body.linear_damping);
    angular_drag_.push_back(body.angular_drag);
  }
  for (const Force& force : model.forces()) {
    if (const ConstantForce* constant = std::get_if<ConstantForce>(&force)) {
      const Body& body = model.body(constant->body);
      const bool is_steady = !constant->frame_is_body && constant->p_BP.isZero(0);
      if (is_steady && body.motion == MotionType::dynamic) {
        steady_accelerations_[index(constant->body)] += constant->f / body.mass;
      } else {
        body_forces_[index(constant->body)].push_back(*constant);
      }
    } else if (const ConstantTorque* torque = std::get_if<ConstantTorque>(&force)) {
      torques_[index(torque->body)].push_back(*torque);
    } else if (const Spring* spring = std::get_if<Spring>(&force)) {
      if (springs == PointSprings::left_out) continue;
      const int number = static_cast<int>(springs_.size());
      springs_.push_back(*spring);
      for (const int body : {spring->body_A, spring->body_B}) {
        if (body == world_body) continue;
        std::vector<int>& of_body = springs_of_[index(body)];
        if (of_body.empty() || of_body.back() != number) of_body.push_back(number);
        const int other = body == spring->body_A ? spring->body_B : spring->body_A;
        if (other == world_body || other == body) continue;
        if (model.body(other).motion == MotionType::dynamic) partners_[index(body)].push_back(other);
      }
    } else if (const Drag* drag = std::get_if<Drag>(&force)) {
      linear_drag_[index(drag->body)] += drag->linear;
      angular_drag_[index(drag->body)] += drag->angular;
    }
  }
  for (int i = 0; i < model.body_count(); ++i) {
    sort_and_unite(partners_[index(i)]);
    is_forced_[index(i)] =
        model.body(i).motion == MotionType::dynamic &&
        (!springs_of_[index(i)].empty() || !body_forces_[index(i)].empty() || !torques_[index(i)].empty() ||
         linear_drag_[index(i)] > 0 || angular_drag_[index(i)] > 0 || model.body(i).angular_damping > 0);
  }
  if (with_joints) add_joints();
}

void Environment::add_joints() {
  for (int j = 0; j < static_cast<int>(model_->joints().size()); ++j) {
    std::vector<int> bodies = model_->bodies_of_joint(j);
    std::erase_if(bodies, [this](int body) { return model_->body(body).motion != MotionType::dynamic; });
    for (const int body : bodies) {
      is_forced_[index(body)] = true;
      std::copy_if(bodies.begin(), bodies.end(), std::back_inserter(joint_partners_[index(body)]),
                   [body](int other) { return other != body; });
      if (has_springs(model_->joint(j))) joint_springs_of_[index(body)].push_back(j);
    }
  }
  for (std::vector<int>& partners : joint_partners_) sort_and_unite(partners);
}

Wrench Environment::own_forces(int body, const BodyView& view) const {
  const Body& own = model_->body(body);
  Wrench wrench;
  wrench.f_W = own.mass * steady_accelerations_[index(body)] - linear_drag_[index(body)] * view.v;
  wrench.tau_W = -angular_drag_[index(body)] * view.w;
  if (own.angular_damping > 0) {
    const Vec3 L_B = own.moments.cwiseProduct(view.R.transpose() * view.w);
    wrench.tau_W -= own.angular_damping * (view.R * L_B);
  }
  for (const ConstantForce& force : body_forces_[index(body)]) {
    const Vec3 f_W = force.frame_is_body ? Vec3(view.R * force.f) : force.f;
    wrench.f_W += f_W;
    wrench.tau_W += (view.R * force.p_BP).cross(f_W);
  }
  for (const ConstantTorque& torque : torques_[index(body)]) {
    wrench.tau_W += torque.frame_is_body ? Vec3(view.R * torque.tau) : torque.tau;
  }
  return wrench;
}

double Environment::supplied_power(int body, const BodyView& view) const {
  double power = 0;
  for (const ConstantForce& force : body_forces_[index(body)]) {
    const Vec3 f_W = force.frame_is_body ? Vec3(view.R * force.f) : force.f;
    power += f_W.dot(view.v + view.w.cross(view.R * force.p_BP));
  }
  for (const ConstantTorque& torque : torques_[index(body)]) {
    power += view.w.dot(torque.frame_is_body ? Vec3(view.R * torque.tau) : torque.tau);
  }
  return power;
}

double Environment::potential(int body, const Vec3& x) const {
  return -model_->body(body).mass * steady_accelerations_[index(body)].dot(x);
}

double Environment::stored_energy(const Spring& spring, const SpringEnd& A, const SpringEnd& B) {
  const double stretch = (B.p_W - A.p_W).norm() - spring.length;
  return 0.5 * spring.stiffness * stretch * stretch;
}

Vec3 Environment::force_on_B(const Spring& spring, const SpringEnd& A, const SpringEnd& B) {
  const Vec3 d = B.p_W - A.p_W;
  const double length = d.norm();
  // Where the ends meet the line has no direction; a spring of rest length 0 has no force there.
  if (length == 0) return Vec3::Zero();
  const Vec3 direction = d / length;
  const double rate = direction.dot(B.v_W - A.v_W);
  return -(spring.stiffness * (length - spring.length) + spring.damping * rate) * direction;
}

}  // namespace rigor
