#include "rigor/solver/coulomb/coulomb_local.hpp"
#include "rigor/solver/coulomb/rolling_friction_problem.hpp"
#include "rigor/solver/motion/motion_problem.hpp"
#include "rigor/solver/motion/projected_gauss_seidel.hpp"

#include "solver/reference_data.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace rigor::one_contact_test {
namespace {

/// A problem of one contact from ncp.json, in which all its solutions stand.
struct OneContact {
  std::string name;
  Mat3 K;
  Vec3 b;
  double mu;
  std::vector<Vec3> solutions;
};

std::vector<OneContact> reference_contacts() {
  std::vector<OneContact> contacts;
  const nlohmann::json& file = reference::read("ncp.json");
  for (const nlohmann::json& json : file["cases"]) {
    OneContact contact{
        json["name"], reference::matrix(json["K"]), reference::vector(json["b"]), json["mu"], {}};
    for (const nlohmann::json& solution : json["solutions"])
      contact.solutions.push_back(reference::vector(solution["lambda"]));
    contacts.push_back(contact);
  }
  return contacts;
}

CoulombProblem dense(const OneContact& contact) {
  return {contact.K, contact.b, {contact.mu}, {FrictionRow::cone}, {Vec2::UnitX()}};
}

/// The same on one node: K = J M⁻¹ Jᵀ with M = 1 and the Cholesky factor of K in F.
MotionProblem sparse(const OneContact& contact) {
  MotionProblem problem;
  problem.rows.masses.push_back(Mat6::Identity());
  problem.rows.inverse_masses.push_back(Mat6::Identity());
  ContactRows::Sides sides;
  sides[0].node = 0;
  sides[0].J.leftCols<3>() = Mat3(contact.K.llt().matrixL());
  problem.rows.contacts.push_back(sides);
  problem.laws = dense(contact);
  problem.laws.A.resize(0, 0);
  return problem;
}

/// Whether these forces are one of the solutions, and satisfy the law to round-off.
void expect_solution(const OneContact& contact, const Vec3& lambda, double tolerance, const char* solver) {
  EXPECT_LE(coulomb_residual(dense(contact), lambda, contact.K * lambda + contact.b), 1e-12)
      << contact.name << ", " << solver;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Vec3& solution : contact.solutions) nearest = std::min(nearest, (lambda - solution).norm());
  EXPECT_LE(nearest, tolerance * (1e-3 + lambda.norm())) << contact.name << ", " << solver;
}

TEST(OneContact, TheNumberOfSolutionsIsTold) {
  int several = 0;
  for (const OneContact& contact : reference_contacts()) {
    const std::size_t count = solve_coulomb_local_all(contact.K, contact.b, contact.mu).size();
    EXPECT_EQ(count, contact.solutions.size()) << contact.name;
    several += count > 1 ? 1 : 0;
  }
  EXPECT_EQ(several, 1);
}

TEST(OneContact, EverySolverOfTheExactConeReturnsOneOfThem) {
  const std::vector<OneContact> contacts = reference_contacts();
  EXPECT_EQ(contacts.size(), 24u);
  for (const OneContact& contact : contacts) {
    for (const std::optional<LcpName> lcp :
         {std::optional<LcpName>(), std::optional(LcpName::dantzig), std::optional(LcpName::lemke)}) {
      CoulombOptions options;
      options.lcp = lcp;
      expect_solution(contact, solve_coulomb(dense(contact), options).lambda, 1e-13, "contact space");
    }
    const MotionProblem problem = sparse(contact);
    // Beyond Painlevé's threshold motion space may hand over; what it solves is a solution.
    if (const std::optional<CoulombSolution> motion = solve_in_motion_space(problem)) {
      expect_solution(contact, motion->lambda, 1e-11, "motion space");
    } else {
      EXPECT_GT(contact.mu, 1) << contact.name;
    }
    CoulombOptions any_share;
    any_share.least_norm = false;
    if (const std::optional<CoulombSolution> motion = solve_in_motion_space(problem, {}, any_share))
      expect_solution(contact, motion->lambda, 1e-11, "augmented Lagrangian");
    expect_solution(contact, solve_projected_gauss_seidel({problem, {}}, 3000).lambda, 1e-10,
                    "projected Gauss-Seidel");
    RollingFrictionProblem moments{MatX::Zero(6, 6), VecX::Zero(6), {contact.mu}, {0}, {0}};
    moments.A.topLeftCorner<3, 3>() = contact.K;
    moments.A.bottomRightCorner<3, 3>().setIdentity();
    moments.b.head<3>() = contact.b;
    expect_solution(contact, solve_rolling_friction(moments).lambda.head<3>(), 1e-11, "moments");
  }
}

}  // namespace
}  // namespace rigor::one_contact_test
