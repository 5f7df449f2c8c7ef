#include "rigor/sim/penalty/poses_before.hpp"

#include "rigor/core/index.hpp"

#include <algorithm>
#include <array>

namespace rigor {
namespace {

Pose pose_before(const Model& model, const PosesBefore& before, int body) {
  if (model.body(body).motion != MotionType::dynamic)
    return prescribed_kinetics(model.body(body), before.t).pose();
  const auto place = std::ranges::lower_bound(before.bodies, body);
  return dynamic_kinetics(model.body(body), before.phases[at(place - before.bodies.begin())]).pose();
}

}  // namespace

double most_closed(const Model& model, const PosesBefore& before, const Contact& contact, const Pose& X_WA,
                   const Pose& X_WB) {
  // The displacements of the two witness points with their bodies, and the angles that these turned by.
  const Vec3 &p_WA = contact.point.p_WA, &p_WB = contact.point.p_WB, &n_W = contact.point.n_W;
  const Pose X_A = pose_before(model, before, contact.body_A),
             X_B = pose_before(model, before, contact.body_B);
  const Vec3 moved_A = p_WA - X_A * (X_WA.inverse() * p_WA), moved_B = p_WB - X_B * (X_WB.inverse() * p_WB);
  const double turned = (X_WA.R - X_A.R).norm() + (X_WB.R - X_B.R).norm();

  // Along the normal to first order; to second order the normal turns with the bodies, and points slide over
  // surfaces that bend by no more than a radius of half the thickness does.
  const Vec3 apart = moved_B - moved_A;
  const double closed = std::max(0.0, -n_W.dot(apart));
  const double thickness =
      std::min(model.body(contact.body_A).thickness, model.body(contact.body_B).thickness);
  return closed + turned * (moved_A.norm() + moved_B.norm()) + apart.squaredNorm() / thickness;
}

}  // namespace rigor
