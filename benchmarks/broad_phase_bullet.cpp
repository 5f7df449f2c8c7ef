// Bullet's broad phases on the same boxes.

#include "broad_phase_cases.hpp"

#include <btBulletCollisionCommon.h>

namespace rigor::bench {
namespace {

btVector3 to_bullet(const Vec3& p) {
  return btVector3(p.x(), p.y(), p.z());
}

BroadPhaseTime time_broad_phase(btBroadphaseInterface& phase, int count) {
  MovingBoxes moving(count);
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  std::vector<btCollisionObject> objects(static_cast<std::size_t>(count));
  std::vector<btBroadphaseProxy*> proxies;
  for (std::size_t i = 0; i < moving.boxes.size(); ++i) {
    proxies.push_back(phase.createProxy(to_bullet(moving.boxes[i].lower), to_bullet(moving.boxes[i].upper), 0,
                                        &objects[i], 1, -1, &dispatcher));
  }
  double total = 0;
  for (int step = 0; step < kSteps + 2; ++step) {
    moving.move();
    const double start = cpu_seconds();
    for (std::size_t i = 0; i < proxies.size(); ++i) {
      phase.setAabb(proxies[i], to_bullet(moving.boxes[i].lower), to_bullet(moving.boxes[i].upper),
                    &dispatcher);
    }
    phase.calculateOverlappingPairs(&dispatcher);
    if (step >= 2) total += cpu_seconds() - start;
  }
  const long pairs = phase.getOverlappingPairCache()->getNumOverlappingPairs();
  for (btBroadphaseProxy* proxy : proxies) phase.destroyProxy(proxy, &dispatcher);
  return {1e3 * total / kSteps, pairs};
}

}  // namespace

BroadPhaseTime bullet_tree_time(int count) {
  btDbvtBroadphase phase;
  return time_broad_phase(phase, count);
}

BroadPhaseTime bullet_sweep_time(int count) {
  const double reach = 3 * std::cbrt(count);
  bt32BitAxisSweep3 phase(btVector3(-reach, -reach, -reach), btVector3(reach, reach, reach),
                          static_cast<unsigned>(count) + 2);
  return time_broad_phase(phase, count);
}

}  // namespace rigor::bench
