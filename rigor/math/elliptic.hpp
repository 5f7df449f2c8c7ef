#pragma once

namespace rigor {

/// Values of Jacobi's elliptic functions at one argument; sn² + cn² = 1, dn² = cn² + (1 - m) sn².
struct JacobiValues {
  double sn;
  double cn;
  double dn;
};

/// Complete elliptic integral K of the parameter m, given by its complement 1 - m in [0, 1] so that nothing
/// cancels near m = 1; infinite at 0. Computed by the arithmetic-geometric mean, K = π / (2 agm(1, √(1 - m)))
/// (DLMF 19.8.5).
double complete_elliptic_k(double complement);

/// Jacobi's functions sn, cn, dn of one parameter m in [0, 1], given by its complement 1 - m.
///
/// The chain of arithmetic-geometric means is computed once. An evaluation takes one sine, one cosine and a
/// short recursion of positive terms, so that cn and dn keep their relative accuracy where they are small (1
/// - m may be as small as 1e-300). At m = 1 the functions are tanh and sech and have no period.
///
/// Source: descending Landen transformation as in DLMF 22.20(ii), carried in the cotangent cn/sn instead of
/// the amplitude (as in R. Bulirsch, Numerical calculation of elliptic integrals and elliptic functions,
/// Numer. Math. 7, 1965).
class JacobiFunctions {
 public:
  JacobiFunctions() : JacobiFunctions(1) {}
  explicit JacobiFunctions(double complement);

  /// Values at any real u; exact to rounding of u.
  JacobiValues at(double u) const;
  /// Amplitude φ with sn = sin φ, cn = cos φ: continuous and increasing in u.
  double amplitude(double u) const;
  /// The quarter period K, the first positive zero of cn; infinite at m = 1.
  double quarter_period() const { return quarter_period_; }
  double complement() const { return complement_; }

 private:
  JacobiValues at_reduced(double u) const;

  /// A complement of 1e-300 needs 13 means.
  static constexpr int max_levels = 16;
  double complement_;
  double quarter_period_;
  int levels_ = 0;
  double a_[max_levels] = {};  ///< Arithmetic means, a_[0] = 1.
  double b_[max_levels] = {};  ///< Geometric means, b_[0] = √(1 - m).
};

}  // namespace rigor
