#pragma once

namespace rigor {

/// What is integrated for the attitude: the quaternion (13 numbers per body) or the matrix R with
/// Gram-Schmidt after each step (18 numbers per body).
enum class OrientationForm { quaternion, matrix };

}  // namespace rigor
