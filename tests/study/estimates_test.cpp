#include "studies.hpp"

#include "rigor/study/kinds/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace rigor::estimates_test {
namespace {

using studies::finding_of;
using studies::finished;

std::string monte_carlo(int seed, const std::string& more, const std::string& formula) {
  return "rigor_study: 1\nkind: monte-carlo\nseed: " + std::to_string(seed) + "\n" + more +
         "parameters:\n  - {name: x, range: [0, 1]}\noutcomes:\n  - {name: y, formula: \"" + formula +
         "\"}\n";
}

/// How many of 200 seeds have an interval that holds the truth.
int covered(const std::string& more, const std::string& formula, double truth) {
  int count = 0;
  for (int seed = 1; seed <= 200; ++seed) {
    const Finding y = finding_of(*finished(monte_carlo(seed, more, formula)), "y");
    if (*y.low <= truth && truth <= *y.high) ++count;
  }
  return count;
}

// 190 of 200 are expected, with a standard deviation of 3.1: four of them are 177 to 200.
TEST(MonteCarlo, IntervalsOfAMeanHoldTheTruthAsOftenAsTheySay) {
  const int count = covered("runs: 100\n", "x", 0.5);
  EXPECT_GE(count, 177);
  EXPECT_LT(count, 200);
}

TEST(MonteCarlo, IntervalsOfAShareHoldTheTruthAsOftenAsTheySay) {
  EXPECT_GE(covered("runs: 100\n", "x < 0.1", 0.1), 177);
}

TEST(MonteCarlo, IntervalsOfEvenPointsHoldTheTruthAndAreNarrower) {
  EXPECT_GE(covered("runs: 128\nsampling: sobol\n", "exp(x)", std::numbers::e - 1), 177);
  EXPECT_GE(covered("runs: 128\nsampling: latin-hypercube\n", "exp(x)", std::numbers::e - 1), 177);
  const Finding random = finding_of(*finished(monte_carlo(1, "runs: 1024\n", "exp(x)")), "y");
  const Finding even = finding_of(*finished(monte_carlo(1, "runs: 1024\nsampling: sobol\n", "exp(x)")), "y");
  // The error of even points falls as 1/n: 64 of them, 16 times, are worth far more than 1024 others.
  EXPECT_LT(*even.high - *even.low, 0.25 * (*random.high - *random.low));
}

TEST(MonteCarlo, EndsWhenItsIntervalIsNarrow) {
  const auto study = finished(monte_carlo(1, "runs: 100000\nhalf_width: 0.01\n", "x"));
  const Finding y = finding_of(*study, "y");
  EXPECT_LE(0.5 * (*y.high - *y.low), 0.01);
  // (1.96 / 0.01)² / 12 = 3201 runs are needed; the rule is asked after every fifth more.
  EXPECT_GT(study->run_count(), 2800u);
  EXPECT_LT(study->run_count(), 4200u);
}

TEST(MonteCarlo, DrawsNormalNumbers) {
  const auto study = finished(
      "rigor_study: 1\nkind: monte-carlo\nruns: 16384\nsampling: sobol\nparameters:\n"
      "  - {name: n, distribution: normal, mean: 2, deviation: 3}\n"
      "  - {name: l, distribution: lognormal, deviation: 0.5}\n"
      "outcomes:\n  - {name: mean, formula: n}\n  - {name: square, formula: (n - 2)^2}\n  - {name: log, "
      "formula: l}\n");
  EXPECT_NEAR(finding_of(*study, "mean").value, 2, 0.01);
  EXPECT_NEAR(finding_of(*study, "square").value, 9, 0.05);
  EXPECT_NEAR(finding_of(*study, "log").value, std::exp(0.125), 0.003);
}

// Ishigami's function with a = 7, b = 0.1: closed forms of Saltelli et al., Global Sensitivity Analysis,
// 2008.
TEST(Sensitivity, FindsTheIndicesOfIshigamisFunction) {
  const auto study = finished(
      "rigor_study: 1\nkind: sensitivity\nruns: 4096\nparameters:\n"
      "  - {name: x1, range: [-3.141592653589793, 3.141592653589793]}\n"
      "  - {name: x2, range: [-3.141592653589793, 3.141592653589793]}\n"
      "  - {name: x3, range: [-3.141592653589793, 3.141592653589793]}\n"
      "outcomes:\n  - {name: y, formula: \"sin(x1) + 7*sin(x2)^2 + 0.1*x3^4*sin(x1)\"}\n");
  const double pi4 = std::pow(std::numbers::pi, 4), a = 7, b = 0.1;
  const double v1 = 0.5 * std::pow(1 + b * pi4 / 5, 2), v2 = a * a / 8, v13 = b * b * pi4 * pi4 * 8 / 225;
  const double v = v1 + v2 + v13;
  const auto holds = [&](const std::string& name, double truth) {
    const Finding found = finding_of(*study, name);
    EXPECT_NEAR(found.value, truth, 0.02) << name;
    EXPECT_LE(*found.low - 0.005, truth) << name;
    EXPECT_GE(*found.high + 0.005, truth) << name;
  };
  holds("y.first.x1", v1 / v);
  holds("y.first.x2", v2 / v);
  holds("y.first.x3", 0);
  holds("y.total.x1", (v1 + v13) / v);
  holds("y.total.x2", v2 / v);
  holds("y.total.x3", v13 / v);
}

TEST(Morris, FindsTheSlopesOfALinearFunction) {
  const auto study = finished(
      "rigor_study: 1\nkind: morris\nruns: 20\nparameters:\n  - {name: a, range: [0, 1]}\n  - {name: b, "
      "range: [0, 2]}\n"
      "  - {name: c, range: [0, 1]}\noutcomes:\n  - {name: y, formula: 3*a - 5*b + a*c}\n");
  // Over the unit cube the slope of b is -10; c acts by a, so its effects differ.
  EXPECT_NEAR(finding_of(*study, "y.size.b").value, 10, 1e-12);
  EXPECT_NEAR(finding_of(*study, "y.deviation.b").value, 0, 1e-12);
  EXPECT_GT(finding_of(*study, "y.deviation.c").value, 0.1);
}

TEST(Bisection, FindsAThresholdInEachCell) {
  const auto study = finished(
      "rigor_study: 1\nkind: bisection\nsearch: x\ncondition: y > 0\ntolerance: 1e-9\nparameters:\n"
      "  - {name: c, values: [2, 3]}\n  - {name: x, range: [0, 4]}\noutcomes:\n  - {name: y, formula: x^2 - "
      "c}\n");
  EXPECT_NEAR(finding_of(*study, "threshold[0]").value, std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(finding_of(*study, "threshold[1]").value, std::sqrt(3.0), 1e-9);
}

TEST(Bisection, SaysThatThereIsNoThreshold) {
  const auto study = finished(
      "rigor_study: 1\nkind: bisection\nsearch: x\ncondition: y > 0\nparameters:\n"
      "  - {name: x, range: [0, 4]}\noutcomes:\n  - {name: y, formula: x + 1}\n");
  EXPECT_TRUE(std::isnan(finding_of(*study, "threshold").value));
  ASSERT_EQ(study->answer().warnings.size(), 1u);
}

TEST(Optimum, FindsTheMinimumOfRosenbrocksValley) {
  const auto study = finished(
      "rigor_study: 1\nkind: minimise\nruns: 3000\ntolerance: 1e-7\nstarts: 3\nparameters:\n"
      "  - {name: x, range: [-2, 2]}\n  - {name: y, range: [-1, 3]}\n"
      "outcomes:\n  - {name: f, formula: \"(1 - x)^2 + 100*(y - x^2)^2\"}\n");
  EXPECT_NEAR(finding_of(*study, "x").value, 1, 1e-3);
  EXPECT_NEAR(finding_of(*study, "y").value, 1, 2e-3);
  const auto largest = finished(
      "rigor_study: 1\nkind: maximise\nruns: 300\ntolerance: 1e-6\nparameters:\n  - {name: x, range: [0, "
      "3]}\n"
      "outcomes:\n  - {name: f, formula: sin(x)}\n");
  EXPECT_NEAR(finding_of(*largest, "x").value, std::numbers::pi / 2, 1e-4);
}

TEST(Sweep, KnowsTheExtremesOfTheMeansAndHidesNoRunWithoutANumber) {
  const auto extremes = [](const std::string& values) {
    const auto study = finished("rigor_study: 1\nkind: sweep\nparameters: [{name: x, values: " + values +
                                "}]\noutcomes: [{name: y, formula: \"sqrt(x) - 2\"}]\n");
    return std::pair{finding_of(*study, "least y").value, finding_of(*study, "greatest y").value};
  };
  EXPECT_EQ(extremes("[4, 1, 25, 9]"), (std::pair{-1.0, 3.0}));
  EXPECT_TRUE(std::isnan(extremes("[4, -1, 25]").first));
  EXPECT_TRUE(std::isnan(extremes("[4, -1, 25]").second));
}

}  // namespace
}  // namespace rigor::estimates_test
