#pragma once

#include "rigor/math/types.hpp"

namespace rigor {

/// Rotation matrix of q with the factor s = 2/|q|²: orthonormal to rounding for any non-zero q, so that drift
/// of |q| has no effect.
Mat3 rotation_matrix(const Quat& q);

/// Unit quaternion exp(φ/2) of the rotation vector φ [rad]; for small |φ| sinc is replaced by its Taylor
/// series.
Quat rotation_exp(const Vec3& phi);

/// Rotation vector φ [rad], |φ| ≤ π, with rotation_exp(φ) = ±q; q need not be normalised.
Vec3 rotation_log(const Quat& q);

/// Angle [rad] of the rotation that takes a to b, in [0, π].
double rotation_angle_between(const Quat& a, const Quat& b);

/// Quaternion of the rotation matrix R (orthonormal, det +1); w ≥ 0.
Quat quaternion_of(const Mat3& R);

/// Columns orthonormalised from the first to the last (Gram-Schmidt, which favours the first column).
Mat3 gram_schmidt(const Mat3& R);

/// Skew matrix a~ with a~ b = a × b.
Mat3 skew(const Vec3& a);

/// Matrix [t1 t2 n] of a right-handed orthonormal frame with the given unit vector as its third column.
Mat3 frame_with_z(const Vec3& n);

}  // namespace rigor
