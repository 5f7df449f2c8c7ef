#include "rigor/geometry/contacts/contact_mesh.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/geometry/contacts/contact_pair.hpp"
#include "rigor/geometry/convex/convex_distance.hpp"
#include "rigor/geometry/mesh/mesh_point.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/geometry/shape/aabb.hpp"
#include "rigor/geometry/shape/support.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace rigor {
namespace {

/// A normal this far outside the cone of an edge or vertex (as a sine) counts as on its border.
constexpr double kConeSlack = 1e-9;

MeshTriangle mesh_triangle(const Mesh& mesh, int t) {
  const TriangleTree::Triangle& topology = mesh.tree->triangles[at(t)];
  MeshTriangle triangle{
      .normal = topology.normal, .vertices = mesh.mesh->triangles[at(t)], .patch = topology.patch};
  for (std::size_t k = 0; k < 3; ++k) {
    triangle.corners[k] = mesh.mesh->vertices[at(triangle.vertices[k])];
    triangle.corner_is_real[k] = topology.is_patch_corner[k];
    triangle.edge_is_real[k] = topology.edge[k] != MeshEdgeKind::flat;
    triangle.edges[k] = 3 * t + static_cast<int>(k);
    // The neighbour's number where that is the lower one.
    const int neighbour = topology.neighbour[k];
    if (neighbour < 0 || neighbour > t) continue;
    const std::array<int, 3>& other = mesh.mesh->triangles[at(neighbour)];
    for (std::size_t j = 0; j < 3; ++j) {
      if (other[j] == triangle.vertices[(k + 1) % 3] && other[(j + 1) % 3] == triangle.vertices[k]) {
        triangle.edges[k] = 3 * neighbour + static_cast<int>(j);
      }
    }
  }
  return triangle;
}

/// Does the surface fall away from the direction n at vertex v, that is, does no side at v rise along n?
bool is_in_vertex_cone(const Mesh& mesh, int v, const Vec3& n_M) {
  const Vec3& p = mesh.mesh->vertices[at(v)];
  for (const int t : mesh.tree->vertex_triangles[at(v)]) {
    for (const int other : mesh.mesh->triangles[at(t)]) {
      const Vec3 along = mesh.mesh->vertices[at(other)] - p;
      if (n_M.dot(along) > kConeSlack * along.norm()) return false;
    }
  }
  return true;
}

/// The same for both triangles at an edge.
bool is_in_edge_cone(const Mesh& mesh, int edge, const Vec3& n_M) {
  const int t = edge / 3;
  const std::size_t k = at(edge % 3);
  const Vec3& p = mesh.mesh->vertices[at(mesh.mesh->triangles[at(t)][k])];
  for (const int side : {t, mesh.tree->triangles[at(t)].neighbour[k]}) {
    if (side < 0) continue;
    for (const int v : mesh.mesh->triangles[at(side)]) {
      const Vec3 along = mesh.mesh->vertices[at(v)] - p;
      if (n_M.dot(along) > kConeSlack * along.norm()) return false;
    }
  }
  return true;
}

/// Is n a normal of the mesh at the contact's feature? The back of a closed surface has none.
bool is_surface_normal(const Mesh& mesh, const Feature& feature, const Vec3& n_M,
                       const Vec3& triangle_normal) {
  const double facing = n_M.dot(triangle_normal);
  if (mesh.tree->is_closed && facing < -kConeSlack) return false;
  switch (feature.kind) {
    case Feature::Kind::vertex:
      return is_in_vertex_cone(mesh, feature.index, n_M);
    case Feature::Kind::edge:
      return is_in_edge_cone(mesh, feature.index, n_M);
    default:
      return std::abs(facing) > 0.5;
  }
}

/// All vertices near the plane except those inside flat patches or on straight creases.
std::vector<ContactPoint> plane_contacts(const Mesh& mesh, const Pose& X_OM, const HalfSpace& plane,
                                         const Pose& X_OB, double tolerance) {
  const Vec3 n = X_OB.R * plane.normal;
  const double offset = plane.offset + n.dot(X_OB.p);
  SurfaceCurvature flat;
  flat.flat_count = 2;
  std::vector<ContactPoint> contacts;
  for (std::size_t v = 0; v < mesh.mesh->vertices.size(); ++v) {
    if (!mesh.tree->is_crease_corner[v]) continue;
    const Vec3 p = X_OM * mesh.mesh->vertices[v];
    const double gap = n.dot(p) - offset;
    if (gap > tolerance) continue;
    const Feature vertex{Feature::Kind::vertex, static_cast<int>(v)}, face{Feature::Kind::face, 0};
    contacts.push_back({.p_WA = p,
                        .p_WB = p - gap * n,
                        .n_W = -n,
                        .gap = gap,
                        .feature = feature_pair(vertex, face),
                        .curvature_B = flat});
  }
  return contacts;
}

Vec3 triangle_lower(const MeshTriangle& t) {
  return t.corners[0].cwiseMin(t.corners[1]).cwiseMin(t.corners[2]);
}

Vec3 triangle_upper(const MeshTriangle& t) {
  return t.corners[0].cwiseMax(t.corners[1]).cwiseMax(t.corners[2]);
}

/// Collects the contacts triangle by triangle.
class TriangleContacts {
 public:
  TriangleContacts(const Mesh& mesh, const Pose& X_OM, const Shape& b, const Pose& X_OB, double tolerance)
      : mesh_(mesh),
        X_OM_(X_OM),
        shape_(b, X_OB),
        tolerance_(tolerance),
        center_M_(X_OM.inverse() * X_OB.p),
        radius_(radius_about(b, Vec3::Zero())) {}

  void add(int t) {
    const MeshTriangle triangle = mesh_triangle(mesh_, t);
    const ContactShape face(triangle, X_OM_);
    // Most triangles near a shape lie off its ball or in planes that it does not reach.
    const Vec3 nearest = triangle_lower(triangle).cwiseMax(center_M_.cwiseMin(triangle_upper(triangle)));
    if ((nearest - center_M_).norm() > radius_ + tolerance_) return;
    const Vec3 n = X_OM_.R * triangle.normal;
    const bool is_above = n.dot(shape_.support(-n) - face.X_OS().p) > tolerance_;
    const bool is_below = -n.dot(shape_.support(n) - face.X_OS().p) > tolerance_;
    if (is_above || is_below) return;
    // The contact set of the triangle as a convex body of its own.
    const DistanceResult distance = convex_distance(face.core(), face.X_OS(), shape_.core(), shape_.X_OS());
    if (distance.distance > tolerance_) return;
    const ContactPair pair{face, shape_, contact_scale(face, shape_, tolerance_)};
    merge_ = std::max(merge_, pair.scale.merge);
    // What touches through a side that is none of the surface is kept aside.
    bool is_blocked = false;
    for (const ContactPoint& contact : convex_contacts(pair, distance)) {
      const Vec3 n_M = X_OM_.R.transpose() * contact.n_W;
      if (is_surface_normal(mesh_, first_feature(contact.feature), n_M, triangle.normal)) {
        contacts_.push_back({contact, triangle.patch});
      } else {
        is_blocked = true;
        if (!nearest_blocked_ || contact.gap < nearest_blocked_->gap) nearest_blocked_ = contact;
      }
    }
    if (is_blocked && distance.distance < 0) blocked_.push_back(t);
  }

  /// A shape that is pressed into a flat patch may leave one of its triangles faster through a side that is
  /// no side of the surface. It is then held by the face, as deep as by the others of the patch.
  void add_blocked() {
    for (const int t : blocked_) {
      const MeshTriangle triangle = mesh_triangle(mesh_, t);
      const ContactShape face(triangle, X_OM_);
      const ContactPair pair{face, shape_, contact_scale(face, shape_, tolerance_)};
      const FlatFace front = face.polygon(0);
      double depth = tolerance_;
      for (const auto& [contact, patch] : contacts_) {
        if (patch == triangle.patch) depth = std::max(depth, -contact.gap + tolerance_);
      }
      if (separation(pair, front.normal) < -depth) continue;
      const std::optional<std::vector<ContactPoint>> contacts = face_contacts(pair, front, true);
      if (!contacts) continue;
      for (const ContactPoint& contact : *contacts) contacts_.push_back({contact, triangle.patch});
    }
  }

  /// Where a corner touches a corner of the mesh without any distance, the directions that the triangles see
  /// are arbitrary and may all be blocked. The mean normal of the surface is the one to take then.
  void add_corner_if_empty() {
    if (!contacts_.empty() || !nearest_blocked_) return;
    ContactPoint contact = *nearest_blocked_;
    const Vec3 p_M = X_OM_.inverse() * contact.p_WA;
    contact.n_W = X_OM_.R * nearest_mesh_point(mesh_, p_M).normal_M.normalized();
    contact.gap = contact.n_W.dot(contact.p_WB - contact.p_WA);
    contact.degenerate = true;
    contacts_.push_back({contact, 0});
  }

  std::vector<ContactPoint> merged() const {
    std::vector<ContactPoint> contacts;
    for (const auto& [contact, patch] : contacts_) contacts.push_back(contact);
    sort_and_merge({.tolerance = tolerance_, .tie = 0, .slack = 0, .merge = merge_}, contacts);
    return contacts;
  }

 private:
  const Mesh& mesh_;
  const Pose& X_OM_;
  const ContactShape shape_;
  const double tolerance_;
  const Vec3 center_M_;  ///< Of a ball that holds the shape.
  const double radius_;
  double merge_ = 0;
  std::vector<std::pair<ContactPoint, int>> contacts_;  ///< With the patch of the triangle.
  std::vector<int> blocked_;
  std::optional<ContactPoint> nearest_blocked_;
};

}  // namespace

std::vector<ContactPoint> mesh_contacts(const Mesh& mesh, const Pose& X_OM, const Shape& b, const Pose& X_OB,
                                        double tolerance) {
  RIGOR_ASSERT(mesh.tree != nullptr && !std::holds_alternative<Mesh>(b));
  if (const HalfSpace* plane = std::get_if<HalfSpace>(&b)) {
    return plane_contacts(mesh, X_OM, *plane, X_OB, tolerance);
  }
  TriangleContacts contacts(mesh, X_OM, b, X_OB, tolerance);
  const Aabb box_M = axis_aligned_box(b, X_OM.inverse() * X_OB).grown(tolerance);
  for (const int t : mesh.tree->overlapping(box_M)) contacts.add(t);
  contacts.add_blocked();
  contacts.add_corner_if_empty();
  return contacts.merged();
}

}  // namespace rigor
