#include "rigor/contact/system/face_normals.hpp"

#include <algorithm>
#include <utility>

namespace rigor {

namespace {

bool is_corner(const SurfaceCurvature& surface) {
  return surface.flat_count == 0 && surface.radius_W.isZero(0);
}

/// Whether a corner of B lies on a face of A.
bool is_corner_of_B(const ContactPoint& point) {
  return point.curvature_A.flat_count == 2 && is_corner(point.curvature_B);
}

/// Whether a corner of A lies on a face of B.
bool is_corner_of_A(const ContactPoint& point) {
  return point.curvature_B.flat_count == 2 && is_corner(point.curvature_A);
}

bool are_on_same_faces(const Contact& a, const Contact& b) {
  // Points of one region have the same normal to the last bit or two.
  constexpr double parallel = 1e-12;
  return !a.stop && !b.stop && a.body_A == b.body_A && a.body_B == b.body_B && a.shape_A == b.shape_A &&
         a.shape_B == b.shape_B && (a.point.n_W - b.point.n_W).norm() <= parallel &&
         (is_corner_of_A(b.point) || is_corner_of_B(b.point));
}

/// Whether three of the points are far from one line.
bool span_a_plane(const std::vector<ContactPoint*>& points) {
  constexpr double share = 1e-3;
  const Vec3 first = points.front()->p_WB;
  Vec3 longest = Vec3::Zero();
  for (const ContactPoint* point : points) {
    const Vec3 d = point->p_WB - first;
    if (d.norm() > longest.norm()) longest = d;
  }
  return std::any_of(points.begin(), points.end(), [&](const ContactPoint* point) {
    return (point->p_WB - first).cross(longest).norm() > share * longest.squaredNorm();
  });
}

}  // namespace

void share_normals_of_faces(std::vector<Contact>& contacts) {
  std::vector<bool> is_done(contacts.size());
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    // The points of these two faces.
    std::vector<ContactPoint*> points;
    bool has_corner_of_A = false, has_corner_of_B = false;
    for (std::size_t k = i; k < contacts.size(); ++k) {
      if (is_done[k] || !are_on_same_faces(contacts[i], contacts[k])) continue;
      is_done[k] = true;
      has_corner_of_A = has_corner_of_A || is_corner_of_A(contacts[k].point);
      has_corner_of_B = has_corner_of_B || is_corner_of_B(contacts[k].point);
      points.push_back(&contacts[k].point);
    }
    if (!has_corner_of_A || !has_corner_of_B || !span_a_plane(points)) continue;

    // The face of B carries the normal of all.
    for (ContactPoint* point : points) {
      if (!is_corner_of_B(*point)) continue;
      std::swap(point->curvature_A, point->curvature_B);
      point->curvature_A.flat_W = point->n_W;
    }
  }
}

}  // namespace rigor
