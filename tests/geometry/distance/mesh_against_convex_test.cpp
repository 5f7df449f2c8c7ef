#include "geometry/mesh_against_convex.hpp"

#include "rigor/geometry/mesh/triangle_tree.hpp"

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <numbers>

#include <gtest/gtest.h>

namespace rigor::mesh_against_convex_test {
namespace {

using namespace rigor::test;

constexpr double kTolerance = 1e-6;  ///< Of the contact sets [m].

Mesh as_mesh(const TriangleMesh& mesh) {
  return make_mesh(std::make_shared<const TriangleMesh>(mesh));
}

/// Poses a cell: few in the test; tools/study_meshes.sh asks for more.
int pose_count(int by_default) {
  const char* const wanted = std::getenv("RIGOR_STUDY_POSES");
  return wanted != nullptr ? std::atoi(wanted) : by_default;
}
bool is_study() {
  return std::getenv("RIGOR_STUDY_POSES") != nullptr;
}

/// Boxes of 2 m and floors of 4 m, cut coarse and fine.
std::vector<MeshStudySolid> boxes() {
  std::vector<MeshStudySolid> solids;
  const Vec3 box = Vec3::Ones();
  for (const int cells : {1, 6, 31})
    solids.push_back({"box " + std::to_string(cells), as_mesh(make_grid_box(box, cells)), Box{box}, Pose{}});
  return solids;
}
std::vector<MeshStudySolid> floors() {
  std::vector<MeshStudySolid> solids;
  const Vec3 slab(2, 2, 1);
  const Pose below{Mat3::Identity(), Vec3(0, 0, -1)};
  for (const int cells : {1, 3, 8, 31}) {
    TriangleMesh mesh = make_grid_box(slab, cells);
    for (Vec3& v : mesh.vertices) v.z() -= 1;
    solids.push_back({"floor " + std::to_string(cells), as_mesh(mesh), Box{slab}, below});
  }
  for (const int cells : {1, 3, 8, 31}) {
    solids.push_back(
        {"sheet " + std::to_string(cells), as_mesh(make_grid_sheet(2, cells)), Box{slab}, below});
  }
  return solids;
}

/// Floors of solids that are not convex: beside a wall at the border, about a pillar in a corner and about a
/// well, and with a corner cut out, all farther away than the shapes reach.
std::vector<MeshStudySolid> rooms() {
  std::vector<MeshStudySolid> solids;
  const Pose below{Mat3::Identity(), Vec3(0, 0, -1)};
  const auto add = [&](const char* name, const TriangleMesh& cubes) {
    TriangleMesh mesh = cubes;
    // 16 cubes a side of 1/3 m; the floor is the top of the first layer.
    for (Vec3& v : mesh.vertices)
      v = Vec3(v.x() / 3 - 8.0 / 3, v.y() / 3 - 8.0 / 3, v.z() < 0.5 ? -2 : (v.z() - 1) / 3);
    solids.push_back({name, as_mesh(mesh), Box{Vec3(8.0 / 3, 8.0 / 3, 1)}, below});
  };
  add("wall", make_cube_mesh({16, 16, 4}, [](int i, int, int k) { return k == 0 || i == 15; }));
  add("pillar",
      make_cube_mesh({16, 16, 4}, [](int i, int j, int k) { return k == 0 || (i == 14 && j == 14); }));
  add("well", make_cube_mesh({16, 16, 1}, [](int i, int j, int) { return i != 14 || j != 14; }));
  add("corner", make_cube_mesh({16, 16, 1}, [](int i, int j, int) { return i < 14 || j < 14; }));
  return solids;
}

const char* kind_name(int kind) {
  static const std::vector<const char*> names = {"sphere", "box",    "capsule", "cylinder", "cone",
                                                 "ellips", "hull 8", "hull 32", "hull 128", "turned"};
  return names[static_cast<std::size_t>(kind)];
}

void print_head() {
  std::printf("%-10s %-9s %6s %6s %6s %7s %7s %6s %6s %6s %9s %7s %7s\n", "solid", "shape", "poses", "depth",
              "bounds", "normal", "missing", "extra", "empty", "law", "worst m", "d us", "set us");
}
void print(const std::string& solid, int kind, const MeshStudyCell& cell) {
  std::printf("%-10s %-9s %6d %6d %6d %7d %7d %6d %6d %6d %9.1e %7.1f %7.1f\n", solid.c_str(),
              kind_name(kind), cell.poses, cell.wrong_depth, cell.broken_bounds, cell.wrong_normal,
              cell.missing, cell.extra, cell.empty, cell.broken_law, cell.worst_depth,
              cell.distance_us / cell.poses, cell.contacts_us / cell.poses);
}

/// Any turn, the centre anywhere in a box about the solid, overlapping or not.
MeshStudyPose anywhere(Draw& draw) {
  return {draw.pose(1), draw.pose(1.4)};
}

/// Depth from 1e-6 to 0.5 m, spread evenly over the orders.
double random_depth(Draw& draw) {
  return 1e-6 * std::pow(5e5, draw.uniform(0, 1));
}

/// Tilted by up to 0.6 (often very little or not at all) about a random axis, the axes of the shape up, down
/// or sideways first, over the floor, no farther than
/// the reach from its middle along x and y [m], at a random depth.
MeshStudyPose on_floor(const Shape& shape, double reach, Draw& draw) {
  const double tilt = draw.uniform(0, 1) < 0.2 ? 0 : 0.6 * std::pow(10, draw.uniform(-6, 0));
  const double angle = draw.uniform(0, 2 * std::numbers::pi);
  const Mat3 lean = rotation_matrix(rotation_exp(tilt * Vec3(std::cos(angle), std::sin(angle), 0)));
  const Mat3 spin = rotation_matrix(rotation_exp(Vec3(0, 0, draw.uniform(0, 6))));
  const Mat3 quarter =
      rotation_matrix(rotation_exp(0.5 * std::numbers::pi * std::floor(draw.uniform(0, 4)) * Vec3::UnitX()));
  MeshStudyPose pose{
      Pose{}, {lean * spin * quarter, Vec3(draw.uniform(-reach, reach), draw.uniform(-reach, reach), 3)}};
  const Vec3 down_B = pose.X_WB.R.transpose() * -Vec3::UnitZ();
  // The lowest point goes to the depth, as far as the way up stays the shortest.
  const double height = support_value(shape, down_B) + support_value(shape, -down_B);
  pose.X_WB.p.z() = support_value(shape, down_B) - std::min(random_depth(draw), 0.3 * height);
  return pose;
}

TEST(MeshAgainstConvex, BoxesAtAnyPoseHaveTheDistanceOfTheConvex) {
  if (is_study()) print_head();
  for (const MeshStudySolid& solid : boxes()) {
    for (int kind = 0; kind < kMeshStudyKinds; ++kind) {
      Draw draw(100 + static_cast<std::uint64_t>(kind));
      MeshStudyCell cell;
      for (int i = 0; i < pose_count(30); ++i) {
        const Shape shape = mesh_study_shape(draw, kind);
        MeshStudy(solid, shape, kTolerance).compare(anywhere(draw), cell);
      }
      if (is_study()) print(solid.name, kind, cell);
      EXPECT_TRUE(cell.is_clean()) << solid.name << ", " << kind_name(kind);
    }
  }
}

TEST(MeshAgainstConvex, ShapesOnAFloorHaveTheContactsOfTheConvex) {
  if (is_study()) print_head();
  for (const MeshStudySolid& solid : floors()) {
    for (int kind = 0; kind < kMeshStudyKinds; ++kind) {
      Draw draw(200 + static_cast<std::uint64_t>(kind));
      MeshStudyCell cell;
      for (int i = 0; i < pose_count(30); ++i) {
        const Shape shape = mesh_study_shape(draw, kind);
        MeshStudy(solid, shape, kTolerance).compare(on_floor(shape, 1.2, draw), cell);
      }
      if (is_study()) print(solid.name, kind, cell);
      EXPECT_TRUE(cell.is_clean()) << solid.name << ", " << kind_name(kind);
    }
  }
}

TEST(MeshAgainstConvex, ShapesOnTheFloorOfARoomHaveTheContactsOfTheConvex) {
  if (is_study()) print_head();
  for (const MeshStudySolid& solid : rooms()) {
    for (int kind = 0; kind < kMeshStudyKinds; ++kind) {
      Draw draw(300 + static_cast<std::uint64_t>(kind));
      MeshStudyCell cell;
      for (int i = 0; i < pose_count(30); ++i) {
        const Shape shape = mesh_study_shape(draw, kind);
        MeshStudy(solid, shape, kTolerance).compare(on_floor(shape, 0.5, draw), cell);
      }
      if (is_study()) print(solid.name, kind, cell);
      EXPECT_TRUE(cell.is_clean()) << solid.name << ", " << kind_name(kind);
    }
  }
}

}  // namespace
}  // namespace rigor::mesh_against_convex_test
