// Stacks, arches and other scenes whose contacts last, against closed forms.

#include "laws/scene_runs.hpp"

#include "rigor/math/rotation.hpp"
#include "rigor/sim/audit/contact_snapshot.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace rigor::test::resting_scenes_test {
namespace {

constexpr double g = 9.81;

void expect_trusted(const SceneRun& run) {
  EXPECT_EQ(run.audit().report.reason, StopReason::reached_end) << run.audit().report.detail;
  for (const std::string& violation : run.audit().violations) ADD_FAILURE() << violation;
}

/// Largest displacement of a body from the first state to the last [m].
double drift(const SceneRun& run) {
  double worst = 0;
  for (int i = 0; i < run.scene.model->body_count(); ++i)
    worst = std::max(worst, (run.states.back().position(i) - run.states.front().position(i)).norm());
  return worst;
}

/// Force of body a on body b at the end of the run [N].
Vec3 force_between(const SceneRun& run, int a, int b) {
  Vec3 sum = Vec3::Zero();
  for (const TouchingPoint& point : contact_snapshot(*run.scene.model, run.scene.method, run.result.state))
    if (point.body_A == a && point.body_B == b) sum += point.force_W;
  return sum;
}

const std::array<std::vector<std::string>, 3> kChoices = {
    std::vector<std::string>{"method.resting=motion-space"},
    std::vector<std::string>{"method.resting=contact-space", "method.lcp=dantzig"},
    std::vector<std::string>{"method.resting=contact-space", "method.lcp=lemke"}};

void expect_stack_stands(const SceneRun& run, int count) {
  expect_trusted(run);
  EXPECT_EQ(drift(run), 0) << count;
  EXPECT_LE(run.audit().report.max_penetration, 1e-14);
  for (const Audit::BodyEnd& body : run.audit().bodies) EXPECT_TRUE(body.velocity.isZero(0)) << body.name;
  const double weight = 1000 * 0.008 * g;
  for (int k = 0; k < count; ++k) {
    const Vec3 force = force_between(run, k, k + 1);
    EXPECT_LE((force - Vec3(0, 0, (count - k) * weight)).norm(), 1e-12 * (count - k) * weight) << count << k;
  }
}

TEST(RestingScenes, StacksStandAndEveryCubeCarriesWhatIsAboveIt) {
  for (const auto& [file, count] :
       {std::pair{"stack_10.yaml", 10}, std::pair{"stack_20.yaml", 20}, std::pair{"stack_50.yaml", 50}})
    expect_stack_stands(run_scene(file), count);
}

TEST(RestingScenes, StacksOfThreeAndOfAHundredCubesStandForAHundredSeconds) {
  for (const int count : {3, 100}) {
    const std::string counts = "bodies.cube.repeat.count=[1,1," + std::to_string(count) + "]";
    expect_stack_stands(run_scene("stack_50.yaml", {counts, "run.duration=100", "run.output_interval=10",
                                                    "method.scheme=event-driven"}),
                        count);
  }
}

TEST(RestingScenes, AStackCarriesAHundredfoldAndAThousandfoldWeightOnTop) {
  for (const double ratio : {100.0, 1000.0}) {
    const SceneRun run =
        run_scene("stack_heavy_top.yaml", {"bodies.top.density=" + std::to_string(1000 * ratio)});
    expect_trusted(run);
    EXPECT_EQ(drift(run), 0);
    const double weight = 1000 * 0.008 * g;
    for (int k = 0; k < 10; ++k) {
      const double above = (9 - k + ratio) * weight;
      EXPECT_LE((force_between(run, k, k + 1) - Vec3(0, 0, above)).norm(), 1e-12 * above) << k;
    }
  }
}

TEST(RestingScenes, EveryChoiceOfTheMethodGivesTheSameMotion) {
  for (const auto& [file, duration] :
       {std::pair{"stack_10.yaml", "1"}, std::pair{"table.yaml", "1"}, std::pair{"ramp_stick.yaml", "1"},
        std::pair{"ramp_slide.yaml", "1"}, std::pair{"slide_to_roll.yaml", "1"},
        std::pair{"wedge.yaml", "0.3"}, std::pair{"arch_thick.yaml", "0.1"},
        std::pair{"dominoes.yaml", "0.2"}, std::pair{"pile.yaml", "0.35"}}) {
    std::vector<SceneRun> runs;
    for (std::vector<std::string> choice : kChoices) {
      choice.push_back(std::string("run.duration=") + duration);
      runs.push_back(run_scene(file, choice));
      expect_trusted(runs.back());
    }
    for (std::size_t k = 1; k < runs.size(); ++k) {
      for (std::size_t i = 0; i < runs[0].audit().bodies.size(); ++i) {
        const Audit::BodyEnd &one = runs[0].audit().bodies[i], &other = runs[k].audit().bodies[i];
        EXPECT_LE((one.position - other.position).norm(), 1e-9) << file << ", " << kChoices[k].back();
        EXPECT_LE((one.velocity - other.velocity).norm(), 1e-8) << file << ", " << kChoices[k].back();
      }
    }
  }
}

TEST(RestingScenes, OverhangStandsUpToTheHarmonicSumAndTopplesBeyond) {
  const SceneRun stands = run_scene("overhang.yaml");
  expect_trusted(stands);
  EXPECT_EQ(drift(stands), 0);
  // The same with 1.001 of the offsets 1/10, 1/8, 1/6, 1/4, 1/2 from below.
  std::vector<std::string> offsets = {"run.duration=0.2"};
  double end = 0;
  for (int k = 1; k <= 5; ++k) {
    end += 1.001 / (2 * (6 - k));
    offsets.push_back("bodies.block" + std::to_string(k) + ".position.0=" + std::to_string(end - 0.5));
  }
  EXPECT_GT(drift(run_scene("overhang.yaml", offsets)), 1e-6);
}

TEST(RestingScenes, ArchOfEightStonesStandsJustAboveTheCriticalThicknessAndFallsBelow) {
  const SceneRun stands = run_scene("arch.yaml");
  expect_trusted(stands);
  EXPECT_EQ(drift(stands), 0);
  // At the springings each side carries half the weight.
  double weight = 0;
  for (int i = 1; i <= 8; ++i) weight += stands.scene.model->body(i).mass * g;
  EXPECT_NEAR(force_between(stands, 0, 1).z(), 0.5 * weight, 1e-11 * weight);
  EXPECT_NEAR(force_between(stands, 0, 8).z(), 0.5 * weight, 1e-11 * weight);
  const SceneRun falls = run_scene("arch_thin.yaml", {"run.duration=0.5"});
  EXPECT_GT(drift(falls), 1e-3);
}

TEST(RestingScenes, ArchSlidesWhereFrictionIsBelowTheCriticalOne) {
  const SceneRun stands = run_scene("arch_thick.yaml");
  expect_trusted(stands);
  EXPECT_EQ(drift(stands), 0);
  const SceneRun slides =
      run_scene("arch_thick.yaml", {"materials.stone.friction=0.3011207", "run.duration=0.1"});
  EXPECT_GT(drift(slides), 1e-6);
}

TEST(RestingScenes, ArchOfTwentyStonesStands) {
  const SceneRun run = run_scene("arch_20.yaml");
  expect_trusted(run);
  EXPECT_EQ(drift(run), 0);
}

TEST(RestingScenes, LogsStandOnEachOtherDownToTheFrictionOfFifteenDegrees) {
  const SceneRun stands = run_scene("cylinder_pyramid.yaml");
  expect_trusted(stands);
  EXPECT_EQ(drift(stands), 0);
  for (const char* less : {"pairs.0.friction=0.26527", "pairs.1.friction=0.088423"}) {
    const SceneRun falls = run_scene("cylinder_pyramid.yaml", {less, "run.duration=0.1"});
    EXPECT_GT(drift(falls), 1e-5) << less;
  }
}

TEST(RestingScenes, FourLegsCarryTheTableAndWhatStandsOnIt) {
  const SceneRun run = run_scene("table.yaml");
  expect_trusted(run);
  EXPECT_EQ(drift(run), 0);
  EXPECT_NEAR(force_between(run, 0, 1).z(), 14 * g, 1e-11 * g);
  EXPECT_NEAR(force_between(run, 1, 2).z(), 4 * g, 1e-11 * g);
}

TEST(RestingScenes, ABlockOnARampNeitherCreepsNorSticksWhereItMustNot) {
  // 20 degrees, the fall line along an axis and 30 degrees off; 1.01 and 0.99 of the friction that holds.
  const double slope = 20 * M_PI / 180;
  for (const double heading : {0.0, M_PI / 6}) {
    const Vec3 gravity =
        g * Vec3(std::sin(slope) * std::cos(heading), std::sin(slope) * std::sin(heading), -std::cos(slope));
    char text[120];
    std::snprintf(text, sizeof text, "world.gravity=[%.17g, %.17g, %.17g]", gravity.x(), gravity.y(),
                  gravity.z());
    const auto displacement = [&](double factor) {
      char friction[60];
      std::snprintf(friction, sizeof friction, "materials.wood.friction=%.17g", factor * std::tan(slope));
      return Vec3(run_scene("ramp_stick.yaml", {text, friction}).end_of("block").position - Vec3(0, 0, 0.1));
    };
    EXPECT_LE(displacement(1.01).norm(), 1e-12);
    EXPECT_NEAR(displacement(0.99).norm(), 0.5 * 100 * g * 0.01 * std::sin(slope), 1e-9);
  }
}

TEST(RestingScenes, ABlockDoesNotCreepInAThousandSecondsWhateverTheStep) {
  // 25 degrees, friction 0.6.
  const double slope = 25 * M_PI / 180;
  char gravity[120];
  std::snprintf(gravity, sizeof gravity, "world.gravity=[%.17g, 0, %.17g]", g * std::sin(slope),
                -g * std::cos(slope));
  for (const char* step : {"run.step=0.01", "run.step=1"}) {
    const SceneRun run = run_scene("ramp_stick.yaml", {gravity, "materials.wood.friction=0.6", step,
                                                       "run.duration=1000", "run.output_interval=100"});
    expect_trusted(run);
    EXPECT_LE(drift(run), 1e-12) << step;
  }
}

TEST(RestingScenes, ACardHouseStandsAndItsTopPairSlidesApartBelowTheCriticalFriction) {
  const SceneRun stands = run_scene("card_house.yaml");
  expect_trusted(stands);
  EXPECT_EQ(drift(stands), 0);
  // All the weight is on the table.
  double weight = 0, carried = 0;
  for (int i = 1; i < stands.scene.model->body_count(); ++i) {
    weight += stands.scene.model->body(i).mass * g;
    carried += force_between(stands, 0, i).z();
  }
  EXPECT_NEAR(carried, weight, 1e-11 * weight);
  const SceneRun slides =
      run_scene("card_house.yaml", {"materials.card.friction=0.1267", "run.duration=0.0015"});
  EXPECT_GT(drift(slides), 1e-9);
}

TEST(RestingScenes, AWedgeSlidesAwayFromUnderABlock) {
  const SceneRun run = run_scene("wedge.yaml");
  expect_trusted(run);
  const double a = 35 * M_PI / 180, m = 2, M = 5;
  const double normal = m * M * g * std::cos(a) / (M + m * std::sin(a) * std::sin(a));
  EXPECT_NEAR(normal, 14.20273977291671, 1e-13);
  EXPECT_NEAR(force_between(run, 1, 2).norm(), normal, 1e-12);
  const double wedge = normal * std::sin(a) / M;
  EXPECT_NEAR(run.end_of("wedge").position.x(), -0.5 * wedge * 0.09, 1e-12);
}

TEST(RestingScenes, BallsRollOnAPushedPlateTheSameWayInEveryDirection) {
  for (const char* force : {"forces.0.force=[75, 129.9038105676658, 0]", "forces.0.force=[0, 150, 0]"}) {
    const SceneRun run = run_scene("rolling_plate.yaml", {force});
    expect_trusted(run);
    // 150 - 0.4 * 35 g = (10 + 25 * 2/7) a.
    const double plate = (150 - 0.4 * 35 * g) / (10 + 50.0 / 7);
    EXPECT_NEAR(run.end_of("plate").velocity.norm(), plate, 1e-9 * plate);
    for (const Audit::BodyEnd& body : run.audit().bodies) {
      if (body.name.starts_with("ball")) {
        EXPECT_NEAR(body.velocity.norm(), plate * 2 / 7, 1e-9 * plate) << body.name;
      }
    }
  }
}

TEST(RestingScenes, BodiesRollDownASlopeAsTheirInertiaSays) {
  const SceneRun run = run_scene("incline_race.yaml");
  expect_trusted(run);
  // a = g sin / (1 + k) with k = I / m R².
  for (const auto& [name, k] : {std::pair{"solid", 0.4}, std::pair{"hollow", 2.0 / 3},
                                std::pair{"cylinder", 0.5}, std::pair{"hoop", 1.0}}) {
    const double a = 0.5 * g / (1 + k);
    EXPECT_NEAR(run.end_of(name).velocity.x(), a, 1e-11 * a) << name;
    EXPECT_NEAR(run.end_of(name).angular_velocity.y() * 0.1, a, 1e-11 * a) << name;
  }
  const double normal = g * std::cos(M_PI / 6);
  EXPECT_NEAR(run.end_of("slipping").velocity.x(), 0.5 * g - 0.1 * normal, 1e-11);
  EXPECT_NEAR(run.end_of("slipping").angular_velocity.y() * 0.1, 0.1 * normal / 0.4, 1e-11);
}

TEST(RestingScenes, ABowlingBallRollsAfterTwoSeventhsOfItsSpeed) {
  const SceneRun run = run_scene("bowling.yaml");
  expect_trusted(run);
  double rolls = 0;
  for (const MotionEvent& event : run.events)
    if (event.kind == MotionEvent::Kind::slip_to_stick) rolls = event.time;
  const double expected = 2 * 8 / (7 * 0.12 * g), speed = 8 * 5.0 / 7;
  EXPECT_NEAR(expected, 1.941653317800107, 1e-14);
  EXPECT_NEAR(rolls, expected, 1e-9);
  EXPECT_NEAR(run.end_of("ball").velocity.x(), speed, 1e-10);
  EXPECT_NEAR(run.end_of("ball").position.x(), 0.5 * (8 + speed) * expected + speed * (3 - expected), 1e-9);
}

TEST(RestingScenes, ARodOnIceFallsStraightDown) {
  const SceneRun run = run_scene("falling_rod.yaml");
  expect_trusted(run);
  const Audit::BodyEnd& rod = run.end_of("rod");
  EXPECT_LE(rod.position.head<2>().norm(), 1e-13);
  // Energy: ½ (I + m (L/2)² sin²θ) ω² = m g (L/2) (cos 5° - cos θ).
  const double cosine = 2 * rod.position.z(), sine_squared = 1 - cosine * cosine;
  const double rate =
      std::sqrt(2 * g * 0.5 * (std::cos(5 * M_PI / 180) - cosine) / (1.0 / 12 + 0.25 * sine_squared));
  EXPECT_NEAR(rod.angular_velocity.norm(), rate, 1e-7);
}

TEST(RestingScenes, EulersDiskWhirlsAHundredTimesAtTheSameTilt) {
  // ω along the diameter through the contact: Ω² = 4 g / (R sin α) for k = 1/4.
  EXPECT_NEAR(std::sqrt(4 * g / (0.1 * std::sin(M_PI / 18))), 47.536738819418, 1e-11);
  const SceneRun run = run_scene("euler_disk.yaml");
  expect_trusted(run);
  const Vec3 axis = rotation_matrix(run.result.state.orientation(1)).col(2);
  // 1e-10 a step of the integrator, over 14000 steps.
  EXPECT_NEAR(std::acos(axis.z()), M_PI / 18, 1e-8);
  EXPECT_LE((run.end_of("disk").position - Vec3(0, 0, 0.1 * std::sin(M_PI / 18))).norm(), 1e-8);
}

TEST(RestingScenes, ABlockRocksOnWithHousnersRatio) {
  // The times of the impact and of the states beside it; between, the rate changes by p² α = 1.424 rad/s².
  constexpr double upright = 0.4908644578495588, before = 0.4582398511156162, ratio = 0.9423076923076923;
  const double fall = 3 * g / (4 * std::sqrt(1.04)) * std::atan(0.2);
  const auto rate_at = [](double t) {
    return std::abs(run_scene("rocking_block.yaml", {"run.duration=" + std::to_string(t)})
                        .end_of("block")
                        .angular_velocity.y());
  };
  EXPECT_NEAR(rate_at(0.490863), before - fall * (upright - 0.490863), 1e-7);
  // The impact is noticed within the tolerance of contact, 1e-8 m after it.
  EXPECT_NEAR(rate_at(0.490867), before * ratio - fall * (0.490867 - upright), 1e-6);
  const SceneRun run = run_scene("rocking_block.yaml", {"run.duration=1.1"});
  expect_trusted(run);
  double peak = 0;
  for (const State& state : run.states)
    if (state.t > 0.5) peak = std::max(peak, 2 * std::asin(std::abs(state.orientation(1).y())));
  // Outputs every 5 ms miss the top by half of p² (α - θ) (2.5 ms)² at most.
  EXPECT_NEAR(peak, 0.08333911316435469, 3e-6);
}

}  // namespace
}  // namespace rigor::test::resting_scenes_test
