#pragma once

#include "rigor/bulk/contacts/solved_manifold.hpp"
#include "rigor/bulk/state/bulk_bodies.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace rigor {

/// The response of a body's velocities to a wrench (F, T) along n, t1, t2 at the centre of the manifold, with
/// the inertia that contacts have: dv and dw times it.
struct WrenchResponse {
  Eigen::Matrix<double, 3, 6> dv, dw;
  Mat6 K;  ///< Of (V, Ω) there.
};
/// r: the centre of the manifold from the centre of mass.
WrenchResponse response_of(const InverseInertia& inertia, const ManifoldFrame& f, const Vec3& r);

/// (V, Ω) of body B against A along n, t1, t2 at the centre of the manifold, as blocks have it
/// (docs/theory/bulk.md, section 2).
Vec6 motion_at(const SolvedManifold& manifold, const BulkBodies& bodies);
/// The same of one body alone.
Vec6 motion_at(const ManifoldFrame& f, const Vec3& r, const MotionRecord& motion);

/// u·row is the normal velocity of the point, and an impulse of the point that multiple of a wrench.
Vec6 row_of(const SolvedManifold::Point& point);

/// Whether a point met in the step faster than it may rest, and was pressed.
bool strikes(const SolvedManifold& manifold, std::size_t point);
/// Whether any point does.
bool strikes(const SolvedManifold& manifold);

/// Normal velocity at which a point that strikes met [m/s]: from the beginning of the step on forces change
/// it by `accelerations`, of each body, until its gap is closed. Bounces would be lower by up to g times the
/// step else.
/// What does not give way is not accelerated.
double meeting_speed(const SolvedManifold& manifold, std::size_t point,
                     const std::vector<MotionRow>& accelerations, const BulkBodies& bodies);

/// Impulses of a manifold besides those that it has, and their wrench.
struct ImpactImpulses {
  std::array<double, Manifold::max_points> points{};
  Eigen::Vector2d slip = Eigen::Vector2d::Zero(), roll = Eigen::Vector2d::Zero();
  double twist = 0;
  Vec6 wrench = Vec6::Zero();

  /// A part of them.
  ManifoldImpulses part(double share) const;
};

/// A quadratic function without a constant: what a part κ of a change costs.
struct ImpactCost {
  double square = 0, linear = 0;  ///< square κ² + linear κ [J].

  /// The largest part, at most 1, that costs no more than `most` >= 0.
  double affordable_part(double most) const {
    if (square + linear <= most) return 1;
    return (-linear + std::sqrt(linear * linear + 4 * square * most)) / (2 * square);
  }
};

/// What an impact is to end with.
struct ImpactAim {
  /// Normal velocities that points which strike are to part at [m/s].
  std::array<double, Manifold::max_points> speeds{};
  /// Whether what has struck too hard is taken back: points that part faster lose of the impulse that they
  /// have. Else impulses are only added.
  bool may_take_back = false;
};

/// The impulses with which points that strike part at the speeds of the aim, others that were pressed do not
/// come closer, and friction is that of the whole impact: it stops as much of slip, twist and rolling as all
/// normal impulses, those of the step with these, bear (Coulomb). u: (V, Ω) as the bodies move now, K: its
/// response to wrenches.
///
/// Source: Pfeiffer and Glocker, Multibody Dynamics with Unilateral Contacts, 1996, chapter 8, for Newton's
/// and Coulomb's laws with several points.
ImpactImpulses find_impact(const SolvedManifold& manifold, const ImpactAim& aim, const Vec6& u,
                           const Mat6& K);

}  // namespace rigor
