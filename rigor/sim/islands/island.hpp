#pragma once

#include "rigor/contact/resting/resting.hpp"
#include "rigor/contact/system/work_done.hpp"
#include "rigor/dynamics/dense_phase.hpp"

#include <algorithm>
#include <optional>
#include <vector>

namespace rigor {

/// Dynamic bodies that move together from one event to the next: joined by active contacts, joints and
/// springs, or under forces that have no closed form.
struct Island {
  std::vector<int> bodies;           ///< Ascending.
  std::vector<BodyPhase> start;      ///< At `begin`, one per body.
  std::vector<Contact> contacts;     ///< Active ones, found at `begin`.
  std::vector<ContactState> states;  ///< One per contact.
  double begin = 0;                  ///< [s].
  /// Which rows of redundant joints count, all through a step; chosen where it begins.
  std::optional<JointSystem::RowChoice> joint_rows = std::nullopt;
};

/// One step of an island.
struct IslandStep {
  double h = 0;                ///< [s].
  std::vector<BodyPhase> end;  ///< One per body.
  std::vector<DensePhase> dense;
  double error = 0;  ///< Embedded estimate relative to the tolerance; NaN if the method has none.
  double quaternion_drift = 0;
  VecX end_forces;              ///< λ (3n) at its end, where the method's last stage is there; or none.
  WorkDone work;                ///< [J].
  Vec3 impulse = Vec3::Zero();  ///< Of all forces from outside the island [N s].
  Vec3 angular_impulse = Vec3::Zero();  ///< The same about the origin of W [N m s].
  double unpaid = 0;                    ///< Energy gained that its motion cannot give back [J].
  bool is_implicit = false;             ///< Of first order: contacts answered with impulses.
  bool is_stiff = false;                ///< By the integrator for stiff forces.

  /// Whether the phases are finite, at the end and half way along the paths: explicit integrators overflow
  /// where stiff forces meet long steps.
  bool is_finite() const;
};

inline bool IslandStep::is_finite() const {
  return std::all_of(end.begin(), end.end(), [](const BodyPhase& phase) { return phase.is_finite(); }) &&
         std::all_of(dense.begin(), dense.end(),
                     [](const DensePhase& path) { return path.at(0.5).is_finite(); });
}

}  // namespace rigor
