#include "rigor/sim/islands/energy_repair.hpp"

#include "rigor/core/sorted_unique.hpp"
#include "rigor/math/dense.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/sim/islands/contact_system_assembler.hpp"
#include "rigor/sim/report/ledger.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace rigor {

namespace {

Mat3 inertia_in_W(const Body& body, const BodyPhase& phase) {
  const Mat3 R = rotation_matrix(phase.q);
  return R * body.moments.asDiagonal() * R.transpose();
}

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
  RigidVelocity rigid_motion(const Vec3& P, const Vec3& L) const {
    RigidVelocity motion{centre(), Vec3::Zero(), Vec3::Zero()};
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
  Vec3 momentum(std::size_t i, const RigidVelocity& motion) const {
    return body(i).mass * (motion.v + motion.w.cross(phases[i].x - motion.centre));
  }
  Vec3 spin(std::size_t i, const RigidVelocity& motion) const {
    return inertia_in_W(body(i), phases[i]) * motion.w;
  }
};

}  // namespace

double energy_of_bodies(const Model& model, const Environment& environment, double t,
                        const std::vector<int>& bodies, const std::vector<BodyPhase>& phases) {
  // Springs may tie bodies to prescribed ones.
  const auto view = [&](int body) {
    if (!holds(bodies, body)) return view_of(prescribed_kinetics(model.body(body), t));
    return view_of(dynamic_kinetics(model.body(body), phases[place_of(bodies, body)]));
  };
  double energy = environment.spring_energy_of(bodies, view);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Body& body = model.body(bodies[i]);
    energy += kinetic_energy(BodyInertia{body.mass, body.moments}, phases[i]) +
              environment.potential(bodies[i], phases[i].x);
  }
  return energy;
}

EnergyBalance energy_balance(const Model& model, const Environment& environment, double t,
                             const std::vector<int>& bodies, const std::vector<Contact>& contacts) {
  // Forces without a potential.
  EnergyBalance balance{true, true, {}};
  for (const int body : bodies) balance.is_closed = balance.is_closed && environment.keeps_energy(body);

  // The prescribed bodies: all stand still, or it is one that moves.
  std::optional<int> carrier;
  const auto add_prescribed = [&](int body) {
    if (body == carrier) return;
    BodyKinetics prescribed;
    if (body != world_body) prescribed = prescribed_kinetics(model.body(body), t);
    const bool stands = prescribed.v.isZero(0) && prescribed.w.isZero(0);
    const bool stood = balance.carrier.v.isZero(0) && balance.carrier.w.isZero(0);
    balance.is_closed = balance.is_closed && (balance.is_free || (stands && stood));
    balance.is_free = false;
    balance.carrier = {prescribed.x, prescribed.v, prescribed.w};
    carrier = body;
  };
  for (const Contact& contact : contacts) {
    for (const int body : {contact.body_A, contact.body_B})
      if (body != world_body && model.body(body).motion != MotionType::dynamic) add_prescribed(body);
  }
  for (const int body : bodies)
    for (const int anchor : environment.joint_anchors(body)) add_prescribed(anchor);

  // What moves the other end of a spring works on it.
  for (const int body : bodies) {
    for (const int anchor : environment.spring_anchors(body)) {
      add_prescribed(anchor);
      balance.is_closed = balance.is_closed && balance.carrier.v.isZero(0) && balance.carrier.w.isZero(0);
    }
  }
  return balance;
}

TakenEnergy take_kinetic_energy(const Model& model, const std::vector<int>& bodies, double amount,
                                const EnergyBalance& balance, std::vector<BodyPhase>& phases) {
  // The rigid motion U: of the carrier, or the one that carries the momenta of a free group.
  const std::vector<BodyPhase> now = phases;
  const Group group{model, bodies, now};
  RigidVelocity rigid = balance.carrier;
  if (balance.is_free) {
    Vec3 P = Vec3::Zero();
    for (const BodyPhase& phase : now) P += phase.P;
    rigid = group.rigid_motion(P, group.angular_momentum(group.centre()));
  }

  // The rest W = V - U, with T(W) and U·M W.
  std::vector<BodyPhase> rest = now;
  double T = 0, power = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    rest[i].P -= group.momentum(i, rigid);
    rest[i].L -= group.spin(i, rigid);
    T += kinetic_energy(BodyInertia{group.body(i).mass, group.body(i).moments}, rest[i]);
    power += rest[i].P.dot(rigid.v + rigid.w.cross(now[i].x - rigid.centre)) + rest[i].L.dot(rigid.w);
  }
  if (!(T > 0)) return {};

  // What can be taken, and 1 - s without cancellation.
  const double taken = std::min(amount, T);
  const double share = taken / T;
  const double less = share / (1 + std::sqrt(1 - share));

  // V = U + s W.
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    phases[i].P -= less * rest[i].P;
    phases[i].L -= less * rest[i].L;
  }
  return {taken, balance.is_free ? 0 : -less * power};
}

bool pay_for_correction(const Model& model, const Environment& environment, const Island& island,
                        const std::vector<BodyPhase>& uncorrected, IslandStep& step) {
  const EnergyBalance balance =
      energy_balance(model, environment, island.begin + step.h, island.bodies, island.contacts);
  if (!balance.is_closed) return true;

  // What the corrections have added.
  const auto energy = [&](double t, const std::vector<BodyPhase>& phases) {
    return energy_of_bodies(model, environment, t, island.bodies, phases);
  };
  const double end = island.begin + step.h;
  const double gained =
      energy(end, step.end) -
      std::max(energy(end, uncorrected), energy(island.begin, island.start) + step.work.supplied);
  if (gained <= 0) return true;

  // All of it is taken, or nothing.
  std::vector<BodyPhase> paid = step.end;
  const TakenEnergy taken = take_kinetic_energy(model, island.bodies, gained, balance, paid);
  if (taken.energy < gained) return false;
  const MomentumScope momentum(model, island.bodies, step.end);
  step.end = std::move(paid);
  step.work.supplied += taken.work;

  // What stands still around the bodies has taken the difference of the momenta.
  if (!balance.is_free) momentum.add_change(step.impulse, step.angular_impulse);
  return true;
}

void give_momenta(const Model& model, const std::vector<int>& bodies, const Vec3& P, const Vec3& L,
                  std::vector<BodyPhase>& phases) {
  const std::vector<BodyPhase> now = phases;
  const Group group{model, bodies, now};
  const RigidVelocity motion = group.rigid_motion(P, L - group.centre().cross(P));
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    phases[i].P += group.momentum(i, motion);
    phases[i].L += group.spin(i, motion);
  }
}

}  // namespace rigor
