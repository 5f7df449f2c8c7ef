// The search for the first impact of two meshes.

#include "geometry/mesh_shapes.hpp"
#include "geometry/solid_shapes.hpp"
#include "random_vectors.hpp"
#include "rigor/contact/time_of_impact.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/motion/time_of_contact.hpp"
#include "rigor/geometry/shape/support.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/body.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace rigor::mesh_time_of_impact_test {
namespace {

using test::as_mesh;
using test::Random;

/// A body of one shape that flies freely under a steady acceleration.
struct Flier {
  Body body;
  Motion motion;

  Flier(const Shape& shape, const BodyPhase& start, const Vec3& acceleration = Vec3::Zero()) {
    body.shapes = {{BodyShape{.shape = shape, .radius = radius_about(shape, Vec3::Zero())}}};
    // All moments alike: the angular velocity is constant.
    const BodyInertia inertia{1, Vec3::Ones()};
    motion = Motion::flight(FreeFlight(inertia, start, 0, acceleration), inertia);
  }
  MovingShape part() const { return {&body.shapes[0].shape, body.shapes[0].X_BS, &motion}; }
};

Mesh cube_mesh(double half) {
  return as_mesh(make_box_mesh(Vec3::Constant(-half), Vec3::Constant(half)));
}
/// Upper side at z = 0.
Mesh slab_mesh() {
  return as_mesh(make_box_mesh(Vec3(-2, -2, -1), Vec3(2, 2, 0)));
}
BodyPhase at_rest() {
  return {Vec3::Zero(), Quat::Identity(), Vec3::Zero(), Vec3::Zero()};
}

TimeOfImpact impact_of(const Flier& A, const Flier& B, double t1) {
  return find_time_of_impact(A.body, A.motion, B.body, B.motion, 0, t1, ToiOptions{});
}

TEST(MeshTimeOfImpact, TumblingBoxesMeetWhenTheirMeshesDo) {
  Random random(11);
  int contacts = 0;
  for (int trial = 0; trial < 30; ++trial) {
    const BodyPhase start_A{Vec3::Zero(), rotation_exp(3 * random.vector()), Vec3(0, 0, 3),
                            2 * random.vector()};
    const BodyPhase start_B{Vec3(3, 0, 0) + 0.3 * random.vector(), rotation_exp(3 * random.vector()),
                            Vec3(-4, 0, 3), 2 * random.vector()};
    const Vec3 g(0, 0, -9.81);
    const TimeOfImpact of_boxes = impact_of(Flier(Box{Vec3::Constant(0.5)}, start_A, g),
                                            Flier(Box{Vec3::Constant(0.4)}, start_B, g), 1.5);
    const TimeOfImpact of_meshes =
        impact_of(Flier(cube_mesh(0.5), start_A, g), Flier(cube_mesh(0.4), start_B, g), 1.5);
    ASSERT_EQ(of_meshes.is_contact, of_boxes.is_contact) << trial;
    if (!of_meshes.is_contact) continue;
    ++contacts;
    // Each within its time tolerance.
    EXPECT_NEAR(of_meshes.time, of_boxes.time, 4e-12) << trial;
    EXPECT_LE(of_meshes.evaluations, 60) << trial;
  }
  EXPECT_GT(contacts, 15);
}

TEST(MeshTimeOfImpact, OfTumblingSolidsWithHollowsIsTheirFirstContact) {
  // find_time_of_contact searches all pairs of boxes and triangles, best first.
  Random random(12);
  const Mesh star = as_mesh(test::star_solid(5, 0.4)), angle = as_mesh(test::l_solid());
  int contacts = 0;
  for (int trial = 0; trial < 12; ++trial) {
    const Flier A(star,
                  {Vec3::Zero(), rotation_exp(3 * random.vector()), Vec3(0, 0, 1), 2 * random.vector()});
    const Flier B(angle, {Vec3(4, 0, 0) + random.vector(), rotation_exp(3 * random.vector()), Vec3(-3, 0, 1),
                          2 * random.vector()});
    const TimeOfContact contact = find_time_of_contact(A.part(), B.part(), 0, 2);
    ASSERT_TRUE(contact.is_complete) << trial;
    const TimeOfImpact found = impact_of(A, B, 2);
    ASSERT_EQ(found.is_contact, contact.is_contact) << trial;
    if (!found.is_contact) continue;
    ++contacts;
    EXPECT_NEAR(found.time, contact.lower, 4e-12) << trial;
  }
  EXPECT_GT(contacts, 6);
}

TEST(MeshTimeOfImpact, CubeThatSlidesOnASlabNeedsFewSteps) {
  const Flier slab(slab_mesh(), at_rest());
  BodyPhase start{Vec3(-1, 0.1, 0.5), Quat::Identity(), Vec3(1, 0, 0), Vec3::Zero()};
  const TimeOfImpact found = impact_of(slab, Flier(cube_mesh(0.5), start), 1);
  EXPECT_FALSE(found.is_contact);
  EXPECT_EQ(found.time, 1);
  EXPECT_LE(found.evaluations, 102);  // Steps of a hundredth of the cube's side.
}

TEST(MeshTimeOfImpact, EdgesThatTouchToRoundingAndPartDoNotMeet) {
  // A cube turned by 45° about x lies with its edge across that of another; along the edges they slip faster
  // than they part.
  constexpr double eighth = std::numbers::pi / 4;
  const Flier lower(cube_mesh(0.5),
                    {Vec3::Zero(), rotation_exp(Vec3(eighth, 0, 0)), Vec3::Zero(), Vec3::Zero()});
  const double height = std::sqrt(2.0);
  for (const double off : {-1e-16, 0.0, 1e-16, 1e-15}) {
    const BodyPhase start{Vec3(0, 0, height + off), rotation_exp(Vec3(0, eighth, 0)), Vec3(0.3, 0.5, 1e-3),
                          Vec3::Zero()};
    const TimeOfImpact found = impact_of(lower, Flier(cube_mesh(0.5), start), 0.1);
    EXPECT_FALSE(found.is_contact) << off;
    EXPECT_EQ(found.time, 0.1) << off;
  }
}

TEST(MeshTimeOfImpact, EdgesThatTouchWhileBothTiltNeedFewSteps) {
  // Two solids with hollows touch across two edges and rotate about that point, which is at rest for a
  // moment: no direction that is fixed or rotates with one of them keeps the gap to first order.
  constexpr double eighth = std::numbers::pi / 4;
  const Mesh angle = as_mesh(test::l_solid());
  const Quat q_A = rotation_exp(Vec3(-eighth, 0, 0));
  const Quat q_B = rotation_exp(Vec3(0, 0, 2 * eighth)) * rotation_exp(Vec3(3 * eighth, 0, 0));
  const Vec3 on_edge(1, 0, 1);
  Random random(13);
  for (int trial = 0; trial < 50; ++trial) {
    const Vec3 off(0, 0, std::pow(10, random.uniform(-15, -9)));
    const Vec3 w_A = 3 * random.vector(), w_B = 3 * random.vector();
    const Vec3 x_A = -(q_A * on_edge), x_B = off - q_B * on_edge;
    const Flier A(angle, {x_A, q_A, w_A.cross(x_A), w_A}), B(angle, {x_B, q_B, w_B.cross(x_B), w_B});
    const TimeOfImpact found = impact_of(A, B, 0.05);
    EXPECT_LE(found.evaluations, 500) << trial;
    if (!found.is_contact) {
      EXPECT_EQ(found.time, 0.05) << trial;
      continue;
    }
    // Where they come back to each other, they touch to rounding.
    const double distance =
        signed_distance(angle, A.part().pose(found.time), angle, B.part().pose(found.time)).distance;
    EXPECT_NEAR(distance, 0, 1e-13) << trial;
  }
}

TEST(MeshTimeOfImpact, SlidingCubeMeetsTheStepBeforeIt) {
  // The slab's surface is z = 0; a step of height 0.2 begins at x = 1.
  const Mesh stairs = as_mesh(
      moved(make_prism({Vec2(-2, -1), Vec2(2, -1), Vec2(2, 0.2), Vec2(1, 0.2), Vec2(1, 0), Vec2(-2, 0)}, 4),
            {rotation_matrix(rotation_exp(Vec3(std::numbers::pi / 2, 0, 0))), Vec3::Zero()}));
  const Flier below(stairs, at_rest());
  const BodyPhase start{Vec3(-1, -2, 0.5), Quat::Identity(), Vec3(2, 0, 0), Vec3::Zero()};
  const TimeOfImpact found = impact_of(below, Flier(cube_mesh(0.5), start), 3);
  ASSERT_TRUE(found.is_contact);
  EXPECT_NEAR(found.time, 0.75, 4e-12);  // 1.5 m at 2 m/s.
  EXPECT_LE(found.evaluations, 165);     // 150 to get there.
}

}  // namespace
}  // namespace rigor::mesh_time_of_impact_test
