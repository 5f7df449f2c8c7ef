#include "rigor/view/3d/surface.hpp"

#include "rigor/core/index.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/geometry/shape/polygon_triangulation.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"

#include <array>
#include <cmath>
#include <span>

namespace rigor {

namespace {

constexpr int round_sides = 96;  ///< Number of sides of a body of revolution.
constexpr int rings = 20;        ///< Number of rings from a pole to the equator.

void add_face(const std::vector<int>& loop, Surface& surface) {
  // A face with many corners is split into parts.
  constexpr std::size_t most = 48;
  if (loop.size() > most) {
    std::vector<int> rest = {loop[0]};
    rest.insert(rest.end(), loop.begin() + most - 1, loop.end());
    add_face({loop.begin(), loop.begin() + most}, surface);
    return add_face(rest, surface);
  }
  const Vec3 area = doubled_area_vector(surface.vertices, loop);
  if (area.norm() == 0) return;
  surface.faces.push_back(
      {static_cast<int>(surface.corners.size()), static_cast<int>(loop.size()), area.normalized(), false});
  surface.corners.insert(surface.corners.end(), loop.begin(), loop.end());
  surface.corner_normals.insert(surface.corner_normals.end(), loop.size(), area.normalized());
}

void add_smooth_face(const std::vector<int>& loop, std::span<const Vec3> normals, Surface& surface) {
  const std::size_t before = surface.faces.size();
  add_face(loop, surface);
  if (surface.faces.size() == before) return;
  surface.faces.back().is_smooth = true;
  std::copy(normals.begin(), normals.end(), surface.corner_normals.end() - static_cast<long>(loop.size()));
}

/// A point of the half plane x ≥ 0 that is rotated about z, with the normal there.
struct ProfilePoint {
  double radius, z;
  double normal_radius, normal_z;
};

/// The band between two rings of a surface of revolution.
void add_band(const ProfilePoint& lower, const ProfilePoint& upper, Surface& surface) {
  const int first = static_cast<int>(surface.vertices.size());
  for (int k = 0; k < round_sides; ++k) {
    const double angle = 2 * M_PI * k / round_sides, c = std::cos(angle), s = std::sin(angle);
    surface.vertices.push_back({lower.radius * c, lower.radius * s, lower.z});
    surface.vertices.push_back({upper.radius * c, upper.radius * s, upper.z});
  }
  const auto normal = [](const ProfilePoint& point, double k) {
    const double angle = 2 * M_PI * k / round_sides;
    return Vec3(point.normal_radius * std::cos(angle), point.normal_radius * std::sin(angle), point.normal_z)
        .normalized();
  };
  for (int k = 0; k < round_sides; ++k) {
    const int a = first + 2 * k, b = first + 2 * ((k + 1) % round_sides);
    // Towards a tip the band consists of triangles, whose normal at the tip is that of their middle.
    if (upper.radius == 0) {
      add_smooth_face({a, b, a + 1},
                      std::array{normal(lower, k), normal(lower, k + 1), normal(upper, k + 0.5)}, surface);
    } else if (lower.radius == 0) {
      add_smooth_face({a, b + 1, a + 1},
                      std::array{normal(lower, k + 0.5), normal(upper, k + 1), normal(upper, k)}, surface);
    } else {
      add_smooth_face(
          {a, b, b + 1, a + 1},
          std::array{normal(lower, k), normal(lower, k + 1), normal(upper, k + 1), normal(upper, k)},
          surface);
    }
  }
}

/// The disk that closes a surface of revolution.
void add_disk(double radius, double z, bool faces_up, Surface& surface) {
  const int first = static_cast<int>(surface.vertices.size());
  std::vector<int> loop;
  for (int k = 0; k < round_sides; ++k) {
    const double angle = (faces_up ? 2 : -2) * M_PI * k / round_sides;
    surface.vertices.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
    loop.push_back(first + k);
  }
  add_face(loop, surface);
}

/// Bands between neighbouring points of the profile, from the lowest to the highest.
Surface revolved(const std::vector<ProfilePoint>& profile) {
  Surface surface;
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) add_band(profile[i], profile[i + 1], surface);
  return surface;
}

/// Profile of the lower or upper half of a unit sphere, from the pole or towards it, shifted along z.
void add_hemisphere(double radius, double shift, bool is_upper, std::vector<ProfilePoint>& profile) {
  for (int i = 0; i <= rings; ++i) {
    const double angle = (is_upper ? i : i - rings) * 0.5 * M_PI / rings;
    const bool is_pole = i == (is_upper ? rings : 0);
    const double c = is_pole ? 0 : std::cos(angle), s = std::sin(angle);
    profile.push_back({radius * c, shift + radius * s, c, s});
  }
}

Surface surface_of(const Sphere&) {
  return {};
}
Surface surface_of(const HalfSpace&) {
  return {};
}

/// The caller draws this shape as a mesh instead (drawn_form).
Surface surface_of(const Cavity&) {
  return {};
}

Surface surface_of(const ConvexHull& hull) {
  Surface surface;
  surface.vertices = hull.vertices;
  for (const std::vector<int>& face : hull.faces) add_face(face, surface);
  return surface;
}
Surface surface_of(const Convex& convex) {
  return surface_of(*convex.hull);
}
Surface surface_of(const Box& box) {
  return surface_of(make_box_hull(box.half_extents));
}

Surface surface_of(const Capsule& capsule) {
  std::vector<ProfilePoint> profile;
  add_hemisphere(capsule.radius, -capsule.half_length, false, profile);
  add_hemisphere(capsule.radius, capsule.half_length, true, profile);
  return revolved(profile);
}

Surface surface_of(const Cylinder& cylinder) {
  const double r = cylinder.radius, l = cylinder.half_length;
  Surface surface = revolved({{r, -l, 1, 0}, {r, l, 1, 0}});
  add_disk(r, -l, false, surface);
  add_disk(r, l, true, surface);
  return surface;
}

Surface surface_of(const Cone& cone) {
  const double r = cone.radius, l = cone.half_length;
  Surface surface = revolved({{r, -l, 2 * l, r}, {0, l, 2 * l, r}});
  add_disk(r, -l, false, surface);
  return surface;
}

/// Each frustum has its own normals, so that the rims stay visible.
Surface surface_of(const Revolution& solid) {
  const std::vector<Ring>& circles = *solid.rings;
  Surface surface;
  for (std::size_t i = 0; i + 1 < circles.size(); ++i) {
    const Ring &lower = circles[i], &upper = circles[i + 1];
    const double along_radius = upper.z - lower.z, along_z = lower.radius - upper.radius;
    add_band({lower.radius, lower.z, along_radius, along_z}, {upper.radius, upper.z, along_radius, along_z},
             surface);
  }
  if (circles.front().radius > 0) add_disk(circles.front().radius, circles.front().z, false, surface);
  if (circles.back().radius > 0) add_disk(circles.back().radius, circles.back().z, true, surface);
  return surface;
}

/// A stretched unit sphere; its normals stretch by the inverse factors.
Surface surface_of(const Ellipsoid& ellipsoid) {
  std::vector<ProfilePoint> profile;
  add_hemisphere(1, 0, false, profile);
  profile.pop_back();
  add_hemisphere(1, 0, true, profile);
  Surface surface = revolved(profile);
  for (Vec3& vertex : surface.vertices) vertex = vertex.cwiseProduct(ellipsoid.radii);
  for (Vec3& normal : surface.corner_normals) normal = normal.cwiseQuotient(ellipsoid.radii).normalized();
  for (Surface::Face& face : surface.faces)
    face.normal = face.normal.cwiseQuotient(ellipsoid.radii).normalized();
  return surface;
}

/// Normals of the triangles that meet at a vertex, weighted by area: one for each corner, from those
/// triangles whose normals differ from that of the corner by less than the crease angle.
Surface surface_of(const Mesh& shape) {
  constexpr double crease_cosine = 0.8660254;  // 30 degrees
  const TriangleMesh& mesh = *shape.mesh;
  Surface surface;
  surface.vertices = mesh.vertices;
  std::vector<std::vector<Vec3>> areas_at(mesh.vertices.size());
  const auto area_of = [&](const std::array<int, 3>& t) {
    const auto vertex = [&](int i) { return mesh.vertices[at(t[at(i)])]; };
    return Vec3((vertex(1) - vertex(0)).cross(vertex(2) - vertex(0)));
  };
  for (const std::array<int, 3>& triangle : mesh.triangles) {
    for (const int v : triangle) areas_at[at(v)].push_back(area_of(triangle));
  }
  for (const std::array<int, 3>& triangle : mesh.triangles) {
    const Vec3 own = area_of(triangle).normalized();
    std::vector<Vec3> normals;
    for (const int v : triangle) {
      Vec3 sum = Vec3::Zero();
      for (const Vec3& area : areas_at[at(v)]) {
        if (area.dot(own) >= crease_cosine * area.norm()) sum += area;
      }
      normals.push_back(sum.normalized());
    }
    add_smooth_face({triangle[0], triangle[1], triangle[2]}, normals, surface);
  }
  return surface;
}

}  // namespace

Surface make_surface(const Shape& shape) {
  return std::visit([](const auto& s) { return surface_of(s); }, shape);
}

}  // namespace rigor
