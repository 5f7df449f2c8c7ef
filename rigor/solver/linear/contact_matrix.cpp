#include "rigor/solver/linear/contact_matrix.hpp"

#include "rigor/core/index.hpp"
#include "rigor/solver/linear/two_doubles.hpp"

#include <array>
#include <span>
#include <tuple>

namespace rigor {

using Eigen::Index;

ContactMatrix::ContactMatrix(const ContactRows& rows, const EliminationPlan& plan, double mass_factor)
    : pattern_(plan.pattern), blocks_(plan.pattern, false), scales_(plan.scales) {
  masses_.reserve(rows.node_count());
  for (std::size_t k = 0; k < rows.node_count(); ++k) {
    const auto S = scales_.segment<6>(6 * static_cast<Index>(k)).asDiagonal();
    masses_.push_back(S * (mass_factor * rows.masses[k]) * S);
  }
  const std::size_t count = rows.contacts.size();
  first_.reserve(count + 1);
  first_slot_.reserve(count);
  pair_of_.reserve(count);
  rows_.reserve(2 * count);
  slots_.reserve(4 * count);
  for (const ContactRows::Sides& sides : rows.contacts) add_sides(sides);
  first_.push_back(rows_.size());
  squares_.resize(count);
}

void ContactMatrix::add_sides(const ContactRows::Sides& sides) {
  std::array<const ContactRows::Side*, std::tuple_size_v<ContactRows::Sides>> present{};
  std::size_t count = 0;
  first_.push_back(rows_.size());
  first_slot_.push_back(slots_.size());
  for (const ContactRows::Side& side : sides) {
    if (side.node < 0) continue;
    present[count++] = &side;
    rows_.push_back(side.J * scales_.segment<6>(6 * side.node).asDiagonal());
  }
  // Where the products of any two sides go in the matrix is found once for all factorisations.
  const std::span own(present.data(), count);
  for (const ContactRows::Side* left : own)
    for (const ContactRows::Side* right : own) slots_.push_back(pattern_.slot(left->node, right->node));
  pair_of_.push_back(own.size() == 2 ? pair_of(*own[0], *own[1]) : no_pair);
}

/// The pair whose shift takes the rows of A to those of B, to rounding; none if no shift does.
int ContactMatrix::pair_of(const ContactRows::Side& A, const ContactRows::Side& B) {
  constexpr double rounding = 1e-12;
  if (A.node == B.node) return no_pair;
  // For a force at one point the rows of B are those of A, negated, about a centre that is displaced by the
  // arm.
  const Mat3 axes = A.J.leftCols<3>();
  const Mat3 arm = axes.transpose() * (-B.J.rightCols<3>() - A.J.rightCols<3>());
  const double size = A.J.cwiseAbs().maxCoeff() + B.J.cwiseAbs().maxCoeff();
  const bool is_shift =
      (axes + B.J.leftCols<3>()).cwiseAbs().maxCoeff() <= rounding * size &&
      (axes * arm + A.J.rightCols<3>() + B.J.rightCols<3>()).cwiseAbs().maxCoeff() <= rounding * size;
  if (!is_shift) return no_pair;

  // A contact of a pair that is known, or of another one.
  for (std::size_t k = pairs_.size(); k-- > 0;) {
    const Pair& known = pairs_[k];
    if (known.A == A.node && known.B == B.node && (known.arm - arm).cwiseAbs().maxCoeff() <= rounding * size)
      return static_cast<int>(k);
  }
  // A new pair: its shift between scaled unknowns, and the places of its four blocks.
  const double linear_A = scales_(6 * A.node), angular_A = scales_(6 * A.node + 3);
  const double linear_B = scales_(6 * B.node), angular_B = scales_(6 * B.node + 3);
  pairs_.push_back({A.node, B.node, arm, linear_B / linear_A, angular_B / angular_A,
                    (angular_B / linear_A) * arm, pattern_.slot(A.node, A.node),
                    pattern_.slot(B.node, B.node), pattern_.slot(A.node, B.node),
                    pattern_.slot(B.node, A.node), Block6::Zero(), false});
  return static_cast<int>(pairs_.size()) - 1;
}

bool ContactMatrix::factor(const std::vector<Mat3>& D, bool is_symmetric) {
  // The masses, then what the contacts add: contacts of a pair are summed on A, and shifted to the other
  // blocks once.
  blocks_.restart(is_symmetric);
  for (int node = 0; node < static_cast<int>(masses_.size()); ++node)
    blocks_.block(pattern_.slot(node, node)) = masses_[at(node)];
  for (Pair& pair : pairs_) pair.is_used = false;
  for (std::size_t i = 0; i < D.size(); ++i)
    if (!D[i].isZero(0)) add_contact(i, D[i]);
  for (const Pair& pair : pairs_)
    if (pair.is_used) add_pair(pair);
  return blocks_.factor();
}

void ContactMatrix::add_contact(std::size_t contact, const Mat3& D) {
  const std::size_t begin = first_[contact], end = first_[contact + 1];
  if (pair_of_[contact] != no_pair) {
    Pair& pair = pairs_[at(pair_of_[contact])];
    if (!pair.is_used) pair.sum.setZero();
    pair.is_used = true;
    add_square(contact, D, pair.sum);
    return;
  }
  if (end - begin == 1) {
    add_square(contact, D, blocks_.block(slots_[first_slot_[contact]]));
    return;
  }
  const std::size_t* slot = slots_.data() + first_slot_[contact];
  for (std::size_t left = begin; left < end; ++left)
    for (std::size_t right = begin; right < end; ++right, ++slot)
      if (blocks_.is_read(*slot)) add_product(rows_[left], D, rows_[right], blocks_.block(*slot));
}

/// block += Jᵀ D J with the rows of the contact's first side. What sticks has a D that is a number.
void ContactMatrix::add_square(std::size_t contact, const Mat3& D, Block6& block) {
  const Rows& J = rows_[first_[contact]];
  if (D != D(0, 0) * Mat3::Identity()) {
    add_product(J, D, J, block);
    return;
  }
  std::optional<Block6>& square = squares_[contact];
  if (!square) square = J.transpose().lazyProduct(J);
  block += D(0, 0) * *square;
}

/// block += leftᵀ D right, two columns at a time.
void ContactMatrix::add_product(const Rows& left, const Mat3& D, const Rows& right, Block6& block) {
  const double *l = left.data(), *r = right.data();
  for (int c = 0; c < 6; c += 2) {
    const TwoDoubles r0 = two_of(r + c), r1 = two_of(r + 6 + c), r2 = two_of(r + 12 + c);
    const TwoDoubles p0 = D(0, 0) * r0 + D(0, 1) * r1 + D(0, 2) * r2,
                     p1 = D(1, 0) * r0 + D(1, 1) * r1 + D(1, 2) * r2,
                     p2 = D(2, 0) * r0 + D(2, 1) * r1 + D(2, 2) * r2;
    double* target = block.data() + c;
    for (int i = 0; i < 6; ++i, target += 6)
      put_two(two_of(target) + (l[i] * p0 + l[6 + i] * p1 + l[12 + i] * p2), target);
  }
}

/// The four blocks of a pair from its sum: what X does to columns, it does by its three blocks.
void ContactMatrix::add_pair(const Pair& pair) {
  const Block6& S = pair.sum;
  // S X, and Xᵀ times a block, with X = (linear, arm; 0, angular).
  Block6 SX;
  SX.leftCols<3>() = pair.linear * S.leftCols<3>();
  SX.rightCols<3>() = S.leftCols<3>().lazyProduct(pair.scaled_arm) + pair.angular * S.rightCols<3>();
  const auto shifted = [&pair](const Block6& block) {
    Block6 result;
    result.topRows<3>() = pair.linear * block.topRows<3>();
    result.bottomRows<3>() =
        pair.scaled_arm.transpose().lazyProduct(block.topRows<3>()) + pair.angular * block.bottomRows<3>();
    return result;
  };
  // (J_A, -J_A X)ᵀ D (J_A, -J_A X), summed over the contacts.
  blocks_.block(pair.slot_A) += S;
  blocks_.block(pair.slot_B) += shifted(SX);
  if (blocks_.is_read(pair.slot_AB)) blocks_.block(pair.slot_AB) -= SX;
  if (blocks_.is_read(pair.slot_BA)) blocks_.block(pair.slot_BA) -= shifted(S);
}

void ContactMatrix::solve(const VecX& c, VecX& x) const {
  scaled_ = scales_.cwiseProduct(c);
  blocks_.solve(scaled_, x);
  x = scales_.cwiseProduct(x);
}

}  // namespace rigor
