#include "coherent_peers.hpp"

#include "rigor/geometry/shape/convex_hull.hpp"

#include <memory>

#ifdef RIGOR_BENCH_FCL
#include <fcl/fcl.h>
#endif
#ifdef RIGOR_BENCH_BULLET
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>
#endif

namespace rigor::bench {
namespace {

#ifdef RIGOR_BENCH_FCL
std::shared_ptr<fcl::CollisionGeometryd> fcl_shape(const Convex& convex) {
  const ConvexHull& hull = *convex.hull;
  const auto vertices = std::make_shared<const std::vector<Vec3>>(hull.vertices);
  const auto faces = std::make_shared<std::vector<int>>();
  for (const std::vector<int>& loop : hull.faces) {
    faces->push_back(static_cast<int>(loop.size()));
    faces->insert(faces->end(), loop.begin(), loop.end());
  }
  return std::make_shared<fcl::Convexd>(vertices, static_cast<int>(hull.faces.size()), faces);
}

fcl::Transform3d fcl_pose(const Pose& X) {
  fcl::Transform3d result = fcl::Transform3d::Identity();
  result.linear() = X.R;
  result.translation() = X.p;
  return result;
}

DistanceQuery fcl_query(const Convex& a, const Convex& b) {
  const auto object_a = std::make_shared<fcl::CollisionObjectd>(fcl_shape(a));
  const auto object_b = std::make_shared<fcl::CollisionObjectd>(fcl_shape(b));
  return [object_a, object_b](const Pose& X_WA, const Pose& X_WB) {
    object_a->setTransform(fcl_pose(X_WA));
    object_b->setTransform(fcl_pose(X_WB));
    fcl::DistanceRequestd request(true, true);
    request.gjk_solver_type = fcl::GST_LIBCCD;
    fcl::DistanceResultd result;
    return fcl::distance(object_a.get(), object_b.get(), request, result);
  };
}
#endif

#ifdef RIGOR_BENCH_BULLET
std::shared_ptr<btConvexHullShape> bullet_shape(const Convex& convex) {
  const auto shape = std::make_shared<btConvexHullShape>();
  for (const Vec3& v : convex.hull->vertices) shape->addPoint({v.x(), v.y(), v.z()}, false);
  shape->recalcLocalAabb();
  shape->setMargin(0);
  return shape;
}

btTransform bullet_pose(const Pose& X) {
  const Mat3& R = X.R;
  const btMatrix3x3 rotation(R(0, 0), R(0, 1), R(0, 2), R(1, 0), R(1, 1), R(1, 2), R(2, 0), R(2, 1), R(2, 2));
  return btTransform(rotation, btVector3(X.p.x(), X.p.y(), X.p.z()));
}

DistanceQuery bullet_query(const Convex& a, const Convex& b) {
  const auto shape_a = bullet_shape(a), shape_b = bullet_shape(b);
  return [shape_a, shape_b](const Pose& X_WA, const Pose& X_WB) {
    btVoronoiSimplexSolver simplex;
    btGjkEpaPenetrationDepthSolver depth;
    btGjkPairDetector detector(shape_a.get(), shape_b.get(), &simplex, &depth);
    btGjkPairDetector::ClosestPointInput input;
    input.m_transformA = bullet_pose(X_WA);
    input.m_transformB = bullet_pose(X_WB);
    input.m_maximumDistanceSquared = BT_LARGE_FLOAT;
    btPointCollector found;
    detector.getClosestPoints(input, found, nullptr);
    return static_cast<double>(found.m_distance);
  };
}
#endif

}  // namespace

std::vector<DistancePeer> distance_peers() {
  return {
#ifdef RIGOR_BENCH_FCL
      {"FCL (libccd)", fcl_query},
#endif
#ifdef RIGOR_BENCH_BULLET
      {"Bullet", bullet_query},
#endif
  };
}

}  // namespace rigor::bench
