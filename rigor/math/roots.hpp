#pragma once

namespace rigor {

/// Reference to a function double(double) that outlives the call: root finders live in a source file and
/// allocate nothing.
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

/// Interval that contains a sign change. f_lo and f_hi have opposite signs, or one of them is zero; f_lo
/// keeps the sign that f had at the left end given.
struct RootBracket {
  double lo, hi;  ///< lo ≤ hi.
  double f_lo, f_hi;
  int iterations;  ///< Evaluations of f after the two ends.

  double width() const { return hi - lo; }
  /// The end where |f| is smaller.
  double best() const;
};

/// The three methods shrink a bracket [lo, hi] with f(lo) f(hi) ≤ 0 (asserted) until its width is at most
/// tolerance, or until its ends are neighbours up to two units in the last place (with tolerance = 0). An
/// exact zero ends the search with lo = hi. f need not be continuous; then a sign change is found.

/// Halving: one bit an evaluation.
RootBracket find_root_bisection(ScalarFunction f, double lo, double hi, double tolerance);

/// False position with the Illinois rule: the value kept twice at the same end counts half, which makes
/// regula falsi superlinear (order 1.44). An interval not halved within three evaluations is halved. Source:
/// M. Dowell and P. Jarratt, A modified regula falsi method for computing the root of an equation, BIT 11,
/// 1971. The safeguard is ours.
RootBracket find_root_illinois(ScalarFunction f, double lo, double hi, double tolerance);

/// ITP (interpolate, truncate, project): superlinear, and never more than one evaluation worse than halving
/// (two where rounding of the ends tips the count).
/// Source: I. F. D. Oliveira and R. H. C. Takahashi, An enhancement of the bisection method average
/// performance preserving minmax optimality, ACM Trans. Math. Softw. 47(1), 2021; κ1 = 0.2/(hi - lo), κ2 = 2,
/// n0 = 1.
RootBracket find_root_itp(ScalarFunction f, double lo, double hi, double tolerance);

}  // namespace rigor
