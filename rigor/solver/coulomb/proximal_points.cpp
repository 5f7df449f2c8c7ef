#include "rigor/solver/coulomb/proximal_points.hpp"

#include "rigor/core/interrupt.hpp"
#include "rigor/solver/coulomb/coulomb_law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace rigor {

using Eigen::Index;

namespace {

// Times 1 / the mean diagonal of a contact's block. Longer steps multiply the rounding of the motion into the
// forces.
constexpr double kFirstRho = 10;
constexpr double kLargestPointRho = 1e4;
constexpr double kGrowth = 10;
// What the contacts do is first asked of λ - c w with this c, whatever ρ: the mode of a contact is seldom
// wrong then, and a point begins where the last one ended. Where Newton's method gets nowhere so, c is ρ.
constexpr double kBoldScale = 10;
constexpr double kBoldRho = 1e3;
// Where points come no nearer than by this share, contacts jam: forces that do nothing have to grow far
// before they show whether the contacts contradict each other. Longer steps get there sooner, and their
// rounding is still below what counts as solved.
constexpr double kSlow = 0.3;
constexpr double kLargestSlowRho = 1e6;

class ProximalPoints {
 public:
  ProximalPoints(const CoulombProblem& laws, const ContactMotion& motion,
                 const std::function<double(const VecX&)>& size_of, const ProximalPointOptions& options)
      : laws_(laws),
        motion_(motion),
        size_of_(size_of),
        options_(options),
        masses_(effective_masses(motion.diagonal())),
        rho_(options.is_bold ? kBoldRho : kFirstRho),
        is_bold_(options.is_bold) {
    const Index count = static_cast<Index>(laws.mu.size());
    lambda_ = options.start.size() > 0 ? clamp_to_cones(laws, options.start) : VecX::Zero(3 * count);
    v_ = motion_.lift(motion_.pull(lambda_));
  }

  std::optional<CoulombSolution> run() {
    constexpr int kMaxPoints = 60, kPatience = 3;
    double growth = kGrowth;
    int stalls = 0, failures = 0;
    for (int point = 1; point <= kMaxPoints; ++point) {
      poll_interrupt();
      const std::optional<Point> next = next_point();
      if (next) {
        // How well its forces solve the law with b, and with the b' that the point has.
        const Offer offer = offer_of(*next);
        const bool is_slow = !(offer.residual < std::max(kSlow * least(), options_.enough));
        stalls = offer.residual < 0.5 * least() ? 0 : stalls + 1;
        failures = 0;
        keep(offer, point);
        if (best_->residual <= options_.wanted) return solution_of(*best_, best_->residual);

        // The next point, with a longer step; where rounding held this one back, with a shorter one.
        lambda_ = next->lambda;
        v_ = motion_.lift(motion_.pull(lambda_));
        const double largest = is_slow ? kLargestSlowRho : kLargestPointRho;
        if (next->is_rounded)
          rho_ = std::max(rho_ / growth, kFirstRho);
        else if (rho_ < largest)
          rho_ = std::min(growth * rho_, largest);
      } else if (is_bold_) {
        // Newton's method goes to and fro between modes: nearer points, with c = ρ.
        is_bold_ = false;
        rho_ = std::min(rho_, kFirstRho);
      } else {
        // Too far for Newton's method: nearer points, and smaller steps from then on.
        ++failures;
        rho_ /= growth * growth;
        growth = std::max(1.5, std::sqrt(growth));
      }

      // The search ends when it gets no farther from what counts as solved.
      if (stalls + failures > 0 && best_ && best_->residual <= options_.enough)
        return solution_of(*best_, best_->residual);
      if (stalls >= kPatience && nearest_) return solution_of(*nearest_, nearest_->changed_residual);
    }
    if (!options_.gives_best || !best_) return std::nullopt;
    return solution_of(*best_, best_->residual);
  }

 private:
  struct Point {
    VecX lambda;
    std::vector<ContactMode> modes;
    bool is_rounded;  ///< Rounding, times ρ, kept Newton's method from its tolerance.
  };

  std::optional<Point> next_point() const { return is_bold_ ? point_by_forces() : point_by_motion(); }

  // Newton's method for motion and forces, with a moderate c.

  /// A motion v and forces λ, with what the search along a line needs of them: all of it is linear.
  struct Place {
    VecX v;
    VecX rates;     ///< L v (3n).
    VecX momentum;  ///< M v.
    VecX lambda;    ///< 3n.
    VecX pulled;    ///< Lᵀ λ.
  };

  Place place_at(VecX v, VecX lambda) const {
    Place place{std::move(v), {}, {}, std::move(lambda), {}};
    place.rates = motion_.rates(place.v);
    place.momentum = motion_.weigh(place.v);
    place.pulled = motion_.pull(place.lambda);
    return place;
  }

  static Place moved(const Place& place, double length, const Place& way) {
    return {place.v + length * way.v, place.rates + length * way.rates,
            place.momentum + length * way.momentum, place.lambda + length * way.lambda,
            place.pulled + length * way.pulled};
  }

  /// How forces and motion miss the law: F = λ - P(λ - c w') (3n), w' = L v + b + (λ - λ⁰) / ρ.
  struct Miss {
    VecX F;
    std::vector<ContactMode> modes;
    double error;  ///< Of F and of M v - Lᵀ λ, in the metric of the masses.
  };

  Miss miss_at(const Place& place) const {
    const std::size_t count = laws_.mu.size();
    Miss miss{VecX(place.lambda.size()), std::vector<ContactMode>(count), 0};
    const VecX momentum = place.momentum - place.pulled;
    double square = std::max(0.0, momentum.dot(motion_.lift(momentum)));
    for (std::size_t k = 0; k < count; ++k) {
      const Index row = 3 * static_cast<Index>(k);
      const Vec3 x = asked_of(k, place);
      miss.modes[k] = mode_of(k, x);
      miss.F.segment<3>(row) = place.lambda.segment<3>(row) - projected(k, miss.modes[k], x);
      square += miss.F.segment<3>(row).squaredNorm() / masses_(row / 3);
    }
    miss.error = std::sqrt(square);
    return miss;
  }

  /// x = λ - c w', which shows what contact k does.
  Vec3 asked_of(std::size_t k, const Place& place) const {
    const Index row = 3 * static_cast<Index>(k);
    const double mass = masses_(row / 3);
    const Vec3 lambda = place.lambda.segment<3>(row);
    const Vec3 w = place.rates.segment<3>(row) + laws_.b.segment<3>(row) +
                   (lambda - lambda_.segment<3>(row)) / (rho_ * mass);
    return lambda - kBoldScale * mass * w;
  }

  // Alart and Curnier's functions: open, stick inside the disk of radius μ x_n, slide on its border.
  ContactMode mode_of(std::size_t k, const Vec3& x) const {
    if (!(x.z() > 0)) return ContactMode::open;
    const double mu = laws_.mu[k];
    const bool sticks = laws_.rows[k] == FrictionRow::cone && mu > 0 && x.head<2>().norm() <= mu * x.z();
    return sticks ? ContactMode::stick : ContactMode::slide;
  }

  bool has_free_slip(std::size_t k) const { return laws_.rows[k] == FrictionRow::cone; }

  /// Direction of the friction of a sliding contact.
  Vec2 friction_direction(std::size_t k, const Vec3& x) const {
    return has_free_slip(k) ? Vec2(x.head<2>().normalized()) : Vec2(-laws_.slips[k]);
  }

  /// P(x).
  Vec3 projected(std::size_t k, ContactMode mode, const Vec3& x) const {
    if (mode == ContactMode::open) return Vec3::Zero();
    if (mode == ContactMode::stick) return x;
    Vec3 force(0, 0, x.z());
    if (laws_.mu[k] > 0) force.head<2>() = laws_.mu[k] * x.z() * friction_direction(k, x);
    return force;
  }

  /// dP / dx.
  Mat3 slope_of(std::size_t k, ContactMode mode, const Vec3& x) const {
    if (mode == ContactMode::open) return Mat3::Zero();
    if (mode == ContactMode::stick) return Mat3::Identity();
    Mat3 slope = Mat3::Zero();
    slope(2, 2) = 1;
    if (laws_.mu[k] == 0) return slope;
    const Vec2 along = friction_direction(k, x), across(-along.y(), along.x());
    slope.topRightCorner<2, 1>() = laws_.mu[k] * along;
    if (has_free_slip(k))
      slope.topLeftCorner<2, 2>() = laws_.mu[k] * x.z() / x.head<2>().norm() * across * across.transpose();
    return slope;
  }

  /// Newton's direction for F = 0 and M v = Lᵀ λ. With S = dP/dx, dF = 0 gives
  ///   (1 - (1 - c/ρ) S) dλ = -c S L dv - F,  so  dλ = -D L dv - r,
  /// and what is left is (M + Lᵀ D L) dv = Lᵀ (λ - r) - M v.
  Place direction_from(const Place& place, const Miss& miss) const {
    std::vector<Mat3> D(laws_.mu.size(), Mat3::Zero());
    VecX r = miss.F;
    constexpr double c = kBoldScale;
    for (std::size_t k = 0; k < D.size(); ++k) {
      if (miss.modes[k] == ContactMode::open) continue;
      const Index row = 3 * static_cast<Index>(k);
      const Mat3 S = slope_of(k, miss.modes[k], asked_of(k, place));
      const Mat3 inverse = Mat3(Mat3::Identity() - (1 - c / rho_) * S).inverse();
      D[k] = c * masses_(row / 3) * inverse * S;
      r.segment<3>(row) = inverse * miss.F.segment<3>(row);
    }
    const VecX wanted = place.pulled - motion_.pull(r) - place.momentum;
    VecX dv = motion_.newton_step(D, wanted, Symmetry::none);
    const VecX rates = motion_.rates(dv);
    VecX dlambda = -r;
    for (std::size_t k = 0; k < D.size(); ++k) {
      const Index row = 3 * static_cast<Index>(k);
      dlambda.segment<3>(row) -= D[k] * rates.segment<3>(row);
    }
    return place_at(std::move(dv), std::move(dlambda));
  }

  /// Solves the law of contacts that give way from v_ and λ⁰; nothing where the search along Newton's
  /// direction stops.
  std::optional<Point> point_by_forces() const {
    constexpr int most_steps = 20, most_halvings = 6;
    constexpr double kDecrease = 1e-4;
    // Below kRounding of its terms the miss is their rounding, times ρ. It need not be smaller than a share
    // of what the point moves: that share is what the points lose of their speed of convergence.
    constexpr double kRounding = 1e-12, kStuck = 1e-9, kShare = 1e-3;
    const Place start = place_at(v_, lambda_);
    Place place = start;
    Miss miss = miss_at(place);
    for (int step = 0; step < most_steps; ++step) {
      const double size =
          std::sqrt(place.pulled.dot(motion_.lift(place.pulled))) + std::sqrt(place.v.dot(place.momentum));
      const double moved_by =
          std::sqrt(std::max(0.0, (place.v - start.v).dot(place.momentum - start.momentum)));
      if (miss.error <= std::max(kRounding * size, kShare * moved_by))
        return Point{std::move(place.lambda), std::move(miss.modes), false};

      // Newton's direction, and halving until the error falls in proportion to the step.
      const Place way = direction_from(place, miss);
      if (!way.v.allFinite()) return std::nullopt;
      double length = 1;
      Place there = moved(place, length, way);
      Miss trial = miss_at(there);
      for (int k = 0; k < most_halvings && !(trial.error <= (1 - kDecrease * length) * miss.error); ++k) {
        length *= 0.5;
        there = moved(place, length, way);
        trial = miss_at(there);
      }
      if (!(trial.error < miss.error)) {
        if (!(miss.error <= kStuck * size)) return std::nullopt;
        return Point{std::move(place.lambda), std::move(miss.modes), true};
      }
      place = std::move(there);
      miss = std::move(trial);
    }
    return std::nullopt;
  }

  // Newton's method for the motion alone, of which c = ρ makes the forces a function.

  /// A motion v with what the search along a line needs of it.
  struct Motion {
    VecX v;
    VecX rates;     ///< L v (3n).
    VecX momentum;  ///< M v.
  };

  Motion motion_at(VecX v) const {
    Motion motion{std::move(v), {}, {}};
    motion.rates = motion_.rates(motion.v);
    motion.momentum = motion_.weigh(motion.v);
    return motion;
  }

  static Motion moved(const Motion& motion, double length, const Motion& direction) {
    return {motion.v + length * direction.v, motion.rates + length * direction.rates,
            motion.momentum + length * direction.momentum};
  }

  /// Forces at a motion v, and what the contacts do there.
  struct Forces {
    VecX lambda;  ///< 3n.
    std::vector<ContactMode> modes;
    std::vector<Mat3> slopes;  ///< -dλ / dw, one per contact.
    VecX pulled;               ///< Lᵀ λ.
    VecX miss;                 ///< M v - Lᵀ λ.
    double error;              ///< Of the miss, in the metric of M⁻¹.
  };

  Forces forces_at(const Motion& motion) const {
    const VecX w = motion.rates + laws_.b;
    const std::size_t count = laws_.mu.size();
    Forces forces{VecX(w.size()),
                  std::vector<ContactMode>(count, ContactMode::open),
                  std::vector<Mat3>(count, Mat3::Zero()),
                  {},
                  {},
                  0};
    for (std::size_t k = 0; k < count; ++k) set_force(k, w, forces);
    forces.pulled = motion_.pull(forces.lambda);
    forces.miss = motion.momentum - forces.pulled;
    forces.error = std::sqrt(std::max(0.0, forces.miss.dot(motion_.lift(forces.miss))));
    return forces;
  }

  void set_force(std::size_t k, const VecX& w, Forces& forces) const {
    const Index row = 3 * static_cast<Index>(k);
    const double rho = rho_ * masses_(row / 3), mu = laws_.mu[k];
    const Vec3 x = lambda_.segment<3>(row) - rho * w.segment<3>(row);
    forces.lambda.segment<3>(row).setZero();
    // Alart and Curnier's functions: open, stick inside the disk of radius μ x_n, slide on its border.
    if (!(x.z() > 0)) return;
    Mat3& slope = forces.slopes[k];
    const double radius = mu * x.z(), length = x.head<2>().norm();
    if (laws_.rows[k] == FrictionRow::cone && length <= radius && mu > 0) {
      forces.lambda.segment<3>(row) = x;
      forces.modes[k] = ContactMode::stick;
      slope = rho * Mat3::Identity();
      return;
    }
    forces.modes[k] = ContactMode::slide;
    forces.lambda(row + 2) = x.z();
    slope(2, 2) = rho;
    if (mu == 0) return;
    const bool has_free_slip = laws_.rows[k] == FrictionRow::cone;
    const Vec2 along = has_free_slip ? Vec2(x.head<2>() / length) : Vec2(-laws_.slips[k]);
    forces.lambda.segment<2>(row) = radius * along;
    slope.topRightCorner<2, 1>() = mu * rho * along;
    if (!has_free_slip) return;
    const Vec2 across(-along.y(), along.x());
    slope.topLeftCorner<2, 2>() = (rho * radius / length) * across * across.transpose();
  }

  /// Solves M v = Lᵀ λ(v) from v_; nothing where the search along Newton's direction stops.
  std::optional<Point> point_by_motion() const {
    constexpr int kMaxSteps = 30, kMaxHalvings = 12;
    constexpr double kDecrease = 1e-4;
    // Below kRounding of its terms the miss is their rounding, times ρ. It need not be smaller than a share
    // of what the point moves: that share is what the points lose of their speed of convergence.
    constexpr double kRounding = 1e-12, kStuck = 1e-9, kShare = 1e-3;
    const Motion start = motion_at(v_);
    Motion motion = start;
    Forces at = forces_at(motion);
    for (int step = 0; step < kMaxSteps; ++step) {
      const double size =
          std::sqrt(at.pulled.dot(motion_.lift(at.pulled))) + std::sqrt(motion.v.dot(motion.momentum));
      const Motion way = moved(motion, -1, start);
      const double way_size = std::sqrt(std::max(0.0, way.v.dot(way.momentum)));
      if (at.error <= std::max(kRounding * size, kShare * way_size))
        return Point{std::move(at.lambda), std::move(at.modes), false};

      // Newton's direction, and halving until the error falls in proportion to the step.
      const Motion direction = motion_at(-motion_.newton_step(at.slopes, at.miss, Symmetry::none));
      if (!direction.v.allFinite()) return std::nullopt;
      double length = 1;
      Motion there = moved(motion, length, direction);
      Forces trial = forces_at(there);
      for (int k = 0; k < kMaxHalvings && !(trial.error <= (1 - kDecrease * length) * at.error); ++k) {
        length *= 0.5;
        there = moved(motion, length, direction);
        trial = forces_at(there);
      }
      if (!(trial.error < at.error)) {
        if (!(at.error <= kStuck * size)) return std::nullopt;
        return Point{std::move(at.lambda), std::move(at.modes), true};
      }
      motion = std::move(there);
      at = std::move(trial);
    }
    return std::nullopt;
  }

  /// Forces as an answer to the problem.
  struct Offer {
    VecX lambda, w;
    std::vector<ContactMode> modes;
    double residual;          ///< Of the law.
    double change;            ///< Largest of b' - b.
    double changed_residual;  ///< Of the law with b'.
    int point = 0;            ///< After how many points.
  };

  Offer offer_of(const Point& point) const {
    Offer offer{clamp_to_cones(laws_, point.lambda), {}, point.modes, 0, 0, 0};
    offer.w = motion_.rates(motion_.lift(motion_.pull(offer.lambda))) + laws_.b;
    const double size = size_of_(offer.lambda);
    offer.residual = law_residual(laws_, motion_.diagonal(), size, offer.lambda, offer.w);
    VecX change = offer.lambda - lambda_;
    for (Index i = 0; i < masses_.size(); ++i) change.segment<3>(3 * i) /= rho_ * masses_(i);
    offer.change = change.cwiseAbs().maxCoeff();
    offer.changed_residual = law_residual(laws_, motion_.diagonal(), size, offer.lambda, offer.w + change);
    return offer;
  }

  double least() const { return best_ ? best_->residual : std::numeric_limits<double>::infinity(); }

  /// Keeps the offer if it is the best so far, of the law with b or of that with b'.
  void keep(Offer offer, int point) {
    offer.point = point;
    const bool is_near = offer.change <= options_.resolution && offer.changed_residual <= options_.enough;
    if (is_near && (!nearest_ || offer.change < nearest_->change)) nearest_ = offer;
    if (offer.residual < least()) best_ = std::move(offer);
  }

  CoulombSolution solution_of(const Offer& offer, double residual) const {
    return {offer.lambda,     offer.w, offer.modes, residual, offer.point, residual <= options_.enough,
            "proximal points"};
  }

  const CoulombProblem& laws_;
  const ContactMotion& motion_;
  const std::function<double(const VecX&)>& size_of_;
  const ProximalPointOptions& options_;
  VecX masses_;  ///< effective_masses: n.
  VecX lambda_;  ///< λ⁰.
  VecX v_;       ///< M⁻¹ Lᵀ λ⁰.
  double rho_;
  bool is_bold_;                  ///< Whether c is kBoldScale; else it is ρ.
  std::optional<Offer> best_;     ///< Of the least residual.
  std::optional<Offer> nearest_;  ///< Of those that solve the law with a b' within the resolution.
};

}  // namespace

std::optional<CoulombSolution> solve_by_proximal_points(const CoulombProblem& laws,
                                                        const ContactMotion& motion,
                                                        const std::function<double(const VecX&)>& size_of,
                                                        const ProximalPointOptions& options) {
  return ProximalPoints(laws, motion, size_of, options).run();
}

}  // namespace rigor
