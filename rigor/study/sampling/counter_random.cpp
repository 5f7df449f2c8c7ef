#include "rigor/study/sampling/counter_random.hpp"

namespace rigor {

std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key) {
  constexpr int rounds = 10;
  // Multipliers and the Weyl sequences of the key, from the paper.
  constexpr std::uint64_t m0 = 0xD2511F53u, m1 = 0xCD9E8D57u;
  constexpr std::uint32_t w0 = 0x9E3779B9u, w1 = 0xBB67AE85u;
  for (int round = 0; round < rounds; ++round) {
    const std::uint64_t a = m0 * counter[0], b = m1 * counter[2];
    counter = {static_cast<std::uint32_t>(b >> 32) ^ counter[1] ^ key[0], static_cast<std::uint32_t>(b),
               static_cast<std::uint32_t>(a >> 32) ^ counter[3] ^ key[1], static_cast<std::uint32_t>(a)};
    key[0] += w0;
    key[1] += w1;
  }
  return counter;
}

std::uint64_t random_bits(std::uint64_t seed, RandomStream stream, DrawIndex index) {
  const auto low = [](std::uint64_t word) { return static_cast<std::uint32_t>(word); };
  const auto high = [](std::uint64_t word) { return static_cast<std::uint32_t>(word >> 32); };
  const std::array<std::uint32_t, 4> words =
      philox({low(index.run), high(index.run), index.coordinate, static_cast<std::uint32_t>(stream)},
             {low(seed), high(seed)});
  return (static_cast<std::uint64_t>(words[0]) << 32) | words[1];
}

double random_uniform(std::uint64_t seed, RandomStream stream, DrawIndex index) {
  return (static_cast<double>(random_bits(seed, stream, index) >> 12) + 0.5) * 0x1p-52;
}

}  // namespace rigor
