#include "rigor/geometry/decomposition/make_mesh.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/geometry/decomposition/mesh_solid.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"

#include <memory>
#include <utility>

namespace rigor {

Mesh make_mesh(std::shared_ptr<const TriangleMesh> mesh) {
  RIGOR_ASSERT(mesh != nullptr);
  std::shared_ptr<const TriangleTree> tree = make_triangle_tree(*mesh);
  std::shared_ptr<const MeshSolid> solid = std::make_shared<const MeshSolid>(mesh, tree);
  return {std::move(mesh), std::move(tree), std::move(solid)};
}

}  // namespace rigor
