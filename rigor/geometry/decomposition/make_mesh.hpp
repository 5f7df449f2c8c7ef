#pragma once

#include "rigor/geometry/shape/shape.hpp"

#include <memory>

namespace rigor {

/// A mesh shape with its tree, which is built once and shared by all copies of the shape.
Mesh make_mesh(std::shared_ptr<const TriangleMesh> mesh);

}  // namespace rigor
