#include "rigor/math/elliptic.hpp"

#include "rigor/math/carlson.hpp"

#include <cmath>
#include <fstream>
#include <numbers>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace rigor::elliptic_test {
namespace {

constexpr double kEpsilon = 0x1p-52;

nlohmann::json reference() {
  std::ifstream file(std::string(RIGOR_TEST_DATA) + "/elliptic.json");
  return nlohmann::json::parse(file);
}

void expect_relative(double value, double expected, double tolerance, const std::string& what) {
  EXPECT_LE(std::abs(value - expected), tolerance * std::abs(expected))
      << what << ": " << value << " != " << expected;
}

TEST(Elliptic, CompleteIntegralAgreesWithReferenceDownToTinyComplements) {
  for (const nlohmann::json file = reference(); const auto& row : file["K"]) {
    expect_relative(complete_elliptic_k(row["complement"]), row["value"], 4 * kEpsilon, row.dump());
    EXPECT_EQ(JacobiFunctions(row["complement"]).quarter_period(), complete_elliptic_k(row["complement"]));
  }
  // K → ln(4/√(1 - m)) as m → 1.
  expect_relative(complete_elliptic_k(1e-300), std::log(4.0) + 150 * std::log(10.0), 4 * kEpsilon, "1e-300");
  EXPECT_TRUE(std::isinf(complete_elliptic_k(0)));
}

TEST(Elliptic, FunctionsKeepRelativeAccuracyAlsoWhereCnAndDnAreSmall) {
  for (const nlohmann::json file = reference(); const auto& row : file["jacobi"]) {
    const double complement = row["complement"], u = row["u"];
    const JacobiFunctions functions(complement);
    const JacobiValues values = functions.at(u);
    // One rounding of u moves cn by sn dn u ε; near K that is relative to the distance from K.
    const double K = functions.quarter_period();
    const double conditioning = kEpsilon * (8 + 2 * u + 2 * u / (K - u));
    expect_relative(values.sn, row["sn"], 8 * kEpsilon, row.dump());
    expect_relative(values.cn, row["cn"], conditioning, row.dump());
    expect_relative(values.dn, row["dn"], conditioning, row.dump());
  }
}

TEST(Elliptic, FunctionsAreOddEvenAndPeriodic) {
  const JacobiFunctions functions(0.3);
  const double K = functions.quarter_period();
  for (const double u : {0.1, 0.7, 1.3, 1.9}) {
    const JacobiValues at = functions.at(u), mirrored = functions.at(-u), shifted = functions.at(u + 2 * K);
    EXPECT_EQ(mirrored.sn, -at.sn);
    EXPECT_EQ(mirrored.cn, at.cn);
    EXPECT_EQ(mirrored.dn, at.dn);
    // The shift itself rounds.
    EXPECT_NEAR(shifted.sn, -at.sn, 8 * kEpsilon);
    EXPECT_NEAR(shifted.cn, -at.cn, 8 * kEpsilon);
    EXPECT_NEAR(shifted.dn, at.dn, 8 * kEpsilon);
    EXPECT_NEAR(functions.at(u + 40 * K).cn, at.cn, 200 * kEpsilon);
  }
}

TEST(Elliptic, LimitsAreTrigonometricAndHyperbolic) {
  for (const double u : {-3.0, -0.5, 0.0, 1e-9, 0.4, 2.0, 30.0, 800.0}) {
    const JacobiValues circle = JacobiFunctions(1).at(u);
    EXPECT_NEAR(circle.sn, std::sin(u), 2 * kEpsilon * (1 + std::abs(u)));
    EXPECT_NEAR(circle.cn, std::cos(u), 2 * kEpsilon * (1 + std::abs(u)));
    EXPECT_EQ(circle.dn, 1);
    const JacobiValues separatrix = JacobiFunctions(0).at(u);
    EXPECT_EQ(separatrix.sn, std::tanh(u));
    EXPECT_EQ(separatrix.cn, 1 / std::cosh(u));
    EXPECT_EQ(separatrix.dn, separatrix.cn);
  }
}

TEST(Elliptic, DerivativeOfSnIsCnDn) {
  // Central difference with h = 1e-5: error h²/6 |sn'''| + ε/h.
  const JacobiFunctions functions(1e-3);
  for (const double u : {0.2, 1.0, 3.0, 4.5}) {
    const double h = 1e-5;
    const double slope = (functions.at(u + h).sn - functions.at(u - h).sn) / (2 * h);
    EXPECT_NEAR(slope, functions.at(u).cn * functions.at(u).dn, 3e-10);
  }
}

TEST(Elliptic, AmplitudeIsContinuousAndInvertsTheFirstIntegral) {
  const JacobiFunctions functions(0.2);
  const double K = functions.quarter_period();
  EXPECT_NEAR(functions.amplitude(K), 0.5 * std::numbers::pi, 2 * kEpsilon);
  EXPECT_NEAR(functions.amplitude(6 * K), 3 * std::numbers::pi, 16 * kEpsilon);
  for (const double u : {-1.0, 0.3, 1.1}) {
    const double phi = functions.amplitude(u), c = std::cos(phi), s = std::sin(phi);
    // F(φ) = s R_F(c², 1 - m s², 1).
    EXPECT_NEAR(s * carlson_rf(c * c, c * c + 0.2 * s * s, 1), u, 8 * kEpsilon);
  }
  // Gudermann: am(u, 1) = atan sinh u.
  EXPECT_NEAR(JacobiFunctions(0).amplitude(1.5), std::atan(std::sinh(1.5)), 4 * kEpsilon);
}

TEST(Carlson, IntegralsAgreeWithReference) {
  for (const nlohmann::json file = reference(); const auto& row : file["rf"]) {
    const auto& x = row["x"];
    expect_relative(carlson_rf(x[0], x[1], x[2]), row["value"], 4 * kEpsilon, row.dump());
  }
  for (const nlohmann::json file = reference(); const auto& row : file["rj"]) {
    const auto& x = row["x"];
    expect_relative(carlson_rj(x[0], x[1], x[2], x[3]), row["value"], 16 * kEpsilon, row.dump());
  }
}

TEST(Carlson, IntegralsAreHomogeneousBitForBitInPowersOfFour) {
  // R_F(4x) = R_F(x)/2, R_J(4x) = R_J(x)/8.
  EXPECT_EQ(carlson_rf(4 * 0.3, 4 * 0.7, 4 * 1.9), carlson_rf(0.3, 0.7, 1.9) / 2);
  EXPECT_EQ(carlson_rj(4 * 0.3, 4 * 0.7, 4 * 1.9, 4 * 0.1), carlson_rj(0.3, 0.7, 1.9, 0.1) / 8);
}

}  // namespace
}  // namespace rigor::elliptic_test
