#include "rigor/geometry/mesh_penetration/point_depth.hpp"

#include "rigor/geometry/convex/convex_distance.hpp"
#include "rigor/geometry/decomposition/lipschitz_maximum.hpp"
#include "rigor/geometry/decomposition/mesh_solid.hpp"
#include "rigor/geometry/mesh/mesh_point.hpp"
#include "rigor/geometry/shape/aabb.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace rigor {
namespace {

constexpr MaximumGoal kGoal{.relative_gap = 0.01, .max_evaluations = 20000};
/// Depths below this fraction of the size of the smaller solid are not searched for.
constexpr double kFinest = 1e-6;

/// The depth of a point in one solid.
struct PointDepth {
  double depth;       ///< Distance from the surface, negative outside [m].
  Vec3 on_surface_W;  ///< Nearest point of the surface [m].
};

/// The depth of points in one solid, as a function of their position in W.
class DepthField {
 public:
  DepthField(const Shape& shape, const Pose& X_WS)
      : shape_(shape), X_WS_(X_WS), X_SW_(X_WS.inverse()), box_W_(axis_aligned_box(shape, X_WS)) {
    if (const Mesh* const mesh = std::get_if<Mesh>(&shape)) solid_ = solid_of(*mesh);
  }

  const Aabb& box_W() const { return box_W_; }

  PointDepth operator()(const Vec3& p_W) const {
    const Vec3 p_S = X_SW_ * p_W;
    if (const Mesh* const mesh = std::get_if<Mesh>(&shape_)) {
      const MeshPoint nearest = nearest_mesh_point(*mesh, p_S);
      const bool is_inside = solid_->winding()(p_S) >= 1;
      return {is_inside ? nearest.distance : -nearest.distance, X_WS_ * nearest.p_M};
    }
    const std::array<Vec3, 1> point = {p_S};
    const DistanceResult d = convex_distance(make_core(shape_), {}, make_points_core(point), {});
    return {-d.distance, X_WS_ * d.p_WA};
  }

 private:
  const Shape& shape_;
  const Pose& X_WS_;
  Pose X_SW_;
  Aabb box_W_;
  std::shared_ptr<const MeshSolid> solid_;
};

}  // namespace

DistanceResult deepest_point(const Mesh& a, const Pose& X_WA, const Shape& b, const Pose& X_WB) {
  const double infinity = std::numeric_limits<double>::infinity();
  DistanceResult result{0, 0, infinity, X_WA.p, X_WA.p, Vec3::UnitZ()};
  const Shape shape_a = a;
  const DepthField in_a(shape_a, X_WA), in_b(b, X_WB);
  if (!in_a.box_W().overlaps(in_b.box_W())) return result;

  // Branch and bound: the depth changes by no more than the distance between two points. The vertices of the
  // meshes are good first points, since overlaps often begin at them.
  LipschitzFunction depth;
  depth.box = {in_a.box_W().lower.cwiseMax(in_b.box_W().lower),
               in_a.box_W().upper.cwiseMin(in_b.box_W().upper)};
  depth.value = [&](const Vec3& p) { return std::max(in_a(p).depth, in_b(p).depth); };
  depth.beyond = [&](const Vec3& p) { return std::max(0.0, -std::min(in_a(p).depth, in_b(p).depth)); };
  for (const auto& [shape, X_WS] : {std::pair(&shape_a, &X_WA), {&b, &X_WB}}) {
    const Mesh* const mesh = std::get_if<Mesh>(shape);
    if (mesh == nullptr) continue;
    for (const Vec3& v : mesh->mesh->vertices) depth.starts.push_back(*X_WS * v);
  }
  // The accuracy is relative to the depth, but no finer than a small fraction of the smaller solid.
  MaximumGoal goal = kGoal;
  const double size = std::min((in_a.box_W().upper - in_a.box_W().lower).maxCoeff(),
                               (in_b.box_W().upper - in_b.box_W().lower).maxCoeff());
  goal.absolute_gap = kFinest * size;
  const MaximumBounds found = lipschitz_maximum(depth, goal);
  if (!(found.lower > 0)) {
    result.lower = -found.upper;
    return result;
  }
  // Witnesses: the deepest point, and the nearest surface point of the solid in which it is deeper. The
  // normal is the direction from the one to the other.
  const PointDepth of_a = in_a(found.place), of_b = in_b(found.place);
  const bool is_deeper_in_a = of_a.depth >= of_b.depth;
  const double deepest = std::max(of_a.depth, of_b.depth);
  result.distance = result.upper = -deepest;
  result.lower = -std::max(found.upper, deepest);
  result.p_WA = is_deeper_in_a ? of_a.on_surface_W : found.place;
  result.p_WB = is_deeper_in_a ? found.place : of_b.on_surface_W;
  result.n_W = (result.p_WA - result.p_WB) / deepest;
  return result;
}

}  // namespace rigor
