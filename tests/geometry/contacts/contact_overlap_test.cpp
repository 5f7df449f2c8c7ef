// Contact sets of shapes that overlap hold the deepest point, however far apart points may be that still
// count.

#include "random_vectors.hpp"
#include "rigor/geometry/contacts/contact_set.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/math/rotation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace rigor::contact_overlap_test {
namespace {

TEST(ContactOverlap, TheDeepestPointOnAFloorIsInTheSetAtAnyTolerance) {
  test::Random random(3);
  const Shape shapes[] = {Cone{0.1, 0.05},
                          Cylinder{0.08, 0.04},
                          Capsule{0.05, 0.1},
                          Sphere{0.1},
                          Ellipsoid{Vec3(0.1, 0.05, 0.07)},
                          Box{Vec3(0.1, 0.06, 0.03)}};
  const Shape floors[] = {Box{Vec3(3, 3, 0.25)}, HalfSpace{Vec3::UnitZ(), 0.25}};
  const Pose X_WF{Mat3::Identity(), Vec3(0, 0, -0.25)};
  for (int trial = 0; trial < 60; ++trial) {
    const Mat3 R = rotation_matrix(rotation_exp(3 * random.vector()).normalized());
    for (const Shape& shape : shapes) {
      for (const Shape& floor : floors) {
        const Pose above{R, Vec3(0.2, -0.1, 1)};
        const double height = signed_distance(floor, X_WF, shape, above).distance;
        for (const double depth : {1e-6, 4e-4, 5e-3}) {
          const Pose X_WS{R, above.p - Vec3(0, 0, height + depth)};
          for (const double tolerance : {1e-6, 1e-3, 0.05, 0.2}) {
            double deepest = std::numeric_limits<double>::infinity();
            for (const ContactPoint& contact : contact_set(floor, X_WF, shape, X_WS, tolerance))
              deepest = std::min(deepest, contact.gap);
            // Rounding of positions of the order of one; the set may leave out what it merges.
            EXPECT_NEAR(deepest, -depth, 1e-9) << trial << " " << shape_type_name(shape) << " " << tolerance;
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace rigor::contact_overlap_test
