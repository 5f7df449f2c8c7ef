#include "rigor/geometry/contacts/contact_set.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/geometry/shape/support.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace rigor::contact_laws_test {
namespace {

constexpr double kTolerance = 1e-6;  ///< Of the sets [m].
/// Witnesses of curved shapes are found by iteration; sizes are of the order of 1 m.
constexpr double kAccuracy = 1e-9;
/// Where a rim grazes an edge, its two crossings are the roots of a parabola whose height is rounding, some
/// 4e-16 m: they lie within its root.
constexpr double kGrazing = 2e-8;

Convex prism() {
  std::vector<Vec3> points;
  for (int k = 0; k < 5; ++k) {
    const double angle = 2 * std::numbers::pi / 5 * k;
    for (const double z : {-0.3, 0.3}) points.emplace_back(0.6 * std::cos(angle), 0.6 * std::sin(angle), z);
  }
  return {std::make_shared<ConvexHull>(std::get<ConvexHull>(make_convex_hull(points)))};
}

std::vector<Shape> bounded_shapes() {
  return {Sphere{0.4},
          Box{Vec3(0.3, 0.4, 0.5)},
          Capsule{0.2, 0.5},
          Cylinder{0.3, 0.5},
          Cone{0.4, 0.5},
          Ellipsoid{Vec3(0.3, 0.4, 0.6)},
          prism()};
}

struct PosedPair {
  Shape a, b;
  Pose X_WA, X_WB;
  double gap;    ///< The signed distance [m].
  double upper;  ///< Its certified upper bound: of two sharp corners that overlap the distance may be a local
                 ///< optimum.
};

/// Random pairs that touch: orientations either free or multiples of a quarter turn, so that features run
/// parallel.
class PairMaker {
 public:
  explicit PairMaker(unsigned seed) : engine_(seed) {}

  PosedPair make(const Shape& a, const Shape& b) {
    PosedPair pair{a, b, {orientation(), Vec3(number(), number(), number())}, {orientation(), Vec3::Zero()},
                   0, 0};
    pair.gap = pair.upper = 0.4 * kTolerance * std::round(number());
    if (const HalfSpace* plane = std::get_if<HalfSpace>(&a)) {
      // Lower the shape along the normal.
      const Vec3 n = pair.X_WA.R * plane->normal;
      const double height = support_value(b, -(pair.X_WB.R.transpose() * n));
      const double offset = plane->offset + n.dot(pair.X_WA.p);
      const Vec3 aside = n.cross(Vec3(number(), number(), number()));
      pair.X_WB.p = aside + (offset + height + pair.gap) * n;
      return pair;
    }
    // From far away along the axes, a little aside, towards A along the normal.
    const Vec3 away = Vec3(number(), number(), number()).normalized();
    Vec3 offset = 0.4 * Vec3(number(), number(), number());
    int axis = 0;
    away.cwiseAbs().maxCoeff(&axis);
    offset(axis) = away(axis) > 0 ? 3 : -3;
    pair.X_WB.p = pair.X_WA.p + pair.X_WA.R * offset;
    const DistanceResult d = signed_distance(a, pair.X_WA, b, pair.X_WB);
    pair.X_WB.p -= (d.distance - pair.gap) * d.n_W;
    // Two corners that overlap along n need not go back all that way.
    if (pair.gap < 0) {
      const DistanceResult overlap = signed_distance(a, pair.X_WA, b, pair.X_WB);
      pair.gap = overlap.distance;
      pair.upper = overlap.upper;
    }
    return pair;
  }

  double number() { return uniform_(engine_); }

  Mat3 orientation() {
    if (number() < 0) {
      return rotation_matrix(rotation_exp(3 * Vec3(number(), number(), number())));
    }
    return quarter_turns();
  }

  Mat3 quarter_turns() {
    Mat3 R = Mat3::Identity();
    for (int k = 0; k < 3; ++k) {
      const double quarters = std::round(1.5 * number());
      R = R * rotation_matrix(rotation_exp(quarters * std::numbers::pi / 2 * Vec3::Unit(k)));
    }
    return R;
  }

 private:
  std::mt19937 engine_;
  std::uniform_real_distribution<double> uniform_{-1, 1};
};

/// How far p is off the surface: a ball about it overlaps a convex body by its radius exactly if p is on the
/// surface.
double distance_to_surface(const Shape& shape, const Pose& X_WS, const Vec3& p_W) {
  const double radius = 0.01;
  return signed_distance(Sphere{radius}, {Mat3::Identity(), p_W}, shape, X_WS).distance + radius;
}

/// Calls check(pair, contacts, name) for many touching pairs of all shapes.
template <typename Check>
void for_all_pairs(unsigned seed, int trials, const Check& check) {
  PairMaker maker(seed);
  std::vector<Shape> firsts = bounded_shapes();
  firsts.push_back(HalfSpace{Vec3(0.6, 0, 0.8), 0.3});
  for (const Shape& a : firsts) {
    for (const Shape& b : bounded_shapes()) {
      for (int trial = 0; trial < trials; ++trial) {
        const PosedPair pair = maker.make(a, b);
        const std::string name = std::string(shape_type_name(a)) + " and " + shape_type_name(b) + ", trial " +
                                 std::to_string(trial);
        check(pair, contact_set(pair.a, pair.X_WA, pair.b, pair.X_WB, kTolerance), name);
      }
    }
  }
}

/// Largest distance from a contact of one set to the nearest of the other: points and, unless the direction
/// is arbitrary (corners without distance), normals.
double difference(const std::vector<ContactPoint>& first, const std::vector<ContactPoint>& second) {
  double worst = 0;
  for (const ContactPoint& x : first) {
    double best = 1;
    for (const ContactPoint& y : second) {
      const double turn = x.degenerate ? 0 : (x.n_W - y.n_W).norm();
      best = std::min(best, (x.p_WA - y.p_WA).norm() + (x.p_WB - y.p_WB).norm() + turn);
    }
    worst = std::max(worst, best);
  }
  return worst;
}

TEST(ContactSetLaws, EveryPointLiesOnBothSurfacesAtItsGap) {
  for_all_pairs(
      1, 25, [](const PosedPair& pair, const std::vector<ContactPoint>& contacts, const std::string& name) {
        ASSERT_FALSE(contacts.empty()) << name;
        double least = 1;
        for (const ContactPoint& c : contacts) {
          EXPECT_NEAR(c.n_W.norm(), 1, 1e-14) << name;
          EXPECT_LE(c.gap, kTolerance) << name;
          EXPECT_NEAR((c.p_WB - c.p_WA).dot(c.n_W), c.gap, 1e-12) << name;
          EXPECT_LE((c.p_WB - c.p_WA - c.gap * c.n_W).norm(), kTolerance) << name;
          EXPECT_LE(std::abs(distance_to_surface(pair.a, pair.X_WA, c.p_WA)), kTolerance) << name;
          EXPECT_LE(std::abs(distance_to_surface(pair.b, pair.X_WB, c.p_WB)), kTolerance) << name;
          least = std::min(least, c.gap);
        }
        EXPECT_GE(least, pair.gap - kAccuracy) << name;
        EXPECT_LE(least, pair.upper + kAccuracy) << name;
      });
}

// Features that run parallel but for a tilt of the order of the tolerance: which of them touch is decided by
// the last digits, that one of them touches at the distance is not.
TEST(ContactSetLaws, NearlyParallelFeaturesMeetAtTheDistance) {
  PairMaker maker(9);
  const std::vector<Shape> shapes = bounded_shapes();
  for (const Shape& a : shapes) {
    for (const Shape& b : shapes) {
      for (int trial = 0; trial < 60; ++trial) {
        PosedPair pair = maker.make(a, b);
        const double size = std::pow(10.0, -6.5 + 2 * maker.number());
        pair.X_WB.R =
            pair.X_WA.R * maker.quarter_turns() *
            rotation_matrix(rotation_exp(size * Vec3(maker.number(), maker.number(), maker.number())));
        const DistanceResult apart = signed_distance(a, pair.X_WA, b, pair.X_WB);
        pair.X_WB.p -= apart.distance * apart.n_W;
        const DistanceResult now = signed_distance(a, pair.X_WA, b, pair.X_WB);
        // Overlapping corners have several ways out; the law above is for them.
        if (now.distance < -kAccuracy) continue;
        const std::vector<ContactPoint> contacts = contact_set(a, pair.X_WA, b, pair.X_WB, kTolerance);
        const std::string name = std::string(shape_type_name(a)) + " and " + shape_type_name(b) + ", trial " +
                                 std::to_string(trial);
        ASSERT_FALSE(contacts.empty()) << name;
        double least = 1;
        for (const ContactPoint& c : contacts) least = std::min(least, c.gap);
        EXPECT_NEAR(least, now.distance, kAccuracy) << name;
      }
    }
  }
}

TEST(ContactSetLaws, TheNormalSeparatesTheShapesAsFarAsTheLeastGap) {
  for_all_pairs(
      2, 25, [](const PosedPair& pair, const std::vector<ContactPoint>& contacts, const std::string& name) {
        if (std::holds_alternative<HalfSpace>(pair.a)) return;
        for (const ContactPoint& c : contacts) {
          const double top_A =
              c.n_W.dot(pair.X_WA.p) + support_value(pair.a, pair.X_WA.R.transpose() * c.n_W);
          const double bottom_B =
              c.n_W.dot(pair.X_WB.p) - support_value(pair.b, -(pair.X_WB.R.transpose() * c.n_W));
          EXPECT_GE(bottom_B - top_A, pair.gap - kAccuracy) << name;
          EXPECT_LE(bottom_B - top_A, pair.upper + kAccuracy) << name;
        }
      });
}

TEST(ContactSetLaws, ExchangingTheShapesNegatesTheNormals) {
  for_all_pairs(
      3, 25, [](const PosedPair& pair, const std::vector<ContactPoint>& contacts, const std::string& name) {
        std::vector<ContactPoint> exchanged = contact_set(pair.b, pair.X_WB, pair.a, pair.X_WA, kTolerance);
        for (ContactPoint& c : exchanged) {
          std::swap(c.p_WA, c.p_WB);
          c.n_W = -c.n_W;
        }
        ASSERT_EQ(exchanged.size(), contacts.size()) << name;
        EXPECT_LE(difference(contacts, exchanged), kAccuracy) << name;
        EXPECT_LE(difference(exchanged, contacts), kAccuracy) << name;
      });
}

TEST(ContactSetLaws, ARigidMotionOfThePairMovesTheSet) {
  PairMaker motions(44);
  for_all_pairs(
      4, 25, [&](const PosedPair& pair, const std::vector<ContactPoint>& contacts, const std::string& name) {
        const Pose X{motions.orientation(), Vec3(motions.number(), motions.number(), motions.number())};
        std::vector<ContactPoint> moved = contacts;
        for (ContactPoint& c : moved) {
          c.p_WA = X * c.p_WA;
          c.p_WB = X * c.p_WB;
          c.n_W = X.R * c.n_W;
        }
        const std::vector<ContactPoint> found =
            contact_set(pair.a, X * pair.X_WA, pair.b, X * pair.X_WB, kTolerance);
        ASSERT_EQ(found.size(), moved.size()) << name;
        // Of two optima rounding may take either.
        if (pair.upper - pair.gap > kAccuracy) return;
        EXPECT_LE(difference(moved, found), 2 * kGrazing) << name;
      });
}

TEST(ContactSetLaws, NoPointComesTwiceAndFeaturesAscend) {
  for_all_pairs(5, 40,
                [](const PosedPair&, const std::vector<ContactPoint>& contacts, const std::string& name) {
                  for (std::size_t i = 1; i < contacts.size(); ++i) {
                    EXPECT_LE(contacts[i - 1].feature, contacts[i].feature) << name;
                    for (std::size_t j = 0; j < i; ++j) {
                      EXPECT_GT((contacts[i].p_WA - contacts[j].p_WA).norm(), 1e-10) << name;
                    }
                  }
                });
}

TEST(ContactSetLaws, FartherThanTheToleranceThereIsNone) {
  for_all_pairs(
      6, 20, [](const PosedPair& pair, const std::vector<ContactPoint>& contacts, const std::string& name) {
        ASSERT_FALSE(contacts.empty()) << name;
        Pose X_away = pair.X_WB;
        X_away.p += 1.5 * kTolerance * contacts.front().n_W;
        EXPECT_TRUE(contact_set(pair.a, pair.X_WA, pair.b, X_away, kTolerance).empty()) << name;
      });
}

TEST(ContactSetLaws, ScalingAllLengthsByAPowerOfTwoScalesTheSetBitForBit) {
  const Box a{Vec3(0.3, 0.4, 0.5)}, b{Vec3(0.2, 0.6, 0.1)};
  PairMaker maker(7);
  for (int trial = 0; trial < 50; ++trial) {
    const PosedPair pair = maker.make(a, b);
    const Pose X_WA{pair.X_WA.R, 1024 * pair.X_WA.p}, X_WB{pair.X_WB.R, 1024 * pair.X_WB.p};
    const std::vector<ContactPoint> small = contact_set(a, pair.X_WA, b, pair.X_WB, kTolerance);
    const std::vector<ContactPoint> large =
        contact_set(Box{1024 * a.half_extents}, X_WA, Box{1024 * b.half_extents}, X_WB, 1024 * kTolerance);
    ASSERT_EQ(large.size(), small.size());
    for (std::size_t k = 0; k < small.size(); ++k) {
      EXPECT_EQ(large[k].gap, 1024 * small[k].gap);
      EXPECT_EQ(large[k].p_WA, 1024 * small[k].p_WA);
      EXPECT_EQ(large[k].n_W, small[k].n_W);
      EXPECT_EQ(large[k].feature, small[k].feature);
    }
  }
}

}  // namespace
}  // namespace rigor::contact_laws_test
