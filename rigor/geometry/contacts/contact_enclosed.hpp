#pragma once

#include "rigor/geometry/contacts/contact_set.hpp"

#include <optional>

namespace rigor {

/// Of two shapes, one a mesh, whose faces have no contact: if they overlap all the same, as where one lies
/// inside the other solid, the way out as a contact, marked degenerate; its features are face 0 of both.
/// Where the surfaces are apart it looks only at single points until one of them lies in the other's box.
std::optional<ContactPoint> find_enclosed_contact(const Shape& a, const Pose& X_OA, const Shape& b,
                                                  const Pose& X_OB);

}  // namespace rigor
