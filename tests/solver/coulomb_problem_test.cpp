#include "rigor/solver/coulomb/coulomb_problem.hpp"

#include "solver/contact_scenes.hpp"
#include "solver/reference_data.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

namespace rigor::coulomb_problem_test {
namespace {

using scenes::Scene;

constexpr double kGravity = 9.81;
constexpr double kDegree = std::numbers::pi / 180;

// Gravity seen from a plane inclined by `slope`, with the fall line at `heading` from the x axis.
Vec3 gravity_on_incline(double slope, double heading) {
  return kGravity *
         Vec3(std::sin(slope) * std::cos(heading), std::sin(slope) * std::sin(heading), -std::cos(slope));
}

Vec3 force_sum(const Scene& scene, const VecX& lambda) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < scene.contacts.size(); ++i)
    sum += scene.contacts[i].axes * lambda.segment<3>(3 * static_cast<Eigen::Index>(i));
  return sum;
}

int count(const CoulombSolution& solution, ContactMode mode) {
  return static_cast<int>(std::count(solution.modes.begin(), solution.modes.end(), mode));
}

// ---- One body on a plane.

TEST(CoulombProblem, ABoxAtRestOnFourPointsGetsFourEqualForces) {
  const CoulombProblem problem = scenes::problem_of(scenes::box_on_plane(2, 0.5, {0, 0, -kGravity}));
  const CoulombSolution s = solve_coulomb(problem);
  ASSERT_TRUE(s.converged);
  EXPECT_LE(s.w.cwiseAbs().maxCoeff(), 1e-14 * kGravity);
  for (int i = 0; i < 4; ++i)
    EXPECT_LT((s.lambda.segment<3>(3 * i) - Vec3(0, 0, kGravity / 4)).norm(), 1e-14 * kGravity);
  EXPECT_EQ(count(s, ContactMode::stick), 4);
}

TEST(CoulombProblem, ABoxBelowTheFrictionAngleStaysExactly) {
  for (const int points : {2, 3, 10})
    for (const double slope : {5.0, 15.0, 26.0, 26.5}) {  // atan 0.5 = 26.565 degrees
      const CoulombSolution s = solve_coulomb(
          scenes::problem_of(scenes::box_on_plane(points, 0.5, gravity_on_incline(slope * kDegree, 0.4))));
      ASSERT_TRUE(s.converged) << points << " " << slope;
      EXPECT_LE(s.w.cwiseAbs().maxCoeff(), 1e-13 * kGravity);
      EXPECT_EQ(count(s, ContactMode::stick), points * points);
    }
}

TEST(CoulombProblem, ABoxAboveTheFrictionAngleSlidesDownTheFallLine) {
  // a = g (sin α - μ cos α) along the fall line, whatever the heading and the turn of the contact frames.
  const double mu = 0.5;
  for (const int points : {2, 3, 10})
    for (const double heading : {0.0, 30 * kDegree, 77 * kDegree}) {
      const double slope = 30 * kDegree;
      const Scene scene = scenes::box_on_plane(points, mu, gravity_on_incline(slope, heading), 0.3);
      const CoulombSolution s = solve_coulomb(scenes::problem_of(scene));
      ASSERT_TRUE(s.converged);
      EXPECT_EQ(count(s, ContactMode::slide), points * points);
      const double a = kGravity * (std::sin(slope) - mu * std::cos(slope));
      const VecX motion = scenes::motion_with(scene, s.lambda);
      VecX expected = VecX::Zero(6);
      expected.head<2>() << a * std::cos(heading), a * std::sin(heading);
      EXPECT_LT((motion - expected).norm(), 2e-13 * kGravity) << points << " " << heading;
    }
}

TEST(CoulombProblem, ABoxBeyondItsBaseTips) {
  // With the weight outside the base (half length 0.5, height 0.3: slopes above atan(0.5 / 0.3) = 59 degrees)
  // and much friction it turns about the two lower points: (I + m r²) α = m g (0.3 sin - 0.5 cos).
  const double slope = 70 * kDegree;
  for (const double mu : {3.0, 1e6}) {
    const Scene scene = scenes::box_on_plane(2, mu, gravity_on_incline(slope, 0));
    const CoulombSolution s = solve_coulomb(scenes::problem_of(scene));
    ASSERT_TRUE(s.converged);
    EXPECT_EQ(count(s, ContactMode::open), 2);
    EXPECT_EQ(count(s, ContactMode::stick), 2);
    const double inertia = (1.0 + 0.36) / 12 + 0.25 + 0.09;
    const double alpha = kGravity * (0.3 * std::sin(slope) - 0.5 * std::cos(slope)) / inertia;
    EXPECT_NEAR(scenes::motion_with(scene, s.lambda)(4), alpha, 1e-13 * kGravity);
  }
}

TEST(CoulombProblem, ASphereRollsOnTwoSeventhsOfTheWeight) {
  const double slope = 25 * kDegree, m = 3.0, r = 0.2;
  Scene scene;
  scene.bodies.push_back(
      {m, 0.4 * m * r * r * Mat3::Identity(), Vec3(0, 0, r), gravity_on_incline(slope, 0.7)});
  scene.contacts.push_back({-1, 0, Vec3::Zero(), scenes::axes_of(Vec3::UnitZ(), 0.2), 0.5});
  const CoulombSolution s = solve_coulomb(scenes::problem_of(scene));
  ASSERT_TRUE(s.converged);
  EXPECT_EQ(s.modes[0], ContactMode::stick);
  EXPECT_NEAR(s.lambda.head<2>().norm(), 2.0 / 7.0 * m * kGravity * std::sin(slope), 1e-13 * m * kGravity);
  EXPECT_NEAR(scenes::motion_with(scene, s.lambda).head<2>().norm(), 5.0 / 7.0 * kGravity * std::sin(slope),
              1e-13 * kGravity);
}

TEST(CoulombProblem, AFrictionlessBoxSlidesFreely) {
  const Scene scene = scenes::box_on_plane(10, 0.0, gravity_on_incline(20 * kDegree, 0.3));
  const CoulombSolution s = solve_coulomb(scenes::problem_of(scene));
  ASSERT_TRUE(s.converged);
  EXPECT_LE(s.residual, 1e-13);
  const VecX motion = scenes::motion_with(scene, s.lambda);
  EXPECT_NEAR(motion.head<2>().norm(), kGravity * std::sin(20 * kDegree), 1e-13 * kGravity);
  EXPECT_LT(motion.tail<4>().norm(), 1e-12 * kGravity);
  for (int i = 0; i < 100; ++i) EXPECT_NEAR(s.lambda(3 * i + 2), s.lambda(2), 1e-13 * kGravity);
}

// ---- Stacks: interface k carries the weight above it.

void expect_standing(const std::vector<double>& masses, double mu) {
  const Scene scene = scenes::stack(masses, mu);
  const CoulombSolution s = solve_coulomb(scenes::problem_of(scene));
  ASSERT_TRUE(s.converged);
  double total = std::accumulate(masses.begin(), masses.end(), 0.0);
  // Round-off of w is that of the largest force on the smallest mass.
  const double lightest = *std::min_element(masses.begin(), masses.end());
  EXPECT_LE(s.w.cwiseAbs().maxCoeff(), 1e-14 * kGravity * total / lightest);
  // Forces know as many digits as the condition of A leaves: about the ratio of the masses times the layers
  // squared.
  const double heaviest = *std::max_element(masses.begin(), masses.end());
  const double layers = static_cast<double>(masses.size());
  const double slack = 1e-15 * total * kGravity * (heaviest / lightest) * layers * layers;
  for (std::size_t i = 0; i < masses.size(); ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      const Vec3 force = s.lambda.segment<3>(3 * static_cast<Eigen::Index>(4 * i + k));
      EXPECT_LT((force - Vec3(0, 0, total * kGravity / 4)).norm(), slack) << i;
    }
    total -= masses[i];
  }
}

TEST(CoulombProblem, StacksStand) {
  expect_standing(std::vector<double>(5, 1.0), 0.5);
  expect_standing(std::vector<double>(10, 1.0), 0.5);
  expect_standing(std::vector<double>(10, 1.0), 0.0);
  expect_standing(std::vector<double>(5, 1.0), 1e6);
}

TEST(CoulombProblem, StacksOfUnlikeMassesStand) {
  expect_standing({1, 1000}, 0.5);
  expect_standing({1000, 1}, 0.5);
  expect_standing({1, 1000, 1, 1000, 1, 1000}, 0.3);
  expect_standing({1, 1, 1, 1, 1000}, 0.0);
}

TEST(CoulombProblem, AStackOnASlopeStandsUntilItsWeightLeavesTheBase) {
  Scene scene = scenes::stack(std::vector<double>(6, 1.0), 0.5);
  for (scenes::Body& body : scene.bodies) body.v = gravity_on_incline(std::atan(0.15), 0.2);  // 6 · 0.15 < 1
  const CoulombSolution stands = solve_coulomb(scenes::problem_of(scene));
  ASSERT_TRUE(stands.converged);
  EXPECT_LE(stands.w.cwiseAbs().maxCoeff(), 1e-13 * kGravity);
  for (scenes::Body& body : scene.bodies)
    body.v = gravity_on_incline(std::atan(0.2), 0.2);  // 6 · 0.2 · cos 0.2 > 1
  const CoulombSolution falls = solve_coulomb(scenes::problem_of(scene));
  ASSERT_TRUE(falls.converged);
  EXPECT_GE(falls.w.cwiseAbs().maxCoeff(), 1e-3 * kGravity);
}

TEST(CoulombProblem, ALowBoxPushedFromUnderAStackIsSolved) {
  Scene scene = scenes::stack(std::vector<double>(10, 1.0), 0.5);
  scene.bodies[0].v = Vec3(300, 3, -kGravity);
  const CoulombSolution s = solve_coulomb(scenes::problem_of(scene));
  EXPECT_TRUE(s.converged) << s.residual;
  EXPECT_GT(count(s, ContactMode::slide), 3);
}

// ---- Slide rows.

TEST(CoulombProblem, AKnownSlipGetsItsKineticFriction) {
  // Sliding uphill along `slip`: a = g - friction, |friction| = μ m g cos α against the slip; no tilt with 9
  // points.
  const double slope = 20 * kDegree, mu = 0.3;
  const Scene scene = scenes::box_on_plane(3, mu, gravity_on_incline(slope, 0));
  CoulombProblem problem = scenes::problem_of(scene);
  const Vec2 slip(std::cos(2.0), std::sin(2.0));
  problem.rows.assign(9, FrictionRow::slide);
  problem.slips.assign(9, slip);
  const CoulombSolution s = solve_coulomb(problem);
  ASSERT_TRUE(s.converged);
  EXPECT_EQ(count(s, ContactMode::slide), 9);
  Vec3 expected = gravity_on_incline(slope, 0);
  expected.head<2>() -= mu * kGravity * std::cos(slope) * slip;
  expected.z() = 0;
  EXPECT_LT((scenes::motion_with(scene, s.lambda).head<3>() - expected).norm(), 1e-13 * kGravity);
}

TEST(CoulombProblem, SlidingAndStickingRowsMix) {
  // Five boxes of equal mass; the lowest slides on the ground with known slip along x, the others ride on it:
  // all have the acceleration -μ g.
  Scene scene = scenes::stack(std::vector<double>(5, 1.0), 0.6);
  for (int i = 0; i < 4; ++i) scene.contacts[static_cast<std::size_t>(i)].mu = 0.1;
  CoulombProblem problem = scenes::problem_of(scene);
  for (std::size_t i = 0; i < 4; ++i) problem.rows[i] = FrictionRow::slide;
  const CoulombSolution s = solve_coulomb(problem);
  ASSERT_TRUE(s.converged);
  const VecX motion = scenes::motion_with(scene, s.lambda);
  for (int i = 0; i < 5; ++i) {
    VecX expected = VecX::Zero(6);
    expected(0) = -0.1 * kGravity;
    EXPECT_LT((motion.segment<6>(6 * i) - expected).norm(), 1e-12 * kGravity);
  }
}

// A thin rod at 45 degrees on a plane: A_nn = 1 + 3 cos², A_nt = ±3 sin cos; the paradox starts at μ = 5/3.
CoulombProblem painleve_rod(double mu, double normal_acceleration) {
  CoulombProblem problem;
  problem.A = Mat3(Vec3(2.5, 1.0, 2.5).asDiagonal());
  problem.A(0, 2) = problem.A(2, 0) = 1.5;
  problem.b = Vec3(0.3, 0, normal_acceleration);
  problem.mu = {mu};
  problem.rows = {FrictionRow::slide};
  problem.slips = {Vec2(1, 0)};
  return problem;
}

TEST(CoulombProblem, PainlevesParadoxIsReportedNotHidden) {
  EXPECT_TRUE(solve_coulomb(painleve_rod(1.0, -1)).converged);
  const CoulombSolution none = solve_coulomb(painleve_rod(2.0, -1));  // no solution
  EXPECT_FALSE(none.converged);
  EXPECT_GT(none.residual, 0.1);
  EXPECT_TRUE(solve_coulomb(painleve_rod(2.0, 1)).converged);  // λ = 0 is one of two
}

// ---- What holds for every problem.

Scene random_pile(std::mt19937_64& generator, double largest_mu) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto draw = [&] { return uniform(generator); };
  const auto vector = [&] { return Vec3(draw(), draw(), draw()); };
  Scene scene;
  const int bodies = 1 + static_cast<int>(generator() % 7);
  for (int i = 0; i < bodies; ++i) {
    const double m = std::pow(10.0, 1.5 * draw());  // masses spread over a thousand
    scene.bodies.push_back({m, scenes::box_inertia(m, Vec3::Ones() + 0.5 * vector()),
                            Vec3(draw(), draw(), 1.5 * i), vector() - Vec3::UnitZ(), vector()});
  }
  const int contacts = 1 + static_cast<int>(generator() % static_cast<unsigned>(4 * bodies));
  for (int i = 0; i < contacts; ++i) {
    const int body = static_cast<int>(generator() % static_cast<unsigned>(bodies));
    const Vec3 point =
        scene.bodies[static_cast<std::size_t>(body)].center + Vec3(0.5 * draw(), 0.5 * draw(), -0.5);
    const Mat3 axes = scenes::axes_of((Vec3::UnitZ() + 0.3 * vector()).normalized(), draw());
    scene.contacts.push_back({body - 1, body, point, axes, std::max(0.0, largest_mu * draw())});
  }
  return scene;
}

double kinetic_energy(const Scene& scene, const VecX& motion) {
  double energy = 0;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const Vec6 V = motion.segment<6>(6 * static_cast<Eigen::Index>(i));
    energy += 0.5 * scene.bodies[i].mass * V.head<3>().squaredNorm() +
              0.5 * V.tail<3>().dot(scene.bodies[i].inertia * V.tail<3>());
  }
  return energy;
}

TEST(CoulombProblem, RandomPlasticImpactsAreSolvedAndNeverGainEnergy) {
  std::mt19937_64 generator(7);
  int solved = 0;
  const int problems = 300;
  for (int i = 0; i < problems; ++i) {
    const Scene scene = random_pile(generator, 1.0);
    const CoulombProblem problem = scenes::problem_of(scene);
    const CoulombSolution s = solve_coulomb(problem);
    solved += s.converged;
    EXPECT_EQ(s.converged, s.residual <= 1e-12);
    EXPECT_LT((problem.A * s.lambda + problem.b - s.w).norm(),
              1e-13 * (problem.b.norm() + s.lambda.norm()) * 1e3);
    if (!s.converged) continue;
    const double before = kinetic_energy(scene, scenes::free_motion(scene));
    EXPECT_LE(kinetic_energy(scene, scenes::motion_with(scene, s.lambda)), before * (1 + 1e-12));
  }
  EXPECT_EQ(solved, problems);
}

TEST(CoulombProblem, ForcesAreInTheirConesAlsoWhereFewDigitsAreAskedFor) {
  std::mt19937_64 generator(17);
  const CoulombOptions few_digits{.tolerance = 1e-9, .enough = 1e-6, .least_norm = false};
  for (int i = 0; i < 100; ++i) {
    const CoulombProblem problem = scenes::problem_of(random_pile(generator, 1.0));
    for (const CoulombOptions& options : {CoulombOptions{}, few_digits}) {
      const CoulombSolution s = solve_coulomb(problem, options);
      EXPECT_LE(coulomb_residual(problem, s.lambda, s.w), options.least_norm ? 1e-12 : options.enough);
      for (std::size_t k = 0; k < problem.mu.size(); ++k) {
        const Vec3 force = s.lambda.segment<3>(3 * static_cast<Eigen::Index>(k));
        EXPECT_GE(force(2), 0.0);
        EXPECT_LE(force.head<2>().norm(), problem.mu[k] * force(2) * (1 + 1e-15));
      }
    }
  }
}

CoulombProblem permuted(const CoulombProblem& problem, const std::vector<std::size_t>& order) {
  CoulombProblem result = problem;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Eigen::Index to = 3 * static_cast<Eigen::Index>(i), from = 3 * static_cast<Eigen::Index>(order[i]);
    result.b.segment<3>(to) = problem.b.segment<3>(from);
    result.mu[i] = problem.mu[order[i]];
    result.rows[i] = problem.rows[order[i]];
    result.slips[i] = problem.slips[order[i]];
    for (std::size_t j = 0; j < order.size(); ++j)
      result.A.block<3, 3>(to, 3 * static_cast<Eigen::Index>(j)) =
          problem.A.block<3, 3>(from, 3 * static_cast<Eigen::Index>(order[j]));
  }
  return result;
}

TEST(CoulombProblem, TheOrderOfTheContactsDoesNotMatter) {
  std::vector<Scene> all = {scenes::box_on_plane(3, 0.5, gravity_on_incline(26 * kDegree, 0.4)),
                            scenes::box_on_plane(3, 0.5, gravity_on_incline(35 * kDegree, 0.4)),
                            scenes::box_on_plane(3, 0.0, gravity_on_incline(35 * kDegree, 0.4)),
                            scenes::stack(std::vector<double>(4, 1.0), 0.5)};
  all[3].bodies[2].v += Vec3(4, 1, 0);
  all.push_back(scenes::box_on_plane(3, 0.3, {5, 2, -kGravity}));  // slides and spins: nine directions
  all.back().bodies[0].omega = Vec3(0, 0, 4);
  for (const Scene& scene : all) {
    const CoulombProblem problem = scenes::problem_of(scene);
    std::vector<std::size_t> order(problem.mu.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::mt19937_64 generator(2);
    std::shuffle(order.begin(), order.end(), generator);
    const CoulombSolution one = solve_coulomb(problem);
    const CoulombSolution other = solve_coulomb(permuted(problem, order));
    ASSERT_TRUE(one.converged && other.converged);
    for (std::size_t i = 0; i < order.size(); ++i)
      EXPECT_LT((other.lambda.segment<3>(3 * static_cast<Eigen::Index>(i)) -
                 one.lambda.segment<3>(3 * static_cast<Eigen::Index>(order[i])))
                    .norm(),
                1e-12 * one.lambda.norm());
  }
}

TEST(CoulombProblem, ScalesExactlyByPowersOfTwoAndRepeatsItsBits) {
  std::mt19937_64 generator(9);
  for (int i = 0; i < 40; ++i) {
    const CoulombProblem problem = scenes::problem_of(random_pile(generator, 1.0));
    CoulombProblem other = problem;
    other.A *= std::ldexp(1.0, 41);
    other.b *= std::ldexp(1.0, -17);
    const CoulombSolution one = solve_coulomb(problem);
    const CoulombSolution scaled = solve_coulomb(other);
    EXPECT_EQ(scaled.lambda, std::ldexp(1.0, -58) * one.lambda);
    EXPECT_EQ(scaled.w, std::ldexp(1.0, -17) * one.w);
    EXPECT_EQ(scaled.residual, one.residual);
    EXPECT_EQ(solve_coulomb(problem).lambda, one.lambda);
  }
}

TEST(CoulombProblem, OneContactAgreesWithTheReferenceProblems) {
  for (const nlohmann::json file = reference::read("ncp.json");
       const nlohmann::json& reference : file["cases"]) {
    SCOPED_TRACE(reference["name"]);
    CoulombProblem problem{reference::matrix(reference["K"]),
                           reference::vector(reference["b"]),
                           {reference["mu"]},
                           {FrictionRow::cone},
                           {Vec2::Zero()}};
    const CoulombSolution s = solve_coulomb(problem);
    ASSERT_TRUE(s.converged);
    EXPECT_LE(s.residual, 1e-13);
    double nearest = std::numeric_limits<double>::infinity();
    for (const nlohmann::json& expected : reference["solutions"])
      nearest = std::min(nearest, (s.lambda - reference::vector(expected["lambda"])).norm());
    EXPECT_LE(nearest, 1e-13 * s.lambda.norm());
  }
}

TEST(CoulombProblem, FrictionlessReferenceAccelerationsAreMet) {
  for (const nlohmann::json file = reference::read("lcp.json");
       const nlohmann::json& reference : file["cases"]) {
    SCOPED_TRACE(reference["name"]);
    const MatX J = reference::matrix(reference["J"]);
    const VecX inverse_mass = reference::vector(reference["M"]).cwiseInverse();
    const VecX a0 = reference::vector(reference["a0"]);
    const VecX b = J * a0 - reference::vector(reference["c"]);
    const std::size_t n = static_cast<std::size_t>(b.size());
    CoulombProblem problem{MatX::Zero(3 * b.size(), 3 * b.size()), VecX::Zero(3 * b.size()),
                           std::vector<double>(n, 0.0), std::vector<FrictionRow>(n, FrictionRow::cone),
                           std::vector<Vec2>(n, Vec2::Zero())};
    const MatX A = J * inverse_mass.asDiagonal() * J.transpose();
    for (Eigen::Index i = 0; i < b.size(); ++i) {
      problem.b(3 * i + 2) = b(i);
      for (Eigen::Index j = 0; j < b.size(); ++j) problem.A(3 * i + 2, 3 * j + 2) = A(i, j);
    }
    const CoulombSolution s = solve_coulomb(problem);
    ASSERT_TRUE(s.converged);
    VecX normal(b.size());
    for (Eigen::Index i = 0; i < b.size(); ++i) normal(i) = s.lambda(3 * i + 2);
    const VecX expected = reference::vector(reference["acceleration"]);
    EXPECT_LT((a0 + inverse_mass.asDiagonal() * (J.transpose() * normal) - expected).cwiseAbs().maxCoeff(),
              1e-13 * (1 + a0.cwiseAbs().maxCoeff() + expected.cwiseAbs().maxCoeff()) * 10);
  }
}

// ---- Known modes.

// The slips of a solution, as a caller would pass them on.
CoulombProblem with_slips_of(CoulombProblem problem, const CoulombSolution& s) {
  for (std::size_t i = 0; i < problem.mu.size(); ++i)
    if (s.modes[i] == ContactMode::slide)
      problem.slips[i] = s.w.segment<2>(3 * static_cast<Eigen::Index>(i)).normalized();
  return problem;
}

TEST(KnownModes, RepeatTheSolutionTheyCameFrom) {
  Scene scene = scenes::box_on_plane(3, 0.3, {5, 2, -kGravity});
  scene.bodies[0].omega = Vec3(0, 0, 4);
  const CoulombProblem problem = scenes::problem_of(scene);
  const CoulombSolution s = solve_coulomb(problem);
  ASSERT_TRUE(s.converged);
  ASSERT_EQ(count(s, ContactMode::slide), 9);
  const VecX lambda = solve_known_modes(with_slips_of(problem, s), s.modes);
  EXPECT_LT((lambda - s.lambda).norm(), 1e-12 * s.lambda.norm());
  // A solution's w is known to a 1e-13 of the largest term (kZeroMotion) in each of 18 rows of tangents.
  EXPECT_LT((problem.A * lambda + problem.b - s.w).norm(), 4e-13 * problem.b.norm());
}

TEST(KnownModes, KeepForcesInTheirConesWhereLeastNormLeavesThem) {
  Scene scene = scenes::stack(std::vector<double>(5, 1.0), 0.5);
  scene.bodies[0].v += Vec3(40, 10, 0);
  const CoulombProblem problem = scenes::problem_of(scene);
  const CoulombSolution s = solve_coulomb(problem);
  ASSERT_TRUE(s.converged);
  const std::optional<VecX> in_cones = find_cone_forces(with_slips_of(problem, s), s.modes);
  ASSERT_TRUE(in_cones.has_value());
  // The slips passed on are those of w, which is known to 1e-13 of the largest term; a slow one turns by
  // more.
  double slowest = problem.b.norm();
  for (Eigen::Index i = 0; i < static_cast<Eigen::Index>(s.modes.size()); ++i)
    if (s.modes[static_cast<std::size_t>(i)] == ContactMode::slide)
      slowest = std::min(slowest, s.w.segment<2>(3 * i).norm());
  const double turn = 1e-13 * problem.b.cwiseAbs().maxCoeff() / slowest;
  EXPECT_LT(turn, 1e-11);
  EXPECT_LT((*in_cones - s.lambda).norm(), (1e-11 + 10 * turn) * s.lambda.norm());
  EXPECT_LE(solve_known_modes(with_slips_of(problem, s), s.modes).norm(), in_cones->norm() * (1 + 1e-12));
}

TEST(KnownModes, KeepStickingPointsStillToRoundOff) {
  const CoulombProblem problem = scenes::problem_of(scenes::stack(std::vector<double>(10, 1.0), 0.5));
  const VecX lambda = solve_known_modes(problem, std::vector<ContactMode>(40, ContactMode::stick));
  EXPECT_LT((problem.A * lambda + problem.b).cwiseAbs().maxCoeff(), 1e-14 * 10 * kGravity);
}

TEST(KnownModes, TellWhenNoForcesInTheConesCanHold) {
  const std::vector<ContactMode> stick(4, ContactMode::stick);
  const double angle = std::atan(0.5);
  const auto on_slope = [](double slope) {
    return scenes::problem_of(scenes::box_on_plane(2, 0.5, gravity_on_incline(slope, 0.4)));
  };
  EXPECT_TRUE(find_cone_forces(on_slope(0.999 * angle), stick).has_value());
  EXPECT_FALSE(find_cone_forces(on_slope(1.001 * angle), stick).has_value());
}

TEST(KnownModes, OpenContactsGetNoForce) {
  const Scene scene = scenes::box_on_plane(2, 0.5, {0, 0, -kGravity});
  const CoulombProblem problem = scenes::problem_of(scene);
  EXPECT_EQ(solve_known_modes(problem, std::vector<ContactMode>(4, ContactMode::open)), VecX::Zero(12));
  const VecX lambda = solve_known_modes(
      problem, {ContactMode::stick, ContactMode::stick, ContactMode::stick, ContactMode::open});
  EXPECT_EQ(lambda.tail<3>(), Vec3::Zero());
  EXPECT_LT((force_sum(scene, lambda) - Vec3(0, 0, kGravity)).norm(), 1e-13 * kGravity);
}

// ---- Odd inputs.

TEST(CoulombProblem, OddInputsAreAnsweredHonestly) {
  EXPECT_TRUE(solve_coulomb({MatX(0, 0), VecX(0), {}, {}, {}}).converged);
  const auto single = [](const Mat3& A, const Vec3& b) {
    return solve_coulomb({A, b, {0.5}, {FrictionRow::cone}, {Vec2::Zero()}});
  };
  // Two immovable bodies that approach: nothing can be done. Nothing needs to be done if they part.
  EXPECT_FALSE(single(Mat3::Zero(), {0, 0, -1}).converged);
  EXPECT_TRUE(single(Mat3::Zero(), {1, 0, 1}).converged);
  EXPECT_FALSE(single(Mat3::Identity(), {0, 0, std::nan("")}).converged);
  // A pendulum's contact point moves along one line only: K has rank one.
  const Vec3 line = Vec3(0.6, 0, 0.8);
  const CoulombSolution hinge = single(line * line.transpose(), -2 * line);
  EXPECT_TRUE(hinge.converged);
  EXPECT_LE(hinge.w.norm(), 1e-13);
}

}  // namespace
}  // namespace rigor::coulomb_problem_test
