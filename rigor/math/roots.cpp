#include "rigor/math/roots.hpp"

#include "rigor/core/assert.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {
namespace {

/// Two units in the last place of the larger end.
double resolution(double lo, double hi) {
  return 2 * std::numeric_limits<double>::epsilon() * std::max(std::abs(lo), std::abs(hi));
}

/// The bracket of the given interval; a zero at one of its ends is the root.
RootBracket start_bracket(const ScalarFunction& f, double lo, double hi) {
  RIGOR_ASSERT(lo <= hi);
  RootBracket bracket{lo, hi, f(lo), f(hi), 0};
  RIGOR_ASSERT((bracket.f_lo <= 0 && bracket.f_hi >= 0) || (bracket.f_lo >= 0 && bracket.f_hi <= 0));
  if (bracket.f_lo == 0) {
    bracket.hi = lo;
    bracket.f_hi = 0;
  } else if (bracket.f_hi == 0) {
    bracket.lo = hi;
    bracket.f_lo = 0;
  }
  return bracket;
}

bool is_done(const RootBracket& bracket, double tolerance) {
  return bracket.width() <= std::max(tolerance, resolution(bracket.lo, bracket.hi));
}

double midpoint(const RootBracket& bracket) {
  return bracket.lo + 0.5 * (bracket.hi - bracket.lo);
}

/// Narrows the bracket by the point x with the value y; returns whether x became the left end.
bool narrow(double x, double y, RootBracket& bracket) {
  ++bracket.iterations;
  if (y == 0) {
    bracket = {x, x, y, y, bracket.iterations};
    return true;
  }
  const bool is_left = (y < 0) == (bracket.f_lo < 0);
  (is_left ? bracket.lo : bracket.hi) = x;
  (is_left ? bracket.f_lo : bracket.f_hi) = y;
  return is_left;
}

/// x moved into the interior of the bracket by at least its resolution, so that each evaluation narrows the
/// bracket.
double inside(double x, const RootBracket& bracket) {
  const double margin = 0.5 * resolution(bracket.lo, bracket.hi);
  if (!(x > bracket.lo + margin)) x = bracket.lo + margin;
  if (!(x < bracket.hi - margin)) x = bracket.hi - margin;
  return x > bracket.lo && x < bracket.hi ? x : midpoint(bracket);
}

}  // namespace

double RootBracket::best() const {
  return std::abs(f_lo) <= std::abs(f_hi) ? lo : hi;
}

RootBracket find_root_bisection(ScalarFunction f, double lo, double hi, double tolerance) {
  RootBracket bracket = start_bracket(f, lo, hi);
  while (!is_done(bracket, tolerance)) {
    const double x = midpoint(bracket);
    if (x == bracket.lo || x == bracket.hi) break;
    narrow(x, f(x), bracket);
  }
  return bracket;
}

RootBracket find_root_illinois(ScalarFunction f, double lo, double hi, double tolerance) {
  RootBracket bracket = start_bracket(f, lo, hi);
  double weight_lo = bracket.f_lo, weight_hi = bracket.f_hi;
  int last_side = 0;  // -1: the left end moved, +1: the right end moved
  int since_halved = 0;
  double reference_width = bracket.width();

  while (!is_done(bracket, tolerance)) {
    const bool is_slow = since_halved >= 3;
    // The zero of the chord between the weighted ends, or the midpoint if the bracket shrinks too slowly.
    const double secant = bracket.lo - weight_lo * (bracket.width() / (weight_hi - weight_lo));
    const double x = is_slow ? midpoint(bracket) : inside(secant, bracket);
    if (x == bracket.lo || x == bracket.hi) break;
    const double y = f(x);
    const int side = narrow(x, y, bracket) ? -1 : 1;

    // The Illinois rule: the value at an end that is kept twice is halved, which brings the next chord across
    // the root.
    if (side < 0) weight_lo = y;
    if (side > 0) weight_hi = y;
    if (side == last_side) (side < 0 ? weight_hi : weight_lo) *= 0.5;
    last_side = side;

    // The safeguard counts the evaluations since the bracket was last halved.
    ++since_halved;
    if (is_slow || bracket.width() <= 0.5 * reference_width) {
      since_halved = 0;
      reference_width = bracket.width();
    }
  }
  return bracket;
}

RootBracket find_root_itp(ScalarFunction f, double lo, double hi, double tolerance) {
  RootBracket bracket = start_bracket(f, lo, hi);
  const double target = std::max({tolerance, resolution(lo, hi), std::numeric_limits<double>::min()});
  const double kappa = 0.2 / bracket.width();
  // Half the width that bisection (with one evaluation more) would have left; the method never exceeds it.
  double budget = 0.5 * target * std::exp2(std::ceil(std::log2(std::max(1.0, bracket.width() / target))) + 1);

  while (!is_done(bracket, target)) {
    const double middle = midpoint(bracket);
    const double width = bracket.width();
    if (middle == bracket.lo || middle == bracket.hi) break;

    // Interpolate: the zero of the chord. Truncate: that point moved slightly towards the middle. Project:
    // into the interval about the middle that keeps within the budget.
    const double secant = bracket.lo - bracket.f_lo * (width / (bracket.f_hi - bracket.f_lo));
    const double direction = middle >= secant ? 1 : -1;
    const double shift = kappa * width * width;
    const double truncated = shift <= std::abs(middle - secant) ? secant + direction * shift : middle;
    const double radius = std::max(0.0, budget - 0.5 * width);
    const double x = std::abs(truncated - middle) <= radius ? truncated : middle - direction * radius;
    const double safe = x > bracket.lo && x < bracket.hi ? x : middle;
    narrow(safe, f(safe), bracket);
    budget *= 0.5;
  }
  return bracket;
}

}  // namespace rigor
