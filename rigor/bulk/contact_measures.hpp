#pragma once

#include "rigor/bulk/bulk_bodies.hpp"
#include "rigor/bulk/manifold_blocks.hpp"

#include <array>

namespace rigor {

/// Impulses of eight manifolds, added up over the substeps of a step: each substep ends with all that its
/// contacts have done in it.
struct alignas(32) BlockTotals {
  std::array<LaneArray, Manifold::max_points> normal{};  ///< [N s].
  LaneArray tangent[2]{};                                ///< Along t1, t2, on B [N s].
  LaneArray twist{}, roll[2]{};                          ///< About n, t1, t2 [N m s].

  void add(const ManifoldBlock& block);
};

/// The frame of a manifold at its centre, in W.
struct ManifoldFrame {
  Vec3 n, t1, t2;
  Vec3 rA, rB;  ///< The centre from those of the bodies [m].
};
ManifoldFrame manifold_frame(const ManifoldBlock& block, int lane);

/// All that a manifold did to body B in a step: the impulse at its centre [N s] and the moment of it about
/// the centre [N m s], in W. Body A has got the opposite.
struct ManifoldWrench {
  Vec3 impulse, moment;
};
ManifoldWrench total_wrench(const ManifoldBlock& block, const BlockTotals& totals, int lane);

/// Work of a manifold on the dynamic one of its bodies, if the other moves as it must [J]; else 0. Velocities
/// of that and arms are constant in a step.
double work_of_mover(const ManifoldBlock& block, const BlockTotals& totals, int lane,
                     const BulkBodies& bodies);

/// Energy that the springs of a manifold hold at the end of a step of substeps of h [s], in J: Σ ½ k s² over
/// its points that overlap by s, but not more than they held before (`held`) and the work that has pressed
/// them in the step: overlaps that an impact makes are not paid for by it. What the soft constraint of
/// section 3 of docs/theory/bulk.md does at rest is the force of a spring of stiffness k = m ω².
double spring_energy(const ManifoldBlock& block, const BlockTotals& totals, int lane,
                     const BulkBodies& bodies, double h, int substeps, double held);

/// The fastest approach of its points at the begin of the step [m/s], >= 0, of points that were pressed in
/// it; 0 if none was.
double approach_speed(const ManifoldBlock& block, int lane);

}  // namespace rigor
