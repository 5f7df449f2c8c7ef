#include "rigor/dynamics/environment.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/sorted_unique.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace rigor {

Environment::Environment(const Model& model, PointSprings springs, bool with_joints)
    : model_(&model), records_(at(model.body_count()), 0), acting_(1) {
  // The drag and damping of the bodies themselves; damping of P is a drag in proportion to the mass.
  for (int i = 0; i < model.body_count(); ++i) {
    const Body& body = model.body(i);
    const double linear = body.linear_drag + body.mass * body.linear_damping;
    if (linear == 0 && body.angular_drag == 0 && body.angular_damping == 0) continue;
    acting_on(i).linear_drag = linear;
    acting_on(i).angular_drag = body.angular_drag;
  }
  // The forces of the scene, and then which bodies are under forces without a closed form.
  add_forces(springs);
  for (int i = 0; i < model.body_count(); ++i) {
    if (records_[at(i)] == 0) continue;
    Acting& acting = acting_on(i);
    acting.spring_partners = sorted_unique(std::move(acting.spring_partners));
    acting.is_forced =
        model.body(i).motion == MotionType::dynamic &&
        (!acting.springs.empty() || !acting.forces.empty() || !acting.torques.empty() ||
         acting.linear_drag > 0 || acting.angular_drag > 0 || model.body(i).angular_damping > 0);
  }
  if (with_joints) add_joints();
  for (int i = 0; i < model_->body_count(); ++i) {
    if (records_[at(i)] != 0 && model_->body(i).motion == MotionType::dynamic)
      acting_on(i).stiff_rate = find_stiff_rate(i);
  }
}

double Environment::find_stiff_rate(int body) const {
  const Body& own = model_->body(body);
  const double least = own.moments.minCoeff();
  const auto mobility = [&](const Vec3& p_BP) { return 1 / own.mass + p_BP.squaredNorm() / least; };
  const auto rate_of = [](double stiffness, double damping, double of_end) {
    return std::max(std::sqrt(2 * stiffness * of_end), 2 * damping * of_end);
  };

  // Drag, springs between points, and those of joints.
  const DragRates of_drag = drag(body);
  double rate = std::max(of_drag.linear / own.mass, of_drag.angular / least + of_drag.angular_damping);
  for (const int index : acts_on(body).springs) {
    const Spring& spring = springs_[at(index)];
    for (const auto& [end, p] :
         {std::pair{spring.body_A, spring.p_AP}, std::pair{spring.body_B, spring.p_BQ}}) {
      if (end == body) rate = std::max(rate, rate_of(spring.stiffness, spring.damping, mobility(p)));
    }
  }
  for (const int index : acts_on(body).joint_springs) {
    const Joint& joint = model_->joint(index);
    const Vec3& anchor = joint.body_A == body ? joint.X_AF.p : joint.X_BK.p;
    for (std::size_t k = 0; k < joint.axes.size(); ++k) {
      const bool turns = is_angle(joint.type, static_cast<int>(k));
      rate = std::max(rate, rate_of(joint.axes[k].stiffness, joint.axes[k].damping,
                                    turns ? 1 / least : mobility(anchor)));
    }
  }
  return rate;
}

/// The record of a body, which is created if it has none.
Environment::Acting& Environment::acting_on(int body) {
  int& record = records_[at(body)];
  if (record == 0) {
    record = static_cast<int>(acting_.size());
    acting_.emplace_back();
  }
  return acting_[at(record)];
}

Vec3 Environment::gravity_on(int body) const {
  const Body& own = model_->body(body);
  return own.motion == MotionType::dynamic ? Vec3(own.gravity_scale * model_->g_W()) : Vec3(Vec3::Zero());
}

void Environment::add_forces(PointSprings springs) {
  for (const Force& force : model_->forces()) {
    if (const ConstantForce* constant = std::get_if<ConstantForce>(&force)) {
      const Body& body = model_->body(constant->body);
      Acting& acting = acting_on(constant->body);
      // A force at the centre of mass that is constant in W only adds to gravity.
      const bool is_steady = !constant->frame_is_body && constant->p_BP.isZero(0);
      if (is_steady && body.motion == MotionType::dynamic) {
        acting.steady = steady_acceleration(constant->body) + constant->f / body.mass;
      } else {
        acting.forces.push_back(*constant);
        acting.is_tied_down = true;
      }
    } else if (const ConstantTorque* torque = std::get_if<ConstantTorque>(&force)) {
      acting_on(torque->body).torques.push_back(*torque);
      acting_on(torque->body).is_tied_down = true;
    } else if (const Spring* spring = std::get_if<Spring>(&force)) {
      if (springs == PointSprings::act) add_spring(*spring);
    } else if (const Drag* drag = std::get_if<Drag>(&force)) {
      acting_on(drag->body).linear_drag += drag->linear;
      acting_on(drag->body).angular_drag += drag->angular;
    }
  }
}

void Environment::add_spring(const Spring& spring) {
  const int number = static_cast<int>(springs_.size());
  springs_.push_back(spring);
  for (const int body : {spring.body_A, spring.body_B}) {
    if (body == world_body) continue;
    Acting& acting = acting_on(body);
    if (acting.springs.empty() || acting.springs.back() != number) acting.springs.push_back(number);
    const int other = body == spring.body_A ? spring.body_B : spring.body_A;
    if (other == body) continue;
    if (other != world_body && model_->body(other).motion == MotionType::dynamic) {
      acting.spring_partners.push_back(other);
    } else {
      acting.is_tied_down = true;
      acting.spring_anchors.push_back(other);
    }
  }
}

void Environment::add_joints() {
  for (int j = 0; j < static_cast<int>(model_->joints().size()); ++j) {
    // A joint holds its dynamic bodies; the others and the world are what it ties them to.
    std::vector<int> bodies = model_->bodies_of_joint(j), anchors;
    std::copy_if(bodies.begin(), bodies.end(), std::back_inserter(anchors),
                 [this](int body) { return model_->body(body).motion != MotionType::dynamic; });
    if (model_->joint(j).body_A == world_body || model_->joint(j).body_B == world_body)
      anchors.push_back(world_body);
    std::erase_if(bodies, [this](int body) { return model_->body(body).motion != MotionType::dynamic; });
    for (const int body : bodies) {
      Acting& acting = acting_on(body);
      acting.is_forced = acting.is_jointed = true;
      std::copy_if(bodies.begin(), bodies.end(), std::back_inserter(acting.joint_partners),
                   [body](int other) { return other != body; });
      acting.joint_anchors.insert(acting.joint_anchors.end(), anchors.begin(), anchors.end());
      if (has_springs(model_->joint(j))) acting.joint_springs.push_back(j);
    }
  }
  for (Acting& acting : acting_) {
    acting.joint_partners = sorted_unique(std::move(acting.joint_partners));
    acting.joint_anchors = sorted_unique(std::move(acting.joint_anchors));
    acting.spring_anchors = sorted_unique(std::move(acting.spring_anchors));
  }
}

Wrench Environment::own_forces(int body, const BodyView& view) const {
  const Body& own = model_->body(body);
  if (acts_on(body).leaves_own_forces) return {};
  // Gravity and steady forces, less drag.
  Wrench wrench;
  wrench.f_W = own.mass * steady_acceleration(body) - acts_on(body).linear_drag * view.v;
  wrench.tau_W = -acts_on(body).angular_drag * view.w;
  // Damping torque -c L with L = R I_B Rᵀ ω.
  if (own.angular_damping > 0) {
    const Vec3 L_B = own.moments.cwiseProduct(view.R.transpose() * view.w);
    wrench.tau_W -= own.angular_damping * (view.R * L_B);
  }
  add_given(body, view, wrench);
  return wrench;
}

Wrench Environment::undamped_forces(int body, const BodyView& view) const {
  Wrench wrench;
  wrench.f_W = model_->body(body).mass * steady_acceleration(body);
  add_given(body, view, wrench);
  return wrench;
}

void Environment::add_given(int body, const BodyView& view, Wrench& wrench) const {
  // Forces with a lever about the centre of mass or fixed in the body, and torques.
  for (const ConstantForce& force : acts_on(body).forces) {
    const Vec3 f_W = force.frame_is_body ? Vec3(view.R * force.f) : force.f;
    wrench.f_W += f_W;
    wrench.tau_W += (view.R * force.p_BP).cross(f_W);
  }
  for (const ConstantTorque& torque : acts_on(body).torques) {
    wrench.tau_W += torque.frame_is_body ? Vec3(view.R * torque.tau) : torque.tau;
  }
}

double Environment::supplied_power(int body, const BodyView& view) const {
  double power = 0;
  if (acts_on(body).leaves_own_forces) return power;
  for (const ConstantForce& force : acts_on(body).forces) {
    const Vec3 f_W = force.frame_is_body ? Vec3(view.R * force.f) : force.f;
    power += f_W.dot(view.v + view.w.cross(view.R * force.p_BP));
  }
  for (const ConstantTorque& torque : acts_on(body).torques) {
    power += view.w.dot(torque.frame_is_body ? Vec3(view.R * torque.tau) : torque.tau);
  }
  return power;
}

double Environment::potential(int body, const Vec3& x) const {
  return -model_->body(body).mass * steady_acceleration(body).dot(x);
}

std::vector<int> Environment::springs_of(std::span<const int> bodies) const {
  std::vector<int> found;
  for (const int body : bodies)
    found.insert(found.end(), acts_on(body).springs.begin(), acts_on(body).springs.end());
  return sorted_unique(std::move(found));
}

std::vector<int> Environment::joint_springs_of(std::span<const int> bodies) const {
  std::vector<int> found;
  for (const int body : bodies)
    found.insert(found.end(), acts_on(body).joint_springs.begin(), acts_on(body).joint_springs.end());
  return sorted_unique(std::move(found));
}

double Environment::stored_energy(const Spring& spring, const SpringEnd& A, const SpringEnd& B) {
  const double stretch = (B.p_W - A.p_W).norm() - spring.length;
  return 0.5 * spring.stiffness * stretch * stretch;
}

Vec3 Environment::force_on_B(const Spring& spring, const SpringEnd& A, const SpringEnd& B) {
  const Vec3 d = B.p_W - A.p_W;
  const double length = d.norm();
  // Where the ends meet, the line has no direction; a spring of rest length 0 has no force there.
  if (length == 0) return Vec3::Zero();
  // Tension k (d - length) + c ḋ along the line.
  const Vec3 direction = d / length;
  const double rate = direction.dot(B.v_W - A.v_W);
  return -(spring.stiffness * (length - spring.length) + spring.damping * rate) * direction;
}

}  // namespace rigor
