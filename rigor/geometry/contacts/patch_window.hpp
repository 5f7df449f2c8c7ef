#pragma once

#include "rigor/geometry/contacts/contact_shape.hpp"
#include "rigor/geometry/shape/shape.hpp"
#include "rigor/math/pose.hpp"

#include <optional>

namespace rigor {

/// The part of a flat patch that a shape can touch, as one facet, if it is convex: what the shape meets there
/// is then the same however the patch is cut into triangles and whatever its border is elsewhere. Nothing
/// for a single triangle or a face, for a patch that is not flat, and where a corner of the border turns
/// inwards under the shape (at the foot of a pillar).
///
/// The part lies in a rectangle about the shape (in O) that is larger on all sides than the shape is deep
/// below the patch and than the reach [m]: no shortest way out of the facet leads through a side that is none
/// of the surface.
std::optional<MeshFacet> patch_window(const Mesh& mesh, int patch, const Pose& X_OM,
                                      const ContactShape& shape, double reach);

}  // namespace rigor
