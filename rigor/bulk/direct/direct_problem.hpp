#pragma once

#include "rigor/solver/motion/motion_problem.hpp"

#include <optional>
#include <vector>

namespace rigor {

/// An island as a problem of its points, three rows each.
struct DirectProblem {
  MotionProblem motion;  ///< Without b.
  VecX V;                ///< Velocities at the end of the step without contacts, six a body.
  VecX given;            ///< Relative velocities by bodies that are not dynamic.
  std::vector<Mat3> frames;
  std::vector<double> gaps;          ///< [m].
  std::vector<double> restitutions;  ///< Of each point.
  VecX start;                        ///< Impulses of the step before [N s].
  VecX V_begin;                      ///< Velocities at the beginning of the step.

  /// Kinetic energy at these velocities [J].
  double kinetic(const VecX& V_bodies) const { return 0.5 * product(V_bodies, V_bodies); }
  /// Work of the forces of the step over the displacements at these velocities [J].
  double work(const VecX& V_bodies) const { return product(V - V_begin, V_bodies); }
  /// a · M b.
  double product(const VecX& a, const VecX& b) const;
  /// The energy that velocities at the end add beyond rounding [J].
  double gain(const VecX& V_end) const;
  /// The part of the velocities at the end that takes no more than there was: Moreau's step gives nothing,
  /// but between bodies of the mass ratio 1e10 rounding does: a part of what forces would do in the step.
  VecX affordable(const VecX& V_end) const;
  /// The rows of a point, its gap [m], its coefficient of friction, the velocity of bodies that are not
  /// dynamic along the frame, and the impulse with which it begins.
  void add_point(const Mat3& frame, double gap, double friction, const ContactRows::Sides& sides,
                 const Vec3& prescribed, const Vec3& impulse);
  /// u + max(s, 0)/h at the velocities V_bodies: relative velocities, with what gaps allow. Of an overlap s <
  /// 0 this share is put back.
  VecX rates(const VecX& V_bodies, double h, double share) const;
  /// What the impulses λ of a step that ends with V_pressed become where points bounce, less λ: nothing if
  /// none does. h: of the step [s].
  std::optional<VecX> bounce(const VecX& lambda, const VecX& V_pressed, double h) const;
  /// V + M⁻¹ Jᵀ λ.
  VecX velocities_after(const VecX& V_bodies, const VecX& lambda) const;
};

/// Three more numbers at the end of a vector.
void append(const Vec3& part, VecX& whole);

/// The impulses λ of section 6 of docs/theory/bulk.md; nothing if the problem was not solved to 1e-9 of its
/// terms.
std::optional<VecX> solve_impulses(const MotionProblem& problem, const VecX& start);

}  // namespace rigor
