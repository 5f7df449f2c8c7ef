#pragma once

#include <cstdint>
#include <vector>

namespace rigor {

/// Point number `index` of Sobol's sequence: `dimensions` numbers in [0, 1), multiples of 2⁻⁵³ at the
/// finest. The first point (index 0) is the origin. At most most_sobol_dimensions().
///
/// Source: Joe and Kuo, Constructing Sobol sequences with better two-dimensional projections, SIAM J. Sci.
/// Comput. 30, 2008; their numbers (new-joe-kuo-6.21201) are those of Boost.Random.
std::vector<double> sobol_point(std::uint64_t index, int dimensions);
int most_sobol_dimensions();

/// The same with a random shift modulo 1 in each dimension, that of the replicate: the points of one
/// replicate are as even as before, and different replicates are independent.
///
/// Source: Cranley and Patterson, Randomization of number theoretic methods for multiple integration, SIAM J.
/// Numer. Anal. 13, 1976.
std::vector<double> shifted_sobol_point(std::uint64_t index, int dimensions, std::uint64_t seed,
                                        std::uint64_t replicate);

/// Point number `index` of a Latin hypercube of `count` points: in each dimension every interval of width
/// 1/count holds exactly one of them. index < count.
///
/// Source: McKay, Beckman and Conover, A comparison of three methods for selecting values of input variables
/// in the analysis of output from a computer code, Technometrics 21, 1979.
struct HypercubeOf {
  std::uint64_t count, seed;
  std::uint64_t replicate = 0;  ///< Different ones are independent.
};
std::vector<double> hypercube_point(std::uint64_t index, int dimensions, const HypercubeOf& cube);

/// Where `index` goes under a random permutation of 0 ... count - 1, one for each key; no list of them is
/// kept.
std::uint64_t permuted(std::uint64_t index, std::uint64_t count, std::uint64_t key);

}  // namespace rigor
