#include "rigor/bulk/state/held_bodies.hpp"

#include "rigor/dynamics/joint_rows.hpp"
#include "rigor/math/rotation.hpp"

#include <Eigen/Eigenvalues>

#include <cmath>
#include <map>
#include <utility>

namespace rigor {

namespace {

/// Joints leave a body no way if no unit motion (lengths by its radius) has rates whose squares add up to
/// less than this part of the most.
constexpr double least_held = 1e-3;

/// No rigid whole, and that of the world and what stands. A kinematic body is one of its own.
constexpr int moves_freely = -1, world_whole = 0;

int whole_of_its_own(const Model& model, int body) {
  if (body == world_body || model.body(body).motion == MotionType::fixed) return world_whole;
  return model.body(body).motion == MotionType::kinematic ? body + 1 : moves_freely;
}

BodyMotion place_of(const Model& model, int body) {
  if (body == world_body) return {};
  return {model.body(body).p_WB, rotation_matrix(model.body(body).q_WB)};
}

/// Adds Jᵀ J of the rows of a joint for one of its bodies, lengths by its radius.
void add_rows(const Model& model, const Joint& joint, int body, Mat6& sum) {
  const JointRows rows = joint_rows(joint, place_of(model, joint.body_A), place_of(model, joint.body_B));
  const double radius = model.body(body).bounding_radius;
  Vec6 unit = Vec6::Ones();
  if (std::isfinite(radius)) unit.tail<3>() /= radius;
  for (int side = 0; side < rows.side_count; ++side) {
    if (rows.bodies[at(side)] != body) continue;
    for (int k = 0; k < rows.size; ++k) {
      const Vec6 row = rows.J[at(side)].row(k).transpose().cwiseProduct(unit);
      // Rows of rotation and of displacement weigh the same.
      if (row.squaredNorm() > 0) sum += row * row.transpose() / row.squaredNorm();
    }
  }
}

}  // namespace

HeldBodies::HeldBodies(const Model& model) : is_held_(at(model.body_count()), 0) {
  std::vector<int> whole(at(model.body_count()));
  for (int body = 0; body < model.body_count(); ++body) whole[at(body)] = whole_of_its_own(model, body);
  const auto whole_at = [&](int body) { return body == world_body ? world_whole : whole[at(body)]; };
  std::vector<std::vector<int>> joints_of(at(model.body_count()));
  std::vector<int> open;  // Bodies that may be held now.
  for (int j = 0; j < static_cast<int>(model.joints().size()); ++j) {
    const Joint& joint = model.joint(j);
    if (joint.type == JointType::gear) continue;
    for (const auto& [body, other] : {std::pair{joint.body_A, joint.body_B}, {joint.body_B, joint.body_A}}) {
      if (whole_at(body) != moves_freely) continue;
      joints_of[at(body)].push_back(j);
      if (whole_at(other) != moves_freely) open.push_back(body);
    }
  }

  // From what stands or moves as it must over joints, as far as they lead.
  while (!open.empty()) {
    const int body = open.back();
    open.pop_back();
    if (contains(body)) continue;
    std::map<int, Mat6> sums;  // Of each whole to which its joints lead.
    for (const int j : joints_of[at(body)]) {
      const Joint& joint = model.joint(j);
      const int other = whole_at(joint.body_A == body ? joint.body_B : joint.body_A);
      if (other != moves_freely)
        add_rows(model, joint, body, sums.try_emplace(other, Mat6::Zero()).first->second);
    }
    for (const auto& [other, sum] : sums) {
      const Vec6 squares = Eigen::SelfAdjointEigenSolver<Mat6>(sum, Eigen::EigenvaluesOnly).eigenvalues();
      if (squares[0] < least_held * squares[5]) continue;
      whole[at(body)] = other;
      is_held_[at(body)] = 1;
      break;
    }
    if (!contains(body)) continue;
    for (const int j : joints_of[at(body)]) {
      const Joint& joint = model.joint(j);
      const int other = joint.body_A == body ? joint.body_B : joint.body_A;
      if (whole_at(other) == moves_freely) open.push_back(other);
    }
  }
  for (int body = 0; body < model.body_count(); ++body)
    if (contains(body)) held_.push_back(body);
  if (!held_.empty()) strikes_.assign(is_held_.size(), {});
}

void HeldBodies::mark(BulkBodies& bodies) const {
  for (const int body : held_) bodies.inertia[at(body)].is_held = 1;
}

void HeldBodies::unmark(BulkBodies& bodies) const {
  for (const int body : held_) bodies.inertia[at(body)].is_held = 0;
}

void HeldBodies::strike(int body, const Vec3& dv, const Vec3& dw) {
  MotionRow& row = strikes_[at(body)];
  for (int k = 0; k < 3; ++k) {
    row[at(k)] += static_cast<float>(dv[k]);
    row[at(4 + k)] += static_cast<float>(dw[k]);
  }
}

bool HeldBodies::take_strikes(BulkBodies& bodies) {
  bool was_struck = false;
  for (const int body : held_) {
    MotionRow& row = strikes_[at(body)];
    if (row == MotionRow{}) continue;
    MotionRecord& motion = bodies.motion[at(body)];
    for (std::size_t k = 0; k < 3; ++k) {
      motion.v[k] += row[k];
      motion.w[k] += row[4 + k];
    }
    row = {};
    was_struck = true;
  }
  return was_struck;
}

}  // namespace rigor
