#include "rigor/sim/penalty/joint_tension.hpp"

#include "rigor/core/index.hpp"
#include "rigor/math/dense.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace rigor {

namespace {

/// What the joints of a body hold it with.
struct Held {
  Mat3 K = Mat3::Zero();  ///< Against turning, by forces at their arms [N m].
  double across = 0;      ///< Bound of what tensions of distance joints add to ω² [1/s²].
};

/// Adds what one end of a joint does to its body: the force f at the point p, and of a distance joint the
/// stiffness across it [N/m].
void add_end(const BodyKinetics& body, const Vec3& f_W, const Vec3& p_W, double across, Held& held) {
  const Vec3 r = p_W - body.x;
  held.K += f_W.dot(r) * Mat3::Identity() - 0.5 * (f_W * r.transpose() + r * f_W.transpose());
  // The end moves against the other one: twice the share of each.
  held.across += 2 * across * (body.inverse_mass + r.squaredNorm() * body.inverse_inertia.trace());
}

/// Bound of ω² [1/s²]: the largest eigenvalue of I⁻¹ K, that of Lᵀ K L with I⁻¹ = L Lᵀ, and the rest.
double square_of(const BodyKinetics& body, const Held& held) {
  const Mat3 L = cholesky_factor(body.inverse_inertia);
  return std::max(0.0, symmetric_eigenvalues(Mat3(L.transpose() * held.K * L))[2]) + held.across;
}

}  // namespace

double tension_frequency(const Model& model, const ContactSystem& system, const VecX& joint_lambda) {
  if (!system.joints) return 0;
  std::vector<Held> held(system.bodies.size());
  const std::vector<int>& joints = system.joints->joints();
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const Joint& joint = model.joint(joints[j]);
    if (joint.type == JointType::gear) continue;
    // Where its force acts: at the anchor on B, of a distance joint at both anchors.
    const Vec3 f_W = system.joints->reaction(j, joint_lambda).f_W;
    const auto anchor = [&](int body, const Vec3& p) -> Vec3 {
      return body == world_body ? p : Vec3(system.of(body).pose() * p);
    };
    const Vec3 on_A_W = anchor(joint.body_A, joint.X_AF.p), on_B_W = anchor(joint.body_B, joint.X_BK.p);
    double across = 0;
    const bool is_distance = joint.type == JointType::distance;
    if (const Vec3 d = on_B_W - on_A_W; is_distance && d.norm() > 0)
      across = std::max(0.0, -f_W.dot(d) / d.squaredNorm());
    const auto add = [&](int body, double sign, const Vec3& p_W) {
      if (body == world_body || system.of(body).inverse_mass == 0) return;
      add_end(system.of(body), sign * f_W, p_W, across, held[at(system.local_index(body))]);
    };
    add(joint.body_A, -1, is_distance ? on_A_W : on_B_W);
    add(joint.body_B, 1, on_B_W);
  }
  double square = 0;
  for (std::size_t b = 0; b < held.size(); ++b) {
    if (system.kinetics[b].inverse_mass > 0)
      square = std::max(square, square_of(system.kinetics[b], held[b]));
  }
  return std::sqrt(square);
}

}  // namespace rigor
