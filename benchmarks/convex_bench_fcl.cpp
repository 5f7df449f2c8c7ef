// FCL 0.7 with its libccd solver as a peer of rigor_convex_bench.

#include "convex_bench.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"

#include <fcl/narrowphase/distance.h>

#include <exception>

namespace rigor::bench {
namespace {

struct MakeFcl {
  using Result = std::shared_ptr<fcl::CollisionGeometryd>;

  Result operator()(const Sphere& s) const { return std::make_shared<fcl::Sphered>(s.radius); }
  Result operator()(const Box& s) const { return std::make_shared<fcl::Boxd>(Vec3(2 * s.half_extents)); }
  Result operator()(const Capsule& s) const {
    return std::make_shared<fcl::Capsuled>(s.radius, 2 * s.half_length);
  }
  Result operator()(const Cylinder& s) const {
    return std::make_shared<fcl::Cylinderd>(s.radius, 2 * s.half_length);
  }
  Result operator()(const Cone& s) const { return std::make_shared<fcl::Coned>(s.radius, 2 * s.half_length); }
  Result operator()(const Ellipsoid& s) const { return std::make_shared<fcl::Ellipsoidd>(s.radii); }
  Result operator()(const Convex& s) const {
    auto vertices = std::make_shared<std::vector<Vec3>>(s.hull->vertices);
    auto faces = std::make_shared<std::vector<int>>();
    for (const std::vector<int>& face : s.hull->faces) {
      faces->push_back(static_cast<int>(face.size()));
      faces->insert(faces->end(), face.begin(), face.end());
    }
    return std::make_shared<fcl::Convexd>(vertices, static_cast<int>(s.hull->faces.size()), faces);
  }
  Result operator()(const HalfSpace&) const { return nullptr; }
  Result operator()(const Cavity&) const { return nullptr; }
  Result operator()(const Mesh&) const { return nullptr; }
};

fcl::Transform3d transform(const Pose& X) {
  fcl::Transform3d result = fcl::Transform3d::Identity();
  result.linear() = X.R;
  result.translation() = X.p;
  return result;
}

std::optional<EngineAnswer> solve(const fcl::CollisionGeometryd& a, const fcl::CollisionGeometryd& b,
                                  const ConvexQuery& q) {
  // Spheres at one place keep FCL 0.7 in a loop without end.
  if (q.kind_a() == 0 && q.kind_b() == 0 && (q.X_WA.p - q.X_WB.p).norm() < 1e-6) return std::nullopt;
  fcl::DistanceRequestd request;
  request.enable_nearest_points = true;
  request.enable_signed_distance = true;
  request.gjk_solver_type = fcl::GST_LIBCCD;
  fcl::DistanceResultd result;
  try {
    fcl::distance(&a, transform(q.X_WA), &b, transform(q.X_WB), request, result);
  } catch (const std::exception&) {
    return std::nullopt;
  }
  EngineAnswer answer{result.min_distance, std::nullopt};
  const Vec3 way = result.nearest_points[1] - result.nearest_points[0];
  if (way.norm() > 0) answer.n_W = (result.min_distance < 0 ? -1 : 1) * way.normalized();
  return answer;
}

}  // namespace

ConvexEngine fcl_engine(const std::vector<Shape>& shapes) {
  std::vector<std::shared_ptr<fcl::CollisionGeometryd>> geometries;
  for (const Shape& shape : shapes) geometries.push_back(std::visit(MakeFcl{}, shape));
  return {"fcl (libccd)", true, [geometries](const ConvexQuery& q) {
            return solve(*geometries[static_cast<std::size_t>(q.a)],
                         *geometries[static_cast<std::size_t>(q.b)], q);
          }};
}

}  // namespace rigor::bench
