// Which choices a scheme looks at.

#include "rigor/sim/method/method_use.hpp"
#include "rigor/sim/make_stepper.hpp"

#include "sim/time_stepping_scenes.hpp"

#include <gtest/gtest.h>

#include <tuple>
#include <utility>

namespace rigor::method_use_test {
namespace {

class ChoicesOfAScheme : public testing::TestWithParam<std::pair<Scheme, SolverMethod>> {
 protected:
  Method method() const {
    Method method;
    std::tie(method.scheme, method.solver) = GetParam();
    return method;
  }

  /// Two cubes after 0.06 s: one has struck the floor, turning; both rub on it.
  State end_of_run(const Method& method) const {
    ModelBuilder builder = test::stepping_builder(0.4, 0.4, Vec3(0, 0, -9.81));
    const Shape cube = Box{Vec3(0.1, 0.1, 0.1)};
    BodyDescription tumbling = test::stepping_body("tumbling", cube, Vec3(0, 0, 0.25));
    tumbling.q_WU = Quat(0.9, 0.3, -0.2, 0.1).normalized();
    tumbling.velocity = Vec3(0.5, 0.2, -3);
    tumbling.angular_velocity = Vec3(3, -2, 1);
    builder.add_body(tumbling);
    BodyDescription sliding = test::stepping_body("sliding", cube, Vec3(1, 0, 0.1));
    sliding.velocity = Vec3(2, 0, 0);
    // Trains of collisions of a sliding block take long.
    if (method.scheme != Scheme::impulse_based) builder.add_body(sliding);
    const std::shared_ptr<const Model> model = builder.build();
    State state = make_initial_state(*model);
    make_stepper(model, method, 0.01)->advance(state, 0.06);
    return state;
  }
};

TEST_P(ChoicesOfAScheme, ThatItDoesNotLookAtChangeNothing) {
  const State expected = end_of_run(method());
  for (const std::string& key : method_choice_keys()) {
    if (uses_choice(method(), key)) continue;
    for (const std::string& value : method_values(key)) {
      Method changed = method();
      ASSERT_EQ(set_method_choice(key, value, changed), "");
      EXPECT_EQ(end_of_run(changed), expected) << key << " " << value;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Schemes, ChoicesOfAScheme,
                         testing::Values(std::pair(Scheme::event_driven, Method().solver),
                                         std::pair(Scheme::time_stepping, Method().solver),
                                         std::pair(Scheme::time_stepping, SolverMethod::substep),
                                         std::pair(Scheme::penalty, Method().solver),
                                         std::pair(Scheme::impulse_based, Method().solver),
                                         std::pair(Scheme::hybrid, Method().solver)));

TEST(MethodUse, EachFamilyHasItsOwn) {
  Method method;
  const auto used_by = [&](Scheme scheme, std::string_view key) {
    method.scheme = scheme;
    return uses_choice(method, key);
  };
  for (const Scheme scheme : {Scheme::event_driven, Scheme::impulse_based, Scheme::hybrid}) {
    EXPECT_TRUE(used_by(scheme, "toi"));
    EXPECT_FALSE(used_by(scheme, "solver"));
    EXPECT_FALSE(used_by(scheme, "penalty_law"));
    EXPECT_EQ(used_by(scheme, "micro_collisions"), scheme == Scheme::impulse_based);
  }
  EXPECT_TRUE(used_by(Scheme::time_stepping, "solver"));
  EXPECT_FALSE(used_by(Scheme::time_stepping, "toi"));
  EXPECT_TRUE(used_by(Scheme::penalty, "penalty_law"));
  EXPECT_FALSE(used_by(Scheme::penalty, "impact"));
  for (const Scheme scheme : {Scheme::time_stepping, Scheme::penalty, Scheme::hybrid})
    EXPECT_TRUE(used_by(scheme, "integrator"));
  EXPECT_TRUE(used_by(Scheme::automatic, "penalty"));
  EXPECT_TRUE(used_by(Scheme::time_stepping, "impact"));
  method.solver = SolverMethod::substep;
  EXPECT_FALSE(used_by(Scheme::time_stepping, "impact"));
  EXPECT_TRUE(used_by(Scheme::time_stepping, "sleeping"));
}

TEST(MethodUse, AnotherValueOfALawThatIsUsedIsAnotherMotion) {
  const std::shared_ptr<const Model> model = test::stepping_cube(1, 1);
  for (const auto& [scheme, key, value] :
       {std::tuple{Scheme::event_driven, "impact", "newton"}, std::tuple{Scheme::hybrid, "impact", "newton"},
        std::tuple{Scheme::impulse_based, "impact", "newton"},
        std::tuple{Scheme::time_stepping, "impact", "newton"},
        std::tuple{Scheme::penalty, "penalty_law", "hunt-crossley"},
        std::tuple{Scheme::penalty, "penalty", "global"}}) {
    Method method;
    method.scheme = scheme;
    Method changed = method;
    ASSERT_EQ(set_method_choice(key, value, changed), "");
    EXPECT_TRUE(uses_choice(method, key));
    State one = make_initial_state(*model), other = one;
    make_stepper(model, method, 0.01)->advance(one, 0.4);
    make_stepper(model, changed, 0.01)->advance(other, 0.4);
    EXPECT_GT((one.position(1) - other.position(1)).norm(), 1e-9) << method_choice(method, "scheme") << key;
  }
}

}  // namespace
}  // namespace rigor::method_use_test
