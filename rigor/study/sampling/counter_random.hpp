#pragma once

#include <array>
#include <cstdint>

namespace rigor {

/// Random bits as a function of a counter and a key: run number 7 has the same ones whichever thread or
/// machine carries it out, and in whatever order. This is Philox4x32 with 10 rounds.
///
/// Source: Salmon, Moraes, Dror and Shaw, Parallel Random Numbers: As Easy as 1, 2, 3, SC11, 2011.
std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key);

/// What random numbers are drawn for; streams of one seed are independent of each other.
enum class RandomStream : std::uint32_t { coordinates, strata, shift, seeds, bootstrap, trajectories };

/// Number of a draw: which run (or cell, or replicate), and which coordinate of it.
struct DrawIndex {
  std::uint64_t run;
  std::uint32_t coordinate = 0;
};

/// 64 random bits of the seed and the stream.
std::uint64_t random_bits(std::uint64_t seed, RandomStream stream, DrawIndex index);
/// Uniform in (0, 1): an odd multiple of 2⁻⁵³.
double random_uniform(std::uint64_t seed, RandomStream stream, DrawIndex index);

}  // namespace rigor
