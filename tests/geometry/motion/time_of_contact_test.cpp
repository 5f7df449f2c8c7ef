#include "rigor/geometry/motion/time_of_contact.hpp"
#include "rigor/geometry/distance/distance.hpp"

#include "geometry/mesh_shapes.hpp"
#include "geometry/random_pairs.hpp"
#include "rigor/geometry/decomposition/make_mesh.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <numbers>

namespace rigor::time_of_contact_test {
namespace {

using test::Draw;

Vec3 vec3(const nlohmann::json& j) {
  return Vec3(j[0], j[1], j[2]);
}

Shape polytope(const nlohmann::json& j) {
  std::vector<Vec3> points;
  for (const nlohmann::json& vertex : j["vertices"]) points.push_back(vec3(vertex));
  return Convex{std::make_shared<const ConvexHull>(std::get<ConvexHull>(make_convex_hull(points)))};
}

TwistMotion motion_of(const nlohmann::json& j) {
  const Quat q = Quat(j["q0"][0], j["q0"][1], j["q0"][2], j["q0"][3]).normalized();
  return TwistMotion({rotation_matrix(q), vec3(j["x0"])}, vec3(j["v"]), vec3(j["w"]));
}

TwistMotion at_rest() {
  return TwistMotion(Pose{}, Vec3::Zero(), Vec3::Zero());
}

Shape mesh_of(const PolygonMesh& mesh) {
  return make_mesh(std::make_shared<const TriangleMesh>(triangulated(mesh)));
}

/// Torus about z: circles of radius r about a circle of radius R, with vertices on the axes.
Shape torus(double R, double r, int around, int across) {
  TriangleMesh mesh;
  const double turn = 2 * std::numbers::pi;
  for (int i = 0; i < around; ++i) {
    for (int k = 0; k < across; ++k) {
      const double u = turn * i / around, v = turn * k / across, rho = R + r * std::cos(v);
      mesh.vertices.emplace_back(rho * std::cos(u), rho * std::sin(u), r * std::sin(v));
    }
  }
  for (int i = 0; i < around; ++i) {
    for (int k = 0; k < across; ++k) {
      const int j = (i + 1) % around, l = (k + 1) % across;
      mesh.triangles.push_back({i * across + k, j * across + k, j * across + l});
      mesh.triangles.push_back({i * across + k, j * across + l, i * across + l});
    }
  }
  return make_mesh(std::make_shared<const TriangleMesh>(mesh));
}

TEST(TimeOfContact, OfTheReferenceMotionsIsBracketedByATrillionthOfASecond) {
  std::ifstream file(std::string(RIGOR_TEST_DATA) + "/toi.json");
  const nlohmann::json cases = nlohmann::json::parse(file);
  for (const nlohmann::json& c : cases["cases"]) {
    const Shape a = polytope(c["A"]), b = polytope(c["B"]);
    const TwistMotion of_a = motion_of(c["A"]), of_b = motion_of(c["B"]);
    const TimeOfContact found = find_time_of_contact({&a, Pose{}, &of_a}, {&b, Pose{}, &of_b}, 0, c["t_max"]);
    EXPECT_TRUE(found.is_complete);
    ASSERT_EQ(found.is_contact, !c["toi"].is_null()) << c["name"];
    if (!found.is_contact) continue;
    const double toi = c["toi"];
    // Distances are known to some 1e-15 m, which the speed of approach turns into time.
    EXPECT_LE(found.lower, toi + 1e-13) << c["name"];
    EXPECT_GE(found.upper, toi - 1e-13) << c["name"];
    EXPECT_LE(found.upper - found.lower, 1e-12 + 1e-15 * toi) << c["name"];
  }
}

TEST(TimeOfContact, OfABoxAndAConeIsTheOneByHand) {
  // The face at x - 0.5... of a box 1 x 2 x 3 that goes from x = -10 to 10 meets the base circle at x = -1:
  // 20 t - 9.5 = -1.
  const Shape box = Box{Vec3(0.5, 1, 1.5)}, cone = Cone{1, 1.5};
  const TwistMotion moving(Pose{Mat3::Identity(), Vec3(-10, 0, 0)}, Vec3(20, 0, 0), Vec3::Zero());
  const TwistMotion still = at_rest();
  const TimeOfContact found = find_time_of_contact({&box, Pose{}, &moving}, {&cone, Pose{}, &still}, 0, 1);
  ASSERT_TRUE(found.is_contact);
  EXPECT_LE(found.lower, 0.425 + 1e-15);
  EXPECT_GE(found.upper, 0.425 - 1e-15);
  EXPECT_LE(found.upper - found.lower, 1.001e-12);
  EXPECT_NEAR((found.distance.n_W - Vec3::UnitX()).norm(), 0, 1e-9);
  EXPECT_NEAR((found.distance.p_WB - Vec3(-1, 0, -1.5)).norm(), 0, 1e-9);
}

TEST(TimeOfContact, OfATurningCapsuleAndAFloorIsAnArcsine) {
  // The lower end is at z = h - l sin(ω t) - r.
  const Shape capsule = Capsule{0.2, 1}, floor = HalfSpace{Vec3::UnitZ(), 0};
  const TwistMotion still = at_rest();
  for (const double w : {0.1, 1.0, 50.0}) {
    const double h = 0.9;
    const Pose lying{rotation_matrix(rotation_exp(Vec3(0, 0.5 * std::numbers::pi, 0))), Vec3(0, 0, h)};
    const TwistMotion turning(lying, Vec3::Zero(), Vec3(0, w, 0));
    const TimeOfContact found =
        find_time_of_contact({&capsule, Pose{}, &turning}, {&floor, Pose{}, &still}, 0, 100);
    ASSERT_TRUE(found.is_contact);
    const double t = std::asin(h - 0.2) / w;
    EXPECT_LE(found.lower, t + 1e-15 / w);
    EXPECT_GE(found.upper, t - 1e-15 / w);
    EXPECT_LE(found.upper - found.lower, 1.001e-12);
  }
}

TEST(TimeOfContact, AlongAScrewIsThatOfTheTurnAndTheGlide) {
  // A ball on an arm of length 2 about the z axis through (1, 0, 0) meets a wall y ≥ 1 of its other side at
  // 2 sin(ω t) + r = 1, whatever the glide.
  const double w = 0.7, r = 0.1;
  const Shape ball = Sphere{r}, wall = HalfSpace{-Vec3::UnitY(), -1};
  const Pose start{Mat3::Identity(), Vec3(3, 0, 0)};
  // The point at the origin of W turns about the axis too: v = ω × (0 - c) + glide.
  const Vec3 omega(0, 0, w), velocity = omega.cross(Vec3(-1, 0, 0)) + Vec3(0, 0, 5);
  const ScrewMotion screw = make_screw_motion(start, omega, velocity);
  const TwistMotion still = at_rest();
  const TimeOfContact found =
      find_time_of_contact({&ball, screw.X_BU, &screw.motion}, {&wall, Pose{}, &still}, 0, 3);
  ASSERT_TRUE(found.is_contact);
  const double t = std::asin(0.5 * (1 - r)) / w;
  EXPECT_NEAR(found.lower, t, 1.1e-12);
  EXPECT_GE(found.upper, t - 1e-15);
  // All points keep their distance from the axis, and the pose is the exponential of the twist.
  const Pose X = MovingShape{&ball, screw.X_BU, &screw.motion}.pose(t);
  EXPECT_NEAR((X.p - Vec3(1, 0, X.p.z())).norm(), 2, 1e-14);
  EXPECT_NEAR(X.p.z(), 5 * t, 1e-14);
}

TEST(TimeOfContact, BracketsOfRandomMotionsAreFreeBeforeAndTouchAfter) {
  Draw draw(31);
  int contacts = 0, misses = 0;
  for (int trial = 0; trial < 120; ++trial) {
    const Shape a = draw.shape(trial % Draw::kKinds), b = draw.shape((trial / 3) % Draw::kKinds);
    const Pose X_WA = draw.pose(0.3);
    const Pose X_WB{draw.rotation(), X_WA.p + 4 * draw.direction()};
    const TwistMotion of_a(X_WA, 0.5 * draw.direction(), 3 * draw.direction(), draw.direction());
    const TwistMotion of_b(X_WB, X_WA.p - X_WB.p + 0.8 * draw.direction(), 3 * draw.direction());
    const MovingShape A{&a, draw.pose(0.2), &of_a}, B{&b, draw.pose(0.2), &of_b};
    const TimeOfContact found = find_time_of_contact(A, B, 0, 2);
    ASSERT_TRUE(found.is_complete);
    for (int k = 0; k < 200; ++k) {
      const double t = found.lower * k / 200;
      EXPECT_GT(signed_distance(a, A.pose(t), b, B.pose(t)).distance, 0) << trial;
    }
    (found.is_contact ? contacts : misses) += 1;
    if (!found.is_contact) continue;
    // Speeds of up to 10 m/s in a bracket of 1e-12 s.
    const double t = found.upper;
    EXPECT_LE(signed_distance(a, A.pose(t), b, B.pose(t)).distance, 1e-13) << trial;
    EXPECT_LE(found.upper - found.lower, 1.001e-12);
    EXPECT_NEAR(found.distance.n_W.norm(), 1, 1e-14);
  }
  EXPECT_GT(contacts, 40);
  EXPECT_GT(misses, 20);
}

TEST(TimeOfContact, OfAMeshIsThatOfTheSolidItIsTheSurfaceOf) {
  Draw draw(32);
  int contacts = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const Vec3 half = draw.sizes(), half_b = draw.sizes();
    const Shape box = Box{half}, box_mesh = mesh_of(make_box_mesh(-half, half));
    const Shape other = Box{half_b}, other_mesh = mesh_of(make_box_mesh(-half_b, half_b));
    const TwistMotion of_a(draw.pose(0.2), Vec3::Zero(), 2 * draw.direction());
    const TwistMotion of_b({draw.rotation(), Vec3(3, 0, 0)}, Vec3(-3, draw.uniform(-1, 1), 0),
                           2 * draw.direction());
    const auto time = [&](const Shape& a, const Shape& b) {
      return find_time_of_contact({&a, Pose{}, &of_a}, {&b, Pose{}, &of_b}, 0, 2);
    };
    const TimeOfContact solid = time(box, other);
    for (const TimeOfContact& found :
         {time(box_mesh, other), time(box, other_mesh), time(box_mesh, other_mesh)}) {
      ASSERT_EQ(found.is_contact, solid.is_contact);
      EXPECT_NEAR(found.lower, solid.lower, 3e-12);
      EXPECT_NEAR(found.upper, solid.upper, 3e-12);
    }
    contacts += solid.is_contact;
  }
  EXPECT_GT(contacts, 20);
}

TEST(TimeOfContact, OfATorusThroughATorusIsWhereTheirTubesMeet) {
  // B stands across A, its centre at x. Linked from x = 1 it meets A's tube from inside at x - 0.8 = 0.8;
  // from x = 4 from outside at x - 1.2 = 1.2.
  const Shape ring = torus(1, 0.2, 32, 16);
  const Mat3 across = rotation_matrix(rotation_exp(Vec3(0.5 * std::numbers::pi, 0, 0)));
  const TwistMotion still = at_rest();
  const TwistMotion out(Pose{across, Vec3(1, 0, 0)}, Vec3(1, 0, 0), Vec3::Zero());
  const TwistMotion in(Pose{across, Vec3(4, 0, 0)}, Vec3(-1, 0, 0), Vec3::Zero());
  const TimeOfContact leaves = find_time_of_contact({&ring, Pose{}, &still}, {&ring, Pose{}, &out}, 0, 5);
  ASSERT_TRUE(leaves.is_contact);
  EXPECT_NEAR(leaves.upper, 0.6, 2e-12);
  const TimeOfContact comes = find_time_of_contact({&ring, Pose{}, &still}, {&ring, Pose{}, &in}, 0, 5);
  ASSERT_TRUE(comes.is_contact);
  EXPECT_NEAR(comes.upper, 1.6, 2e-12);
  // Far fewer than the millions of pairs of triangles are looked at.
  EXPECT_LT(comes.evaluations, 5000);
  // Turning in its own plane it stays linked for good, but for the corners of its polygons: no contact.
  const TwistMotion turning(Pose{across, Vec3(1, 0, 0)}, Vec3::Zero(), across * Vec3(0, 0, 1));
  EXPECT_FALSE(find_time_of_contact({&ring, Pose{}, &still}, {&ring, Pose{}, &turning}, 0, 2).is_contact);
}

TEST(TimeOfContact, OfAMeshThatIsThrownOnAFloorIsThatOfItsHull) {
  Draw draw(33);
  for (int trial = 0; trial < 20; ++trial) {
    const Vec3 half = draw.sizes();
    const Shape box = Box{half}, box_mesh = mesh_of(make_box_mesh(-half, half));
    const Shape floor = HalfSpace{draw.direction(), 0};
    const Vec3 n = std::get<HalfSpace>(floor).normal;
    const TwistMotion thrown({draw.rotation(), 3 * n}, draw.direction(), 5 * draw.direction(), -9.81 * n);
    const TwistMotion still = at_rest();
    const TimeOfContact solid = find_time_of_contact({&box, Pose{}, &thrown}, {&floor, Pose{}, &still}, 0, 9);
    const TimeOfContact mesh =
        find_time_of_contact({&floor, Pose{}, &still}, {&box_mesh, Pose{}, &thrown}, 0, 9);
    ASSERT_TRUE(solid.is_contact && mesh.is_contact);
    EXPECT_NEAR(solid.upper, mesh.upper, 2e-12);
    EXPECT_NEAR((mesh.distance.n_W - n).norm(), 0, 1e-14);
  }
}

TEST(TimeOfContact, DoesNotDependOnTheUnitOfLength) {
  // All lengths times a power of two: the same times, bit for bit.
  Draw draw(34);
  int contacts = 0;
  for (int trial = 0; trial < 20; ++trial) {
    const Vec3 half = draw.sizes(), half_b = draw.sizes();
    const Mat3 R_A = draw.rotation(), R_B = draw.rotation();
    const Vec3 x(3, 0.2, 0), v(-3, draw.uniform(-0.4, 0.4), 0), w = 2 * draw.direction();
    const auto time = [&](double unit) {
      const Shape a = Box{unit * half}, b = mesh_of(make_box_mesh(-unit * half_b, unit * half_b));
      const TwistMotion of_a({R_A, Vec3::Zero()}, Vec3::Zero(), w);
      const TwistMotion of_b({R_B, unit * x}, unit * v, -w);
      return find_time_of_contact({&a, Pose{}, &of_a}, {&b, Pose{}, &of_b}, 0, 2);
    };
    const TimeOfContact one = time(1);
    contacts += one.is_contact;
    for (const double unit : {0x1p-20, 0x1p20}) {
      EXPECT_EQ(time(unit).lower, one.lower);
      EXPECT_EQ(time(unit).upper, one.upper);
    }
  }
  EXPECT_GT(contacts, 10);
}

TEST(TimeOfContact, OfShapesThatOverlapOrLieInAMeshIsTheBeginning) {
  const Shape room = mesh_of(make_box_mesh(Vec3(-2, -2, -2), Vec3(2, 2, 2)));
  const Shape ball = Sphere{0.1}, small = mesh_of(make_box_mesh(Vec3(-0.1, -0.1, -0.1), Vec3(0.1, 0.1, 0.1)));
  const TwistMotion still = at_rest(), moving(Pose{}, Vec3(1, 0, 0), Vec3::Zero());
  for (const Shape* inner : {&ball, &small}) {
    const TimeOfContact found = find_time_of_contact({inner, Pose{}, &moving}, {&room, Pose{}, &still}, 0, 9);
    EXPECT_TRUE(found.is_contact);
    EXPECT_EQ(found.upper, 0);
  }
  // Touching at the beginning counts, also of shapes that part.
  const TwistMotion away(Pose{Mat3::Identity(), Vec3(0.2, 0, 0)}, Vec3(1, 0, 0), Vec3::Zero());
  EXPECT_TRUE(find_time_of_contact({&ball, Pose{}, &still}, {&ball, Pose{}, &away}, 0, 9).is_contact);
}

}  // namespace
}  // namespace rigor::time_of_contact_test
