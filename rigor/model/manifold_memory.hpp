#pragma once

#include "rigor/core/index.hpp"
#include "rigor/model/contact_key.hpp"

#include <array>
#include <cstdint>

namespace rigor {

/// What the many-body path keeps of a touching pair of shapes from step to step: the impulses with which its
/// solver starts. Part of the State, so that a fresh stepper continues bit for bit.
struct ManifoldMemory {
  static constexpr int max_points = 4;

  int body_A = -1, body_B = -1;    ///< Model indices.
  int shape_A = -1, shape_B = -1;  ///< Of these bodies.
  int part = 0;                    ///< Number of the manifold if the pair has several (meshes).
  int point_count = 0;             ///< At most max_points: how many features and impulses are used.
  std::array<std::uint32_t, max_points> feature{};
  std::array<float, max_points> normal_impulse{};  ///< Of the last substep [N s], >= 0.
  std::array<float, 3> friction_impulse_W{};       ///< On B, where the next step begins [N s].
  float twist_impulse = 0;                         ///< About the normal, on B [N m s].
  std::array<float, 3> rolling_impulse_W{};        ///< Of rolling friction, on B [N m s].
  float energy = 0;                                ///< Elastic energy of its springs [J].

  bool operator==(const ManifoldMemory& other) const = default;
  ContactKey key() const { return {body_A, body_B, shape_A, shape_B, at(part)}; }
};

}  // namespace rigor
