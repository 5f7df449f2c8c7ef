#include "rigor/contact/impact/slip_flow.hpp"

#include "random_vectors.hpp"
#include "solver/reference_data.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace rigor::slip_flow_test {
namespace {

using test::Random;

Vec2 direction(double theta) {
  return {std::cos(theta), std::sin(theta)};
}

Mat3 random_matrix(Random& random) {
  Mat3 A;
  for (int k = 0; k < 9; ++k) A(k / 3, k % 3) = random.number();
  return A * A.transpose() + 1e-3 * Mat3::Identity();
}

TEST(SlipFlow, FindsTheInvariantDirectionsOfTheReference) {
  for (const nlohmann::json& json : reference::read("invariant_directions.json")["cases"]) {
    SCOPED_TRACE(json["id"].get<std::string>());
    const CollisionMatrix collision{reference::matrix(json["K"]), json["mu"].get<double>()};
    const SlipFlow flow(collision);
    const std::vector<InvariantDirection> found = find_invariant_directions(flow);
    const nlohmann::json& expected = json["directions"];
    const StickTest sticking = test_sticking(collision);
    EXPECT_NEAR(sticking.ratio, json["stick_ratio"].get<double>(), 1e-13 * (1 + sticking.ratio));
    EXPECT_EQ(sticking.is_stable, json["stable"].get<bool>());
    // A sphere: every direction is invariant, and none is found.
    if (flow.b.isZero(0) && flow.M(0, 0) == flow.M(1, 1)) {
      EXPECT_TRUE(found.empty());
      continue;
    }
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
      EXPECT_NEAR(found[k].theta, expected[k]["theta"].get<double>(), 1e-13);
      EXPECT_NEAR(found[k].radial_rate, expected[k]["radial_rate"].get<double>(), 1e-13 * flow.rate_bound());
      EXPECT_NEAR(found[k].normal_rate, expected[k]["normal_rate"].get<double>(), 1e-13 * flow.kappa);
    }
  }
}

TEST(SlipFlow, HasOneDivergingDirectionExactlyWhereStickingIsUnstable) {
  Random random(3);
  int unstable = 0;
  for (int k = 0; k < 2000; ++k) {
    const CollisionMatrix collision{random_matrix(random), std::pow(10, random.uniform(-2, 1))};
    const SlipFlow flow(collision);
    int diverging = 0;
    double theta = 0;
    for (const InvariantDirection& found : find_invariant_directions(flow)) {
      if (found.radial_rate > 0) ++diverging, theta = found.theta;
    }
    const StickTest sticking = test_sticking(collision);
    EXPECT_EQ(diverging, sticking.is_stable ? 0 : 1);
    if (sticking.is_stable) continue;
    ++unstable;
    const Vec2 ray = diverging_direction(flow);
    EXPECT_NEAR(std::abs(flow.angular_rate(ray)), 0, 1e-13 * flow.rate_bound());
    // A root that others nearly meet is known to the root of rounding.
    EXPECT_LT((ray - direction(theta)).norm(), 1e-6);
    // It leads out of contact: du_n/dp > μ λ.
    EXPECT_GT(flow.normal_rate(ray), flow.mu * flow.radial_rate(ray));
  }
  EXPECT_GT(unstable, 100);
}

TEST(SlipFlow, RatesAreThoseOfTheImpulses) {
  Random random(4);
  for (int k = 0; k < 100; ++k) {
    const CollisionMatrix collision{random_matrix(random), random.uniform(0, 2)};
    const SlipFlow flow(collision);
    const Vec2 d = direction(random.uniform(-3, 3));
    const Vec3 u_rate = collision.K * Vec3(-collision.mu * d.x(), -collision.mu * d.y(), 1);
    EXPECT_LT((flow.slip_rate(d) - u_rate.head<2>()).norm(), 1e-14 * flow.rate_bound());
    EXPECT_NEAR(flow.normal_rate(d), u_rate.z(), 1e-14 * flow.kappa * (1 + flow.mu));
    EXPECT_LE(flow.slip_rate(d).norm(), flow.rate_bound());
  }
}

TEST(SlipFlow, JamsForARodFromTheFrictionOfPainleveOn) {
  // Thin rod of mass 1 and length 2 l at the angle θ to the floor: K = [1 + 3 sin², 3 sin cos; ., 1 + 3
  // cos²]; the tip that slides into the lean is pressed down for μ > (1 + 3 cos² θ)/(3 sin θ cos θ), at least
  // 4/3 (tan θ = 2).
  const auto rate = [](double theta, double mu) {
    const double c = std::cos(theta), s = std::sin(theta);
    Mat3 K;
    K << 1 + 3 * s * s, 0, 3 * s * c, 0, 1, 0, 3 * s * c, 0, 1 + 3 * c * c;
    return SlipFlow({K, mu}).normal_rate(Vec2(1, 0));
  };
  EXPECT_NEAR(rate(M_PI / 4, 5.0 / 3), 0, 1e-15);
  EXPECT_LT(rate(M_PI / 4, 2), 0);
  const double least = std::atan(2);
  EXPECT_NEAR(rate(least, 4.0 / 3), 0, 1e-15);
  for (double theta = 0.05; theta < 1.5; theta += 0.05) EXPECT_GT(rate(theta, 4.0 / 3 - 1e-9), 0);
}

TEST(SlipFlow, StickingFrictionKeepsTheSlipAtZero) {
  Random random(6);
  for (int k = 0; k < 500; ++k) {
    const CollisionMatrix collision{random_matrix(random), 1};
    const StickTest sticking = test_sticking(collision);
    const Vec3 u_rate = collision.K * Vec3(sticking.friction.x(), sticking.friction.y(), 1);
    EXPECT_LT(u_rate.head<2>().norm(), 1e-14 * collision.K.norm() * (1 + sticking.friction.norm()));
    EXPECT_NEAR(sticking.normal_rate, 1 / collision.K.inverse()(2, 2), 1e-9 * collision.K(2, 2));
  }
}

}  // namespace
}  // namespace rigor::slip_flow_test
