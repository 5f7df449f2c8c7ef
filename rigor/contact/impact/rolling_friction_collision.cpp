#include "rigor/contact/impact/rolling_friction_collision.hpp"

#include "rigor/contact/impact/restitution_watch.hpp"
#include "rigor/core/assert.hpp"
#include "rigor/math/dense.hpp"
#include "rigor/math/roots.hpp"
#include "rigor/solver/runge_kutta.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rigor {

namespace {

// The state of an impact as one vector: velocities (6), work, impulses (6).
constexpr Eigen::Index work_row = 6, impulse_row = 7, row_count = 13;
constexpr double path_tolerance = 1e-12;

/// One of the three frictions.
struct Friction {
  enum class Mode {
    moves,   ///< Greatest friction against the motion.
    rests,   ///< Held with less.
    starts,  ///< Greatest friction against `start`, the unit direction in which it will move.
  };
  Eigen::Index row, size;  ///< Its components of velocity and impulse.
  double limit;            ///< Per unit of normal impulse.
  Mode mode = Mode::moves;
  VecX start = {};

  VecX part(const VecX& six) const { return six.segment(row, size); }
  void set(const VecX& value, VecX& six) const { six.segment(row, size) = value; }
  void clear(VecX& six) const { six.segment(row, size).setZero(); }
};
using Mode = Friction::Mode;

ImpactState impact_state(const VecX& y, double p) {
  return {y.head<3>(), y.segment<3>(impulse_row), p, y[work_row]};
}

/// One step of the integrator. z is the share of it.
class RungeKuttaPiece final : public ImpactPiece {
 public:
  RungeKuttaPiece(RungeKuttaStep step, double p, double h) : step_(std::move(step)), p_(p), h_(h) {
    end_ = 1;
  }

  NormalMotion normal(double z) const override {
    double u_n = 0, work = 0, slope = 0;
    for (Eigen::Index k = step_.dense.cols(); k-- > 0;) {
      if (k > 0) slope = slope * z + static_cast<double>(k) * step_.dense(2, k);
      u_n = u_n * z + step_.dense(2, k);
      work = work * z + step_.dense(work_row, k);
    }
    return {p_ + z * h_, u_n, work, h_, slope / h_};
  }
  ImpactState state(double z) const override { return impact_state(step_.at(z), p_ + z * h_); }
  Vec2 direction(double z) const override { return step_.at(z).head<2>().normalized(); }

  const RungeKuttaStep& step() const { return step_; }

 private:
  RungeKuttaStep step_;
  double p_, h_;
};

class RollingFrictionImpactPath {
 public:
  RollingFrictionImpactPath(const RollingFrictionCollision& collision, RestitutionLaw law)
      : K_(collision.K),
        y_(VecX::Zero(row_count)),
        watch_(law, collision.restitution, {collision.u, Vec3::Zero(), 0, 0}) {
    y_.head<3>() = collision.u;
    y_.segment<3>(3) = collision.w;
    for (const Friction& friction : {Friction{0, 2, collision.mu}, Friction{3, 2, collision.rolling_friction},
                                     Friction{5, 1, collision.torsional_friction}}) {
      if (friction.limit > 0) frictions_.push_back(friction);
    }
    // An angular velocity counts as the velocity that has the same energy.
    const double arm = std::sqrt(K_.topLeftCorner<3, 3>().trace() / K_.bottomRightCorner<3, 3>().trace());
    scale_ = VecX::Ones(row_count) * std::max(collision.u.norm(), arm * collision.w.norm());
    scale_.segment<3>(3) /= std::isfinite(arm) && arm > 0 ? arm : 1;
    p_scale_ = scale_[0] / K_(2, 2);
    scale_[work_row] *= p_scale_;
    scale_.tail<6>().setConstant(p_scale_);
    scale_.tail<3>() *= std::isfinite(arm) && arm > 0 ? arm : 1;
  }

  /// False if the steps are used up before the law ends the impact.
  bool run() {
    constexpr int most_steps = 100000;
    decide();
    double h = 0.1 * p_scale_;
    for (int k = 0; k < most_steps; ++k) {
      h = std::min(h, longest_step());
      // A step of Dormand and Prince's method; too large an error means another with a smaller h.
      const RungeKuttaStep step = runge_kutta_step(tableau(), rate_function(), p_, y_, h);
      const double error = (step.error.cwiseAbs().cwiseQuotient(scale_)).maxCoeff() / path_tolerance;
      if (error > 1 && h > 1e-15 * p_scale_) {
        h *= std::max(0.2, 0.9 * std::pow(error, -0.2));
        continue;
      }

      // The step is good: the impact ends in it, or continues with the h that the error allows.
      if (follow(RungeKuttaPiece(step, p_, h), h)) return true;
      h *= std::min(5.0, 0.9 * std::pow(std::max(error, 1e-10), -0.2));
    }
    return false;
  }

  RollingFrictionOutcome outcome(const RollingFrictionCollision& collision) const {
    RollingFrictionOutcome outcome{
        y_.head<3>(), y_.segment<3>(3), y_.segment<3>(impulse_row), y_.tail<3>(), 0, true};
    outcome.energy_change =
        0.5 * (outcome.lambda.dot(collision.u + outcome.u) + outcome.moment.dot(collision.w + outcome.w));
    return outcome;
  }

 private:
  static const ButcherTableau& tableau() {
    static const ButcherTableau dopri5 = dopri5_tableau();
    return dopri5;
  }
  OdeFunction rate_function() const {
    return [this](double, const VecX& y) { return rate(y); };
  }

  /// Slower counts as rest: above the errors of steps.
  double still(const Friction& friction) const { return 100 * path_tolerance * scale_[friction.row]; }

  /// Impulses per unit of normal impulse: greatest friction against what moves, what holds the others at
  /// rest.
  VecX impulse_rate(const VecX& y) const {
    VecX f = VecX::Zero(6);
    f[2] = 1;
    std::vector<Eigen::Index> held;
    for (const Friction& friction : frictions_) {
      if (friction.mode == Mode::rests) {
        for (Eigen::Index i = 0; i < friction.size; ++i) held.push_back(friction.row + i);
        continue;
      }
      const VecX v = friction.part(y);
      const bool has_direction = friction.mode == Mode::moves && !v.isZero(0);
      friction.set(-friction.limit * (has_direction ? VecX(v.normalized()) : friction.start), f);
    }
    if (held.empty()) return f;
    const MatX K = K_;
    const VecX hold = least_norm_solution(K(held, held), -VecX((K * f)(held)));
    for (std::size_t i = 0; i < held.size(); ++i) f[held[i]] = hold[static_cast<Eigen::Index>(i)];
    return f;
  }

  VecX rate(const VecX& y) const {
    const VecX f = impulse_rate(y);
    VecX result(row_count);
    result << K_ * f, y[2], f;
    return result;
  }

  /// Whether what does not move stays at rest or starts: the friction of least energy rate ½ fᵀ K f within
  /// its limits.
  void decide() {
    // The frictions whose motion has come to rest.
    std::vector<Friction*> resting;
    for (Friction& friction : frictions_) {
      if (friction.mode == Mode::moves && friction.part(y_).norm() > still(friction)) continue;
      friction.clear(y_);
      friction.mode = Mode::starts;
      friction.start = VecX::Zero(friction.size);
      resting.push_back(&friction);
    }

    // Projected Gauss-Seidel on the convex problem min ½ fᵀ K f within their limits.
    VecX f = impulse_rate(y_);
    constexpr int most_sweeps = 100000;
    for (int sweep = 0; sweep < most_sweeps && !resting.empty(); ++sweep) {
      double change = 0;
      for (const Friction* const friction : resting) {
        const Eigen::Index row = friction->row, size = friction->size;
        const VecX before = friction->part(f);
        VecX next = before - friction->part(K_ * f) / K_.block(row, row, size, size).trace();
        if (next.norm() > friction->limit) next *= friction->limit / next.norm();
        change = std::max(change, (next - before).norm() / friction->limit);
        friction->set(next, f);
      }
      if (change <= 1e-15) break;
    }

    // Friction below its limit holds at rest; at its limit the motion starts against it.
    constexpr double below_limit = 1 - 1e-9;
    for (Friction* const friction : resting) {
      const VecX held = friction->part(f);
      if (held.norm() < friction->limit * below_limit) {
        friction->mode = Mode::rests;
      } else {
        friction->start = -held.normalized();
      }
    }
  }

  /// Nearly to where the next friction would stop.
  double longest_step() const {
    double h = 10 * p_scale_;
    const VecX acceleration = K_ * impulse_rate(y_);
    for (const Friction& friction : frictions_) {
      const VecX v = friction.part(y_);
      const double slowing = -v.dot(friction.part(acceleration));
      if (friction.mode == Mode::moves && slowing > 0) h = std::min(h, 0.9 * v.squaredNorm() / slowing);
    }
    return std::max(h, 1e-16 * p_scale_);
  }

  /// By how much the friction at rest that is nearest to its limit stays below it, over the limit.
  double least_margin(const VecX& y) const {
    const VecX f = impulse_rate(y);
    double margin = 1;
    for (const Friction& friction : frictions_) {
      if (friction.mode == Mode::rests)
        margin = std::min(margin, 1 + 1e-10 - friction.part(f).norm() / friction.limit);
    }
    return margin;
  }

  /// Returns whether the impact ends in this step; else goes to its end, or to where something at rest
  /// starts.
  bool follow(const RungeKuttaPiece& piece, double h) {
    // The step is cut where a friction at rest comes to its limit.
    double z_end = 1;
    if (least_margin(piece.step().end) < 0) {
      const auto margin = [&](double z) { return least_margin(piece.step().at(z)); };
      if (margin(0) > 0 && margin(1) < 0) z_end = find_root_itp(margin, 0, 1, 1e-14).hi;
    }

    // The watch needs pieces on which u_n is monotone: cuts at the root of its rate.
    PiecePoint a{0, piece.normal(0)};
    std::vector<double> cuts;
    const auto normal_rate = [&](double z) { return piece.normal(z).rate; };
    if (normal_rate(0) * normal_rate(z_end) < 0)
      cuts.push_back(find_root_itp(normal_rate, 0, z_end, 0).best());
    cuts.push_back(z_end);
    for (const double cut : cuts) {
      const PiecePoint b{cut, piece.normal(cut)};
      if (const std::optional<double> end = watch_.follow(piece, a, b)) {
        go(*end * h);
        ImpactState state = impact_state(y_, p_);
        watch_.set_end(state);
        y_[2] = state.u.z();
        return true;
      }
      a = b;
    }

    // No end: what has stopped or started in this step decides anew.
    go(z_end * h);
    bool changes = z_end < 1;
    for (Friction& friction : frictions_) {
      const double speed = friction.part(y_).norm();
      constexpr double clearly = 10;
      if (friction.mode == Mode::starts && speed > clearly * still(friction)) friction.mode = Mode::moves;
      if (friction.mode == Mode::moves && speed <= still(friction)) changes = true;
    }
    if (changes) decide();
    return false;
  }

  void go(double h) {
    if (h == 0) return;
    y_ = runge_kutta_end(tableau(), rate_function(), p_, y_, h).end;
    p_ += h;
    for (const Friction& friction : frictions_) {
      if (friction.mode == Mode::rests) friction.clear(y_);
    }
  }

  Mat6 K_;
  VecX y_;
  double p_ = 0;
  RestitutionWatch watch_;
  std::vector<Friction> frictions_;
  VecX scale_;
  double p_scale_ = 0;
};

}  // namespace

RollingFrictionOutcome resolve_rolling_friction_collision(const RollingFrictionCollision& collision,
                                                          RestitutionLaw law) {
  RIGOR_ASSERT(std::isfinite(collision.mu) && collision.mu >= 0 && collision.rolling_friction >= 0 &&
               collision.torsional_friction >= 0);
  RollingFrictionOutcome outcome{collision.u, collision.w, Vec3::Zero(), Vec3::Zero(), 0, true};
  if (!(collision.u.z() < 0)) return outcome;
  RollingFrictionImpactPath impact(collision, law);
  if (!impact.run()) {
    outcome.is_resolved = false;
    return outcome;
  }
  return impact.outcome(collision);
}

}  // namespace rigor
