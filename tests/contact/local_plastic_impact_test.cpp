#include "rigor/contact/impact/local_plastic_impact.hpp"

#include "rigor/contact/impact/normal_reflections.hpp"

#include <gtest/gtest.h>

#include <random>

namespace rigor::local_plastic_impact_test {
namespace {

Mat3 cross_matrix(const Vec3& r) {
  Mat3 matrix;
  matrix << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
  return matrix;
}

/// Bricks of 1 kg, 0.2 by 0.1 by 0.1 m, in columns that stand side by side on a floor: four points between
/// bricks that lie on each other, two between neighbours of a row.
class Wall {
 public:
  Wall(int columns, int rows) : columns_(columns), height_(rows) {
    Mat6 mass = Mat6::Identity();
    mass.diagonal().tail<3>() = Vec3(0.02, 0.05, 0.05) / 12;
    const std::size_t bricks = static_cast<std::size_t>(columns * rows);
    rows_.masses.assign(bricks, mass);
    rows_.inverse_masses.assign(bricks, mass.inverse());
    for (int column = 0; column < columns; ++column) {
      for (int row = 0; row < rows; ++row) {
        for (const double x : {-0.1, 0.1})
          for (const double y : {-0.05, 0.05})
            add(node(column, row - 1), node(column, row), Vec3(x, y, 0.05), Vec3(x, y, -0.05), Vec3::UnitZ());
        for (const double z : {-0.05, 0.05})
          if (column > 0)
            add(node(column - 1, row), node(column, row), Vec3(0.1, 0, z), Vec3(-0.1, 0, z), Vec3::UnitX());
      }
    }
  }

  int node(int column, int row) const { return row < 0 ? -1 : column * height_ + row; }

  /// At rest but for one brick.
  ImpactProblem struck(int body, const Vec3& v, const Vec3& w) const {
    VecX V = VecX::Zero(6 * columns_ * height_);
    V.segment<6>(6 * body) << v, w;
    ImpactProblem problem{contacts_, {}, contact_rates(rows_, V)};
    problem.rows = std::make_shared<const ContactRows>(rows_);
    problem.A = DelassusOperator(problem.rows);
    return problem;
  }

 private:
  void add(int lower, int higher, const Vec3& r_lower, const Vec3& r_higher, const Vec3& n) {
    Mat3 frame;
    frame << n.unitOrthogonal(), n.cross(n.unitOrthogonal()), n;
    ContactRows::Sides sides;
    sides[0].node = lower;
    sides[0].J << -frame.transpose(), frame.transpose() * cross_matrix(r_lower);
    sides[1].node = higher;
    sides[1].J << frame.transpose(), -frame.transpose() * cross_matrix(r_higher);
    rows_.contacts.push_back(sides);
    contacts_.push_back({lower + 1, higher + 1, frame, 0.5, 0.3});
  }

  int columns_, height_;
  ContactRows rows_;
  std::vector<ImpactContact> contacts_;
};

CoulombProblem law_of(const ImpactProblem& problem) {
  return {problem.A.dense(), problem.u, frictions(problem),
          std::vector<FrictionRow>(problem.count(), FrictionRow::cone),
          std::vector<Vec2>(problem.count(), Vec2::Zero())};
}

TEST(LocalPlasticImpact, SolvesTheLawOfAllContacts) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const Wall wall(6, 5);
  for (int k = 0; k < 12; ++k) {
    const int body = static_cast<int>(generator() % 30);
    const ImpactProblem problem =
        wall.struck(body, Vec3(uniform(generator), uniform(generator), uniform(generator)),
                    Vec3(uniform(generator), uniform(generator), uniform(generator)));
    const CoulombSolution found = solve_plastic_where_it_acts(problem, problem.u);
    // solve_cones accepts 1e-10, and contacts that contradict each other by a millionth of the velocities.
    EXPECT_LE(coulomb_residual(law_of(problem), found.lambda, found.w), 1e-6) << k;
    EXPECT_LE(fastest_approach(found.w), 1e-6 * problem.u.cwiseAbs().maxCoeff()) << k;
    EXPECT_LE((problem.u + problem.A * found.lambda - found.w).cwiseAbs().maxCoeff(), 1e-12) << k;
  }
}

TEST(LocalPlasticImpact, LeavesWhatIsFarAsItWas) {
  // The uppermost brick at the end of a long row is pressed down: its column takes it, and what friction
  // moves beside it.
  const Wall wall(16, 3);
  const ImpactProblem problem = wall.struck(wall.node(0, 2), Vec3(0, 0, -1), Vec3::Zero());
  const CoulombSolution found = solve_plastic_where_it_acts(problem, problem.u);
  EXPECT_TRUE(found.converged);
  std::size_t pressed = 0;
  for (std::size_t i = 0; i < problem.count(); ++i) pressed += found.lambda[row_of(i) + 2] > 0 ? 1U : 0U;
  EXPECT_GE(pressed, 4U);
  EXPECT_LE(pressed, problem.count() / 4);
}

TEST(NormalReflections, OfRowsAndOfTheMatrixAreTheSameAndKeepTheEnergy) {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const Wall wall(4, 4);
  for (int k = 0; k < 8; ++k) {
    const int body = static_cast<int>(generator() % 16);
    const ImpactProblem by_rows =
        wall.struck(body, Vec3(uniform(generator), 0, uniform(generator)), Vec3::Zero());
    ImpactProblem by_matrix = by_rows;
    by_matrix.rows.reset();
    by_matrix.A = DelassusOperator(by_rows.A.dense());

    const VecX lambda = NormalReflections(by_rows).run();
    const VecX u = by_rows.u + by_rows.A * lambda;
    const double speed = by_rows.u.cwiseAbs().maxCoeff();
    EXPECT_LE(fastest_approach(u), 1e-12 * speed) << k;
    EXPECT_GE(lambda.minCoeff(), 0) << k;
    // Every reflection keeps the energy; some dozens of them add their rounding.
    EXPECT_NEAR(energy_change(by_rows, lambda), 0, 1e-9 * speed * speed) << k;
    const VecX of_matrix = by_rows.A * NormalReflections(by_matrix).run();
    EXPECT_LE((by_rows.A * lambda - of_matrix).cwiseAbs().maxCoeff(), 1e-9 * speed) << k;
  }
}

TEST(DelassusOperator, OfRowsIsTheirMatrix) {
  const Wall wall(2, 3);
  const ImpactProblem problem = wall.struck(1, Vec3(0.3, 0.2, -1), Vec3(1, 2, 3));
  const MatX A = problem.A.dense();
  const DelassusOperator matrix(A);
  EXPECT_LE((problem.A * problem.u - A * problem.u).cwiseAbs().maxCoeff(), 1e-13 * A.cwiseAbs().maxCoeff());
  const auto of_rows = problem.A.normal_couplings();
  for (std::size_t i = 0; i < problem.count(); ++i) {
    for (std::size_t k = 0; k < problem.count(); ++k)
      EXPECT_LE((problem.A.block(i, k) - matrix.block(i, k)).cwiseAbs().maxCoeff(), 1e-13) << i << " " << k;
    for (const DelassusOperator::Coupling& other : of_rows[i])
      EXPECT_NEAR(other.response, A(row_of(i) + 2, row_of(other.contact) + 2), 1e-13);
  }
}

}  // namespace
}  // namespace rigor::local_plastic_impact_test
