#include "rigor/geometry/contacts/parting_contacts.hpp"

#include "rigor/geometry/contacts/contact_pair.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <variant>

namespace rigor {
namespace {

/// The rate of the gap that shrinks fastest [m/s].
double slowest(const std::vector<ContactPoint>& contacts, const PointVelocity& velocity) {
  double rate = std::numeric_limits<double>::infinity();
  for (const ContactPoint& contact : contacts)
    rate = std::min(rate, contact.n_W.dot(velocity(0.5 * (contact.p_WA + contact.p_WB))));
  return rate;
}

bool is_solid(const Shape& shape) {
  return !is_unbounded(shape) && !std::holds_alternative<Mesh>(shape);
}

/// The contacts with a face; where the shape covers none of it, at the nearest points.
std::vector<ContactPoint> contacts_along(const ContactPair& pair, const FlatFace& face, bool is_of_A,
                                         const DistanceResult& distance) {
  std::vector<ContactPoint> contacts =
      face_contacts(pair, face, is_of_A).value_or(std::vector<ContactPoint>{});
  if (contacts.empty()) {
    DistanceResult along = distance;
    along.n_W = is_of_A ? face.normal : (-face.normal).eval();
    ContactPoint contact = witness_contact(pair, along);
    contact.n_W = along.n_W;
    contact.gap = separation(pair, contact.n_W);
    contact.p_WB = contact.p_WA + contact.gap * contact.n_W;
    contacts.push_back(contact);
  }
  for (ContactPoint& contact : contacts) contact.degenerate = true;
  sort_and_merge(pair.scale, contacts);
  return contacts;
}

}  // namespace

// NOLINTNEXTLINE(readability-function-size): two shapes, each with its pose.
std::optional<std::vector<ContactPoint>> parting_contacts(const Shape& shape_a, const Pose& X_WA,
                                                          const Shape& shape_b, const Pose& X_WB,
                                                          double tolerance,
                                                          const std::vector<ContactPoint>& found,
                                                          const PointVelocity& velocity) {
  const Shape &a = convex_solid(shape_a), &b = convex_solid(shape_b);
  if (!is_solid(a) || !is_solid(b) || found.empty()) return {};
  double best = slowest(found, velocity);
  if (best >= 0) return {};

  // In a frame at A, as the contact set.
  const Vec3 origin = X_WA.p;
  const Pose X_OA{X_WA.R, Vec3::Zero()}, X_OB{X_WB.R, X_WB.p - origin};
  const ContactShape shape_A(a, X_OA), shape_B(b, X_OB);
  const ContactPair pair{shape_A, shape_B, contact_scale(shape_A, shape_B, tolerance)};
  const DistanceResult distance = signed_distance(a, X_OA, b, X_OB);
  const PointVelocity velocity_O = [&](const Vec3& p_O) { return velocity(p_O + origin); };

  // The faces of both at the place, along whose normals the shapes are apart but for half the tolerance.
  std::optional<std::vector<ContactPoint>> result;
  const auto try_faces = [&](const std::vector<FlatFace>& faces, bool are_of_A) {
    for (const FlatFace& face : faces) {
      if (separation(pair, are_of_A ? face.normal : (-face.normal).eval()) < -0.5 * tolerance) continue;
      std::vector<ContactPoint> contacts = contacts_along(pair, face, are_of_A, distance);
      const double rate = slowest(contacts, velocity_O);
      if (!(rate > best)) continue;
      best = rate;
      result = std::move(contacts);
    }
  };
  const double reach = tolerance + 1e-6 * std::max(shape_A.size(), shape_B.size());
  try_faces(shape_A.faces_near(distance.p_WA, reach), true);
  try_faces(shape_B.faces_near(distance.p_WB, reach), false);
  if (!result) return {};
  for (ContactPoint& contact : *result) {
    contact.p_WA += origin;
    contact.p_WB += origin;
  }
  return result;
}

}  // namespace rigor
