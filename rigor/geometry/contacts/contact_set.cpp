#include "rigor/geometry/contacts/contact_set.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/geometry/contacts/cavity_contacts.hpp"
#include "rigor/geometry/contacts/contact_enclosed.hpp"
#include "rigor/geometry/contacts/contact_mesh.hpp"
#include "rigor/geometry/contacts/contact_pair.hpp"
#include "rigor/geometry/contacts/mesh_pair_contacts.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/distance/mesh_pair_distance.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"

#include <algorithm>
#include <limits>
#include <optional>

namespace rigor {
namespace {

/// Planes and cavities, and meshes, which may be large.
bool is_wide(const Shape& shape) {
  return is_unbounded(shape) || std::holds_alternative<Mesh>(shape);
}

/// Whether the pair is computed with its shapes exchanged: a cavity is A, else a mesh is treated as A, else a
/// plane, else the shapes as they come.
bool is_exchanged_pair(const Shape& a, const Shape& b) {
  if (std::holds_alternative<Cavity>(a) || std::holds_alternative<Cavity>(b))
    return std::holds_alternative<Cavity>(b);
  const bool is_a_mesh = std::holds_alternative<Mesh>(a);
  return std::holds_alternative<Mesh>(b) || (std::holds_alternative<HalfSpace>(b) && !is_a_mesh);
}

/// The contacts with the two shapes exchanged.
std::vector<ContactPoint> exchanged(std::vector<ContactPoint> contacts) {
  for (ContactPoint& contact : contacts) {
    std::swap(contact.p_WA, contact.p_WB);
    std::swap(contact.curvature_A, contact.curvature_B);
    contact.n_W = -contact.n_W;
    contact.feature = contact.feature << 32 | contact.feature >> 32;
  }
  std::stable_sort(contacts.begin(), contacts.end(),
                   [](const ContactPoint& x, const ContactPoint& y) { return x.feature < y.feature; });
  return contacts;
}

std::vector<ContactPoint> plane_contacts(const HalfSpace& plane, const Pose& X_OA, const ContactPair& pair) {
  const Vec3 n = X_OA.R * plane.normal;
  const FlatFace face{.kind = FlatFace::Kind::plane,
                      .feature = {Feature::Kind::face, 0},
                      .normal = n,
                      .center = X_OA.p + plane.offset * n,
                      .area = std::numeric_limits<double>::infinity()};
  return face_contacts(pair, face, true).value_or(std::vector<ContactPoint>{});
}

/// All pairs near the origin but those whose unbounded shape comes second.
std::vector<ContactPoint> contacts_within(const Shape& a, const Pose& X_OA, const Shape& b, const Pose& X_OB,
                                          double tolerance, double reach) {
  if (const Cavity* const cavity = std::get_if<Cavity>(&a))
    return cavity_contacts(*cavity, X_OA, b, X_OB, reach);
  const Mesh* const mesh = std::get_if<Mesh>(&a);
  const Mesh* const other = std::get_if<Mesh>(&b);
  if (mesh != nullptr) {
    std::vector<ContactPoint> contacts = other != nullptr
                                             ? mesh_pair_contacts(*mesh, X_OA, *other, X_OB, tolerance, reach)
                                             : mesh_contacts(*mesh, X_OA, b, X_OB, tolerance, reach);
    if (!contacts.empty() || std::holds_alternative<HalfSpace>(b)) return contacts;
    if (const auto enclosed = find_enclosed_contact(a, X_OA, b, X_OB)) contacts.push_back(*enclosed);
    return contacts;
  }
  const std::optional<DistanceResult> near = distance_within(a, X_OA, b, X_OB, reach);
  if (!near) return {};
  const DistanceResult& distance = *near;
  const ContactShape shape_A(a, X_OA), shape_B(b, X_OB);
  const ContactPair pair{shape_A, shape_B, contact_scale(shape_A, shape_B, reach)};
  const HalfSpace* const plane = std::get_if<HalfSpace>(&a);
  std::vector<ContactPoint> contacts =
      plane != nullptr ? plane_contacts(*plane, X_OA, pair) : convex_contacts(pair, distance);
  add_witness(pair, distance, contacts);
  sort_and_merge(pair.scale, contacts);
  return contacts;
}

bool has_edges(const Shape& shape) {
  return std::holds_alternative<Box>(shape) || std::holds_alternative<Convex>(shape) ||
         std::holds_alternative<Mesh>(shape);
}

/// The contacts that touch, and of the others near those that do not touch yet and are none of these.
std::vector<ContactPoint> joined(const std::vector<ContactPoint>& touching,
                                 const std::vector<ContactPoint>& near, double tolerance) {
  std::vector<ContactPoint> all = touching;
  for (const ContactPoint& contact : near) {
    const bool is_known = std::ranges::any_of(
        touching, [&](const ContactPoint& other) { return other.feature == contact.feature; });
    if (contact.gap > tolerance && !is_known) all.push_back(contact);
  }
  std::ranges::stable_sort(all, {}, &ContactPoint::feature);
  return all;
}

/// Edges that touch do so with their own normal, however far the reach is within which faces lie on each
/// other. What overlaps by a depth lies on each other within twice that.
std::vector<ContactPoint> local_contacts(const Shape& a, const Pose& X_OA, const Shape& b, const Pose& X_OB,
                                         double tolerance, double reach) {
  std::vector<ContactPoint> near = contacts_within(a, X_OA, b, X_OB, tolerance, reach);
  if (near.empty() || !has_edges(a) || !has_edges(b)) return near;
  const double deepest = std::ranges::min_element(near, {}, &ContactPoint::gap)->gap;
  const double touching = std::max(tolerance, -2 * deepest);
  if (deepest > tolerance || touching >= reach) return near;
  return joined(contacts_within(a, X_OA, b, X_OB, tolerance, touching), near, tolerance);
}

}  // namespace

std::vector<ContactPoint> contact_set(const Shape& shape_a, const Pose& X_WA, const Shape& shape_b,
                                      const Pose& X_WB, double tolerance) {
  return contact_set(shape_a, X_WA, shape_b, X_WB, ContactReach{tolerance, tolerance});
}

std::vector<ContactPoint> contact_set(const Shape& shape_a, const Pose& X_WA, const Shape& shape_b,
                                      const Pose& X_WB, const ContactReach& within) {
  const auto [tolerance, reach] = within;
  RIGOR_ASSERT(tolerance >= 0 && reach >= tolerance);
  // A mesh that bounds a convex solid is that solid, however its faces are cut.
  const Shape &a = convex_solid(shape_a), &b = convex_solid(shape_b);
  RIGOR_ASSERT(!(is_unbounded(a) && is_unbounded(b)));
  poll_interrupt();
  // Two meshes of which both or neither are convex go in an order of their own.
  const Mesh *const mesh_a = std::get_if<Mesh>(&shape_a), *const mesh_b = std::get_if<Mesh>(&shape_b);
  const bool are_meshes = mesh_a != nullptr && mesh_b != nullptr && a.index() == b.index();
  const bool is_exchanged =
      are_meshes ? is_mesh_pair_swapped(*mesh_a, X_WA, *mesh_b, X_WB) : is_exchanged_pair(a, b);

  // Everything happens in a frame at a bounded shape, so that the distance to the origin of W costs no
  // digits.
  const bool is_at_b = are_meshes ? !is_exchanged : is_wide(a);
  const Vec3 origin = is_at_b ? X_WB.p : X_WA.p;
  const Pose X_OA{X_WA.R, X_WA.p - origin}, X_OB{X_WB.R, X_WB.p - origin};
  std::vector<ContactPoint> contacts = is_exchanged
                                           ? exchanged(local_contacts(b, X_OB, a, X_OA, tolerance, reach))
                                           : local_contacts(a, X_OA, b, X_OB, tolerance, reach);
  for (ContactPoint& contact : contacts) {
    contact.p_WA += origin;
    contact.p_WB += origin;
  }
  return contacts;
}

}  // namespace rigor
