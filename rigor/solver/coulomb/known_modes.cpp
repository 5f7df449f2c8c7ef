#include "rigor/solver/coulomb/known_modes.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/rounding.hpp"
#include "rigor/math/dense.hpp"
#include "rigor/solver/coulomb/cone.hpp"

#include <cmath>
#include <utility>

namespace rigor {

using Eigen::Index;

namespace {

std::vector<ContactVector> force_directions(const CoulombProblem& problem, const ContactModes& modes) {
  std::vector<ContactVector> columns;
  for (Index i = 0; i < static_cast<Index>(modes.modes.size()); ++i) {
    const std::size_t k = at(i);
    if (modes.modes[k] == ContactMode::stick) {
      // A contact that sticks may have any force, so its columns are the axes.
      for (int axis = 0; axis < 3; ++axis) columns.push_back({i, Vec3::Unit(axis)});
    } else if (modes.modes[k] == ContactMode::slide) {
      // One that slides has a force on the border of its cone, against the slip: one column.
      const double mu = problem.mu[k];
      const Vec2 slip = mu > 0 ? modes.slips[k] : Vec2::Zero();
      columns.push_back({i, Vec3(-mu * slip(0), -mu * slip(1), 1.0) / std::sqrt(1.0 + mu * mu)});
    }
  }
  return columns;
}

std::vector<ContactVector> equations(const ContactModes& modes) {
  std::vector<ContactVector> rows;
  for (Index i = 0; i < static_cast<Index>(modes.modes.size()); ++i) {
    const ContactMode mode = modes.modes[at(i)];
    if (mode == ContactMode::open) continue;
    // Sticking holds the three components of the rate at zero, sliding the normal one.
    for (int axis = mode == ContactMode::stick ? 0 : 2; axis < 3; ++axis)
      rows.push_back({i, Vec3::Unit(axis)});
  }
  return rows;
}

VecX right_side(const VecX& b, const std::vector<ContactVector>& rows) {
  VecX c(static_cast<Index>(rows.size()));
  for (Index r = 0; r < c.size(); ++r) {
    const ContactVector& row = rows[at(r)];
    c(r) = -row.direction.dot(b.segment<3>(3 * row.contact));
  }
  return c;
}

}  // namespace

MatX reduce(const MatX& A, const std::vector<ContactVector>& rows,
            const std::vector<ContactVector>& columns) {
  MatX reduced(static_cast<Index>(rows.size()), static_cast<Index>(columns.size()));
  for (Index j = 0; j < reduced.cols(); ++j) {
    const ContactVector& column = columns[at(j)];
    // Only three columns of A act on a direction of one contact.
    const VecX image = A.middleCols<3>(3 * column.contact) * column.direction;
    for (Index r = 0; r < reduced.rows(); ++r) {
      const ContactVector& row = rows[at(r)];
      reduced(r, j) = row.direction.dot(image.segment<3>(3 * row.contact));
    }
  }
  return reduced;
}

KnownModesSystem::KnownModesSystem(const CoulombProblem& problem, const ContactModes& modes)
    : contact_count_(problem.b.size() / 3),
      columns_(force_directions(problem, modes)),
      system_(reduce(problem.A, equations(modes), columns_)),
      right_side_(right_side(problem.b, equations(modes))),
      x_least_(system_.solve(right_side_)) {
  // Unknowns are listed by contact: three for one that sticks, one for one that slides.
  for (Index j = 0; j < x_least_.size();) {
    const Index contact = columns_[at(j)].contact;
    const std::size_t k = at(contact);
    const bool sticks = modes.modes[k] == ContactMode::stick;
    blocks_.push_back({contact, j, sticks, problem.mu[k]});
    j += sticks ? 3 : 1;
  }
}

VecX KnownModesSystem::expand(const VecX& x) const {
  VecX lambda = VecX::Zero(3 * contact_count_);
  for (Index j = 0; j < x.size(); ++j) {
    const ContactVector& column = columns_[at(j)];
    lambda.segment<3>(3 * column.contact) += x(j) * column.direction;
  }
  return lambda;
}

VecX KnownModesSystem::solve_near(const VecX& lambda) const {
  VecX x(x_least_.size());
  for (Index j = 0; j < x.size(); ++j) {
    const ContactVector& column = columns_[at(j)];
    x(j) = column.direction.dot(lambda.segment<3>(3 * column.contact));
  }
  // The least change of the given forces, as far as these directions can make them, that solves the
  // equations.
  x += system_.solve(right_side_ - system_.matrix() * x);
  return expand(x);
}

// Nearest x in the cones: Coulomb cone for a stick contact, half-line for a slide.
VecX KnownModesSystem::project(const VecX& x) const {
  VecX projected(x.size());
  for (const Block& block : blocks_) {
    if (block.sticks) {
      projected.segment<3>(block.column) = project_on_cone(x.segment<3>(block.column), block.mu);
    } else {
      projected(block.column) = std::max(0.0, x(block.column));
    }
  }
  return projected;
}

// basisᵀ D basis with D the derivative of `project` at x.
MatX KnownModesSystem::project_derivative(const VecX& x, const MatX& basis) const {
  MatX scaled = MatX::Zero(basis.rows(), basis.cols());
  for (const Block& block : blocks_) {
    if (block.sticks) {
      scaled.middleRows<3>(block.column) = cone_projection_derivative(x.segment<3>(block.column), block.mu) *
                                           basis.middleRows<3>(block.column);
    } else if (x(block.column) > 0) {
      scaled.row(block.column) = basis.row(block.column);
    }
  }
  return basis.transpose() * scaled;
}

// The least-norm point of an affine set {x : Zᵀx = d} (Z orthonormal, x_least = Z d) in a cone C is
// proj_C(Z y) where y minimises the convex, once differentiable  φ(y) = ½|proj_C(Z y)|² - dᵀy:  Newton's
// method with a line search. Without such a point y grows without bound.
std::optional<VecX> KnownModesSystem::find_in_cones() const {
  constexpr int kMaxSteps = 40;
  constexpr double kRunaway = 1e6;
  if (!x_least_.allFinite()) return std::nullopt;
  // Where the least-norm solution obeys the cones, it is the answer.
  if (project(x_least_) == x_least_) return expand(x_least_);
  // Else the search is for y, which has as many components as the equations have rank.
  const MatX Z = system_.row_space();
  const VecX d = Z.transpose() * x_least_;
  const double size = d.norm();
  const double tolerance = 8 * kEpsilon * size * std::sqrt(static_cast<double>(d.size()));
  DualPoint point = evaluate_dual(d, Z, d);
  for (int step = 0; step < kMaxSteps && point.y.norm() <= kRunaway * size; ++step) {
    const double error = point.gradient.norm();
    if (error <= tolerance) return expand(point.x);

    // The derivative of the projection is only semidefinite: a little is added that vanishes with the error.
    MatX H = project_derivative(Z * point.y, Z);
    H.diagonal().array() += 1e-3 * std::min(1e-3, error / size) + kEpsilon;
    // The Newton step, halved until the function or its gradient becomes smaller.
    const VecX direction = -symmetric_solution(H, point.gradient);
    const double slope = point.gradient.dot(direction);
    double length = 1;
    const auto is_better = [&](const DualPoint& trial) {
      return trial.value <= point.value + 1e-4 * length * slope || trial.gradient.norm() <= 0.5 * error;
    };
    DualPoint trial = evaluate_dual(point.y + direction, Z, d);
    for (int halving = 0; halving < 30 && !is_better(trial); ++halving) {
      length *= 0.5;
      trial = evaluate_dual(point.y + length * direction, Z, d);
    }
    if (!is_better(trial)) break;
    point = std::move(trial);
  }
  return std::nullopt;
}

KnownModesSystem::DualPoint KnownModesSystem::evaluate_dual(const VecX& y, const MatX& Z,
                                                            const VecX& d) const {
  DualPoint point{y, project(Z * y), VecX(), 0.0};
  point.gradient = Z.transpose() * point.x - d;
  point.value = 0.5 * point.x.squaredNorm() - d.dot(y);
  return point;
}

}  // namespace rigor
