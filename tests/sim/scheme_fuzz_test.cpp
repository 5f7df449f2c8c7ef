// Small random scenes by all schemes: nothing stops, becomes infinite or gains energy, nothing sinks in. The
// benchmark rigor_scheme_fuzz looks for longer.

#include "sim/scheme_fuzz.hpp"
#include "sim/random_scene.hpp"

#include "rigor/sim/method/scheme_check.hpp"

#include <gtest/gtest.h>

namespace rigor::scheme_fuzz_test {
namespace {

class SchemeFuzz : public testing::TestWithParam<Scheme> {};

TEST_P(SchemeFuzz, RandomScenesRunToTheirEndWithinTheAuditsTolerances) {
  Method method;
  method.scheme = GetParam();
  // Trains of collisions take many.
  const long most_polls = method.scheme == Scheme::impulse_based ? 20000 : 200000;
  int whole = 0;
  for (unsigned seed = 1; seed <= 8; ++seed) {
    const std::shared_ptr<const Model> model = test::RandomScene(seed, 3).build();
    if (!check_scheme(*model, method).empty()) continue;
    const test::FuzzOutcome outcome = test::fuzz_run(model, method, 0.3, most_polls);
    EXPECT_EQ(outcome.trouble, "") << "seed " << seed;
    if (!outcome.took_too_long) ++whole;
    // The same scene gives the same bits.
    if (seed <= 2) {
      EXPECT_EQ(test::fuzz_run(test::RandomScene(seed, 3).build(), method, 0.3, most_polls).state,
                outcome.state);
    }
  }
  EXPECT_GE(whole, 3);
}

INSTANTIATE_TEST_SUITE_P(Schemes, SchemeFuzz,
                         testing::Values(Scheme::event_driven, Scheme::time_stepping, Scheme::penalty,
                                         Scheme::impulse_based, Scheme::hybrid));

}  // namespace
}  // namespace rigor::scheme_fuzz_test
