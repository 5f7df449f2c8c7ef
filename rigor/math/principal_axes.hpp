#pragma once

#include "rigor/math/types.hpp"

namespace rigor {

/// Principal frame P of an inertia tensor given in a frame B: I_B = R diag(moments) Rᵀ.
struct PrincipalAxes {
  Mat3 R;        ///< R_BP: columns are the principal axes in B; orthonormal, det +1.
  Vec3 moments;  ///< Principal moments in the order of the columns, not sorted.
};

/// Principal axes of a symmetric matrix (its lower half is not read), by Jacobi rotations.
///
/// A matrix whose off-diagonal elements are all at most 16 ε ‖I‖ (ε = 2⁻⁵³) counts as diagonal: then R = 1,
/// so that the axes that a user chose are kept. Otherwise each rotation is by at most 45°, so that the
/// principal axes stay near the given ones. The moments have the relative accuracy of the Jacobi method. Same
/// input, same bits; scaling the input by a power of two scales the moments and leaves R unchanged.
///
/// Source: Demmel and Veselić, Jacobi's Method is More Accurate than QR, SIAM J. Matrix Anal. Appl. 13(4),
/// 1992 (the stopping rule |a_pq| ≤ ε √(a_pp a_qq)).
PrincipalAxes principal_axes(const Mat3& inertia);

}  // namespace rigor
