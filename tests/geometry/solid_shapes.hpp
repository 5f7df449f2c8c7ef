#pragma once

#include "geometry/mesh_shapes.hpp"
#include "geometry/random_pairs.hpp"
#include "rigor/geometry/decomposition/make_mesh.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

/// Solids that are not convex, for tests.
namespace rigor::test {

inline Mesh as_mesh(const TriangleMesh& mesh) {
  return make_mesh(std::make_shared<const TriangleMesh>(mesh));
}
inline Mesh as_mesh(const PolygonMesh& mesh) {
  return as_mesh(triangulated(mesh));
}

/// The solid with all lengths times `scale`.
inline Mesh as_scaled_mesh(PolygonMesh mesh, double scale) {
  for (Vec3& v : mesh.vertices) v *= scale;
  return as_mesh(mesh);
}

/// Two unit cubes on a row and one on the first: volume 3.
inline PolygonMesh l_solid() {
  return make_prism({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 1);
}

/// Prism over a star: `2 tips` corners at the radii 1 and `inner` by turns.
inline PolygonMesh star_solid(int tips, double inner) {
  std::vector<Vec2> loop;
  for (int i = 0; i < 2 * tips; ++i) {
    const double angle = std::numbers::pi * i / tips, radius = i % 2 == 0 ? 1 : inner;
    loop.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return make_prism(loop, 0.5);
}

/// Prism over a wheel with trapezoidal teeth.
inline PolygonMesh gear_solid(int teeth) {
  std::vector<Vec2> loop;
  for (int i = 0; i < teeth; ++i) {
    for (const auto& [part, radius] : {std::pair(0.0, 0.8), {0.4, 0.8}, {0.55, 1.0}, {0.85, 1.0}}) {
      const double angle = 2 * std::numbers::pi * (i + part) / teeth;
      loop.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
  }
  return make_prism(loop, 0.3);
}

/// Prism over a random loop around the origin, counter-clockwise: no edge crosses another.
inline PolygonMesh random_prism(Draw& draw, int corners) {
  std::vector<Vec2> loop;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * (i + draw.uniform(0, 0.8)) / corners;
    loop.push_back(draw.uniform(0.3, 1) * Vec2(std::cos(angle), std::sin(angle)));
  }
  return make_prism(loop, draw.uniform(0.3, 1));
}

/// Cube of side 2 about the origin with a square hole of side 1 along z: volume 6.
inline PolygonMesh cube_with_hole() {
  PolygonMesh mesh;
  for (const double z : {-1.0, 1.0}) {
    for (const double r : {1.0, 0.5}) {
      for (const auto& [x, y] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
        mesh.vertices.emplace_back(r * x, r * y, z);
      }
    }
  }
  for (int i = 0; i < 4; ++i) {
    const int k = (i + 1) % 4;
    mesh.faces.push_back({i, k, 8 + k, 8 + i});            // outside
    mesh.faces.push_back({4 + k, 4 + i, 12 + i, 12 + k});  // the hole
    mesh.faces.push_back({i, 4 + i, 4 + k, k});            // bottom
    mesh.faces.push_back({8 + i, 8 + k, 12 + k, 12 + i});  // top
  }
  return mesh;
}

/// Cube of side 2 with a cube of side 1 missing inside: volume 7.
inline PolygonMesh cube_with_cavity() {
  return joined(make_box_mesh(Vec3::Constant(-1), Vec3::Constant(1)),
                inside_out(make_box_mesh(Vec3::Constant(-0.5), Vec3::Constant(0.5))));
}

/// Ring of radius 1 about z, its tube of radius `tube`: quads.
inline PolygonMesh torus_solid(double tube, int around, int along) {
  PolygonMesh mesh;
  for (int i = 0; i < around; ++i) {
    const double u = 2 * std::numbers::pi * i / around;
    for (int k = 0; k < along; ++k) {
      const double v = 2 * std::numbers::pi * k / along, r = 1 + tube * std::cos(v);
      mesh.vertices.emplace_back(r * std::cos(u), r * std::sin(u), tube * std::sin(v));
    }
  }
  for (int i = 0; i < around; ++i) {
    for (int k = 0; k < along; ++k) {
      const int a = i * along + k, b = (i + 1) % around * along + k;
      const int c = (i + 1) % around * along + (k + 1) % along, d = i * along + (k + 1) % along;
      mesh.faces.push_back({a, b, c, d});
    }
  }
  return mesh;
}

/// Ball of radius 1 with waves of the given height on it.
inline TriangleMesh bumpy_ball(int levels, double height) {
  TriangleMesh mesh = make_icosphere(levels);
  for (Vec3& v : mesh.vertices) {
    v *= 1 + height * std::sin(5 * v.x()) * std::sin(5 * v.y() + 1) * std::sin(5 * v.z() + 2);
  }
  return mesh;
}

}  // namespace rigor::test
