#include "rigor/view/page/page_frames.hpp"

#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/model_builder.hpp"
#include "rigor/sim/simulation.hpp"
#include "rigor/view/page/page_run.hpp"
#include "view/frame_reading.hpp"
#include "view/page_reading.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

namespace rigor::page_frames_test {
namespace {

BodyDescription body_of(const std::string& name, const Shape& shape, const Vec3& x) {
  BodyDescription body;
  body.name = name;
  body.p_WU = x;
  body.shapes.push_back({shape, Vec3::Zero(), Quat::Identity(), "", ""});
  return body;
}

/// A floor and n boxes that can be put anywhere.
std::shared_ptr<const Model> boxes(int count) {
  ModelBuilder builder;
  BodyDescription floor = body_of("floor", HalfSpace{Vec3::UnitZ(), -1}, Vec3::Zero());
  floor.motion = MotionType::fixed;
  builder.add_body(floor);
  for (int i = 0; i < count; ++i) {
    builder.add_body(body_of("box" + std::to_string(i), Box{Vec3(0.1, 0.15, 0.2)}, Vec3(0.5 * i, 0, 0)));
  }
  return builder.build();
}

/// Frames with every body in free rotation and translation.
std::vector<State> tumbling(const Model& model, int count) {
  std::vector<State> states;
  for (int k = 0; k < count; ++k) {
    State state = make_initial_state(model);
    state.t = 0.01 * k;
    for (int i = 1; i < model.body_count(); ++i) {
      const Vec3 v(0.3, -0.2 * i, 1 - 9.81 * state.t), w(4, -3 + i, 2);
      const Vec3 x = state.position(i) + Vec3(0.3, -0.2 * i, 1 - 4.905 * state.t) * state.t;
      const Quat q = rotation_exp(w * state.t);
      const Mat3 R = rotation_matrix(q);
      const Body& body = model.body(i);
      state.set_body(i, x, q, body.mass * v, R * body.moments.asDiagonal() * R.transpose() * w);
    }
    states.push_back(state);
  }
  return states;
}

/// All chunks of the states.
std::vector<PageBlock> chunks_of(PageFrames& frames, const std::vector<State>& states) {
  std::vector<PageBlock> chunks;
  const auto keep = [&chunks](const std::optional<PagePacking>& packing) {
    if (packing) chunks.push_back((*packing)());
  };
  for (const State& state : states) keep(frames.add(phases_of(state)));
  keep(frames.finish());
  return chunks;
}

TEST(PageFrames, WhatIsReadBackIsTheMotionToTheStatedErrors) {
  const std::shared_ptr<const Model> model = boxes(3);
  // More than one chunk.
  const std::vector<State> states = tumbling(*model, 600);
  const PageScale scale = page_scale(*model, states[0]);
  PageFrames frames(*model, scale);
  const std::vector<PageBlock> chunks = chunks_of(frames, states);
  EXPECT_EQ(frames.frame_count(), 600);
  ASSERT_GT(chunks.size(), 1u);
  const test::ReadFrames read = test::read_frames(chunks, scale);
  ASSERT_EQ(read.x.size(), states.size());
  for (std::size_t k = 0; k < states.size(); ++k) {
    for (int i = 1; i < 4; ++i) {
      const std::size_t place = static_cast<std::size_t>(i - 1);
      const auto largest = [](const Vec3& v) { return v.cwiseAbs().maxCoeff(); };
      // Half a step, and the rounding of doubles.
      EXPECT_LE(largest(read.x[k][place] - states[k].position(i)), 0.5 * scale.position_step * (1 + 1e-9));
      EXPECT_LE(rotation_angle_between(read.q[k][place], states[k].orientation(i)), packing_error);
      EXPECT_LE(largest(read.v[k][place] - linear_velocity(*model, states[k], i)), 0.5 * read.speed_step);
      EXPECT_LE(largest(read.w[k][place] - angular_velocity(*model, states[k], i)), 0.5 * read.spin_step);
    }
  }
}

TEST(PageFrames, ThePositionErrorIsAtMostAHundredThousandthOfTheExtent) {
  for (const int count : {1, 3, 100}) {
    const std::shared_ptr<const Model> model = boxes(count);
    const PageScale scale = page_scale(*model, make_initial_state(*model));
    // From the first box's far end to the last one's, each as large as the ball around it.
    const double radius = Vec3(0.1, 0.15, 0.2).norm();
    EXPECT_NEAR(scale.extent, std::hypot(0.5 * (count - 1) + 2 * radius, 2 * radius, 2 * radius), 1e-12);
    EXPECT_LE(0.5 * scale.position_step, 1e-5 * scale.extent);
  }
}

TEST(PageFrames, AnyOrientationIsPackedWithinItsError) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  for (int sample = 0; sample < 20000; ++sample) {
    // Some near the places where the largest component changes.
    Quat q(normal(random), normal(random), normal(random), normal(random));
    if (sample % 4 == 0) q = Quat(0.5, -0.5, 0.5 + 1e-6 * normal(random), 0.5);
    q.normalize();
    const PackedQuaternion p = packed(q);
    double all[4], rest = 1;
    for (int c = 0, place = 0; c < 4; ++c) {
      if (c == p.largest) continue;
      const std::int64_t other = p.others[static_cast<std::size_t>(place++)];
      EXPECT_LE(std::abs(other), 32767);
      all[c] = static_cast<double>(other) * std::sqrt(0.5) / 32767;
      rest -= all[c] * all[c];
    }
    all[p.largest] = std::sqrt(std::max(0.0, rest));
    EXPECT_LE(rotation_angle_between(Quat(all[0], all[1], all[2], all[3]), q), packing_error);
  }
}

/// Bytes of a run in a page, as text, for a moving body and frame.
double bytes_per_body_frame(const Scene& scene) {
  std::optional<PageRun> run;
  double frames = 0;
  const RunResult result =
      run_simulation(scene.model, scene.method, scene.run, std::nullopt,
                     [&](const State& state, const AdvanceReport& since, const Auditor& auditor) {
                       if (!run) run.emplace(scene, state);
                       run->add(state, since, auditor.energy());
                       ++frames;
                       return true;
                     });
  double bytes = 0, moving = 0;
  for (const PageBlock& block : run->finish(result.audit))
    bytes += static_cast<double>(seven_bit_text(block.deflated).size());
  for (const Body& body : scene.model->bodies()) moving += body.motion == MotionType::fixed ? 0 : 1;
  return bytes / (moving * frames);
}

double bytes_per_body_frame(const std::string& scene_file, double interval) {
  Scene scene = read_scene(std::string(RIGOR_SOURCE_DIR) + "/scenes/" + scene_file);
  scene.run.output_interval = interval;
  return bytes_per_body_frame(scene);
}

TEST(PageFrames, AGasOfBallsWithAllItsImpactsTakesLessThanTwelveBytesABodyAFrame) {
  EXPECT_LT(bytes_per_body_frame("gas.yaml", 0.02), 12);
}

TEST(PageFrames, ASmallSceneWithManyImpactsAndContactsTakesLessThanTwelveBytesABodyAFrame) {
  EXPECT_LT(bytes_per_body_frame("dominoes.yaml", 0.01), 12);
}

/// A pen into which balls fall, with up to two contacts each.
Scene pen_of_balls() {
  return parse_scene(R"(
rigor: 1
run: {duration: 1, step: 0.016666666666666666, output_interval: 0.02}
method: {scheme: time-stepping, solver: substep}
materials: [{name: wood, friction: 0.5, restitution: 0.3}]
bodies:
  - {name: floor, motion: static, shapes: [{type: plane, normal: [0, 0, 1], offset: 0, material: wood}]}
  - name: pen
    motion: static
    shapes:
      - {type: box, size: [0.2, 3, 3], position: [1.4, 0, 1.5], material: wood}
      - {type: box, size: [0.2, 3, 3], position: [-1.4, 0, 1.5], material: wood}
      - {type: box, size: [3, 0.2, 3], position: [0, 1.4, 1.5], material: wood}
      - {type: box, size: [3, 0.2, 3], position: [0, -1.4, 1.5], material: wood}
  - name: ball
    position: [-1.08, -1.08, 0.3]
    mass: 3
    shapes: [{type: sphere, radius: 0.1, material: wood}]
    repeat: {count: [8, 8, 16], spacing: [0.27, 0.27, 0.24], jitter: 0.02}
)",
                     "pen.yaml", ".");
}

/// The worst second of it, in which all are struck all the time; with the rest that follows it is less than
/// half.
TEST(PageFrames, ACrowdThatFallsIntoAPenTakesLessThanFifteenBytesABodyAFrame) {
  EXPECT_LT(bytes_per_body_frame(pen_of_balls()), 15);
}

TEST(PageFrames, ACrowdIsReadBackToTheErrorsThatItsScaleStates) {
  const Scene scene = pen_of_balls();
  const std::vector<State> states = tumbling(*scene.model, 20);
  const PageScale scale = page_scale(*scene.model, states[0]);
  ASSERT_LT(scale.orientation_parts, 32767);
  PageFrames frames(*scene.model, scale);
  const test::ReadFrames read = test::read_frames(chunks_of(frames, states), scale);
  ASSERT_EQ(read.x.size(), states.size());
  std::size_t moving = 0;
  for (int i = 0; i < scene.model->body_count(); ++i) {
    if (scene.model->body(i).motion == MotionType::fixed) continue;
    const auto largest = [](const Vec3& v) { return v.cwiseAbs().maxCoeff(); };
    for (std::size_t k = 0; k < states.size(); ++k) {
      EXPECT_LE(largest(read.x[k][moving] - states[k].position(i)), 0.5 * scale.position_step * (1 + 1e-9));
      EXPECT_LE(rotation_angle_between(read.q[k][moving], states[k].orientation(i)),
                packing_error_of(scale.orientation_parts));
      EXPECT_LE(largest(read.v[k][moving] - linear_velocity(*scene.model, states[k], i)),
                0.5 * read.speed_step);
    }
    ++moving;
  }
  // No surface is farther off than two steps of positions.
  EXPECT_LE(packing_error_of(scale.orientation_parts) * 0.1, 2 * scale.position_step * 1.001);
}

TEST(PageRun, OfTooManyEventsTheStrongestStayInTheirOrder) {
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  std::vector<MotionEvent> events(500);
  for (std::size_t i = 0; i < events.size(); ++i) {
    events[i].time = 0.01 * static_cast<double>(i);
    events[i].j_W = i % 5 == 0 ? Vec3(1, 0, 0) : Vec3(normal(random), normal(random), normal(random));
  }
  EXPECT_EQ(strongest_events(events, 500).size(), 500u);
  const std::vector<MotionEvent> kept = strongest_events(events, 100);
  ASSERT_EQ(kept.size(), 100u);
  // The same by sorting all of them.
  std::vector<MotionEvent> sorted = events;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const MotionEvent& a, const MotionEvent& b) { return a.j_W.norm() > b.j_W.norm(); });
  sorted.resize(100);
  std::sort(sorted.begin(), sorted.end(),
            [](const MotionEvent& a, const MotionEvent& b) { return a.time < b.time; });
  for (std::size_t i = 0; i < kept.size(); ++i) EXPECT_EQ(kept[i].time, sorted[i].time);
}

TEST(PageFrames, BoxesTumblingAtRandomTakeLessThanTwelveBytesABodyAFrame) {
  const std::shared_ptr<const Model> model = boxes(200);
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  State state = make_initial_state(*model);
  std::vector<Vec3> v(201), w(201);
  for (int i = 1; i <= 200; ++i) {
    v[static_cast<std::size_t>(i)] = Vec3(normal(random), normal(random), normal(random));
    w[static_cast<std::size_t>(i)] = 5 * Vec3(normal(random), normal(random), normal(random));
  }
  PageFrames frames(*model, page_scale(*model, state));
  std::vector<State> states;
  constexpr int count = 300;
  constexpr double h = 0.01;
  for (int k = 0; k < count; ++k) {
    states.push_back(state);
    for (int i = 1; i <= 200; ++i) {
      const std::size_t place = static_cast<std::size_t>(i);
      // Every tenth body is struck in every frame.
      if ((k + i) % 10 == 0) {
        v[place] += 0.3 * Vec3(normal(random), normal(random), normal(random));
        w[place] += 2 * Vec3(normal(random), normal(random), normal(random));
      }
      v[place].z() -= 9.81 * h;
      const Quat q = (rotation_exp(h * w[place]) * state.orientation(i)).normalized();
      const Mat3 R = rotation_matrix(q);
      const Body& body = model->body(i);
      state.set_body(i, state.position(i) + h * v[place], q, body.mass * v[place],
                     R * body.moments.asDiagonal() * R.transpose() * w[place]);
    }
  }
  double bytes = 0;
  for (const PageBlock& block : chunks_of(frames, states))
    bytes += static_cast<double>(seven_bit_text(block.deflated).size());
  EXPECT_LT(bytes / (200.0 * count), 12);
}

TEST(PageFrames, StatesThatAreNotFiniteAreStoredAsTheOriginAndDoNotStopThePage) {
  const std::shared_ptr<const Model> model = boxes(1);
  State state = make_initial_state(*model);
  const PageScale scale = page_scale(*model, state);
  PageFrames frames(*model, scale);
  state.x[3] = std::numeric_limits<double>::quiet_NaN();
  state.P[3] = std::numeric_limits<double>::infinity();
  const test::ReadFrames read = test::read_frames(chunks_of(frames, {state}), scale);
  EXPECT_EQ(read.x[0][0].x(), scale.origin.x());
}

}  // namespace
}  // namespace rigor::page_frames_test
