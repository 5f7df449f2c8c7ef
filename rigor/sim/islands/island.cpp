#include "rigor/sim/islands/island.hpp"

#include "rigor/contact/resting/rolling_friction.hpp"
#include "rigor/contact/system/contact_kinematics.hpp"
#include "rigor/core/index.hpp"
#include "rigor/dynamics/dense_phase.hpp"
#include "rigor/dynamics/step_control.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace rigor {

namespace {

IntegratorName integrator_of(IntegratorMethod method) {
  switch (method) {
    case IntegratorMethod::euler:
      return IntegratorName::euler;
    case IntegratorMethod::semi_implicit_euler:
      return IntegratorName::semi_implicit_euler;
    case IntegratorMethod::midpoint:
      return IntegratorName::midpoint;
    case IntegratorMethod::rk4:
      return IntegratorName::rk4;
    case IntegratorMethod::lie_rk4:
      return IntegratorName::lie_rk4;
    case IntegratorMethod::dop853:
      return IntegratorName::dop853;
    case IntegratorMethod::exact:
    case IntegratorMethod::dopri5:
      break;
  }
  return IntegratorName::dopri5;
}

std::size_t place_of(const std::vector<int>& ascending, int body) {
  return at(std::lower_bound(ascending.begin(), ascending.end(), body) - ascending.begin());
}
bool holds(const std::vector<int>& ascending, int body) {
  return std::binary_search(ascending.begin(), ascending.end(), body);
}

Environment::BodyView view_of(const BodyKinetics& body) {
  return {body.x, body.v, body.w, body.R, body.inverse_mass > 0};
}

Pose pose_of(const BodyPhase& phase) {
  return {rotation_matrix(phase.q), phase.x};
}

}  // namespace

std::vector<int> bodies_of(const std::vector<Contact>& contacts, const std::vector<int>& others) {
  std::vector<int> bodies = others;
  for (const Contact& contact : contacts) {
    bodies.push_back(contact.body_A);
    bodies.push_back(contact.body_B);
  }
  std::sort(bodies.begin(), bodies.end());
  bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
  return bodies;
}

/// The wrench on each body and, as two bodies more, what the ledger integrates: the external force and torque
/// (about the origin of W), and the supplied power as the x component of a force.
struct IslandIntegrator::Load {
  std::vector<Wrench> wrenches;
  Wrench external;
  double power = 0;
};

IslandIntegrator::IslandIntegrator(const Model& model, const Environment& environment, const Method& method)
    : model_(model),
      environment_(environment),
      joints_by_body_(joints_by_body(model)),
      integrator_(method.integrator),
      orientation_(method.orientation),
      tolerance_(method.tolerance),
      direction_tolerance_(direction_tolerance(method)),
      resting_velocity_(method.resting_velocity),
      resting_(resting_choice(method)) {}

RestingChoice resting_choice(const Method& method) {
  return {method.resting == RestingMethod::motion_space ? RestingSpace::motion : RestingSpace::contact,
          method.lcp == LcpMethod::dantzig ? LcpName::dantzig : LcpName::lemke};
}

double direction_tolerance(const Method& method) {
  return 1e-3 * method.resting_velocity;
}

double slip_tolerance(const Method& method) {
  return 1e-6 * method.resting_velocity;
}

std::vector<int> IslandIntegrator::joints_of(const std::vector<int>& bodies) const {
  std::vector<int> joints;
  for (const int body : bodies) {
    const std::vector<int>& own = joints_by_body_[at(body)];
    joints.insert(joints.end(), own.begin(), own.end());
  }
  std::sort(joints.begin(), joints.end());
  joints.erase(std::unique(joints.begin(), joints.end()), joints.end());
  return joints;
}

std::vector<int> IslandIntegrator::bodies_of_joints(const std::vector<int>& joints) const {
  std::vector<int> bodies;
  for (const int joint : joints) {
    const std::vector<int> own = model_.bodies_of_joint(joint);
    bodies.insert(bodies.end(), own.begin(), own.end());
  }
  std::sort(bodies.begin(), bodies.end());
  bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
  return bodies;
}

std::vector<int> IslandIntegrator::jointed_prescribed(const std::vector<int>& bodies) const {
  std::vector<int> result = bodies_of_joints(joints_of(bodies));
  std::erase_if(result, [this](int body) { return model_.body(body).motion == MotionType::dynamic; });
  return result;
}

IslandIntegrator::Bodies IslandIntegrator::bodies_at(double t, const std::vector<int>& bodies,
                                                     std::span<const BodyPhase> phases,
                                                     const std::vector<Contact>& contacts,
                                                     const std::vector<int>& joints) const {
  std::vector<int> others = bodies_of_joints(joints);
  others.insert(others.end(), bodies.begin(), bodies.end());
  Bodies result{bodies_of(contacts, others), {}};
  for (const int body : result.indices) {
    result.kinetics.push_back(holds(bodies, body)
                                  ? dynamic_kinetics(model_.body(body), phases[place_of(bodies, body)])
                                  : prescribed_kinetics(model_.body(body), t));
  }
  return result;
}

ContactSystem IslandIntegrator::system_of(double t, const std::vector<int>& bodies,
                                          std::span<const BodyPhase> phases, std::vector<Contact> contacts,
                                          const JointSystem::RowChoice* choice) const {
  std::vector<int> joints = joints_of(bodies);
  Bodies all = bodies_at(t, bodies, phases, contacts, joints);
  std::shared_ptr<const JointSystem> of_joints;
  if (!joints.empty())
    of_joints = std::make_shared<JointSystem>(model_, std::move(joints), all.indices, all.kinetics, choice);
  return make_contact_system(model_, std::move(contacts), std::move(all.indices), std::move(all.kinetics),
                             std::move(of_joints));
}

double IslandIntegrator::joint_residual(double t, const std::vector<int>& bodies,
                                        std::span<const BodyPhase> phases) const {
  if (joints_of(bodies).empty()) return 0;
  return system_of(t, bodies, phases, {}).joints->largest_residual().first;
}

void IslandIntegrator::choose_joint_rows(Island& island) const {
  const ContactSystem system = system_of(island.begin, island.bodies, island.start, {});
  if (system.joints) island.joint_rows = system.joints->choice();
}

/// The closed form is for flight. Where forces act its place is taken by integrators that control their
/// error: of order 8 where motion is smooth, of order 5 where contacts may end the step early.
IntegratorName IslandIntegrator::integrator_for(const Island& island) const {
  if (integrator_ != IntegratorMethod::exact) return integrator_of(integrator_);
  return island.contacts.empty() ? IntegratorName::dop853 : IntegratorName::dopri5;
}

ContactSystem IslandIntegrator::contact_system(const Island& island, double t,
                                               std::span<const BodyPhase> phases,
                                               std::shared_ptr<JointSystem>* joint_room) const {
  std::vector<int> joints = joints_of(island.bodies);
  Bodies all = bodies_at(t, island.bodies, phases, island.contacts, joints);
  std::vector<Contact> contacts = island.contacts;
  if (t != island.begin) {
    const auto pose_at_begin = [&](int body) {
      return holds(island.bodies, body) ? pose_of(island.start[place_of(island.bodies, body)])
                                        : prescribed_kinetics(model_.body(body), island.begin).pose();
    };
    for (Contact& contact : contacts) {
      if (contact.stop) continue;
      contact.point =
          tracked_contact(model_, contact, pose_at_begin(contact.body_A), pose_at_begin(contact.body_B),
                          all.kinetics[place_of(all.indices, contact.body_A)].pose(),
                          all.kinetics[place_of(all.indices, contact.body_B)].pose());
    }
  }
  const JointSystem::RowChoice* const choice = island.joint_rows ? &*island.joint_rows : nullptr;
  std::shared_ptr<JointSystem> of_joints = joint_room ? *joint_room : nullptr;
  if (of_joints) {
    of_joints->update(model_, all.indices, all.kinetics, choice);
  } else if (!joints.empty()) {
    of_joints = std::make_shared<JointSystem>(model_, std::move(joints), all.indices, all.kinetics, choice);
    if (joint_room) *joint_room = of_joints;
  }
  return make_contact_system(model_, std::move(contacts), std::move(all.indices), std::move(all.kinetics),
                             std::move(of_joints));
}

std::vector<Wrench> IslandIntegrator::environment_wrenches(const ContactSystem& system, double t) const {
  const auto view = [&](int body) {
    if (holds(system.bodies, body)) return view_of(system.of(body));
    return view_of(prescribed_kinetics(model_.body(body), t));
  };
  std::vector<Wrench> wrenches(system.bodies.size());
  environment_.apply_env_forces(system.bodies, view, wrenches);
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    if (system.kinetics[b].inverse_mass == 0) wrenches[b] = Wrench{};
  }
  return wrenches;
}

std::vector<Wrench> IslandIntegrator::with_moments(const ContactSystem& system,
                                                   const std::vector<ContactState>& states,
                                                   std::vector<Wrench> wrenches) const {
  return with_rolling_friction(system, states, std::move(wrenches), direction_tolerance_, resting_velocity_);
}

IslandIntegrator::Load IslandIntegrator::load(const Island& island, double t,
                                              std::span<const BodyPhase> phases,
                                              std::shared_ptr<JointSystem>& joints) const {
  const ContactSystem system = contact_system(island, t, phases, &joints);
  std::vector<Wrench> wrenches = environment_wrenches(system, t);
  Load load;
  // What springs do inside the island cancels in the sum; those to prescribed bodies and the world are
  // external.
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    if (system.kinetics[b].inverse_mass == 0) continue;
    load.external.f_W += wrenches[b].f_W;
    load.external.tau_W += wrenches[b].tau_W + system.kinetics[b].x.cross(wrenches[b].f_W);
    load.power += environment_.supplied_power(system.bodies[b], view_of(system.kinetics[b]));
  }
  VecX lambda, joint_lambda;
  if (!island.contacts.empty()) {
    const std::vector<Wrench> of_environment = wrenches;
    wrenches = with_moments(system, island.states, std::move(wrenches));
    load.power += rolling_power_of_prescribed(system, of_environment, wrenches);
    // Moments on prescribed bodies leave the island: their opposites are external to it.
    for (std::size_t b = 0; b < system.bodies.size(); ++b) {
      if (system.kinetics[b].inverse_mass == 0) load.external.tau_W -= wrenches[b].tau_W;
    }
    lambda = contact_forces(system, island.states, wrenches, direction_tolerance_, resting_);
    add_contact_wrenches(system, lambda, wrenches);
    load.power += work_of_prescribed(system, lambda);
  }
  if (system.joints) {
    JointReactions reactions = with_joint_reactions(system, std::move(wrenches));
    wrenches = std::move(reactions.wrenches);
    joint_lambda = reactions.lambda;
    load.power += system.joints->supplied_power(joint_lambda);
  }
  const Wrench external = external_wrench(system, lambda, joint_lambda);
  load.external.f_W += external.f_W;
  load.external.tau_W += external.tau_W;
  for (const int body : island.bodies) load.wrenches.push_back(wrenches[place_of(system.bodies, body)]);
  return load;
}

IntegratorTolerances IslandIntegrator::tolerances(const Island& island) const {
  IntegratorTolerances result;
  result.relative = tolerance_;
  // A linear momentum below this share of what turning carries is rounding of it, as of a wheel on its axle.
  constexpr double rounding_share = 1e-4;
  double length = 0, momentum = 0, angular_momentum = 0, turning = 0;
  for (std::size_t i = 0; i < island.bodies.size(); ++i) {
    const Body& body = model_.body(island.bodies[i]);
    const double size = std::isfinite(body.bounding_radius) && body.bounding_radius > 0
                            ? body.bounding_radius
                            : model_.length_scale();
    const double speed = std::sqrt(size * environment_.steady_acceleration(island.bodies[i]).norm());
    length = std::max(length, size);
    momentum = std::max(momentum, std::max(island.start[i].P.norm(), body.mass * speed));
    angular_momentum =
        std::max(angular_momentum, std::max(island.start[i].L.norm(), body.mass * speed * size));
    turning = std::max(turning, island.start[i].L.norm() / size);
  }
  if (length > 0) result.length_scale = length;
  if (momentum > 0) result.momentum_scale = std::max(momentum, rounding_share * turning);
  if (angular_momentum > 0) result.angular_momentum_scale = angular_momentum;
  return result;
}

IslandStep IslandIntegrator::step(const Island& island, double h) const {
  const std::size_t count = island.bodies.size();
  std::vector<BodyInertia> inertias;
  for (const int body : island.bodies)
    inertias.push_back({model_.body(body).mass, model_.body(body).moments});
  // The books do not move: their paths would only disturb the estimate of the error.
  constexpr double infinite = std::numeric_limits<double>::infinity();
  inertias.resize(count + 2, {infinite, Vec3::Constant(infinite)});
  std::vector<BodyPhase> start = island.start;
  start.resize(count + 2);

  std::shared_ptr<JointSystem> joints;
  const WrenchField field = [&](double t, std::span<const BodyPhase> phases, std::span<Wrench> wrenches) {
    const Load now = load(island, t, phases.first(count), joints);
    std::copy(now.wrenches.begin(), now.wrenches.end(), wrenches.begin());
    wrenches[count] = now.external;
    wrenches[count + 1] = {now.power * Vec3::UnitX(), Vec3::Zero()};
  };
  SystemStep taken = integrate_step(integrator_for(island), orientation_, inertias, start, island.begin, h,
                                    field, tolerances(island));

  IslandStep result{h, {}, {}, taken.error, taken.quaternion_drift};
  result.impulse = taken.end[count].P;
  result.angular_impulse = taken.end[count].L;
  result.work = taken.end[count + 1].P.x();
  taken.end.resize(count);
  taken.dense.resize(count);
  result.end = std::move(taken.end);
  result.dense = std::move(taken.dense);
  return result;
}

ControlledStep IslandIntegrator::controlled_step(const Island& island, double h, double least) const {
  StepController controller(integrator_order(integrator_for(island)));
  while (true) {
    IslandStep taken = step(island, h);
    if (std::isnan(taken.error)) return {std::move(taken), std::numeric_limits<double>::infinity()};
    const StepDecision decision = controller.decide(h, taken.error);
    if (decision.is_accepted || h <= least) return {std::move(taken), decision.h_next};
    h = std::max(least, decision.h_next);
  }
}

}  // namespace rigor
