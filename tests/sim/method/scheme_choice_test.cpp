#include "rigor/sim/method/scheme_choice.hpp"

#include "rigor/model/model_builder.hpp"
#include "rigor/sim/simulation.hpp"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace rigor::scheme_choice_test {
namespace {

/// Facts of many bodies that fall on each other.
SchemeFacts many_bodies(double restitution) {
  return {.dynamic_bodies = 1000,
          .colliding_bodies = 1000,
          .has_closed_form = true,
          .lowest_restitution = restitution,
          .highest_restitution = restitution};
}

Scheme chosen(const SchemeFacts& facts) {
  return choose_scheme(facts).scheme;
}

/// The same where only these schemes can run the scene.
SchemeChoice choice_among(const std::vector<Scheme>& possible, const SchemeFacts& facts) {
  std::vector<SchemeRefusal> refusals;
  for (const Scheme scheme : all_schemes()) {
    if (std::find(possible.begin(), possible.end(), scheme) == possible.end())
      refusals.push_back({scheme, "no"});
  }
  return choose_scheme(facts, refusals);
}

/// Two balls on a floor, the second above the first; they may not touch each other.
std::shared_ptr<const Model> two_balls(double restitution) {
  ModelBuilder builder;
  builder.set_gravity(Vec3(0, 0, -10));
  builder.add_material({"m", 1000, 0.5, restitution});
  BodyDescription floor;
  floor.name = "floor";
  floor.motion = MotionType::fixed;
  floor.shapes.push_back({HalfSpace{Vec3::UnitZ(), 0}, Vec3::Zero(), Quat::Identity(), "m", ""});
  builder.add_body(floor);
  for (const auto& [name, height] : {std::pair("low", 0.5), std::pair("high", 1.5 + 1e-3)}) {
    BodyDescription ball;
    ball.name = name;
    ball.p_WU = Vec3(0, 0, height);
    ball.mass = 1;
    ball.shapes.push_back({Sphere{0.5}, Vec3::Zero(), Quat::Identity(), "m", ""});
    builder.add_body(ball);
  }
  BodyDescription ghost;
  ghost.name = "ghost";
  ghost.p_WU = Vec3(9, 0, 9);
  ghost.mass = 1;
  ghost.mask = 0;
  ghost.shapes.push_back({Sphere{0.5}, Vec3::Zero(), Quat::Identity(), "m", ""});
  builder.add_body(ghost);
  return builder.build();
}

TEST(SchemeFacts, CountWhatMayTouchAndWhatDoes) {
  const SchemeFacts facts = scheme_facts(*two_balls(0.25), 1e-6);
  EXPECT_EQ(facts.dynamic_bodies, 3);
  EXPECT_EQ(facts.colliding_bodies, 2);
  // The lower ball touches the floor; between the balls is a millimetre.
  EXPECT_EQ(facts.touching_pairs, 1);
  EXPECT_EQ(scheme_facts(*two_balls(0.25), 2e-3).touching_pairs, 2);
  // It bounces, and so does the upper ball, which is apart, until both touch something; not with restitution
  // 0 or 1.
  EXPECT_EQ(facts.bouncing_pairs, 1);
  EXPECT_EQ(facts.bouncing_apart, 1);
  EXPECT_EQ(scheme_facts(*two_balls(0.25), 2e-3).bouncing_pairs, 2);
  EXPECT_EQ(scheme_facts(*two_balls(0.25), 2e-3).bouncing_apart, 0);
  for (const double e : {0.0, 1.0}) {
    EXPECT_EQ(scheme_facts(*two_balls(e), 1e-6).bouncing_pairs, 0);
    EXPECT_EQ(scheme_facts(*two_balls(e), 1e-6).bouncing_apart, 0);
  }
  EXPECT_EQ(facts.joints, 0);
  EXPECT_TRUE(facts.has_closed_form);
  EXPECT_EQ(facts.lowest_restitution, 0.25);
  EXPECT_EQ(facts.highest_restitution, 0.25);
}

TEST(SchemeFacts, AForceOrADragLeavesNoClosedForm) {
  for (const bool has_spring : {true, false}) {
    ModelBuilder builder;
    BodyDescription ball;
    ball.name = "ball";
    ball.mass = 1;
    ball.linear_drag = has_spring ? 0 : 1;
    ball.shapes.push_back({Sphere{0.5}});
    builder.add_body(ball);
    if (has_spring) {
      ModelBuilder::ForceDescription spring{ModelBuilder::ForceDescription::Type::spring};
      spring.bodies = {"world", "ball"};
      spring.points = {Vec3::Zero(), Vec3::Zero()};
      spring.stiffness = 1;
      builder.add_force(spring);
    }
    const SchemeFacts facts = scheme_facts(*builder.build(), 1e-6);
    EXPECT_FALSE(facts.has_closed_form);
    EXPECT_EQ(facts.colliding_bodies, 0);
  }
}

TEST(SchemeRules, TheFirstThatAppliesDecides) {
  // The cases are the lines of the table, one after the other.
  EXPECT_EQ(chosen({.dynamic_bodies = 1000, .has_closed_form = true}), Scheme::event_driven);
  EXPECT_EQ(chosen({.dynamic_bodies = 1000, .joints = 999}), Scheme::event_driven);
  EXPECT_EQ(chosen(many_bodies(1)), Scheme::event_driven);
  SchemeFacts hail{.dynamic_bodies = 40, .colliding_bodies = 40, .bouncing_pairs = 1, .bouncing_apart = 1};
  EXPECT_EQ(chosen(hail), Scheme::hybrid);
  EXPECT_EQ(chosen({.dynamic_bodies = 40, .colliding_bodies = 40}), Scheme::event_driven);
  SchemeFacts stack{.dynamic_bodies = 50, .colliding_bodies = 50, .resting_bodies = 50};
  EXPECT_EQ(chosen(stack), Scheme::event_driven);
  stack.resting_bodies = 49;
  EXPECT_EQ(chosen(stack), Scheme::time_stepping);
  hail.bouncing_apart = 0;
  EXPECT_EQ(chosen(hail), Scheme::event_driven);
  hail.bouncing_pairs = 0, hail.bouncing_apart = 1;
  EXPECT_EQ(chosen(hail), Scheme::event_driven);
  EXPECT_EQ(chosen({.dynamic_bodies = 41, .colliding_bodies = 41, .highest_restitution = 0.1}),
            Scheme::hybrid);
  EXPECT_EQ(chosen(many_bodies(0.5)), Scheme::hybrid);
  EXPECT_EQ(chosen(many_bodies(0)), Scheme::time_stepping);
  // Elastic bodies that lie on each other, or are tied together, do not only fly.
  SchemeFacts lying = many_bodies(1);
  lying.touching_pairs = 1;
  EXPECT_EQ(chosen(lying), Scheme::hybrid);
  SchemeFacts tied = many_bodies(1);
  tied.has_closed_form = false;
  EXPECT_EQ(chosen(tied), Scheme::hybrid);
}

TEST(SchemeRules, ASchemeThatRefusesIsReplacedAndSaid) {
  const SchemeChoice choice = choice_among({Scheme::event_driven}, many_bodies(0.5));
  EXPECT_EQ(choice.scheme, Scheme::event_driven);
  EXPECT_NE(choice.reason.find("hybrid would be preferred but refuses the scene: no"), std::string::npos)
      << choice.reason;
  EXPECT_EQ(choice_among({Scheme::event_driven, Scheme::time_stepping}, many_bodies(0.5)).scheme,
            Scheme::time_stepping);
  EXPECT_EQ(choice_among({Scheme::event_driven, Scheme::hybrid}, many_bodies(0)).scheme, Scheme::hybrid);
  EXPECT_EQ(choose_scheme(many_bodies(0.5)).reason.find("refuses"), std::string::npos);
}

TEST(SchemeRules, TheLastOneAlwaysAppliesAndAllEndWithEventDriven) {
  EXPECT_TRUE(scheme_rules().back().applies(SchemeFacts{}));
  for (const SchemeRule& rule : scheme_rules()) {
    ASSERT_FALSE(rule.schemes.empty());
    EXPECT_EQ(rule.schemes.back(), Scheme::event_driven) << rule.when;
  }
}

TEST(SchemeRules, AreThoseOfTheDocumentation) {
  std::ifstream file(std::string(RIGOR_SOURCE_DIR) + "/docs/choosing.md");
  const std::string document{std::istreambuf_iterator<char>(file), {}};
  std::string table;
  for (const SchemeRule& rule : scheme_rules()) {
    std::string schemes;
    for (const Scheme scheme : rule.schemes) {
      Method method;
      method.scheme = scheme;
      schemes += (schemes.empty() ? "" : ", else ") + method_choice(method, "scheme");
    }
    table += fmt::format("| {} | {} | {} |\n", rule.when, schemes, rule.why);
  }
  EXPECT_NE(document.find(table), std::string::npos) << "docs/choosing.md must have these lines:\n" << table;
}

TEST(AllSchemes, BeginWithEventDrivenAndLeaveOutAuto) {
  const std::vector<Scheme> schemes = all_schemes();
  EXPECT_EQ(schemes.front(), Scheme::event_driven);
  for (const Scheme scheme : schemes) EXPECT_NE(scheme, Scheme::automatic);
  // `auto` itself is the one name more.
  EXPECT_EQ(schemes.size() + 1, method_values("scheme").size());
}

TEST(AutomaticScheme, RunsAsTheSchemeThatItStandsForAndTheAuditSaysWhy) {
  const std::shared_ptr<const Model> model = two_balls(0.5);
  Method method, by_name;
  method.scheme = Scheme::automatic;
  by_name.scheme = resolve_scheme(*model, method).method.scheme;
  EXPECT_EQ(by_name.scheme, Scheme::hybrid);
  const RunSettings settings{.duration = 0.5};
  const Observer watch = [](const State&, const AdvanceReport&, const Auditor&) { return true; };
  const RunResult chosen_run = run_simulation(model, method, settings, std::nullopt, watch);
  const RunResult named_run = run_simulation(model, by_name, settings, std::nullopt, watch);
  EXPECT_EQ(chosen_run.state, named_run.state);
  EXPECT_EQ(chosen_run.audit.method.scheme, Scheme::hybrid);
  EXPECT_EQ(chosen_run.audit.scheme_reason,
            "hybrid, since at most 40 bodies collide, some touch at t = 0 and some are apart, all with "
            "restitutions "
            "between 0 and 1: bouncing bodies fall on resting ones, which must not bounce in each of their "
            "impacts (3 "
            "dynamic bodies, 2 may collide; 1 pair touches at t = 0; 0 joints; restitution 0.5)");
  EXPECT_EQ(named_run.audit.scheme_reason, "");
}

}  // namespace
}  // namespace rigor::scheme_choice_test
