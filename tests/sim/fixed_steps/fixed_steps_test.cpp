#include "rigor/sim/fixed_steps/fixed_steps.hpp"

#include <gtest/gtest.h>

namespace rigor::fixed_steps_test {
namespace {

TEST(FixedSteps, ASpanOfWholeStepsHasThatMany) {
  for (int k = 1; k < 200; ++k) {
    const double t = 0.01 * k;
    const FixedSteps steps(t, 0.01 * (k + 1), 0.001);
    EXPECT_EQ(steps.count(), 10) << k;
  }
}

TEST(FixedSteps, AShortRestIsSharedByAllSteps) {
  const FixedSteps steps(2, 2.105, 0.01);
  EXPECT_EQ(steps.count(), 11);
  for (long k = 0; k < steps.count(); ++k)
    EXPECT_NEAR(steps.end(k) - (k == 0 ? 2 : steps.end(k - 1)), 0.105 / 11, 1e-15);
}

TEST(FixedSteps, TheLastStepEndsOnTheEndToTheBit) {
  for (const double t_end : {0.1, 1.0 / 3, 7.7777}) {
    const FixedSteps steps(0.01, t_end, 1.0 / 60);
    EXPECT_EQ(steps.end(steps.count() - 1), t_end);
  }
}

TEST(FixedSteps, ATargetBeyondTheSpanIsOneStep) {
  EXPECT_EQ(FixedSteps(0, 0.01, 1).count(), 1);
}

}  // namespace
}  // namespace rigor::fixed_steps_test
