#pragma once

#include "rigor/bulk/state/bulk_bodies.hpp"
#include "rigor/core/index.hpp"
#include "rigor/geometry/shape/aabb.hpp"

#include <array>
#include <vector>

namespace rigor {

/// How far a body has gone within a step.
struct BodyDisplacement {
  Vec3 dp;    ///< Displacement [m].
  Quat turn;  ///< Rotation, along W's axes.
};

/// The paths of bodies that joints hold: not straight, but as the substeps have taken them. Wherever these
/// ended, the joints hold.
class JointedPaths {
 public:
  /// A step of so many substeps begins.
  void begin(std::size_t bodies, int substeps);
  /// After each of them: where the bodies are.
  void note(const BulkBodies& bodies, const std::vector<int>& moving, const std::vector<char>& is_jointed);

  /// Whether the path of the body is known, which is that of all bodies that were noted in each substep.
  bool has(int body) const { return at(body) < first_.size() && first_[at(body)] >= 0; }
  /// After the part t of the step, from 0 to 1; within a substep along its displacement.
  BodyDisplacement point(int body, double t) const;
  /// The box about all displacements of the centre.
  Aabb box(int body) const;
  /// Lengths of the paths of the centre [m] and of the orientation [rad].
  std::array<double, 2> lengths(int body) const;

 private:
  /// Displacement and rotation vector after a substep.
  using Leg = std::array<float, 6>;
  const Leg& leg(int body, int k) const { return legs_[at(k) * jointed_ + at(first_[at(body)])]; }

  int substeps_ = 0, noted_ = 0;
  std::size_t jointed_ = 0;  ///< Bodies that are noted.
  std::vector<int> first_;   ///< Place of each body among these; -1: none.
  std::vector<Leg> legs_;    ///< Of the first substep, then of the second, ...
};

}  // namespace rigor
