#include "rigor/geometry/motion/shape_cast.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/geometry/motion/time_of_contact.hpp"

namespace rigor {

std::optional<ShapeCastHit> cast_shape(const ShapeCast& cast, const Shape& other, const Pose& X_WO) {
  RIGOR_ASSERT(cast.translation_W.allFinite());
  // The translation over one unit of time makes the time of contact the fraction of the translation.
  const TwistMotion pushed(cast.X_WS, cast.translation_W, Vec3::Zero());
  const TwistMotion still(X_WO, Vec3::Zero(), Vec3::Zero());
  const MovingShape A{cast.shape, Pose{}, &pushed}, B{&other, Pose{}, &still};
  const TimeOfContact found = find_time_of_contact(A, B, 0, 1);
  if (found.is_complete && !found.is_contact) return std::nullopt;
  // A search that gave up stops the shape where it was proven free. Only shapes that slide along each other
  // make it give up.
  const Vec3 p_W = 0.5 * (found.distance.p_WA + found.distance.p_WB);
  return ShapeCastHit{found.lower, found.upper, p_W, found.distance.n_W};
}

}  // namespace rigor
