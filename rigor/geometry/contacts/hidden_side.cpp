#include "rigor/geometry/contacts/hidden_side.hpp"

#include "rigor/geometry/shape/support.hpp"

#include <algorithm>
#include <variant>

namespace rigor {

namespace {

bool is_bounded_convex(const Shape& shape) {
  return !is_unbounded(shape) && !std::holds_alternative<Mesh>(shape);
}

/// max of n · (p - origin) over a shape [m].
double extent_along(const Vec3& n, const Shape& shape, const Pose& X_WS, const Vec3& origin) {
  return support_value(shape, X_WS.R.transpose() * n) + n.dot(X_WS.p - origin);
}

}  // namespace

bool hides_side(const GroundPlane& plane, const Shape& body, const Pose& X_WB, const Shape& side,
                const Pose& X_WS, double slack) {
  if (!is_bounded_convex(body) || !is_bounded_convex(side)) return false;
  return extent_along(plane.n_W, side, X_WS, plane.p_W) <= slack &&
         -extent_along(-plane.n_W, body, X_WB, plane.p_W) >= std::min(0.0, plane.gap) - slack;
}

}  // namespace rigor
