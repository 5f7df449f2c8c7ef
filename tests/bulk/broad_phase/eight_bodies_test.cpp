// What is done to eight bodies or pairs at a time has the bits of what is done to one.

#include "rigor/bulk/broad_phase/near_bodies.hpp"
#include "rigor/bulk/broad_phase/pair_lanes.hpp"
#include "rigor/bulk/broad_phase/shape_places.hpp"
#include "rigor/bulk/state/bulk_bodies.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/model_builder.hpp"

#include "random_vectors.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace rigor::eight_bodies_test {
namespace {

using test::Random;

struct Crowd {
  std::shared_ptr<const Model> model;
  BulkBodies bodies;
};

/// Spheres, capsules and boxes that move.
Crowd random_crowd(int count, double speed, Random& random) {
  const Shape shapes[] = {Sphere{0.3}, Capsule{0.1, 0.2}, Box{Vec3(0.2, 0.3, 0.4)}};
  ModelBuilder builder;
  for (int i = 0; i < count; ++i) {
    BodyDescription body;
    body.name = "b" + std::to_string(i);
    body.p_WU = 3 * random.vector();
    body.q_WU = rotation_exp(3 * random.vector());
    body.shapes = {{.shape = shapes[i % 3]}};
    body.density = 1000;
    builder.add_body(body);
  }
  Crowd crowd{builder.build(), {}};
  crowd.bodies = read_bulk_bodies(*crowd.model, make_initial_state(*crowd.model));
  for (MotionRecord& motion : crowd.bodies.motion) {
    const Vec3 v = random.vector(), w = speed * random.vector();
    for (int k = 0; k < 3; ++k) {
      motion.v[k] = static_cast<float>(v[k]);
      motion.w[k] = static_cast<float>(w[k]);
    }
  }
  return crowd;
}

TEST(EightBodies, HaveThePlacesAndBoxesOfOne) {
  Random random(5);
  for (int trial = 0; trial < 40; ++trial) {
    const Crowd crowd = random_crowd(9, trial % 2 == 0 ? 1 : 200, random);
    std::vector<ShapeBound> bounds;
    std::array<const ShapeBound*, 8> of_eight;
    for (int i = 0; i < 9; ++i) bounds.push_back(make_shape_bound(crowd.model->body(i).shapes[0]));
    for (std::size_t i = 0; i < 8; ++i) of_eight[i] = &bounds[i + 1];
    const Vec3 origin(0.5, -1, 2);
    ShapePlace places[8];
    FloatBox boxes[8];
    sweep_eight_shapes(of_eight, crowd.bodies, 1, {origin, 0.02F, 0.003F}, places, boxes);
    for (int i = 0; i < 8; ++i) {
      const SweptShape one =
          sweep_shape(*of_eight[static_cast<std::size_t>(i)], crowd.bodies, i + 1, origin, 0.02F, 0.003F);
      for (int k = 0; k < 3; ++k) {
        EXPECT_EQ(places[i].center[k], one.place.center[k]);
        EXPECT_EQ(places[i].u[k], one.place.u[k]);
        EXPECT_EQ(places[i].w[k], one.place.w[k]);
        EXPECT_EQ(boxes[i].lower[k], one.box.lower[k]);
        EXPECT_EQ(boxes[i].upper[k], one.box.upper[k]);
      }
      EXPECT_EQ(places[i].slack, one.place.slack);
      EXPECT_EQ(places[i].bound, of_eight[static_cast<std::size_t>(i)]);
    }
  }
}

std::vector<LaneTarget> targets() {
  std::vector<LaneTarget> all = {LaneTarget::portable};
  if (best_lane_target() != LaneTarget::portable) all.push_back(best_lane_target());
  return all;
}

TEST(EightPairs, HaveTheMarginsOfOne) {
  Random random(7);
  int near_count = 0, far_count = 0, box_count = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const Crowd crowd = random_crowd(16, trial % 2 == 0 ? 1 : 20, random);
    std::vector<ShapeBound> bounds;
    std::vector<SweptShape> swept;
    for (int i = 0; i < 16; ++i) bounds.push_back(make_shape_bound(crowd.model->body(i).shapes[0]));
    bounds[15].reach = 5;  // A large one, whose box is asked.
    for (int i = 0; i < 16; ++i)
      swept.push_back(
          sweep_shape(bounds[static_cast<std::size_t>(i)], crowd.bodies, i, Vec3(0.5, -1, 2), 0.02F, 0.003F));
    std::array<ShapePlacePair, kLaneCount> pairs;
    for (std::size_t i = 0; i < 8; ++i) pairs[i] = {&swept[i].place, &swept[15 - i].place};
    for (const LaneTarget target : targets()) {
      const PairMargins found = find_pair_margins(pairs, 0.02F, 0.003F, target);
      for (int i = 0; i < 8; ++i) {
        const PairPlaces one{*pairs[static_cast<std::size_t>(i)].a, *pairs[static_cast<std::size_t>(i)].b,
                             crowd.bodies.q[static_cast<std::size_t>(i)],
                             crowd.bodies.q[static_cast<std::size_t>(15 - i)]};
        const std::optional<float> margin = find_pair_margin(one, 0.02F, 0.003F);
        const bool is_near = (found.near >> i & 1) != 0, asks_box = (found.asks_box >> i & 1) != 0;
        EXPECT_EQ(asks_box, i == 0 && is_near);
        EXPECT_TRUE(is_near || !margin);
        EXPECT_TRUE(asks_box || !is_near || margin);
        EXPECT_EQ(found.margin[i], margin.value_or(found.margin[i]));
        ++(asks_box ? box_count : (is_near ? near_count : far_count));
      }
    }
  }
  EXPECT_GT(near_count, 20);
  EXPECT_GT(far_count, 20);
  EXPECT_GT(box_count, 20);
}

TEST(EightPairs, OfBoxesTouchAsOneDoes) {
  Random random(8);
  int touching = 0, apart_by_edges = 0, apart = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    std::array<FloatBox, 17> boxes;  // Room behind the last one.
    std::array<float, 16> radii;
    for (std::size_t i = 0; i < 16; ++i) {
      const Vec3 center = random.vector();
      for (int k = 0; k < 3; ++k) {
        boxes[i].lower[k] = static_cast<float>(center[k]) - 0.4F;
        boxes[i].upper[k] = static_cast<float>(center[k]) + 0.4F;
      }
      radii[i] = i % 3 == 0 ? 0 : 0.1F * static_cast<float>(i % 4);
    }
    boxes[15] = boxes[0];  // Two faces at the same place.
    for (int k = 0; k < 2; ++k)
      (k == 0 ? boxes[15].lower : boxes[15].upper)[0] = boxes[0].upper[0] + 0.8F * static_cast<float>(k);
    std::array<RoundBoxPair, kLaneCount> pairs;
    for (std::size_t i = 0; i < 8; ++i) pairs[i] = {&boxes[i], &boxes[15 - i], radii[i] + radii[15 - i]};
    for (const LaneTarget target : targets()) {
      const unsigned found = find_touching_boxes(pairs, target);
      for (std::size_t i = 0; i < 8; ++i) {
        const bool does_touch = rounded_boxes_touch(boxes[i], radii[i], boxes[15 - i], radii[15 - i]);
        EXPECT_EQ((found >> i & 1) != 0, does_touch);
        ++(does_touch ? touching : (boxes[i].overlaps(boxes[15 - i]) ? apart_by_edges : apart));
      }
    }
  }
  EXPECT_GT(touching, 100);
  EXPECT_GT(apart_by_edges, 10);
  EXPECT_GT(apart, 100);
}

TEST(OrientationNow, IsExactForNearAndFarTurns) {
  Random random(6);
  Crowd crowd = random_crowd(1, 1, random);
  for (const double size : {1e-5, 0.1, 0.57, 0.58, 1.0, 9.0}) {  // The series is for up to 1 rad: 0.577 each.
    for (int trial = 0; trial < 20; ++trial) {
      Vec3 dr = trial == 0 ? Vec3::Constant(size) : Vec3(size * random.vector());
      for (int k = 0; k < 3; ++k) {
        dr[k] = std::ldexp(std::round(std::ldexp(dr[k], 20)), -20);  // Has no more than 24 bits.
        crowd.bodies.motion[0].dr[k] = static_cast<float>(dr[k]);
      }
      const Quat exact = rotation_exp(dr) * crowd.bodies.q[0];
      EXPECT_LT((orientation_now(0, crowd.bodies).coeffs() - exact.coeffs()).norm(),
                2e-15);  // Some roundings.
    }
  }
}

}  // namespace
}  // namespace rigor::eight_bodies_test
