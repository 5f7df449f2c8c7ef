#pragma once

#include "rigor/geometry/contacts/contact_set.hpp"

#include <optional>

namespace rigor {

/// Of two shapes whose surfaces are apart, one a mesh: if one lies inside the other solid, the way out as a
/// contact, marked degenerate; its features are face 0 of both. Looks only at single points until one of them
/// lies in the other's box.
std::optional<ContactPoint> find_enclosed_contact(const Shape& a, const Pose& X_OA, const Shape& b,
                                                  const Pose& X_OB);

}  // namespace rigor
