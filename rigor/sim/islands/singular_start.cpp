#include "rigor/sim/islands/singular_start.hpp"

#include "rigor/contact/system/joint_system.hpp"
#include "rigor/core/index.hpp"

#include <numeric>
#include <utility>
#include <vector>

namespace rigor {

namespace {

/// The joints of a model with the bodies where they are, and at rest.
struct Mechanism {
  const Model& model;
  std::vector<int> joints, bodies;
  std::vector<BodyKinetics> kinetics;

  Mechanism(const Model& of, const State& state) : model(of) {
    joints.resize(of.joints().size());
    std::iota(joints.begin(), joints.end(), 0);
    bodies.resize(at(of.body_count()));
    std::iota(bodies.begin(), bodies.end(), 0);
    for (const int body : bodies) {
      const BodyPhase still{state.position(body), state.orientation(body), Vec3::Zero(), Vec3::Zero()};
      const bool is_dynamic = of.body(body).motion == MotionType::dynamic;
      BodyKinetics& of_body = kinetics.emplace_back(is_dynamic ? dynamic_kinetics(of.body(body), still)
                                                               : prescribed_kinetics(of.body(body), state.t));
      of_body.v = of_body.w = Vec3::Zero();
    }
  }

  JointSystem equations(const JointSystem::RowChoice* choice) const {
    return {model, joints, bodies, kinetics, {.choice = choice, .without_motors = true}};
  }

  /// The velocities that the bodies have with these momenta where no joint holds them.
  std::vector<Vec6> alone(const std::vector<Vec6>& momenta) const {
    std::vector<Vec6> velocities(momenta.size());
    for (std::size_t b = 0; b < kinetics.size(); ++b)
      velocities[b] << kinetics[b].inverse_mass * momenta[b].head<3>(),
          kinetics[b].inverse_inertia * momenta[b].tail<3>();
    return velocities;
  }

  /// The product of momenta with the part of their velocities that is left [J].
  static double twice_energy(const std::vector<Vec6>& momenta, const std::vector<Vec6>& velocities) {
    double sum = 0;
    for (std::size_t b = 0; b < momenta.size(); ++b) sum += momenta[b].dot(velocities[b]);
    return sum;
  }

  void move(const std::vector<Vec6>& velocities) {
    for (std::size_t b = 0; b < kinetics.size(); ++b) {
      if (kinetics[b].inverse_mass == 0) continue;
      kinetics[b].v = velocities[b].head<3>();
      kinetics[b].w = velocities[b].tail<3>();
    }
  }
};

/// Of the joints, moving with the part of these velocities that they allow.
std::optional<int> contradiction(Mechanism mechanism, const std::vector<Vec6>& momenta) {
  // The velocities that the joints allow, nearest to these by their masses.
  constexpr double share = 1e-3;
  const JointSystem still = mechanism.equations(nullptr);
  const VecX none = VecX::Zero(still.biases().size());
  const std::vector<Vec6> allowed = still.respond(momenta, none).a;
  // Where joints take all of it, as the hinges of a door take its weight, what is left is rounding.
  constexpr double rounding = 1e-20;
  if (!(mechanism.twice_energy(momenta, allowed) >
        rounding * mechanism.twice_energy(momenta, mechanism.alone(momenta))))
    return std::nullopt;
  mechanism.move(allowed);

  // The accelerations with which they go on, by the rows that count: the others follow, or contradict.
  const JointSystem moving = mechanism.equations(&still.choice());
  const double size = moving.biases().size() > 0 ? moving.biases().cwiseAbs().maxCoeff() : 0;
  const std::vector<Vec6> nothing(momenta.size(), Vec6::Zero());
  const auto [error, joint] = moving.largest_contradiction(moving.respond(nothing, -moving.biases()).a);
  return error > share * size ? std::optional<int>(joint) : std::nullopt;
}

}  // namespace

std::optional<int> singular_joint(const Model& model, const State& state) {
  if (model.joints().empty()) return std::nullopt;
  const Mechanism mechanism(model, state);
  if (mechanism.equations(nullptr).choice().empty()) return std::nullopt;
  std::vector<Vec6> by_gravity(at(model.body_count()), Vec6::Zero()), given = by_gravity;
  for (const int body : mechanism.bodies) {
    if (model.body(body).motion != MotionType::dynamic) continue;
    by_gravity[at(body)].head<3>() = model.body(body).mass * model.g_W();
    given[at(body)] << state.linear_momentum(body), state.angular_momentum(body);
  }
  const std::optional<int> joint = contradiction(mechanism, by_gravity);
  return joint ? joint : contradiction(mechanism, given);
}

}  // namespace rigor
