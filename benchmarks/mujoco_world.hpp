#pragma once

#include "peer_cases.hpp"

#include <memory>

namespace rigor::bench {

/// shipped: Euler steps, pyramidal cone, contact as soft as it comes. elliptic: the same with the cone of
/// Coulomb's law. tuned: RK4, elliptic cone, contact as hard as the step allows.
enum class MujocoSettings { shipped, elliptic, tuned };

/// MuJoCo with this scene.
std::unique_ptr<PeerWorld> make_mujoco_world(const PeerScene& scene, MujocoSettings settings);

}  // namespace rigor::bench
