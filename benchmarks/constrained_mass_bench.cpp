// Chains of bodies: time a body of factor() and solve() by their length, and of forces on single bodies.

#include "rigor/solver/linear/constrained_mass.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <vector>

namespace {

using namespace rigor;

/// Rods of length 1 m along x, each joined to the one before by a hinge about z (5 rows); the first hangs on
/// the ground.
struct Chain {
  explicit Chain(int count) {
    graph.node_count = count;
    const Vec6 mass(Vec6::Ones() - Vec6(0, 0, 0, 0.9, 0.9, 0.9));
    masses.assign(static_cast<std::size_t>(count), mass.asDiagonal());
    for (int i = 0; i < count; ++i) {
      graph.links.push_back({5, i == 0 ? std::vector{0} : std::vector{i - 1, i}});
      if (i > 0) rows.push_back(-hinge(0.5));
      rows.push_back(hinge(-0.5));
    }
    f = VecX::Ones(6 * count);
    c = VecX::Zero(5 * count);
  }
  /// Velocity at the joint, at x from the centre, and turning about x and y.
  static Mat6 hinge(double x) {
    Mat6 J = Mat6::Zero();
    J.topLeftCorner<5, 5>().setIdentity();
    J(1, 5) = x;
    J(2, 4) = -x;
    return J;
  }

  ConstraintGraph graph;
  std::vector<Mat6> masses;
  std::vector<Mat6> rows;
  VecX f, c;
};

/// Median of the CPU time of a call, of many [s].
template <typename Call>
double median_seconds(int calls, const Call& call) {
  std::vector<double> times;
  for (int i = 0; i < 21; ++i) {
    const std::clock_t begin = std::clock();
    for (int k = 0; k < calls; ++k) call();
    times.push_back(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC / calls);
  }
  std::nth_element(times.begin(), times.begin() + 10, times.end());
  return times[10];
}

}  // namespace

int main() {
  fmt::print("Chains of hinges on the ground, nanoseconds of CPU time a body\n");
  fmt::print("{:>8} {:>10} {:>10} {:>20}\n", "bodies", "factor", "solve", "force on one body");
  for (const int count : {1, 10, 100, 1000, 10000}) {
    const Chain chain(count);
    ConstrainedMass mass(chain.graph);
    const int calls = std::max(1, 20000 / count);
    MatX force = MatX::Zero(6 * count, 1);
    force(6 * (count / 2)) = 1;
    double sum = 0;
    // What is factored already is not factored again: another mass each time.
    std::vector<Mat6> masses = chain.masses;
    const double factor = median_seconds(calls, [&] {
      masses[0](0, 0) = 3 - masses[0](0, 0);
      mass.factor(masses, chain.rows);
    });
    mass.factor(chain.masses, chain.rows);
    const double solve = median_seconds(calls, [&] { sum += mass.solve(chain.f, chain.c).a[0]; });
    const double single = median_seconds(calls, [&] { sum += mass.solve(force)(0, 0); });
    fmt::print("{:>8} {:>10.0f} {:>10.0f} {:>20.0f}\n", count, 1e9 * factor / count, 1e9 * solve / count,
               1e9 * single / count);
    if (sum != sum) return 1;
  }
  return 0;
}
