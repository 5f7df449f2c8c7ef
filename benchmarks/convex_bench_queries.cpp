// Shapes and queries of rigor_convex_bench: seeded, the same on every machine.

#include "convex_bench.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/math/rotation.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace rigor::bench {
namespace {

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}

  double uniform(double lower, double upper) {
    return lower + (upper - lower) * std::ldexp(static_cast<double>(engine_() >> 11), -53);
  }
  int pick(int count) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(count)); }
  double size() { return uniform(0.15, 0.7); }
  Vec3 sizes() {
    const double x = size();
    const double y = size();
    return {x, y, size()};
  }
  Vec3 direction() {
    const double z = uniform(-1, 1);
    const double angle = uniform(0, 2 * std::numbers::pi);
    const double r = std::sqrt(1 - z * z);
    return Vec3(r * std::cos(angle), r * std::sin(angle), z).normalized();
  }
  Mat3 rotation() {
    const double angle = uniform(0, std::numbers::pi);
    return rotation_matrix(rotation_exp(angle * direction()));
  }

 private:
  std::mt19937_64 engine_;
};

/// Points on an ellipsoid, so that all are vertices.
Shape hull_of(Draw& draw, int count) {
  const Vec3 radii = draw.sizes();
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) points.push_back(radii.cwiseProduct(draw.direction()));
  return Convex{std::make_shared<const ConvexHull>(std::get<ConvexHull>(make_convex_hull(points)))};
}

Shape draw_shape(Draw& draw, int kind) {
  const double size = draw.size();
  switch (kind) {
    case 0:
      return Sphere{size};
    case 1:
      return Box{draw.sizes()};
    case 2:
      return Capsule{size, draw.size()};
    case 3:
      return Cylinder{size, draw.size()};
    case 4:
      return Cone{size, draw.size()};
    case 5:
      return Ellipsoid{draw.sizes()};
    default:
      return hull_of(draw, 8 << (2 * (kind - 6)));
  }
}

/// Moves B along u until the pair is `gap` apart. Along a line the signed distance is convex, so that
/// Newton's method from afar never passes the point. Only the placement: no truth comes from here.
void place_at(const std::vector<Shape>& shapes, const Vec3& u, double gap, ConvexQuery& query) {
  const Shape& a = shapes[static_cast<std::size_t>(query.a)];
  const Shape& b = shapes[static_cast<std::size_t>(query.b)];
  query.X_WB.p = query.X_WA.p + 5 * u;
  for (int i = 0; i < 100; ++i) {
    const DistanceResult r = signed_distance(a, query.X_WA, b, query.X_WB);
    const double step = (r.distance - gap) / r.n_W.dot(u);
    query.X_WB.p -= step * u;
    if (std::abs(step) < 1e-9) return;
  }
}

void place(const std::vector<Shape>& shapes, Regime regime, int index, Draw& draw, ConvexQuery& query) {
  const Vec3 u = draw.direction();
  switch (regime) {
    case Regime::separated:
      return place_at(shapes, u, draw.uniform(0.02, 1), query);
    case Regime::touching:
      return place_at(shapes, u, index % 2 ? 1e-6 : -1e-6, query);
    case Regime::shallow:
      return place_at(shapes, u, -draw.uniform(5e-4, 2e-2), query);
    case Regime::deep: {
      place_at(shapes, u, 0, query);
      const double part = draw.uniform(0, 0.6);
      query.X_WB.p = query.X_WA.p + part * (query.X_WB.p - query.X_WA.p);
      return;
    }
  }
}

}  // namespace

std::vector<Shape> bench_shapes() {
  Draw draw(20261122);
  std::vector<Shape> shapes;
  for (int kind = 0; kind < kKinds; ++kind) {
    for (int i = 0; i < kInstances; ++i) shapes.push_back(draw_shape(draw, kind));
  }
  return shapes;
}

std::vector<ConvexQuery> bench_queries(const std::vector<Shape>& shapes, Regime regime) {
  Draw draw(1 + static_cast<std::uint64_t>(regime));
  std::vector<ConvexQuery> queries;
  for (int kind_a = 0; kind_a < kKinds; ++kind_a) {
    for (int kind_b = kind_a; kind_b < kKinds; ++kind_b) {
      for (int i = 0; i < kQueriesAPair; ++i) {
        const int a = kind_a * kInstances + draw.pick(kInstances);
        const int b = kind_b * kInstances + draw.pick(kInstances);
        const double x = draw.uniform(-1, 1);
        const double y = draw.uniform(-1, 1);
        const double z = draw.uniform(-1, 1);
        ConvexQuery query{a, b, {draw.rotation(), Vec3(x, y, z)}, {draw.rotation(), Vec3::Zero()}};
        place(shapes, regime, i, draw, query);
        queries.push_back(query);
      }
    }
  }
  return queries;
}

}  // namespace rigor::bench
