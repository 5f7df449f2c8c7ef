// libccd's own MPR and EPA as peers of rigor_convex_bench: overlapping pairs only.

#include "convex_bench.hpp"
#include "rigor/geometry/shape/support.hpp"

#include <ccd/ccd.h>

#include <cmath>

namespace rigor::bench {
namespace {

struct Body {
  const Shape& shape;
  const Pose& X;
};

void support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* point) {
  const Body& body = *static_cast<const Body*>(object);
  const Vec3 d(direction->v[0], direction->v[1], direction->v[2]);
  const Vec3 p = body.X * support_point(body.shape, body.X.R.transpose() * d);
  ccdVec3Set(point, p.x(), p.y(), p.z());
}

void center(const void* object, ccd_vec3_t* point) {
  const Vec3& p = static_cast<const Body*>(object)->X.p;
  ccdVec3Set(point, p.x(), p.y(), p.z());
}

template <class Solver>
ConvexEngine engine_of(const std::string& name, const std::vector<Shape>& shapes, Solver solver) {
  return {name, false, [shapes, solver](const ConvexQuery& q) -> std::optional<EngineAnswer> {
            ccd_t ccd;
            CCD_INIT(&ccd);
            ccd.support1 = support;
            ccd.support2 = support;
            ccd.center1 = center;
            ccd.center2 = center;
            ccd.max_iterations = 500;
            ccd.epa_tolerance = 1e-6;
            ccd.mpr_tolerance = 1e-6;
            const Body a{shapes[static_cast<std::size_t>(q.a)], q.X_WA};
            const Body b{shapes[static_cast<std::size_t>(q.b)], q.X_WB};
            ccd_real_t depth = 0;
            ccd_vec3_t direction;
            ccd_vec3_t position;
            if (solver(&a, &b, &ccd, &depth, &direction, &position) != 0) return std::nullopt;
            const Vec3 n(direction.v[0], direction.v[1], direction.v[2]);
            EngineAnswer answer{-depth, std::nullopt};
            if (n.norm() > 0) answer.n_W = n.normalized();
            return answer;
          }};
}

}  // namespace

ConvexEngine ccd_mpr_engine(const std::vector<Shape>& shapes) {
  return engine_of("libccd MPR", shapes, ccdMPRPenetration);
}

ConvexEngine ccd_epa_engine(const std::vector<Shape>& shapes) {
  return engine_of("libccd EPA", shapes, ccdGJKPenetration);
}

}  // namespace rigor::bench
