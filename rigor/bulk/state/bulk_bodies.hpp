#pragma once

#include "rigor/bulk/threads/executor.hpp"
#include "rigor/core/index.hpp"
#include "rigor/model/model.hpp"
#include "rigor/model/state.hpp"

#include <array>
#include <cstring>
#include <memory>
#include <span>
#include <vector>

namespace rigor {

/// What the solver reads and changes of a body: one cache line, so that eight bodies are gathered into lanes
/// by two squares of eight floats each. Along W's axes.
struct alignas(64) MotionRecord {
  float v[3] = {};     ///< Velocity of the centre of mass [m/s].
  float inv_mass = 0;  ///< Inverse mass [1/kg]; 0 for bodies that stand.
  float w[3] = {};     ///< [rad/s].
  float pad_w = 0;
  float dp[3] = {};  ///< Displacement since the beginning of the step [m].
  float pad_dp = 0;
  float dr[3] = {};  ///< Rotation vector since the beginning of the step [rad].
  float pad_dr = 0;
};

/// A velocity of a body, or its change per second by forces, along W's axes in the layout of MotionRecord:
/// linear, unused, angular, unused.
using MotionRow = std::array<float, 8>;

/// What a linear velocity has beyond its 32 bits, along W's axes [m/s].
using FinerVelocity = std::array<float, 3>;
/// A component of a velocity [m/s] as its 32 bits and twelve more: both are the same again if they are read
/// from a momentum that was made of their sum.
void split_velocity(double v, float& rounded, float& finer);

/// A rotation vector of a body along W's axes, and one number more.
using TiltRow = std::array<float, 4>;

/// Inverse inertia about the centre of mass in W at the beginning of the step [1/(kg m^2)]; 0 for bodies that
/// stand.
struct alignas(32) InverseInertia {
  float xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;
  float inv_mass = 0;  ///< [1/kg].
  float is_held = 0;   ///< Not 0: contacts do not move it, since joints hold it (HeldBodies).
};

/// A vector as it is stored in a record, with the number behind it.
typedef float FloatRow __attribute__((vector_size(16)));
inline FloatRow load_row(const float* a) {
  FloatRow row;
  std::memcpy(&row, a, sizeof row);
  return row;
}
inline void store_row(const FloatRow& row, float* a) {
  std::memcpy(a, &row, sizeof row);
}
/// The cross product; the last element is 0 if it is finite in both.
inline FloatRow cross(const FloatRow& a, const FloatRow& b) {
  return __builtin_shufflevector(a, a, 1, 2, 0, 3) * __builtin_shufflevector(b, b, 2, 0, 1, 3) -
         __builtin_shufflevector(a, a, 2, 0, 1, 3) * __builtin_shufflevector(b, b, 1, 2, 0, 3);
}

/// Rotation vectors r and s with |r|² + |s|² above the square of this [rad] are composed exactly.
constexpr float kFarTurn = 1;
/// r becomes the rotation vector of exp(s) exp(r), exact to rounding. Of the vectors that differ by whole
/// turns it is the one whose length is nearest to |r + s|.
void turn_far(const float* s, float* r);

/// Rotates a body by h ω: dr becomes the rotation vector of exp(h ω) exp(dr), to first order in h ω and third
/// in dr (Baker, Campbell, Hausdorff) where both are small, exactly where they are not.
inline void turn_further(float h, MotionRecord& motion) {
  const FloatRow r = load_row(motion.dr), s = h * load_row(motion.w);
  // Far rotations are composed by their quaternions.
  const FloatRow squares = r * r + s * s;
  if (squares[0] + squares[1] + squares[2] > kFarTurn * kFarTurn) {
    float turn[4];
    store_row(s, turn);
    return turn_far(turn, motion.dr);
  }
  // Near ones by the series r + s - (r × s)/2 + r × (r × s)/12.
  const FloatRow c = cross(r, s), cc = cross(r, c);
  store_row(r + (s + ((1.0F / 12) * cc - 0.5F * c)), motion.dr);
}

/// Moves a body on by its velocities for h [s], in a step whose displacements are added up in 32 bits.
inline void displace(float h, MotionRecord& motion) {
  for (int j = 0; j < 3; ++j) motion.dp[j] += h * motion.v[j];
  turn_further(h, motion);
}

/// The bodies of a Model as arrays, by model index: 64-bit positions, 32-bit velocities.
struct BulkBodies {
  std::vector<Vec3> x;  ///< p_WB of the centre of mass [m].
  std::vector<Quat> q;  ///< q_WB.
  std::vector<MotionRecord> motion;
  std::vector<InverseInertia> inertia;
  /// Angular momenta [kg m²/s] between two steps. The State holds these: angular velocities follow from them
  /// by a rounding that is not undone when they are computed back.
  std::vector<Vec3> L;
  /// Of bodies in flight, between two steps; 0 of all others (FlightVelocities).
  std::vector<FinerVelocity> finer_v;
  /// By what the arms of contacts are turned back in the step [rad] (ElasticTilts); empty if none is.
  std::vector<TiltRow> tilts;

  int count() const { return static_cast<int>(x.size()); }
  /// The first body whose pose or velocity is not finite, -1 if there is none.
  int find_broken() const;
  /// Whether impulses move the body: it is dynamic and does not sleep. The others stand, or move as
  /// prescribed.
  bool is_dynamic(int body) const { return inertia[at(body)].inv_mass > 0; }
  /// Whether contacts move it in this step.
  bool gives_way(int body) const { return is_dynamic(body) && !(inertia[at(body)].is_held > 0); }
  bool has_velocity(int body) const {
    const MotionRecord& m = motion[at(body)];
    return m.v[0] != 0 || m.v[1] != 0 || m.v[2] != 0 || m.w[0] != 0 || m.w[1] != 0 || m.w[2] != 0;
  }
  /// Whether contacts with the body may change in a step.
  bool moves(int body) const { return is_dynamic(body) || has_velocity(body); }
};

/// Reads the bodies of a State: angular velocities are rounded to 32 bits, linear ones to 36; what is written
/// and read again has the same bits.
BulkBodies read_bulk_bodies(const Model& model, const State& state);
/// After a body of the Model has changed: it is where the Model has it at t = 0 with the velocities that it
/// has there, if it is dynamic; else where it is to be at t [s].
void read_changed_body(const Model& model, int body, double t, BulkBodies& bodies);
/// Writes the bodies into the State (all bodies, momenta of the dynamic ones), but not their anchors.
void write_bulk_bodies(const Model& model, const BulkBodies& bodies, State& state);

/// After velocities have been changed: sets the angular momentum of a dynamic body, and its angular velocity
/// as it would be read from a State.
void set_momentum(const Model& model, int body, BulkBodies& bodies);

/// Lets a dynamic body stand as if it were fixed (it sleeps), or move again from the beginning of the next
/// step on.
void set_standing(const Model& model, int body, bool stands, BulkBodies& bodies);

/// Begins a step: displacements become zero, and the inertia in W is computed of the dynamic bodies that are
/// marked in `touches` (by body; if it is empty, of all). Bodies that touch nothing in the step do not need
/// it.
void begin_bulk_step(const Model& model, const Executor& executor, BulkBodies& bodies,
                     std::span<const char> touches = {});
/// Within a step, after the displacements so far: the orientation of a body, and the kinetic energy of a
/// dynamic body [J].
Quat orientation_now(int body, const BulkBodies& bodies);
double kinetic_energy_now(const Model& model, int body, const BulkBodies& bodies);
/// Ends a step: applies the displacements to positions and orientations.
void end_bulk_step(const Executor& executor, BulkBodies& bodies);

}  // namespace rigor
