#pragma once

#include "rigor/geometry/shape/aabb.hpp"

#include <cmath>
#include <ctime>
#include <random>
#include <vector>

namespace rigor::bench {

inline constexpr int kSteps = 20;

/// Boxes that fly straight on in a cube, the same for every engine.
class MovingBoxes {
 public:
  explicit MovingBoxes(int count) {
    std::mt19937_64 engine(17);
    const auto number = [&] { return std::ldexp(static_cast<double>(engine() >> 11), -53); };
    const double side = 2 * std::cbrt(count);
    for (int i = 0; i < count; ++i) {
      const Vec3 p(side * number(), side * number(), side * number());
      const Vec3 half = Vec3::Constant(0.25) + 0.25 * Vec3(number(), number(), number());
      boxes.push_back({p - half, p + half});
      steps_.push_back(0.02 * (2 * Vec3(number(), number(), number()) - Vec3::Ones()));
    }
  }
  void move() {
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      boxes[i].lower += steps_[i];
      boxes[i].upper += steps_[i];
    }
  }

  std::vector<Aabb> boxes;

 private:
  std::vector<Vec3> steps_;
};

/// CPU time of the process so far [s].
inline double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct BroadPhaseTime {
  double milliseconds;  ///< Mean of a step.
  long pairs;           ///< At the end, as the engine keeps them (Bullet's boxes have a margin of their own).
};

#ifdef RIGOR_BENCH_BULLET
BroadPhaseTime bullet_tree_time(int count);
BroadPhaseTime bullet_sweep_time(int count);
#endif

}  // namespace rigor::bench
