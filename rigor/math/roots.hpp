#pragma once

namespace rigor {

/// A reference to a function double(double), which must outlive the call: with it the root finders are
/// compiled in a source file and allocate nothing.
class ScalarFunction {
 public:
  template <class Callable>
  ScalarFunction(const Callable& callable)  // implicit: lambdas are passed as they are
      : callable_(&callable), call_([](const void* c, double x) {
          return static_cast<double>((*static_cast<const Callable*>(c))(x));
        }) {}

  double operator()(double x) const { return call_(callable_, x); }

 private:
  const void* callable_;
  double (*call_)(const void*, double);
};

/// An interval that contains a sign change. f_lo and f_hi have opposite signs, or one of them is zero; f_lo
/// has the sign of f at the left end of the interval given.
struct RootBracket {
  double lo, hi;  ///< lo ≤ hi.
  double f_lo, f_hi;
  int iterations;  ///< Number of evaluations of f besides the two ends.

  double width() const { return hi - lo; }
  /// The end at which |f| is smaller.
  double best() const;
};

/// All three methods shrink a bracket [lo, hi] with f(lo) f(hi) ≤ 0 (asserted) until its width is at most the
/// tolerance, or (with tolerance = 0) until its ends are neighbours up to two units in the last place. An
/// exact zero ends the search with lo = hi. f need not be continuous; in that case a sign change is found.

/// Bisection: one bit per evaluation.
RootBracket find_root_bisection(ScalarFunction f, double lo, double hi, double tolerance);

/// False position with the Illinois rule: the value at an end that is kept twice is halved, which makes
/// regula falsi superlinear (order 1.44). An interval that is not halved within three evaluations is
/// bisected. Source: M. Dowell and P. Jarratt, A modified regula falsi method for computing the root of an
/// equation, BIT 11, 1971. The safeguard is ours.
RootBracket find_root_illinois(ScalarFunction f, double lo, double hi, double tolerance);

/// ITP (interpolate, truncate, project): superlinear, and never more than one evaluation worse than bisection
/// (two where rounding of the ends tips the count).
/// Source: I. F. D. Oliveira and R. H. C. Takahashi, An enhancement of the bisection method average
/// performance preserving minmax optimality, ACM Trans. Math. Softw. 47(1), 2021; κ1 = 0.2/(hi - lo), κ2 = 2,
/// n0 = 1.
RootBracket find_root_itp(ScalarFunction f, double lo, double hi, double tolerance);

}  // namespace rigor
