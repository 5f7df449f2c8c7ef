#pragma once

#include "rigor/core/index.hpp"
#include "rigor/math/types.hpp"
#include "rigor/model/contact_memory.hpp"
#include "rigor/model/event_memory.hpp"
#include "rigor/model/handover_memory.hpp"
#include "rigor/model/manifold_memory.hpp"
#include "rigor/model/model.hpp"

#include <cstddef>
#include <vector>

namespace rigor {

/// Everything needed to continue bit for bit: the time and, for each body, Y = (x, q, P, L), as flat arrays.
/// Momenta are the state; velocities are derived.
///
/// Each body also has its *anchor*: the epoch and phase at which its present smooth motion began (its last
/// event). A body in closed-form flight is evaluated from its anchor, never from the last output, so that
/// looking at a trajectory does not change it and rounding does not accumulate. x, q, P, L are the phases at
/// t; code that changes them directly must call anchor_here() (or use set_body).
struct State {
  double t = 0;           ///< [s].
  std::vector<double> x;  ///< 3n: p_WB of the centre of mass [m].
  std::vector<double> q;  ///< 4n: q_WB as w x y z.
  std::vector<double> P;  ///< 3n: linear momentum in W [kg m/s]; 0 for kinematic and fixed bodies.
  std::vector<double> L;  ///< 3n: angular momentum about the centre of mass in W [kg m²/s]; 0 as above.

  std::vector<double> epoch;   ///< n: time of each anchor, ≤ t [s].
  std::vector<double> anchor;  ///< 13n: x, q, P, L of each body at its epoch.

  /// Memory of contacts from step to step, for schemes that have one; in the order of the keys.
  std::vector<ContactMemory> contacts;
  /// The same for the many-body path, which packs them while it works.
  std::vector<ManifoldMemory> manifolds;
  std::vector<float> joint_impulses;  ///< Many-body path: six per joint, in the order of the model.
  /// How long each body has been slow [s], infinite if it sleeps; empty if none may sleep.
  std::vector<float> quiet_time;
  HandoverMemory handover;  ///< Of the scheme `auto`.
  EventMemory events;       ///< Of schemes that go from event to event.

  bool operator==(const State& other) const = default;

  int body_count() const { return static_cast<int>(epoch.size()); }
  Vec3 position(int body) const { return Vec3::Map(&x[3 * at(body)]); }
  Quat orientation(int body) const {
    const double* w = &q[4 * at(body)];
    return Quat(w[0], w[1], w[2], w[3]);
  }
  Vec3 linear_momentum(int body) const { return Vec3::Map(&P[3 * at(body)]); }
  Vec3 angular_momentum(int body) const { return Vec3::Map(&L[3 * at(body)]); }

  /// Sets a body's phase at t and anchors it there.
  void set_body(int body, const Vec3& x_new, const Quat& q_new, const Vec3& P_new, const Vec3& L_new);
  /// Anchors one body at its present phase and time.
  void anchor_body(int body);
  /// Anchors every body at its present phase and time.
  void anchor_here();
};

/// The State at t = 0 that the Model describes.
State make_initial_state(const Model& model);

/// Velocity of the centre of mass of a body in W [m/s]; that of its prescribed motion for kinematic bodies.
Vec3 linear_velocity(const Model& model, const State& state, int body);
/// Angular velocity of a body in W [rad/s]; that of its prescribed motion for kinematic bodies.
Vec3 angular_velocity(const Model& model, const State& state, int body);

/// Pose of a kinematic or fixed body at time t: constant velocities from t = 0, or along its path (positions
/// piecewise linear, orientations rotating at a constant rate between path points).
struct PrescribedMotion {
  Vec3 p_WB;
  Quat q_WB;
  Vec3 v_WB;  ///< [m/s]; at a path point the velocity of the leg that begins there.
  Vec3 w_WB;  ///< [rad/s], in W.
};
PrescribedMotion prescribed_motion(const Body& body, double t);

/// Bytes that restore the same State bit for bit (little-endian doubles with a header and a checksum).
std::vector<unsigned char> serialise(const State& state);
/// The State of those bytes; an InputError that says what is wrong if they are not from serialise() or
/// damaged.
State deserialise(const std::vector<unsigned char>& bytes);

}  // namespace rigor
