#include "rigor/geometry/contacts/cavity_contacts.hpp"

#include "rigor/geometry/contacts/contact_shape.hpp"
#include "rigor/geometry/distance/cavity_distance.hpp"
#include "rigor/geometry/shape/corner_balls.hpp"

namespace rigor {

ContactPoint cavity_contact(const Cavity& cavity, const Pose& X_WA, const Vec3& p_W, double radius) {
  const Vec3 r = p_W - X_WA.p;
  const Vec3 n_W = inward_normal(r);
  const Mat3 across = Mat3::Identity() - n_W * n_W.transpose();
  ContactPoint contact;
  contact.gap = cavity.radius - (r.norm() + radius);
  contact.n_W = n_W;
  contact.p_WB = p_W - radius * n_W;
  contact.p_WA = contact.p_WB - contact.gap * n_W;
  contact.feature = 0;
  // The wall's normal rotates against the motion of its witness point.
  contact.curvature_A.radius_W = -cavity.radius * across;
  contact.curvature_B.radius_W = radius * across;
  return contact;
}

std::vector<ContactPoint> cavity_contacts(const Cavity& cavity, const Pose& X_WA, const Shape& b,
                                          const Pose& X_WB, double tolerance) {
  std::vector<ContactPoint> contacts;
  const double radius = corner_radius(b);
  for_each_corner(b, [&](int i, const Vec3& corner) {
    ContactPoint contact = cavity_contact(cavity, X_WA, X_WB * corner, radius);
    if (contact.gap > tolerance) return;
    contact.feature = feature_pair({Feature::Kind::side, 0}, {Feature::Kind::vertex, i});
    contacts.push_back(contact);
  });
  return contacts;
}

}  // namespace rigor
