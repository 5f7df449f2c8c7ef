#include "rigor/geometry/distance/mesh_exit.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/rounding.hpp"
#include "rigor/geometry/convex/convex_distance.hpp"
#include "rigor/geometry/mesh/mesh_point.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/geometry/shape/support.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"

#include <algorithm>
#include <array>

namespace rigor {
namespace {

/// Moves a shape out of a mesh along one direction; everything in the frame of the mesh.
class MeshExit {
 public:
  MeshExit(const Mesh& mesh, const Shape& b, const Pose& X_MB, const Vec3& n_M)
      : mesh_(mesh),
        b_(b),
        core_(make_core(b)),
        X_MB_(X_MB),
        n_(n_M),
        bottom_(n_M.dot(X_MB.p) - support_value(b, X_MB.R.transpose() * -n_M)),
        rounding_(32 * kEpsilon * (mesh.tree->size + X_MB.p.norm())) {}

  double length() const {
    // A triangle that meets the shape is left, for good, once the lowest point of the shape is past its
    // highest. That may bring the shape to other triangles, until all are behind it.
    double t = 0;
    for (bool is_apart = false; !is_apart;) {
      is_apart = true;
      const Pose moved = at_length(t);
      for (const int triangle : mesh_.tree->overlapping(axis_aligned_box(b_, moved))) {
        const double needed = top(triangle) - bottom_;
        if (needed <= t || !meets(triangle, at_length(t))) continue;
        t = needed;
        is_apart = false;
      }
    }
    return mesh_.tree->is_closed && is_inside(at_length(t)) ? past_all() : t;
  }

 private:
  Pose at_length(double t) const { return {X_MB_.R, X_MB_.p + t * n_}; }
  std::array<Vec3, 3> corners(int t) const {
    const std::array<int, 3>& v = mesh_.mesh->triangles[at(t)];
    return {mesh_.mesh->vertices[at(v[0])], mesh_.mesh->vertices[at(v[1])], mesh_.mesh->vertices[at(v[2])]};
  }
  double top(int t) const {
    const std::array<Vec3, 3> p = corners(t);
    return std::max({n_.dot(p[0]), n_.dot(p[1]), n_.dot(p[2])});
  }
  bool meets(int t, const Pose& X_MB) const {
    const std::array<Vec3, 3> p = corners(t);
    return convex_distance(make_points_core(p), Pose{}, core_, X_MB).distance < -rounding_;
  }
  /// The surface does not meet the shape: one point of it tells the side.
  bool is_inside(const Pose& X_MB) const {
    const Vec3 p_M = X_MB * support_point(b_, X_MB.R.transpose() * n_);
    const MeshPoint nearest = nearest_mesh_point(mesh_, p_M);
    return (p_M - nearest.p_M).dot(nearest.normal_M) < 0;
  }
  double past_all() const {
    double highest = -kInfinity;
    for (const Vec3& v : mesh_.mesh->vertices) highest = std::max(highest, n_.dot(v));
    return highest - bottom_;
  }

  const Mesh& mesh_;
  const Shape& b_;
  const ConvexCore core_;
  const Pose X_MB_;
  const Vec3 n_;
  const double bottom_;  ///< Height of the lowest point of the shape along n [m].
  const double rounding_;
};

}  // namespace

double exit_length(const Mesh& mesh, const Pose& X_WM, const Shape& b, const Pose& X_WB, const Vec3& n_W) {
  return MeshExit(mesh, b, X_WM.inverse() * X_WB, X_WM.R.transpose() * n_W).length();
}

}  // namespace rigor
