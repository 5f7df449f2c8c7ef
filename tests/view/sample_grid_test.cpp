#include "rigor/view/3d/sample_grid.hpp"

#include "rigor/view/3d/occlusion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace rigor::sample_grid_test {
namespace {

constexpr NearnessPlane near_plane{2, 0, 0}, far_plane{1, 0, 0};

int count(const SampleGrid& grid, int width, int height, std::uint32_t id) {
  int sum = 0;
  for (int y = 0; y < height; ++y) sum += static_cast<int>(std::count(grid.ids(y), grid.ids(y) + width, id));
  return sum;
}

/// Counter-clockwise as seen: on the picture, with y down, the sum of x dy - y dx is negative.
std::array<Vec2, 3> counter_clockwise(Vec2 a, Vec2 b, Vec2 c) {
  const Vec2 u = b - a, v = c - a;
  if (u.x() * v.y() - u.y() * v.x() > 0) std::swap(b, c);
  return {a, b, c};
}

TEST(SampleGrid, ATriangleCoversItsArea) {
  // Samples decide by their place: the error is that of counting lattice points, about the outline's length
  // to the power 2/3; half of the outline's length is safe.
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(1, 199);
  for (int trial = 0; trial < 100; ++trial) {
    const Vec2 a(place(random), place(random)), b(place(random), place(random)),
        c(place(random), place(random));
    SampleGrid grid(0.375, 0.125);
    grid.clear(200, 200);
    grid.fill(Outline(counter_clockwise(a, b, c)), near_plane, 7);
    const double area = 0.5 * std::abs((b - a).x() * (c - a).y() - (b - a).y() * (c - a).x());
    const double outline = (b - a).norm() + (c - b).norm() + (a - c).norm();
    EXPECT_NEAR(count(grid, 200, 200, 7), area, 0.5 * outline + 1);
  }
}

TEST(SampleGrid, TwoTrianglesWithACommonEdgeShareNoSampleAndLeaveNone) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(30, 70);
  for (int trial = 0; trial < 200; ++trial) {
    // Four triangles about a random middle fill the square from 10 to 90.
    const std::array<Vec2, 4> corners = {Vec2(10, 10), Vec2(10, 90), Vec2(90, 90), Vec2(90, 10)};
    const Vec2 middle(place(random), place(random));
    int sum = 0;
    SampleGrid all(0.5, 0.5);
    all.clear(100, 100);
    for (std::size_t i = 0; i < 4; ++i) {
      const std::array<Vec2, 3> triangle = {corners[i], corners[(i + 1) % 4], middle};
      SampleGrid one(0.5, 0.5);
      one.clear(100, 100);
      one.fill(Outline(triangle), near_plane, 1);
      all.fill(Outline(triangle), near_plane, 1);
      sum += count(one, 100, 100, 1);
    }
    ASSERT_EQ(sum, 80 * 80);
    ASSERT_EQ(count(all, 100, 100, 1), 80 * 80);
  }
}

TEST(SampleGrid, WhatIsNearerStaysWhateverComesFirst) {
  const std::array<Vec2, 4> square = {Vec2(2, 2), Vec2(2, 8), Vec2(8, 8), Vec2(8, 2)};
  for (const bool near_first : {true, false}) {
    SampleGrid grid(0.5, 0.5);
    grid.clear(10, 10);
    grid.fill(Outline(square), near_first ? near_plane : far_plane, near_first ? 1 : 2);
    grid.fill(Outline(square), near_first ? far_plane : near_plane, near_first ? 2 : 1);
    EXPECT_EQ(count(grid, 10, 10, 1), 36);
    EXPECT_EQ(count(grid, 10, 10, 2), 0);
    EXPECT_EQ(grid.nearness(5)[5], 2);
  }
}

TEST(SampleGrid, AFaceBeyondTheEdgesOfThePictureIsCut) {
  SampleGrid grid(0.5, 0.5);
  grid.clear(20, 10);
  const std::array<Vec2, 4> square = {Vec2(-1e6, -1e6), Vec2(-1e6, 1e6), Vec2(1e6, 1e6), Vec2(1e6, -1e6)};
  grid.fill(Outline(square), near_plane, 1);
  EXPECT_EQ(count(grid, 20, 10, 1), 200);
}

TEST(SampleGrid, ABallIsTheEllipseThatPerspectiveMakesOfIt) {
  // The outline of a ball at an angle t from the middle of the picture is an ellipse. With a the half angle
  // of its cone (sin a = r / distance), its axes are f sin a cos a / (cos² t - sin² a) along the radius of
  // the picture and f sin a / √(cos² t - sin² a) across it.
  const Projection projection(Camera{Vec3(0, -1, 0), Vec3::Zero(), Vec3::UnitZ(), M_PI / 3}, 800, 800);
  for (const Vec3& p_K : {Vec3(0, 0, 5), Vec3(1.2, 0.7, 5), Vec3(-1, 1, 4)}) {
    const double r = 0.8, f = projection.focal_length(), sin_a = r / p_K.norm(), cos_t = p_K.z() / p_K.norm();
    const double k = cos_t * cos_t - sin_a * sin_a;
    const double along = f * sin_a * std::sqrt(1 - sin_a * sin_a) / k, across = f * sin_a / std::sqrt(k);
    SampleGrid grid(0.5, 0.5);
    grid.clear(800, 800);
    grid.fill(ViewSpaceBall{p_K, r}, projection, 3);
    EXPECT_NEAR(count(grid, 800, 800, 3), M_PI * along * across, 2 * (along + across));
  }
}

TEST(SampleGrid, TheNearestPointOfABallIsItsRadiusBeforeItsCenter) {
  const Projection projection(Camera{Vec3(0, -1, 0), Vec3::Zero(), Vec3::UnitZ(), M_PI / 3}, 101, 101);
  SampleGrid grid(0.5, 0.5);
  grid.clear(101, 101);
  grid.fill(ViewSpaceBall{Vec3(0, 0, 5), 0.5}, projection, 1);
  EXPECT_NEAR(1 / grid.nearness(50)[50], 4.5, 1e-5);
}

TEST(Occlusion, HidesWhatIsBehindAWholeTileAndNothingElse) {
  std::array<SampleGrid, 1> grids = {SampleGrid(0.5, 0.5)};
  grids[0].clear(64, 64);
  Occlusion occlusion(grids, 64, 64);
  const std::array<Vec2, 4> left_half = {Vec2(0, 0), Vec2(0, 64), Vec2(32, 64), Vec2(32, 0)};
  grids[0].fill(Outline(left_half), near_plane, 1);
  occlusion.add({0, 32, 0, 64, 2});
  EXPECT_TRUE(occlusion.hides({3, 20, 3, 60, 1.5}));
  EXPECT_FALSE(occlusion.hides({3, 20, 3, 60, 2.5}));
  EXPECT_FALSE(occlusion.hides({3, 40, 3, 60, 1.5}));
  EXPECT_TRUE(occlusion.hides({-50, -10, 3, 60, 9}));
  EXPECT_TRUE(occlusion.hides({3, 60, 70, 90, 9}));
}

}  // namespace
}  // namespace rigor::sample_grid_test
