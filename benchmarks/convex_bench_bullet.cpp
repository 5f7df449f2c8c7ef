// Bullet's GJK and EPA kernel (float64, margin 0) as a peer of rigor_convex_bench. Its pipeline has special
// routines for some pairs, such as two boxes, that are not called here.

#include "convex_bench.hpp"
#include "rigor/geometry/shape/support.hpp"

#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>
#include <btBulletCollisionCommon.h>

namespace rigor::bench {
namespace {

btVector3 vector_of(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

/// Any shape by its support points; spheres and hulls use Bullet's own.
class SupportShape : public btConvexInternalShape {
 public:
  explicit SupportShape(const Shape& shape) : shape_(shape) {
    m_shapeType = CUSTOM_CONVEX_SHAPE_TYPE;
    setMargin(0);
  }
  btVector3 localGetSupportingVertexWithoutMargin(const btVector3& d) const override {
    if (d.length2() == 0) return vector_of(support_point(shape_, Vec3::UnitX()));
    return vector_of(support_point(shape_, Vec3(d.x(), d.y(), d.z())));
  }
  btVector3 localGetSupportingVertex(const btVector3& d) const override {
    return localGetSupportingVertexWithoutMargin(d);
  }
  void batchedUnitVectorGetSupportingVertexWithoutMargin(const btVector3* d, btVector3* points,
                                                         int count) const override {
    for (int i = 0; i < count; ++i) points[i] = localGetSupportingVertexWithoutMargin(d[i]);
  }
  void calculateLocalInertia(btScalar, btVector3& inertia) const override { inertia.setZero(); }
  const char* getName() const override { return "support"; }

 private:
  Shape shape_;
};

std::shared_ptr<btConvexShape> make_bullet(const Shape& shape) {
  if (const Sphere* const sphere = std::get_if<Sphere>(&shape))
    return std::make_shared<btSphereShape>(sphere->radius);
  if (const Box* const box = std::get_if<Box>(&shape)) {
    auto result = std::make_shared<btBoxShape>(vector_of(box->half_extents));
    result->setMargin(0);
    return result;
  }
  if (const Capsule* const capsule = std::get_if<Capsule>(&shape))
    return std::make_shared<btCapsuleShapeZ>(capsule->radius, 2 * capsule->half_length);
  return std::make_shared<SupportShape>(shape);
}

btTransform transform(const Pose& X) {
  const Mat3& R = X.R;
  return btTransform(
      btMatrix3x3(R(0, 0), R(0, 1), R(0, 2), R(1, 0), R(1, 1), R(1, 2), R(2, 0), R(2, 1), R(2, 2)),
      vector_of(X.p));
}

}  // namespace

ConvexEngine bullet_kernel_engine(const std::vector<Shape>& shapes) {
  std::vector<std::shared_ptr<btConvexShape>> own;
  for (const Shape& shape : shapes) own.push_back(make_bullet(shape));
  return {"bullet f64", true, [own](const ConvexQuery& q) -> std::optional<EngineAnswer> {
            btVoronoiSimplexSolver simplex;
            btGjkEpaPenetrationDepthSolver penetration;
            btGjkPairDetector detector(own[static_cast<std::size_t>(q.a)].get(),
                                       own[static_cast<std::size_t>(q.b)].get(), &simplex, &penetration);
            btGjkPairDetector::ClosestPointInput input;
            input.m_transformA = transform(q.X_WA);
            input.m_transformB = transform(q.X_WB);
            btPointCollector collector;
            detector.getClosestPoints(input, collector, nullptr);
            if (!collector.m_hasResult) return std::nullopt;
            const btVector3& n = collector.m_normalOnBInWorld;
            return EngineAnswer{collector.m_distance, Vec3(-n.x(), -n.y(), -n.z())};
          }};
}

}  // namespace rigor::bench
