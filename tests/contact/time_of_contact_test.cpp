#include "rigor/geometry/motion/time_of_contact.hpp"

#include "random_vectors.hpp"
#include "rigor/contact/time_of_impact.hpp"
#include "rigor/geometry/shape/support.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/body.hpp"

#include <gtest/gtest.h>

#include <array>

// The search for shapes on the motions of the engine, against the search of the engine.

namespace rigor::time_of_contact_test {
namespace {

using test::Random;

/// A body of two shapes that tumbles freely under gravity.
struct Thrown {
  Body body;
  Motion motion;

  Thrown(Random& random, const Shape& shape, const Vec3& x, const Vec3& v) {
    std::vector<BodyShape> shapes(2);
    shapes[0].shape = shape;
    shapes[0].X_BS = {rotation_matrix(rotation_exp(random.vector())), 0.2 * random.vector()};
    shapes[1].shape = Sphere{0.2};
    shapes[1].X_BS.p = Vec3(0, 0, 0.5);
    for (BodyShape& s : shapes) s.radius = radius_about(s.shape, Vec3::Zero());
    body.shapes = std::move(shapes);
    const BodyInertia inertia{1, Vec3(0.5, 0.8, 1.1)};
    const BodyPhase start{x, rotation_exp(3 * random.vector()), v, 2 * random.vector()};
    motion = Motion::flight(FreeFlight(inertia, start, 0, Vec3(0, 0, -9.81)), inertia);
  }
  std::array<MovingShape, 2> shapes() const {
    return {MovingShape{&body.shapes[0].shape, body.shapes[0].X_BS, &motion},
            MovingShape{&body.shapes[1].shape, body.shapes[1].X_BS, &motion}};
  }
};

TEST(TimeOfContactOfBodies, InFreeFlightIsTheTimeOfTheirImpact) {
  Random random(61);
  int contacts = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const Shape a = trial % 2 == 0 ? Shape(Box{Vec3(0.5, 0.3, 0.2)}) : Shape(Cone{0.4, 0.4});
    const Shape b = trial % 3 == 0 ? Shape(Ellipsoid{Vec3(0.5, 0.3, 0.2)}) : Shape(Cylinder{0.3, 0.3});
    const Thrown A(random, a, Vec3::Zero(), Vec3(0, 0, 3));
    const Thrown B(random, b, Vec3(4, 0, 0) + 0.3 * random.vector(), Vec3(-5, 0, 3));
    const TimeOfContact contact = find_time_of_contact(A.shapes(), B.shapes(), 0, 1.5);
    const TimeOfImpact impact = find_time_of_impact(A.body, A.motion, B.body, B.motion, 0, 1.5, ToiOptions{});
    ASSERT_TRUE(contact.is_complete);
    // An impact is a touch of shapes that approach; from apart the first touch is one.
    ASSERT_EQ(contact.is_contact, impact.is_contact) << trial;
    if (!contact.is_contact) continue;
    ++contacts;
    EXPECT_NEAR(contact.lower, impact.time, 3e-12) << trial;
    EXPECT_LE(contact.upper - contact.lower, 1.01e-12);
  }
  EXPECT_GT(contacts, 30);
}

}  // namespace
}  // namespace rigor::time_of_contact_test
