// Every scene of scenes/ runs and gives the number that its header promises.

#include "laws/scene_runs.hpp"

#include "rigor/math/rotation.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rigor::test::scenes_test {
namespace {

constexpr double g = 9.81;

void expect_trusted(const SceneRun& run) {
  EXPECT_EQ(run.audit().report.reason, StopReason::reached_end) << run.audit().report.detail;
  for (const std::string& violation : run.audit().violations) ADD_FAILURE() << violation;
}

/// Height above its lowest position of a ball dropped from h with e = 1, at time t.
double bouncing_height(double h, double t) {
  const double fall = std::sqrt(2 * h / g), period = 2 * fall;
  const double since = std::abs(std::remainder(t, period));
  return h - 0.5 * g * since * since;
}

TEST(Scenes, ElasticBallKeepsItsHeightAtAnyTargetStep) {
  for (const char* step : {"run.step=0.1", "run.step=0.01", "run.step=0.001"}) {
    const SceneRun run = run_scene("bouncing_ball.yaml", {step});
    expect_trusted(run);
    const int ball = run.body("ball");
    double worst = 0;
    for (const State& state : run.states) {
      worst = std::max(worst, std::abs(state.position(ball).z() - 0.1 - bouncing_height(1, state.t)));
    }
    // Eleven impacts, each with the rounding of t and v: far below the goal of 1e-9.
    EXPECT_LT(worst, 1e-12) << step;
  }
}

TEST(Scenes, BouncesWithRestitutionEndAtTheLimitTime) {
  // t₀ (1 + e)/(1 - e): the first fall and the geometric series of flights.
  for (const auto& [file, e] :
       {std::pair{"bouncing_ball_e05.yaml", 0.5}, std::pair{"bouncing_ball_e09.yaml", 0.9}}) {
    const SceneRun run = run_scene(file);
    expect_trusted(run);
    const double limit = std::sqrt(2 / g) * (1 + e) / (1 - e);
    double found = 0;
    for (const MotionEvent& event : run.events) {
      if (event.kind == MotionEvent::Kind::rest) found = event.time;
    }
    EXPECT_NEAR(found, limit, 1e-9) << file;
    EXPECT_EQ(run.end_of("ball").velocity.norm(), 0) << file;
    EXPECT_NEAR(run.end_of("ball").position.z(), 0.1, 1e-9) << file;
  }
}

TEST(Scenes, TennisRacketFlipsAtTheTimesOfTheEllipticFunctions) {
  const SceneRun run = run_scene("tennis_racket.yaml", {"run.duration=6.059041085650863"});
  expect_trusted(run);
  const State& state = run.result.state;
  const Mat3 R = rotation_matrix(state.orientation(0));
  const Vec3 w_B = R.transpose() * angular_velocity(*run.scene.model, state, 0);
  EXPECT_NEAR(w_B.y(), 0, 1e-11);
  EXPECT_EQ(state.angular_momentum(0), run.states.front().angular_momentum(0));
}

TEST(Scenes, TurntableBallReturnsToItsStart) {
  const SceneRun run = run_scene("turntable.yaml");
  expect_trusted(run);
  const int ball = run.body("ball");
  for (const State& state : run.states) {
    const Vec3 from_centre = state.position(ball) - Vec3(0.475, 0, 0.1);
    EXPECT_NEAR(from_centre.norm(), 0.525, 1e-10);
  }
  EXPECT_LT((run.end_of("ball").position - Vec3(1, 0, 0.1)).norm(), 1e-10);
}

TEST(Scenes, SlidingBallRollsFromTheInstantThatSlipEnds) {
  const SceneRun run = run_scene("slide_to_roll.yaml");
  expect_trusted(run);
  double transition = 0;
  for (const MotionEvent& event : run.events) {
    if (event.kind == MotionEvent::Kind::slip_to_stick) transition = event.time;
  }
  EXPECT_NEAR(transition, 7 / (3.5 * 0.2 * g), 1e-9);
  EXPECT_NEAR(run.end_of("ball").velocity.x(), 3, 1e-11);
  EXPECT_NEAR(run.end_of("ball").angular_velocity.y(), 30, 1e-10);
}

TEST(Scenes, BlockBelowTheFrictionAngleDoesNotCreep) {
  const SceneRun run = run_scene("ramp_stick.yaml");
  expect_trusted(run);
  EXPECT_LE((run.end_of("block").position - Vec3(0, 0, 0.1)).norm(), 1e-12);
}

TEST(Scenes, BlockOnPlainMicroCollisionsCreepsDownTheSlopeAndPatchedStays) {
  const SceneRun plain = run_scene("ramp_creep.yaml");
  expect_trusted(plain);
  // A train of some ninety collisions: what a compiler rounds otherwise may shift a flight.
  EXPECT_NEAR(plain.end_of("block").position.x(), 0.0193, 5e-4);
  const SceneRun patched = run_scene("ramp_creep.yaml", {"method.micro_collisions=patched"});
  expect_trusted(patched);
  EXPECT_LE(std::abs(patched.end_of("block").position.x()), 1e-7);
}

TEST(Scenes, BlockSlidesAlongTheFallLine) {
  const SceneRun run = run_scene("ramp_slide.yaml");
  expect_trusted(run);
  const double angle = 20 * M_PI / 180;
  const double acceleration = g * (std::sin(angle) - 0.99 * std::tan(angle) * std::cos(angle));
  const Vec3 expected = 0.5 * acceleration * 100 * Vec3(std::cos(M_PI / 6), std::sin(M_PI / 6), 0);
  EXPECT_NEAR(expected.norm(), 1.67761, 1e-5);
  // Constant acceleration along a line: what is left is the tolerance of the step control, 1e-10 a step.
  EXPECT_LT((run.end_of("block").position - Vec3(0, 0, 0.1) - expected).norm(), 1e-9);
}

TEST(Scenes, CradlePassesTheBallOn) {
  const SceneRun run = run_scene("cradle.yaml");
  expect_trusted(run);
  for (int i = 1; i <= 5; ++i) {
    EXPECT_NEAR(run.end_of("ball" + std::to_string(i)).velocity.x(), i == 5 ? 1 : 0, 1e-14);
  }
  EXPECT_EQ(run.audit().report.impacts, 4);
}

TEST(Scenes, TouchingCradlePassesTheBallOnToo) {
  for (const char* law : {"reflections", "sequential"}) {
    const SceneRun run = run_scene("touching_cradle.yaml", {std::string("method.simultaneous=") + law});
    expect_trusted(run);
    for (int i = 1; i <= 5; ++i) {
      EXPECT_NEAR(run.end_of("ball" + std::to_string(i)).velocity.x(), i == 5 ? 1 : 0, 1e-15) << law;
    }
  }
}

TEST(Scenes, TouchingCradleMovesOffAsOneBlockUnderNewtonsLawOnAllContacts) {
  const SceneRun run = run_scene("touching_cradle.yaml", {"method.simultaneous=lcp"});
  expect_trusted(run);
  for (int i = 1; i <= 5; ++i) {
    EXPECT_NEAR(run.end_of("ball" + std::to_string(i)).velocity.x(), i == 1 ? -0.6 : 0.4, 1e-14);
  }
}

TEST(Scenes, BallThatFallsOnTwoRisesToElevenTwentyFifthsSquared) {
  const SceneRun run = run_scene("ball_on_two.yaml");
  expect_trusted(run);
  const double h = 0.5, fall = std::sqrt(2 * h / g), v = g * fall, since = 0.6 - fall;
  // The time of impact is known to 1e-12 s.
  const Audit::BodyEnd &ball = run.end_of("ball"), &left = run.end_of("left"), &right = run.end_of("right");
  EXPECT_LT((ball.velocity - Vec3(0, 0, 11.0 / 25 * v - g * since)).norm(), 1e-11);
  for (const double side : {-1.0, 1.0}) {
    const Vec3 expected(side * 6 * std::sqrt(3.0) / 25 * v, 0, 12.0 / 25 * v - g * since);
    EXPECT_LT(((side < 0 ? left : right).velocity - expected).norm(), 1e-11);
  }
  double highest = 0;
  for (const State& state : run.states) {
    if (state.t > fall) highest = std::max(highest, state.position(run.body("ball")).z());
  }
  // Output every 0.01 s: the top is missed by g (0.005)²/2 at most.
  EXPECT_NEAR(highest - 0.2 * std::cos(M_PI / 6) - 0.1, h * 121 / 625, 0.5 * g * 0.005 * 0.005);
}

TEST(Scenes, BilliardsBreakIsSymmetricAndKeepsEnergyAndMomentum) {
  const SceneRun run = run_scene("billiards.yaml");
  expect_trusted(run);
  EXPECT_NEAR(run.audit().final.total(), 2.125, 1e-14);
  const Momentum momentum = total_momentum(*run.scene.model, run.result.state);
  EXPECT_LT((momentum.linear - Vec3(0.85, 0, 0)).norm(), 1e-14);
  // ball2 and ball3 stand on either side of the line of the cue ball.
  const Vec3 left = run.end_of("ball2").position, right = run.end_of("ball3").position;
  EXPECT_NEAR(left.x(), right.x(), 1e-12);
  EXPECT_NEAR(left.y(), -right.y(), 1e-12);
}

TEST(Scenes, GasKeepsItsEnergyWithoutOverlap) {
  const SceneRun run = run_scene("gas.yaml");
  expect_trusted(run);
  EXPECT_NEAR(run.audit().final.total() / run.audit().initial.total(), 1, 1e-12);
  EXPECT_GT(run.audit().report.impacts, 2000);
  for (const State& state : run.states) {
    EXPECT_TRUE(find_overlaps(*run.scene.model, state, run.scene.method.contact_tolerance).empty());
  }
}

TEST(Scenes, BulletBouncesOffTheThinPlate) {
  const SceneRun run = run_scene("bullet.yaml");
  expect_trusted(run);
  const int ball = run.body("ball");
  double first = 0;
  for (const MotionEvent& event : run.events) {
    const bool is_ball = event.body_A == ball || event.body_B == ball;
    if (is_ball && event.kind == MotionEvent::Kind::impact && first == 0) first = event.time;
  }
  EXPECT_NEAR(first, 0.00094, 1e-12);
  EXPECT_NEAR(run.end_of("ball").velocity.x(), -1000, 1e-9);
  EXPECT_LT(run.end_of("rod").position.x(), 1);
}

TEST(Scenes, DominoesStrikeOneAnotherInTurn) {
  const SceneRun run = run_scene("dominoes.yaml");
  expect_trusted(run);
  double strike = 0;
  for (const MotionEvent& event : run.events) {
    if (event.kind == MotionEvent::Kind::impact && strike == 0) strike = event.time;
  }
  // A domino that turns about its edge without slip, integrated with a tolerance of 1e-10 a step.
  EXPECT_NEAR(strike, 0.0770237950567839, 1e-9);
  EXPECT_GT(run.end_of("domino8").angular_velocity.norm() + std::abs(run.end_of("domino8").orientation.y()),
            1e-3);
}

TEST(Scenes, EllComesToRest) {
  const SceneRun run = run_scene("l_shape.yaml");
  expect_trusted(run);
  EXPECT_LT(run.audit().final.kinetic, 1e-3);
  EXPECT_LT(run.audit().final.total(), run.audit().initial.total());
}

TEST(Scenes, BoxesInAPenComeToRestWithoutGainingEnergy) {
  const SceneRun run = run_scene("pile.yaml");
  expect_trusted(run);
  EXPECT_LE(run.audit().max_increase, 1e-6 * run.audit().initial.total());
  for (const std::string box : {"box[0,0,0]", "box[0,1,0]", "box[1,0,0]", "box[1,1,0]"}) {
    EXPECT_LE(run.end_of(box).velocity.norm(), 1e-12) << box;
  }
  for (const State& state : run.states) {
    EXPECT_TRUE(find_overlaps(*run.scene.model, state, run.scene.method.contact_tolerance).empty())
        << state.t;
  }
}

TEST(Scenes, RocksFallWithoutOverlap) {
  const SceneRun run = run_scene("rocks.yaml", {"run.duration=1"});
  expect_trusted(run);
  for (const State& state : run.states) {
    EXPECT_TRUE(find_overlaps(*run.scene.model, state, run.scene.method.contact_tolerance).empty())
        << state.t;
  }
}

}  // namespace
}  // namespace rigor::test::scenes_test
