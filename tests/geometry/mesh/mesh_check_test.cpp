#include "rigor/geometry/mesh/mesh_check.hpp"

#include "geometry/mesh_shapes.hpp"
#include "rigor/math/rotation.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <string>

namespace rigor::mesh_check_test {
namespace {

using Kind = MeshDefectKind;

/// The only defect of the mesh; fails if there is not exactly one.
MeshDefect only_defect(const PolygonMesh& mesh, const MeshCheckOptions& options = {}) {
  const std::vector<MeshDefect> defects = find_mesh_defects(mesh, options);
  EXPECT_EQ(defects.size(), 1u);
  for (const MeshDefect& defect : defects) SCOPED_TRACE(defect.text);
  return defects.empty() ? MeshDefect{Kind::empty, false, 0, "nothing"} : defects[0];
}

PolygonMesh unit_cube() {
  return make_box_mesh(Vec3::Zero(), Vec3::Ones());
}

PolygonMesh mesh_of(const nlohmann::json& solid) {
  PolygonMesh mesh;
  for (const nlohmann::json& v : solid["vertices"]) {
    const auto number = [](const nlohmann::json& x) { return x.is_null() ? std::nan("") : x.get<double>(); };
    mesh.vertices.emplace_back(number(v[0]), number(v[1]), number(v[2]));
  }
  mesh.faces = solid["faces"].get<std::vector<std::vector<int>>>();
  return mesh;
}

TEST(MeshCheck, FindsNothingInValidSolids) {
  const nlohmann::json data = nlohmann::json::parse(std::ifstream(RIGOR_TEST_DATA "/massprops.json"));
  for (const nlohmann::json& solid : data["valid"]) {
    for (const MeshDefect& defect : find_mesh_defects(mesh_of(solid)))
      ADD_FAILURE() << solid["name"] << ": " << defect.text;
    for (const MeshDefect& defect : find_mesh_defects(triangulated(mesh_of(solid)))) {
      ADD_FAILURE() << solid["name"] << ": " << defect.text;
    }
  }
  EXPECT_TRUE(find_mesh_defects(make_icosphere(3)).empty());
  EXPECT_TRUE(find_mesh_defects(make_uv_sphere(20, 30)).empty());
}

TEST(MeshCheck, RejectsInvalidSolidsForTheNamedReason) {
  const std::map<std::string, Kind> kinds = {
      {"inverted", Kind::inverted},         {"open_edge", Kind::open_edge},
      {"flipped_face", Kind::flipped_face}, {"not_planar", Kind::not_planar},
      {"zero_volume", Kind::zero_volume},   {"non_manifold_edge", Kind::non_manifold_edge},
      {"not_finite", Kind::not_finite}};
  const nlohmann::json data = nlohmann::json::parse(std::ifstream(RIGOR_TEST_DATA "/massprops.json"));
  ASSERT_EQ(data["invalid"].size(), 7u);
  for (const nlohmann::json& solid : data["invalid"]) {
    const std::vector<MeshDefect> defects = find_mesh_defects(mesh_of(solid));
    ASSERT_FALSE(defects.empty()) << solid["name"];
    EXPECT_TRUE(defects[0].is_error);
    EXPECT_EQ(defects[0].kind, kinds.at(solid["defect"].get<std::string>())) << defects[0].text;
    for (const MeshDefect& other : defects)
      EXPECT_TRUE(other.kind == defects[0].kind || !other.is_error) << other.text;
  }
}

TEST(MeshCheck, SaysWhichFacesAndEdges) {
  PolygonMesh open = unit_cube();
  open.faces.pop_back();
  EXPECT_EQ(only_defect(open).text,
            "the surface is not closed: 4 edges with one face only (1-3 of face 0, 1-5 of face 2, 3-7 of "
            "face 3 and 5-7 of face 1)");

  PolygonMesh bent = unit_cube();
  bent.vertices[7] = {2, 2, 2};
  const MeshDefect defect = only_defect(bent);
  EXPECT_EQ(defect.count, 3);
  EXPECT_EQ(defect.text.substr(0, 20), "3 faces (1, 3 and 5)");

  PolygonMesh lost = unit_cube();
  lost.faces[2][1] = 8;
  EXPECT_EQ(only_defect(lost).text, "face 2: vertex index out of range, the mesh has 8 vertices");
}

TEST(MeshCheck, NamesFaultsOfVerticesAndFaces) {
  EXPECT_EQ(only_defect({unit_cube().vertices, {}}).kind, Kind::empty);
  EXPECT_EQ(only_defect({}).kind, Kind::empty);
  PolygonMesh infinite = unit_cube();
  infinite.vertices[3].y() = std::numeric_limits<double>::infinity();
  EXPECT_EQ(only_defect(infinite).kind, Kind::not_finite);
  PolygonMesh negative = unit_cube();
  negative.faces[0][0] = -1;
  EXPECT_EQ(only_defect(negative).kind, Kind::index_out_of_range);
  PolygonMesh repeated = unit_cube();
  repeated.faces[0] = {0, 2, 2, 1};
  EXPECT_EQ(only_defect(repeated).kind, Kind::degenerate_face);
  PolygonMesh unused = unit_cube();
  unused.vertices.emplace_back(0.5, 0.5, 0.5);
  EXPECT_EQ(only_defect(unused).kind, Kind::unused_vertex);
  EXPECT_FALSE(only_defect(unused).is_error);
}

TEST(MeshCheck, RejectsFacesWithoutArea) {
  // A cube whose front has a needle of three vertices on one line at its lower edge.
  PolygonMesh mesh = unit_cube();
  mesh.vertices.emplace_back(0.5, 0, 0);
  mesh.faces[0] = {0, 2, 3, 1, 8};
  mesh.faces.push_back({0, 8, 1});
  const std::vector<MeshDefect> defects = find_mesh_defects(mesh);
  ASSERT_EQ(defects.size(), 1u);
  EXPECT_EQ(defects[0].kind, Kind::zero_area_face);
  EXPECT_EQ(defects[0].text, "face 6: no area, its vertices lie on one line");
}

TEST(MeshCheck, RejectsSizesWhoseInertiaLeavesTheRangeOfDoubles) {
  for (const double size : {1e-30, 1e25}) {
    EXPECT_EQ(only_defect(make_box_mesh(Vec3::Zero(), Vec3::Constant(size))).kind, Kind::size_out_of_range);
  }
  for (const double size : {1e-15, 1e15}) {
    EXPECT_TRUE(find_mesh_defects(make_box_mesh(Vec3::Zero(), Vec3::Constant(size))).empty());
  }
  EXPECT_EQ(only_defect(make_box_mesh(Vec3::Ones(), Vec3::Ones())).text, "all vertices lie at one point");
}

TEST(MeshCheck, AllowsForTheRoundingOfTurnedAndDistantFaces) {
  for (const Vec3& p : {Vec3(0, 0, 0), Vec3(1e3, 2e3, -5e3), Vec3(1e7, 0, 0)}) {
    const Pose X{rotation_matrix(rotation_exp({0.3, -0.7, 1.9})), p};
    for (const MeshDefect& defect : find_mesh_defects(moved(unit_cube(), X))) ADD_FAILURE() << defect.text;
  }
}

TEST(MeshCheck, RejectsAVolumeThatIsTinyAgainstTheBox) {
  // A plate across the diagonal of a cube, 1e-13 thick; the same plate along the axes fills its box.
  const Pose diagonal{rotation_matrix(rotation_exp({0.5, 0.6, 0.7})), Vec3::Zero()};
  const PolygonMesh plate = make_box_mesh(Vec3::Zero(), {1, 1, 1e-13});
  MeshCheckOptions options;
  options.self_intersections = false;
  EXPECT_TRUE(find_mesh_defects(plate, options).empty());
  EXPECT_EQ(only_defect(moved(plate, diagonal), options).kind, Kind::small_volume);
  options.volume_fraction = 1e-14;
  EXPECT_TRUE(find_mesh_defects(moved(plate, diagonal), options).empty());
}

TEST(MeshCheck, AcceptsCavitiesAndSeparateShells) {
  const PolygonMesh outer = make_box_mesh(Vec3::Zero(), Vec3::Constant(4));
  const PolygonMesh hole = inside_out(make_box_mesh(Vec3::Ones(), Vec3::Constant(3)));
  const PolygonMesh stone = make_box_mesh(Vec3::Constant(1.5), Vec3::Constant(2.5));
  EXPECT_TRUE(find_mesh_defects(joined(outer, hole)).empty());
  EXPECT_TRUE(find_mesh_defects(joined(joined(stone, hole), outer)).empty());
  EXPECT_TRUE(find_mesh_defects(joined(outer, moved(stone, {Mat3::Identity(), {9, 0, 0}}))).empty());
}

TEST(MeshCheck, RejectsShellsInTheWrongPlace) {
  const PolygonMesh outer = make_box_mesh(Vec3::Zero(), Vec3::Constant(4));
  const PolygonMesh inner = make_box_mesh(Vec3::Ones(), Vec3::Constant(3));
  EXPECT_EQ(only_defect(joined(outer, inner)).kind, Kind::misplaced_shell);
  const MeshDefect aside =
      only_defect(joined(outer, moved(inside_out(inner), {Mat3::Identity(), {4, 0, 0}})));
  EXPECT_EQ(aside.kind, Kind::misplaced_shell);
  EXPECT_NE(aside.text.find("face 6"), std::string::npos) << aside.text;
}

TEST(MeshCheck, WarnsOfPartsThatCutEachOther) {
  const PolygonMesh overlapping =
      joined(unit_cube(), moved(unit_cube(), {Mat3::Identity(), {0.5, 0.25, 0.125}}));
  const MeshDefect defect = only_defect(overlapping);
  EXPECT_EQ(defect.kind, Kind::self_intersection);
  EXPECT_FALSE(defect.is_error);
}

TEST(MeshCheck, NeverAcceptsABowTieInSilence) {
  // Two triangles tip to tip, the right one turned round by the crossing: areas 1 and -k².
  const PolygonMesh uneven = make_prism({{-1, -1}, {0.5, 0.5}, {0.5, -0.5}, {-1, 1}}, 1);
  EXPECT_EQ(find_mesh_defects(uneven).back().kind, Kind::self_intersection);
  const PolygonMesh nearly_plain = make_prism({{-1, -1}, {0.125, 0.125}, {0.125, -0.125}, {-1, 1}}, 1);
  EXPECT_EQ(only_defect(nearly_plain).kind, Kind::self_intersection);

  // With even halves the caps have no area, and cut into triangles the volume is zero.
  const PolygonMesh even = make_prism({{-1, -1}, {1, 1}, {1, -1}, {-1, 1}}, 1);
  EXPECT_EQ(only_defect(even).kind, Kind::zero_area_face);
  const std::vector<MeshDefect> defects = find_mesh_defects(triangulated(even));
  ASSERT_EQ(defects.size(), 2u);
  EXPECT_EQ(defects[0].kind, Kind::zero_volume);
  EXPECT_TRUE(defects[0].is_error);
  EXPECT_EQ(defects[1].kind, Kind::self_intersection);
}

TEST(MeshCheck, FindsAVertexPushedThroughTheOppositeSide) {
  TriangleMesh ball = make_icosphere(2);
  ball.vertices[0] *= -1.2;
  const std::vector<MeshDefect> defects = find_mesh_defects(ball);
  ASSERT_FALSE(defects.empty());
  EXPECT_EQ(defects.back().kind, Kind::self_intersection);
}

TEST(MeshCheck, FindsAFoldThatIsSharedByNeighboursOnly) {
  // A pyramid over a flat kite whose tip folds back on the kite itself.
  PolygonMesh mesh;
  mesh.vertices = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0.5, 0.5, 0}, {0, 0, 1}};
  mesh.faces = {{1, 0, 2}, {1, 2, 3}, {0, 1, 4}, {2, 0, 4}, {1, 3, 4}, {3, 2, 4}};
  const std::vector<MeshDefect> defects = find_mesh_defects(mesh);
  ASSERT_EQ(defects.size(), 1u);
  EXPECT_EQ(defects[0].kind, Kind::self_intersection);
  EXPECT_NE(defects[0].text.find("0 and 1"), std::string::npos) << defects[0].text;
}

TEST(MeshCheck, LetsStaticBodiesBeOpenButSaysSo) {
  PolygonMesh open = unit_cube();
  open.faces.pop_back();
  MeshCheckOptions options;
  options.may_be_open = true;
  const MeshDefect defect = only_defect(open, options);
  EXPECT_EQ(defect.kind, Kind::open_edge);
  EXPECT_FALSE(defect.is_error);
}

}  // namespace
}  // namespace rigor::mesh_check_test
