#include "rigor/study/sampling/even_points.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/study/sampling/counter_random.hpp"

#include <boost/random/sobol.hpp>

#include <bit>
#include <cmath>

namespace rigor {

int most_sobol_dimensions() {
  return static_cast<int>(boost::random::default_sobol_table::max_dimension);
}

std::vector<double> sobol_point(std::uint64_t index, int dimensions) {
  RIGOR_ASSERT(dimensions >= 1 && dimensions <= most_sobol_dimensions());
  std::vector<double> point(at(dimensions), 0.0);
  // Boost's sequence begins after the origin.
  if (index == 0) return point;
  boost::random::sobol sequence(static_cast<std::size_t>(dimensions));
  sequence.seed(index - 1);
  for (double& x : point) x = static_cast<double>(sequence() >> 11) * 0x1p-53;
  return point;
}

std::vector<double> shifted_sobol_point(std::uint64_t index, int dimensions, std::uint64_t seed,
                                        std::uint64_t replicate) {
  std::vector<double> point = sobol_point(index, dimensions);
  for (std::size_t k = 0; k < point.size(); ++k) {
    point[k] += random_uniform(seed, RandomStream::shift, {replicate, static_cast<std::uint32_t>(k)});
    point[k] -= std::floor(point[k]);
  }
  return point;
}

std::uint64_t permuted(std::uint64_t index, std::uint64_t count, std::uint64_t key) {
  RIGOR_ASSERT(index < count);
  constexpr int rounds = 6;
  // A Feistel network permutes the numbers of 2 h bits; those beyond the count are sent through it again
  // until they fall below (Black and Rogaway, Ciphers with arbitrary finite domains, CT-RSA 2002).
  const int half = (std::max(2, static_cast<int>(std::bit_width(count - 1))) + 1) / 2;
  const std::uint64_t mask = (std::uint64_t{1} << half) - 1;
  std::uint64_t value = index;
  do {
    std::uint64_t left = value >> half, right = value & mask;
    for (std::uint32_t round = 0; round < rounds; ++round) {
      const std::uint64_t mixed = left ^ (random_bits(key, RandomStream::strata, {right, round}) & mask);
      left = right;
      right = mixed;
    }
    value = (left << half) | right;
  } while (value >= count);
  return value;
}

std::vector<double> hypercube_point(std::uint64_t index, int dimensions, const HypercubeOf& cube) {
  std::vector<double> point;
  for (int k = 0; k < dimensions; ++k) {
    const std::uint32_t coordinate = static_cast<std::uint32_t>(k);
    const std::uint64_t key =
        random_bits(cube.seed, RandomStream::strata, {cube.replicate, 1000 + coordinate});
    const std::uint64_t stratum = permuted(index, cube.count, key);
    const double inside = random_uniform(cube.seed, RandomStream::coordinates,
                                         {cube.replicate * cube.count + index, coordinate});
    const double x = (static_cast<double>(stratum) + inside) / static_cast<double>(cube.count);
    point.push_back(std::min(x, std::nextafter(1.0, 0.0)));
  }
  return point;
}

}  // namespace rigor
