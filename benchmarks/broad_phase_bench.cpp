// Broad phase: time a step to keep the pairs of boxes that all move, by their number.

#include "broad_phase_cases.hpp"
#include "rigor/geometry/broad_phase/pair_set.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace {

using namespace rigor;
using namespace rigor::bench;

/// Mean CPU time of a step [ms], after two to begin with, and the pairs at the end. The mean: the tree is
/// built anew every few steps.
BroadPhaseTime time_pair_set(BroadPhaseMethod method, int count) {
  MovingBoxes moving(count);
  PairSet set(method, 0.05);
  double total = 0;
  for (int step = 0; step < kSteps + 2; ++step) {
    moving.move();
    const double start = cpu_seconds();
    set.update(moving.boxes);
    if (step >= 2) total += cpu_seconds() - start;
  }
  return {1e3 * total / kSteps, static_cast<long>(set.pairs().size())};
}

void print(const char* name, int count, const BroadPhaseTime& time) {
  fmt::print("  {:<34} {:>8} {:>12.3f} {:>10.0f} {:>10}\n", name, count, time.milliseconds,
             1e6 * time.milliseconds / count, time.pairs);
  std::fflush(stdout);
}

}  // namespace

int main() {
  fmt::print(
      "Broad phase: boxes of 0.5 to 1 m, one in 8 m^3, all moving by up to 0.02 m a step; median of {} "
      "steps\n",
      kSteps);
  fmt::print("  {:<34} {:>8} {:>12} {:>10} {:>10}\n", "", "boxes", "ms a step", "ns a box", "pairs");
  for (const int count : {1000, 10000, 100000}) {
    print("rigor tree", count, time_pair_set(BroadPhaseMethod::tree, count));
    print("rigor sweep-and-prune", count, time_pair_set(BroadPhaseMethod::sweep_and_prune, count));
#ifdef RIGOR_BENCH_BULLET
    print("bullet btDbvtBroadphase", count, bullet_tree_time(count));
    // To put its boxes in one by one takes minutes for more.
    if (count <= 10000) print("bullet bt32BitAxisSweep3", count, bullet_sweep_time(count));
#endif
  }
}
