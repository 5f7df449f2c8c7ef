// Solids of revolution of convex profiles: against the cylinder and the cone that two points make, and
// against polyhedra inside and around them.

#include "geometry/random_pairs.hpp"
#include "rigor/geometry/contacts/contact_set.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/distance/point_distance.hpp"
#include "rigor/geometry/mass/mass_properties.hpp"
#include "rigor/geometry/mass/point_sampling.hpp"
#include "rigor/geometry/rays/ray_span.hpp"
#include "rigor/geometry/shape/aabb.hpp"
#include "rigor/geometry/shape/containment.hpp"
#include "rigor/geometry/shape/support.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace rigor::revolution_test {
namespace {

using test::Draw;

constexpr double kPi = std::numbers::pi;

Revolution solid_of(const std::vector<Vec2>& profile) {
  std::variant<Revolution, std::string> solid = make_revolution(profile);
  if (const std::string* const reason = std::get_if<std::string>(&solid))
    throw std::invalid_argument(*reason);
  return std::get<Revolution>(std::move(solid));
}

/// Points of an ellipse, from the bottom up, the lowest and highest of them with or without a flat cap.
std::vector<Vec2> random_profile(Draw& draw) {
  const double radius = draw.size(), height = draw.size(), shift = draw.uniform(-0.2, 0.2);
  const int count = static_cast<int>(draw.uniform(2, 9));
  std::vector<double> angles;
  for (int i = 0; i < count; ++i) angles.push_back(draw.uniform(-0.5 * kPi, 0.5 * kPi));
  std::vector<Vec2> profile;
  for (const double angle : angles)
    profile.emplace_back(radius * std::cos(angle), shift + height * std::sin(angle));
  if (draw.uniform(0, 1) < 0.5) profile.emplace_back(0, shift - height);
  if (draw.uniform(0, 1) < 0.5) profile.emplace_back(0, shift + height);
  return profile;
}

/// The polyhedron of n-gons in the rings (factor 1) or around them (1 / cos(π/n)).
Convex polyhedron(const Revolution& solid, int n, double factor) {
  std::vector<Vec3> points;
  for (const Ring& ring : *solid.rings) {
    const double r = factor * ring.radius;
    for (int k = 0; k < (r > 0 ? n : 1); ++k) {
      const double angle = 2 * kPi * k / n;
      points.emplace_back(r * std::cos(angle), r * std::sin(angle), ring.z);
    }
  }
  return Convex{std::make_shared<const ConvexHull>(std::get<ConvexHull>(make_convex_hull(points)))};
}

/// A cylinder and a cone with the same solids of two points.
std::vector<std::pair<Shape, Shape>> twins(Draw& draw) {
  const double r = draw.size(), h = draw.size();
  return {{Cylinder{r, h}, solid_of({{r, -h}, {r, h}})}, {Cone{r, h}, solid_of({{r, -h}, {0, h}})}};
}

void expect_same_curvature(const SurfaceCurvature& a, const SurfaceCurvature& b) {
  EXPECT_EQ(a.flat_count, b.flat_count);
  EXPECT_LE((a.radius_W - b.radius_W).norm(), 1e-9 * (1 + a.radius_W.norm()));
}

void expect_same_contacts(const std::vector<ContactPoint>& a, const std::vector<ContactPoint>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].feature, b[i].feature);
    EXPECT_LE((a[i].p_WA - b[i].p_WA).norm() + (a[i].p_WB - b[i].p_WB).norm(), 1e-9);
    EXPECT_LE((a[i].n_W - b[i].n_W).norm(), 1e-9);
    EXPECT_NEAR(a[i].gap, b[i].gap, 1e-12);
    expect_same_curvature(a[i].curvature_A, b[i].curvature_A);
    expect_same_curvature(a[i].curvature_B, b[i].curvature_B);
  }
}

TEST(Revolution, OfTwoPointsIsAtTheDistancesOfTheCylinderAndTheCone) {
  Draw draw(1);
  for (int i = 0; i < 300; ++i) {
    for (const auto& [basic, solid] : twins(draw)) {
      const Shape other = draw.shape(i % Draw::kKinds);
      const Pose X_WA = draw.pose(0.8), X_WB = draw.pose(0.8);
      const DistanceResult expected = signed_distance(basic, X_WA, other, X_WB);
      EXPECT_NEAR(signed_distance(solid, X_WA, other, X_WB).distance, expected.distance, 1e-12) << i;
    }
  }
}

TEST(Revolution, OfTwoPointsHasTheContactsOfTheCylinderAndTheCone) {
  Draw draw(2);
  const Shape plane = HalfSpace{Vec3::UnitZ(), 0};
  for (int i = 0; i < 100; ++i) {
    for (const auto& [basic, solid] : twins(draw)) {
      const Shape other = i % 2 == 0 ? plane : draw.shape(i % Draw::kKinds);
      // Lying, standing or leaning, touching along the line between the origins.
      const double lean = i % 3 == 0 ? 0 : i % 3 == 1 ? 0.5 * kPi : draw.uniform(0, kPi);
      Pose X_WA{rotation_matrix(rotation_exp(lean * Vec3::UnitY())), Vec3(0, 0, 3)};
      const Pose X_WB = i % 2 == 0 ? Pose{} : draw.pose(0.1);
      for (int k = 0; k < 30; ++k) X_WA.p.z() -= 0.5 * signed_distance(basic, X_WA, other, X_WB).distance;
      expect_same_contacts(contact_set(basic, X_WA, other, X_WB, 1e-6),
                           contact_set(solid, X_WA, other, X_WB, 1e-6));
    }
  }
}

TEST(Revolution, OfTwoPointsHasTheMassBoxAndRaysOfTheCylinderAndTheCone) {
  Draw draw(3);
  for (int i = 0; i < 100; ++i) {
    for (const auto& [basic, solid] : twins(draw)) {
      const MassProperties a = mass_properties(basic, 700), b = mass_properties(solid, 700);
      EXPECT_NEAR(b.mass / a.mass, 1, 1e-14);
      EXPECT_LE((a.center - b.center).norm(), 1e-15);
      EXPECT_LE((a.inertia - b.inertia).norm(), 1e-14 * a.inertia.norm());
      const Pose X_WS = draw.pose(1);
      const Aabb box_a = axis_aligned_box(basic, X_WS), box_b = axis_aligned_box(solid, X_WS);
      EXPECT_LE((box_a.lower - box_b.lower).norm() + (box_a.upper - box_b.upper).norm(), 1e-14);
      const Vec3 c = draw.pose(1).p;
      EXPECT_NEAR(radius_about(basic, c), radius_about(solid, c), 1e-14);
      EXPECT_EQ(contains(basic, 0.5 * c), contains(solid, 0.5 * c));
      const ShapeLine line{0.3 * c, draw.direction()};
      const RaySpan span_a = ray_span(basic, line), span_b = ray_span(solid, line);
      ASSERT_EQ(span_a.is_empty(), span_b.is_empty());
      if (span_a.is_empty()) continue;
      EXPECT_NEAR(span_a.in, span_b.in, 1e-13);
      EXPECT_NEAR(span_a.out, span_b.out, 1e-13);
      EXPECT_LE((span_a.n_in - span_b.n_in).norm() + (span_a.n_out - span_b.n_out).norm(), 1e-12);
    }
  }
}

TEST(Revolution, LiesBetweenThePolyhedraInsideAndAroundIt) {
  // A body inside another is at no smaller distance from a third, and overlaps it no deeper.
  Draw draw(4);
  int overlaps = 0;
  for (int i = 0; i < 80; ++i) {
    const Revolution solid = solid_of(random_profile(draw));
    const Shape other = i % (Draw::kKinds + 1) == Draw::kKinds ? Shape(solid_of(random_profile(draw)))
                                                               : draw.shape(i % (Draw::kKinds + 1));
    const Pose X_WA = draw.pose(0.6), X_WB = draw.pose(0.6);
    const DistanceResult found = signed_distance(solid, X_WA, other, X_WB);
    constexpr int sides = 24;
    const double outer = 1 / std::cos(kPi / sides), largest = radius_about(solid, Vec3::Zero());
    const double above = signed_distance(polyhedron(solid, sides, 1), X_WA, other, X_WB).distance;
    const double below = signed_distance(polyhedron(solid, sides, outer), X_WA, other, X_WB).distance;
    EXPECT_LE(found.distance, above + 1e-10) << i;
    EXPECT_GE(found.distance, below - 1e-10) << i;
    EXPECT_LE(above - below, (outer - 1) * largest + 1e-10) << i;
    // The distance is what its normal separates, and it goes from one surface to the other.
    EXPECT_NEAR(test::separation_along(found.n_W, solid, X_WA, other, X_WB), found.distance, 1e-9) << i;
    // Where curved bodies overlap the upper bound is that of a polytope inside their difference.
    EXPECT_LE(found.upper - found.lower, found.distance > 0 ? 1e-12 : 2e-6) << i;
    if (found.distance < 0) ++overlaps;
  }
  EXPECT_GT(overlaps, 20);
}

TEST(Revolution, PointsAreAtTheDistanceOfTheNearestSide) {
  Draw draw(5);
  for (int i = 0; i < 100; ++i) {
    const Revolution solid = solid_of(random_profile(draw));
    const Vec3 p = draw.pose(1).p;
    const PointDistance found = point_distance(solid, Pose{}, p);
    constexpr int sides = 36;
    const double outer = 1 / std::cos(kPi / sides);
    EXPECT_LE(found.distance, point_distance(polyhedron(solid, sides, 1), Pose{}, p).distance + 1e-10) << i;
    EXPECT_GE(found.distance, point_distance(polyhedron(solid, sides, outer), Pose{}, p).distance - 1e-10)
        << i;
    EXPECT_EQ(contains(solid, p), found.distance <= 0) << i;
    EXPECT_NEAR(point_distance(solid, Pose{}, found.p_W).distance, 0, 1e-14) << i;
    // The farthest point is on the surface, and no other ring point is farther.
    const Vec3 far = farthest_point(solid, p);
    EXPECT_NEAR((far - p).norm(), radius_about(solid, p), 1e-15) << i;
    EXPECT_GE((far - p).norm(), radius_about(polyhedron(solid, sides, 1), p) - 1e-14) << i;
  }
}

TEST(Revolution, RaysEnterAndLeaveThroughTheSurface) {
  Draw draw(6);
  int hits = 0;
  for (int i = 0; i < 500; ++i) {
    const Revolution solid = solid_of(random_profile(draw));
    const ShapeLine line{draw.pose(0.4).p, draw.direction()};
    const RaySpan span = ray_span(solid, line);
    for (int k = -40; k <= 40; ++k) {
      const double s = 0.05 * k;
      const bool is_inside = point_distance(solid, Pose{}, line.at(s)).distance < 0;
      if (is_inside) {
        EXPECT_TRUE(span.in <= s && s <= span.out) << i;
      } else {
        EXPECT_FALSE(span.in + 1e-12 < s && s < span.out - 1e-12) << i;
      }
    }
    if (span.is_empty()) continue;
    ++hits;
    for (const auto& [s, n] : {std::pair(span.in, span.n_in), std::pair(span.out, span.n_out)}) {
      EXPECT_NEAR(point_distance(solid, Pose{}, line.at(s)).distance, 0, 1e-12) << i;
      EXPECT_NEAR(support_value(solid, n), n.dot(line.at(s)), 1e-9) << i;
    }
  }
  EXPECT_GT(hits, 100);
}

TEST(Revolution, MassIsThatOfPointsInsideIt) {
  Draw draw(7);
  for (int i = 0; i < 6; ++i) {
    const Revolution solid = solid_of(random_profile(draw));
    const MassProperties exact = mass_properties(solid, 3);
    SamplingOptions options;
    options.cells = 40;
    const SampledMassProperties sampled =
        sampled_mass_properties(make_inside_test(solid), axis_aligned_box(solid, Pose{}), 3, options);
    EXPECT_NEAR(exact.mass, sampled.properties.mass, 5 * 3 * sampled.volume_deviation);
    const Vec3 center_error = exact.center - sampled.properties.center;
    const Mat3 inertia_error = exact.inertia - sampled.properties.inertia;
    EXPECT_TRUE((center_error.cwiseAbs().array() <= 5 * sampled.center_deviation.array()).all());
    EXPECT_TRUE((inertia_error.cwiseAbs().array() <= 5 * sampled.inertia_deviation.array()).all());
  }
}

TEST(Revolution, MassDoesNotDependOnWhereAStraightSideIsCut) {
  // The ring in the middle stands out by 1e-9 of the size, so that it stays.
  const Shape whole = solid_of({{0.3, -0.2}, {0.5, 0.6}});
  const Shape cut = solid_of({{0.3, -0.2}, {0.375 + 1e-9, 0.1}, {0.5, 0.6}});
  const MassProperties a = mass_properties(whole, 1), b = mass_properties(cut, 1);
  EXPECT_NEAR(a.mass, b.mass, 1e-8 * a.mass);
  EXPECT_LE((a.center - b.center).norm(), 1e-8);
  EXPECT_LE((a.inertia - b.inertia).norm(), 1e-8 * a.inertia.norm());
}

TEST(Revolution, ContactsWithAPlaneAreItsLowestPoints) {
  Draw draw(8);
  const Shape plane = HalfSpace{Vec3::UnitZ(), 0};
  for (int i = 0; i < 200; ++i) {
    const Revolution solid = solid_of(random_profile(draw));
    Pose X_WS{draw.rotation(), Vec3::Zero()};
    X_WS.p.z() = support_value(solid, -X_WS.R.transpose() * Vec3::UnitZ());
    constexpr double tolerance = 1e-3;
    const std::vector<ContactPoint> contacts = contact_set(plane, Pose{}, solid, X_WS, tolerance);
    ASSERT_FALSE(contacts.empty()) << i;
    double least = 1;
    for (const ContactPoint& contact : contacts) {
      least = std::min(least, contact.gap);
      EXPECT_LE(contact.gap, tolerance);
      EXPECT_NEAR(contact.p_WB.z(), contact.gap, 1e-14) << i;
      EXPECT_NEAR(point_distance(solid, X_WS, contact.p_WB).distance, 0, 1e-13) << i;
    }
    EXPECT_NEAR(least, 0, 1e-14) << i;
  }
}

TEST(Revolution, ACupOnItsSideTouchesWithBothRimsOfThatSide) {
  const Revolution cup = solid_of({{0.03, -0.06}, {0.045, 0.06}, {0.043, 0.064}});
  const double slope = std::atan2(0.015, 0.12);
  Pose X_WS{rotation_matrix(rotation_exp((-0.5 * kPi + slope) * Vec3::UnitY())), Vec3::Zero()};
  X_WS.p.z() = support_value(cup, -X_WS.R.transpose() * Vec3::UnitZ());
  const std::vector<ContactPoint> contacts =
      contact_set(HalfSpace{Vec3::UnitZ(), 0}, Pose{}, cup, X_WS, 1e-8);
  ASSERT_EQ(contacts.size(), 2);
  EXPECT_NEAR((contacts[0].p_WB - contacts[1].p_WB).norm(), std::hypot(0.015, 0.12), 1e-14);
  for (const ContactPoint& contact : contacts) {
    EXPECT_NEAR(contact.gap, 0, 1e-16);
    EXPECT_EQ(contact.curvature_B.flat_count, 0);
  }
}

TEST(Revolution, StandsOnTheFourPointsOfItsFoot) {
  const Revolution glass = solid_of({{0.03, 0}, {0.031, 0.004}, {0.02, 0.05}, {0, 0.06}});
  const std::vector<ContactPoint> contacts =
      contact_set(HalfSpace{Vec3::UnitZ(), 0}, Pose{}, glass, Pose{}, 1e-6);
  ASSERT_EQ(contacts.size(), 4);
  for (const ContactPoint& contact : contacts) EXPECT_NEAR(contact.p_WB.head<2>().norm(), 0.03, 1e-16);
  // On its tip it stands on one.
  const Pose X_turned{rotation_matrix(rotation_exp(kPi * Vec3::UnitX())), Vec3(0, 0, 0.06)};
  EXPECT_EQ(contact_set(HalfSpace{Vec3::UnitZ(), 0}, Pose{}, glass, X_turned, 1e-6).size(), 1);
}

TEST(Revolution, TakesTheProfileInAnyOrder) {
  const Revolution up = solid_of({{0, 0}, {1, 0}, {2, 1}, {1.5, 3}, {0, 3}});
  const Revolution down = solid_of({{0, 3}, {1.5, 3}, {2, 1}, {1, 0}, {0, 0}});
  ASSERT_EQ(up.rings->size(), 3);
  ASSERT_EQ(down.rings->size(), 3);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ((*up.rings)[i].radius, (*down.rings)[i].radius);
    EXPECT_EQ((*up.rings)[i].z, (*down.rings)[i].z);
  }
}

TEST(Revolution, RefusesWhatIsNoConvexSolidAndSaysWhy) {
  const auto reason = [](const std::vector<Vec2>& profile) {
    const std::variant<Revolution, std::string> result = make_revolution(profile);
    const std::string* const text = std::get_if<std::string>(&result);
    return text != nullptr ? *text : "";
  };
  EXPECT_EQ(reason({{1, 0}}), "the profile has 1 points, must have at least 2");
  EXPECT_EQ(reason({{1, 0}, {-0.5, 1}}), "point 1 of the profile has radius -0.5 m, must be >= 0");
  EXPECT_EQ(reason({{1, 0}, {NAN, 1}}), "point 1 of the profile is not finite");
  EXPECT_EQ(reason({{0, 0}, {0, 1}}), "the profile lies on the axis: the solid has no volume");
  EXPECT_EQ(reason({{1, 2}, {0.5, 2}}), "the profile has no height: the solid has no volume");
  EXPECT_EQ(reason({{1, 0}, {0.25, 1}, {1, 2}}),
            "the profile is not convex: point 1 [0.25, 1] lies 0.75 m inside the hull of the others; give "
            "the body one "
            "convex shape for each part of the profile between two necks, or a mesh");
  // The rounding of written numbers makes no dent.
  EXPECT_EQ(reason({{1, 0}, {1.333333, 1}, {1.666667, 2}, {2, 3}}), "");
}

}  // namespace
}  // namespace rigor::revolution_test
