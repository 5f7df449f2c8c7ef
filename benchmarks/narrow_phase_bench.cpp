// What the narrow phase of the many-body path costs: ns a pair, of pairs that rest, move and are apart.

#include "rigor/bulk/narrow_phase/narrow_phase.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/model_builder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <random>

namespace {

using namespace rigor;

std::mt19937_64 engine(1);

double uniform(double lower, double upper) {
  return lower + (upper - lower) * std::ldexp(static_cast<double>(engine() >> 11), -53);
}

Vec3 random_vector() {
  return Vec3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
}

/// Bodies with one shape each and the pairs between them.
struct Scene {
  std::vector<Shape> shapes;
  BulkBodies bodies;
  std::vector<ShapePair> pairs;

  void add(const Shape& shape, const Vec3& x, const Quat& q) {
    shapes.push_back(shape);
    bodies.x.push_back(x);
    bodies.q.push_back(q);
    bodies.motion.emplace_back();
    bodies.inertia.emplace_back();
  }
  std::shared_ptr<const Model> model() const {
    ModelBuilder builder;
    for (std::size_t k = 0; k < shapes.size(); ++k) {
      BodyDescription body;
      body.name = std::to_string(k);
      body.motion = MotionType::kinematic;
      body.shapes.push_back({shapes[k]});
      builder.add_body(body);
    }
    return builder.build();
  }
};

/// Unit boxes half and half over each other, a hundred in the lowest row.
Scene pyramid() {
  Scene scene;
  constexpr int rows = 100;
  std::vector<int> first;
  for (int i = 0; i < rows; ++i) {
    first.push_back(scene.bodies.count());
    for (int j = 0; j < rows - i; ++j)
      scene.add(Box{Vec3::Constant(0.5)}, Vec3(j - 0.5 * (rows - i - 1), 0.5 + 0.999 * i, 0),
                Quat::Identity());
  }
  const float margin = 0.02f;
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < rows - i; ++j) {
      const int k = first[static_cast<std::size_t>(i)] + j;
      if (j + 1 < rows - i) scene.pairs.push_back({k, k + 1, 0, 0, margin});
      if (i + 1 == rows) continue;
      const int above = first[static_cast<std::size_t>(i + 1)] + j;
      if (j > 0) scene.pairs.push_back({k, above - 1, 0, 0, margin});
      if (j + 1 < rows - i) scene.pairs.push_back({k, above, 0, 0, margin});
    }
  }
  return scene;
}

/// Pairs of their own bodies at gaps between the bounds.
Scene loose_pairs(const std::function<Shape()>& shape, double least_gap, double most_gap) {
  Scene scene;
  for (int k = 0; k < 3000; ++k) {
    const Shape a = shape(), b = shape();
    const auto turn = [] { return rotation_exp(3 * random_vector()); };
    const Quat q_A = turn(), q_B = turn();
    const Vec3 x_A = 100 * random_vector();
    Vec3 x_B = x_A + random_vector();
    const double gap = uniform(least_gap, most_gap);
    for (int step = 0; step < 4; ++step) {
      const DistanceResult distance =
          signed_distance(a, {q_A.toRotationMatrix(), x_A}, b, {q_B.toRotationMatrix(), x_B});
      x_B += (gap - distance.distance) * distance.n_W;
    }
    scene.add(a, x_A, q_A);
    scene.add(b, x_B, q_B);
    scene.pairs.push_back({2 * k, 2 * k + 1, 0, 0, 0.02f});
  }
  return scene;
}

void measure(const char* name, const Scene& scene, double motion) {
  NarrowPhase narrow_phase(*scene.model());
  const Executor executor(1);
  ManifoldList manifolds;
  BulkBodies bodies = scene.bodies;
  double best = INFINITY;
  for (int round = 0; round < 30; ++round) {
    for (int k = 0; k < bodies.count(); ++k) {
      const std::size_t i = static_cast<std::size_t>(k);
      bodies.x[i] = scene.bodies.x[i] + motion * random_vector();
      bodies.q[i] = rotation_exp(motion * random_vector()) * scene.bodies.q[i];
    }
    const auto begin = std::chrono::steady_clock::now();
    narrow_phase.find_manifolds(bodies, scene.pairs, executor, manifolds);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
    best = std::min(best, elapsed.count());
  }
  const std::size_t points = manifolds.all_points();
  fmt::print("{:34} {:6} pairs {:6} manifolds {:6} points  {:8.1f} ns a pair\n", name, scene.pairs.size(),
             manifolds.size(), points, 1e9 * best / static_cast<double>(scene.pairs.size()));
}

Shape random_hull() {
  std::vector<Vec3> points;
  const int count = 20 + static_cast<int>(uniform(0, 11));
  for (int k = 0; k < count; ++k) points.push_back(0.5 * random_vector().normalized());
  return Convex{std::make_shared<const ConvexHull>(std::get<ConvexHull>(make_convex_hull(points)))};
}

}  // namespace

int main() {
  const Shape cube = Box{Vec3(0.6, 0.3, 0.4)};
  std::vector<Shape> hulls;
  for (int k = 0; k < 11; ++k) hulls.push_back(random_hull());
  const auto box = [&] { return cube; };
  const auto hull = [&] { return hulls[static_cast<std::size_t>(uniform(0, 10.99))]; };
  measure("pyramid of boxes, at rest", pyramid(), 1e-6);
  measure("pyramid of boxes, moving", pyramid(), 1e-3);
  measure("boxes touching, moving", loose_pairs(box, -0.01, 0.01), 1e-3);
  measure("boxes apart", loose_pairs(box, 0.03, 0.3), 1e-3);
  measure("hulls touching, moving", loose_pairs(hull, -0.01, 0.01), 1e-3);
  measure("hulls apart", loose_pairs(hull, 0.03, 0.3), 1e-3);
  measure("box and hull touching",
          loose_pairs([&] { return uniform(0, 1) < 0.5 ? cube : hull(); }, -0.01, 0.01), 1e-3);
  measure("spheres touching", loose_pairs([] { return Shape(Sphere{0.5}); }, -0.01, 0.01), 1e-3);
  measure("capsules touching", loose_pairs([] { return Shape(Capsule{0.1, 0.2}); }, -0.01, 0.01), 1e-3);
  measure("capsule and box touching",
          loose_pairs(
              [&] {
                return uniform(0, 1) < 0.5 ? cube : Shape(Capsule{0.1, 0.2});
              },
              -0.01, 0.01),
          1e-3);
  return 0;
}
