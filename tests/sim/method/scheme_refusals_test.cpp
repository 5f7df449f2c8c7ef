// What `scheme: auto` does with schemes that refuse the scene.

#include "rigor/sim/method/scheme_check.hpp"
#include "rigor/sim/method/scheme_choice.hpp"

#include "sim/time_stepping_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace rigor::scheme_refusals_test {
namespace {

/// Facts of bodies so many that event-driven is not the first choice.
SchemeFacts crowd(double restitution) {
  return {.dynamic_bodies = 1000, .colliding_bodies = 1000, .highest_restitution = restitution};
}

/// As many balls that roll with friction, and do not bounce.
std::shared_ptr<const Model> rolling_crowd() {
  ModelBuilder builder = test::stepping_builder(0, 0.5, Vec3(0, 0, -9.81));
  Material cork{"cork"};
  cork.rolling_friction = 1e-3;
  builder.add_material(cork);
  const Shape shape = Sphere{0.1};
  for (int k = 0; k < 300; ++k) {
    BodyDescription ball = test::stepping_body("ball" + std::to_string(k), shape, Vec3(k, 0, 0.1));
    ball.shapes[0].material = "cork";
    builder.add_body(ball);
  }
  return builder.build();
}

TEST(SchemeRefusals, ASchemeThatRefusesIsPassedOverAndTheReasonIsSaid) {
  const std::vector<SchemeRefusal> one = {{Scheme::hybrid, "no springs"}};
  const SchemeChoice second = choose_scheme(crowd(0.5), one);
  EXPECT_EQ(second.scheme, Scheme::time_stepping);
  EXPECT_NE(second.reason.find("; hybrid would be preferred but refuses the scene: no springs"),
            std::string::npos)
      << second.reason;
  const std::vector<SchemeRefusal> two = {{Scheme::hybrid, "no springs"},
                                          {Scheme::time_stepping, "no gears"}};
  const SchemeChoice third = choose_scheme(crowd(0.5), two);
  EXPECT_EQ(third.scheme, Scheme::event_driven);
  EXPECT_NE(third.reason.find("no springs; time-stepping would be preferred but refuses the scene: no gears"),
            std::string::npos)
      << third.reason;
  // What the rule does not want is not spoken of.
  EXPECT_EQ(choose_scheme(crowd(0), one).reason.find("refuses"), std::string::npos);
}

TEST(SchemeRefusals, WhereAllOfTheRuleRefuseAnyOtherIsTaken) {
  std::vector<SchemeRefusal> refusals;
  for (const Scheme scheme : {Scheme::event_driven, Scheme::time_stepping, Scheme::hybrid})
    refusals.push_back({scheme, "no"});
  EXPECT_EQ(choose_scheme(crowd(0.5), refusals).scheme, Scheme::penalty);
  refusals.push_back({Scheme::penalty, "no"});
  EXPECT_EQ(choose_scheme(crowd(0.5), refusals).scheme, Scheme::impulse_based);
}

TEST(SchemeRefusals, AreThoseOfTheChecks) {
  const std::shared_ptr<const Model> model = rolling_crowd();
  const std::vector<SchemeRefusal> refusals = scheme_refusals(*model, Method{});
  for (const Scheme scheme : all_schemes()) {
    Method method;
    method.scheme = scheme;
    const std::vector<std::string> reasons = check_scheme(*model, method);
    const auto refusal = std::find_if(refusals.begin(), refusals.end(),
                                      [&](const SchemeRefusal& each) { return each.scheme == scheme; });
    ASSERT_EQ(refusal != refusals.end(), !reasons.empty()) << method_choice(method, "scheme");
    if (!reasons.empty()) {
      EXPECT_EQ(refusal->reason, reasons.front());
    }
  }
  // The rest of the method may not go with a scheme either.
  Method with_rk4;
  with_rk4.integrator = IntegratorMethod::rk4;
  const std::vector<SchemeRefusal> of_rk4 = scheme_refusals(*test::stepping_cube(1, 1), with_rk4);
  ASSERT_EQ(of_rk4.size(), 1u);
  EXPECT_EQ(of_rk4[0].scheme, Scheme::penalty);
  EXPECT_NE(of_rk4[0].reason.find("does not go with integrator 'rk4'"), std::string::npos);
}

TEST(SchemeRefusals, AutoTakesASchemeThatRunsBallsWithRollingFriction) {
  const std::shared_ptr<const Model> model = rolling_crowd();
  Method method, first;
  method.scheme = Scheme::automatic;
  first.scheme = Scheme::time_stepping;
  const ResolvedMethod resolved = resolve_scheme(*model, method);
  EXPECT_TRUE(check_scheme(*model, resolved.method).empty());
  // Many lasting contacts are the domain of time stepping, if it takes them.
  const std::vector<std::string> reasons = check_scheme(*model, first);
  EXPECT_EQ(resolved.method.scheme == Scheme::time_stepping, reasons.empty());
  if (!reasons.empty()) {
    EXPECT_NE(resolved.scheme_reason.find(reasons.front()), std::string::npos) << resolved.scheme_reason;
  }
}

}  // namespace
}  // namespace rigor::scheme_refusals_test
