// Inertia that is raised where joints pull light bodies taut.

#include "rigor/bulk/joints/taut_links.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <tuple>
#include <vector>

namespace rigor::taut_links_test {
namespace {

float uniform(std::mt19937& random, float low, float high) {
  return low + (high - low) * static_cast<float>(random() >> 8) / static_cast<float>(1 << 24);
}

FloatVec3 lanes_of(const Vec3& a) {
  return {float_lanes(static_cast<float>(a.x())), float_lanes(static_cast<float>(a.y())),
          float_lanes(static_cast<float>(a.z()))};
}
FloatSym3 lanes_of(const Mat3& A) {
  const auto lanes = [&](int i, int j) { return float_lanes(static_cast<float>(A(i, j))); };
  return {lanes(0, 0), lanes(1, 1), lanes(2, 2), lanes(0, 1), lanes(0, 2), lanes(1, 2)};
}
Vec3 first_of(const FloatVec3& a) {
  return Vec3(a.x[0], a.y[0], a.z[0]);
}
Mat3 first_of(const FloatSym3& A) {
  Mat3 M;
  M << A.xx[0], A.xy[0], A.xz[0], A.xy[0], A.yy[0], A.yz[0], A.xz[0], A.yz[0], A.zz[0];
  return M;
}

Vec3 random_vector(std::mt19937& random, float size) {
  return size * Vec3(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1));
}

/// A body with random principal axes and moments between 1 and `spread` times `least`.
TautBody random_body(std::mt19937& random, double least, double spread) {
  const Mat3 R = Eigen::Quaterniond(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1),
                                    uniform(random, -1, 1))
                     .normalized()
                     .toRotationMatrix();
  const Vec3 moments = least * Vec3(1, 1 + (spread - 1) * uniform(random, 0, 1), spread);
  TautBody body{};
  body.w = lanes_of(random_vector(random, 10));
  body.inverse_inertia = lanes_of(Mat3(R * moments.cwiseInverse().asDiagonal() * R.transpose()));
  return body;
}

/// Greatest eigenvalue of h² (I + S)⁻¹ K: the square of h ω of the fastest vibration of the body alone.
double fastest(double h, const TautBody& body, const Mat3& K) {
  const Mat3 raised = first_of(body.inverse_inertia).inverse() + first_of(body.stiffening);
  return h * h * (raised.inverse() * K).eigenvalues().real().maxCoeff();
}

TEST(TautLinks, NothingVibratesFasterThanStepsCanFollow) {
  std::mt19937 random(1);
  for (int k = 0; k < 200; ++k) {
    const double h = std::pow(10, uniform(random, -4, -2)), least = std::pow(10, uniform(random, -9, 1));
    std::vector<TautBody> bodies{random_body(random, least, std::pow(10, uniform(random, 0, 2))), TautBody{}};
    // Two anchors of a body at opposite arms, pulled along them.
    std::vector<TautLink> links;
    Mat3 K = Mat3::Zero();
    const Vec3 arm = random_vector(random, 1);
    for (const double side : {1.0, -1.0}) {
      const double pull = std::pow(10, uniform(random, -3, 6)) * least / (h * h);
      const Vec3 r = side * arm, f = pull * arm.normalized() * side / arm.norm();
      links.push_back({0, 1, lanes_of(Vec3(h * f)), lanes_of(r), lanes_of(Vec3(Vec3::Zero()))});
      K += f.dot(r) * Mat3::Identity() - f * r.transpose();
    }
    const double before = fastest(h, bodies[0], K);
    stiffen(static_cast<float>(h), links, bodies);
    // Steps are stable below 4; with the raised inertia (h ω)² is x / (1 + (1 - 1/x) x) = 1 at most.
    EXPECT_LE(fastest(h, bodies[0], K), 1 + 1e-3) << before;
    // What is slow keeps its inertia.
    if (before < 0.3) {
      EXPECT_EQ(bodies[0].share[0], 0);
      EXPECT_EQ(first_of(bodies[0].stiffening).norm(), 0);
    }
  }
}

TEST(TautLinks, SlackIsNeverTaut) {
  std::mt19937 random(2);
  for (int k = 0; k < 200; ++k) {
    const double least = std::pow(10, uniform(random, -6, 1)), h = 2e-3;
    std::vector<TautBody> bodies{random_body(random, least, 10), TautBody{}};
    const Vec3 moments =
        first_of(bodies[0].inverse_inertia).inverse().selfadjointView<Eigen::Lower>().eigenvalues();
    const int joints = 1 + k % 5;
    std::vector<TautLink> links;
    for (int j = 0; j < joints; ++j) {
      const Vec3 arm = random_vector(random, 1);
      Slack slack;
      slack.add_body(moments, joints, arm);
      // As much as the joint can carry without a body that is taut.
      const Vec3 impulse = 0.999 * std::sqrt(slack.squared) / h * arm.normalized();
      links.push_back({0, 1, lanes_of(impulse), lanes_of(arm), lanes_of(Vec3(Vec3::Zero()))});
    }
    stiffen(static_cast<float>(h), links, bodies);
    EXPECT_EQ(bodies[0].share[0], 0) << k;
  }
}

TEST(TautLinks, CalmingKeepsAngularMomentumAndTakesEnergy) {
  std::mt19937 random(3);
  for (int k = 0; k < 100; ++k) {
    // A chain of four, of very different bodies.
    std::vector<TautBody> bodies;
    std::vector<TautLink> links;
    for (int i = 0; i < 4; ++i) {
      bodies.push_back(random_body(random, std::pow(10, uniform(random, -4, 1)), 30));
      bodies.back().share = float_lanes(uniform(random, 0, 1));
      if (i > 0)
        links.push_back({i, i - 1, lanes_of(Vec3(Vec3::Zero())), lanes_of(Vec3(Vec3::Zero())),
                         lanes_of(Vec3(Vec3::Zero()))});
    }
    const auto sums = [&] {
      Vec3 L = Vec3::Zero();
      double energy = 0, size = 0;
      for (const TautBody& body : bodies) {
        const Vec3 w = first_of(body.w), own = first_of(body.inverse_inertia).inverse() * w;
        L += own;
        energy += 0.5 * w.dot(own);
        size += own.norm();
      }
      return std::tuple(L, energy, size);
    };
    const auto [L, energy, size] = sums();
    calm(links, bodies);
    const auto [L_after, energy_after, size_after] = sums();
    EXPECT_LE((L_after - L).norm(), 1e-4 * size);  // 32 bits, moments 30 to 1.
    EXPECT_LT(energy_after, energy * (1 + 1e-5));
  }
}

}  // namespace
}  // namespace rigor::taut_links_test
