#include "rigor/geometry/contacts/contact_enclosed.hpp"

#include "rigor/core/index.hpp"
#include "rigor/geometry/contacts/contact_shape.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/mesh/mesh_point.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/geometry/mesh/wide_tree.hpp"
#include "rigor/geometry/shape/containment.hpp"
#include "rigor/geometry/shape/support.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"

#include <algorithm>

namespace rigor {
namespace {

bool holds(const Shape& solid, const Vec3& p_S) {
  const Mesh* const mesh = std::get_if<Mesh>(&solid);
  if (mesh == nullptr) return contains(solid, p_S);
  if (!mesh->tree->is_closed || mesh->tree->nodes.empty()) return false;
  const Aabb& box = mesh->tree->nodes.front().box;
  if ((p_S.array() < box.lower.array()).any() || (p_S.array() > box.upper.array()).any()) return false;
  const MeshPoint nearest = nearest_mesh_point(*mesh, p_S);
  return (p_S - nearest.p_M).dot(nearest.normal_M) < 0;
}

/// Whether the solid a holds a point of b; of each part of a mesh that hangs together one is looked at.
bool holds_point_of(const Shape& a, const Shape& b, const Pose& X_AB) {
  const Mesh* const mesh = std::get_if<Mesh>(&b);
  if (mesh == nullptr) return holds(a, X_AB * support_point(b, Vec3::UnitZ()));
  return std::ranges::any_of(mesh->tree->shell_vertices,
                             [&](int v) { return holds(a, X_AB * mesh->mesh->vertices[at(v)]); });
}

/// Whether the surfaces of a mesh and a convex shape may meet. Those of two meshes that do have a contact.
bool may_meet(const Shape& a, const Shape& b, const Pose& X_AB) {
  if (std::holds_alternative<Mesh>(b)) return false;
  return !std::get<Mesh>(a).tree->overlapping(axis_aligned_box(b, X_AB)).empty();
}

}  // namespace

std::optional<ContactPoint> find_enclosed_contact(const Shape& a, const Pose& X_OA, const Shape& b,
                                                  const Pose& X_OB) {
  const Pose X_AB = X_OA.inverse() * X_OB;
  // Where the surfaces do not meet, one solid is inside the other if it holds any point of it.
  const bool may_overlap =
      may_meet(a, b, X_AB) || holds_point_of(a, b, X_AB) || holds_point_of(b, a, X_AB.inverse());
  if (!may_overlap) return std::nullopt;
  const DistanceResult way_out = signed_distance(a, X_OA, b, X_OB);
  if (!(way_out.distance < 0)) return std::nullopt;
  // The shortest way out is the one contact.
  const Feature face{Feature::Kind::face, 0};
  return ContactPoint{.p_WA = way_out.p_WA,
                      .p_WB = way_out.p_WB,
                      .n_W = way_out.n_W,
                      .gap = way_out.distance,
                      .feature = feature_pair(face, face),
                      .degenerate = true};
}

}  // namespace rigor
