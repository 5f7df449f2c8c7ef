#include "rigor/contact/system/contact.hpp"

#include "rigor/geometry/contacts/parting_contacts.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/state.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rigor {

BodyKinetics dynamic_kinetics(const Body& body, const BodyPhase& phase) {
  BodyKinetics result;

  // The pose, and v = P/m.
  result.x = phase.x;
  result.R = rotation_matrix(phase.q);
  result.v = phase.P / body.mass;
  result.inverse_mass = 1 / body.mass;

  // I, I⁻¹ and ω = I⁻¹ L in W, from the principal moments in the frame of the body.
  const bool is_spherical = body.moments.x() == body.moments.y() && body.moments.y() == body.moments.z();
  if (is_spherical) {
    // The same in every frame: no rounding from R.
    result.inertia = body.moments.x() * Mat3::Identity();
    result.inverse_inertia = 1 / body.moments.x() * Mat3::Identity();
    result.w = phase.L / body.moments.x();
  } else {
    result.inertia = result.R * body.moments.asDiagonal() * result.R.transpose();
    result.inverse_inertia = result.R * body.moments.cwiseInverse().asDiagonal() * result.R.transpose();
    result.w = result.R * (result.R.transpose() * phase.L).cwiseQuotient(body.moments);
  }
  return result;
}

BodyKinetics prescribed_kinetics(const Body& body, double t) {
  const PrescribedMotion motion = prescribed_motion(body, t);
  BodyKinetics result;
  result.x = motion.p_WB;
  result.R = rotation_matrix(motion.q_WB);
  result.v = motion.v_WB;
  result.w = motion.w_WB;
  return result;
}

namespace {

/// Whether two shapes' bounding balls come within the tolerance.
bool is_near(const BodyShape& a, const Pose& X_WA, const BodyShape& b, const Pose& X_WB, double tolerance) {
  if (std::isinf(a.radius) || std::isinf(b.radius)) return true;
  const double reach = a.radius + b.radius + tolerance;
  return (X_WB * b.X_BS.p - X_WA * a.X_BS.p).squaredNorm() <= reach * reach;
}

/// Whether two contacts are one to any measurement: where shapes of a body share a corner or an edge, each of
/// them reports it.
bool is_same(const Contact& a, const Contact& b, double tolerance) {
  constexpr double same_direction = 1e-9;
  return a.friction == b.friction && a.restitution == b.restitution &&
         (a.point.p_WA - b.point.p_WA).norm() <= tolerance &&
         (a.point.p_WB - b.point.p_WB).norm() <= tolerance &&
         (a.point.n_W - b.point.n_W).norm() <= same_direction;
}

/// `points_of`: the contact points of two placed shapes.
template <class PointsOf>
// NOLINTNEXTLINE(readability-function-size): two bodies, each with its pose.
std::vector<Contact> contacts_of_shapes(const Model& model, int a, int b, const Pose& X_WA, const Pose& X_WB,
                                        const ContactReach& within, const PointsOf& points_of) {
  const Body& A = model.body(a);
  const Body& B = model.body(b);
  std::vector<Contact> contacts;
  for (std::size_t i = 0; i < A.shapes.size(); ++i) {
    for (std::size_t k = 0; k < B.shapes.size(); ++k) {
      // Shapes that are far apart have no contacts.
      const BodyShape& shape_a = A.shapes[i];
      const BodyShape& shape_b = B.shapes[k];
      if (!is_near(shape_a, X_WA, shape_b, X_WB, within.reach)) continue;

      // The points at which the two shapes touch, with the coefficients of their materials.
      const PairCoefficients pair = model.coefficients(shape_a.material, shape_b.material);
      const std::vector<ContactPoint> points =
          points_of(shape_a.shape, X_WA * shape_a.X_BS, shape_b.shape, X_WB * shape_b.X_BS);
      for (const ContactPoint& point : points) {
        const Contact contact{a,
                              b,
                              static_cast<int>(i),
                              static_cast<int>(k),
                              point,
                              pair.friction,
                              pair.restitution,
                              pair.rolling_friction,
                              pair.torsional_friction,
                              pair.tangential_restitution,
                              pair.sticking_friction()};

        // What another pair of shapes has reported already is left out.
        const bool is_known = std::any_of(contacts.begin(), contacts.end(), [&](const Contact& other) {
          return (other.shape_A != contact.shape_A || other.shape_B != contact.shape_B) &&
                 is_same(other, contact, within.tolerance);
        });
        if (!is_known) contacts.push_back(contact);
      }
    }
  }
  return contacts;
}

}  // namespace

std::vector<Contact> find_contacts(const Model& model, int a, int b, const Pose& X_WA, const Pose& X_WB,
                                   double tolerance) {
  return find_contacts(model, a, b, X_WA, X_WB, ContactReach{tolerance, tolerance});
}

std::vector<Contact> find_contacts(const Model& model, int a, int b, const Pose& X_WA, const Pose& X_WB,
                                   const ContactReach& within) {
  return contacts_of_shapes(model, a, b, X_WA, X_WB, within,
                            [&](const Shape& s, const Pose& X_WS, const Shape& t, const Pose& X_WT) {
                              return contact_set(s, X_WS, t, X_WT, within);
                            });
}

std::vector<Contact> find_contacts(const Model& model, int a, int b, const BodyKinetics& A,
                                   const BodyKinetics& B, double tolerance) {
  const auto velocity = [&](const Vec3& p_W) -> Vec3 { return B.velocity_at(p_W) - A.velocity_at(p_W); };
  const auto points_of = [&](const Shape& s, const Pose& X_WS, const Shape& t, const Pose& X_WT) {
    std::vector<ContactPoint> points = contact_set(s, X_WS, t, X_WT, tolerance);
    return parting_contacts(s, X_WS, t, X_WT, tolerance, points, velocity).value_or(std::move(points));
  };
  return contacts_of_shapes(model, a, b, A.pose(), B.pose(), {tolerance, tolerance}, points_of);
}

}  // namespace rigor
