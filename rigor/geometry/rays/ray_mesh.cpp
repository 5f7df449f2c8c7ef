#include "rigor/geometry/rays/ray_mesh.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/geometry/exact/orientation.hpp"
#include "rigor/geometry/exact/planar_turns.hpp"
#include "rigor/geometry/mesh/tree_walk.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace rigor {
namespace {

bool is_before(const MeshCrossing& a, const MeshCrossing& b) {
  return std::tie(a.s, a.triangle) < std::tie(b.s, b.triangle);
}

/// One line against one mesh (Woop, Benthin and Wald 2013). Every vertex is sheared along the line in the
/// same way for all triangles that share it, so the exact decisions in the plane across the line are
/// consistent.
class Search {
 public:
  Search(const Mesh& mesh, const MeshRay& ray, bool first_only)
      : mesh_(mesh), ray_(ray), first_only_(first_only), to_(ray.to) {
    // The axis along which the line runs fastest becomes z; the shear then takes the line to the z axis.
    // Exchanging x and y where the line runs downwards keeps the orientation of the triangles.
    const Vec3& u = ray.line.u;
    u.cwiseAbs().maxCoeff(&z_);
    x_ = (z_ + 1) % 3;
    y_ = (z_ + 2) % 3;
    if (u(z_) < 0) std::swap(x_, y_);
    shear_ = Vec2(u(x_), u(y_)) / u(z_);
    // Bound of the rounding of a sheared corner, and of the distance of the line from its exact position.
    margin_ = 16 * std::numeric_limits<double>::epsilon() *
              (mesh.tree->size + node_box(*mesh.tree, 0).upper.cwiseAbs().maxCoeff() +
               node_box(*mesh.tree, 0).lower.cwiseAbs().maxCoeff() + ray.line.c.cwiseAbs().maxCoeff());
    visit(0);
  }

  std::vector<MeshCrossing> crossings;

 private:
  /// Parameter at which the line enters the box grown by the margin (slab method); infinity if it does not do
  /// so in the part that is wanted.
  double entry(const Aabb& box) const {
    double in = ray_.from - margin_, out = to_ + margin_;
    for (int axis = 0; axis < 3; ++axis) {
      const double c = ray_.line.c(axis), u = ray_.line.u(axis);
      const double low = box.lower(axis) - margin_ - c, high = box.upper(axis) + margin_ - c;
      if (u == 0) {
        if (low > 0 || high < 0) return kNever;
        continue;
      }
      in = std::max(in, std::min(low / u, high / u));
      out = std::min(out, std::max(low / u, high / u));
    }
    return in <= out ? in : kNever;
  }

  /// Visits the nodes that the line meets, nearest first: a hit that is found early excludes the boxes behind
  /// it.
  void visit(std::size_t node) {
    const TriangleTree& tree = *mesh_.tree;
    if (entry(node_box(tree, node)) == kNever) return;
    if (is_leaf(tree, node)) {
      for_each_triangle(tree, node, [&](int t) { try_triangle(t); });
      return;
    }
    std::array<std::pair<double, std::size_t>, 8> children;
    std::size_t count = 0;
    for_each_child(tree, node, [&](std::size_t child) {
      const double s = entry(node_box(tree, child));
      if (s != kNever) children[count++] = {s, child};
    });
    std::sort(children.begin(), children.begin() + static_cast<std::ptrdiff_t>(count));
    for (std::size_t k = 0; k < count; ++k) visit(children[k].second);
  }

  void try_triangle(int t) {
    const std::array<int, 3>& corners = mesh_.mesh->triangles[at(t)];
    // The corners in the sheared frame: `across` in the plane across the line, and their parameters `along`
    // the line.
    std::array<Vec3, 3> p;
    std::array<Vec2, 3> across;
    Vec3 along;
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = mesh_.mesh->vertices[at(corners[k])];
      const Vec3 v = p[k] - ray_.line.c;
      across[k] = Vec2(v(x_), v(y_)) - v(z_) * shear_;
      along(static_cast<int>(k)) = v(z_) / ray_.line.u(z_);
    }
    const int turns = turns_about(across[0], across[1], across[2], Vec2::Zero());
    // turns > 0: the triangle is counter-clockwise seen from ahead, so the line comes out through it. Whether
    // the triangle is behind the start of the ray is decided exactly.
    if (turns == 0 || orientation(p[0], p[1], p[2], ray_.start_M) * turns > 0) return;

    // The barycentric coordinates of the crossing give its parameter. Weights that rounding made negative are
    // 0.
    Vec3 weight;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2 &a = across[(k + 1) % 3], &b = across[(k + 2) % 3];
      weight(static_cast<int>(k)) = std::max(0.0, turns * (a.x() * b.y() - a.y() * b.x()));
    }
    const double sum = weight.sum();
    const double mean = sum > 0 ? weight.dot(along) / sum : 0.5 * (along.minCoeff() + along.maxCoeff());
    const double s = std::max(ray_.from, mean);
    if (s > to_) return;
    const Vec3 n_M = (p[1] - p[0]).cross(p[2] - p[0]).normalized();
    add({s, t, n_M, turns < 0});
  }

  /// Keeps the crossing. If only the first is wanted, the line then ends there.
  void add(const MeshCrossing& crossing) {
    if (!first_only_) {
      crossings.push_back(crossing);
      return;
    }
    if (!crossings.empty() && !is_before(crossing, crossings.front())) return;
    crossings.assign(1, crossing);
    to_ = crossing.s;
  }

  static constexpr double kNever = std::numeric_limits<double>::infinity();
  const Mesh& mesh_;
  const MeshRay& ray_;
  const bool first_only_;
  double to_;
  int x_ = 0, y_ = 1, z_ = 2;
  Vec2 shear_;
  double margin_;
};

std::vector<MeshCrossing> search(const Mesh& mesh, const MeshRay& ray, bool first_only) {
  RIGOR_ASSERT(mesh.tree != nullptr);
  if (!has_triangles(*mesh.tree)) return {};
  std::vector<MeshCrossing> crossings = Search(mesh, ray, first_only).crossings;
  std::sort(crossings.begin(), crossings.end(), is_before);
  return crossings;
}

}  // namespace

std::vector<MeshCrossing> mesh_crossings(const Mesh& mesh, const MeshRay& ray) {
  return search(mesh, ray, false);
}

std::optional<MeshCrossing> first_mesh_crossing(const Mesh& mesh, const MeshRay& ray) {
  const std::vector<MeshCrossing> crossings = search(mesh, ray, true);
  return crossings.empty() ? std::nullopt : std::optional(crossings.front());
}

}  // namespace rigor
