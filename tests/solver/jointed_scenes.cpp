#include "solver/jointed_scenes.hpp"

#include "rigor/math/dense.hpp"

#include <memory>
#include <utility>

namespace rigor::scenes {

ConstraintRows joint_block(const JointOfScene& joint, const Body& body, double sign) {
  const bool is_hinge = joint.axis.norm() > 0;
  ConstraintRows rows = ConstraintRows::Zero(is_hinge ? 5 : 3, 6);
  const Vec3 r = joint.point - body.center;
  Mat3 cross;
  cross << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
  rows.topLeftCorner<3, 3>() = sign * Mat3::Identity();
  rows.topRightCorner<3, 3>() = -sign * cross;
  if (is_hinge)
    rows.bottomRightCorner(2, 3) = sign * axes_of(joint.axis.normalized()).leftCols<2>().transpose();
  return rows;
}

MotionProblem motion_problem_of(const JointedScene& scene) {
  MotionProblem problem;
  const MatX J = contact_jacobian(scene), W = inverse_mass(scene);
  std::vector<int> nodes;
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const Mat6 inverse = W.block<6, 6>(6 * static_cast<Eigen::Index>(k), 6 * static_cast<Eigen::Index>(k));
    problem.rows.inverse_masses.push_back(inverse);
    problem.rows.masses.push_back(inverse.inverse());
    nodes.push_back(static_cast<int>(k));
  }
  for (std::size_t i = 0; i < scene.contacts.size(); ++i) {
    ContactRows::Sides sides;
    sides[0].node = scene.contacts[i].body_A;
    sides[1].node = scene.contacts[i].body_B;
    for (ContactRows::Side& side : sides)
      if (side.node >= 0) side.J = J.block<3, 6>(3 * static_cast<Eigen::Index>(i), 6 * side.node);
    problem.rows.contacts.push_back(sides);
  }
  ConstraintGraph graph;
  graph.node_count = static_cast<int>(scene.bodies.size());
  std::vector<std::vector<ConstraintRows>> blocks;
  for (const JointOfScene& joint : scene.joints) {
    ConstraintGraph::Link link{joint.axis.norm() > 0 ? 5 : 3, {}};
    blocks.emplace_back();
    for (const auto& [body, sign] : {std::pair{joint.body_A, -1.0}, std::pair{joint.body_B, 1.0}}) {
      if (body < 0) continue;
      link.nodes.push_back(body);
      blocks.back().push_back(joint_block(joint, scene.bodies[static_cast<std::size_t>(body)], sign));
    }
    graph.links.push_back(link);
  }
  const auto joints = std::make_shared<ConstrainedMass>(graph);
  joints->factor(problem.rows.masses, blocks_of(blocks));
  constrain_nodes(joints, nodes, problem.rows);
  problem.laws = problem_of(scene);
  problem.laws.A.resize(0, 0);
  const VecX p = with_joints(problem.rows, node_wrenches(problem.rows, free_motion(scene)));
  problem.laws.b = contact_rates(problem.rows, node_accelerations(problem.rows, p));
  return problem;
}

MatX joint_matrix(const JointedScene& scene) {
  MatX G = MatX::Zero(0, 6 * static_cast<Eigen::Index>(scene.bodies.size()));
  for (const JointOfScene& joint : scene.joints) {
    const Eigen::Index first = G.rows(), count = joint.axis.norm() > 0 ? 5 : 3;
    G.conservativeResize(first + count, Eigen::NoChange);
    G.bottomRows(count).setZero();
    for (const auto& [body, sign] : {std::pair{joint.body_A, -1.0}, std::pair{joint.body_B, 1.0}}) {
      if (body >= 0)
        G.block(first, 6 * body, count, 6) =
            joint_block(joint, scene.bodies[static_cast<std::size_t>(body)], sign);
    }
  }
  return G;
}

MatX held_inverse_mass(const JointedScene& scene) {
  const MatX W = inverse_mass(scene);
  const Eigen::LLT<MatX> root(W);
  // With M⁻¹ = C Cᵀ it is C (1 - Q Qᵀ) Cᵀ, Q an orthonormal base of the columns of (G C)ᵀ.
  const MatX C = root.matrixL();
  const Eigen::JacobiSVD<MatX> svd((joint_matrix(scene) * C).transpose(), Eigen::ComputeThinU);
  Eigen::Index rank = 0;
  while (rank < svd.singularValues().size() && svd.singularValues()(rank) > 1e-9 * svd.singularValues()(0))
    ++rank;
  const MatX Q = svd.matrixU().leftCols(rank);
  return C * (MatX::Identity(W.rows(), W.cols()) - Q * Q.transpose()) * C.transpose();
}

CoulombProblem contact_problem_of(const JointedScene& scene) {
  CoulombProblem problem = problem_of(scene);
  const MatX J = contact_jacobian(scene), W = held_inverse_mass(scene);
  const MatX A = J * W * J.transpose();
  problem.A = 0.5 * (A + A.transpose());
  problem.b = J * W * positive_definite_solution(inverse_mass(scene), free_motion(scene));
  return problem;
}

VecX held_motion_with(const JointedScene& scene, const VecX& lambda) {
  const VecX p = positive_definite_solution(inverse_mass(scene), free_motion(scene)) +
                 contact_jacobian(scene).transpose() * lambda;
  return held_inverse_mass(scene) * p;
}

}  // namespace rigor::scenes
