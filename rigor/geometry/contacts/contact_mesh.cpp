#include "rigor/geometry/contacts/contact_mesh.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/sorted_unique.hpp"
#include "rigor/core/work_count.hpp"
#include "rigor/geometry/contacts/contact_pair.hpp"
#include "rigor/geometry/contacts/extended_facet.hpp"
#include "rigor/geometry/contacts/face_clip.hpp"
#include "rigor/geometry/contacts/patch_window.hpp"
#include "rigor/geometry/convex/convex_distance.hpp"
#include "rigor/geometry/mesh/mesh_point.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/geometry/shape/aabb.hpp"
#include "rigor/geometry/shape/support.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace rigor {
namespace {

/// A normal this far outside the cone of an edge or vertex (as a sine) counts as on its border.
constexpr double kConeSlack = 1e-9;
/// Directions that differ by less are the same.
constexpr double kAlongNormal = 1e-6;

/// A triangle that is not part of a larger face, with the kinds of its sides.
MeshFacet triangle_facet(const Mesh& mesh, int t) {
  const TriangleTree::Triangle& topology = mesh.tree->triangles[at(t)];
  const std::array<int, 3>& vertices = mesh.mesh->triangles[at(t)];
  MeshFacet facet{.normal = topology.normal,
                  .vertices = {vertices.begin(), vertices.end()},
                  .patch = topology.patch,
                  .patch_area = mesh.tree->patch_areas[at(topology.patch)],
                  .is_part = mesh.tree->other_of_patch[at(topology.patch)] >= 0};
  for (std::size_t k = 0; k < 3; ++k) {
    facet.corners.push_back(mesh.mesh->vertices[at(vertices[k])]);
    facet.corner_is_real.push_back(topology.is_patch_corner[k]);
    facet.edge_is_real.push_back(topology.edge[k] != MeshEdgeKind::flat);
    facet.edges.push_back(edge_number(*mesh.mesh, *mesh.tree, t, static_cast<int>(k)));
  }
  return facet;
}

MeshFacet face_facet(const Mesh& mesh, const MeshFace& face) {
  MeshFacet facet{.normal = face.normal,
                  .vertices = face.corners,
                  .edges = face.edges,
                  .corner_is_real = face.is_corner,
                  .edge_is_real = std::vector<bool>(face.corners.size(), true),
                  .patch = face.patch,
                  .patch_area = mesh.tree->patch_areas[at(face.patch)]};
  for (const int v : face.corners) facet.corners.push_back(mesh.mesh->vertices[at(v)]);
  return facet;
}

/// The facets of the mesh near a shape, each once: faces, patches that are convex where the shape is, and
/// the triangles of others.
std::vector<MeshFacet> facets_near(const Mesh& mesh, const Pose& X_OM, const ContactShape& shape,
                                   const Aabb& box_M, double reach) {
  std::vector<MeshFacet> facets;
  std::vector<int> faces;
  std::map<int, bool> is_convex_there;  // By patch.
  for (const int t : mesh.tree->overlapping(box_M)) {
    const int patch = mesh.tree->triangles[at(t)].patch;
    const int face = mesh.tree->face_of_patch[at(patch)];
    if (face >= 0) {
      faces.push_back(face);
      continue;
    }
    const auto [known, is_new] = is_convex_there.try_emplace(patch, false);
    if (is_new) {
      std::optional<MeshFacet> window = patch_window(mesh, patch, X_OM, shape, reach);
      known->second = window.has_value();
      if (window) facets.push_back(std::move(*window));
    }
    if (!known->second) facets.push_back(triangle_facet(mesh, t));
  }
  for (const int face : sorted_unique(std::move(faces)))
    facets.push_back(face_facet(mesh, mesh.tree->faces[at(face)]));
  constexpr std::uint64_t operations = 10;  // Of a facet.
  count_following(operations * facets.size());
  return facets;
}

/// Does the surface fall away from the direction n at vertex v, that is, does no side at v rise along n?
bool is_in_vertex_cone(const Mesh& mesh, int v, const Vec3& n_M, double slack) {
  const Vec3& p = mesh.mesh->vertices[at(v)];
  for (const int t : mesh.tree->vertex_triangles[at(v)]) {
    for (const int other : mesh.mesh->triangles[at(t)]) {
      const Vec3 along = mesh.mesh->vertices[at(other)] - p;
      if (n_M.dot(along) > slack * along.norm()) return false;
    }
  }
  return true;
}

/// The same for both triangles at an edge.
bool is_in_edge_cone(const Mesh& mesh, int edge, const Vec3& n_M, double slack) {
  const int t = edge / 3;
  const std::size_t k = at(edge % 3);
  // Along n no vertex of the two triangles may rise above the edge.
  const Vec3& p = mesh.mesh->vertices[at(mesh.mesh->triangles[at(t)][k])];
  for (const int side : {t, mesh.tree->triangles[at(t)].neighbour[k]}) {
    if (side < 0) continue;
    for (const int v : mesh.mesh->triangles[at(side)]) {
      const Vec3 along = mesh.mesh->vertices[at(v)] - p;
      if (n_M.dot(along) > slack * along.norm()) return false;
    }
  }
  return true;
}

/// Whether n is the normal across a convex edge that ends at vertex v, and square to it.
bool is_across_edge_at(const Mesh& mesh, int v, const Vec3& n_M, double slack) {
  for (const int t : mesh.tree->vertex_triangles[at(v)]) {
    const std::array<int, 3>& corners = mesh.mesh->triangles[at(t)];
    for (std::size_t k = 0; k < 3; ++k) {
      const int p = corners[k], q = corners[(k + 1) % 3];
      if ((p != v && q != v) || mesh.tree->triangles[at(t)].edge[k] != MeshEdgeKind::convex) continue;
      const Vec3 along = mesh.mesh->vertices[at(q)] - mesh.mesh->vertices[at(p)];
      if (std::abs(n_M.dot(along)) > slack * along.norm()) continue;
      if (is_in_edge_cone(mesh, 3 * t + static_cast<int>(k), n_M, slack)) return true;
    }
  }
  return false;
}

/// How far a normal may be off those of the surface, as sines.
struct NormalSlack {
  double face;    ///< Off the normal of a face.
  double border;  ///< Outside the cone of an edge or a vertex.
  double end;     ///< Off those that a face or an edge keeps up to its ends.
};

/// Whether n may be that of a face at its edge as it may inside of the face: tilted along the edge only, not
/// away from the face.
bool is_along_face_at(const Mesh& mesh, int edge, const Vec3& n_M, const Vec3& normal,
                      const NormalSlack& slack) {
  const std::array<int, 3>& corners = mesh.mesh->triangles[at(edge / 3)];
  const std::size_t k = at(edge % 3);
  const Vec3 along = mesh.mesh->vertices[at(corners[(k + 1) % 3])] - mesh.mesh->vertices[at(corners[k])];
  const bool is_tilted_away = std::abs(n_M.dot(along.cross(normal))) > slack.end * along.norm();
  return !is_tilted_away && n_M.dot(normal) > 0.5 && n_M.cross(normal).norm() <= slack.face;
}

/// Is n a normal of the mesh at the contact's feature? The back of a closed surface has none. On a face it is
/// the face's. At the foot of a wall edge and vertex have none of their own, since the floor rises along all
/// of them: but what touches the wall, or its upright edge, down to the foot touches it there too.
bool is_surface_normal(const Mesh& mesh, const Feature& feature, const Vec3& n_M, const Vec3& normal,
                       const NormalSlack& slack) {
  const double facing = n_M.dot(normal), off = n_M.cross(normal).norm();
  if (mesh.tree->is_closed && facing < -kConeSlack) return false;
  switch (feature.kind) {
    case Feature::Kind::vertex:
      return (facing > 0 && off <= slack.end) || is_in_vertex_cone(mesh, feature.index, n_M, slack.border) ||
             is_across_edge_at(mesh, feature.index, n_M, slack.end);
    case Feature::Kind::edge:
      return feature.index != kNoMeshEdge && (is_along_face_at(mesh, feature.index, n_M, normal, slack) ||
                                              is_in_edge_cone(mesh, feature.index, n_M, slack.border));
    default:
      return std::abs(facing) > 0.5 && off <= slack.face;
  }
}

/// All vertices near the plane except those inside flat patches or on straight creases.
std::vector<ContactPoint> plane_contacts(const Mesh& mesh, const Pose& X_OM, const HalfSpace& plane,
                                         const Pose& X_OB, double tolerance) {
  // Along the plane's normal the highest points of a surface are vertices, so that these are all that can
  // touch.
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

Aabb box_of(const std::vector<Vec3>& corners) {
  Aabb box{corners.front(), corners.front()};
  for (const Vec3& p : corners) box = box.united({p, p});
  return box;
}

/// Collects the contacts facet by facet.
class FacetContacts {
 public:
  FacetContacts(const Mesh& mesh, const Pose& X_OM, const Shape& b, const Pose& X_OB, double tolerance,
                double reach)
      : mesh_(mesh),
        X_OM_(X_OM),
        shape_(b, X_OB),
        tolerance_(tolerance),
        reach_(reach),
        center_M_(X_OM.inverse() * X_OB.p),
        radius_(radius_about(b, Vec3::Zero())) {}

  const ContactShape& shape() const { return shape_; }

  void add(const MeshFacet& facet) {
    // Most facets near a shape lie off its ball or in planes that it does not reach.
    const Aabb box = box_of(facet.corners);
    const Vec3 nearest = box.lower.cwiseMax(center_M_.cwiseMin(box.upper));
    if ((nearest - center_M_).norm() > radius_ + reach_) return;
    const Vec3 n = X_OM_.R * facet.normal, p = X_OM_ * facet.corners.front();
    const bool is_above = n.dot(shape_.support(-n) - p) > reach_;
    const bool is_below = -n.dot(shape_.support(n) - p) > reach_;
    if (is_above || is_below) return;
    // The contact set of the facet as a convex body of its own.
    const ContactShape face(facet, X_OM_);
    const DistanceResult distance = convex_distance(face.core(), face.X_OS(), shape_.core(), shape_.X_OS());
    if (distance.distance > reach_) return;
    const ContactPair pair{face, shape_, contact_scale(face, shape_, reach_)};
    merge_ = std::max(merge_, pair.scale.merge);
    std::vector<ContactPoint> found = convex_contacts(pair, distance);
    // A part of a patch is asked for its nearest point only if the patch has none that is nearer.
    const bool is_part = facet.is_part;
    const bool is_nearest = !is_part || distance.distance <= of_hull(facet).distance + pair.scale.merge;
    if (is_nearest) add_witness_along(pair, distance, found);
    // What touches through a side that is none of the surface is kept aside. The shape may leave a part along
    // a normal of its own that would not part it from the patch: within the tolerance it lies flat on both.
    const double most_tilt = !is_part ? 1 : kAlongNormal + 4 * reach_ / face.size();
    // One point, as that of a ball, does not lie on anything down to its end.
    const double flat = found.size() > 1 ? kAlongNormal + 4 * tolerance_ / face.size() : kConeSlack;
    bool is_blocked = is_part && found.empty();
    for (const ContactPoint& contact : found) {
      const Vec3 n_M = X_OM_.R.transpose() * contact.n_W;
      const NormalSlack slack{most_tilt, kConeSlack + 2 * tilt_of(contact, distance, pair.scale.size), flat};
      if (is_surface_normal(mesh_, first_feature(contact.feature), n_M, facet.normal, slack)) {
        contacts_.push_back({contact, facet.patch});
      } else {
        is_blocked = true;
        if (!nearest_blocked_ || contact.gap < nearest_blocked_->gap) nearest_blocked_ = contact;
      }
    }
    if (is_blocked && distance.distance < 0) blocked_.push_back(facet);
  }

  /// A shape that is pressed into a flat patch may leave one of its facets faster through a side that is no
  /// side of the surface. It is then held by the face, as deep as by the others of the patch or as it would
  /// be by the convex hull of the patch, if that is left the same way.
  void add_blocked() {
    for (const MeshFacet& facet : blocked_) {
      const ContactShape face(facet, X_OM_);
      const ContactPair pair{face, shape_, contact_scale(face, shape_, reach_)};
      // How deep the patch is entered: by its other facets, or by its hull if that is left along the face's
      // normal.
      const FlatFace front = face.polygon(0);
      const bool leaves_hull_along = facet.is_part && is_along(of_hull(facet), facet);
      double depth = tolerance_;
      if (leaves_hull_along) depth = std::max(depth, tolerance_ - of_hull(facet).distance);
      for (const auto& [contact, patch] : contacts_) {
        if (patch == facet.patch) depth = std::max(depth, -contact.gap + tolerance_);
      }
      const double separated = separation(pair, front.normal);
      if (separated < -depth) {
        if (!facet.is_part) add_over_concave_edges(facet, front, -separated);
        continue;
      }
      std::optional<std::vector<ContactPoint>> contacts = face_contacts(pair, front, true);
      if (!contacts) continue;
      if (leaves_hull_along && lies_over(front, of_hull(facet).p_WB, pair.scale.slack))
        add_witness_along(pair, of_hull(facet), *contacts);
      for (const ContactPoint& contact : *contacts) contacts_.push_back({contact, facet.patch});
    }
  }

  /// The tip of a shape in a valley would leave each of the two faces sideways, into the other one: the face
  /// holds it if the shape leaves it along the normal once it goes on beyond its concave edges.
  void add_over_concave_edges(const MeshFacet& facet, const FlatFace& front, double depth) {
    // Far enough that the shortest way to the border is longer than the depth.
    const double beyond = (shape_.support(-front.normal) - front.center).norm();
    const MeshFacet larger = extended_over_concave_edges(mesh_, facet, depth + beyond);
    const ContactShape face(larger, X_OM_);
    const DistanceResult distance = convex_distance(face.core(), face.X_OS(), shape_.core(), shape_.X_OS());
    if (!is_along(distance, facet)) return;
    const ContactPair pair{face, shape_, contact_scale(face, shape_, reach_)};
    const auto contacts = face_contacts(pair, face.polygon(0), true);
    if (!contacts) return;
    for (const ContactPoint& contact : *contacts) {
      if (is_within_reach(contact)) contacts_.push_back({contact, facet.patch});
    }
  }

  /// What lies deeper than all contacts is one, even where its direction is no normal of the surface: a set
  /// that left it out would say that the shapes overlap less than they do.
  void add_deepest() {
    if (contacts_.empty() || !nearest_blocked_) return;
    const auto is_deeper = [](const auto& x, const auto& y) { return x.first.gap < y.first.gap; };
    const double deepest = std::ranges::min_element(contacts_, is_deeper)->first.gap;
    if (nearest_blocked_->gap >= std::min(deepest, 0.0) - merge_) return;
    contacts_.push_back({*nearest_blocked_, 0});
    contacts_.back().first.degenerate = true;
  }

  /// Where a corner touches a corner of the mesh without any distance, the directions that the facets see
  /// are arbitrary and may all be blocked. The mean normal of the surface is the one to take then.
  void add_corner_if_empty() {
    if (!contacts_.empty() || !nearest_blocked_) return;
    ContactPoint contact = *nearest_blocked_;
    const Vec3 p_M = X_OM_.inverse() * contact.p_WA;
    contact.n_W = X_OM_.R * nearest_mesh_point(mesh_, p_M).normal_M.normalized();
    contact.gap = contact.n_W.dot(contact.p_WB - contact.p_WA);
    contact.p_WB = contact.p_WA + contact.gap * contact.n_W;
    contact.degenerate = true;
    contacts_.push_back({contact, 0});
  }

  std::vector<ContactPoint> merged() const {
    std::vector<ContactPoint> contacts;
    for (const auto& [contact, patch] : contacts_) contacts.push_back(contact);
    sort_and_merge({.tolerance = reach_, .tie = 0, .slack = 0, .merge = merge_}, contacts);
    return contacts;
  }

 private:
  /// A facet has no inside: the shortest way out of it says nothing about the surface unless it is that of
  /// the contacts.
  static void add_witness_along(const ContactPair& pair, const DistanceResult& distance,
                                std::vector<ContactPoint>& contacts) {
    if (distance.distance >= -pair.scale.merge || is_their_way(distance, contacts))
      add_witness(pair, distance, contacts);
  }
  /// A face that agrees with the separating direction within the tolerance stands for it: a cap that lies
  /// along an edge, tilted by far less, has a normal a little outside the cone of the edge.
  double tilt_of(const ContactPoint& contact, const DistanceResult& distance, double size) const {
    const double tilt = (contact.n_W - distance.n_W).norm();
    return tilt * size <= reach_ ? tilt : 0;
  }
  /// Whether the point of the shape is inside the mesh, as deep as the contact says: under another part of
  /// the surface, or outside, it is none of the face's.
  bool is_within_reach(const ContactPoint& contact) const {
    const Vec3 p_M = X_OM_.inverse() * contact.p_WB;
    const MeshPoint nearest = nearest_mesh_point(mesh_, p_M);
    return (p_M - nearest.p_M).dot(nearest.normal_M) <= 0 && -contact.gap <= nearest.distance + tolerance_;
  }
  bool is_along(const DistanceResult& distance, const MeshFacet& facet) const {
    return (distance.n_W - X_OM_.R * facet.normal).norm() <= kAlongNormal;
  }
  /// Signed distance of the shape from the convex hull of the patch that the facet is a part of.
  const DistanceResult& of_hull(const MeshFacet& facet) {
    const auto known = of_hulls_.find(facet.patch);
    if (known != of_hulls_.end()) return known->second;
    const std::vector<Vec3>& hull =
        mesh_.tree->other_patches[at(mesh_.tree->other_of_patch[at(facet.patch)])].hull;
    const DistanceResult d = convex_distance(make_points_core(hull), X_OM_, shape_.core(), shape_.X_OS());
    return of_hulls_.emplace(facet.patch, d).first->second;
  }

  const Mesh& mesh_;
  const Pose& X_OM_;
  const ContactShape shape_;
  const double tolerance_;
  const double reach_;
  const Vec3 center_M_;  ///< Of a ball that holds the shape.
  const double radius_;
  double merge_ = 0;
  std::vector<std::pair<ContactPoint, int>> contacts_;  ///< With the patch of the facet.
  std::map<int, DistanceResult> of_hulls_;              ///< By patch.
  std::vector<MeshFacet> blocked_;
  std::optional<ContactPoint> nearest_blocked_;
};

}  // namespace

std::vector<ContactPoint> mesh_contacts(const Mesh& mesh, const Pose& X_OM, const Shape& b, const Pose& X_OB,
                                        double tolerance, double reach) {
  RIGOR_ASSERT(mesh.tree != nullptr && !std::holds_alternative<Mesh>(b));
  if (const HalfSpace* plane = std::get_if<HalfSpace>(&b)) {
    return plane_contacts(mesh, X_OM, *plane, X_OB, reach);
  }
  FacetContacts contacts(mesh, X_OM, b, X_OB, tolerance, reach);
  const Aabb box_M = axis_aligned_box(b, X_OM.inverse() * X_OB).grown(reach);
  for (const MeshFacet& facet : facets_near(mesh, X_OM, contacts.shape(), box_M, reach)) contacts.add(facet);
  contacts.add_blocked();
  contacts.add_deepest();
  contacts.add_corner_if_empty();
  return contacts.merged();
}

}  // namespace rigor
