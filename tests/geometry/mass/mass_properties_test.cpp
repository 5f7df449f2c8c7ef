#include "rigor/geometry/mass/mass_properties.hpp"

#include "geometry/mesh_shapes.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/math/principal_axes.hpp"
#include "rigor/math/rotation.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>

namespace rigor::mass_properties_test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kEpsilon = std::numeric_limits<double>::epsilon() / 2;

Vec3 vec3(const nlohmann::json& v) {
  return {v[0].get<double>(), v[1].get<double>(), v[2].get<double>()};
}

PolygonMesh mesh_of(const nlohmann::json& solid) {
  PolygonMesh mesh;
  for (const nlohmann::json& v : solid["vertices"]) mesh.vertices.push_back(vec3(v));
  mesh.faces = solid["faces"].get<std::vector<std::vector<int>>>();
  return mesh;
}

/// The differences relative to mass, size and trace, as MassProperties::error_bound counts them.
double largest_error(const MassProperties& found, const MassProperties& exact) {
  const double size = std::sqrt(exact.inertia.trace() / exact.mass);
  return std::max({std::abs(found.mass - exact.mass) / exact.mass,
                   (found.center - exact.center).norm() / size,
                   (found.inertia - exact.inertia).norm() / exact.inertia.trace()});
}

MassProperties exact_properties(const nlohmann::json& solid) {
  MassProperties exact;
  exact.mass = solid["volume"].get<double>();
  exact.center = vec3(solid["center"]);
  for (int i = 0; i < 3; ++i) exact.inertia.row(i) = vec3(solid["inertia"][static_cast<std::size_t>(i)]);
  return exact;
}

TEST(MassProperties, OfPolyhedraMatchExactRationalNumbers) {
  const nlohmann::json data = nlohmann::json::parse(std::ifstream(RIGOR_TEST_DATA "/massprops.json"));
  ASSERT_EQ(data["valid"].size(), 9u);
  for (const nlohmann::json& solid : data["valid"]) {
    SCOPED_TRACE(solid["name"].get<std::string>());
    const PolygonMesh mesh = mesh_of(solid);
    const MassProperties exact = exact_properties(solid);
    const MassProperties found = mass_properties(mesh, 1.0);
    // The centre's coordinates are rounded to doubles, which counts where it is far from the origin.
    const double rounding = exact.center.norm() / std::sqrt(exact.inertia.trace() / exact.mass) * kEpsilon;
    EXPECT_LE(largest_error(found, exact), 1e-14 + rounding);
    EXPECT_LE(largest_error(found, exact), found.error_bound + rounding);
    EXPECT_LE(found.error_bound, 1e-13);
    EXPECT_LE(largest_error(mass_properties(triangulated(mesh), 1.0), exact), 1e-14 + rounding);
    EXPECT_LE(largest_error(mass_properties(integrals_by_tetrahedra(mesh.vertices, mesh.faces), 1.0), exact),
              1e-14 + rounding);

    Vec3 moments = principal_axes(found.inertia).moments;
    std::sort(moments.data(), moments.data() + 3);
    EXPECT_LE((moments - vec3(solid["principal"])).norm(), 1e-14 * exact.inertia.trace());
  }
}

TEST(MassProperties, AreLinearInTheDensity) {
  const Shape shape = Cylinder{0.3, 0.7};
  const MassProperties one = mass_properties(shape, 1), eight = mass_properties(shape, 8);
  EXPECT_EQ(eight.mass, 8 * one.mass);
  EXPECT_EQ(eight.inertia, 8 * one.inertia);
  EXPECT_EQ(eight.center, one.center);
}

/// ∫ f(z) dz by Gauss-Legendre with 3 points on many intervals: exact for polynomials of degree 5.
template <class Function>
double integral(double from, double to, const Function& f) {
  const int intervals = 4000;
  const double h = (to - from) / intervals, node = std::sqrt(0.6) / 2;
  double sum = 0;
  for (int i = 0; i < intervals; ++i) {
    const double middle = from + (i + 0.5) * h;
    sum += h / 18 * (5 * f(middle - node * h) + 8 * f(middle) + 5 * f(middle + node * h));
  }
  return sum;
}

/// Solid of revolution about z with the radius r(z): V = ∫π r², Izz = ∫π r⁴/2, Ixx = ∫π (r⁴/4 + r² (z - c)²).
template <class Radius>
MassProperties of_revolution(double from, double to, const Radius& r) {
  const auto disks = [&](auto weight) {
    return integral(from, to, [&](double z) { return kPi * r(z) * r(z) * weight(z); });
  };
  MassProperties result;
  result.mass = disks([](double) { return 1.0; });
  result.center.z() = disks([](double z) { return z; }) / result.mass;
  const double along = disks([&](double z) { return r(z) * r(z) / 2; });
  const double across = along / 2 + disks([&](double z) { return std::pow(z - result.center.z(), 2); });
  result.inertia = Vec3(across, across, along).asDiagonal();
  return result;
}

TEST(MassProperties, OfShapesOfRevolutionMatchTheIntegralsOverTheirDisks) {
  const double a = 0.7, h = 1.3;
  const auto ball = [a](double z) { return std::sqrt(std::max(0.0, a * a - z * z)); };
  const auto capsule = [&](double z) { return std::abs(z) <= h ? a : ball(std::abs(z) - h); };
  const auto cone = [&](double z) { return a * (h - z) / (2 * h); };
  const auto spheroid = [&](double z) { return a * std::sqrt(std::max(0.0, 1 - z * z / (h * h))); };
  // The quadrature is exact for the polynomials r², r⁴ on each side of the capsule's seams, up to rounding
  // and the seams.
  EXPECT_LE(largest_error(mass_properties(Shape(Sphere{a}), 1), of_revolution(-a, a, ball)), 1e-12);
  EXPECT_LE(largest_error(mass_properties(Shape(Cylinder{a, h}), 1),
                          of_revolution(-h, h, [a](double) { return a; })),
            1e-12);
  EXPECT_LE(largest_error(mass_properties(Shape(Cone{a, h}), 1), of_revolution(-h, h, cone)), 1e-12);
  EXPECT_LE(largest_error(mass_properties(Shape(Ellipsoid{{a, a, h}}), 1), of_revolution(-h, h, spheroid)),
            1e-12);
  EXPECT_LE(largest_error(mass_properties(Shape(Capsule{a, h}), 1), of_revolution(-h - a, h + a, capsule)),
            1e-7);
  EXPECT_LE(largest_error(mass_properties(Shape(Capsule{a, 0}), 1), mass_properties(Shape(Sphere{a}), 1)),
            1e-15);
}

TEST(MassProperties, OfACapsuleAreThoseOfItsCylinderAndTwoHalfBalls) {
  // A half ball's centre of mass is 3r/8 from its flat side; about it, its moment across is 83/320 m r².
  const double r = 0.7, h = 1.3;
  const MassProperties cylinder = mass_properties(Shape(Cylinder{r, h}), 1);
  MassProperties top;
  top.mass = 2.0 / 3 * kPi * r * r * r;
  top.center.z() = h + 0.375 * r;
  top.inertia = (top.mass * r * r * Vec3(83.0 / 320, 83.0 / 320, 0.4)).asDiagonal();
  MassProperties bottom = top;
  bottom.center = -top.center;
  const std::array<MassProperties, 3> parts = {cylinder, top, bottom};
  EXPECT_LE(largest_error(mass_properties(Shape(Capsule{r, h}), 1), combined(parts)), 1e-15);
}

TEST(MassProperties, OfABoxAgreeAsShapeHullAndMesh) {
  const Vec3 half(0.5, 1, 1.5);
  const MassProperties closed = mass_properties(Shape(Box{half}), 2);
  EXPECT_EQ(closed.mass, 12);
  EXPECT_EQ(closed.inertia.diagonal(), Vec3(13, 10, 5));  // m (b² + c²) / 12 with full lengths 1, 2, 3
  EXPECT_LE(largest_error(mass_properties(make_box_hull(half), 2), closed), 1e-15);
  EXPECT_LE(largest_error(mass_properties(make_box_mesh(-half, half), 2), closed), 1e-15);
}

TEST(MassProperties, OfAnEllipsoidAreThoseOfAStretchedBall) {
  const MassProperties e = mass_properties(Shape(Ellipsoid{{1, 2, 3}}), 1);
  EXPECT_NEAR(e.mass, 8 * kPi, 1e-14);
  EXPECT_LE((e.inertia.diagonal() - e.mass / 5 * Vec3(13, 10, 5)).norm(), 1e-13);
}

/// Stacked frusta between regular polygons of circumradius r = sin θ at z = -cos θ, integrated in closed
/// form.
MassProperties exact_uv_sphere(int stacks, int segments) {
  const double w = 2 * kPi / segments;
  const double area = segments / 2.0 * std::sin(w);                         // of the polygon with r = 1
  const double moment = segments / 24.0 * std::sin(w) * (2 + std::cos(w));  // its ∫x² = ∫y²
  double volume = 0, xx = 0, zz = 0;
  for (int k = 0; k < stacks; ++k) {
    const double z0 = -std::cos(kPi * k / stacks), z1 = -std::cos(kPi * (k + 1) / stacks), h = z1 - z0;
    const double r0 = std::sin(kPi * k / stacks), r1 = k + 1 == stacks ? 0 : std::sin(kPi * (k + 1) / stacks);
    volume += area * h / 3 * (r0 * r0 + r0 * r1 + r1 * r1);
    xx +=
        moment * h / 5 *
        (std::pow(r0, 4) + std::pow(r0, 3) * r1 + r0 * r0 * r1 * r1 + r0 * std::pow(r1, 3) + std::pow(r1, 4));
    // ∫ r² z², by Simpson's rule for degree 4 with its correction: Boole's rule is exact to degree 5.
    const auto f = [&](double s) { return std::pow((r0 + s * (r1 - r0)) * (z0 + s * h), 2); };
    zz += area * h / 90 * (7 * f(0) + 32 * f(0.25) + 12 * f(0.5) + 32 * f(0.75) + 7 * f(1));
  }
  MassProperties exact;
  exact.mass = volume;
  exact.inertia = Vec3(xx + zz, xx + zz, 2 * xx).asDiagonal();
  return exact;
}

TEST(MassProperties, OfALargeMeshMatchTheClosedFormOfItsPolyhedron) {
  const TriangleMesh mesh = make_uv_sphere(201, 250);
  ASSERT_EQ(mesh.triangles.size(), 100000u);
  const MassProperties found = mass_properties(mesh, 1);
  const double error = largest_error(found, exact_uv_sphere(201, 250));
  // The vertices themselves are rounded, and so is the closed form.
  EXPECT_LE(error, 1e-14);
  EXPECT_LE(found.error_bound, 1e-12);
  EXPECT_GE(found.error_bound, 0);
}

TEST(MassProperties, OfFinerSpheresConvergeToTheBallWithOrderTwo) {
  const MassProperties ball = mass_properties(Shape(Sphere{1}), 1);
  double before = largest_error(mass_properties(make_icosphere(2), 1), ball);
  for (const int levels : {3, 4, 5}) {
    const double error = largest_error(mass_properties(make_icosphere(levels), 1), ball);
    EXPECT_NEAR(std::log2(before / error), 2, 0.05);
    before = error;
  }
}

TEST(MassProperties, ScaleWithPowersOfTwoBitForBit) {
  TriangleMesh mesh = make_icosphere(2);
  const MassProperties one = mass_properties(mesh, 1);
  for (Vec3& v : mesh.vertices) v *= 0x1p-10;
  const MassProperties small = mass_properties(mesh, 1);
  EXPECT_EQ(small.mass, 0x1p-30 * one.mass);
  EXPECT_EQ(small.center, 0x1p-10 * one.center);
  EXPECT_EQ(small.inertia, 0x1p-50 * one.inertia);
}

TEST(MassProperties, OfATurnedAndMovedMeshAreTheTransformedOnes) {
  const Pose X{rotation_matrix(rotation_exp({0.3, -0.7, 1.9})), {3, -2, 5}};
  const PolygonMesh mesh = make_prism({{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}}, 2);
  const MassProperties expected = transformed(mass_properties(mesh, 7), X);
  EXPECT_LE(largest_error(mass_properties(moved(mesh, X), 7), expected), 1e-14);
  EXPECT_EQ(expected.inertia, expected.inertia.transpose());
}

TEST(MassProperties, ErrorBoundShowsFacesThatAreNotPlanar) {
  PolygonMesh mesh = make_box_mesh(Vec3::Zero(), Vec3::Ones());
  mesh.vertices[7].z() += 1e-6;
  const double bound = mass_properties(mesh, 1).error_bound;
  EXPECT_GT(bound, 1e-8);
  EXPECT_LT(bound, 1e-5);
}

TEST(MassProperties, OfPartsAddUpToTheWhole) {
  // An L is a bar and a block; cut it, turn and move the parts with the whole.
  const std::array<MassProperties, 2> parts = {mass_properties(make_box_mesh({0, 0, 0}, {4, 1, 2}), 3),
                                               mass_properties(make_box_mesh({0, 1, 0}, {1, 3, 2}), 3)};
  const MassProperties whole =
      mass_properties(make_prism({{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}}, 2), 3);
  EXPECT_LE(largest_error(combined(parts), whole), 1e-15);
}

TEST(MassProperties, OfEqualPartsFarFromTheOriginKeepTheirDigits) {
  MassProperties ball = mass_properties(Shape(Sphere{0.5}), 1);
  MassProperties left = ball, right = ball;
  left.center = {0x1p20 - 1, 0x1p20, 0};
  right.center = {0x1p20 + 1, 0x1p20, 0};
  const std::array<MassProperties, 2> parts = {left, right};
  const MassProperties both = combined(parts);
  EXPECT_EQ(both.center, Vec3(0x1p20, 0x1p20, 0));
  EXPECT_NEAR(both.inertia(1, 1), 2 * (ball.inertia(1, 1) + ball.mass), 1e-15);
}

TEST(MassProperties, OfNoPartsAreZero) {
  const MassProperties nothing = combined({});
  EXPECT_EQ(nothing.mass, 0);
  EXPECT_EQ(nothing.inertia, Mat3::Zero());
}

TEST(MassDefects, AreNoneForSolidsAndForFlatPlates) {
  EXPECT_TRUE(find_mass_defects(mass_properties(Shape(Cone{1, 2}), 1)).empty());
  MassProperties plate{1, Vec3::Zero(), Vec3(0.1, 0.2, 0.3).asDiagonal()};
  EXPECT_TRUE(find_mass_defects(plate).empty());
}

TEST(MassDefects, NameWhatIsImpossible) {
  const auto text = [](double mass, const Vec3& moments) {
    const std::vector<std::string> defects = find_mass_defects({mass, Vec3::Zero(), moments.asDiagonal()});
    return defects.empty() ? std::string() : defects[0];
  };
  EXPECT_EQ(text(-1, {1, 1, 1}), "mass is -1 kg, must be > 0");
  EXPECT_EQ(text(1, {1, 1, 3}),
            "principal moments are 1, 1 and 3 kg m²: the largest must not exceed the sum of the other two");
  EXPECT_EQ(text(1, {0, 0, 0}), "principal moments are 0, 0 and 0 kg m², each must be > 0");
  EXPECT_EQ(text(1, {2, -1, 2}), "principal moments are -1, 2 and 2 kg m², each must be > 0");
  EXPECT_EQ(text(std::nan(""), {1, 1, 1}), "mass, centre of mass and inertia must be finite");

  MassProperties skewed{1, Vec3::Zero(), Mat3::Identity()};
  skewed.inertia(0, 1) = 0.1;
  EXPECT_EQ(find_mass_defects(skewed)[0], "inertia tensor is not symmetric");
}

}  // namespace
}  // namespace rigor::mass_properties_test
