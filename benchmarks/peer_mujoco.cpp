// MuJoCo on the reference scenes: soft convex contact.

#include "mujoco_world.hpp"

namespace rigor::bench {

namespace {

Peer make_peer(const std::string& name, MujocoSettings settings) {
  return {name, [settings](const PeerScene& scene) { return make_mujoco_world(scene, settings); }};
}

}  // namespace

std::vector<Row> mujoco_rows() {
  const Peer shipped = make_peer("MuJoCo {}", MujocoSettings::shipped);
  const Peer tuned = make_peer("MuJoCo RK4 {}", MujocoSettings::tuned);
  return {free_top(shipped, 1e-3), free_top(tuned, 1e-2),  free_top(tuned, 1e-3), bounce(tuned, 1e-3),
          bounce(tuned, 1e-4),     block_sticks(shipped),  block_sticks(tuned),   block_slides(shipped),
          block_slides(tuned),     slide_to_roll(shipped), slide_to_roll(tuned),  gas(shipped),
          fast_ball(shipped)};
}

}  // namespace rigor::bench
