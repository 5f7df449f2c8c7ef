#include "rigor/bulk/state/drag.hpp"

#include <cmath>

namespace rigor {

namespace {

double phi(double z) {
  return z > 0 ? -std::expm1(-z) / z : 1;
}

}  // namespace

MeanAcceleration mean_acceleration(const Body& body, const Environment::DragRates& drag, const Mat3& R_WB,
                                   const Wrench& wrench, double h) {
  MeanAcceleration mean;
  // Drag slows the centre of mass at the rate c / m.
  mean.a = phi(h * drag.linear / body.mass) * wrench.f_W / body.mass;
  // The same along each principal axis, each with its own rate.
  Vec3 alpha_B = R_WB.transpose() * wrench.tau_W;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const double rate = drag.angular / body.moments[k] + drag.angular_damping;
    alpha_B[k] *= phi(h * rate) / body.moments[k];
  }
  mean.alpha = R_WB * alpha_B;
  return mean;
}

}  // namespace rigor
