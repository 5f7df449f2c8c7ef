#include "rigor/bulk/broad_phase/pair_finder.hpp"

#include "random_vectors.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/model_builder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <string>
#include <tuple>

namespace rigor::pair_finder_test {
namespace {

constexpr double kStep = 1.0 / 60, kMargin = 0.02;

Shape random_shape(test::Random& random) {
  const auto size = [&] { return random.uniform(0.1, 0.5); };
  const int kind = static_cast<int>(random.uniform(0, 7));
  if (kind == 0) return Sphere{size()};
  if (kind == 1) return Capsule{0.5 * size(), size()};
  if (kind == 2) return Cylinder{size(), size()};
  if (kind == 3) return Cone{size(), size()};
  if (kind == 4) return Ellipsoid{Vec3(size(), size(), size())};
  if (kind == 5) {
    std::vector<Vec3> points;
    for (int i = 0; i < 12; ++i) points.push_back(0.5 * random.vector());
    return Convex{std::make_shared<ConvexHull>(std::get<ConvexHull>(make_convex_hull(points)))};
  }
  return Box{Vec3(size(), size(), size())};
}

Quat random_rotation(test::Random& random) {
  return rotation_exp(3 * random.vector());
}

BodyDescription random_body(test::Random& random, int number, double room) {
  BodyDescription body;
  body.name = "b" + std::to_string(number);
  if (number % 9 == 0) body.motion = MotionType::fixed;
  if (number % 9 == 1) body.motion = MotionType::kinematic;
  body.p_WU = room * random.vector();
  body.q_WU = random_rotation(random);
  if (body.motion != MotionType::fixed) {
    body.velocity = 2 * random.vector();
    body.angular_velocity = 3 * random.vector();
  }
  const int shape_count = number % 4 == 0 ? 3 : 1;
  for (int s = 0; s < shape_count; ++s) {
    ShapeDescription shape{random_shape(random), Vec3::Zero(), Quat::Identity(), "", ""};
    if (shape_count > 1) shape.p_US = random.vector();
    if (number % 3 == 0) shape.q_US = random_rotation(random);
    body.shapes.push_back(shape);
  }
  body.group = number % 5 == 0 ? 2 : 1;
  body.mask = number % 7 == 0 ? 1 : 3;
  return body;
}

/// Bodies of all kinds, some of several shapes, with a turning plane; some pairs excluded, one by a joint.
std::shared_ptr<const Model> random_scene(unsigned seed, int count) {
  test::Random random(seed);
  const double room = 0.55 * std::cbrt(count);
  ModelBuilder builder;
  const auto add_unbounded = [&](const std::string& name, const Shape& shape, const Vec3& place) {
    BodyDescription body;
    body.name = name;
    body.motion = MotionType::kinematic;
    body.p_WU = place;
    body.velocity = random.vector();
    body.angular_velocity = 0.1 * random.vector();
    body.shapes.push_back({shape, 0.1 * random.vector(), random_rotation(random), "", ""});
    builder.add_body(body);
  };
  for (int i = 0; i < count; ++i) {
    if (i == count / 2) add_unbounded("plane", HalfSpace{Vec3::UnitZ(), -0.5 * room}, Vec3::Zero());
    builder.add_body(random_body(random, i, room));
  }
  builder.exclude_pair("b2", "b3");
  ModelBuilder::JointDescription joint;
  joint.name = "j";
  joint.type = JointType::fixed;
  joint.bodies = {"b4", "b5"};
  builder.add_joint(joint);
  return builder.build();
}

using Key = std::tuple<int, int, int, int>;

Key key_of(const ShapePair& pair) {
  return {pair.body_A, pair.body_B, pair.shape_A, pair.shape_B};
}

std::vector<ShapePair> pairs_of(const Model& model, const BulkBodies& bodies, int threads = 1,
                                double margin = kMargin) {
  std::vector<ShapePair> pairs;
  PairFinder(model).find_pairs(bodies, kStep, margin, Executor(threads), pairs);
  return pairs;
}

/// Pose at a time from now, at the velocities of now.
Pose pose_after(double t, const BulkBodies& bodies, int body, const BodyShape& shape) {
  const std::size_t k = static_cast<std::size_t>(body);
  const MotionRecord& motion = bodies.motion[k];
  const Vec3 v(motion.v[0], motion.v[1], motion.v[2]), w(motion.w[0], motion.w[1], motion.w[2]);
  const Quat q = rotation_exp(t * w) * bodies.q[k];
  return Pose{q.toRotationMatrix(), bodies.x[k] + t * v} * shape.X_BS;
}

double distance_after(double t, const Model& model, const BulkBodies& bodies, const Key& key) {
  const auto& [a, b, shape_a, shape_b] = key;
  const BodyShape& A = model.body(a).shapes[static_cast<std::size_t>(shape_a)];
  const BodyShape& B = model.body(b).shapes[static_cast<std::size_t>(shape_b)];
  return signed_distance(A.shape, pose_after(t, bodies, a, A), B.shape, pose_after(t, bodies, b, B)).distance;
}

std::vector<Key> colliding_shapes(const Model& model) {
  std::vector<Key> keys;
  for (int a = 0; a < model.body_count(); ++a) {
    for (int b = a + 1; b < model.body_count(); ++b) {
      if (!model.may_collide(a, b)) continue;
      for (int i = 0; i < static_cast<int>(model.body(a).shapes.size()); ++i) {
        for (int j = 0; j < static_cast<int>(model.body(b).shapes.size()); ++j) keys.push_back({a, b, i, j});
      }
    }
  }
  return keys;
}

TEST(PairFinder, FindsEveryPairThatIsNearOrMeetsWithinTheStepAndNoneThatMayNot) {
  for (const unsigned seed : {1u, 2u, 3u, 4u}) {
    const std::shared_ptr<const Model> model = random_scene(seed, 90);
    const BulkBodies bodies = read_bulk_bodies(*model, make_initial_state(*model));
    const std::vector<ShapePair> pairs = pairs_of(*model, bodies);
    std::set<Key> found;
    for (const ShapePair& pair : pairs) found.insert(key_of(pair));
    const std::vector<Key> all = colliding_shapes(*model);
    const std::set<Key> allowed(all.begin(), all.end());
    EXPECT_TRUE(std::includes(allowed.begin(), allowed.end(), found.begin(), found.end()));
    int near = 0;
    for (const Key& key : all) {
      double least = distance_after(0, *model, bodies, key) - kMargin;
      for (const double t : {0.25, 0.5, 0.75, 1.0})
        least = std::min(least, distance_after(t * kStep, *model, bodies, key));
      if (least > 0) continue;
      ++near;
      EXPECT_TRUE(found.contains(key)) << std::get<0>(key) << " " << std::get<1>(key) << ", seed " << seed;
    }
    EXPECT_GT(near, 40);
    // Boxes and balls pass on some pairs that are not near, but not many.
    EXPECT_LT(static_cast<int>(found.size()), 3 * near);
  }
}

TEST(PairFinder, MarginHoldsHowFarThePointsComeToEachOther) {
  const std::shared_ptr<const Model> model = random_scene(9, 120);
  const BulkBodies bodies = read_bulk_bodies(*model, make_initial_state(*model));
  int apart = 0;
  for (const ShapePair& pair : pairs_of(*model, bodies, 1, 0.3)) {
    const double before = distance_after(0, *model, bodies, key_of(pair));
    const double after = distance_after(kStep, *model, bodies, key_of(pair));
    if (before <= 0) continue;  // Of overlaps the depth may turn to another side.
    ++apart;
    // To first order: what is left is ½ h² w² r with w below 6 rad/s and r below 2 m.
    const double second_order = 0.5 * kStep * kStep * 36 * 2;
    EXPECT_LE(before - after, static_cast<double>(pair.margin) - 0.3 + second_order);
  }
  EXPECT_GT(apart, 50);
}

TEST(PairFinder, IsInOrderAndDependsOnTheBodiesAlone) {
  const std::shared_ptr<const Model> model = random_scene(5, 300);
  const State state = make_initial_state(*model);
  const BulkBodies bodies = read_bulk_bodies(*model, state);
  BulkBodies others = bodies;
  for (Vec3& x : others.x) x *= 0.7;
  const std::vector<ShapePair> fresh = pairs_of(*model, bodies);
  for (std::size_t i = 1; i < fresh.size(); ++i) EXPECT_LT(key_of(fresh[i - 1]), key_of(fresh[i]));
  PairFinder finder(*model);
  for (const int threads : {1, 2, 3, 8}) {
    const Executor executor(threads);
    std::vector<ShapePair> pairs;
    finder.find_pairs(others, kStep, kMargin, executor, pairs);
    finder.find_pairs(bodies, kStep, kMargin, executor, pairs);
    ASSERT_EQ(pairs.size(), fresh.size());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      EXPECT_EQ(key_of(pairs[i]), key_of(fresh[i]));
      EXPECT_EQ(pairs[i].margin, fresh[i].margin);
    }
  }
}

/// A finder that has seen all steps before answers as one that sees this one first: at rest, when all move,
/// when a few do, when bodies jump, and when all go far away with what is 32 bits' origin.
TEST(PairFinder, WhatWasNearBeforeChangesNoBit) {
  test::Random random(6);
  for (const unsigned seed : {7u, 8u}) {
    const std::shared_ptr<const Model> model = random_scene(seed, 250);
    BulkBodies bodies = read_bulk_bodies(*model, make_initial_state(*model));
    PairFinder finder(*model);
    std::size_t count = 0;
    for (int step = 0; step < 60; ++step) {
      const double way = std::vector<double>{0.0, 1e-3, 0.02, 0.3}[static_cast<std::size_t>(step / 4 % 4)];
      const int stride = step % 3 == 0 ? 1 : 17;
      for (std::size_t k = 0; k < bodies.x.size(); k += static_cast<std::size_t>(stride)) {
        bodies.x[k] += way * random.vector();
        bodies.q[k] = (rotation_exp(way * random.vector()) * bodies.q[k]).normalized();
        for (float& v : bodies.motion[k].v) v += static_cast<float>(random.uniform(-1, 1) * way);
      }
      if (step % 13 == 12) bodies.x[bodies.x.size() / 2] += 3 * random.vector();
      if (step == 40)
        for (Vec3& x : bodies.x) x += Vec3(1000, -300, 20);
      std::vector<ShapePair> pairs;
      finder.find_pairs(bodies, kStep, kMargin, Executor(1 + step % 2), pairs);
      const std::vector<ShapePair> fresh = pairs_of(*model, bodies);
      ASSERT_EQ(pairs.size(), fresh.size()) << "step " << step << ", seed " << seed;
      for (std::size_t i = 0; i < pairs.size(); ++i) {
        EXPECT_EQ(key_of(pairs[i]), key_of(fresh[i])) << "step " << step << ", seed " << seed;
        EXPECT_EQ(pairs[i].margin, fresh[i].margin) << "step " << step << ", seed " << seed;
      }
      count += pairs.size();
    }
    EXPECT_GT(count, 10000u);
  }
}

/// A body of one shape.
BodyDescription body_of(const std::string& name, MotionType motion, const Shape& shape, const Vec3& place) {
  BodyDescription body;
  body.name = name;
  body.motion = motion;
  body.p_WU = place;
  body.shapes.push_back({shape, Vec3::Zero(), Quat::Identity(), "", ""});
  return body;
}

/// Unit cubes on a floor, in rows of one less each.
std::shared_ptr<const Model> pyramid(int rows, const Vec3& from) {
  ModelBuilder builder;
  const Shape floor = Box{Vec3(200, 200, 1)}, cube = Box{Vec3(0.5, 0.5, 0.5)};
  builder.add_body(body_of("floor", MotionType::fixed, floor, from + Vec3(0, 0, -1)));
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < rows - i; ++j) {
      const std::string name = "b" + std::to_string(i) + "_" + std::to_string(j);
      builder.add_body(
          body_of(name, MotionType::dynamic, cube, from + Vec3(j - 0.5 * (rows - i - 1), 0, 0.5 + i)));
    }
  }
  return builder.build();
}

TEST(PairFinder, CountsTheContactsOfAPyramid) {
  // Of n rows: n(n-1)/2 side by side, n(n-1) one on the other, n on the floor. Also far from the origin.
  for (const double far : {0.0, 1048576.0}) {
    for (const int rows : {5, 20}) {
      const std::shared_ptr<const Model> model = pyramid(rows, Vec3(far, -far, 0));
      const BulkBodies bodies = read_bulk_bodies(*model, make_initial_state(*model));
      const std::vector<ShapePair> pairs = pairs_of(*model, bodies);
      EXPECT_EQ(static_cast<int>(pairs.size()), 3 * rows * (rows - 1) / 2 + rows) << rows << " at " << far;
      for (const ShapePair& pair : pairs) EXPECT_EQ(pair.margin, static_cast<float>(kMargin));
    }
  }
}

TEST(PairFinder, FilterOfTheCallerTakesPairsAway) {
  const std::shared_ptr<const Model> model = random_scene(6, 200);
  const BulkBodies bodies = read_bulk_bodies(*model, make_initial_state(*model));
  std::vector<ShapePair> all = pairs_of(*model, bodies), filtered;
  PairFinder finder(*model);
  finder.set_contact_filter([](int a, int b) {
    EXPECT_LT(a, b);
    return (a + b) % 3 != 0;
  });
  finder.find_pairs(bodies, kStep, kMargin, Executor(2), filtered);
  const std::size_t count = all.size();
  std::erase_if(all, [](const ShapePair& pair) { return (pair.body_A + pair.body_B) % 3 == 0; });
  EXPECT_LT(all.size(), count);
  ASSERT_EQ(filtered.size(), all.size());
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(key_of(filtered[i]), key_of(all[i]));
}

TEST(PairFinder, FastBodyMeetsWhatIsOnItsWayOnly) {
  ModelBuilder builder;
  const Shape ball = Sphere{0.1};
  BodyDescription fast = body_of("fast", MotionType::dynamic, ball, Vec3::Zero());
  fast.velocity = Vec3(600, 0, 0);  // 10 m a step.
  builder.add_body(fast);
  builder.add_body(body_of("ahead", MotionType::dynamic, ball, Vec3(9, 0, 0)));
  builder.add_body(body_of("behind", MotionType::dynamic, ball, Vec3(-9, 0, 0)));
  const std::shared_ptr<const Model> model = builder.build();
  const std::vector<ShapePair> pairs = pairs_of(*model, read_bulk_bodies(*model, make_initial_state(*model)));
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(key_of(pairs[0]), Key(0, 1, 0, 0));
  EXPECT_NEAR(pairs[0].margin, 10 + kMargin, 1e-4);
}

TEST(PairFinder, CavityGoesWithWhatIsNearItsWall) {
  ModelBuilder builder;
  const Vec3 center(1, 2, 3);
  const Shape cavity = Cavity{5}, ball = Sphere{0.5};
  builder.add_body(body_of("room", MotionType::fixed, cavity, center));
  for (const double radius : {0.0, 4.4, 4.6}) {
    builder.add_body(
        body_of("b" + std::to_string(radius), MotionType::dynamic, ball, center - Vec3(0, radius, 0)));
  }
  const std::shared_ptr<const Model> model = builder.build();
  const BulkBodies bodies = read_bulk_bodies(*model, make_initial_state(*model));
  std::set<int> bodies_at_the_wall;
  for (const ShapePair& pair : pairs_of(*model, bodies)) {
    if (pair.body_A == 0) bodies_at_the_wall.insert(pair.body_B);
  }
  EXPECT_EQ(bodies_at_the_wall, (std::set<int>{3}));
}

}  // namespace
}  // namespace rigor::pair_finder_test
