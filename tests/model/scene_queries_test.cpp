#include "rigor/model/scene_queries.hpp"

#include "random_vectors.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/distance/point_distance.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/model_builder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace rigor::scene_queries_test {
namespace {

using test::Random;

/// A floor and many bodies of two shapes in a cube of 10 m.
std::shared_ptr<const Model> random_scene(int count) {
  Random random(5);
  ModelBuilder builder;
  builder.add_material({"m", 1000, 0.5, 0.5});
  BodyDescription floor;
  floor.name = "floor";
  floor.motion = MotionType::fixed;
  floor.shapes.push_back({HalfSpace{Vec3::UnitZ(), -6}, Vec3::Zero(), Quat::Identity(), "m", ""});
  builder.add_body(floor);
  for (int i = 0; i < count; ++i) {
    BodyDescription body;
    body.name = "b" + std::to_string(i);
    body.p_WU = 5 * random.vector();
    body.q_WU = rotation_exp(3 * random.vector());
    const Vec3 size = Vec3(0.4, 0.4, 0.4) + 0.2 * random.vector();
    const Shape shape = i % 3 == 0   ? Shape(Box{size})
                        : i % 3 == 1 ? Shape(Ellipsoid{size})
                                     : Shape(Cone{size.x(), size.y()});
    body.shapes.push_back({shape, Vec3::Zero(), Quat::Identity(), "m", ""});
    body.shapes.push_back({Sphere{0.2}, Vec3(0.5, 0, 0), Quat::Identity(), "m", ""});
    builder.add_body(body);
  }
  return builder.build();
}

Pose shape_pose(const SceneQueries& scene, const Model& model, const ShapeIndex& at) {
  return scene.pose(at.body) * model.body(at.body).shapes[static_cast<std::size_t>(at.shape)].X_BS;
}

template <typename Visit>
void for_each_shape(const Model& model, const Visit& visit) {
  for (int body = 0; body < model.body_count(); ++body) {
    const int count = static_cast<int>(model.body(body).shapes.size());
    for (int shape = 0; shape < count; ++shape) {
      visit(ShapeIndex{body, shape}, model.body(body).shapes[static_cast<std::size_t>(shape)].shape);
    }
  }
}

TEST(SceneQueries, RaysMeetWhatTheyMeetOfAllBodiesOneByOne) {
  const std::shared_ptr<const Model> model = random_scene(200);
  const SceneQueries scene(*model, make_initial_state(*model));
  Random random(6);
  int hits = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const Ray ray{8 * random.vector(), random.vector(), trial % 2 == 0 ? 1e9 : 3};
    std::optional<BodyRayHit> first;
    std::size_t count = 0;
    for_each_shape(*model, [&](const ShapeIndex& at, const Shape& shape) {
      for (const RayHit& hit : find_ray_hits(shape, shape_pose(scene, *model, at), ray)) {
        ++count;
        if (!first || hit.fraction < first->hit.fraction) first = BodyRayHit{at, hit};
      }
    });
    const std::vector<BodyRayHit> all = scene.all_hits(ray);
    ASSERT_EQ(all.size(), count);
    EXPECT_TRUE(std::is_sorted(all.begin(), all.end(), [](const BodyRayHit& a, const BodyRayHit& b) {
      return a.hit.fraction < b.hit.fraction;
    }));
    const std::optional<BodyRayHit> found = scene.first_hit(ray);
    ASSERT_EQ(found.has_value(), first.has_value());
    if (!found) continue;
    ++hits;
    EXPECT_EQ(found->on, first->on);
    EXPECT_EQ(found->hit.fraction, first->hit.fraction);
    EXPECT_EQ(all.front().on, first->on);
    // Without that body the next one is met.
    const auto others = [&](int body) { return body != first->on.body; };
    const std::optional<BodyRayHit> next = scene.first_hit(ray, others);
    EXPECT_TRUE(!next || (next->on.body != first->on.body && next->hit.fraction >= first->hit.fraction));
  }
  EXPECT_GT(hits, 50);
}

TEST(SceneQueries, NearestBodiesAreThoseOfASort) {
  const std::shared_ptr<const Model> model = random_scene(100);
  const SceneQueries scene(*model, make_initial_state(*model));
  Random random(7);
  const Shape capsule = Capsule{0.2, 0.4};
  for (int trial = 0; trial < 40; ++trial) {
    const Pose X_WQ{rotation_matrix(rotation_exp(random.vector())), 6 * random.vector()};
    std::vector<double> to_point(100 + 1, 1e9), to_shape(100 + 1, 1e9);
    for_each_shape(*model, [&](const ShapeIndex& at, const Shape& shape) {
      const Pose X_WS = shape_pose(scene, *model, at);
      double& point = to_point[static_cast<std::size_t>(at.body)];
      double& of_shape = to_shape[static_cast<std::size_t>(at.body)];
      point = std::min(point, point_distance(shape, X_WS, X_WQ.p).distance);
      of_shape = std::min(of_shape, signed_distance(capsule, X_WQ, shape, X_WS).distance);
    });
    for (const int k : {0, 1, 7, 200}) {
      const std::vector<NearBody> near_point = scene.nearest(X_WQ.p, k);
      const std::vector<NearBody> near_shape = scene.nearest(capsule, X_WQ, k);
      std::vector<double> sorted_point = to_point, sorted_shape = to_shape;
      std::sort(sorted_point.begin(), sorted_point.end());
      std::sort(sorted_shape.begin(), sorted_shape.end());
      ASSERT_EQ(near_point.size(), std::min<std::size_t>(static_cast<std::size_t>(k), 101));
      for (std::size_t i = 0; i < near_point.size(); ++i) {
        EXPECT_EQ(near_point[i].distance, sorted_point[i]);
        EXPECT_EQ(near_point[i].distance, to_point[static_cast<std::size_t>(near_point[i].on.body)]);
        EXPECT_EQ(near_shape[i].distance, sorted_shape[i]);
        const NearBody& n = near_shape[i];
        EXPECT_NEAR((n.p_WB - n.p_WQ - n.distance * n.n_W).norm(), 0, 1e-13);
      }
    }
    // The bodies that hold the point or meet the shape are those at no positive distance.
    std::vector<int> holding, meeting;
    for (int body = 0; body <= 100; ++body) {
      if (to_point[static_cast<std::size_t>(body)] <= 0) holding.push_back(body);
      if (to_shape[static_cast<std::size_t>(body)] <= 0) meeting.push_back(body);
    }
    EXPECT_EQ(scene.containing(X_WQ.p), holding);
    EXPECT_EQ(scene.overlapping(capsule, X_WQ), meeting);
  }
}

TEST(SceneQueries, APushedShapeStopsWhereItFirstTouches) {
  const std::shared_ptr<const Model> model = random_scene(100);
  const SceneQueries scene(*model, make_initial_state(*model));
  Random random(8);
  const Shape box = Box{Vec3(0.3, 0.2, 0.1)};
  int hits = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const ShapeCast cast{
        &box, {rotation_matrix(rotation_exp(random.vector())), 7 * random.vector()}, 8 * random.vector()};
    const std::optional<BodyCastHit> found = scene.cast(cast);
    const auto free_until = [&](double fraction) {
      return scene.nearest(box, {cast.X_WS.R, cast.X_WS.p + fraction * cast.translation_W})[0].distance;
    };
    for (int k = 0; k < 20; ++k) {
      const double fraction = (found ? found->hit.fraction : 1) * k / 20;
      if (fraction > 0 || !found) {
        EXPECT_GT(free_until(fraction), 0);
      }
    }
    if (!found || found->hit.upper == 0) continue;
    ++hits;
    EXPECT_NEAR(free_until(found->hit.upper), 0, 2e-11);
    EXPECT_LE(found->hit.upper - found->hit.fraction, 1.001e-12);
    EXPECT_GT(found->hit.n_W.dot(cast.translation_W), 0);
  }
  EXPECT_GT(hits, 15);
}

TEST(SceneQueries, FollowTheStateAndAskBoxesToo) {
  const std::shared_ptr<const Model> model = random_scene(3);
  State state = make_initial_state(*model);
  for (int body = 1; body <= 3; ++body) {
    state.set_body(body, Vec3(4.0 * body, 0, 0), Quat::Identity(), Vec3::Zero(), Vec3::Zero());
  }
  SceneQueries scene(*model, make_initial_state(*model));
  scene.update(state);
  const std::optional<BodyRayHit> hit = scene.first_hit({Vec3(0, 0, 0), Vec3(1, 0, 0)});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->on.body, 1);
  EXPECT_EQ(scene.overlapping(Aabb{Vec3(3, -3, -3), Vec3(9, 3, 3)}), (std::vector<int>{1, 2}));
  EXPECT_EQ(scene.overlapping(Aabb{Vec3(3, -3, -7), Vec3(5, 3, 3)}), (std::vector<int>{0, 1}));
  EXPECT_EQ(scene.containing(Vec3(12, 0, -8)), (std::vector<int>{0}));
}

}  // namespace
}  // namespace rigor::scene_queries_test
