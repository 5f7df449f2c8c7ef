#include "rigor/sim/islands/energy_repair.hpp"

#include "rigor/math/dense.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

Mat3 inertia_in_W(const Body& body, const BodyPhase& phase) {
  const Mat3 R = rotation_matrix(phase.q);
  return R * body.moments.asDiagonal() * R.transpose();
}

/// Motion of a group as one rigid body: v of its centre of mass, ω.
struct RigidMotion {
  Vec3 centre = Vec3::Zero(), v = Vec3::Zero(), w = Vec3::Zero();
};

struct Group {
  const Model& model;
  const std::vector<int>& bodies;
  const std::vector<BodyPhase>& phases;

  const Body& body(std::size_t i) const { return model.body(bodies[i]); }
  Vec3 centre() const {
    double mass = 0;
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      mass += body(i).mass;
      sum += body(i).mass * phases[i].x;
    }
    return sum / mass;
  }
  Vec3 angular_momentum(const Vec3& about) const {
    Vec3 L = Vec3::Zero();
    for (const BodyPhase& phase : phases) L += phase.L + (phase.x - about).cross(phase.P);
    return L;
  }
  /// With this momentum and angular momentum about the centre.
  RigidMotion rigid_motion(const Vec3& P, const Vec3& L) const {
    RigidMotion motion{centre(), Vec3::Zero(), Vec3::Zero()};
    double mass = 0;
    Mat3 inertia = Mat3::Zero();
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const Vec3 arm = phases[i].x - motion.centre;
      mass += body(i).mass;
      inertia += inertia_in_W(body(i), phases[i]) +
                 body(i).mass * (arm.squaredNorm() * Mat3::Identity() - arm * arm.transpose());
    }
    motion.v = P / mass;
    motion.w = symmetric_solution(inertia, L);
    return motion;
  }
  /// Momentum and angular momentum that body i has in the rigid motion.
  Vec3 momentum(std::size_t i, const RigidMotion& motion) const {
    return body(i).mass * (motion.v + motion.w.cross(phases[i].x - motion.centre));
  }
  Vec3 spin(std::size_t i, const RigidMotion& motion) const {
    return inertia_in_W(body(i), phases[i]) * motion.w;
  }
};

}  // namespace

double energy_of_bodies(const Model& model, const Environment& environment, const std::vector<int>& bodies,
                        const std::vector<BodyPhase>& phases) {
  double energy = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Body& body = model.body(bodies[i]);
    energy += kinetic_energy(BodyInertia{body.mass, body.moments}, phases[i]) +
              environment.potential(bodies[i], phases[i].x);
  }
  return energy;
}

EnergyBalance energy_balance(const Model& model, const Environment& environment, double t,
                             const std::vector<int>& bodies, const std::vector<Contact>& contacts) {
  // Forces besides gravity and steady ones, then prescribed bodies, and whether these move.
  EnergyBalance balance{true, true};
  for (const int body : bodies) balance.is_closed = balance.is_closed && !environment.is_forced(body);
  for (const Contact& contact : contacts) {
    for (const int body : {contact.body_A, contact.body_B}) {
      if (model.body(body).motion == MotionType::dynamic) continue;
      const BodyKinetics prescribed = prescribed_kinetics(model.body(body), t);
      balance.is_free = false;
      balance.is_closed = balance.is_closed && prescribed.v.isZero(0) && prescribed.w.isZero(0);
    }
  }
  return balance;
}

double take_kinetic_energy(const Model& model, const std::vector<int>& bodies, double amount, bool is_free,
                           std::vector<BodyPhase>& phases) {
  // The rigid motion U that carries the momenta of a free group; otherwise none.
  const std::vector<BodyPhase> now = phases;
  const Group group{model, bodies, now};
  RigidMotion rigid;
  if (is_free) {
    Vec3 P = Vec3::Zero();
    for (const BodyPhase& phase : now) P += phase.P;
    rigid = group.rigid_motion(P, group.angular_momentum(group.centre()));
  }

  // The rest W = V - U, and T(W).
  std::vector<BodyPhase> rest = now;
  double T = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    rest[i].P -= group.momentum(i, rigid);
    rest[i].L -= group.spin(i, rigid);
    T += kinetic_energy(BodyInertia{group.body(i).mass, group.body(i).moments}, rest[i]);
  }
  if (!(T > 0)) return 0;

  // What can be taken, and 1 - s without cancellation.
  const double taken = std::min(amount, T);
  const double share = taken / T;
  const double less = share / (1 + std::sqrt(1 - share));

  // V = U + s W.
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    phases[i].P -= less * rest[i].P;
    phases[i].L -= less * rest[i].L;
  }
  return taken;
}

}  // namespace rigor
