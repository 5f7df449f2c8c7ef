#include "rigor/geometry/decomposition/convex_decomposition.hpp"

#include "geometry/solid_shapes.hpp"
#include "rigor/geometry/decomposition/hull_excess.hpp"

#include <gtest/gtest.h>

namespace rigor::convex_decomposition_test {
namespace {

using namespace test;

/// Rounding of a few hundred cuts, and of areas cut out of planes, for solids of a size near 1 m.
constexpr double kRounding = 1e-12;

/// What holds for every exact decomposition, whatever the solid.
ConvexDecomposition expect_exact(const Mesh& mesh, double resolution = 0.05) {
  const ConvexDecomposition d = decompose(mesh);
  EXPECT_TRUE(d.is_exact);
  EXPECT_EQ(d.error, 0);
  const DecompositionCheck check = check_decomposition(mesh, d, resolution);
  EXPECT_LT(check.volume_error, kRounding);
  EXPECT_LT(check.area_error, kRounding);
  EXPECT_LT(check.deepest_overlap, kRounding);
  EXPECT_LE(check.excess, 2 * resolution);
  return d;
}

TEST(ConvexDecomposition, AConvexSolidIsOnePieceWithRealFacesOnly) {
  const ConvexDecomposition d = expect_exact(as_mesh(make_box_mesh({-1, -2, -3}, {1, 2, 3})));
  ASSERT_EQ(d.pieces.size(), 1u);
  EXPECT_EQ(d.pieces[0].hull->vertices.size(), 8u);
  for (const double share : d.pieces[0].real_share) EXPECT_EQ(share, 1);
}

TEST(ConvexDecomposition, AnLIsTwoBoxesWithAVirtualFaceBetweenThem) {
  const ConvexDecomposition d = expect_exact(as_mesh(l_solid()));
  ASSERT_EQ(d.pieces.size(), 2u);
  int virtual_faces = 0;
  double virtual_area = 0;
  for (const ConvexPiece& piece : d.pieces) {
    EXPECT_EQ(piece.hull->vertices.size(), 8u);
    for (const double share : piece.real_share) {
      if (share == 1) continue;
      ++virtual_faces;
      // The cut is a unit square: all of a face of one box, half of a face of the other.
      virtual_area += share == 0 ? 1 : 2 * (1 - share);
    }
  }
  EXPECT_EQ(virtual_faces, 2);
  EXPECT_NEAR(virtual_area, 2, kRounding);
}

TEST(ConvexDecomposition, KnownSolidsNeedFewPieces) {
  // Four corners at the hole, each resolved by one of four cuts; a cut through the cavity takes two opposite
  // walls at once; a ring of n straight parts is n wedges.
  EXPECT_EQ(expect_exact(as_mesh(cube_with_hole())).pieces.size(), 4u);
  EXPECT_EQ(expect_exact(as_mesh(cube_with_cavity())).pieces.size(), 6u);
  EXPECT_EQ(expect_exact(as_mesh(torus_solid(0.4, 12, 8))).pieces.size(), 12u);
  // n notches of a star or gear are resolved by n cuts at most, so by n + 1 pieces.
  EXPECT_LE(expect_exact(as_mesh(star_solid(5, 0.4))).pieces.size(), 6u);
  EXPECT_LE(expect_exact(as_mesh(gear_solid(16))).pieces.size(), 33u);
}

TEST(ConvexDecomposition, RandomPrismsAreExactInEveryPose) {
  Draw draw(1);
  for (int i = 0; i < 12; ++i) {
    const PolygonMesh prism = random_prism(draw, 6 + 2 * i);
    const std::size_t count = expect_exact(as_mesh(prism), 0.2).pieces.size();
    EXPECT_LE(count, static_cast<std::size_t>(6 + 2 * i - 2));  // no more than a triangulation
    expect_exact(as_mesh(moved(prism, draw.pose(3))), 0.2);
  }
}

TEST(ConvexDecomposition, ABumpyBallIsExactToo) {
  expect_exact(as_mesh(bumpy_ball(2, 0.3)), 0.2);
}

TEST(ConvexDecomposition, DoesNotDependOnTheUnit) {
  const Mesh gear = as_mesh(gear_solid(12));
  const ConvexDecomposition d = decompose(gear);
  for (const double unit : {1.0 / 1048576, 1048576.0}) {
    PolygonMesh scaled = gear_solid(12);
    for (Vec3& v : scaled.vertices) v *= unit;
    const ConvexDecomposition other = decompose(as_mesh(scaled));
    EXPECT_TRUE(other.is_exact);
    ASSERT_EQ(other.pieces.size(), d.pieces.size());
    EXPECT_NEAR(other.pieces_volume / (unit * unit * unit), d.pieces_volume, kRounding);
  }
}

TEST(ConvexDecomposition, TouchingSolidsAreParted) {
  // Two boxes with a common face: the surface is there twice, with no room between.
  const PolygonMesh pair = joined(make_box_mesh({0, 0, 0}, {1, 1, 1}), make_box_mesh({1, 0, 0}, {2, 1, 1}));
  const ConvexDecomposition d = decompose(as_mesh(pair));
  EXPECT_TRUE(d.is_exact);
  EXPECT_NEAR(d.pieces_volume, 2, kRounding);
  // Boxes that do not touch.
  const PolygonMesh apart =
      joined(make_box_mesh({0, 0, 0}, {1, 1, 1}), make_box_mesh({3, 0.5, 0}, {4, 1, 2}));
  EXPECT_EQ(expect_exact(as_mesh(apart)).pieces.size(), 2u);
}

TEST(ConvexDecomposition, WithToleranceStatesABoundOfWhatStandsOut) {
  const Mesh ball = as_mesh(bumpy_ball(2, 0.3));
  const ConvexDecomposition d = decompose(ball, {.tolerance = 0.2, .max_pieces = 64});
  EXPECT_FALSE(d.is_exact);
  EXPECT_GT(d.error, 0);
  EXPECT_LE(d.error, 0.2);
  EXPECT_LT(d.pieces.size(), 20u);
  // The union holds the solid, so it is larger; no two pieces overlap; the bound is found again without the
  // knowledge of how the pieces were made, up to its own gap.
  EXPECT_GT(d.pieces_volume, d.volume);
  const DecompositionCheck check = check_decomposition(ball, d, 0.01);
  EXPECT_LT(check.deepest_overlap, kRounding);
  EXPECT_LE(check.excess, 1.1 * d.error + 0.01);
  // Points that do stand out are within the bound: no hull's vertex is one, the farthest point of each is.
  const WindingNumber winding(*ball.mesh);
  double farthest = 0;
  for (const ConvexPiece& piece : d.pieces) {
    farthest = std::max(farthest, hull_excess(*piece.hull, ball, winding, {}).lower);
    EXPECT_LE(hull_excess(*piece.hull, ball, winding, {}).lower, piece.excess);
  }
  EXPECT_GT(farthest, 0.5 * d.error);
}

TEST(ConvexDecomposition, TheUnionHoldsTheSolid) {
  const Mesh ball = as_mesh(bumpy_ball(2, 0.3));
  const ConvexDecomposition d = decompose(ball, {.tolerance = 0.2, .max_pieces = 64});
  const WindingNumber winding(*ball.mesh);
  Draw draw(3);
  int inside = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 p(draw.uniform(-1, 1), draw.uniform(-1, 1), draw.uniform(-1, 1));
    if (winding(p) < 1) continue;
    ++inside;
    const bool is_held = std::any_of(d.pieces.begin(), d.pieces.end(), [&](const ConvexPiece& piece) {
      return contains(Convex{piece.hull}, p);
    });
    EXPECT_TRUE(is_held);
  }
  EXPECT_GT(inside, 1000);
}

TEST(ConvexDecomposition, FacesFlatInSinglePrecisionAreOneWithATolerance) {
  const PolygonMesh gear = gear_solid(12);
  PolygonMesh turned = moved(gear, {rotation_matrix(rotation_exp(Vec3(0.3, 0.4, 0.5))), Vec3::UnitX()});
  for (Vec3& v : turned.vertices) v = v.cast<float>().cast<double>();
  const Mesh mesh = as_mesh(turned);
  const ConvexDecomposition d = decompose(mesh, {.tolerance = 1e-4});
  EXPECT_EQ(d.pieces.size(), decompose(as_mesh(gear)).pieces.size());
  EXPECT_LE(d.error, 1e-4);
  // Volumes agree to the rounding of coordinates, 6e-8, times area over volume.
  EXPECT_NEAR(d.pieces_volume / d.volume, 1, 1e-6);
}

TEST(ConvexDecomposition, EndsAtTheMostPiecesAndWhenTold) {
  const Mesh ball = as_mesh(bumpy_ball(2, 0.3));
  const ConvexDecomposition few = decompose(ball, {.max_pieces = 5});
  EXPECT_LE(few.pieces.size(), 5u);
  EXPECT_FALSE(few.is_exact);
  EXPECT_GT(few.error, 0.1);
  int told = 0;
  const ConvexDecomposition one = decompose(ball, {.goes_on = [&told](int, double) {
                                              ++told;
                                              return false;
                                            }});
  EXPECT_GT(told, 0);
  EXPECT_EQ(one.pieces.size(), 1u);
  EXPECT_FALSE(one.is_exact);
}

TEST(ConvexDecomposition, SameMeshSamePiecesBitForBit) {
  const ConvexDecomposition a = decompose(as_mesh(gear_solid(9))), b = decompose(as_mesh(gear_solid(9)));
  ASSERT_EQ(a.pieces.size(), b.pieces.size());
  for (std::size_t i = 0; i < a.pieces.size(); ++i) {
    EXPECT_EQ(a.pieces[i].hull->vertices, b.pieces[i].hull->vertices);
  }
}

TEST(LipschitzMaximum, BoundsEncloseAKnownMaximum) {
  // Distance from the origin over the ball of radius 1 about (1, 0, 0): 2 at (2, 0, 0).
  LipschitzFunction f;
  f.value = [](const Vec3& p) { return p.norm(); };
  f.beyond = [](const Vec3& p) { return std::max(0.0, (p - Vec3::UnitX()).norm() - 1); };
  f.box = {Vec3(-1, -2, -2), Vec3(3, 2, 2)};
  const MaximumBounds found = lipschitz_maximum(f, {.relative_gap = 0.02});
  EXPECT_LE(found.lower, 2);
  EXPECT_GE(found.upper, 2);
  EXPECT_LE(found.upper - found.lower, 0.02 * found.lower);
  EXPECT_EQ(found.place.norm(), found.lower);
  // Bounds hold also when the search is cut short.
  const MaximumBounds rough = lipschitz_maximum(f, {.relative_gap = 0.02, .max_evaluations = 20});
  EXPECT_GE(rough.upper, 2);
  EXPECT_LE(rough.lower, 2);
}

}  // namespace
}  // namespace rigor::convex_decomposition_test
