#include "rigor/geometry/motion/moving_part.hpp"

#include "rigor/geometry/mesh/tree_walk.hpp"
#include "rigor/geometry/shape/support.hpp"

#include <algorithm>

namespace rigor {

PartName first_part(const Shape& shape, bool against_unbounded) {
  if (against_unbounded || !std::holds_alternative<Mesh>(shape)) return {};
  return {PartName::Kind::node, 0};
}

std::vector<PartName> parts_of_node(const Mesh& mesh, int node) {
  const std::size_t at = static_cast<std::size_t>(node);
  std::vector<PartName> parts;
  if (is_leaf(*mesh.tree, at)) {
    for_each_triangle(*mesh.tree, at, [&](int t) { parts.push_back({PartName::Kind::triangle, t}); });
  } else {
    for_each_child(*mesh.tree, at, [&](std::size_t child) {
      parts.push_back({PartName::Kind::node, static_cast<int>(child)});
    });
  }
  return parts;
}

MovingPart::MovingPart(const MovingShape& moving, const PartName& name, const RigidMotion::Sample* sample) {
  const Shape& shape = *moving.shape;
  // The whole shape: its own core.
  if (name.kind == PartName::Kind::whole) {
    core_ = make_moving_core(shape, moving.X_BS, radius_about(shape, Vec3::Zero()), *moving.motion);
    core_.sample = sample;
    return;
  }
  const Mesh& mesh = *std::get_if<Mesh>(&shape);
  core_.X_BC = moving.X_BS;
  core_.motion = moving.motion;
  core_.sample = sample;
  // A node: its box about the box's centre, which holds all triangles below the node.
  if (name.is_node()) {
    const Aabb& box = node_box(*mesh.tree, static_cast<std::size_t>(name.index));
    core_.core = make_core(Box{0.5 * (box.upper - box.lower)});
    core_.X_BC.p = moving.X_BS * Vec3(0.5 * (box.upper + box.lower));
    core_.turning_radius = core_.X_BC.p.norm() + core_.core.extent;
    return;
  }
  // A triangle: its corners are taken relative to the first one, so that no digits are lost far from the
  // origin of the mesh.
  const std::array<int, 3>& vertices = mesh.mesh->triangles[static_cast<std::size_t>(name.index)];
  const Vec3& origin = mesh.mesh->vertices[static_cast<std::size_t>(vertices[0])];
  core_.turning_radius = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& corner = mesh.mesh->vertices[static_cast<std::size_t>(vertices[k])];
    corners_[k] = corner - origin;
    core_.turning_radius = std::max(core_.turning_radius, (moving.X_BS * corner).norm());
  }
  core_.core = make_points_core(corners_);
  core_.X_BC.p = moving.X_BS * origin;
}

}  // namespace rigor
