// Which sides of the ground a body that lies on a plane cannot come to.

#include "rigor/geometry/contacts/hidden_side.hpp"

#include <gtest/gtest.h>

namespace rigor::hidden_side_test {
namespace {

Pose at_place(double x, double z) {
  return {Mat3::Identity(), Vec3(x, 0, z)};
}

/// A box of 0.2 m that lies at z = 0 on a floor whose border is at x = 0, and a floor from there on.
bool is_hidden(double height_of_next, double overlap = 0) {
  const GroundPlane plane{Vec3::UnitZ(), Vec3(-0.1, 0, 0), -overlap};
  const Shape body = Box{Vec3::Constant(0.1)}, next = Box{Vec3(1, 1, 0.3)};
  return hides_side(plane, body, at_place(-0.2, 0.1 - overlap), next, at_place(1, height_of_next - 0.3),
                    1e-6);
}

TEST(HiddenSide, OfAFloorThatIsNoHigher) {
  EXPECT_TRUE(is_hidden(0));
  EXPECT_TRUE(is_hidden(0, 1e-3));
  EXPECT_TRUE(is_hidden(-0.2));
}

TEST(HiddenSide, IsNoStepUpwards) {
  EXPECT_FALSE(is_hidden(2e-6));
  EXPECT_FALSE(is_hidden(0.05));
}

// Part of the body has come under the plane elsewhere: what lies there may be met.
TEST(HiddenSide, IsMetByWhatIsUnderThePlane) {
  const GroundPlane plane{Vec3::UnitZ(), Vec3(-0.1, 0, 0), 0};
  const Shape body = Box{Vec3::Constant(0.1)}, next = Box{Vec3(1, 1, 0.3)};
  EXPECT_FALSE(hides_side(plane, body, at_place(-0.2, 0.05), next, at_place(1, -0.3), 1e-6));
}

// Half-spaces have no side, and of a mesh its hull says nothing.
TEST(HiddenSide, IsOfConvexSolids) {
  const GroundPlane plane{Vec3::UnitZ(), Vec3::Zero(), 0};
  const Shape body = Box{Vec3::Constant(0.1)};
  EXPECT_FALSE(hides_side(plane, body, at_place(0, 0.1), HalfSpace{Vec3::UnitZ(), 0}, at_place(0, 0), 1e-6));
}

}  // namespace
}  // namespace rigor::hidden_side_test
