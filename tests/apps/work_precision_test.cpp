#include "apps/work_precision.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace rigor::work_precision_test {
namespace {

/// A run with an error against the first reference.
ComparedRun run_of(const std::vector<std::string>& values, double step, double error, double cpu_time = 1) {
  ComparedRun run{.values = values, .label = values.front(), .cpu_time = cpu_time, .step = step};
  run.reference = 0;
  run.error = MotionError{.position = {error, "a", 1}};
  return run;
}

/// Two schemes at three steps, of orders 1 and 2; the steps change fastest.
Comparison two_orders() {
  Comparison comparison{.scene = "s", .keys = {"method.scheme", "run.step"}};
  comparison.references.push_back({.name = "r", .is_run = true, .own = MotionError{}});
  for (const int order : {1, 2}) {
    for (const double h : {0.04, 0.02, 0.005})
      comparison.runs.push_back(
          run_of({order == 1 ? "slow" : "fast", std::to_string(h)}, h, 3 * std::pow(h, order), 1 / h));
  }
  return comparison;
}

TEST(ObservedOrders, AreThoseOfThePowersOfTheStep) {
  const std::vector<std::optional<double>> orders = observed_orders(two_orders());
  ASSERT_EQ(orders.size(), 6u);
  for (const std::size_t first : {0, 3}) {
    EXPECT_FALSE(orders[first]);
    for (const std::size_t i : {first + 1, first + 2}) {
      // Two logarithms, each rounded.
      EXPECT_NEAR(orders[i].value(), first == 0 ? 1 : 2, 1e-14);
    }
  }
}

TEST(ObservedOrders, AreNotToldWhereTheReferenceIsNoBetter) {
  Comparison comparison = two_orders();
  // Ten times 2e-3 is above the errors of the finest run of the first curve and of all of the second.
  comparison.references[0].own = MotionError{.position = {2e-3, "a", 1}};
  const std::vector<std::optional<double>> orders = observed_orders(comparison);
  EXPECT_TRUE(orders[1]);
  for (const std::size_t i : {2, 4, 5}) EXPECT_FALSE(orders[i]) << i;
}

TEST(ObservedOrders, AreNotToldOfRounding) {
  Comparison comparison = two_orders();
  // Below 1e-4 are the errors of the finest run of the second curve alone.
  comparison.references[0].bound = 1e5;
  const std::vector<std::optional<double>> orders = observed_orders(comparison);
  for (const std::size_t i : {1, 2, 4}) EXPECT_TRUE(orders[i]) << i;
  EXPECT_FALSE(orders[5]);
}

TEST(ObservedOrders, NeedTwoStepsAndTwoErrors) {
  Comparison comparison = two_orders();
  comparison.runs[1].error.reset();
  comparison.runs[3].error->position.value = 0;
  comparison.runs[5].step = comparison.runs[4].step;
  for (const std::optional<double>& order : observed_orders(comparison)) EXPECT_FALSE(order);
}

TEST(CpuRatios, AreToTheFirstRunThatIsNotRefused) {
  Comparison comparison = two_orders();
  comparison.runs[0].end = RunEnd::refused;
  const std::vector<std::optional<double>> ratios = cpu_ratios(comparison);
  EXPECT_FALSE(ratios[0]);
  EXPECT_EQ(ratios[1], 1);
  EXPECT_EQ(ratios[2], 4);
  EXPECT_EQ(base_run(comparison), 1u);
}

TEST(PrecisionCurves, HoldRunsThatDifferInTheStepAlone) {
  const Comparison comparison = two_orders();
  const std::vector<PrecisionCurve> curves = precision_curves(comparison);
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_EQ(curves[0].label, "method.scheme=slow");
  EXPECT_EQ(curves[0].runs, (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(curves[1].runs, (std::vector<std::size_t>{3, 4, 5}));
}

TEST(PrecisionJson, HasThePointsOfEachCurveAndNothingWithoutErrors) {
  Comparison comparison = two_orders();
  comparison.runs[2].error.reset();
  const nlohmann::json json = nlohmann::json::parse(precision_json(comparison));
  EXPECT_EQ(json["references"][0]["name"], "r");
  EXPECT_EQ(json["curves"][0]["points"].size(), 2u);
  EXPECT_EQ(json["curves"][1]["points"].size(), 3u);
  EXPECT_EQ(json["curves"][1]["points"][0]["step"], 0.04);
  EXPECT_EQ(json["curves"][1]["points"][0]["cpu_time"], 25);
  EXPECT_EQ(json["curves"][1]["points"][0]["order"], nullptr);
  for (ComparedRun& run : comparison.runs) run.error.reset();
  EXPECT_EQ(precision_json(comparison), "");
}

}  // namespace
}  // namespace rigor::work_precision_test
