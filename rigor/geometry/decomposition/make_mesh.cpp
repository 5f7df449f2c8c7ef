#include "rigor/geometry/decomposition/make_mesh.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/geometry/decomposition/mesh_solid.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"

namespace rigor {

Mesh make_mesh(std::shared_ptr<const TriangleMesh> mesh) {
  RIGOR_ASSERT(mesh != nullptr);
  const std::shared_ptr<const TriangleTree> tree = make_triangle_tree(*mesh);
  return {mesh, tree, std::make_shared<const MeshSolid>(mesh, tree)};
}

}  // namespace rigor
