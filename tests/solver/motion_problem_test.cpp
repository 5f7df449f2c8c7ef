#include "rigor/solver/motion/motion_problem.hpp"

#include "solver/contact_scenes.hpp"
#include "solver/reference_data.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace rigor::motion_problem_test {
namespace {

using scenes::Scene;

constexpr double kGravity = 9.81;

/// The scene's contacts as rows on its bodies.
MotionProblem motion_problem_of(const Scene& scene) {
  MotionProblem problem;
  const MatX J = scenes::contact_jacobian(scene), W = scenes::inverse_mass(scene);
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const Mat6 inverse = W.block<6, 6>(6 * static_cast<Eigen::Index>(k), 6 * static_cast<Eigen::Index>(k));
    problem.rows.inverse_masses.push_back(inverse);
    problem.rows.masses.push_back(inverse.inverse());
  }
  for (std::size_t i = 0; i < scene.contacts.size(); ++i) {
    ContactRows::Sides sides;
    sides[0].node = scene.contacts[i].body_A;
    sides[1].node = scene.contacts[i].body_B;
    for (ContactRows::Side& side : sides)
      if (side.node >= 0) side.J = J.block<3, 6>(3 * static_cast<Eigen::Index>(i), 6 * side.node);
    problem.rows.contacts.push_back(sides);
  }
  problem.laws = scenes::problem_of(scene);
  problem.laws.A.resize(0, 0);
  return problem;
}

/// Motion space and contact space by each method agree in motion to 1e-10 and in forces, all of least norm.
/// (Where contacts slide in different directions the forces of least norm may be missed, by motion space by
/// no more than 1e-7 of their norm; then the two are different solutions.)
void expect_same(const Scene& scene, const char* what) {
  const MotionProblem in_motion = motion_problem_of(scene);
  const CoulombProblem in_contacts = scenes::problem_of(scene);
  const std::optional<CoulombSolution> motion = solve_in_motion_space(in_motion);
  ASSERT_TRUE(motion.has_value()) << what;
  EXPECT_LE(motion->residual, 1e-12) << what;
  const VecX V = scenes::motion_with(scene, motion->lambda);
  const double size = 1 + scenes::free_motion(scene).cwiseAbs().maxCoeff();
  for (const std::optional<LcpName> lcp :
       {std::optional<LcpName>(), std::optional(LcpName::dantzig), std::optional(LcpName::lemke)}) {
    CoulombOptions options;
    options.lcp = lcp;
    const CoulombSolution contact = solve_coulomb(in_contacts, options);
    ASSERT_TRUE(contact.converged) << what;
    ASSERT_LE(motion->lambda.norm(), (1 + 1e-7) * contact.lambda.norm()) << what;
    // A miss of δ lengthens λ by δ² / 2 only: the roundings of the norms decide.
    if (std::abs(contact.lambda.norm() / motion->lambda.norm() - 1) > 1e-13) continue;
    EXPECT_LE((scenes::motion_with(scene, contact.lambda) - V).cwiseAbs().maxCoeff(), 1e-10 * size)
        << what << ", " << contact.method;
    EXPECT_LE((contact.lambda - motion->lambda).norm(), 1e-9 * (1 + motion->lambda.norm()))
        << what << ", " << contact.method;
  }
}

TEST(MotionSpace, GivesTheReferenceAccelerationsOfRestingContact) {
  const nlohmann::json& file = reference::read("lcp.json");
  for (const nlohmann::json& json : file["cases"]) {
    SCOPED_TRACE(json["name"].get<std::string>());
    const VecX masses = reference::vector(json["M"]), a0 = reference::vector(json["a0"]);
    const MatX J = reference::matrix(json["J"]);
    ASSERT_LE(masses.size(), 6);
    // One node; the velocities that the case lacks are touched by no contact.
    MotionProblem problem;
    Vec6 diagonal = Vec6::Ones();
    diagonal.head(masses.size()) = masses;
    problem.rows.masses.push_back(diagonal.asDiagonal());
    problem.rows.inverse_masses.push_back(diagonal.cwiseInverse().asDiagonal());
    problem.laws.b = VecX::Zero(3 * J.rows());
    const VecX b = J * a0 - reference::vector(json["c"]);
    for (Eigen::Index i = 0; i < J.rows(); ++i) {
      ContactRows::Sides sides;
      sides[0].node = 0;
      sides[0].J.row(2).head(masses.size()) = J.row(i);
      problem.rows.contacts.push_back(sides);
      problem.laws.b(3 * i + 2) = b(i);
    }
    const std::size_t count = problem.rows.contacts.size();
    problem.laws.mu.assign(count, 0.0);
    problem.laws.rows.assign(count, FrictionRow::cone);
    problem.laws.slips.assign(count, Vec2::UnitX());
    const std::optional<CoulombSolution> solution = solve_in_motion_space(problem);
    ASSERT_TRUE(solution.has_value());
    const VecX pushed = node_accelerations(problem.rows, contact_wrenches(problem.rows, solution->lambda))
                            .head(masses.size());
    const VecX expected = reference::vector(json["acceleration"]);
    const double size = a0.cwiseAbs().maxCoeff() + expected.cwiseAbs().maxCoeff();
    EXPECT_LE((a0 + pushed - expected).cwiseAbs().maxCoeff(), 1e-12 * size);
    if (!json["lambda_unique"].get<bool>()) continue;
    const VecX lambda = reference::vector(json["lambda"]);
    for (Eigen::Index i = 0; i < J.rows(); ++i)
      EXPECT_NEAR(solution->lambda(3 * i + 2), lambda(i), 1e-12 * lambda.cwiseAbs().maxCoeff());
  }
}

TEST(MotionSpace, ABoxOnAHundredPointsIsTheSameInBothSpaces) {
  const double slope = 0.3;
  for (const double mu : {0.0, 0.1, 0.29, 0.33, 1.0}) {
    const Vec3 gravity = kGravity * Vec3(std::sin(slope) * 0.8, std::sin(slope) * 0.6, -std::cos(slope));
    const Scene scene = scenes::box_on_plane(10, mu, gravity);
    ASSERT_EQ(scene.contacts.size(), 100u);
    expect_same(scene, "box on a slope");
    const CoulombSolution solution = *solve_in_motion_space(motion_problem_of(scene));
    const VecX V = scenes::motion_with(scene, solution.lambda);
    const double fall = mu > std::tan(slope) ? 0 : kGravity * (std::sin(slope) - mu * std::cos(slope));
    EXPECT_LE((V.head<3>() - fall * Vec3(0.8, 0.6, 0)).norm(), 1e-11) << mu;
    EXPECT_LE(V.tail<3>().norm(), 1e-10) << mu;
  }
}

TEST(MotionSpace, ABoxThatTipsOverLetsGoOfTheSamePoints) {
  Scene scene = scenes::box_on_plane(10, 2.0, kGravity * Vec3(0.9, 0, -std::sqrt(1 - 0.81)));
  expect_same(scene, "box on a steep slope");
  scene = scenes::box_on_plane(10, 0.5, kGravity * Vec3(0, 0, -1));
  scene.bodies[0].omega = Vec3(0, -60, 0);
  expect_same(scene, "box with a torque");
}

TEST(MotionSpace, FourLegsOfATableCarryItsWeightWithLeastForces) {
  Scene scene = scenes::box_on_plane(2, 0.4, Vec3(0, 0, -kGravity));
  // A weight off the middle: angular acceleration that the legs must hold back.
  scene.bodies[0].omega = Vec3(1.5, 2.0, 0);
  expect_same(scene, "table");
  const CoulombSolution solution = *solve_in_motion_space(motion_problem_of(scene));
  double sum = 0, twist = 0;
  for (Eigen::Index i = 0; i < 4; ++i) {
    sum += solution.lambda(3 * i + 2);
    // Legs 0 and 3 are on one diagonal: the forces that balance among themselves are not there.
    twist += (i == 0 || i == 3 ? 1 : -1) * solution.lambda(3 * i + 2);
  }
  EXPECT_NEAR(sum, kGravity, 1e-11);
  EXPECT_NEAR(twist, 0, 1e-11);
}

TEST(MotionSpace, StacksAreTheSameInBothSpaces) {
  expect_same(scenes::stack(std::vector<double>(10, 1.0), 0.5), "stack");
  expect_same(scenes::stack({1, 1, 1, 1, 100}, 0.5), "heavy on top");
  expect_same(scenes::stack({1000, 1, 1000, 1}, 0.5), "unlike masses");
}

/// Of the contacts that begin to slide: the direction of a slow one is known badly by any method.
double slowest_slip(const CoulombSolution& solution) {
  double slowest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < solution.modes.size(); ++i)
    if (solution.modes[i] == ContactMode::slide)
      slowest = std::min(slowest, solution.w.segment<2>(3 * static_cast<Eigen::Index>(i)).norm());
  return slowest;
}

TEST(MotionSpace, RandomRestingProblemsAreTheSameInBothSpaces) {
  std::mt19937_64 generator(23);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int solved = 0;
  for (int trial = 0; trial < 200; ++trial) {
    Scene scene = scenes::box_on_plane(2, 0.2 + 0.1 * uniform(generator), kGravity * Vec3(0, 0, -1),
                                       uniform(generator));
    const Vec3 size(0.4, 0.3, 0.2);
    scene.bodies.push_back({0.5, scenes::box_inertia(0.5, size), Vec3(0.1, 0, 0.7), Vec3(0, 0, -kGravity)});
    scenes::add_face(scene, 0, 1, Vec3(0.1, 0, 0.6), Vec2(0.2, 0.15), 2, 0.25, uniform(generator));
    for (scenes::Body& body : scene.bodies) {
      body.v += 2 * Vec3(uniform(generator), uniform(generator), 0.3 * uniform(generator));
      body.omega = Vec3(uniform(generator), uniform(generator), uniform(generator));
    }
    // Boxes that spin while they slide share their load as the least forces say; those are for contact space.
    const std::optional<CoulombSolution> motion = solve_in_motion_space(motion_problem_of(scene));
    if (!motion || slowest_slip(*motion) < 1e-2) continue;
    ++solved;
    expect_same(scene, ("random " + std::to_string(trial)).c_str());
  }
  EXPECT_GE(solved, 120);
}

TEST(MotionSpace, StartsFromTheModesOfBefore) {
  const Scene scene = scenes::box_on_plane(3, 2.0, kGravity * Vec3(0.9, 0, -std::sqrt(1 - 0.81)));
  const MotionProblem problem = motion_problem_of(scene);
  const CoulombSolution first = *solve_in_motion_space(problem);
  const CoulombSolution again = *solve_in_motion_space(problem, first.modes);
  EXPECT_EQ(again.modes, first.modes);
  EXPECT_EQ(again.method, "motion");
  EXPECT_LE((again.lambda - first.lambda).norm(), 1e-12 * first.lambda.norm());
}

TEST(MotionSpace, NumbersThatAreNoneAreLeftToContactSpace) {
  MotionProblem problem = motion_problem_of(scenes::box_on_plane(2, 0.4, Vec3(0, 0, -kGravity)));
  problem.laws.b(0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(solve_in_motion_space(problem).has_value());
}

// ---- Contact space by name.

TEST(LcpSeed, EachMethodSolvesStacksAndSlopesByItself) {
  for (const LcpName name : {LcpName::dantzig, LcpName::lemke}) {
    CoulombOptions options;
    options.lcp = name;
    const CoulombSolution stack =
        solve_coulomb(scenes::problem_of(scenes::stack({1, 2, 3, 4}, 0.5)), options);
    EXPECT_EQ(stack.method, name == LcpName::dantzig ? "dantzig" : "lemke");
    EXPECT_TRUE(stack.converged);
    const double slope = 0.2;
    const Vec3 gravity = kGravity * Vec3(std::sin(slope), 0, -std::cos(slope));
    const CoulombSolution slides =
        solve_coulomb(scenes::problem_of(scenes::box_on_plane(3, 0.1, gravity)), options);
    EXPECT_TRUE(slides.converged);
    EXPECT_GT(slides.iterations, 0);
  }
}

}  // namespace
}  // namespace rigor::motion_problem_test
