#pragma once

#include "rigor/geometry/shape/triangle_mesh.hpp"
#include "rigor/math/pose.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

/// Meshes for tests.
namespace rigor {

/// Box of six quads between two corners.
inline PolygonMesh make_box_mesh(const Vec3& lower, const Vec3& upper) {
  PolygonMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.emplace_back((i & 1) ? upper.x() : lower.x(), (i & 2) ? upper.y() : lower.y(),
                               (i & 4) ? upper.z() : lower.z());
  }
  mesh.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return mesh;
}

/// The mesh with its faces turned round.
inline PolygonMesh inside_out(PolygonMesh mesh) {
  for (std::vector<int>& face : mesh.faces) face = {face.rbegin(), face.rend()};
  return mesh;
}

inline PolygonMesh moved(PolygonMesh mesh, const Pose& X) {
  for (Vec3& v : mesh.vertices) v = X * v;
  return mesh;
}

/// Both meshes as one, without common vertices.
inline PolygonMesh joined(PolygonMesh a, const PolygonMesh& b) {
  const int offset = static_cast<int>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (std::vector<int> face : b.faces) {
    for (int& v : face) v += offset;
    a.faces.push_back(face);
  }
  return a;
}

/// Prism over a loop in the x-y plane (counter-clockwise), between z = 0 and the height: its caps are
/// polygons.
inline PolygonMesh make_prism(const std::vector<Vec2>& loop, double height) {
  PolygonMesh mesh;
  const int n = static_cast<int>(loop.size());
  for (const double z : {0.0, height}) {
    for (const Vec2& p : loop) mesh.vertices.emplace_back(p.x(), p.y(), z);
  }
  mesh.faces.resize(2);
  for (int i = 0; i < n; ++i) {
    mesh.faces[0].push_back(n - 1 - i);
    mesh.faces[1].push_back(n + i);
    mesh.faces.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
  }
  return mesh;
}

/// Unit ball of 20 · 4^levels triangles, vertices on the sphere.
inline TriangleMesh make_icosphere(int levels) {
  const double g = std::numbers::phi;
  TriangleMesh mesh;
  mesh.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                   {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  for (Vec3& v : mesh.vertices) v.normalize();
  mesh.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto [entry, is_new] =
          middles.try_emplace(std::minmax(a, b), static_cast<int>(mesh.vertices.size()));
      if (is_new) {
        const Vec3 sum =
            mesh.vertices[static_cast<std::size_t>(a)] + mesh.vertices[static_cast<std::size_t>(b)];
        mesh.vertices.push_back(sum.normalized());
      }
      return entry->second;
    };
    std::vector<std::array<int, 3>> finer;
    for (const auto& [a, b, c] : mesh.triangles) {
      const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
  }
  return mesh;
}

/// Unit ball of regular polygons of `segments` corners at the heights z = -cos(π k / stacks): `2 segments
/// (stacks - 1)` triangles.
inline TriangleMesh make_uv_sphere(int stacks, int segments) {
  TriangleMesh mesh;
  const double pi = std::numbers::pi;
  for (int k = 1; k < stacks; ++k) {
    const double z = -std::cos(pi * k / stacks), r = std::sin(pi * k / stacks);
    for (int i = 0; i < segments; ++i) {
      mesh.vertices.emplace_back(r * std::cos(2 * pi * i / segments), r * std::sin(2 * pi * i / segments), z);
    }
  }
  const int south = static_cast<int>(mesh.vertices.size()), north = south + 1;
  mesh.vertices.emplace_back(0, 0, -1);
  mesh.vertices.emplace_back(0, 0, 1);
  for (int i = 0; i < segments; ++i) {
    const int j = (i + 1) % segments, top = (stacks - 2) * segments;
    mesh.triangles.push_back({south, j, i});
    for (int k = 0; k + 2 < stacks; ++k) {
      const int a = k * segments + i, b = k * segments + j;
      mesh.triangles.push_back({a, b, b + segments});
      mesh.triangles.push_back({a, b + segments, a + segments});
    }
    mesh.triangles.push_back({north, top + i, top + j});
  }
  return mesh;
}

}  // namespace rigor
