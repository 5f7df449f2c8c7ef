#include "rigor/solver/coulomb/coulomb_local.hpp"

#include "rigor/core/rounding.hpp"
#include "rigor/math/dense.hpp"
#include "rigor/solver/coulomb/cone.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace rigor {
namespace {

// Rounding of a few sums of products, relative to the largest term.
constexpr double kRounding = 64 * kEpsilon;
// Two roots closer than this [rad] are one double root, whose halves are known to the square root of ε only.
constexpr double kSameAngle = 1e-7;

// h(θ) = c₀ + c₁ cos θ + s₁ sin θ + c₂ cos 2θ + s₂ sin 2θ.
struct TrigPolynomial {
  double c0, c1, s1, c2, s2;

  struct Jet {
    double value, slope;
  };
  /// At the unit vector (cos θ, sin θ).
  Jet at(const Vec2& u) const {
    const double c = u(0), s = u(1);
    const double cc = (c - s) * (c + s), ss = 2 * c * s;  // Of twice the angle.
    return {c0 + c1 * c + s1 * s + c2 * cc + s2 * ss, s1 * c - c1 * s + 2 * (s2 * cc - c2 * ss)};
  }
  double size() const { return std::abs(c0) + std::abs(c1) + std::abs(s1) + std::abs(c2) + std::abs(s2); }
  // The same function of ψ, θ = ψ + shift.
  TrigPolynomial shifted(double shift) const {
    const double c = std::cos(shift), s = std::sin(shift);
    const double cc = std::cos(2 * shift), ss = std::sin(2 * shift);
    return {c0, c1 * c + s1 * s, s1 * c - c1 * s, c2 * cc + s2 * ss, s2 * cc - c2 * ss};
  }
};

// h(θ) of the header: the condition that the slip is along û(θ), multiplied by κ - μ k·û.
TrigPolynomial slip_condition(const Mat3& K, const Vec3& b, double mu) {
  const Vec2 k = K.block<2, 1>(0, 2);
  const Vec2 p = K(2, 2) * b.head<2>() - b(2) * k;
  return {-0.5 * mu * (k(0) * b(1) - k(1) * b(0)), p(1), -p(0),
          -0.5 * mu * (k(0) * b(1) + k(1) * b(0)) + mu * b(2) * K(0, 1),
          -0.5 * mu * (k(1) * b(1) - k(0) * b(0)) + 0.5 * mu * b(2) * (K(1, 1) - K(0, 0))};
}

// Newton's method from a point near a root; keeps the best point.
Vec2 refine_root(const TrigPolynomial& h, Vec2 u) {
  TrigPolynomial::Jet best = h.at(u);
  for (int i = 0; i < 50 && best.value != 0 && best.slope != 0; ++i) {
    // The vector turned by the step d = -h / h', or by atan d, which is as near to the root.
    const double step = -best.value / best.slope;
    const Vec2 turned = Vec2(u(0) - step * u(1), u(1) + step * u(0)).normalized();
    const TrigPolynomial::Jet next = h.at(turned);
    if (!(std::abs(next.value) < std::abs(best.value))) break;
    u = turned;
    best = next;
  }
  return u;
}

Vec2 direction_of(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

// All real roots, as unit vectors: those of a quartic in t = tan(ψ/2), θ = ψ + shift.
std::vector<Vec2> find_roots(const TrigPolynomial& h) {
  const double size = h.size();
  if (!(size > 0)) return {};

  // t is infinite at ψ = π: the shift is the one of eight that puts that point farthest from a root.
  double shift = 0;
  for (int i = 1; i < 8; ++i) {
    const double angle = i * std::numbers::pi / 4;
    const auto size_at_infinity = [&](double of) { return std::abs(h.at(-direction_of(of)).value); };
    if (size_at_infinity(angle) > size_at_infinity(shift)) shift = angle;
  }
  const TrigPolynomial g = h.shifted(shift);

  // The roots t are the eigenvalues of the quartic's companion matrix.
  const double lead = g.c0 - g.c1 + g.c2;
  Eigen::Matrix4d companion = Eigen::Matrix4d::Zero();
  companion.row(0) << -(2 * g.s1 - 4 * g.s2) / lead, -(2 * g.c0 - 6 * g.c2) / lead,
      -(2 * g.s1 + 4 * g.s2) / lead, -(g.c0 + g.c1 + g.c2) / lead;
  companion(1, 0) = companion(2, 1) = companion(3, 2) = 1;
  const Vec4 quartic_roots = real_parts_of_eigenvalues(companion);

  // Real parts are only near the roots: Newton's method on h decides which of them are real, and double roots
  // count once.
  std::vector<Vec2> roots;
  for (int i = 0; i < 4; ++i) {
    const Vec2 u = refine_root(h, direction_of(shift + 2 * std::atan(quartic_roots(i))));
    if (!(std::abs(h.at(u).value) <= kRounding * size)) continue;
    const auto is_same = [&](const Vec2& other) { return (u - other).norm() < kSameAngle; };
    if (std::none_of(roots.begin(), roots.end(), is_same)) roots.push_back(u);
  }
  return roots;
}

// The slide along û, if its force pushes and opposes the slip; backward slip slower than `slack` counts
// too.
std::optional<LocalCoulombSolution> find_slide(const Mat3& K, const Vec3& b, double mu, const Vec2& u,
                                               double slack) {
  const Vec3 direction(-mu * u(0), -mu * u(1), 1.0);
  const double normal = -b(2) / sliding_response(K, mu, u);
  if (!(normal > 0) || !std::isfinite(normal)) return std::nullopt;
  const Vec3 lambda = normal * direction;
  const Vec3 w = K * lambda + b;
  if (!(u.dot(w.head<2>()) > -slack)) return std::nullopt;
  return LocalCoulombSolution{lambda, {w(0), w(1), 0.0}, ContactMode::slide};
}

std::optional<LocalCoulombSolution> find_stick(const Mat3& K, const Vec3& b, double mu) {
  // A force far outside the cone shows by the cofactors of K, for a fraction of what exact forces cost.
  constexpr double kFar = 1e-6;
  const Vec3 rough = -(K.inverse() * b);
  if (rough.allFinite() && rough.head<2>().norm() > mu * rough(2) + kFar * rough.norm()) return std::nullopt;
  const Vec3 lambda = -refined_symmetric_solution(K, b);
  if (!(lambda(2) > 0)) return std::nullopt;
  if (!(lambda.head<2>().norm() <= mu * lambda(2) * (1 + kRounding))) return std::nullopt;
  return LocalCoulombSolution{clamp_to_cone(lambda, mu), Vec3::Zero(), ContactMode::stick};
}

// Slip speed below which a slide is not told from sticking.
double slip_rounding(const Mat3& K, const Vec3& b, const LocalCoulombSolution& slide) {
  return kRounding * (b.lpNorm<Eigen::Infinity>() + (K.cwiseAbs() * slide.lambda.cwiseAbs()).maxCoeff());
}

// Every slide; one too slow to be told from sticking counts only if nothing sticks.
std::vector<LocalCoulombSolution> find_slides(const Mat3& K, const Vec3& b, double mu, bool sticks) {
  std::vector<LocalCoulombSolution> slides;
  for (const Vec2& u : find_roots(slip_condition(K, b, mu))) {
    const double everything = std::numeric_limits<double>::infinity();
    const std::optional<LocalCoulombSolution> slide = find_slide(K, b, mu, u, everything);
    if (!slide) continue;
    const double slack = slip_rounding(K, b, *slide);
    if (u.dot(slide->w.head<2>()) > (sticks ? slack : -slack)) slides.push_back(*slide);
  }
  std::stable_sort(slides.begin(), slides.end(), [](const auto& a, const auto& c) {
    return a.w.template head<2>().squaredNorm() > c.w.template head<2>().squaredNorm();
  });
  return slides;
}

}  // namespace

std::vector<LocalCoulombSolution> solve_coulomb_local_all(const Mat3& K, const Vec3& b, double mu) {
  std::vector<LocalCoulombSolution> solutions;
  if (b(2) >= 0) solutions.push_back({Vec3::Zero(), b, ContactMode::open});
  const std::optional<LocalCoulombSolution> stick = find_stick(K, b, mu);
  if (stick) solutions.push_back(*stick);
  const std::vector<LocalCoulombSolution> slides = find_slides(K, b, mu, stick.has_value());
  solutions.insert(solutions.end(), slides.begin(), slides.end());
  return solutions;
}

LocalCoulombSolution solve_coulomb_local(const Mat3& K, const Vec3& b, double mu,
                                         const std::optional<Vec2>& slip_hint) {
  // In the order of solve_coulomb_local_all: open, then stick.
  if (b(2) >= 0) return {Vec3::Zero(), b, ContactMode::open};
  const std::optional<LocalCoulombSolution> stick = find_stick(K, b, mu);
  if (stick) return *stick;

  // A near slip direction leads Newton's method to its root at once; else all slides are found.
  if (slip_hint) {
    const TrigPolynomial h = slip_condition(K, b, mu);
    const Vec2 u = refine_root(h, *slip_hint);
    if (std::abs(h.at(u).value) <= kRounding * h.size()) {
      const std::optional<LocalCoulombSolution> slide = find_slide(K, b, mu, u, 0.0);
      if (slide) return *slide;
    }
  }
  const std::vector<LocalCoulombSolution> slides = find_slides(K, b, mu, false);
  if (!slides.empty()) return slides.front();

  // Only rounding leads here, where K is close to singular: the nearest force of the cone.
  const Vec3 lambda = clamp_to_cone(-symmetric_solution(K, b), mu);
  return {lambda, K * lambda + b, ContactMode::slide};
}

double sliding_response(const Mat3& K, double mu, const Vec2& slip) {
  return K(2, 2) - mu * K.block<1, 2>(2, 0).dot(slip);
}

int count_sliding_solutions(double response, double b_n) {
  const bool may_part = b_n >= 0, may_press = response != 0 && -b_n / response > 0;
  return int{may_part} + int{may_press};
}

}  // namespace rigor
