#pragma once

namespace rigor {

/// Carlson's symmetric elliptic integral of the first kind,
///
///   R_F(x, y, z) = ½ ∫₀^∞ dt / √((t + x)(t + y)(t + z)),   x, y, z ≥ 0, at most one of them 0.
///
/// The relative error is a few units in the last place. With s = sin φ, c = cos φ and Δ² = 1 - m s²,
/// Legendre's F is s R_F(c², Δ², 1).
///
/// Source: B. C. Carlson, Numerical computation of real or complex elliptic integrals, Numerical Algorithms
/// 10, 1995 (also DLMF 19.36(i)): duplication until a Taylor series of degree five is exact to rounding.
double carlson_rf(double x, double y, double z);

/// Carlson's symmetric elliptic integral of the third kind,
///
///   R_J(x, y, z, p) = 3/2 ∫₀^∞ dt / ((t + p) √((t + x)(t + y)(t + z))),   x, y, z ≥ 0, at most one of them
///   0, p > 0.
///
/// With s = sin φ, c and Δ as above, Legendre's Π(n; φ, m) is s R_F(c², Δ², 1) + (n/3) s³ R_J(c², Δ², 1, 1 -
/// n s²). Source as for R_F.
double carlson_rj(double x, double y, double z, double p);

}  // namespace rigor
