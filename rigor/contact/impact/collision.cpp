#include "rigor/contact/impact/collision.hpp"

#include "rigor/contact/impact/asymptotic_slip.hpp"
#include "rigor/contact/impact/impact_piece.hpp"
#include "rigor/contact/impact/restitution_watch.hpp"
#include "rigor/contact/impact/slip_power_series.hpp"
#include "rigor/core/assert.hpp"
#include "rigor/math/roots.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace rigor {

namespace {

/// Where u_n changes from falling to growing on a piece or back: sliding enters or leaves the directions that
/// jam, κ < μ b·û. Ascending; the slip direction rotates in one sense and by less than half a circle.
struct JamBorders {
  std::size_t count = 0;
  std::array<double, 2> z = {};
};
JamBorders find_jam_borders(const SlipFlow& flow, const ImpactPiece& piece) {
  JamBorders borders;
  const double size = flow.mu * flow.b.norm(), kappa = flow.drive * flow.kappa;
  if (kappa >= size || !std::isfinite(piece.end())) return borders;

  // The two borders stand at the same angle on both sides of b, cos = κ / (μ |b|).
  const Vec2 axis = flow.b.normalized(), across{-axis.y(), axis.x()};
  const double c = kappa / size, s = std::sqrt(1 - c * c);
  for (const double side : {-1.0, 1.0}) {
    const Vec2 border = c * axis + side * s * across;
    const auto past = [&](double z) {
      const Vec2 d = piece.direction(z);
      return border.x() * d.y() - border.y() * d.x();
    };
    if (border.dot(piece.direction(0)) <= 0 || past(0) * past(piece.end()) >= 0) continue;
    borders.z[borders.count++] = find_root_itp(past, 0, piece.end(), 0).best();
  }
  if (borders.count == 2 && borders.z[1] < borders.z[0]) std::swap(borders.z[0], borders.z[1]);
  return borders;
}

/// The path of an impact from its beginning to where the law ends it, piece by piece.
class ImpactPath {
 public:
  ImpactPath(const Collision& collision, RestitutionLaw law, const ImpactState& start,
             std::vector<CollisionPoint>* path)
      : collision_(collision),
        flow_(collision.matrix),
        state_(start),
        watch_(law, collision.restitution, start),
        path_(path) {
    if (!std::isfinite(flow_.mu)) flow_.mu = 1, flow_.drive = 0;
    // Slip below the rounding of the velocities is none.
    still_ = std::numeric_limits<double>::epsilon() * start.u.cwiseAbs().maxCoeff();
  }

  /// False if the normal velocity cannot be changed.
  bool run() {
    constexpr int most_pieces = 10000;
    if (slip_speed() > still_) watch_.note('S');
    for (int k = 0; k < most_pieces; ++k) {
      const Step step = slip_speed() > still_ ? slide() : start_or_stick();
      if (step != Step::continues) return step == Step::ended;
    }
    return false;
  }

  const ImpactState& state() const { return state_; }
  const RestitutionWatch& watch() const { return watch_; }

 private:
  /// Whether the path continues after a piece, has ended by the law, or can neither.
  enum class Step { continues, ended, stuck };

  double slip_speed() const { return state_.slip().norm(); }

  /// One piece of sliding: straight, on the asymptotic series, or on a power series.
  Step slide() {
    constexpr double straight = 16 * std::numeric_limits<double>::epsilon();
    constexpr double no_friction = 1e-30;
    // Without friction, and along an invariant direction, slip goes straight to the end.
    if (flow_.mu < no_friction) return follow(StraightPiece(flow_, state_));
    const Vec2 direction = state_.slip().normalized();
    if (std::abs(flow_.angular_rate(direction)) <= straight * flow_.rate_bound()) {
      return follow(StraightPiece(flow_, direction, state_));
    }

    // Near an attracting invariant direction one series reaches the stop; elsewhere a power series in p goes
    // a part of the way.
    if (const std::optional<double> w = find_asymptotic_place(direction))
      return follow(AsymptoticSlip(flow_, *asymptotic_series_, *w, state_));
    return follow(SlipPowerSeries(flow_, state_));
  }

  /// The coordinate w of this direction on the series about the invariant direction that slip tends to, if
  /// they reach as far.
  std::optional<double> find_asymptotic_place(const Vec2& direction) {
    const std::optional<Vec2> limit = find_near_attractor(flow_, direction);
    if (!limit) return std::nullopt;
    if (!asymptotic_series_ || (asymptotic_series_->limit() - *limit).squaredNorm() > 1e-20)
      asymptotic_series_.emplace(flow_, *limit);
    const Vec2 from = asymptotic_series_->limit();
    return asymptotic_series_->find_w(
        std::atan2(from.x() * direction.y() - from.y() * direction.x(), from.dot(direction)));
  }

  /// Without slip: the contact sticks to the end, or starts along the one direction that leads away.
  Step start_or_stick() {
    state_.u.head<2>().setZero();
    // In the limit μ → ∞ slip has been stopped by friction impulse alone; from here on p is normal impulse.
    if (flow_.drive == 0) {
      asymptotic_series_.reset();
      flow_ = SlipFlow(collision_.matrix);
      if (watch_.leave_limit(state_)) return Step::ended;
    }

    // Either motion has constant rates for ever, so only the law can end it.
    const StickTest sticking = test_sticking(collision_.matrix);
    watch_.note(sticking.is_stable ? 'K' : 'U');
    if (sticking.is_stable && is_wedged(sticking)) {
      state_.u.z() = 0;
      return Step::ended;
    }
    const Step step = sticking.is_stable ? follow(StraightPiece(sticking, state_))
                                         : follow(StraightPiece(flow_, diverging_direction(flow_), state_));
    return step == Step::continues ? Step::stuck : step;
  }

  /// Whether joints let no impulse inside the cone of friction move the contact, so that its normal velocity
  /// has ended with its slip, to rounding: nothing is left that could push it back.
  bool is_wedged(const StickTest& sticking) const {
    constexpr double rounding = 1e-12, rounding_of_u = 1e-10 / std::numeric_limits<double>::epsilon();
    return sticking.normal_rate <= rounding * collision_.matrix.K(2, 2) &&
           std::abs(state_.u.z()) <= rounding_of_u * still_;
  }

  /// Follows a piece to its end or to that of the impact. Between the borders of the jamming directions u_n
  /// is monotone, as the watch needs it.
  Step follow(const ImpactPiece& piece) {
    PiecePoint a{0, piece.normal(0)};
    const JamBorders borders = find_jam_borders(flow_, piece);
    for (std::size_t k = 0; k <= borders.count; ++k) {
      const double cut = k < borders.count ? borders.z[k] : piece.end();
      const PiecePoint b{cut, piece.normal(cut)};
      if (const std::optional<double> end = watch_.follow(piece, a, b)) {
        go_to(piece, *end);
        watch_.set_end(state_);
        return Step::ended;
      }
      a = b;
    }
    if (!std::isfinite(piece.end())) return Step::stuck;
    go_to(piece, piece.end());
    return Step::continues;
  }

  void go_to(const ImpactPiece& piece, double z_end) {
    constexpr int points = 8;
    for (int k = 1; path_ && k <= points; ++k) {
      const ImpactState state = piece.state(z_end * k / points);
      path_->push_back({state.u, state.lambda, state.work});
    }
    state_ = piece.state(z_end);
  }

  const Collision& collision_;
  SlipFlow flow_;
  ImpactState state_;
  RestitutionWatch watch_;
  std::vector<CollisionPoint>* path_;
  double still_;
  std::optional<AsymptoticSlipSeries> asymptotic_series_;
};

bool is_pressed(const Collision& collision, const Vec3& u) {
  if (u.z() != 0) return u.z() < 0;
  // A jam: sliding that presses the bodies together although they do not approach.
  if (!std::isfinite(collision.matrix.mu) || u.head<2>().isZero(0)) return false;
  return SlipFlow(collision.matrix).normal_rate(u.head<2>().normalized()) < 0;
}

}  // namespace

CollisionOutcome resolve_collision(const Collision& collision, RestitutionLaw law,
                                   std::vector<CollisionPoint>* path) {
  RIGOR_ASSERT(collision.restitution >= 0 && collision.restitution <= 1 && collision.matrix.mu >= 0);
  constexpr int most_restarts = 1000;
  constexpr double least = -1e-13;
  CollisionOutcome outcome;
  ImpactState state;
  state.u = collision.u;
  outcome.end.u = collision.u;
  if (path) path->push_back({state.u, state.lambda, state.work});

  // A law can end an impact while the bodies still approach (Newton's and Poisson's): then a new one begins
  // with the velocities that the last one left.
  Collision left = collision;
  for (int start = 0; start < most_restarts && is_pressed(left, state.u); ++start) {
    // A law that ends again and again while the bodies approach gives an infinite series: it is cut off by a
    // plastic impact.
    if (start > 0 && state.u.z() > least * collision.u.norm()) left.restitution = 0;
    ImpactPath impact(left, law, state, path);
    if (!impact.run()) {
      outcome.is_resolved = false;
      return outcome;
    }
    state = impact.state();
    if (start == 0) outcome.compression = impact.watch().compression();
    outcome.phases += (start == 0 ? "" : ";") + impact.watch().phases();
    outcome.end = {state.u, state.lambda, state.work};
  }
  outcome.energy_change = 0.5 * outcome.end.lambda.dot(collision.u + outcome.end.u);
  return outcome;
}

}  // namespace rigor
