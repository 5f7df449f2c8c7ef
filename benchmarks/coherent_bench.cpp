// Distance and penetration of convex polyhedra that move a little from query to query: the feature walk and
// the climb on the Gauss map, warm and cold, beside our GJK and the libraries that are installed.

#include "coherent_peers.hpp"

#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/distance/distance_cache.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/math/rotation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace rigor;
using namespace rigor::bench;

constexpr int kSequences = 60, kQueries = 10, kPasses = 7;
/// Motion from query to query [rad], [m].
constexpr double kTurn = 0.6 * std::numbers::pi / 180, kStep = 3e-3;

class Draw {
 public:
  double uniform(double lower, double upper) {
    return lower + (upper - lower) * std::ldexp(static_cast<double>(engine_() >> 11), -53);
  }
  Vec3 direction() {
    const double z = uniform(-1, 1), angle = uniform(0, 2 * std::numbers::pi);
    return {std::sqrt(1 - z * z) * std::cos(angle), std::sqrt(1 - z * z) * std::sin(angle), z};
  }
  /// A box, or a hull of so many points on an ellipsoid.
  Convex polyhedron(int vertices) {
    const Vec3 radii(uniform(0.15, 0.7), uniform(0.15, 0.7), uniform(0.15, 0.7));
    if (vertices == 0) return {std::make_shared<const ConvexHull>(make_box_hull(radii))};
    std::vector<Vec3> points;
    for (int i = 0; i < vertices; ++i) points.push_back(radii.cwiseProduct(direction()));
    return {std::make_shared<const ConvexHull>(std::get<ConvexHull>(make_convex_hull(points)))};
  }
  Mat3 rotation() { return rotation_matrix(rotation_exp(uniform(0, std::numbers::pi) * direction())); }

 private:
  std::mt19937_64 engine_{6};
};

/// What we see of it: a box as such.
Shape own_shape(const Convex& convex) {
  const ConvexHull& hull = *convex.hull;
  if (hull.faces.size() == 6 && hull.vertices.size() == 8) return Box{hull.vertices[7]};
  return convex;
}

enum class Regime { separated, shallow, deep };

/// A pair and its poses.
struct Sequence {
  Convex a, b;
  std::vector<Pose> X_WA, X_WB;
};

/// Separated by 0.02 to 1 m, overlapping by 0.5 to 20 mm, or with centres at less than 0.6 of the distance at
/// which they touch.
Sequence make_sequence(int vertices, Regime regime, Draw& draw) {
  Sequence s{draw.polyhedron(vertices), draw.polyhedron(vertices), {}, {}};
  const Pose X_WA{draw.rotation(), 0.1 * draw.direction()};
  Pose X_WB{draw.rotation(), X_WA.p + 3 * draw.direction()};
  const Vec3 direction = (X_WB.p - X_WA.p).normalized();
  const double gap = regime == Regime::separated ? draw.uniform(0.02, 1) : -draw.uniform(5e-4, 2e-2);
  double low = 0, high = 3;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    X_WB.p = X_WA.p + middle * direction;
    (signed_distance(s.a, X_WA, s.b, X_WB).distance > (regime == Regime::deep ? 0 : gap) ? high : low) =
        middle;
  }
  if (regime == Regime::deep) X_WB.p = X_WA.p + draw.uniform(0, 0.6) * high * direction;
  // Across the normal, so that the regime lasts.
  const Vec3 n = signed_distance(s.a, X_WA, s.b, X_WB).n_W;
  const Vec3 step = kStep * n.cross(draw.direction()).normalized();
  const Vec3 axis = draw.direction();
  for (int k = 0; k < kQueries; ++k) {
    s.X_WA.push_back(X_WA);
    s.X_WB.push_back({rotation_matrix(rotation_exp(k * kTurn * axis)) * X_WB.R, X_WB.p + k * step});
  }
  return s;
}

/// Nanoseconds a query: the fastest of some passes over all queries after the first. Also adds up what the
/// queries return, so that no compiler leaves them out.
template <typename Pass>
double time_of(const Pass& pass) {
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kPasses; ++i) best = std::min(best, pass());
  return best / (kQueries - 1);
}

double now() {
  return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

volatile double sink;

double time_of_warm_walk(const Sequence& s) {
  const Shape a = own_shape(s.a), b = own_shape(s.b);
  return time_of([&] {
    DistanceCache cache;
    double sum = walked_distance(a, s.X_WA[0], b, s.X_WB[0], cache).distance;
    const double begin = now();
    for (std::size_t k = 1; k < kQueries; ++k)
      sum += walked_distance(a, s.X_WA[k], b, s.X_WB[k], cache).distance;
    const double end = now();
    sink = sum;
    return end - begin;
  });
}

double time_of_query(const Sequence& s, const DistanceQuery& query) {
  return time_of([&] {
    double sum = query(s.X_WA[0], s.X_WB[0]);
    const double begin = now();
    for (std::size_t k = 1; k < kQueries; ++k) sum += query(s.X_WA[k], s.X_WB[k]);
    const double end = now();
    sink = sum;
    return end - begin;
  });
}

DistanceQuery cold_walk(const Convex& a, const Convex& b) {
  return [a = own_shape(a), b = own_shape(b)](const Pose& X_WA, const Pose& X_WB) {
    DistanceCache cache;
    return walked_distance(a, X_WA, b, X_WB, cache).distance;
  };
}

DistanceQuery gjk(const Convex& a, const Convex& b) {
  return [a = own_shape(a), b = own_shape(b)](const Pose& X_WA, const Pose& X_WB) {
    return signed_distance(a, X_WA, b, X_WB).distance;
  };
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<long>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

void print_rows(Regime regime, const std::string& title) {
  std::vector<DistancePeer> methods = {{"walk, cold", cold_walk}, {"GJK", gjk}};
  for (const DistancePeer& peer : distance_peers()) methods.push_back(peer);
  fmt::print("\n{} (median of {} sequences; ns a query)\n{:<8} {:>11}", title, kSequences, "", "walk, warm");
  for (const DistancePeer& method : methods) fmt::print(" {:>13}", method.name);
  fmt::print("   largest difference of walk and GJK [m]\n");
  Draw draw;
  for (const int vertices : {0, 8, 32, 128, 512}) {
    std::vector<double> warm;
    std::vector<std::vector<double>> times(methods.size());
    double difference = 0;
    for (int i = 0; i < kSequences; ++i) {
      const Sequence s = make_sequence(vertices, regime, draw);
      warm.push_back(time_of_warm_walk(s));
      for (std::size_t m = 0; m < methods.size(); ++m)
        times[m].push_back(time_of_query(s, methods[m].make_query(s.a, s.b)));
      DistanceCache cache;
      for (std::size_t k = 0; k < kQueries; ++k) {
        const double walked =
            walked_distance(own_shape(s.a), s.X_WA[k], own_shape(s.b), s.X_WB[k], cache).distance;
        difference =
            std::max(difference, std::abs(walked - signed_distance(s.a, s.X_WA[k], s.b, s.X_WB[k]).distance));
      }
    }
    fmt::print("{:<8} {:>11.0f}", vertices == 0 ? "box" : fmt::format("hull{}", vertices), median(warm));
    for (const std::vector<double>& of_method : times) fmt::print(" {:>13.0f}", median(of_method));
    fmt::print("   {:.1e}\n", difference);
  }
}

}  // namespace

int main() {
  fmt::print("Convex polyhedra in coherent motion: {:.1f} degrees and {:g} mm from query to query\n",
             kTurn * 180 / std::numbers::pi, 1000 * kStep);
  print_rows(Regime::separated, "separated, 0.02 to 1 m");
  print_rows(Regime::shallow, "shallow penetration, 0.5 to 20 mm");
  print_rows(Regime::deep, "deep penetration");
  return 0;
}
