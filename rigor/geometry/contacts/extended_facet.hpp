#pragma once

#include "rigor/geometry/contacts/contact_shape.hpp"
#include "rigor/geometry/shape/shape.hpp"

namespace rigor {

/// The facet continued in its plane beyond its concave edges, by at least the length along each [m]. There
/// the next face rises out of the plane, so that the solid is below: a shape that would leave the facet alone
/// through such an edge has to leave the continued one in another direction. Nothing that the facet would
/// have beyond its other edges is added. Without a concave edge it is the facet itself.
MeshFacet extended_over_concave_edges(const Mesh& mesh, const MeshFacet& facet, double length);

}  // namespace rigor
