// The ledgers of energy and momentum, on bodies whose momenta are changed by hand.

#include "rigor/sim/report/ledger.hpp"
#include "rigor/contact/system/work_done.hpp"
#include "rigor/model/model_builder.hpp"

#include <gtest/gtest.h>

namespace rigor::ledger_test {
namespace {

/// Two bodies of 2 kg and 3 kg, moments 1, 2, 3 kg m² and 2, 2, 2 kg m².
std::shared_ptr<const Model> two_bodies() {
  ModelBuilder builder;
  for (const auto& [name, mass, moments] :
       {std::tuple{"a", 2.0, Vec3(1, 2, 3)}, std::tuple{"b", 3.0, Vec3(2, 2, 2)}}) {
    BodyDescription body;
    body.name = name;
    body.p_WU = mass * Vec3::UnitX();
    body.inertia = GivenInertia{mass, Vec3::Zero(), moments, Vec3::Zero()};
    builder.add_body(body);
  }
  return builder.build();
}

struct Bodies {
  std::shared_ptr<const Model> model = two_bodies();
  std::vector<int> indices{0, 1};
  std::vector<BodyPhase> phases{{Vec3(1, 0, 0), Quat::Identity(), Vec3(2, 0, 0), Vec3(0, 0, 3)},
                                {Vec3(0, 2, 0), Quat::Identity(), Vec3(0, 3, 0), Vec3(2, 0, 0)}};
  AdvanceReport report;
};

TEST(Ledger, TotalsAreSumsAboutTheOrigin) {
  const Bodies bodies;
  const BodyTotals totals = totals_of(*bodies.model, bodies.indices, bodies.phases);
  EXPECT_EQ(totals.P, Vec3(2, 3, 0));
  // Spins, and x × P: (1,0,0) × (2,0,0) = 0, (0,2,0) × (0,3,0) = 0.
  EXPECT_EQ(totals.L, Vec3(2, 0, 3));
  // ½ 2²/2 + ½ 3²/3 + ½ 3²/3 + ½ 2²/2.
  EXPECT_EQ(totals.T, 1 + 1.5 + 1.5 + 1);
}

TEST(EnergyScope, ChargesWhatTheBodiesLoseToItsAccount) {
  for (const EnergyAccount account :
       {EnergyAccount::impact, EnergyAccount::plastic_impact, EnergyAccount::projection}) {
    Bodies bodies;
    {
      const EnergyScope scope(account, *bodies.model, bodies.indices, bodies.phases, bodies.report);
      bodies.phases[0].P.setZero();
    }
    const AdvanceReport& report = bodies.report;
    EXPECT_EQ(report.impact_loss, account == EnergyAccount::projection ? 0 : 1);
    EXPECT_EQ(report.projection_loss, account == EnergyAccount::projection ? 1 : 0);
    EXPECT_EQ(report.impact_gain, 0);
    EXPECT_EQ(report.work, 0);
  }
}

TEST(EnergyScope, TellsGainsOfImpactsFromLosses) {
  Bodies bodies;
  const auto doubled = [&](EnergyAccount account) {
    const EnergyScope scope(account, *bodies.model, bodies.indices, bodies.phases, bodies.report);
    bodies.phases[0].P *= 2;
  };
  // From 1 J to 4 J of body a.
  doubled(EnergyAccount::impact);
  EXPECT_EQ(bodies.report.impact_gain, 3);
  EXPECT_EQ(bodies.report.impact_loss, 0);
  // From 4 J to 16 J: a plastic impact books whichever sign it has.
  doubled(EnergyAccount::plastic_impact);
  EXPECT_EQ(bodies.report.impact_gain, 3);
  EXPECT_EQ(bodies.report.impact_loss, -12);
}

TEST(EnergyScope, CountsWorkBookedMeanwhileAsSupplied) {
  Bodies bodies;
  bodies.report.work = 100;  // Before: none of the scope's business.
  {
    const EnergyScope scope(EnergyAccount::impact, *bodies.model, bodies.indices, bodies.phases,
                            bodies.report);
    bodies.phases[0].P *= 2;  // + 3 J.
    bodies.report.book({.supplied = 5, .motors = 2, .friction = 0});
  }
  EXPECT_EQ(bodies.report.impact_loss, 2);
  EXPECT_EQ(bodies.report.impact_gain, 0);
  EXPECT_EQ(bodies.report.work, 105);
  EXPECT_EQ(bodies.report.motor_work, 2);
}

TEST(MomentumScope, BooksWhatNoImpulseFromOutsideExplains) {
  Bodies bodies;
  const MomentumScope scope(*bodies.model, bodies.indices, bodies.phases);
  bodies.phases[0].P += Vec3(0, 4, 0);  // At (1, 0, 0): moment (0, 0, 4).
  bodies.phases[1].L += Vec3(0, 0, 1);
  scope.book_error({Wrench{Vec3(0, 4, 0), Vec3(0, 0, 4)}, Wrench{Vec3::Zero(), Vec3(0, 0, 1)}},
                   bodies.report);
  EXPECT_EQ(bodies.report.momentum_error, Vec3::Zero());
  EXPECT_EQ(bodies.report.angular_momentum_error, Vec3::Zero());
  scope.book_error({Wrench{Vec3(0, 3, 0), Vec3::Zero()}}, bodies.report);
  EXPECT_EQ(bodies.report.momentum_error, Vec3(0, 1, 0));
  EXPECT_EQ(bodies.report.angular_momentum_error, Vec3(0, 0, 5));
  // Errors add up with their signs.
  scope.book_error({Wrench{Vec3(0, 5, 0), Vec3(0, 0, 10)}}, bodies.report);
  EXPECT_EQ(bodies.report.momentum_error, Vec3::Zero());
  EXPECT_EQ(bodies.report.angular_momentum_error, Vec3::Zero());
}

TEST(MomentumScope, NoticesADisplacementAsAMoment) {
  Bodies bodies;
  const MomentumScope scope(*bodies.model, bodies.indices, bodies.phases);
  bodies.phases[1].x += Vec3(1, 0, 0);  // (1, 0, 0) × (0, 3, 0).
  Vec3 impulse = Vec3::Zero(), angular_impulse = Vec3(0, 0, 1);
  scope.add_change(impulse, angular_impulse);
  EXPECT_EQ(impulse, Vec3::Zero());
  EXPECT_EQ(angular_impulse, Vec3(0, 0, 4));
}

TEST(AdvanceReport, JudgesOverlapsByTheThinnerBodyAndByDepth) {
  ModelBuilder builder;
  for (const auto& [name, size] : {std::pair{"slab", Vec3(10, 10, 0.1)}, std::pair{"block", Vec3(1, 2, 3)},
                                   std::pair{"rock", Vec3(5, 6, 4)}}) {
    BodyDescription body;
    body.name = name;
    ShapeDescription shape;
    shape.shape = Box{0.5 * size};
    body.shapes = {shape};
    builder.add_body(body);
  }
  const std::shared_ptr<const Model> model = builder.build();
  EXPECT_EQ(model->body(0).thickness, 0.1);
  EXPECT_EQ(model->body(2).thickness, 4);
  AdvanceReport report;
  report.note_overlap(*model, 0.05, 0, 1, 1.5);
  report.note_overlap(*model, 0.2, 1, 2, 2.5);
  report.note_overlap(*model, 0.02, 0, 2, 3.5);
  EXPECT_EQ(report.max_penetration, 0.2);
  EXPECT_EQ(report.penetration_time, 2.5);
  EXPECT_DOUBLE_EQ(report.worst_overlap.share, 0.5);
  EXPECT_EQ(report.worst_overlap.body_A, 0);
  EXPECT_EQ(report.worst_overlap.body_B, 1);
  EXPECT_EQ(report.worst_overlap.time, 1.5);
  AdvanceReport sum;
  sum.add(report);
  EXPECT_EQ(sum.worst_overlap.depth, 0.05);
}

}  // namespace
}  // namespace rigor::ledger_test
