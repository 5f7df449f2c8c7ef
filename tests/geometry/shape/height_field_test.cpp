#include "rigor/geometry/shape/height_field.hpp"
#include "rigor/geometry/contacts/contact_set.hpp"
#include "rigor/geometry/decomposition/make_mesh.hpp"
#include "rigor/geometry/mass/mass_properties.hpp"
#include "rigor/geometry/mesh/mesh_check.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/math/splitmix64.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace rigor::height_field_test {
namespace {

constexpr double kEpsilon = 2.22e-16;

/// Heights f(x, y) over a grid of that many cells.
template <typename Function>
HeightField field_of(const Function& f, int cells_x, int cells_y, const Vec2& size, double base_depth) {
  HeightField field{{}, size, base_depth};
  for (int i = 0; i <= cells_y; ++i) {
    std::vector<double>& row = field.rows.emplace_back();
    for (int j = 0; j <= cells_x; ++j) {
      row.push_back(f(size.x() * (double(j) / cells_x - 0.5), size.y() * (double(i) / cells_y - 0.5)));
    }
  }
  return field;
}

double zero(double, double) {
  return 0;
}

TEST(HeightFieldMesh, HasTheCountsOfItsGridAndIsAClosedSurfaceWithoutDefects) {
  SplitMix64 random(5);
  const auto noise = [&](double, double) { return 0.3 * random.symmetric(); };
  for (const auto& [n, m] : {std::pair{1, 1}, {1, 7}, {6, 1}, {9, 14}}) {
    const TriangleMesh mesh = make_height_field_mesh(field_of(noise, n, m, {2, 3}, 0.1));
    EXPECT_EQ(mesh.triangles.size(), static_cast<std::size_t>(2 * n * m + 6 * (n + m)));
    EXPECT_EQ(mesh.vertices.size(), static_cast<std::size_t>((n + 1) * (m + 1) + 2 * (n + m) + 1));
    for (const MeshDefect& defect : find_mesh_defects(mesh)) ADD_FAILURE() << n << "x" << m << defect.text;
  }
}

TEST(HeightFieldMesh, PutsRowsAlongXOneAfterTheOtherAlongY) {
  const HeightField field{{{0.1, 0.2, 0.3}, {0.4, 0.5, 0.6}}, {4, 2}, 1};
  const TriangleMesh mesh = make_height_field_mesh(field);
  EXPECT_EQ(mesh.vertices[0], Vec3(-2, -1, 0.1));
  EXPECT_EQ(mesh.vertices[2], Vec3(2, -1, 0.3));
  EXPECT_EQ(mesh.vertices[4], Vec3(0, 1, 0.5));
  EXPECT_EQ(lowest_height(field), 0.1);
}

// The volume over a cell is its area times the mean height of its corners only if it is planar; heights
// f(x) + g(y) give planar cells, so the trapezoidal sum is exact.
TEST(HeightFieldMesh, OfHeightsThatAreSumsHasTheVolumeOfTheTrapezoidalRule) {
  const auto hills = [](double x, double y) { return 0.3 * std::cos(2 * x) + 0.2 * std::sin(3 * y); };
  const HeightField field = field_of(hills, 12, 17, {2, 3}, 0.25);
  double sum = 0;
  for (std::size_t i = 0; i <= 17; ++i) {
    for (std::size_t j = 0; j <= 12; ++j) {
      const double weight = (i == 0 || i == 17 ? 0.5 : 1) * (j == 0 || j == 12 ? 0.5 : 1);
      sum += weight * (field.rows[i][j] - lowest_height(field) + 0.25);
    }
  }
  const double volume = sum * (2.0 / 12) * (3.0 / 17);
  EXPECT_NEAR(mass_properties(make_height_field_mesh(field), 1).mass, volume, 100 * kEpsilon * volume);
}

TEST(HeightFieldMesh, OfAFlatFieldHasTheMassOfABox) {
  const MassProperties field = mass_properties(make_height_field_mesh(field_of(zero, 6, 5, {2, 3}, 0.5)), 7);
  const double mass = 7 * 2 * 3 * 0.5;
  EXPECT_NEAR(field.mass, mass, 50 * kEpsilon * mass);
  EXPECT_LT((field.center - Vec3(0, 0, -0.25)).norm(), 50 * kEpsilon);
  const Vec3 moments(9 + 0.25, 4 + 0.25, 4 + 9);
  EXPECT_LT((field.inertia - Mat3((mass / 12 * moments).asDiagonal())).norm(), 200 * kEpsilon * mass);
}

TEST(HeightFieldMesh, OfSymmetricHeightsIsSymmetricOverEvenNumbersOfCells) {
  SplitMix64 random(8);
  HeightField field = field_of([&](double, double) { return random.uniform(); }, 6, 4, {3, 2}, 0.2);
  for (std::vector<double>& row : field.rows) {
    for (std::size_t j = 0; j < 3; ++j) row[6 - j] = row[j];
  }
  const TriangleMesh mesh = make_height_field_mesh(field);
  // Triangles of the cells as sets of corners, the original ones and those with x turned about.
  using Corner = std::array<double, 3>;
  std::set<std::array<Corner, 3>> triangles, mirrored;
  for (std::size_t i = 0; i < 2 * 6 * 4; ++i) {
    const std::array<int, 3>& triangle = mesh.triangles[i];
    std::array<Corner, 3> corners, mirror;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p = mesh.vertices[static_cast<std::size_t>(triangle[k])];
      corners[k] = {p.x(), p.y(), p.z()};
      mirror[k] = {0 - p.x(), p.y(), p.z()};
    }
    std::sort(corners.begin(), corners.end());
    std::sort(mirror.begin(), mirror.end());
    triangles.insert(corners);
    mirrored.insert(mirror);
  }
  EXPECT_EQ(triangles, mirrored);
}

// Ghost contacts would be further points, or normals that lean.
TEST(HeightFieldMesh, OfAFlatFieldTouchesBoxesAndBallsAsAPlaneDoes) {
  const Mesh ground = make_mesh(
      std::make_shared<const TriangleMesh>(make_height_field_mesh(field_of(zero, 20, 20, {2, 2}, 0.1))));
  const HalfSpace plane{Vec3::UnitZ(), 0};
  const Box block{Vec3(0.17, 0.11, 0.05)};
  const Sphere ball{0.05};
  for (const double x : {0.0, 0.013, 0.05, 0.1, -0.3}) {
    const Pose X_WB{Mat3(Eigen::AngleAxisd(7 * x, Vec3::UnitZ())), Vec3(x, 2 * x, 0.05)};
    for (const Shape& shape : {Shape(block), Shape(ball)}) {
      const std::vector<ContactPoint> found = contact_set(ground, Pose{}, shape, X_WB, 1e-6);
      const std::vector<ContactPoint> expected = contact_set(plane, Pose{}, shape, X_WB, 1e-6);
      ASSERT_EQ(found.size(), expected.size()) << x;
      for (const ContactPoint& point : expected) {
        const auto is_at = [&](const ContactPoint& other) {
          return (other.p_WB - point.p_WB).norm() < 10 * kEpsilon && other.n_W == Vec3::UnitZ();
        };
        EXPECT_TRUE(std::any_of(found.begin(), found.end(), is_at)) << x;
      }
    }
  }
}

}  // namespace
}  // namespace rigor::height_field_test
