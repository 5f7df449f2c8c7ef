// One frictional impact a million times: time of each, and what must hold of each.

#include "rigor/contact/impact/collision.hpp"
#include "rigor/math/splitmix64.hpp"

#include <fmt/format.h>
#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <vector>

namespace {

using namespace rigor;

constexpr int count = 1000000;

class Random {
 public:
  double uniform(double lo, double hi) {
    return lo + (hi - lo) * static_cast<double>(generator_.next() >> 11) * 0x1p-53;
  }
  Vec3 vector() {
    const double x = uniform(-1, 1), y = uniform(-1, 1), z = uniform(-1, 1);
    return {x, y, z};
  }

 private:
  SplitMix64 generator_{2026};
};

/// K with random axes and a condition of up to 10^digits, μ up to 1.5, approach and slip of one size.
Collision random_collision(Random& random, double digits) {
  Mat3 A;
  for (int k = 0; k < 3; ++k) A.col(k) = random.vector();
  const Mat3 axes = Eigen::HouseholderQR<Mat3>(A).householderQ();
  const double condition = std::pow(10, random.uniform(0, digits));
  const Vec3 values(1, std::pow(condition, -random.uniform(0, 1)), 1 / condition);
  const Mat3 K = axes * values.asDiagonal() * axes.transpose();
  Vec3 u = random.vector();
  u.z() = -std::abs(u.z());
  return {{0.5 * (K + K.transpose()), random.uniform(0, 1.5)}, u, random.uniform(0, 1)};
}

void measure(double digits, RestitutionLaw law, const char* name) {
  Random random;
  std::vector<double> times;
  double gain = 0, cone = 0, approach = 0;
  int unresolved = 0;
  for (int k = 0; k < count; ++k) {
    const Collision collision = random_collision(random, digits);
    const auto begin = std::chrono::steady_clock::now();
    const CollisionOutcome outcome = resolve_collision(collision, law);
    times.push_back(
        std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count());
    unresolved += !outcome.is_resolved;
    const double energy = 0.5 * collision.u.dot(collision.matrix.K.ldlt().solve(collision.u));
    gain = std::max(gain, outcome.energy_change / energy);
    const double limit = collision.matrix.mu * outcome.end.lambda.z();
    if (limit > 0) cone = std::max(cone, outcome.end.lambda.head<2>().norm() / limit - 1);
    approach = std::max(approach, -outcome.end.u.z());
  }
  std::sort(times.begin(), times.end());
  const auto at = [&](double share) { return times[static_cast<std::size_t>(share * (count - 1))]; };
  fmt::print("{:<9} 1e{:<9g} {:>8.2f} {:>8.2f} {:>8.2f} {:>8.1f} {:>11} {:>12.1e} {:>12.1e} {:>10.1e}\n",
             name, digits, at(0.5), at(0.9), at(0.999), at(1), unresolved, gain, cone, approach);
}

}  // namespace

int main() {
  fmt::print("{} random impacts each, microseconds\n", count);
  fmt::print("{:<9} {:<11} {:>8} {:>8} {:>8} {:>8} {:>11} {:>12} {:>12} {:>10}\n", "law", "condition <",
             "median", "90 %", "99.9 %", "longest", "unresolved", "energy gain", "over cone", "approach");
  for (const double digits : {1.0, 2.0, 8.0}) {
    measure(digits, RestitutionLaw::newton, "newton");
    measure(digits, RestitutionLaw::poisson, "poisson");
    measure(digits, RestitutionLaw::stronge, "stronge");
  }
  return 0;
}
