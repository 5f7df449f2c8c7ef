#include "rigor/geometry/decomposition/hull_excess.hpp"

#include "rigor/core/index.hpp"
#include "rigor/geometry/mesh/mesh_point.hpp"
#include "rigor/math/compensated_sum.hpp"

#include <algorithm>
#include <limits>

namespace rigor {

MaximumBounds hull_excess(const ConvexHull& hull, const Mesh& mesh, const WindingNumber& winding,
                          const MaximumGoal& goal, std::span<const CutPlane> in_front_of) {
  // Branch and bound: the signed distance from the solid changes by no more than the distance between two
  // points, so its value at the centre of a box bounds it in the whole box.
  LipschitzFunction distance;
  distance.value = [&](const Vec3& p) {
    const double length = nearest_mesh_point(mesh, p).distance;
    return winding(p) >= 1 ? -length : length;
  };
  // Lower bound of the distance of a point from the set to be searched: the hull, and the front of one of the
  // planes.
  distance.beyond = [&](const Vec3& p) {
    double highest = -std::numeric_limits<double>::infinity();
    for (const CutPlane& plane : in_front_of) highest = std::max(highest, plane.height(p));
    double beyond = in_front_of.empty() ? 0 : std::max(-highest, 0.0);
    for (std::size_t f = 0; f < hull.faces.size(); ++f) {
      const Vec3& corner = hull.vertices[at(hull.faces[f][0])];
      beyond = std::max(beyond, hull.face_normals[f].dot(p - corner));
    }
    return beyond;
  };
  distance.box = {hull.vertices[0], hull.vertices[0]};
  for (const Vec3& v : hull.vertices) distance.box = distance.box.united({v, v});
  return lipschitz_maximum(distance, goal);
}

double hull_volume(const ConvexHull& hull) {
  // Sum of the signed volumes of the tetrahedra from one corner to the triangles of the faces; the
  // compensation keeps it accurate where they cancel.
  CompensatedSum sum;
  const Vec3& origin = hull.vertices[0];
  for (const std::vector<int>& face : hull.faces) {
    const auto corner = [&](std::size_t i) -> Vec3 { return hull.vertices[at(face[i])] - origin; };
    for (std::size_t i = 2; i < face.size(); ++i) {
      sum.add(corner(0).dot(corner(i - 1).cross(corner(i))) / 6);
    }
  }
  return sum.value();
}

}  // namespace rigor
