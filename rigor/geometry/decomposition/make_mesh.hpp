#pragma once

#include "rigor/geometry/shape/shape.hpp"

#include <memory>

namespace rigor {

/// A mesh shape with its tree, built once and shared by all copies.
Mesh make_mesh(std::shared_ptr<const TriangleMesh> mesh);

}  // namespace rigor
