#include "rigor/geometry/mass/point_sampling.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/math/splitmix64.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {

namespace {

/// Integrals of 1 | x y z | xx yy zz | xy yz zx over the solid, in units of the box: p = center + size ∘ u, u
/// in [-1/2, 1/2].
using Moments = Eigen::Matrix<double, 10, 1>;
using Covariance = Eigen::Matrix<double, 10, 10>;

Moments monomials(const Vec3& u) {
  Moments m;
  m << 1, u, u.cwiseAbs2(), u[0] * u[1], u[1] * u[2], u[2] * u[0];
  return m;
}

/// Estimated moments, and the covariance of the estimates.
struct Estimate {
  Moments moments = Moments::Zero();
  Covariance covariance = Covariance::Zero();
};

/// Adds one cell of `weight` (its part of the box): the mean of the points' contributions, and the variance
/// of that mean.
class CellSum {
 public:
  void add_point(const Moments& m) {
    ++inside_;
    sum_ += m;
    squares_.selfadjointView<Eigen::Lower>().rankUpdate(m);
  }
  void add_to(Estimate& estimate, double weight, int points) {
    if (inside_ == 0) return;
    // The mean of the contributions of all points, those outside being zero; of its variance the sum of
    // squares less n times the square of the mean, over n (n - 1).
    const double n = points;
    estimate.moments += (weight / n) * sum_;
    squares_.selfadjointView<Eigen::Lower>().rankUpdate(sum_, -1 / n);
    estimate.covariance.triangularView<Eigen::Lower>() += (weight * weight / (n * (n - 1))) * squares_;
    *this = {};
  }

 private:
  int inside_ = 0;
  Moments sum_ = Moments::Zero();
  Covariance squares_ = Covariance::Zero();
};

Estimate sampled_moments(const std::function<bool(const Vec3&)>& inside, const Aabb& box,
                         const SamplingOptions& options) {
  // Stratified sampling: in each cell of the grid some points at random places.
  const Vec3 center = 0.5 * (box.lower + box.upper), size = box.upper - box.lower;
  const int n = options.cells;
  const double width = 1.0 / n;
  SplitMix64 random(options.seed);
  Estimate estimate;
  CellSum cell;
  for (int z = 0; z < n; ++z) {
    poll_interrupt();
    for (int y = 0; y < n; ++y) {
      for (int x = 0; x < n; ++x) {
        for (int k = 0; k < options.points_per_cell; ++k) {
          const double jx = random.uniform(), jy = random.uniform(), jz = random.uniform();
          const Vec3 u = width * Vec3(x + jx, y + jy, z + jz) - Vec3::Constant(0.5);
          if (inside(center + size.cwiseProduct(u))) cell.add_point(monomials(u));
        }
        cell.add_to(estimate, width * width * width, options.points_per_cell);
      }
    }
  }
  // Only the lower half was summed.
  estimate.covariance = Covariance(estimate.covariance.selfadjointView<Eigen::Lower>());
  return estimate;
}

/// The same moments and covariance in the units of the box's frame, from its centre.
Estimate scaled(const Estimate& unit, const Vec3& size) {
  // Each moment scales with the volume of the box and the lengths of its monomial.
  const double volume = size.prod();
  Moments factors;
  factors << 1, size, size.cwiseAbs2(), size[0] * size[1], size[1] * size[2], size[2] * size[0];
  factors *= volume;
  return {factors.cwiseProduct(unit.moments), factors.asDiagonal() * unit.covariance * factors.asDiagonal()};
}

double deviation(const Moments& gradient, const Covariance& covariance) {
  return std::sqrt(std::max(0.0, gradient.dot(covariance * gradient)));
}

/// Index of the second moment of axes i and j.
int second(int i, int j) {
  return i == j ? 4 + i : (i + j == 1 ? 7 : (i + j == 3 ? 8 : 9));
}

/// Gradient of ∫ (p - c)_i (p - c)_j with respect to the moments. The centre c may be held fixed: the
/// derivative with respect to it vanishes there.
Moments central_gradient(int i, int j, const Vec3& c) {
  Moments g = Moments::Zero();
  g[second(i, j)] += 1;
  g[1 + i] -= c[j];
  g[1 + j] -= c[i];
  g[0] += c[i] * c[j];
  return g;
}

Moments inertia_gradient(int i, int j, const Vec3& c) {
  if (i != j) return -central_gradient(i, j, c);
  return central_gradient((i + 1) % 3, (i + 1) % 3, c) + central_gradient((i + 2) % 3, (i + 2) % 3, c);
}

double relative_bound(const SampledMassProperties& s, double density) {
  const MassProperties& p = s.properties;
  const double size = std::sqrt(p.inertia.trace() / p.mass);
  return 3 * std::max({s.volume_deviation * density / p.mass, s.center_deviation.maxCoeff() / size,
                       s.inertia_deviation.maxCoeff() / p.inertia.trace()});
}

}  // namespace

SampledMassProperties sampled_mass_properties(const std::function<bool(const Vec3&)>& inside, const Aabb& box,
                                              double density, const SamplingOptions& options) {
  RIGOR_ASSERT(options.cells >= 1 && options.points_per_cell >= 2);
  const Estimate estimate = scaled(sampled_moments(inside, box, options), box.upper - box.lower);
  const Moments& m = estimate.moments;

  SampledMassProperties result;
  // The volume is a moment itself; a box without a point inside says nothing more.
  result.volume = m[0];
  result.volume_deviation = std::sqrt(estimate.covariance(0, 0));
  if (!(m[0] > 0)) {
    result.properties.error_bound = std::numeric_limits<double>::infinity();
    return result;
  }

  // Centre and inertia are functions of the moments: their deviations follow from their gradients and the
  // covariance.
  const Vec3 c = m.segment<3>(1) / m[0];
  result.properties.mass = density * m[0];
  result.properties.center = 0.5 * (box.lower + box.upper) + c;
  for (int i = 0; i < 3; ++i) {
    Moments center_gradient = Moments::Unit(1 + i) - c[i] * Moments::Unit(0);
    result.center_deviation[i] = deviation(center_gradient / m[0], estimate.covariance);
    for (int j = 0; j < 3; ++j) {
      const Moments gradient = inertia_gradient(i, j, c);
      result.properties.inertia(i, j) = density * gradient.dot(m);
      result.inertia_deviation(i, j) = density * deviation(gradient, estimate.covariance);
    }
  }
  result.properties.error_bound = relative_bound(result, density);
  return result;
}

}  // namespace rigor
