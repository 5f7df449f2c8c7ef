#pragma once

#include "rigor/bulk/joints/joint_forest.hpp"
#include "rigor/math/types.hpp"

#include <memory>
#include <vector>

namespace rigor {

struct JointBlock;

/// The equations of systems of joints with loops and gears, of all lanes in use. With the rows C of all
/// joints and the masses M of the bodies, the impulses λ follow from
///
///   (C M⁻¹ Cᵀ + S) λ = -residual - C M⁻¹ push,    Δv = M⁻¹ (push + Cᵀ λ),
///
/// S being the softness of laws: a sparse Cholesky factorisation in 64 bits, in an order of little fill. Rows
/// that loops make redundant share their impulse evenly: docs/theory/bulk_joints.md.
class LoopSolver {
 public:
  explicit LoopSolver(const JointSystems& systems);
  LoopSolver(LoopSolver&& other) noexcept;
  ~LoopSolver();

  /// Factors where the rows of the block are now.
  void factor(const JointBlock& block);
  /// Impulses that take the residuals away and the pushes up; changes of the slots.
  void solve(JointBlock& block) const;

 private:
  struct Lane;
  struct Side;
  struct Pattern;
  void read_rows(const JointBlock& block, Lane& lane) const;
  void assemble(Lane& lane) const;
  VecX impulses(const Lane& lane, const VecX& b, bool of_places) const;
  void solve_lane(const Lane& lane, JointBlock& block) const;

  std::unique_ptr<const Pattern> pattern_;
  std::vector<Lane> lanes_;  ///< Those in use.
};

}  // namespace rigor
