#include "rigor/solver/coulomb/proximal_point_by_forces.hpp"

#include "random_vectors.hpp"
#include "rigor/solver/coulomb/coulomb_law.hpp"
#include "rigor/solver/coulomb/smooth_modes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace rigor::proximal_point_by_forces_test {
namespace {

using Eigen::Index;

CoulombProblem problem_of(const MatX& J, const VecX& b, double mu) {
  const std::size_t count = static_cast<std::size_t>(b.size() / 3);
  return {J * J.transpose(), b, std::vector<double>(count, mu),
          std::vector<FrictionRow>(count, FrictionRow::cone), std::vector<Vec2>(count, Vec2::Zero())};
}

/// One proximal point from no forces, and its miss of the law that it solves, relative to its rates.
struct Found {
  std::optional<ProximalPoint> point;
  double miss = 0;
};

Found find(const CoulombProblem& problem, double rho, SearchByForces& search) {
  const FactoredMotion motion(problem.A);
  const VecX masses = effective_masses(motion.diagonal());
  ProximalForces none;
  none.lambda = VecX::Zero(problem.b.size());
  none.complete(motion);
  Found found{search.find({problem, motion, masses, none, rho, 1e-3})};
  if (!found.point) return found;
  VecX w = problem.A * found.point->lambda + problem.b;
  for (Index i = 0; i < masses.size(); ++i)
    w.segment<3>(3 * i) += found.point->lambda.segment<3>(3 * i) / (rho * masses(i));
  found.miss = law_residual(problem, motion.diagonal(), largest_term(problem, found.point->lambda),
                            found.point->lambda, w);
  return found;
}

/// A mass on one contact of three rates of its own, whose truth is known in closed form: with A = 1 the
/// contact gives way by λ / ρ on top, (1 + 1/ρ) λ + b = w.
TEST(SearchByForces, OneContactOpensSticksAndSlides) {
  SearchByForces search;
  constexpr double rho = 100, mu = 0.5, give = 1 + 1 / rho;
  const MatX J = MatX::Identity(3, 3);
  const auto force = [&](const Vec3& b) {
    const Found found = find(problem_of(J, b, mu), rho, search);
    EXPECT_TRUE(found.point);
    return found.point ? Vec3(found.point->lambda) : Vec3(Vec3::Zero());
  };
  EXPECT_LE(force({0.3, 0.1, 1}).norm(), 1e-12);
  EXPECT_LE((force({0.2, 0.1, -1}) - Vec3(-0.2, -0.1, 1) / give).norm(), 1e-10);
  EXPECT_LE((force({3, 4, -1}) - Vec3(-0.3, -0.4, 1) / give).norm(), 1e-10);
}

/// Bodies of six unknowns on more contacts than they need, pushed on them and along: contacts let go, slide
/// and stick on the way, and the step has to end at such kinks. Each point solves its own law.
TEST(SearchByForces, PointsSolveTheirOwnLawBeyondKinks) {
  test::Random random(31);
  SearchByForces search;
  int found = 0, sliding = 0;
  constexpr int count = 300;
  for (int k = 0; k < count; ++k) {
    SCOPED_TRACE(k);
    const Index contacts = 2 + k % 9, unknowns = 6 * (1 + k % 3);
    const MatX J = MatX::NullaryExpr(3 * contacts, unknowns, [&] { return random.number(); });
    // Rates of a motion, so that redundant contacts agree, towards most of the contacts.
    VecX V = VecX::NullaryExpr(unknowns, [&] { return random.number(); });
    for (Index i = 0; i < contacts; ++i) V -= 0.5 * J.row(3 * i + 2).transpose();
    const CoulombProblem problem = problem_of(J, J * V, 0.1 + 0.1 * (k % 8));
    const Found point = find(problem, std::pow(10, 1 + k % 3), search);
    if (!point.point) continue;
    ++found;
    EXPECT_LE(point.miss, 1e-3);
    for (const ContactMode mode : point.point->modes) sliding += mode == ContactMode::slide;
  }
  EXPECT_GE(found, 290);  // A few go to and fro between modes, which the caller has to expect.
  EXPECT_GE(sliding, 300);
}

}  // namespace
}  // namespace rigor::proximal_point_by_forces_test
