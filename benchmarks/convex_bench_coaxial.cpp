// Solids of revolution whose axes are parallel, or nearly: a circle of directions is as good, or nearly so,
// as the best one.

#include "convex_bench.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/math/rotation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

namespace rigor::bench {
namespace {

constexpr std::array kAxes = {"concentric", "coaxial", "beside"};
constexpr int kPairs = 60, kPasses = 5;

struct Pair {
  Shape a, b;
  Pose X_WA, X_WB;
};

class Draw {
 public:
  explicit Draw(unsigned seed) : random_(seed) {}

  double within(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }

  Shape solid() {
    const int kind = static_cast<int>(within(0, 3));
    const double radius = within(0.05, 0.5), half_length = within(0.05, 0.5);
    if (kind == 0) return Cylinder{radius, half_length};
    if (kind == 1) return Cone{radius, half_length};
    return Capsule{radius, half_length};
  }

  Vec3 direction() {
    std::normal_distribution<double> normal;
    return Vec3(normal(random_), normal(random_), normal(random_)).normalized();
  }

  /// Two solids that overlap, the one inside the other's extent along its axis (or at its origin), tilted.
  Pair pair(std::size_t axes, double tilt) {
    Pair pair{solid(), solid(), {}, {}};
    pair.X_WA = Pose{rotation_matrix(rotation_exp(within(0, std::numbers::pi) * direction())),
                     within(0, 2) * direction()};
    const double angle = within(0, 2 * std::numbers::pi);
    const double along = axes == 0 ? 0 : within(-0.1, 0.1),
                 beside = axes < 2 ? 0 : std::pow(10, within(-7, -1.3));
    const Vec3 across(std::cos(angle), std::sin(angle), 0);
    const Pose X_AB{rotation_matrix(rotation_exp(tilt * Vec3(-across.y(), across.x(), 0))),
                    Vec3(beside, 0, along)};
    pair.X_WB = pair.X_WA * X_AB;
    return pair;
  }

 private:
  std::mt19937 random_;
};

}  // namespace

void print_coaxial() {
  using Clock = std::chrono::steady_clock;
  fmt::print(
      "\ncylinders, cones and capsules with axes that are parallel or tilted, overlapping: {} pairs each\n"
      "{:<12}{:>9}{:>14}{:>12}{:>14}\n",
      kPairs, "axes", "tilt", "median [us]", "most [us]", "widest bounds");
  Draw draw(20240607);
  for (std::size_t axes = 0; axes < kAxes.size(); ++axes) {
    for (const double tilt : {0.0, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2}) {
      std::vector<double> times;
      double widest = 0;
      for (int i = 0; i < kPairs; ++i) {
        const Pair pair = draw.pair(axes, tilt);
        double least = std::numeric_limits<double>::infinity();
        for (int pass = 0; pass < kPasses; ++pass) {
          const Clock::time_point begin = Clock::now();
          const DistanceResult result = signed_distance(pair.a, pair.X_WA, pair.b, pair.X_WB);
          least = std::min(least, std::chrono::duration<double, std::micro>(Clock::now() - begin).count());
          widest = std::max(widest, result.upper - result.lower);
        }
        times.push_back(least);
      }
      std::sort(times.begin(), times.end());
      fmt::print("{:<12}{:>9.0e}{:>14.2f}{:>12.1f}{:>14.1e}\n", kAxes[axes], tilt, times[kPairs / 2],
                 times.back(), widest);
    }
  }
}

}  // namespace rigor::bench
