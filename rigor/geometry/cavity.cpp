#include "rigor/geometry/cavity.hpp"

#include "rigor/geometry/concave_step.hpp"
#include "rigor/geometry/contact_shape.hpp"
#include "rigor/geometry/convex_hull.hpp"
#include "rigor/geometry/separation_bound.hpp"
#include "rigor/geometry/support.hpp"
#include "rigor/geometry/triangle_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {
namespace {

/// Calls f with the index and the place in S of each corner; nothing for shapes that have none.
template <typename Function>
void for_each_corner(const Shape& shape, const Function& f) {
  if (std::holds_alternative<Sphere>(shape)) {
    f(0, Vec3(0, 0, 0));
  } else if (const Capsule* capsule = std::get_if<Capsule>(&shape)) {
    f(0, Vec3(0, 0, -capsule->half_length));
    f(1, Vec3(0, 0, capsule->half_length));
  } else if (const Box* box = std::get_if<Box>(&shape)) {
    for (int i = 0; i < 8; ++i) {
      const Vec3 signs((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
      f(i, Vec3(box->half_extents.cwiseProduct(signs)));
    }
  } else if (const std::vector<Vec3>* vertices =
                 std::holds_alternative<Convex>(shape) ? &std::get<Convex>(shape).hull->vertices
                 : std::holds_alternative<Mesh>(shape) ? &std::get<Mesh>(shape).mesh->vertices
                                                       : nullptr) {
    for (std::size_t i = 0; i < vertices->size(); ++i) f(static_cast<int>(i), (*vertices)[i]);
  }
}

double corner_radius(const Shape& shape) {
  if (const Sphere* sphere = std::get_if<Sphere>(&shape)) return sphere->radius;
  if (const Capsule* capsule = std::get_if<Capsule>(&shape)) return capsule->radius;
  return 0;
}

/// From the wall inwards at a point at r from the centre; a direction of its own at the centre.
Vec3 inward(const Vec3& r) {
  const double distance = r.norm();
  return distance > 0 ? Vec3(-r / distance) : Vec3::UnitZ();
}

}  // namespace

bool has_corner_balls(const Shape& shape) {
  bool has = false;
  for_each_corner(shape, [&](int, const Vec3&) { has = true; });
  return has;
}

DistanceResult cavity_distance(const Cavity& cavity, const Pose& X_WA, const Shape& b, const Pose& X_WB) {
  const Vec3 to_b = X_WB.p - X_WA.p;
  const Vec3 c_B = X_WB.R.transpose() * -to_b;
  const Vec3 farthest = to_b + X_WB.R * farthest_point(b, c_B);
  const double distance = cavity.radius - radius_about(b, c_B);
  const double size = to_b.norm() + radius_about(b, Vec3::Zero()) + cavity.radius;
  const double rounding = 10 * std::numeric_limits<double>::epsilon() * size;
  const Vec3 n_W = inward(farthest);
  const Vec3 p_WB = X_WA.p + farthest;
  return {distance, distance - rounding, distance + rounding, p_WB - distance * n_W, p_WB, n_W};
}

ContactPoint cavity_contact(const Cavity& cavity, const Pose& X_WA, const Vec3& p_W, double radius) {
  const Vec3 r = p_W - X_WA.p;
  const Vec3 n_W = inward(r);
  const Mat3 across = Mat3::Identity() - n_W * n_W.transpose();
  ContactPoint contact;
  contact.gap = cavity.radius - (r.norm() + radius);
  contact.n_W = n_W;
  contact.p_WB = p_W - radius * n_W;
  contact.p_WA = contact.p_WB - contact.gap * n_W;
  contact.feature = 0;
  // The wall's normal turns against its witness point.
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

double safe_step_in_cavity(const MovingShape& cavity, const MovingShape& inside, double t, double t_end,
                           double level) {
  const RigidMotion::Sample A = cavity.motion->sample(t), B = inside.motion->sample(t);
  const Vec3 center = A.X_WB * cavity.X_BS.p;
  const Vec3 v_center = A.velocity_at(center);
  const Pose X_WS = B.X_WB * inside.X_BS;
  const double room = std::get<Cavity>(*cavity.shape).radius - corner_radius(*inside.shape) - level;
  const double of_origins = largest_acceleration(*cavity.motion, t, t_end) +
                            largest_acceleration(*inside.motion, t, t_end) +
                            cavity.motion->max_turn_acceleration() * cavity.X_BS.p.norm();
  double step = t_end - t;
  for_each_corner(*inside.shape, [&](int, const Vec3& corner) {
    const Vec3 p_W = X_WS * corner;
    const Vec3 r = p_W - center, u = B.velocity_at(p_W) - v_center;
    const double a = of_origins + inside.motion->max_turn_acceleration() * (p_W - B.X_WB.p).norm();
    const auto clearance = [&](double tau) { return room - (r + tau * u).norm() - 0.5 * a * tau * tau; };
    step = clearance(0) < 0 ? 0 : safe_step_of_concave(clearance, step);
  });
  return step;
}

}  // namespace rigor
