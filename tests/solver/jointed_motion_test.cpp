#include "random_vectors.hpp"
#include "solver/jointed_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rigor::jointed_motion_test {
namespace {

using scenes::JointedScene;

constexpr double kGravity = 9.81;

JointedScene box_on_points(int count, double mu, const Vec3& gravity, double angle = 0) {
  JointedScene scene;
  static_cast<scenes::Scene&>(scene) = scenes::box_on_plane(count, mu, gravity, angle);
  return scene;
}

/// Boxes of 1 × 0.8 × 0.6 m in a row on the floor, each on 3 × 3 points, with joints between neighbours.
JointedScene train(int count, double mu, bool with_hinges) {
  JointedScene scene;
  const Vec3 size(1.0, 0.8, 0.6);
  for (int i = 0; i < count; ++i) {
    scene.bodies.push_back(
        {1.0, scenes::box_inertia(1.0, size), Vec3(1.2 * i, 0, 0.3), Vec3(0, 0, -kGravity)});
    scenes::add_face(scene, -1, i, Vec3(1.2 * i, 0, 0), Vec2(0.5, 0.4), 3, mu);
    if (i > 0)
      scene.joints.push_back(
          {i - 1, i, Vec3(1.2 * i - 0.6, 0, 0.3), with_hinges ? Vec3(0, 1, 0) : Vec3(0, 0, 0)});
  }
  return scene;
}

/// A random motion, pushed to the floor.
void push(JointedScene& scene, test::Random& random) {
  for (scenes::Body& body : scene.bodies) {
    body.v += 2 * random.vector();
    body.omega = random.vector();
  }
}

/// Accelerations of both spaces to 1e-10 and forces of the contacts, of least norm. Returns how many contacts
/// of the solution are not open; 0 where the spaces have found two different solutions of Coulomb's law (of
/// contacts that slide in different directions the forces of least norm may be missed).
int expect_same_in_both_spaces(const JointedScene& scene) {
  const std::optional<CoulombSolution> motion = solve_in_motion_space(scenes::motion_problem_of(scene));
  EXPECT_TRUE(motion.has_value());
  if (!motion) return 0;
  EXPECT_LE(motion->residual, 1e-12);
  const CoulombSolution contact = solve_coulomb(scenes::contact_problem_of(scene));
  EXPECT_TRUE(contact.converged);
  const CoulombProblem problem = scenes::contact_problem_of(scene);
  EXPECT_LE(coulomb_residual(problem, motion->lambda, problem.A * motion->lambda + problem.b), 1e-12);
  const double least = contact.lambda.norm();
  if (motion->modes != contact.modes || std::abs(motion->lambda.norm() - least) > 1e-9 * least) return 0;
  const double size = 1 + scenes::free_motion(scene).cwiseAbs().maxCoeff();
  const VecX V = scenes::held_motion_with(scene, motion->lambda);
  EXPECT_LE((scenes::held_motion_with(scene, contact.lambda) - V).cwiseAbs().maxCoeff(), 1e-10 * size)
      << contact.method << " and " << motion->method;
  EXPECT_LE((contact.lambda - motion->lambda).norm(), 1e-9 * (1 + motion->lambda.norm()));
  EXPECT_LE((scenes::joint_matrix(scene) * V).cwiseAbs().maxCoeff(), 1e-12 * size);
  return static_cast<int>(std::count_if(motion->modes.begin(), motion->modes.end(),
                                        [](ContactMode mode) { return mode != ContactMode::open; }));
}

TEST(JointedMotion, AHeldBoxOnAHundredPointsIsTheSameInBothSpaces) {
  // A ball joint at the middle of the upper face, or a hinge there that lets the box tip about y alone.
  for (const Vec3& axis : {Vec3(0, 0, 0), Vec3(0, 1, 0)}) {
    for (const double mu : {0.0, 0.3}) {
      JointedScene scene = box_on_points(10, mu, kGravity * Vec3(0.3, 0.1, -1));
      scene.bodies[0].omega = Vec3(0.4, 3, 0.7);
      scene.joints.push_back({-1, 0, Vec3(0.1, 0, 0.6), axis});
      EXPECT_GT(expect_same_in_both_spaces(scene), 0);
    }
  }
}

TEST(JointedMotion, AJointBearsTheLoadThatContactsNeedNotBear) {
  // A box on its four corners whose centre hangs on a ball joint: nothing pushes the floor. The least norm is
  // that of the contact forces alone, so the joint bears it all.
  JointedScene scene = box_on_points(2, 0.5, Vec3(0, 0, -kGravity));
  scene.joints.push_back({-1, 0, Vec3(0, 0, 0.3)});
  const MotionProblem problem = scenes::motion_problem_of(scene);
  const EliminationPlan plan = elimination_plan(problem.rows);
  const VecX forces = MotionModesSystem(problem, plan,
                                        {std::vector<ContactMode>(4, ContactMode::stick),
                                         std::vector<Vec2>(4, Vec2::UnitX())})
                          .least_norm();
  EXPECT_LE(forces.norm(), 1e-13 * kGravity);
}

TEST(JointedMotion, TrainsOfBoxesAreTheSameInBothSpaces) {
  test::Random random(3);
  for (const bool with_hinges : {false, true}) {
    for (const double mu : {0.0, 0.4}) {
      JointedScene scene = train(3, mu, with_hinges);
      EXPECT_EQ(expect_same_in_both_spaces(scene), 27);
      for (scenes::Body& body : scene.bodies) body.omega = random.vector();
      EXPECT_GT(expect_same_in_both_spaces(scene), 0);
    }
  }
}

TEST(JointedMotion, LoopsWithRedundantRowsAreTheSameInBothSpaces) {
  // Three boxes joined to a triangle by hinges of one direction: 15 rows, of which 12 count.
  JointedScene scene = train(2, 0.4, true);
  scene.bodies.push_back(
      {2.0, scenes::box_inertia(2.0, Vec3(1.0, 0.8, 0.6)), Vec3(0.6, 0, 1.2), Vec3(0.5, 0, -kGravity)});
  scene.joints.push_back({0, 2, Vec3(0.2, 0, 0.8), Vec3::UnitY()});
  scene.joints.push_back({1, 2, Vec3(1.0, 0, 0.8), Vec3::UnitY()});
  const MotionProblem problem = scenes::motion_problem_of(scene);
  EXPECT_EQ(problem.rows.joints->row_count(), 15);
  EXPECT_EQ(problem.rows.joints->choice().size(), 3u);
  EXPECT_EQ(for_each_joint_row(problem.rows, [](Eigen::Index, int, const Vec6&) {}), 12);
  EXPECT_EQ(expect_same_in_both_spaces(scene), 18);
}

TEST(JointedMotion, RandomJointedSystemsAreTheSameInBothSpaces) {
  test::Random random(11);
  int touching = 0, solved = 0, same = 0;
  for (int trial = 0; trial < 60; ++trial) {
    JointedScene scene = train(2 + trial % 3, 0.15 + 0.1 * (trial % 5), trial % 2 == 0);
    if (trial % 3 == 0) scene.joints.push_back({-1, 0, Vec3(-0.5, 0.1, 0.3)});
    if (trial % 4 == 0) scene.joints.push_back(scene.joints.front());  // The same joint twice.
    push(scene, random);
    // Slip that turns on redundant contacts is left to contact space.
    if (!solve_in_motion_space(scenes::motion_problem_of(scene))) continue;
    ++solved;
    SCOPED_TRACE("trial " + std::to_string(trial));
    const int touch = expect_same_in_both_spaces(scene);
    touching += touch;
    same += touch > 0 ? 1 : 0;
  }
  EXPECT_GE(same, solved - 4);
  EXPECT_GE(solved, 40);
  EXPECT_GE(touching, 300);
}

TEST(JointedMotion, LongTrainsAreSolvedBySparseFactors) {
  // 30 boxes: 180 velocities and 145 rows of hinges.
  const JointedScene scene = train(30, 0.4, true);
  const std::optional<CoulombSolution> solution = solve_in_motion_space(scenes::motion_problem_of(scene));
  ASSERT_TRUE(solution.has_value());
  // Nothing strains the joints: each box is carried by its nine points alone.
  for (Eigen::Index i = 0; i < 270; ++i) EXPECT_NEAR(solution->lambda(3 * i + 2), kGravity / 9, 1e-9);
  EXPECT_LE(scenes::held_motion_with(scene, solution->lambda).cwiseAbs().maxCoeff(), 1e-10);
}

}  // namespace
}  // namespace rigor::jointed_motion_test
