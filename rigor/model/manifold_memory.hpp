#pragma once

#include <array>
#include <cstdint>

namespace rigor {

/// What of a touching pair of shapes goes on from step to step: where the solver begins. Part of the State,
/// so that a fresh stepper goes on bit for bit.
struct ManifoldMemory {
  static constexpr int max_points = 4;

  int body_A = -1, body_B = -1;    ///< Model indices.
  int shape_A = -1, shape_B = -1;  ///< Of these bodies.
  int part = 0;                    ///< Of a pair of shapes with several manifolds (meshes), its number.
  int point_count = 0;             ///< At most max_points; of others there are no features and impulses.
  std::array<std::uint32_t, max_points> feature{};
  std::array<float, max_points> normal_impulse{};  ///< Of the last substep [N s], >= 0.
  std::array<float, 3> friction_impulse_W{};       ///< On B, of the last substep [N s].
  float twist_impulse = 0;                         ///< About the normal, on B [N m s].
  std::array<float, 3> rolling_impulse_W{};        ///< Of rolling friction, on B [N m s].
  float energy = 0;                                ///< That its springs hold [J].

  bool operator==(const ManifoldMemory& other) const = default;
  std::array<int, 5> key() const { return {body_A, body_B, shape_A, shape_B, part}; }
};

}  // namespace rigor
