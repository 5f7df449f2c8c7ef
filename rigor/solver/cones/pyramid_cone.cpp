#include "rigor/solver/cones/pyramid_cone.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/solver/coulomb/known_modes.hpp"

#include <cmath>
#include <numbers>

namespace rigor {

using Eigen::Index;

namespace {

bool has_pyramid(const CoulombProblem& problem, std::size_t k) {
  return problem.rows[k] == FrictionRow::cone && problem.mu[k] > 0;
}

int exponent_of(double x) {
  int exponent = 0;
  std::frexp(x, &exponent);
  return exponent;
}

/// The complementarity problem. Its unknowns are c of all contacts, then β of those with a pyramid, then
/// their s.
struct PyramidLcp {
  std::vector<ContactVector> rows, columns;  ///< Of c and β: directions of w, and of forces.
  std::vector<std::size_t> slipping;         ///< Contacts with a pyramid.
  MatX M;
  VecX q;
};

/// Assembles the matrix and the right side in the form of Stewart and Trinkle 1996.
PyramidLcp make_lcp(const CoulombProblem& problem, const FrictionPyramid& pyramid) {
  PyramidLcp lcp;
  const Index count = static_cast<Index>(problem.mu.size()), m = pyramid.directions;
  // Normal rows: 0 ≤ c ⊥ w_n ≥ 0. A contact with a prescribed slip direction adds its friction to the column
  // of c.
  for (Index i = 0; i < count; ++i) {
    const std::size_t k = at(i);
    lcp.rows.push_back({i, Vec3::UnitZ()});
    lcp.columns.push_back(lcp.rows.back());
    if (problem.rows[k] == FrictionRow::slide && problem.mu[k] > 0)
      lcp.columns.back().direction.head<2>() = -problem.mu[k] * problem.slips[k];
    if (has_pyramid(problem, k)) lcp.slipping.push_back(k);
  }
  // Tangential rows: one for each direction of each pyramid.
  for (const std::size_t k : lcp.slipping) {
    for (int j = 0; j < m; ++j) {
      const double angle = pyramid.first_angle + 2 * std::numbers::pi * j / static_cast<double>(m);
      lcp.rows.push_back({static_cast<Index>(k), Vec3(std::cos(angle), std::sin(angle), 0)});
      lcp.columns.push_back(lcp.rows.back());
    }
  }
  const Index forces = static_cast<Index>(lcp.rows.size()), slips = static_cast<Index>(lcp.slipping.size());
  lcp.M = MatX::Zero(forces + slips, forces + slips);
  lcp.q = VecX::Zero(forces + slips);
  // The block of the forces: the matrix A between their directions.
  lcp.M.topLeftCorner(forces, forces) = reduce(problem.A, lcp.rows, lcp.columns);
  for (Index r = 0; r < forces; ++r) {
    const ContactVector& row = lcp.rows[at(r)];
    lcp.q(r) = row.direction.dot(problem.b.segment<3>(3 * row.contact));
  }
  // The blocks of the slip speeds: e in the rows of β, and μ c - eᵀ β in those of s.
  for (Index s = 0; s < slips; ++s) {
    const std::size_t k = lcp.slipping[at(s)];
    lcp.M.block(count + m * s, forces + s, m, 1).setOnes();
    lcp.M.block(forces + s, count + m * s, 1, m).setConstant(-1);
    lcp.M(forces + s, static_cast<Index>(k)) = problem.mu[k];
  }
  return lcp;
}

ContactMode mode_of(double normal, double speed, double zero) {
  if (!(normal > 0)) return ContactMode::open;
  return speed <= zero ? ContactMode::stick : ContactMode::slide;
}

}  // namespace

CoulombSolution solve_pyramids(const CoulombProblem& problem, const FrictionPyramid& pyramid) {
  RIGOR_ASSERT(pyramid.directions >= 4 && pyramid.directions % 2 == 0);
  RIGOR_ASSERT(problem.A.rows() == problem.b.size());
  const Index count = static_cast<Index>(problem.mu.size());
  CoulombSolution solution{VecX::Zero(problem.b.size()), problem.b, {}, 0.0, 0, true, "pyramid"};
  if (count == 0) return solution;
  // Lemke's pivots compare velocities and forces, so both are scaled to the same size; powers of two change
  // no digit.
  CoulombProblem unit = problem;
  const int A_exponent = exponent_of(problem.A.cwiseAbs().maxCoeff()),
            b_exponent = exponent_of(problem.b.cwiseAbs().maxCoeff());
  unit.A *= std::ldexp(1.0, -A_exponent);
  unit.b *= std::ldexp(1.0, -b_exponent);
  const PyramidLcp lcp = make_lcp(unit, pyramid);
  const LcpSolution found = lcp_lemke(lcp.M, lcp.q);
  // λ = Σ of the forces along their columns, scaled back.
  for (std::size_t c = 0; c < lcp.columns.size(); ++c)
    solution.lambda.segment<3>(3 * lcp.columns[c].contact) +=
        std::ldexp(found.z(static_cast<Index>(c)), b_exponent - A_exponent) * lcp.columns[c].direction;
  solution.w = problem.A * solution.lambda + problem.b;
  // A contact sticks if its slip is round-off; one with a force and without a pyramid always slides.
  const double zero = 1e-12 * problem.b.cwiseAbs().maxCoeff();
  for (std::size_t k = 0; k < problem.mu.size(); ++k) {
    const Index row = 3 * static_cast<Index>(k);
    solution.modes.push_back(has_pyramid(problem, k) || solution.lambda(row + 2) <= 0
                                 ? mode_of(solution.lambda(row + 2), solution.w.segment<2>(row).norm(), zero)
                                 : ContactMode::slide);
  }
  solution.residual = found.residual;
  solution.iterations = found.pivots;
  solution.converged = found.converged;
  return solution;
}

}  // namespace rigor
