#include "rigor/solver/coulomb/alart_curnier.hpp"
#include "rigor/solver/coulomb/proximal_point.hpp"

namespace rigor {

using Eigen::Index;

namespace {

/// M v = Lᵀ λ(v) with λ(v) = P(λ⁰ - ρ (L v + b)).
class SearchByMotion {
 public:
  explicit SearchByMotion(const ProximalStart& from) : from_(from) {}

  /// A motion v with what the search along a line needs of it.
  struct Motion {
    VecX v;
    VecX rates;     ///< L v (3n).
    VecX momentum;  ///< M v.
  };

  /// Forces at a motion v, and what the contacts do there.
  struct Forces {
    VecX lambda;  ///< 3n.
    std::vector<ContactMode> modes;
    std::vector<Mat3> slopes;  ///< -dλ / dw, one per contact.
    VecX pulled;               ///< Lᵀ λ.
    VecX miss;                 ///< M v - Lᵀ λ.
    double error;              ///< Of the miss, in the metric of M⁻¹.
  };

  const ContactMotion& motion() const { return from_.motion; }
  Motion start() const { return motion_at(from_.v); }

  Forces miss_at(const Motion& motion) const {
    const VecX w = motion.rates + from_.laws.b;
    const std::size_t count = from_.laws.mu.size();
    Forces forces{VecX(w.size()), std::vector<ContactMode>(count), std::vector<Mat3>(count), {}, {}, 0};
    for (std::size_t k = 0; k < count; ++k) {
      const Index row = 3 * static_cast<Index>(k);
      const double rho = from_.rho * from_.masses(row / 3);
      const ProjectedForce projection =
          alart_curnier(from_.laws, k, from_.lambda.segment<3>(row) - rho * w.segment<3>(row));
      forces.lambda.segment<3>(row) = projection.force;
      forces.modes[k] = projection.mode;
      forces.slopes[k] = rho * projection.slope;
    }
    forces.pulled = from_.motion.pull(forces.lambda);
    forces.miss = motion.momentum - forces.pulled;
    forces.error = std::sqrt(std::max(0.0, forces.miss.dot(from_.motion.lift(forces.miss))));
    return forces;
  }

  Motion way_from(const Motion&, const Forces& forces) const {
    return motion_at(-from_.motion.newton_step(forces.slopes, forces.miss, Symmetry::none));
  }

  static Motion moved(const Motion& motion, double length, const Motion& way) {
    return {motion.v + length * way.v, motion.rates + length * way.rates,
            motion.momentum + length * way.momentum};
  }

  static const Forces& forces_of(const Motion&, const Forces& forces) { return forces; }

 private:
  Motion motion_at(VecX v) const {
    Motion motion{std::move(v), {}, {}};
    motion.rates = from_.motion.rates(motion.v);
    motion.momentum = from_.motion.weigh(motion.v);
    return motion;
  }

  const ProximalStart& from_;
};

}  // namespace

std::optional<ProximalPoint> proximal_point_by_motion(const ProximalStart& start) {
  constexpr int most_steps = 30, most_halvings = 12;
  return newton_point(SearchByMotion(start), most_steps, most_halvings);
}

}  // namespace rigor
