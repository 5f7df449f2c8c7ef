#include "rigor/solver/coulomb/alart_curnier.hpp"
#include "rigor/solver/coulomb/proximal_point.hpp"

#include <Eigen/LU>

namespace rigor {

using Eigen::Index;

namespace {

// Times 1 / the mean diagonal of a contact's block. With such a c the mode of a contact is seldom wrong,
// whatever ρ.
constexpr double kScale = 10;

/// λ = P(λ - c w) and M v = Lᵀ λ, with w = L v + b + (λ - λ⁰) / ρ.
class SearchByForces {
 public:
  explicit SearchByForces(const ProximalStart& from) : from_(from) {}

  /// A motion v and forces λ, with what the search along a line needs of them: all of it is linear.
  struct Place {
    VecX v;
    VecX rates;     ///< L v (3n).
    VecX momentum;  ///< M v.
    VecX lambda;    ///< 3n.
    VecX pulled;    ///< Lᵀ λ.
  };

  /// How a place misses the law.
  struct Miss {
    VecX F;  ///< λ - P(λ - c w) (3n).
    std::vector<ContactMode> modes;
    std::vector<Mat3> slopes;  ///< dP / dx, one per contact.
    double error = 0;          ///< Of F and of M v - Lᵀ λ.
  };

  const ContactMotion& motion() const { return from_.motion; }
  Place start() const { return place_at(from_.v, from_.lambda); }

  void measure(const Place& place, Miss& miss) const {
    const std::size_t count = from_.laws.mu.size();
    miss.F.resize(place.lambda.size());
    miss.modes.resize(count);
    miss.slopes.resize(count);
    const VecX momentum = place.momentum - place.pulled;
    double square = std::max(0.0, momentum.dot(from_.motion.lift(momentum)));
    for (std::size_t k = 0; k < count; ++k) {
      const Index row = 3 * static_cast<Index>(k);
      const double mass = from_.masses(row / 3);
      const Vec3 lambda = place.lambda.segment<3>(row);
      const Vec3 w = place.rates.segment<3>(row) + from_.laws.b.segment<3>(row) +
                     (lambda - from_.lambda.segment<3>(row)) / (from_.rho * mass);
      const ProjectedForce projection = alart_curnier(from_.laws, k, lambda - kScale * mass * w);
      miss.modes[k] = projection.mode;
      miss.slopes[k] = projection.slope;
      miss.F.segment<3>(row) = lambda - projection.force;
      square += miss.F.segment<3>(row).squaredNorm() / mass;
    }
    miss.error = std::sqrt(square);
  }

  /// With S = dP/dx, dF = 0 gives
  ///   (1 - (1 - c/ρ) S) dλ = -c S L dv - F,  so  dλ = -D L dv - r,
  /// and what is left is (M + Lᵀ D L) dv = Lᵀ (λ - r) - M v.
  Place way_from(const Place& place, const Miss& miss) const {
    std::vector<Mat3> D(miss.slopes.size(), Mat3::Zero());
    VecX r = miss.F;
    for (std::size_t k = 0; k < D.size(); ++k) {
      if (miss.modes[k] == ContactMode::open) continue;
      const Index row = 3 * static_cast<Index>(k);
      if (miss.modes[k] == ContactMode::stick) {
        // S = 1.
        D[k].diagonal().setConstant(from_.rho * from_.masses(row / 3));
        r.segment<3>(row) *= from_.rho / kScale;
        continue;
      }
      const Mat3& S = miss.slopes[k];
      const Mat3 inverse = Mat3(Mat3::Identity() - (1 - kScale / from_.rho) * S).inverse();
      D[k] = kScale * from_.masses(row / 3) * inverse * S;
      r.segment<3>(row) = inverse * miss.F.segment<3>(row);
    }
    const VecX wanted = place.pulled - from_.motion.pull(r) - place.momentum;
    VecX dv = from_.motion.newton_step(D, wanted, Symmetry::none);
    const VecX rates = from_.motion.rates(dv);
    VecX dlambda = -r;
    for (std::size_t k = 0; k < D.size(); ++k) {
      const Index row = 3 * static_cast<Index>(k);
      dlambda.segment<3>(row) -= D[k] * rates.segment<3>(row);
    }
    return place_at(std::move(dv), std::move(dlambda));
  }

  static void move(const Place& place, double length, const Place& way, Place& there) {
    there.v = place.v + length * way.v;
    there.rates = place.rates + length * way.rates;
    there.momentum = place.momentum + length * way.momentum;
    there.lambda = place.lambda + length * way.lambda;
    there.pulled = place.pulled + length * way.pulled;
  }

  static const Place& forces_of(const Place& place, const Miss&) { return place; }

 private:
  Place place_at(VecX v, VecX lambda) const {
    Place place{std::move(v), {}, {}, std::move(lambda), {}};
    place.rates = from_.motion.rates(place.v);
    place.momentum = from_.motion.weigh(place.v);
    place.pulled = from_.motion.pull(place.lambda);
    return place;
  }

  const ProximalStart& from_;
};

}  // namespace

std::optional<ProximalPoint> proximal_point_by_forces(const ProximalStart& start) {
  constexpr int most_steps = 20, most_halvings = 6;
  return newton_point(SearchByForces(start), start.share, most_steps, most_halvings);
}

}  // namespace rigor
