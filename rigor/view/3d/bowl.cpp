#include "rigor/view/3d/bowl.hpp"

#include "rigor/geometry/decomposition/make_mesh.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

namespace rigor {
namespace {

constexpr int bowl_sides = 96, rings = 24;

/// Vertices of the hemisphere z ≤ 0: the pole, then ring after ring up to z = 0.
void add_half_sphere(double radius, TriangleMesh& mesh) {
  mesh.vertices.push_back(Vec3(0, 0, -radius));
  for (int i = 1; i <= rings; ++i) {
    const double tilt = 0.5 * std::numbers::pi * i / rings;
    for (int k = 0; k < bowl_sides; ++k) {
      const double azimuth = 2 * std::numbers::pi * k / bowl_sides;
      mesh.vertices.push_back(radius * Vec3(std::sin(tilt) * std::cos(azimuth),
                                            std::sin(tilt) * std::sin(azimuth), -std::cos(tilt)));
    }
  }
}

/// Inner and outer hemisphere and the rim between them, with normals pointing outwards.
std::shared_ptr<const TriangleMesh> bowl_mesh(double radius) {
  constexpr double thickness = 0.02;
  TriangleMesh mesh;
  add_half_sphere(radius, mesh);
  const int outer = static_cast<int>(mesh.vertices.size());
  add_half_sphere((1 + thickness) * radius, mesh);
  const auto vertex = [](int first, int ring, int k) {
    return ring == 0 ? first : first + 1 + (ring - 1) * bowl_sides + k % bowl_sides;
  };
  const auto add_quad = [&](std::array<int, 4> corners, bool is_turned) {
    if (is_turned) std::swap(corners[1], corners[3]);
    if (corners[0] != corners[1]) mesh.triangles.push_back({corners[0], corners[1], corners[2]});
    if (corners[0] != corners[3] && corners[2] != corners[3])
      mesh.triangles.push_back({corners[0], corners[2], corners[3]});
  };
  for (const int first : {0, outer}) {
    for (int ring = 0; ring < rings; ++ring) {
      for (int k = 0; k < bowl_sides; ++k) {
        // Seen from outside, the quads of a ring run clockwise downwards, so those of the inner hemisphere
        // are reversed.
        add_quad({vertex(first, ring + 1, k), vertex(first, ring, k), vertex(first, ring, k + 1),
                  vertex(first, ring + 1, k + 1)},
                 first == 0);
      }
    }
  }
  for (int k = 0; k < bowl_sides; ++k) {
    add_quad(
        {vertex(0, rings, k), vertex(outer, rings, k), vertex(outer, rings, k + 1), vertex(0, rings, k + 1)},
        false);
  }
  return std::make_shared<const TriangleMesh>(std::move(mesh));
}

}  // namespace

Shape drawn_form(const Shape& shape) {
  if (const Cavity* const cavity = std::get_if<Cavity>(&shape)) return make_mesh(bowl_mesh(cavity->radius));
  constexpr double slenderest = 1.0 / 150;  // Radius to half the length.
  Shape form = shape;
  const auto thicken = [](auto& rod) { rod.radius = std::max(rod.radius, slenderest * rod.half_length); };
  if (Capsule* const capsule = std::get_if<Capsule>(&form)) thicken(*capsule);
  if (Cylinder* const cylinder = std::get_if<Cylinder>(&form)) thicken(*cylinder);
  return form;
}

}  // namespace rigor
