// method.toi with meshes: the ends of the search by ratio and by bisection.

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
#include <string>
#include <vector>

namespace rigor::mesh_refinement_test {
namespace {

using test::as_mesh;
using test::Random;

constexpr ToiRefinement kAll[] = {ToiRefinement::conservative, ToiRefinement::ratio,
                                  ToiRefinement::bisection};

/// A body of one shape in free flight.
struct Tumbler {
  Body body;
  Motion motion;

  Tumbler(const Shape& shape, const BodyPhase& start, const Vec3& acceleration = Vec3::Zero()) {
    body.shapes = {{BodyShape{.shape = shape, .radius = radius_about(shape, Vec3::Zero())}}};
    // All moments alike: the angular velocity is constant.
    const BodyInertia inertia{1, Vec3::Ones()};
    motion = Motion::flight(FreeFlight(inertia, start, 0, acceleration), inertia);
  }
  MovingShape part() const { return {&body.shapes[0].shape, body.shapes[0].X_BS, &motion}; }
  Pose pose(double t) const { return motion.sample(t).X_WB; }
};

TimeOfImpact impact_by(ToiRefinement refinement, const Tumbler& A, const Tumbler& B, double t1) {
  ToiOptions options;
  options.refinement = refinement;
  return find_time_of_impact(A.body, A.motion, B.body, B.motion, 0, t1, options);
}

Shape thing(int kind) {
  switch (kind) {
    case 0:
      return as_mesh(test::star_solid(5, 0.4));
    case 1:
      return as_mesh(test::l_solid());
    case 2:
      return Box{Vec3(0.5, 0.3, 0.4)};
    case 3:
      return Ellipsoid{Vec3(0.5, 0.3, 0.4)};
    default:
      return Cylinder{0.4, 0.3};
  }
}

TEST(MeshRefinement, AllFindTheFirstContactOfTumblingShapes) {
  // find_time_of_contact gives a bracket in which the first contact is proven to be.
  Random random(31);
  int contacts = 0;
  for (int trial = 0; trial < 30; ++trial) {
    const Tumbler A(thing(trial % 2),
                    {Vec3::Zero(), rotation_exp(3 * random.vector()), Vec3(0, 0, 1), 2 * random.vector()});
    const Tumbler B(thing(trial % 5), {Vec3(4, 0, 0) + random.vector(), rotation_exp(3 * random.vector()),
                                       Vec3(-3, 0, 1), 2 * random.vector()});
    const TimeOfContact contact = find_time_of_contact(A.part(), B.part(), 0, 2);
    ASSERT_TRUE(contact.is_complete) << trial;
    contacts += contact.is_contact;
    for (const ToiRefinement refinement : kAll) {
      for (const bool is_exchanged : {false, true}) {
        const TimeOfImpact found =
            is_exchanged ? impact_by(refinement, B, A, 2) : impact_by(refinement, A, B, 2);
        ASSERT_EQ(found.is_contact, contact.is_contact) << trial;
        if (!found.is_contact) continue;
        // A root of the signed distance, whose rounding of 1e-15 m counts more the slower they meet.
        EXPECT_NEAR(found.time, contact.lower, 1e-11) << trial;
        EXPECT_LE(found.evaluations, 120) << trial;  // Near the mesh in steps of a hundredth of it.
      }
    }
  }
  EXPECT_GT(contacts, 12);
}

TEST(MeshRefinement, EndsBeforeAnyOverlap) {
  Random random(32);
  const Vec3 g(0, 0, -9.81);
  const Tumbler ground(as_mesh(test::star_solid(7, 0.5)),
                       {Vec3::Zero(), Quat::Identity(), Vec3::Zero(), Vec3::Zero()});
  for (int trial = 0; trial < 10; ++trial) {
    const Tumbler falling(thing(trial % 5),
                          {Vec3(0.3 * random.number(), 0.3 * random.number(), 3),
                           rotation_exp(3 * random.vector()), Vec3::Zero(), 2 * random.vector()},
                          g);
    for (const ToiRefinement refinement : kAll) {
      const TimeOfImpact found = impact_by(refinement, ground, falling, 2);
      ASSERT_TRUE(found.is_contact) << trial;
      const double gap = signed_distance(ground.body.shapes[0].shape, ground.pose(found.time),
                                         falling.body.shapes[0].shape, falling.pose(found.time))
                             .distance;
      // They fall at most 3 m, at most 2 rad/s turn 1 m: 10 m/s in the time tolerance of 1e-12 s, and
      // rounding.
      EXPECT_GE(gap, -1e-14) << trial;
      EXPECT_LE(gap, 2e-11) << trial;
    }
  }
}

}  // namespace
}  // namespace rigor::mesh_refinement_test
