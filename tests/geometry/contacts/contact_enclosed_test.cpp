// Contacts and overlaps of what lies inside a solid mesh.

#include "geometry/mesh_shapes.hpp"
#include "geometry/solid_shapes.hpp"
#include "rigor/geometry/contacts/contact_set.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/mesh_penetration/mesh_penetration.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace rigor::contact_enclosed_test {
namespace {

using test::as_mesh;

Mesh cube(double half) {
  return as_mesh(make_box_mesh(Vec3::Constant(-half), Vec3::Constant(half)));
}
Pose at(double x, double y, double z) {
  return {Mat3::Identity(), Vec3(x, y, z)};
}

/// The cube of half side 1 with a notch along its edge x = y = -1, far from where the tests are.
Mesh notched_cube() {
  return as_mesh(
      moved(make_prism({{-0.9, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -0.9}, {-0.9, -0.9}}, 2), at(0, 0, -1)));
}

/// One contact: out through the side x = 1 by the way that is left and the width of b.
void expect_way_out(const Shape& a, const Shape& b, double half_width) {
  constexpr double place = 0.6;
  for (const bool is_exchanged : {false, true}) {
    const std::vector<ContactPoint> contacts = is_exchanged
                                                   ? contact_set(b, at(place, 0, 0), a, Pose{}, 1e-6)
                                                   : contact_set(a, Pose{}, b, at(place, 0, 0), 1e-6);
    ASSERT_EQ(contacts.size(), 1u);
    const ContactPoint& contact = contacts[0];
    EXPECT_NEAR(contact.gap, -(1 - place + half_width), 1e-12);
    EXPECT_NEAR((contact.n_W - (is_exchanged ? -1 : 1) * Vec3::UnitX()).norm(), 0, 1e-12);
    EXPECT_NEAR((contact.p_WB - contact.p_WA - contact.gap * contact.n_W).norm(), 0, 1e-12);
    EXPECT_TRUE(contact.degenerate);
  }
}

TEST(EnclosedContact, OfAShapeInsideAMeshIsTheWayOut) {
  expect_way_out(notched_cube(), Sphere{0.1}, 0.1);
  expect_way_out(notched_cube(), Box{Vec3(0.2, 0.1, 0.1)}, 0.2);
  expect_way_out(notched_cube(), cube(0.1), 0.1);
}

TEST(EnclosedContact, OfAConvexMeshIsThatOfTheConvex) {
  for (const Shape& inner : {Shape(Sphere{0.1}), Shape(Box{Vec3(0.2, 0.1, 0.1)}), Shape(cube(0.1))}) {
    const std::vector<ContactPoint> found = contact_set(cube(1), Pose{}, inner, at(0.6, 0, 0), 1e-6);
    const std::vector<ContactPoint> expected =
        contact_set(Box{Vec3::Ones()}, Pose{}, inner, at(0.6, 0, 0), 1e-6);
    ASSERT_EQ(found.size(), expected.size());
    ASSERT_FALSE(found.empty());
    for (const ContactPoint& contact : found) {
      EXPECT_NEAR((contact.n_W - Vec3::UnitX()).norm(), 0, 1e-12);
      EXPECT_NEAR((contact.p_WB - contact.p_WA - contact.gap * contact.n_W).norm(), 0, 1e-12);
    }
  }
}

TEST(EnclosedContact, ThereIsNoneInAHollowOrBesideTheMesh) {
  // Two cubes, the inner one inside out: a wall of 0.5 about a hollow.
  const Shape shell = as_mesh(test::cube_with_cavity());
  EXPECT_TRUE(contact_set(shell, Pose{}, Sphere{0.1}, at(0.1, 0, 0), 1e-6).empty());
  EXPECT_TRUE(contact_set(shell, Pose{}, cube(0.1), at(0.1, 0, 0), 1e-6).empty());
  EXPECT_EQ(contact_set(shell, Pose{}, Sphere{0.1}, at(0.75, 0, 0), 1e-6).size(), 1u);
  EXPECT_TRUE(contact_set(cube(1), Pose{}, Sphere{0.1}, at(1.2, 0, 0), 1e-6).empty());
  // In the box of the L, but not in the L.
  const Shape angle = as_mesh(test::l_solid());
  EXPECT_TRUE(contact_set(angle, Pose{}, Sphere{0.1}, at(1.5, 1.5, 0.5), 1e-6).empty());
}

TEST(SharedInside, OfEqualMeshesAtEqualPosesIsSeen) {
  const Shape a = cube(0.5), b = cube(0.5);
  EXPECT_TRUE(share_inside(a, Pose{}, b, Pose{}, 1e-6));
  EXPECT_NEAR(solid_distance(a, Pose{}, b, Pose{}).distance, -1, 1e-12);
  EXPECT_TRUE(share_inside(a, Pose{}, Box{Vec3::Constant(0.5)}, Pose{}, 1e-6));
  // Side by side they only touch.
  EXPECT_FALSE(share_inside(a, Pose{}, b, at(1, 0, 0), 1e-6));
  EXPECT_FALSE(share_inside(a, Pose{}, b, at(1, 0.2, 0.3), 1e-6));
  EXPECT_TRUE(share_inside(a, Pose{}, b, at(1 - 1e-3, 0.2, 0.3), 1e-6));
}

}  // namespace
}  // namespace rigor::contact_enclosed_test
