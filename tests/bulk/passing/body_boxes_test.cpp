// Boxes about random bodies on random ways. The truth: where their shapes are along these ways.

#include "rigor/bulk/passing/body_boxes.hpp"
#include "geometry/random_pairs.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/motion/rigid_motion.hpp"
#include "rigor/geometry/motion/separation_bound.hpp"
#include "rigor/geometry/shape/support.hpp"
#include "rigor/math/rotation.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace rigor::body_boxes_test {
namespace {

using test::Draw;

constexpr int kSamples = 24;

/// A body of one shape, which need not be about its centre, and its way in a step.
struct MovingBody {
  Shape shape;
  Pose X_BS, X_WB;
  Vec3 dp, dr;

  Pose shape_at(double t) const { return TwistMotion(X_WB, dp, dr).sample(t).X_WB * X_BS; }
  BodyBoxes::Way way() const {
    return {dp, turning_radius(shape, X_BS, radius_about(shape, Vec3::Zero())) * dr.norm()};
  }
};

Shape draw_shape(int kind, Draw& draw) {
  const Vec3 sizes = draw.sizes();
  switch (kind) {
    case 0:
      return Box{sizes};
    case 1:
      return Capsule{0.3 * sizes.x(), sizes.y()};
    case 2:
      return Cylinder{sizes.x(), 0.2 * sizes.y()};
    default:
      return Sphere{sizes.x()};
  }
}

MovingBody draw_body(int kind, Draw& draw) {
  const Shape shape = draw_shape(kind, draw);
  const Pose X_BS = draw.pose(0.2), X_WB = draw.pose(1.2);
  const Vec3 dp = draw.uniform(0, 0.8) * draw.direction(), dr = draw.uniform(0, 0.5) * draw.direction();
  return {shape, X_BS, X_WB, dp, dr};
}

/// Two bodies where a step begins, with their boxes.
struct Beginning {
  explicit Beginning(const std::array<MovingBody, 2>& pair) {
    for (int i = 0; i < 2; ++i) {
      const MovingBody& body = pair[at(i)];
      boxes.set_body(i, axis_aligned_box(body.shape, body.X_BS));
      bodies.x.push_back(body.X_WB.p);
      bodies.q.push_back(quaternion_of(body.X_WB.R));
    }
  }
  BodyBoxes boxes;
  BulkBodies bodies;
};

TEST(BodyBoxes, PartNoBodiesThatMeet) {
  Draw draw(11);
  int parted = 0, meeting = 0;
  for (int k = 0; k < 4000; ++k) {
    const std::array<MovingBody, 2> pair = {draw_body(k % 4, draw), draw_body(k / 4 % 4, draw)};
    const Beginning begin(pair);
    const bool are_parted = begin.boxes.are_parted(begin.bodies, 0, 1, pair[0].way(), pair[1].way());
    double nearest = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= kSamples; ++i) {
      const double t = static_cast<double>(i) / kSamples;
      nearest = std::min(
          nearest,
          signed_distance(pair[0].shape, pair[0].shape_at(t), pair[1].shape, pair[1].shape_at(t)).distance);
    }
    ASSERT_TRUE(!are_parted || nearest > -1e-9) << k;
    parted += are_parted ? 1 : 0;
    meeting += nearest < 0 ? 1 : 0;
  }
  // They see most of those that stay apart.
  EXPECT_GT(meeting, 500);
  EXPECT_GT(parted, 0.5 * (4000 - meeting));
}

TEST(BodyBoxes, HoldBodiesAllAlongTheirWays) {
  Draw draw(12);
  for (int k = 0; k < 2000; ++k) {
    const std::array<MovingBody, 2> pair = {draw_body(k % 4, draw), draw_body(k / 4 % 4, draw)};
    const Beginning begin(pair);
    for (int i = 0; i < 2; ++i) {
      const MovingBody& body = pair[at(i)];
      const Aabb box = *begin.boxes.swept(begin.bodies, i, body.way());
      for (int s = 0; s <= kSamples; ++s) {
        Aabb now = axis_aligned_box(body.shape, body.shape_at(static_cast<double>(s) / kSamples));
        now = {now.lower - body.X_WB.p, now.upper - body.X_WB.p};
        ASSERT_TRUE(box.grown(1e-12).contains(now)) << k;
      }
    }
  }
}

TEST(BodyBoxes, KnowNothingOfWhatIsUnbounded) {
  BodyBoxes boxes;
  BulkBodies bodies;
  const double infinity = std::numeric_limits<double>::infinity();
  boxes.set_body(0, Aabb{Vec3::Constant(-infinity), Vec3(infinity, infinity, 0)});
  boxes.set_body(1, std::nullopt);
  boxes.set_body(2, Aabb{Vec3::Constant(-1), Vec3::Constant(1)});
  for (int i = 0; i < 3; ++i) {
    bodies.x.push_back(Vec3(0, 0, 100 * i));
    bodies.q.push_back(Quat::Identity());
  }
  const BodyBoxes::Way still{Vec3::Zero(), 0};
  EXPECT_FALSE(boxes.are_parted(bodies, 0, 2, still, still));
  EXPECT_FALSE(boxes.are_parted(bodies, 2, 1, still, still));
  EXPECT_FALSE(boxes.swept(bodies, 0, still));
  EXPECT_FALSE(boxes.swept(bodies, 1, still));
  EXPECT_TRUE(boxes.swept(bodies, 2, still));
}

}  // namespace
}  // namespace rigor::body_boxes_test
