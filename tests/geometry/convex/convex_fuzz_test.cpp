#include "fuzz/convex_pair.hpp"
#include "rigor/geometry/distance/distance.hpp"

#include <gtest/gtest.h>

#include <random>

namespace rigor::convex_fuzz_test {
namespace {

TEST(ConvexFuzz, ThousandsOfHostilePairsKeepTheirPromises) {
  std::mt19937_64 engine(1);
  for (int i = 0; i < 2000; ++i) {
    std::vector<std::uint8_t> bytes(160);
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(engine() >> 56);
    EXPECT_EQ(test::fault_of_bytes(bytes), "") << "input " << i;
  }
}

TEST(ConvexFuzz, EndsOfTheBytesAreZeros) {
  for (std::size_t length = 0; length < 40; ++length) {
    const std::vector<std::uint8_t> bytes(length, 0x91);
    EXPECT_EQ(test::fault_of_bytes(bytes), "") << length;
  }
}

TEST(ConvexFuzz, AWrongNormalWouldBeSeen) {
  // The check itself: boxes at an angle are not apart along a direction that is off by a hundredth.
  const Box box{Vec3::Constant(0.5)};
  const Pose X{rotation_matrix(rotation_exp(Vec3(0.3, 0.2, 0.1))), Vec3(2, 0.1, 0.2)};
  const DistanceResult r = signed_distance(box, {}, box, X);
  const Vec3 off = (r.n_W + 0.01 * r.n_W.unitOrthogonal()).normalized();
  EXPECT_LT(test::separation_along(off, box, {}, box, X), r.distance - 1e-5);
}

}  // namespace
}  // namespace rigor::convex_fuzz_test
