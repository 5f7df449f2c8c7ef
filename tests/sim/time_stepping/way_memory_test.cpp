// What is remembered of pairs of bodies while one step is tried.

#include "rigor/sim/time_stepping/way_memory.hpp"

#include "rigor/core/index.hpp"

#include <gtest/gtest.h>

#include <random>

namespace rigor {
namespace {

/// What the ways of a pair show: a number that another way of either body changes.
double shown_by(const Cluster& struck, const Cluster& end, double h, const WayMemory::Pair& pair) {
  double sum = h;
  for (const int body : {pair.first, pair.second})
    for (const Cluster* cluster : {&struck, &end})
      if (body > 0) sum = 3 * sum + cluster->phase_of(body).x.x() + cluster->phase_of(body).P.x();
  return sum;
}

/// Tries at random, in each of which some bodies move otherwise, and sometimes all for another time: what is
/// remembered is what would be found anew, and most of it is not looked for again.
TEST(WayMemory, HoldsAsLongAsBothBodiesMoveAlike) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const std::vector<int> bodies{1, 2, 4, 5};  // 0 is the floor.
  int asked = 0, found = 0;
  for (int step = 0; step < 20; ++step) {
    WayMemory ways;
    Cluster struck{0, bodies, std::vector<BodyPhase>(bodies.size()), {}}, end = struck;
    double h = 0.01;
    for (int k = 0; k < 20; ++k) {
      for (Cluster* cluster : {&struck, &end}) {
        for (BodyPhase& phase : cluster->phases) {
          if (uniform(generator) > 0.8) phase.x.x() = uniform(generator);
          if (uniform(generator) > 0.9) phase.P.x() = uniform(generator);
        }
      }
      if (uniform(generator) > 0.8) h *= 0.5;
      ways.note(struck, end, h);
      for (const WayMemory::Pair& pair : {WayMemory::Pair{0, 1}, {0, 4}, {1, 2}, {1, 5}, {2, 4}, {4, 5}}) {
        if (uniform(generator) > 0.5) continue;
        const auto find = [&] {
          ++found;
          return shown_by(struck, end, h, pair);
        };
        ++asked;
        EXPECT_EQ(ways.meeting(pair, find), shown_by(struck, end, h, pair)) << step << " " << k;
      }
    }
  }
  EXPECT_LT(found, 0.8 * asked);
  EXPECT_GT(found, 0.2 * asked);
}

}  // namespace
}  // namespace rigor
