#include "rigor/solver/coulomb/coulomb_gauss_seidel.hpp"

#include "rigor/core/index.hpp"
#include "rigor/math/dense.hpp"
#include "rigor/solver/coulomb/coulomb_local.hpp"

#include <utility>

namespace rigor {

using Eigen::Index;

namespace {

// A block with an eigenvalue below this share of its trace gets a proximal term of kProximal times its trace.
constexpr double kSingular = 1e-8;
constexpr double kProximal = 1e-3;

}  // namespace

CoulombGaussSeidel::CoulombGaussSeidel(const CoulombProblem& problem, CoulombGuess start)
    : problem_(problem), guess_(std::move(start)), w_(problem.A * guess_.lambda + problem.b) {
  for (Index i = 0; i < static_cast<Index>(problem.mu.size()); ++i) {
    Mat3 K = problem.A.block<3, 3>(3 * i, 3 * i);
    const double trace = K.trace();
    const double proximal = least_symmetric_pivot(K) > kSingular * trace ? 0.0 : kProximal * trace;
    K.diagonal().array() += proximal;
    blocks_.push_back({K, proximal});
  }
}

double CoulombGaussSeidel::sweep() {
  // Forth and back: the symmetric sweep depends less on the order of the contacts.
  const Index count = static_cast<Index>(blocks_.size());
  largest_change_ = 0;
  for (Index i = 0; i < count; ++i) relax(i);
  for (Index i = count - 1; i >= 0; --i) relax(i);
  const double largest = guess_.lambda.cwiseAbs().maxCoeff();
  return largest > 0 ? largest_change_ / largest : largest_change_;
}

void CoulombGaussSeidel::relax(Index contact) {
  const std::size_t k = at(contact);
  const Block& block = blocks_[k];
  if (!(block.K.trace() > 0)) return;  // Nothing here moves.
  if (problem_.rows[k] == FrictionRow::cone) {
    relax_cone(contact, block);
  } else {
    relax_slide(contact, block);
  }
}

void CoulombGaussSeidel::relax_cone(Index contact, const Block& block) {
  const std::size_t k = at(contact);
  const Vec3 lambda = guess_.lambda.segment<3>(3 * contact);
  // The other contacts held, w = K (λ' - λ) + w_old; the proximal term is inside K and vanishes at λ' = λ.
  const Vec3 b = w_.segment<3>(3 * contact) - block.K * lambda;
  const bool slid = guess_.modes.modes[k] == ContactMode::slide;
  const LocalCoulombSolution local = solve_coulomb_local(
      block.K, b, problem_.mu[k], slid ? std::optional<Vec2>(guess_.modes.slips[k]) : std::nullopt);

  // What the contact does is read off the local solution, the slip direction off its friction.
  const double speed = local.w.head<2>().norm();
  guess_.modes.modes[k] = local.mode;
  if (local.mode == ContactMode::stick && problem_.mu[k] == 0) guess_.modes.modes[k] = ContactMode::slide;
  if (local.mode == ContactMode::slide)
    guess_.modes.slips[k] =
        slip_of_force(local.lambda, speed > 0 ? Vec2(local.w.head<2>() / speed) : guess_.modes.slips[k]);
  set_force(contact, local.lambda);
}

void CoulombGaussSeidel::relax_slide(Index contact, const Block& block) {
  const std::size_t k = at(contact);
  const double mu = problem_.mu[k];
  const Vec2 slip = mu > 0 ? problem_.slips[k] : Vec2::Zero();
  // The force stays on the generator against the known slip: one unknown, its normal part.
  const Vec3 direction(-mu * slip(0), -mu * slip(1), 1.0);
  const double stiffness = block.K.row(2).dot(direction);
  const double normal = guess_.lambda(3 * contact + 2);
  const double b = w_(3 * contact + 2) - stiffness * normal;
  // A stiffness ≤ 0 is Painlevé's case: no force is given, whatever b says, and the residual will tell.
  const double solved = stiffness > 0 && b < 0 ? -b / stiffness : 0.0;
  guess_.modes.modes[k] = solved > 0 ? ContactMode::slide : ContactMode::open;
  set_force(contact, solved * direction);
}

void CoulombGaussSeidel::set_force(Index contact, const Vec3& lambda) {
  const Vec3 change = lambda - guess_.lambda.segment<3>(3 * contact);
  if (change.isZero(0.0)) return;
  w_ += problem_.A.middleCols<3>(3 * contact) * change;
  guess_.lambda.segment<3>(3 * contact) = lambda;
  largest_change_ = std::max(largest_change_, change.cwiseAbs().maxCoeff());
}

}  // namespace rigor
