// Resting contact in contact space and in motion space as the number of contacts grows: time of each and the
// condition of the matrices that they work with.

#include "rigor/solver/motion/motion_problem.hpp"

#include <fmt/format.h>
#include <Eigen/Dense>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

namespace {

using namespace rigor;
using Eigen::Index;

constexpr double g = 9.81;

/// Rows of a contact with normal z at r from a body's centre of mass, times sign.
ContactRows::Side side(int node, const Vec3& r, double sign) {
  ContactRows::Side result;
  result.node = node;
  Mat3 cross;
  cross << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
  result.J << sign * Mat3::Identity(), -sign * cross;
  return result;
}

void add_cube(double mass, MotionProblem& problem) {
  Vec6 diagonal;
  diagonal << mass, mass, mass, mass / 6, mass / 6, mass / 6;
  problem.rows.masses.push_back(diagonal.asDiagonal());
  problem.rows.inverse_masses.push_back(diagonal.cwiseInverse().asDiagonal());
}

/// Free accelerations: gravity, a little aslant, so that friction acts.
void finish(double mu, MotionProblem& problem) {
  const std::size_t count = problem.rows.contacts.size();
  VecX free = VecX::Zero(6 * static_cast<Index>(problem.rows.node_count()));
  for (Index k = 0; k < free.size(); k += 6) free.segment<3>(k) = Vec3(0.002, 0.001, -1) * g;
  problem.laws.b = contact_rates(problem.rows, free);
  problem.laws.mu.assign(count, mu);
  problem.laws.rows.assign(count, FrictionRow::cone);
  problem.laws.slips.assign(count, Vec2::UnitX());
}

/// A cube of edge 1 on count × count points.
MotionProblem box_on_points(int count, double mu) {
  MotionProblem problem;
  add_cube(1, problem);
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < count; ++j)
      problem.rows.contacts.push_back(
          {ContactRows::Side{}, side(0, Vec3(i / (count - 1.0) - 0.5, j / (count - 1.0) - 0.5, -0.5), 1)});
  finish(mu, problem);
  return problem;
}

/// Cubes of edge 1 one on another, four points each.
MotionProblem stack(int cubes, double mu) {
  MotionProblem problem;
  for (int k = 0; k < cubes; ++k) {
    add_cube(1, problem);
    for (const double x : {-0.5, 0.5})
      for (const double y : {-0.5, 0.5})
        problem.rows.contacts.push_back(
            {k > 0 ? side(k - 1, Vec3(x, y, 0.5), -1) : ContactRows::Side{}, side(k, Vec3(x, y, -0.5), 1)});
  }
  finish(mu, problem);
  return problem;
}

MatX dense_rows(const MotionProblem& problem, bool over_root_of_mass) {
  MatX J = MatX::Zero(problem.laws.b.size(), 6 * static_cast<Index>(problem.rows.node_count()));
  for (std::size_t i = 0; i < problem.rows.contacts.size(); ++i)
    for (const ContactRows::Side& part : problem.rows.contacts[i])
      if (part.node >= 0) J.block<3, 6>(3 * static_cast<Index>(i), 6 * part.node) = part.J;
  for (Index k = 0; k < J.cols(); ++k) {
    const double mass = problem.rows.masses[static_cast<std::size_t>(k / 6)](k % 6, k % 6);
    J.col(k) /= over_root_of_mass ? std::sqrt(mass) : mass;
  }
  return J;
}

/// Largest over smallest that is not zero.
double spread(const VecX& values) {
  const double largest = values.maxCoeff();
  double smallest = largest;
  for (const double value : values)
    if (value > 1e-11 * largest) smallest = std::min(smallest, value);
  return largest / smallest;
}

/// Median of several calls [ms].
double milliseconds(const std::function<void()>& call) {
  std::vector<double> times;
  double sum = 0;
  while (times.size() < 3 || (sum < 200 && times.size() < 99)) {
    const auto begin = std::chrono::steady_clock::now();
    call();
    times.push_back(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
    sum += times.back();
    if (sum > 5000) break;
  }
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

void measure(const char* what, const MotionProblem& problem) {
  constexpr Index most_rows_of_svd = 620;
  const MatX G = dense_rows(problem, true);
  const bool is_small = G.rows() <= most_rows_of_svd;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto contact_space = [&](const CoulombOptions& options) {
    // The time counts A too.
    CoulombProblem in_contacts = problem.laws;
    in_contacts.A = G * G.transpose();
    return solve_coulomb(in_contacts, options);
  };
  const auto time_of = [&](std::optional<LcpName> lcp) {
    CoulombOptions options;
    options.lcp = lcp;
    return milliseconds([&] { contact_space(options); });
  };
  const std::size_t contacts = problem.rows.contacts.size();
  // The dense problems of more contacts take minutes.
  const bool is_dense_feasible = contacts <= 200;
  const CoulombSolution one = is_dense_feasible ? contact_space({}) : CoulombSolution{};
  const std::optional<CoulombSolution> other = solve_in_motion_space(problem);
  const double difference =
      other && is_dense_feasible
          ? (G.transpose() * (one.lambda - other->lambda)).norm() / (G.transpose() * one.lambda).norm()
          : nan;
  fmt::print(
      "{:<16} {:>8} {:>11.1e} {:>11.1e} {:>10.3f} {:>10.3f} {:>10.3f} {:>10.3f} {:>11.1e}\n", what, contacts,
      is_small ? spread(Eigen::SelfAdjointEigenSolver<MatX>(G * G.transpose()).eigenvalues()) : nan,
      is_small ? spread(Eigen::BDCSVD<MatX>(G).singularValues()) : nan,
      is_dense_feasible ? time_of(std::nullopt) : nan, is_dense_feasible ? time_of(LcpName::dantzig) : nan,
      contacts <= 40 ? time_of(LcpName::lemke) : nan,
      milliseconds([&] { static_cast<void>(solve_in_motion_space(problem)); }), difference);
}

}  // namespace

int main() {
  fmt::print(
      "Resting contact: condition of A = J M^-1 J^T and of J M^-1/2 (of what is not zero), milliseconds\n");
  fmt::print("{:<16} {:>8} {:>11} {:>11} {:>10} {:>10} {:>10} {:>10} {:>11}\n", "scene", "contacts", "cond A",
             "cond JM^-½", "chain", "dantzig", "lemke", "motion", "difference");
  for (const int count : {2, 3, 4, 6, 8, 10, 14}) measure("box on points", box_on_points(count, 0.5));
  for (const int cubes : {1, 2, 5, 10, 20, 50, 100}) measure("stack", stack(cubes, 0.5));
  return 0;
}
