#include "rigor/solver/linear/jointed_matrix.hpp"

#include "random_vectors.hpp"
#include "rigor/core/work_count.hpp"
#include "rigor/solver/linear/joint_ties.hpp"
#include "rigor/solver/linear/node_system.hpp"
#include "solver/jointed_scenes.hpp"

#include <gtest/gtest.h>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace rigor::jointed_matrix_test {
namespace {

using Eigen::Index;
using scenes::JointedScene;

/// Bodies of 1 to 100 kg, each joined to one before it or to the world by a ball joint or a hinge, some of
/// them in loops, with contacts of single points on the floor and between any two.
JointedScene random_tree(int bodies, bool with_loops, test::Random& random) {
  JointedScene scene;
  const auto axis = [&] {
    return random.uniform(-1, 1) < 0 ? Vec3(0, 0, 0) : Vec3(random.vector().normalized());
  };
  for (int i = 0; i < bodies; ++i) {
    const double mass = std::pow(10, random.uniform(0, 2));
    scene.bodies.push_back(
        {mass, scenes::box_inertia(mass, Vec3(1.0, 0.8, 0.6)), 3 * random.vector(), Vec3(0, 0, -9.81)});
    const int before = static_cast<int>(random.uniform(-1, i));
    const bool is_loose = i % 7 == 3;  // A tree of its own, or a body without joints.
    if (!is_loose) scene.joints.push_back({i == 0 ? -1 : before, i, 3 * random.vector(), axis()});
    if (with_loops && i > 1 && i % 2 == 0) scene.joints.push_back({i - 2, i, 3 * random.vector(), axis()});
    if (random.uniform(-1, 1) < 0.5)
      scenes::add_face(scene, -1, i, 3 * random.vector(), Vec2(0.5, 0.4), 2, 0.5);
    if (i > 0 && random.uniform(-1, 1) < 0)
      scenes::add_face(scene, before, i, 3 * random.vector(), Vec2(0.5, 0.4), 2, 0.5);
  }
  return scene;
}

/// x on the base N of the motions with G N = 0: the dense truth.
VecX solution_on_motions(const MatX& K, const MatX& G, const VecX& c) {
  Eigen::FullPivLU<MatX> lu(G);
  lu.setThreshold(1e-9);
  const MatX N = G.rows() > 0 ? MatX(lu.kernel()) : MatX::Identity(K.rows(), K.cols());
  return N * (N.transpose() * K * N).fullPivLu().solve(N.transpose() * c);
}

TEST(JointedMatrix, SolvesOnTheMotionsThatJointsAllow) {
  test::Random random(19);
  int possible = 0, with_loops = 0;
  for (int example = 0; example < 60; ++example) {
    SCOPED_TRACE(example);
    const JointedScene scene = random_tree(2 + example % 9, example % 3 == 0, random);
    const ContactRows rows = scenes::motion_problem_of(scene).rows;
    const EliminationPlan plan = elimination_plan(rows);
    JointedMatrix matrix(rows, plan, example % 2 ? 1.0 : 1e-3);
    possible += matrix.is_possible();
    with_loops += !joint_ties(rows).loop_rows.empty();
    if (!matrix.is_possible()) continue;

    // Stiff contacts, and the matrix in full.
    const Index size = 6 * static_cast<Index>(rows.node_count());
    MatX dense = MatX::Zero(size, size);
    for (Index node = 0; 6 * node < size; ++node)
      dense.block<6, 6>(6 * node, 6 * node) =
          (example % 2 ? 1.0 : 1e-3) * rows.masses[static_cast<std::size_t>(node)];
    std::vector<Mat3> D;
    for (const ContactRows::Sides& sides : rows.contacts) {
      const Vec3 side = random.vector();
      D.push_back(100 * (side * side.transpose() + Mat3::Identity()));
      if (example % 4 == 0) D.back()(0, 2) += 30;
      for (const ContactRows::Side& left : sides)
        for (const ContactRows::Side& right : sides)
          if (left.node >= 0 && right.node >= 0)
            dense.block<6, 6>(6 * left.node, 6 * right.node) += left.J.transpose() * D.back() * right.J;
    }

    ASSERT_TRUE(matrix.factor(D, example % 4 != 0));
    const VecX c = VecX::NullaryExpr(size, [&] { return random.uniform(-1, 1); });
    const VecX x = matrix.solve(c), truth = solution_on_motions(dense, scenes::joint_matrix(scene), c);
    EXPECT_LE((x - truth).cwiseAbs().maxCoeff(), 1e-8 * truth.cwiseAbs().maxCoeff());
    EXPECT_LE((scenes::joint_matrix(scene) * x).cwiseAbs().maxCoeff(), 1e-9 * x.cwiseAbs().maxCoeff());
  }
  EXPECT_GE(possible, 55);
  EXPECT_GE(with_loops, 10);
}

TEST(JointedMatrix, CountsWorkInProportionToTheLinksOfAChain) {
  const auto work_of = [](int links) {
    JointedScene scene;
    for (int i = 0; i < links; ++i) {
      scene.bodies.push_back(
          {1, scenes::box_inertia(1, Vec3(1.0, 0.8, 0.6)), Vec3(i, 0, 0), Vec3(0, 0, -9.81)});
      if (i > 0) scene.joints.push_back({i - 1, i, Vec3(i - 0.5, 0, 0), Vec3(0, 0, 0)});
      scenes::add_face(scene, -1, i, Vec3(i, 0, -0.4), Vec2(0.5, 0.4), 2, 0.5);
    }
    const ContactRows rows = scenes::motion_problem_of(scene).rows;
    const std::uint64_t before = work_counted();
    const EliminationPlan plan = elimination_plan(rows);
    JointedMatrix matrix(rows, plan, 1);
    EXPECT_TRUE(matrix.factor(std::vector<Mat3>(rows.contacts.size(), Mat3::Identity()), true));
    return static_cast<double>(work_counted() - before);
  };
  // At least the factors of each link.
  EXPECT_GE(work_of(10), 10);
  EXPECT_GE(work_of(80), 6 * work_of(10));
  EXPECT_LE(work_of(80), 10 * work_of(10));
}

/// The diagonal of J (M⁻¹ - M⁻¹ Gᵀ (G M⁻¹ Gᵀ)⁺ G M⁻¹) Jᵀ, from responses along the trees.
TEST(JointedMatrix, DiagonalOfContactsIsThatOfTheFullMatrix) {
  test::Random random(23);
  for (int example = 0; example < 40; ++example) {
    SCOPED_TRACE(example);
    const JointedScene scene = random_tree(2 + example % 9, example % 4 == 0, random);
    const VecX diagonal = contact_diagonal(scenes::motion_problem_of(scene).rows);
    const MatX A = scenes::contact_problem_of(scene).A;
    if (diagonal.size() == 0) continue;
    EXPECT_LE((diagonal - A.diagonal()).cwiseAbs().maxCoeff(), 1e-10 * A.diagonal().maxCoeff());
  }
}

/// Of the ties of a node at most one is left when it is eliminated; a chain has no more neighbours than that.
TEST(JointedMatrix, TreesAreEliminatedFromTheirLeaves) {
  constexpr int count = 40;
  std::vector<JointTies::Tie> ties;
  std::vector<std::pair<int, int>> pairs;
  for (int k = 1; k < count; ++k) {
    ties.push_back({{k - 1, k}, {}, 0});
    pairs.emplace_back(k - 1, k);
  }
  ties.push_back({{17}, {}, 0});  // To the ground.
  const std::vector<int> places = places_of_tied_nodes(count, pairs, ties);
  EXPECT_EQ(places[17], count - 1);
  for (int node = 0; node < count; ++node) {
    int left = node == 17;
    for (const int other : {node - 1, node + 1})
      left += other >= 0 && other < count &&
              places[static_cast<std::size_t>(other)] > places[static_cast<std::size_t>(node)];
    EXPECT_EQ(left, 1) << node;
  }
  EXPECT_EQ(EliminationPattern(places, pairs).pair_count(), count - 1u);
}

}  // namespace
}  // namespace rigor::jointed_matrix_test
