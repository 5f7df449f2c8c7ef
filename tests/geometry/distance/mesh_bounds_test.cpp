// The bounds of the signed distance where meshes overlap hold for the least translation that parts the
// solids.

#include "geometry/random_pairs.hpp"
#include "geometry/solid_shapes.hpp"
#include "rigor/geometry/contacts/contact_set.hpp"
#include "rigor/geometry/decomposition/mesh_solid.hpp"
#include "rigor/geometry/decomposition/pieces_distance.hpp"
#include "rigor/geometry/distance/distance.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace rigor::mesh_bounds_test {
namespace {

using namespace test;

constexpr double kRounding = 1e-9;  ///< Of pieces that were cut out, for sizes near 1 m.

Pose at(double x, double y, double z) {
  return {Mat3::Identity(), Vec3(x, y, z)};
}

std::vector<std::pair<std::string, Mesh>> solids() {
  return {{"L", as_mesh(l_solid())},
          {"gear", as_mesh(gear_solid(6))},
          {"star", as_mesh(star_solid(5, 0.4))},
          {"hole", as_mesh(cube_with_hole())},
          {"torus", as_mesh(torus_solid(0.3, 16, 10))}};
}

/// Whether any two pieces overlap by more than rounding after B moved.
bool overlap(const PlacedPieces& a, PlacedPieces b, const Vec3& shift) {
  b.X_WS.p += shift;
  for (std::size_t i = 0; i < a.shapes.size(); ++i) {
    for (std::size_t k = 0; k < b.shapes.size(); ++k)
      if (piece_distance(a, i, b, k).distance < -kRounding) return true;
  }
  return false;
}

/// The deepest pair of pieces after B moved; distance zero if none overlap.
DistanceResult deepest_pair(const PlacedPieces& a, PlacedPieces b, const Vec3& shift) {
  b.X_WS.p += shift;
  DistanceResult deepest{.distance = 0};
  for (std::size_t i = 0; i < a.shapes.size(); ++i) {
    for (std::size_t k = 0; k < b.shapes.size(); ++k) {
      const DistanceResult d = piece_distance(a, i, b, k);
      if (d.distance < std::min(deepest.distance, -1e-12)) deepest = d;
    }
  }
  return deepest;
}

/// Length of a translation of B along n that parts the solids, found by steps that each part the deepest pair
/// and are short enough to overlook little; `limit` if none shorter was found [m].
double parting_length(const PlacedPieces& a, const PlacedPieces& b, const Vec3& n, double limit) {
  constexpr double kLongestStep = 0.02;
  double t = 0;
  while (t < limit) {
    const DistanceResult deepest = deepest_pair(a, b, t * n);
    if (deepest.distance >= -kRounding / 10) return t;
    const double along = n.dot(deepest.n_W);
    t += along > 1e-3 ? std::min(-deepest.distance / along + kRounding / 100, kLongestStep) : kLongestStep;
  }
  return limit;
}

/// Normals of the pieces that overlap, the way out of a corner by steps, and many directions.
std::vector<Vec3> directions_out(const PlacedPieces& a, const PlacedPieces& b, Draw& draw) {
  std::vector<Vec3> directions;
  for (std::size_t i = 0; i < a.shapes.size(); ++i) {
    for (std::size_t k = 0; k < b.shapes.size(); ++k) {
      const DistanceResult d = piece_distance(a, i, b, k);
      if (d.distance < 0) directions.push_back(d.n_W);
    }
  }
  Vec3 shift = Vec3::Zero();
  for (int step = 0; step < 12; ++step) {
    const DistanceResult deepest = deepest_pair(a, b, shift);
    if (deepest.distance == 0) break;
    shift -= deepest.distance * deepest.n_W;
  }
  directions.push_back(shift.normalized());
  for (int i = 0; i < 100; ++i) directions.push_back(draw.direction());
  return directions;
}

/// Whether some translation of at most the length parts the solids: along one of the directions out, or one
/// to which the best of them descends by random turns that become smaller.
bool parts(const PlacedPieces& a, const PlacedPieces& b, double length, Draw& draw) {
  double least = 10;
  Vec3 best = Vec3::UnitZ();
  const auto is_out = [&](const Vec3& n) {
    const double t = parting_length(a, b, n, least);
    const bool is_better = t < least;
    if (is_better) {
      least = t;
      best = n;
    }
    return is_better;
  };
  for (const Vec3& n : directions_out(a, b, draw)) {
    is_out(n);
    if (least <= length) return true;
  }
  for (double turn = 0.3; turn > 1e-10 && least > length; turn *= 0.5) {
    for (int tries = 0; tries < 12 && least > length;)
      tries = is_out((best + turn * draw.direction()).normalized()) ? 0 : tries + 1;
  }
  return least <= length;
}

/// Checks one overlapping pair: no translation as long as the upper bound parts the solids, and one as long
/// as the lower bound does.
void expect_true_bounds(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB, Draw& draw) {
  const DistanceResult d = signed_distance(a, X_WA, b, X_WB);
  if (d.distance >= -1e-5) return;
  EXPECT_LE(d.lower, d.distance);
  EXPECT_LE(d.distance, d.upper);
  EXPECT_LT((d.p_WB - d.p_WA - d.distance * d.n_W).norm(), kRounding);
  const PlacedPieces of_a = placed_pieces(a, X_WA), of_b = placed_pieces(b, X_WB);
  for (int i = 0; i < 10; ++i)
    EXPECT_TRUE(overlap(of_a, of_b, -0.999 * (d.upper + kRounding) * draw.direction()));
  EXPECT_TRUE(overlap(of_a, of_b, -0.999 * d.upper * d.n_W));
  EXPECT_TRUE(parts(of_a, of_b, -d.lower + kRounding, draw));
  // What overlaps is in contact, and every contact keeps its law.
  const std::vector<ContactPoint> contacts = contact_set(a, X_WA, b, X_WB, 1e-6);
  EXPECT_FALSE(contacts.empty());
  for (const ContactPoint& c : contacts) EXPECT_LT((c.p_WB - c.p_WA - c.gap * c.n_W).norm(), 1e-6);
}

TEST(MeshBounds, OfAConvexShapeInASolidHold) {
  Draw draw(31);
  for (const auto& [name, mesh] : solids()) {
    for (int kind = 0; kind < Draw::kKinds - 1; ++kind) {
      SCOPED_TRACE(name + ", kind " + std::to_string(kind));
      const Shape shape = draw.shape(kind);
      const Pose X_WA = draw.pose(0.5), X_WB = draw.pose(1);
      expect_true_bounds(mesh, X_WA, shape, X_WB, draw);
    }
  }
}

TEST(MeshBounds, OfTwoSolidsHold) {
  Draw draw(32);
  const auto all = solids();
  for (const auto& [name_a, a] : all) {
    for (const auto& [name_b, b] : all) {
      SCOPED_TRACE(name_a + " and " + name_b);
      const Pose X_WA = draw.pose(0.5), X_WB = draw.pose(0.8);
      expect_true_bounds(a, X_WA, b, X_WB, draw);
    }
  }
}

TEST(MeshBounds, MeetWhereTheWayOutIsKnown) {
  // A cube of side 0.2 in the L: 0.6 to the faces about the corner cube, also astride of the border between
  // the arms, where none of the two halves alone would be as deep.
  const Mesh l = as_mesh(l_solid());
  for (const Vec3& p : {Vec3(0.5, 0.5, 0.5), Vec3(1, 0.5, 0.5), Vec3(0.5, 1, 0.5)}) {
    const DistanceResult d = signed_distance(l, {}, Box{Vec3::Constant(0.1)}, at(p.x(), p.y(), p.z()));
    EXPECT_NEAR(d.lower, -0.6, kRounding);
    EXPECT_LE(d.distance, -0.5 + kRounding);
  }
  // 1 mm deep in the floor of the notch, and 2 mm in its wall: less than both together, more than one.
  const DistanceResult corner = signed_distance(l, {}, Box{Vec3::Constant(0.1)}, at(1.098, 1.099, 0.5));
  EXPECT_NEAR(corner.distance, -0.002, kRounding);
  EXPECT_LE(corner.lower, -std::hypot(0.001, 0.002) + kRounding);
}

/// Prints how the bounds of overlapping meshes enclose the distance; tools/study_meshes.sh calls it.
TEST(MeshBounds, OfShallowOverlapsAreNarrow) {
  const char* const wanted = std::getenv("RIGOR_STUDY_POSES");
  const int poses = wanted != nullptr ? std::atoi(wanted) : 12;
  Draw draw(33);
  std::vector<std::pair<std::string, Mesh>> all = solids();
  if (wanted != nullptr) {
    all.emplace_back("bumpy 320", as_mesh(bumpy_ball(2, 0.1)));
    all.emplace_back("bumpy 1280", as_mesh(bumpy_ball(3, 0.1)));
    all.emplace_back("bumpy 5120", as_mesh(bumpy_ball(4, 0.1)));
  }
  for (const auto& [name, mesh] : all) {
    solid_of(mesh)->pieces();  // Once for each mesh, not a part of a query.
    std::vector<double> ratios;
    double us = 0;
    for (int i = 0; i < poses; ++i) {
      // From outside to a depth of 1e-5 to 1e-2 m.
      const Pose X_WA = draw.pose(0.5);
      Pose X_WB{draw.rotation(), X_WA.p + 4 * draw.direction()};
      const DistanceResult apart = signed_distance(mesh, X_WA, mesh, X_WB);
      X_WB.p -= (apart.distance + 1e-5 * std::pow(1e3, draw.uniform(0, 1))) * apart.n_W;
      const std::clock_t begin = std::clock();
      const DistanceResult d = signed_distance(mesh, X_WA, mesh, X_WB);
      us += 1e6 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
      if (d.distance < 0) ratios.push_back(d.distance / d.lower);
    }
    std::ranges::sort(ratios);
    ASSERT_FALSE(ratios.empty());
    if (wanted != nullptr)
      std::printf("%-12s depth / lower bound: least %.3f median %.3f, %.0f us a query\n", name.c_str(),
                  ratios.front(), ratios[ratios.size() / 2], us / poses);
    EXPECT_GT(ratios[ratios.size() / 2], 0.5) << name;
  }
}

}  // namespace
}  // namespace rigor::mesh_bounds_test
