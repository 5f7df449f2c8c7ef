#pragma once

#include "rigor/geometry/shape/triangle_mesh.hpp"
#include "rigor/math/pose.hpp"

#include <array>
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

/// The box with each of its faces cut into a grid of `cells` x `cells` squares of two triangles.
inline TriangleMesh make_grid_box(const Vec3& half_extents, int cells) {
  TriangleMesh mesh;
  std::map<std::array<int, 3>, int> numbers;  // Of the points of the grid, by their places.
  const auto vertex = [&](const std::array<int, 3>& place) {
    const auto [entry, is_new] = numbers.try_emplace(place, static_cast<int>(mesh.vertices.size()));
    if (is_new) {
      Vec3 p;
      for (std::size_t i = 0; i < 3; ++i)
        p(static_cast<int>(i)) =
            half_extents(static_cast<int>(i)) * static_cast<double>(2 * place[i] - cells) / cells;
      mesh.vertices.push_back(p);
    }
    return entry->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const bool is_upper : {false, true}) {
      const auto at = [&](int i, int j) {
        std::array<int, 3> place{};
        place[axis] = is_upper ? cells : 0;
        place[(axis + 1) % 3] = is_upper ? i : cells - i;
        place[(axis + 2) % 3] = j;
        return vertex(place);
      };
      for (int i = 0; i < cells; ++i) {
        for (int j = 0; j < cells; ++j) {
          mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
          mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
      }
    }
  }
  return mesh;
}

/// Surface of unit cubes of a grid, those for which is_full(i, j, k) is true, with i, j, k from 0 to count -
/// 1: two triangles a square. Cubes that share an edge but no square must have a common neighbour.
template <typename IsFull>
TriangleMesh make_cube_mesh(const std::array<int, 3>& count, const IsFull& is_full) {
  TriangleMesh mesh;
  std::map<std::array<int, 3>, int> numbers;
  const auto vertex = [&](const std::array<int, 3>& p) {
    const auto [entry, is_new] = numbers.try_emplace(p, static_cast<int>(mesh.vertices.size()));
    if (is_new) mesh.vertices.emplace_back(p[0], p[1], p[2]);
    return entry->second;
  };
  const auto is_solid = [&](const std::array<int, 3>& c) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (c[i] < 0 || c[i] >= count[i]) return false;
    }
    return is_full(c[0], c[1], c[2]);
  };
  for (int i = 0; i < count[0]; ++i) {
    for (int j = 0; j < count[1]; ++j) {
      for (int k = 0; k < count[2]; ++k) {
        const std::array<int, 3> cube{i, j, k};
        if (!is_solid(cube)) continue;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          for (const int side : {0, 1}) {
            std::array<int, 3> next = cube;
            next[axis] += 2 * side - 1;
            if (is_solid(next)) continue;
            // The square between the two, counter-clockwise seen from outside.
            const auto corner = [&](int u, int v) {
              std::array<int, 3> p = cube;
              p[axis] += side;
              p[(axis + 1) % 3] += side == 1 ? u : v;
              p[(axis + 2) % 3] += side == 1 ? v : u;
              return vertex(p);
            };
            mesh.triangles.push_back({corner(0, 0), corner(1, 0), corner(1, 1)});
            mesh.triangles.push_back({corner(0, 0), corner(1, 1), corner(0, 1)});
          }
        }
      }
    }
  }
  return mesh;
}

/// The triangles of a grid of `cells` x `cells` squares, whose vertices lie row by row.
inline void add_grid_triangles(int cells, TriangleMesh& mesh) {
  const auto vertex = [&](int i, int j) { return i * (cells + 1) + j; };
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  }
}

/// Open sheet z = 0 over |x|, |y| <= half_size, its front above, of `cells` x `cells` squares of two
/// triangles.
inline TriangleMesh make_grid_sheet(double half_size, int cells) {
  TriangleMesh mesh;
  for (int i = 0; i <= cells; ++i) {
    for (int j = 0; j <= cells; ++j)
      mesh.vertices.emplace_back(half_size * (2 * i - cells) / cells, half_size * (2 * j - cells) / cells, 0);
  }
  add_grid_triangles(cells, mesh);
  return mesh;
}

}  // namespace rigor
