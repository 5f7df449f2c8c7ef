#include "rigor/study/plan/parameter_values.hpp"
#include "rigor/study/sampling/counter_random.hpp"
#include "rigor/study/sampling/even_points.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <vector>

namespace rigor::sampling_test {
namespace {

TEST(CounterRandom, IsPhilox4x32Of10Rounds) {
  // Known answers of Random123 (kat_vectors), the authors' own.
  using Words = std::array<std::uint32_t, 4>;
  EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}), (Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(philox({0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}, {0xffffffff, 0xffffffff}),
            (Words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (Words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(Sobol, HasTheFirstPointsOfJoeAndKuo) {
  // The first ten points in three dimensions, from the authors' page on new-joe-kuo-6.
  const std::vector<std::array<double, 3>> published = {{0, 0, 0},
                                                        {0.5, 0.5, 0.5},
                                                        {0.75, 0.25, 0.25},
                                                        {0.25, 0.75, 0.75},
                                                        {0.375, 0.375, 0.625},
                                                        {0.875, 0.875, 0.125},
                                                        {0.625, 0.125, 0.875},
                                                        {0.125, 0.625, 0.375},
                                                        {0.1875, 0.3125, 0.9375},
                                                        {0.6875, 0.8125, 0.4375}};
  for (std::size_t i = 0; i < published.size(); ++i) {
    const std::vector<double> point = sobol_point(i, 3);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(point[k], published[i][k]) << "point " << i << ", " << k;
  }
}

TEST(Sobol, FillsEveryDyadicIntervalOnceInAllDimensions) {
  constexpr int dimensions = 300, count = 64;
  std::vector<std::set<int>> seen(dimensions);
  for (int i = 0; i < count; ++i) {
    const std::vector<double> point = sobol_point(static_cast<std::uint64_t>(i), dimensions);
    for (std::size_t k = 0; k < seen.size(); ++k) seen[k].insert(static_cast<int>(point[k] * count));
  }
  for (const std::set<int>& intervals : seen) EXPECT_EQ(intervals.size(), 64u);
}

TEST(Hypercube, HasOnePointInEachStratum) {
  for (const std::uint64_t count : {1u, 2u, 7u, 100u, 1000u}) {
    std::vector<std::set<std::uint64_t>> strata(5);
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::vector<double> point = hypercube_point(i, 5, {count, 3});
      for (std::size_t k = 0; k < 5; ++k)
        strata[k].insert(static_cast<std::uint64_t>(point[k] * static_cast<double>(count)));
    }
    for (const std::set<std::uint64_t>& filled : strata) EXPECT_EQ(filled.size(), count);
  }
}

TEST(Permutation, DiffersByItsKey) {
  std::vector<std::uint64_t> a, b;
  for (std::uint64_t i = 0; i < 50; ++i) a.push_back(permuted(i, 50, 1)), b.push_back(permuted(i, 50, 2));
  EXPECT_NE(a, b);
}

TEST(UniformRotation, HasTheMomentsOfSO3) {
  // Under the uniform measure each element of R has mean 0 and mean square 1/3.
  constexpr int n = 40000;
  double sum = 0, squares = 0;
  for (int i = 0; i < n; ++i) {
    const auto u = [&](std::uint32_t k) {
      return random_uniform(5, RandomStream::coordinates, {static_cast<std::uint64_t>(i), k});
    };
    const std::array<double, 4> q = uniform_rotation(u(0), u(1), u(2));
    const double norm = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
    EXPECT_NEAR(norm, 1, 1e-14);
    const double R_zz = 1 - 2 * (q[1] * q[1] + q[2] * q[2]);
    sum += R_zz, squares += R_zz * R_zz;
  }
  // Four standard errors: of R_zz, uniform in [-1, 1], and of its square.
  EXPECT_NEAR(sum / n, 0, 4 * std::sqrt(1.0 / 3 / n));
  EXPECT_NEAR(squares / n, 1.0 / 3, 4 * std::sqrt(4.0 / 45 / n));
}

}  // namespace
}  // namespace rigor::sampling_test
