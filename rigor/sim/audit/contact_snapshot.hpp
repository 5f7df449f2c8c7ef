#pragma once

#include "rigor/model/state.hpp"
#include "rigor/sim/method/tolerances.hpp"
#include "rigor/sim/pairs/touching_points.hpp"

#include <vector>

namespace rigor {

struct Method;

/// All points closer than the method's contact tolerance, with the forces that rest and friction require at
/// this instant: Coulomb's problem of the accelerations (solve_resting), solved for each group of touching
/// bodies by itself. Points that part faster than a thousandth of the resting velocity carry no force. Under
/// `method.scheme: penalty`, where the State remembers springs, the forces are those of the springs. Points
/// are in the order of bodies, shapes and features. Groups of more than `most_contacts` are not solved: their
/// modes are unknown. A function of its arguments alone: it shows what a stepper did, and is not part of one.
std::vector<TouchingPoint> contact_snapshot(const Model& model, const Method& method, const State& state,
                                            std::size_t most_contacts = most_contacts_at_rest);

/// Coordinates and reaction of a joint at an instant.
struct JointReaction {
  int joint;                     ///< Model index.
  Vec3 p_W = Vec3::Zero();       ///< Its anchor on B [m].
  Vec3 force_W = Vec3::Zero();   ///< Reaction of its rows on B [N]; of least norm where joints are redundant.
  Vec3 torque_W = Vec3::Zero();  ///< About the anchor, on B [N m].
  std::vector<double> coordinates;  ///< [rad] or [m].
  std::vector<double> rates;        ///< [rad/s] or [m/s].
  /// Force of the motor along each coordinate [N m] or [N]; 0 where it has none.
  std::vector<double> efforts;
  double residual = 0;  ///< Largest |g| [m or 1].
};

/// All joints of the model, in its order. Groups of more than 600 rows get the forces of the tree that the
/// solver chose instead of those of least norm; reactions and efforts in groups of more than 100 contacts are
/// NaN. A function of its arguments alone, like contact_snapshot.
std::vector<JointReaction> joint_snapshot(const Model& model, const Method& method, const State& state);

/// The same without the reactions and efforts, which are costly: anchors, coordinates and rates, which follow
/// from the State alone.
std::vector<JointReaction> joint_motions(const Model& model, const State& state);

}  // namespace rigor
