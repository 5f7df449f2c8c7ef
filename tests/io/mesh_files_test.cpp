#include "rigor/io/mesh/mesh_files.hpp"

#include "geometry/mesh_shapes.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/geometry/mass/mass_properties.hpp"
#include "rigor/geometry/mesh/mesh_check.hpp"
#include "rigor/io/mesh/obj_file.hpp"
#include "rigor/io/mesh/ply_file.hpp"
#include "rigor/io/mesh/stl_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <string>

namespace rigor::mesh_files_test {
namespace {

const std::string kMeshes = RIGOR_TEST_DATA "/meshes/";

/// The message of the InputError, or "no error".
std::string error_of(const std::function<void()>& run) {
  try {
    run();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::string obj_error(const std::string& text) {
  return error_of([&] { parse_obj(text, "a.obj"); });
}
std::string stl_error(const std::string& bytes) {
  return error_of([&] { parse_stl(bytes, "a.stl"); });
}
std::string ply_error(const std::string& bytes) {
  return error_of([&] { parse_ply(bytes, "a.ply"); });
}
std::string file_error(const std::string& name) {
  const std::string text = error_of([&] { read_mesh(kMeshes + name); });
  return text.starts_with(kMeshes) ? text.substr(kMeshes.size()) : text;
}

bool starts_with(const std::string& text, const std::string& start) {
  return text.substr(0, start.size()) == start;
}

/// A file that is removed at the end.
class TemporaryFile {
 public:
  TemporaryFile(const std::string& name, const std::string& bytes)
      : path_(std::filesystem::path(::testing::TempDir()) /
              ("rigor_" + std::to_string(std::hash<std::string>{}(bytes)) + name)) {
    std::ofstream(path_, std::ios::binary) << bytes;
  }
  ~TemporaryFile() { std::filesystem::remove(path_); }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Appends numbers as bytes, little or big end first.
class Bytes {
 public:
  explicit Bytes(bool is_big_endian = false) : is_big_endian_(is_big_endian) {}
  template <class Unsigned>
  Bytes& whole(Unsigned value) {
    std::string bytes;
    for (std::size_t i = 0; i < sizeof(value); ++i) bytes += static_cast<char>((value >> (8 * i)) & 0xFF);
    if (is_big_endian_) std::reverse(bytes.begin(), bytes.end());
    text += bytes;
    return *this;
  }
  Bytes& real(float value) { return whole(std::bit_cast<std::uint32_t>(value)); }
  Bytes& real(double value) { return whole(std::bit_cast<std::uint64_t>(value)); }

  std::string text;

 private:
  bool is_big_endian_;
};

std::string binary_stl(const TriangleMesh& mesh, const std::string& header) {
  Bytes bytes;
  bytes.text = header + std::string(80 - header.size(), ' ');
  bytes.whole(static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const std::array<int, 3>& triangle : mesh.triangles) {
    for (int i = 0; i < 3; ++i) bytes.real(0.0f);
    for (const int v : triangle) {
      for (int i = 0; i < 3; ++i)
        bytes.real(static_cast<float>(mesh.vertices[static_cast<std::size_t>(v)][i]));
    }
    bytes.whole(std::uint16_t{0});
  }
  return bytes.text;
}

const std::string kTetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

void expect_tetrahedron(const PolygonMesh& mesh) {
  EXPECT_EQ(mesh.vertices.size(), 4u);
  EXPECT_EQ(mesh.faces.size(), 4u);
  EXPECT_NEAR(mass_properties(mesh, 1).mass, 1.0 / 6, 1e-16);
  EXPECT_TRUE(find_mesh_defects(mesh).empty());
}

TEST(ObjFile, GivesItsVerticesAndFaces) {
  expect_tetrahedron(parse_obj(kTetrahedron, "a.obj"));
}

TEST(ObjFile, MayHaveTexturesNormalsNegativeIndicesCommentsContinuationAndCarriageReturns) {
  expect_tetrahedron(
      parse_obj("\xEF\xBB\xBF# a comment\r\nmtllib x.mtl\r\no thing\r\nv 0 0 0 # here\r\nv +1. 0 0\r\nv 0 "
                "1e0 0 0.5 0.5 0.5\r\nv 0 0 1 1.0\r\n"
                "vt 0 0\r\nvn 0 0 1\r\ns off\r\nusemtl red\r\nf 1/1 3/1 2/1\r\nf -4//1 -3//1 -1//1\r\nf "
                "1/1/1 \\\r\n4/1/1 3/1/1\r\nf 2 3 4",
                "a.obj"));
}

TEST(ObjFile, MayHaveFacesBeforeTheirVertices) {
  expect_tetrahedron(
      parse_obj("f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n", "a.obj"));
}

TEST(ObjFile, RefusesNumbersThatAreNone) {
  for (const char* number : {"1,5", "0x10", "1e", "--1", "+-1", "nan", "inf", "-infinity", "1.5f", "one",
                             "1_000", "1e999", "1e-999"}) {
    const std::string error = obj_error("v 0 0 0\nv 0 " + std::string(number) + " 0\n");
    EXPECT_TRUE(starts_with(error, "a.obj:2: '" + std::string(number) + "' is ")) << error;
  }
  EXPECT_EQ(obj_error("v 0 0 1,5\n"),
            "a.obj:1: '1,5' is not a number; allowed are finite decimal numbers such as -1.5 or 2e-3");
}

TEST(ObjFile, RefusesWhatItDoesNotUnderstandWithTheLine) {
  EXPECT_TRUE(starts_with(obj_error("v 0 0\n"), "a.obj:1: a vertex with 2 numbers"));
  EXPECT_TRUE(starts_with(obj_error("v 0 0 0 2\n"), "a.obj:1: the weight of a vertex must be 1"));
  EXPECT_TRUE(starts_with(obj_error("\n\ncurv 0 1 1 2\n"), "a.obj:3: 'curv' is not a statement"));
  EXPECT_TRUE(starts_with(obj_error("V 0 0 0\n"), "a.obj:1: 'V' is not a statement"));
  EXPECT_TRUE(starts_with(obj_error(kTetrahedron + "f 1 2\n"), "a.obj:9: a face with 2 vertices"));
  EXPECT_TRUE(starts_with(obj_error(kTetrahedron + "f 1 2 3 \\"),
                          "a.obj:9: the file ends in a line that is to be continued"));
  EXPECT_TRUE(starts_with(obj_error("v 0 0 0\n"), "a.obj:1: the file has no faces"));
  EXPECT_TRUE(starts_with(obj_error(std::string("v \0 1 2\n", 8)), "a.obj:1: '\\x00' is not a number"));
  for (const char* corner : {"1/", "/1", "1//", "1/2/", "1/2/3/4", "1/0", "a/b/c", "1.5", "1/x"}) {
    EXPECT_TRUE(starts_with(obj_error("v 0 0 0\nf " + std::string(corner) + " 1 1\n"), "a.obj:2: '"))
        << corner;
  }
}

TEST(ObjFile, RefusesIndicesOutOfRange) {
  EXPECT_EQ(obj_error(kTetrahedron + "f 1 2 5\n"),
            "a.obj:9: vertex index 5 is out of range; the file has 4 vertices, counted from 1");
  for (const char* index : {"0", "-5", "2147483648", "4294967297"}) {
    const std::string error = obj_error(kTetrahedron + "f 1 2 " + index + "\n");
    EXPECT_TRUE(starts_with(error, "a.obj:9: vertex index " + std::string(index) + " is out of range"))
        << error;
  }
  EXPECT_TRUE(starts_with(obj_error(kTetrahedron + "f 1 2 99999999999999999999\n"),
                          "a.obj:9: '99999999999999999999' is too large"));
}

TEST(StlFile, BinaryIsWeldedToAClosedMesh) {
  const TriangleMesh ball = make_icosphere(2);
  const PolygonMesh mesh = parse_stl(binary_stl(ball, "made by a test"), "a.stl");
  EXPECT_EQ(mesh.vertices.size(), ball.vertices.size());
  EXPECT_EQ(mesh.faces.size(), ball.triangles.size());
  EXPECT_TRUE(find_mesh_defects(mesh).empty());
}

TEST(StlFile, BinaryMayStartWithSolid) {
  const TriangleMesh cube = triangulated(make_box_mesh(Vec3::Zero(), Vec3::Ones()));
  EXPECT_EQ(parse_stl(binary_stl(cube, "solid cube exported"), "a.stl").vertices.size(), 8u);
  EXPECT_EQ(read_mesh(kMeshes + "binary_with_solid.stl").faces.size(), 12u);
}

const std::string kFacet =
    " facet normal nan 0 -0\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n   vertex -0 1e0 0\n  endloop\n "
    "endfacet\n";

TEST(StlFile, AsciiMayHaveSeveralSolidsInAnyCaseAndLayout) {
  const PolygonMesh mesh = parse_stl("SOLID a b\n" + kFacet +
                                         "endsolid a b\nsolid\nFacet Normal 0 0 1 outer loop vertex 0 0 0\n"
                                         "vertex 0 1 0 vertex\n 5 5 5 endloop endfacet endsolid\n",
                                     "a.stl");
  EXPECT_EQ(mesh.faces, (std::vector<std::vector<int>>{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(mesh.vertices[2], Vec3(0, 1, 0));
}

TEST(StlFile, RefusesCountsThatDoNotFitTheFile) {
  std::string bytes = binary_stl(make_icosphere(0), "x");
  EXPECT_EQ(stl_error(bytes + "x"),
            "a.stl: byte 80: the header promises 20 triangles, that is 1084 bytes; the file has 1085");
  bytes.pop_back();
  EXPECT_EQ(stl_error(bytes),
            "a.stl: byte 80: the header promises 20 triangles, that is 1084 bytes; the file has 1083");
  EXPECT_TRUE(starts_with(stl_error("short"), "a.stl: byte 5: the file is cut off"));
  EXPECT_EQ(stl_error(std::string(84, '\0')), "a.stl: byte 84: the file has no triangles");
}

TEST(StlFile, RefusesCoordinatesThatAreNotFinite) {
  TriangleMesh mesh = make_icosphere(0);
  mesh.vertices[static_cast<std::size_t>(mesh.triangles[1][2])].y() = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(starts_with(stl_error(binary_stl(mesh, "x")), "a.stl: byte "));
  EXPECT_TRUE(starts_with(stl_error("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 nan 0\n"),
                          "a.stl:4: 'nan' is not a number"));
}

TEST(StlFile, RefusesAsciiThatIsCutOffOrMixedUp) {
  const std::string whole = "solid\n" + kFacet + "endsolid\n";
  for (const std::size_t length : {5u, 30u, 60u, 100u}) {
    const std::string error = stl_error(whole.substr(0, length));
    EXPECT_TRUE(starts_with(error, "a.stl:")) << error;
  }
  EXPECT_EQ(stl_error("solid\n" + kFacet), "a.stl:8: the file is cut off: 'endsolid' is missing");
  EXPECT_EQ(stl_error("solid\nendsolid\n"), "a.stl:2: the file has no facets");
  EXPECT_EQ(stl_error("solid\nfacet normal 0 0 1\nloop\n"), "a.stl:3: 'loop' stands where 'outer' must be");
  EXPECT_EQ(stl_error("solid\n" + kFacet + "endsolid\nmore\n"),
            "a.stl:10: 'more' stands where 'solid' must be");
}

std::string ply_header(const std::string& format, const std::string& type, const std::string& list) {
  return "ply\nformat " + format + " 1.0\ncomment by a test\nelement vertex 4\nproperty " + type +
         " x\nproperty " + type + " y\nproperty uchar red\nproperty " + type +
         " z\nelement face 4\nproperty list " + list +
         " vertex_indices\nelement extra 1\nproperty list uchar float values\nend_header\n";
}

template <class Real, class Count, class Index>
std::string binary_ply(bool is_big_endian, const std::string& type, const std::string& list) {
  Bytes bytes(is_big_endian);
  bytes.text = ply_header(is_big_endian ? "binary_big_endian" : "binary_little_endian", type, list);
  for (const Vec3& v : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
    bytes.real(static_cast<Real>(v.x()))
        .real(static_cast<Real>(v.y()))
        .whole(std::uint8_t{255})
        .real(static_cast<Real>(v.z()));
  }
  for (const std::array<unsigned, 3>& face :
       {std::array{0u, 2u, 1u}, {0u, 1u, 3u}, {0u, 3u, 2u}, {1u, 2u, 3u}}) {
    bytes.whole(static_cast<Count>(3));
    for (const unsigned v : face) bytes.whole(static_cast<Index>(v));
  }
  bytes.whole(std::uint8_t{2}).real(1.5f).real(2.5f);
  return bytes.text;
}

const std::string kPlyRows =
    "0 0 9 0\n1 0 9 0\n0 1 9 0\n0 0 9 1\n3 0 2 1\n3 0 1 3\n\n3 0 3 2\n3 1 2 3\n2 1.5 2.5\n";

TEST(PlyFile, GivesTheSameMeshInAllFormatsAndTypes) {
  expect_tetrahedron(parse_ply(ply_header("ascii", "double", "uchar int") + kPlyRows, "a.ply"));
  expect_tetrahedron(parse_ply(ply_header("ascii", "short", "char ushort") + kPlyRows, "a.ply"));
  expect_tetrahedron(
      parse_ply(binary_ply<float, std::uint8_t, std::uint32_t>(false, "float", "uchar int"), "a.ply"));
  expect_tetrahedron(
      parse_ply(binary_ply<double, std::uint32_t, std::uint8_t>(false, "float64", "uint32 uint8"), "a.ply"));
  expect_tetrahedron(
      parse_ply(binary_ply<float, std::uint16_t, std::uint16_t>(true, "float32", "short ushort"), "a.ply"));
  expect_tetrahedron(
      parse_ply(binary_ply<double, std::uint8_t, std::uint32_t>(true, "double", "uint8 uint"), "a.ply"));
}

TEST(PlyFile, RefusesEveryCutAndEveryTail) {
  const std::string ascii = ply_header("ascii", "double", "uchar int") + kPlyRows;
  const std::string binary = binary_ply<float, std::uint8_t, std::uint32_t>(false, "float", "uchar int");
  for (const std::string& whole : {ascii, binary}) {
    // The last line end and the last digits of the last number may be missed by no one.
    for (std::size_t length = 0; length + 5 < whole.size(); ++length) {
      EXPECT_TRUE(starts_with(ply_error(whole.substr(0, length)), "a.ply:")) << length;
    }
    EXPECT_NE(ply_error(whole + "1"), "no error");
  }
}

TEST(PlyFile, RefusesCountsBeyondTheFileWithoutReservingMemory) {
  std::string huge = ply_header("ascii", "double", "uchar int") + kPlyRows;
  huge.replace(huge.find("vertex 4"), 8, "vertex 2147483647");
  EXPECT_TRUE(starts_with(ply_error(huge), "a.ply:13: the header promises 2147483647 rows of 'vertex'"))
      << ply_error(huge);
  huge.replace(huge.find("2147483647"), 10, "99999999999");
  EXPECT_TRUE(starts_with(ply_error(huge), "a.ply:4: element count '99999999999' is out of range"));

  Bytes bytes;
  bytes.text =
      "ply\nformat binary_little_endian 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty "
      "float z\n"
      "element face 1\nproperty list uint int vertex_index\nend_header\n";
  bytes.whole(std::uint32_t{4000000000u}).whole(std::uint32_t{0});
  EXPECT_NE(ply_error(bytes.text).find("a list of 4000000000 values in row 0"), std::string::npos)
      << ply_error(bytes.text);
}

TEST(PlyFile, RefusesHeadersThatMakeNoSense) {
  const std::string good = ply_header("ascii", "double", "uchar int") + kPlyRows;
  const auto changed = [&good](const std::string& from, const std::string& to) {
    std::string text = good;
    text.replace(text.find(from), from.size(), to);
    return ply_error(text);
  };
  EXPECT_TRUE(starts_with(changed("ply", "plyx"), "a.ply:1: a PLY file starts"));
  EXPECT_TRUE(starts_with(changed("1.0", "2.0"), "a.ply:2: the second line must be"));
  EXPECT_TRUE(starts_with(changed("comment", "commend"), "a.ply:3: 'commend' is not allowed here"));
  EXPECT_TRUE(starts_with(changed("double x", "quad x"), "a.ply:5: 'quad' is not a type"));
  EXPECT_TRUE(
      starts_with(changed("double x", "double w"), "a.ply:13: element 'vertex' must have one property x"));
  EXPECT_TRUE(starts_with(changed("list uchar int", "list float int"), "a.ply:10: the length of a list"));
  EXPECT_TRUE(starts_with(changed("list uchar int", "list uchar float"), "a.ply:13: the indices of a face"));
  EXPECT_TRUE(
      starts_with(changed("vertex_indices", "vertices"), "a.ply:13: element 'face' must have one list"));
  EXPECT_TRUE(starts_with(changed("element face", "element fate"),
                          "a.ply:13: the header must have one element 'face'"));
  EXPECT_TRUE(starts_with(changed("element vertex 4", "element vertex -4"),
                          "a.ply:4: element count '-4' is out of range"));
}

TEST(PlyFile, RefusesRowsThatMakeNoSense) {
  const std::string good = ply_header("ascii", "double", "uchar int") + kPlyRows;
  const auto changed = [&good](const std::string& from, const std::string& to) {
    std::string text = good;
    text.replace(text.rfind(from), from.size(), to);
    return ply_error(text);
  };
  EXPECT_TRUE(starts_with(changed("0 0 9 1", "0 0 9"), "a.ply:17: the row is cut off"));
  EXPECT_TRUE(starts_with(changed("0 0 9 1", "0 0 9 1 1"), "a.ply:17: 1 values too many"));
  EXPECT_TRUE(starts_with(changed("0 0 9 1", "0 0 256 1"), "a.ply:17: '256' is out of range"));
  EXPECT_TRUE(starts_with(changed("0 0 9 1", "0 0 9 inf"), "a.ply:17: 'inf' is not a number"));
  EXPECT_TRUE(starts_with(changed("3 0 2 1", "2 0 2"), "a.ply:18: face 0 has 2 vertices"));
  EXPECT_TRUE(
      starts_with(changed("3 0 2 1", "3 0 2 -1"), "a.ply:18: vertex index -1 of face 0 is out of range"));
  EXPECT_NE(changed("3 0 2 1", "3 0 2 4").find("vertex index 4 of face 0 is out of range"),
            std::string::npos);
}

TEST(MeshFiles, HostileFilesAreRefusedWithFileAndPlace) {
  EXPECT_TRUE(starts_with(file_error("vertex_nan.obj"), "vertex_nan.obj:7: 'nan' is not a number"));
  EXPECT_TRUE(starts_with(file_error("vertex_nan.stl"), "vertex_nan.stl: byte "));
  EXPECT_TRUE(starts_with(file_error("index_out_of_range.obj"),
                          "index_out_of_range.obj:10: vertex index 999999999 is out of range"));
  EXPECT_TRUE(starts_with(file_error("index_overflow.obj"),
                          "index_overflow.obj:10: '99999999999999999999' is too large"));
  EXPECT_TRUE(starts_with(file_error("empty.obj"), "empty.obj:1: the file is empty"));
  EXPECT_TRUE(starts_with(file_error("empty.stl"), "empty.stl:1: the file is empty"));
  EXPECT_TRUE(starts_with(file_error("count_too_large.stl"),
                          "count_too_large.stl: byte 80: the header promises 80000000 triangles"));
  EXPECT_TRUE(starts_with(file_error("cut_off.stl"), "cut_off.stl:6: the file is cut off"));
  EXPECT_TRUE(starts_with(file_error("garbage_numbers.obj"), "garbage_numbers.obj:1: '1,5' is not a number"));
}

TEST(MeshFiles, HostileSurfacesAreReadAndThenFoundOut) {
  const auto defect = [](const std::string& name) {
    const std::vector<MeshDefect> defects = find_mesh_defects(read_mesh(kMeshes + name));
    EXPECT_TRUE(has_errors(defects)) << name;
    return defects.empty() ? MeshDefectKind::unused_vertex : defects[0].kind;
  };
  EXPECT_EQ(defect("tiny_cube.obj"), MeshDefectKind::size_out_of_range);
  EXPECT_EQ(defect("bow_tie.obj"), MeshDefectKind::zero_volume);
  EXPECT_EQ(defect("bow_tie.stl"), MeshDefectKind::zero_volume);
  EXPECT_EQ(defect("open_cube.obj"), MeshDefectKind::open_edge);
  EXPECT_EQ(defect("collinear.obj"), MeshDefectKind::zero_area_face);
  EXPECT_EQ(defect("one_point.stl"), MeshDefectKind::size_out_of_range);
}

TEST(MeshFiles, APolygonOfTwentyThousandCornersIsReadAndCutUp) {
  std::string text, face = "f";
  for (int i = 0; i < 20000; ++i) {
    const double angle = 2e-4 * 3.141592653589793 * i / 2;
    text += "v " + std::to_string(std::cos(angle)) + " " + std::to_string(std::sin(angle)) + " 0.1\n";
    face += " " + std::to_string(i + 1);
  }
  const PolygonMesh mesh = parse_obj(text + face + "\n", "a.obj");
  EXPECT_EQ(triangulated(mesh).triangles.size(), 19998u);
  EXPECT_TRUE(has_errors(find_mesh_defects(mesh)));  // one face is not closed
}

TEST(MeshFiles, AreToldApartBySuffixInAnyCase) {
  const TemporaryFile upper("A.OBJ", kTetrahedron);
  expect_tetrahedron(read_mesh(upper.path()));
  EXPECT_EQ(error_of([] { read_mesh("a.gltf"); }),
            "a.gltf: unknown kind of mesh file '.gltf'; allowed are .obj, .stl and .ply");
  EXPECT_EQ(error_of([] { read_mesh("mesh"); }),
            "mesh: unknown kind of mesh file ''; allowed are .obj, .stl and .ply");
}

TEST(MeshFiles, ThatAreNoneAreRefused) {
  EXPECT_EQ(file_error("missing.obj"), "missing.obj: no such file");
  const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / "rigor_folder.obj";
  std::filesystem::create_directory(folder);
  EXPECT_EQ(error_of([&] { read_mesh(folder); }),
            folder.string() + ": is a directory; a mesh file is needed");
  std::filesystem::remove(folder);
  const TemporaryFile file("b.obj", kTetrahedron);
  EXPECT_EQ(error_of([&] { read_mesh(file.path(), {50}); }), file.path().string() + ": the file has " +
                                                                 std::to_string(kTetrahedron.size()) +
                                                                 " bytes; allowed are up to 50");
}

}  // namespace
}  // namespace rigor::mesh_files_test
