#include "rigor/sim/method/method.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <set>
#include <string>

namespace rigor::method_test {
namespace {

TEST(MethodTable, EachValueOnceWithMeaningAndSource) {
  std::set<std::string> seen;
  for (const MethodChoice& choice : method_choices()) {
    EXPECT_TRUE(seen.insert(std::string(choice.key) + "=" + std::string(choice.value)).second)
        << choice.value;
    EXPECT_FALSE(choice.meaning.empty());
    EXPECT_FALSE(choice.source.empty());
    EXPECT_EQ(choice.meaning.find('\n'), std::string_view::npos);
  }
  // 5 schemes and `auto`, 8 integrators, 2 orientations, 2 broad phases, 2 distances, 3 times of impact, 3
  // laws, 5 and 2 rules, 2 of micro-collisions, 2 + 2 + 2 + 3 + 3 of time stepping and penalty, 2 of sleep, 2
  // of the last resort.
  EXPECT_EQ(seen.size(), 51u);
}

TEST(MethodTable, DefaultsAreAmongTheValues) {
  const Method method;
  for (const std::string& key : method_choice_keys()) {
    const std::string value = method_choice(method, key);
    const std::vector<std::string> values = method_values(key);
    EXPECT_NE(std::find(values.begin(), values.end(), value), values.end()) << key;
  }
  EXPECT_TRUE(check_combination(method).empty());
}

TEST(SetMethodChoice, EveryValueIsSetAndReadBack) {
  for (const MethodChoice& choice : method_choices()) {
    Method method;
    EXPECT_EQ(set_method_choice(choice.key, choice.value, method), "");
    EXPECT_EQ(method_choice(method, choice.key), choice.value);
  }
}

TEST(SetMethodChoice, EnumeratorsAreTheirNames) {
  Method method;
  set_method_choice("integrator", "exact", method);
  EXPECT_EQ(method.integrator, IntegratorMethod::exact);
  set_method_choice("integrator", "semi-implicit-euler", method);
  EXPECT_EQ(method.integrator, IntegratorMethod::semi_implicit_euler);
  set_method_choice("integrator", "dop853", method);
  EXPECT_EQ(method.integrator, IntegratorMethod::dop853);
  set_method_choice("integrator", "lie-rk4", method);
  EXPECT_EQ(method.integrator, IntegratorMethod::lie_rk4);
  set_method_choice("orientation", "matrix", method);
  EXPECT_EQ(method.orientation, OrientationForm::matrix);
  set_method_choice("distance", "lin-canny", method);
  EXPECT_EQ(method.distance, DistanceMethod::lin_canny);
  set_method_choice("broad_phase", "sweep-and-prune", method);
  EXPECT_EQ(method.broad_phase, BroadPhaseMethod::sweep_and_prune);
  set_method_choice("toi", "bisection", method);
  EXPECT_EQ(method.toi, ToiMethod::bisection);
  set_method_choice("simultaneous", "lcp", method);
  EXPECT_EQ(method.simultaneous, SimultaneousLaw::lcp);
  set_method_choice("simultaneous", "sequential", method);
  EXPECT_EQ(method.simultaneous, SimultaneousLaw::sequential);
  set_method_choice("simultaneous", "projection", method);
  EXPECT_EQ(method.simultaneous, SimultaneousLaw::projection);
  set_method_choice("simultaneous", "moreau", method);
  EXPECT_EQ(method.simultaneous, SimultaneousLaw::moreau);
  set_method_choice("micro_collisions", "plain", method);
  EXPECT_EQ(method.micro_collisions, MicroCollisionMethod::plain);
  set_method_choice("resting", "contact-space", method);
  EXPECT_EQ(method.resting, RestingMethod::contact_space);
  set_method_choice("lcp", "lemke", method);
  EXPECT_EQ(method.lcp, LcpMethod::lemke);
}

TEST(SetMethodChoice, TellsWhatIsWrong) {
  Method method;
  EXPECT_EQ(set_method_choice("impact", "newtn", method), "unknown impact 'newtn'; did you mean 'newton'?");
  EXPECT_EQ(set_method_choice("distance", "lin-cany", method),
            "unknown distance 'lin-cany'; did you mean 'lin-canny'?");
  EXPECT_EQ(set_method_choice("solver", "substeps", method),
            "unknown solver 'substeps'; did you mean 'substep'?");
  EXPECT_EQ(set_method_choice("impct", "newton", method), "unknown choice 'impct'; did you mean 'impact'?");
  EXPECT_EQ(method, Method{});
}

TEST(CheckCombination, TheMatrixGoesOnlyWithIntegratorsThatUseIt) {
  Method method;
  method.orientation = OrientationForm::matrix;
  for (const IntegratorMethod integrator : {IntegratorMethod::exact, IntegratorMethod::lie_rk4}) {
    method.integrator = integrator;
    ASSERT_EQ(check_combination(method).size(), 1u);
    EXPECT_NE(check_combination(method)[0].find("euler, semi-implicit-euler, midpoint, rk4, dopri5, dop853"),
              std::string::npos);
  }
  for (const IntegratorMethod integrator :
       {IntegratorMethod::euler, IntegratorMethod::dopri5, IntegratorMethod::dop853}) {
    method.integrator = integrator;
    EXPECT_TRUE(check_combination(method).empty());
  }
}

TEST(CheckCombination, SweepsAreWholeAndHaveTheExactCone) {
  Method method;
  method.iterations = 2.5;
  EXPECT_EQ(check_combination(method), std::vector<std::string>{"iterations is 2.5, must be a whole number"});
  method = Method{};
  method.solver = SolverMethod::pgs;
  EXPECT_TRUE(check_combination(method).empty());
  method.cone = ConeMethod::convex;
  EXPECT_EQ(check_combination(method),
            std::vector<std::string>{"solver 'pgs' does not go with cone 'convex'; cones that do: exact"});
}

TEST(CheckCombination, PlainMicroCollisionsNeedTheImpulseBasedScheme) {
  Method method;
  method.scheme = Scheme::event_driven;
  method.micro_collisions = MicroCollisionMethod::plain;
  EXPECT_EQ(
      check_combination(method),
      std::vector<std::string>{"micro_collisions 'plain' does not go with scheme 'event-driven', which has "
                               "none; schemes that do: impulse-based"});
  for (const Scheme scheme : {Scheme::impulse_based, Scheme::automatic}) {
    method.scheme = scheme;
    EXPECT_TRUE(check_combination(method).empty());
  }
}

TEST(CheckCombination, ProjectionsNeedASchemeThatSolvesImpactsTogether) {
  for (const SimultaneousLaw law : {SimultaneousLaw::projection, SimultaneousLaw::moreau}) {
    Method method;
    method.simultaneous = law;
    for (const Scheme scheme :
         {Scheme::event_driven, Scheme::time_stepping, Scheme::hybrid, Scheme::automatic}) {
      method.scheme = scheme;
      EXPECT_TRUE(check_combination(method).empty());
    }
    for (const Scheme scheme : {Scheme::penalty, Scheme::impulse_based}) {
      method.scheme = scheme;
      ASSERT_EQ(check_combination(method).size(), 1u);
      EXPECT_NE(check_combination(method)[0].find("schemes that do: event-driven, time-stepping, hybrid"),
                std::string::npos);
    }
    method.scheme = Scheme::time_stepping;
    method.solver = SolverMethod::substep;
    ASSERT_EQ(check_combination(method).size(), 1u);
    EXPECT_NE(check_combination(method)[0].find("solvers that do: exact, pgs"), std::string::npos);
  }
}

TEST(MethodNumbers, DefaultsAreThoseOfTheStructAndInRange) {
  const Method method;
  for (const MethodNumber& number : method_numbers()) {
    EXPECT_EQ(std::stod(std::string(number.fallback)), method.*number.member) << number.key;
    EXPECT_TRUE(number.range.contains(method.*number.member)) << number.key;
  }
}

}  // namespace
}  // namespace rigor::method_test
