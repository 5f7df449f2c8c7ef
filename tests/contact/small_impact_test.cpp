#include "rigor/contact/impact/impact_problem.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace rigor::small_impact_test {
namespace {

Mat3 cross_matrix(const Vec3& r) {
  Mat3 matrix;
  matrix << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
  return matrix;
}

/// One to three boxes of random sizes and velocities, on a floor, beside each other or on each other, with 5
/// to 11 points in all, most of them redundant.
class Boxes {
 public:
  Boxes(std::mt19937& generator, double spin) {
    const int count = 1 + static_cast<int>(generator() % 3);
    mu_ = 0.1 + 0.8 * share(generator);
    for (int box = 0; box < count; ++box) add_box(generator);
    for (int box = 0; box < count; ++box) {
      const bool is_on_box = box > 0 && generator() % 2 == 0;
      add_face(generator, is_on_box ? box - 1 : -1, box, is_on_box ? 0.6 : 1.0);
      if (box > 0 && !is_on_box) add_sides(box - 1, box);
    }
    V_ = VecX::NullaryExpr(6 * count, [&] { return 2 * share(generator) - 1; });
    for (int box = 0; box < count; ++box) {
      V_[6 * box + 2] -= 0.5;
      V_.segment<3>(6 * box + 3) *= spin;
    }
  }

  std::size_t contact_count() const { return contacts_.size(); }

  /// Contact k of the problem is the one at order[k].
  ImpactProblem problem(const std::vector<std::size_t>& order) const {
    ContactRows rows = rows_;
    ImpactProblem result;
    for (std::size_t k = 0; k < order.size(); ++k) {
      rows.contacts[k] = rows_.contacts[order[k]];
      result.contacts.push_back(contacts_[order[k]]);
    }
    result.u = contact_rates(rows, V_);
    result.A = DelassusOperator(contact_response(rows));
    result.rows = std::make_shared<const ContactRows>(std::move(rows));
    return result;
  }

 private:
  static double share(std::mt19937& generator) {
    return std::uniform_real_distribution<double>(0, 1)(generator);
  }

  void add_box(std::mt19937& generator) {
    Vec3 half(0.06, 0.04, 0.02);
    for (double& side : half) side += 0.08 * share(generator);
    const double mass = 8000 * half.prod();
    const Vec3 squares = half.cwiseAbs2();
    Mat6 M = mass * Mat6::Identity();
    M.diagonal().tail<3>() = mass / 3 * (Vec3::Constant(squares.sum()) - squares);
    half_.push_back(half);
    rows_.masses.push_back(M);
    rows_.inverse_masses.push_back(M.inverse());
  }

  void add_face(std::mt19937& generator, int lower, int higher, double part) {
    const Vec3& half = half_[static_cast<std::size_t>(higher)];
    for (const double x : {-1, 1}) {
      for (const double y : {-1, 1}) {
        if (generator() % 5 == 0) continue;
        const Vec3 r(part * x * half.x(), part * y * half.y(), -half.z());
        const double z = lower < 0 ? 0 : half_[static_cast<std::size_t>(lower)].z();
        add(lower, higher, Vec3(r.x(), r.y(), z), r, Vec3::UnitZ());
      }
    }
  }

  void add_sides(int left, int right) {
    const Vec3 &a = half_[static_cast<std::size_t>(left)], &b = half_[static_cast<std::size_t>(right)];
    const Vec3 least = a.cwiseMin(b);
    for (const double y : {-least.y(), least.y()})
      add(left, right, Vec3(a.x(), y, least.z() - a.z()), Vec3(-b.x(), y, least.z() - b.z()), Vec3::UnitX());
  }

  void add(int A, int B, const Vec3& r_A, const Vec3& r_B, const Vec3& n) {
    Mat3 frame;
    frame << n.unitOrthogonal(), n.cross(n.unitOrthogonal()), n;
    ContactRows::Sides sides;
    sides[0].node = A;
    sides[0].J << -frame.transpose(), frame.transpose() * cross_matrix(r_A);
    sides[1].node = B;
    sides[1].J << frame.transpose(), -frame.transpose() * cross_matrix(r_B);
    rows_.contacts.push_back(sides);
    contacts_.push_back({A + 1, B + 1, frame, mu_, 0.0});
  }

  double mu_ = 0;
  std::vector<Vec3> half_;
  ContactRows rows_;
  std::vector<ImpactContact> contacts_;
  VecX V_;
};

Boxes random_boxes(std::mt19937& generator, double spin) {
  while (true) {
    Boxes boxes(generator, spin);
    if (boxes.contact_count() >= 5 && boxes.contact_count() <= 11) return boxes;
  }
}

/// Velocities after it, in the order of the boxes' contacts.
VecX velocities_after(const Boxes& boxes, const std::vector<std::size_t>& order,
                      const std::vector<double>& mu, bool by_matrix = false) {
  ImpactProblem problem = boxes.problem(order);
  if (by_matrix) problem.rows.reset();
  const CoulombSolution found = solve_cones(problem, problem.u, mu);
  EXPECT_LE(found.residual, 1e-10);
  EXPECT_LE((problem.u + problem.A * found.lambda - found.w).norm(), 1e-11 * problem.u.norm());
  VecX w(found.w.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    w.segment<3>(row_of(order[k])) = found.w.segment<3>(row_of(k));
  return w;
}

// Coulomb's law has several solutions where redundant points slide in different directions: which one is
// found hardly ever depends on the order of the contacts.
TEST(SmallImpacts, OnRowsAreSolvedAndHardlyDependOnTheOrderOfContacts) {
  constexpr int kDraws = 1000, kMostOfAThousand = 3;
  std::mt19937 generator(11);
  int differ = 0;
  for (const double spin : {0.0, 1.0, 10.0}) {
    for (int k = 0; k < kDraws; ++k) {
      SCOPED_TRACE(testing::Message() << "spin " << spin << ", draw " << k);
      const Boxes boxes = random_boxes(generator, spin);
      std::vector<std::size_t> order(boxes.contact_count());
      std::iota(order.begin(), order.end(), 0);
      const ImpactProblem problem = boxes.problem(order);
      std::vector<std::size_t> shuffled = order;
      std::shuffle(shuffled.begin(), shuffled.end(), generator);
      const VecX once = velocities_after(boxes, order, frictions(problem));
      EXPECT_LE(fastest_approach(once), 1e-9 * problem.u.cwiseAbs().maxCoeff());
      const VecX again = velocities_after(boxes, shuffled, frictions(problem));
      differ += (once - again).norm() > 1e-8 * problem.u.norm() ? 1 : 0;
    }
  }
  EXPECT_LE(differ, 3 * kMostOfAThousand);
}

// There is one motion then, whoever finds it.
TEST(SmallImpacts, WithoutFrictionRowsAndMatrixGiveOneMotion) {
  std::mt19937 generator(12);
  for (int k = 0; k < 1000; ++k) {
    SCOPED_TRACE(k);
    const Boxes boxes = random_boxes(generator, 3);
    std::vector<std::size_t> order(boxes.contact_count());
    std::iota(order.begin(), order.end(), 0);
    const ImpactProblem problem = boxes.problem(order);
    const std::vector<double> none(order.size(), 0.0);
    const VecX dense = solve_cones(problem.A.dense(), problem.u, none).w;
    EXPECT_LE((velocities_after(boxes, order, none) - dense).norm(), 1e-9 * problem.u.norm());
  }
}

}  // namespace
}  // namespace rigor::small_impact_test
