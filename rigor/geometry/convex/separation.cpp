#include "rigor/geometry/convex/separation.hpp"

#include "rigor/core/index.hpp"
#include "rigor/geometry/convex/gjk.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace rigor {
namespace {

using Tangents = Eigen::Matrix<double, 3, 2>;

constexpr int kMaxNewtonSteps = 12;
/// Number of times that pieces are removed or added before the method gives up.
constexpr int kMaxChanges = 8;
/// Longest step of Newton's method [rad].
constexpr double kLongestStep = 0.3;
/// A step shorter than this [rad] is the last: the next one would be its square.
constexpr double kLastStep = 1e-9;

/// The distinct pieces of one core that meet at the separation, the heaviest first, with their weights (sum
/// 1).
struct ActivePieces {
  int count = 0;
  std::array<int, 4> piece{};
  std::array<double, 4> weight{};
  std::array<Vec3, 4> point;  ///< The farthest point of each towards the other core, along the axes of A [m].

  bool has(int p) const {
    return std::find(piece.begin(), piece.begin() + count, p) != piece.begin() + count;
  }

  /// Adds weight w to piece p and keeps the pieces in the order of falling weight.
  void add(int p, double w) {
    std::size_t i = 0;
    while (i < at(count) && piece[i] != p) ++i;
    if (i == at(count)) piece[at(count++)] = p;
    weight[i] += w;
    for (; i > 0 && weight[i] > weight[i - 1]; --i) {
      std::swap(weight[i], weight[i - 1]);
      std::swap(piece[i], piece[i - 1]);
    }
  }

  std::size_t lightest() const {
    return static_cast<std::size_t>(std::min_element(weight.begin(), weight.begin() + count) -
                                    weight.begin());
  }

  void remove(std::size_t i) {
    for (--count; i < at(count); ++i) {
      piece[i] = piece[i + 1];
      weight[i] = weight[i + 1];
    }
    weight[at(count)] = 0;
  }

  /// The witness point: the mean of the points by their weights.
  Vec3 mean() const {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < at(count); ++i) sum += weight[i] * point[i];
    return sum;
  }
};

/// The condition that two pieces of one core are at the same height along n.
struct ActiveConstraint {
  Vec3 u;        ///< The piece adds weight · u to b - a; the condition is u·n = 0 [m].
  Vec2 tangent;  ///< u in the tangent plane.
  bool in_a;
  std::size_t index;      ///< Of the piece that is not the heaviest.
  double multiplier = 0;  ///< Its weight.
};

/// Newton's method for the maximum of s on the unit sphere, with an active set of pieces.
class Polish {
 public:
  Polish(const CorePair& pair, const WeightedPoints& points) : pair_(pair) {
    for (std::size_t i = 0; i < points.points.size(); ++i) {
      if (points.weights[i] <= 0) continue;
      a_.add(points.points[i].piece_a, points.weights[i]);
      b_.add(points.points[i].piece_b, points.weights[i]);
    }
  }

  /// Newton's method with the active pieces; then one piece is removed or added, until no weight is negative
  /// and no other piece is farther out. These are the conditions of Karush, Kuhn and Tucker for a maximum of
  /// s.
  std::optional<Separation> solve(const Vec3& start) {
    std::optional<Separation> best;
    Vec3 n = start;
    for (int change = 0; change < kMaxChanges; ++change) {
      const std::optional<Vec3> maximum = find_maximum(n);
      if (!maximum) break;
      n = *maximum;
      evaluate_points(n);
      // The separation of the whole cores, not only of the active pieces, is the certified value.
      const DifferencePoint lowest = pair_.lowest(n);
      const double value = n.dot(lowest.w);
      if (!best || value > best->value) best = with_witnesses(n, value);
      const bool is_changed = remove_negative() || add_farther(n, lowest);
      if (!is_changed) break;
    }
    return best;
  }

 private:
  /// Newton's method with the active pieces, from n; nothing if it does not converge.
  std::optional<Vec3> find_maximum(Vec3 n) {
    for (int i = 0; i < kMaxNewtonSteps; ++i) {
      const std::optional<Vec3> step = newton_step(n);
      if (!step) return std::nullopt;
      // Long steps are shortened: the quadratic model holds near n only. Convergence is quadratic, so that
      // after a short step none is needed.
      const double length = step->norm();
      n = (n + std::min(1.0, kLongestStep / length) * *step).normalized();
      if (length <= kLastStep) return n;
    }
    return std::nullopt;
  }

  /// Removes the piece with the most negative weight, if there is one: s grows when that piece falls behind
  /// the others of its core.
  bool remove_negative() {
    const std::size_t i = a_.lightest();
    const std::size_t j = b_.lightest();
    if (a_.weight[i] >= 0 && b_.weight[j] >= 0) return false;
    // The most negative weight of both cores first: removing it changes the others.
    if (a_.weight[i] < b_.weight[j]) {
      a_.remove(i);
    } else {
      b_.remove(j);
    }
    return true;
  }

  /// Adds the pieces that are farther out along n than the active ones, if there are any.
  bool add_farther(const Vec3& n, const DifferencePoint& lowest) {
    // A whole core may reach farther along n than its active pieces, which are all level with the first. Such
    // a piece joins with weight 0 and gets its weight in the next solution.
    const bool is_farther_a = n.dot(lowest.a - a_.point[0]) > pair_.rounding && !a_.has(lowest.piece_a);
    const bool is_farther_b =
        n.dot(b_.point[0] + pair_.X_AB.p - lowest.b) > pair_.rounding && !b_.has(lowest.piece_b);
    if (is_farther_a && a_.count < 4) a_.add(lowest.piece_a, 0);
    if (is_farther_b && b_.count < 4) b_.add(lowest.piece_b, 0);
    return is_farther_a || is_farther_b;
  }

  /// Moves the points of the active pieces to where they are farthest along n.
  void evaluate_points(const Vec3& n) {
    for (std::size_t i = 0; i < at(a_.count); ++i) a_.point[i] = piece_point(pair_.a, a_.piece[i], n);
    const Vec3 d_B = pair_.X_AB.R.transpose() * -n;
    for (std::size_t i = 0; i < at(b_.count); ++i) {
      b_.point[i] = pair_.X_AB.R * piece_point(pair_.b, b_.piece[i], d_B);
    }
  }

  /// R_A + R_B + s in the tangent plane [m].
  Mat2 curvature(const Vec3& n, const Tangents& tangents, double separation) const {
    Mat2 sum = separation * Mat2::Identity();
    // Vertices have no curvature; a curved piece counts by its weight, as the weights mix the pieces' points.
    if (!is_polytope(pair_.a)) {
      for (std::size_t i = 0; i < at(a_.count); ++i) {
        sum += a_.weight[i] * (tangents.transpose() * piece_curvature(pair_.a, a_.piece[i], n) * tangents);
      }
    }
    if (!is_polytope(pair_.b)) {
      const Tangents tangents_B = pair_.X_AB.R.transpose() * tangents;
      const Vec3 d_B = pair_.X_AB.R.transpose() * -n;
      for (std::size_t i = 0; i < at(b_.count); ++i) {
        sum +=
            b_.weight[i] * (tangents_B.transpose() * piece_curvature(pair_.b, b_.piece[i], d_B) * tangents_B);
      }
    }
    return sum;
  }

  /// Collects the conditions of equal height, at most two, that are independent in the tangent plane. The
  /// pieces are visited from the heaviest down.
  void find_constraints(const Tangents& tangents) {
    constraint_count_ = 0;
    for (const bool in_a : {true, false}) {
      const ActivePieces& side = in_a ? a_ : b_;
      for (std::size_t i = 1; i < at(side.count) && constraint_count_ < 2; ++i) {
        // Each further piece of a core must stay level with the heaviest one. A condition that depends on the
        // first to rounding would leave the system singular.
        const Vec3 u = (in_a ? -1 : 1) * (side.point[i] - side.point[0]);
        const Vec2 tangent = tangents.transpose() * u;
        const Vec2& first = constraints_[0].tangent;
        const bool is_independent = constraint_count_ == 0
                                        ? tangent.norm() > 1e-9 * u.norm()
                                        : std::abs(first.x() * tangent.y() - first.y() * tangent.x()) >
                                              1e-7 * first.norm() * tangent.norm();
        if (is_independent) constraints_[at(constraint_count_++)] = {u, tangent, in_a, i};
      }
    }
  }

  /// Newton's step of n in the tangent plane, and the weights of the pieces that go with it.
  std::optional<Vec3> newton_step(const Vec3& n) {
    evaluate_points(n);
    // Gradient and negative Hessian of s in the tangent plane: r is the part of b - a across n, and K = R_A +
    // R_B + s.
    const Tangents tangents = frame_with_z(n).leftCols<2>();
    const Vec3 c = (b_.point[0] + pair_.X_AB.p) - a_.point[0];
    const Vec2 r = tangents.transpose() * c;
    const Mat2 K = curvature(n, tangents, n.dot(c));
    // The tangent plane has two dimensions, of which every condition of equal height takes one.
    find_constraints(tangents);
    const std::optional<Vec2> step = constraint_count_ == 0   ? free_step(K, r)
                                     : constraint_count_ == 1 ? step_along_constraint(n, K, r)
                                                              : step_to_constraints(n, K, r);
    if (!step) return std::nullopt;
    set_weights();
    return tangents * *step;
  }

  /// Newton's step for one gradient and one curvature. A direction in which s is level to rounding, as about
  /// the common axis of two cylinders, needs no step; where s does not curve downwards there is none.
  std::optional<double> step_of(double gradient, double curvature) const {
    const double noise = 100 * pair_.rounding;
    if (curvature > noise) return gradient / curvature;
    if (std::abs(gradient) <= noise) return 0.0;
    return std::nullopt;
  }

  std::optional<Vec2> free_step(const Mat2& K, const Vec2& r) const {
    // Newton's step is taken along each principal axis by itself, because s may be level along one of them.
    // The axis of the larger curvature is the eigenvector of [d o; o -d].
    const double d = 0.5 * (K(0, 0) - K(1, 1));
    const double o = K(0, 1);
    const double m = std::sqrt(d * d + o * o);
    const Vec2 axis = d >= 0 ? Vec2(m + d, o) : Vec2(o, m - d);
    const Vec2 p = m > 0 ? axis.normalized() : Vec2::UnitX();
    const Vec2 q(-p.y(), p.x());
    const std::optional<double> along_p = step_of(p.dot(r), p.dot(K * p));
    const std::optional<double> along_q = step_of(q.dot(r), q.dot(K * q));
    if (!along_p || !along_q) return std::nullopt;
    return Vec2(*along_p * p + *along_q * q);
  }

  /// One condition: it fixes the step along its tangent g; across g Newton's step applies. The multiplier
  /// makes the gradient of s vanish along g.
  std::optional<Vec2> step_along_constraint(const Vec3& n, const Mat2& K, const Vec2& r) {
    const Vec2 g = constraints_[0].tangent;
    const Vec2 q = Vec2(-g.y(), g.x()) / g.norm();
    const Vec2 levelled = -n.dot(constraints_[0].u) / g.squaredNorm() * g;
    const std::optional<double> across = step_of(q.dot(r - K * levelled), q.dot(K * q));
    if (!across) return std::nullopt;
    const Vec2 step = levelled + *across * q;
    constraints_[0].multiplier = g.dot(K * step - r) / g.squaredNorm();
    return step;
  }

  /// Two conditions leave no freedom to maximize s.
  std::optional<Vec2> step_to_constraints(const Vec3& n, const Mat2& K, const Vec2& r) {
    // The linearised conditions alone fix the step, the stationarity of s the two multipliers.
    Mat2 G;
    G << constraints_[0].tangent.transpose(), constraints_[1].tangent.transpose();
    const Mat2 inverse = G.inverse();
    const Vec2 step = -inverse * Vec2(n.dot(constraints_[0].u), n.dot(constraints_[1].u));
    const Vec2 multipliers = inverse.transpose() * (K * step - r);
    constraints_[0].multiplier = multipliers.x();
    constraints_[1].multiplier = multipliers.y();
    return step;
  }

  /// The multiplier of a condition is the weight of its piece; the first piece has the rest of the sum 1.
  void set_weights() {
    a_.weight = {1};
    b_.weight = {1};
    for (std::size_t i = 0; i < at(constraint_count_); ++i) {
      const ActiveConstraint& constraint = constraints_[i];
      ActivePieces& side = constraint.in_a ? a_ : b_;
      // The weights of each core sum to 1.
      side.weight[constraint.index] = constraint.multiplier;
      side.weight[0] -= constraint.multiplier;
    }
  }

  /// The witnesses are the weighted means of the active points if no weight is negative.
  Separation with_witnesses(const Vec3& n, double value) const {
    Separation result{n, value, a_.mean(), b_.mean() + pair_.X_AB.p};
    const bool is_inside = a_.weight[a_.lightest()] >= 0 && b_.weight[b_.lightest()] >= 0;
    if (!is_inside) find_witnesses(result);
    return result;
  }

  /// Where more pieces are level than are needed to determine n, as for two faces, the witnesses are the
  /// nearest points of the hulls of the pieces.
  void find_witnesses(Separation& result) const {
    // The points of the active pieces as hulls of their own, along the axes of A.
    const ConvexCore a = make_points_core({a_.point.data(), at(a_.count)});
    const ConvexCore b = make_points_core({b_.point.data(), at(b_.count)});
    const CorePair pieces(a, b, {.p = pair_.X_AB.p});
    GjkState gjk = start_gjk(pieces);
    advance_gjk(pieces, 0, gjk);
    result.a = Vec3::Zero();
    result.b = Vec3::Zero();
    for (std::size_t i = 0; i < at(gjk.nearest.count); ++i) {
      result.a += gjk.nearest.weight[i] * gjk.points[i].a;
      result.b += gjk.nearest.weight[i] * gjk.points[i].b;
    }
  }

  const CorePair& pair_;
  ActivePieces a_;
  ActivePieces b_;
  std::array<ActiveConstraint, 2> constraints_{};
  int constraint_count_ = 0;
};

}  // namespace

std::optional<Separation> polish_separation(const CorePair& pair, const Vec3& n, const WeightedPoints& at) {
  return Polish(pair, at).solve(n);
}

}  // namespace rigor
