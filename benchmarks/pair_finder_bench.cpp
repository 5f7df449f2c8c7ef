// Broad phase of the many-body path: CPU time of one search on scenes of boxes and balls, by stage of
// crowding and number; and what it costs to launch a loop on threads.

#include "broad_phase_cases.hpp"
#include "rigor/bulk/broad_phase/pair_finder.hpp"
#include "rigor/model/model_builder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <random>
#include <string>

namespace {

using namespace rigor;
using namespace rigor::bench;

constexpr int kRuns = 30;
constexpr double kStep = 1.0 / 60, kMargin = 0.01;

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// (Not inlined: g++ 12 would then see members of a Shape used that are not there.)
[[gnu::noinline]] void add(const std::string& name, MotionType motion, const Shape& shape, const Vec3& place,
                           ModelBuilder& builder) {
  BodyDescription body;
  body.name = name;
  body.motion = motion;
  body.p_WU = place;
  const ShapeDescription description{shape, Vec3::Zero(), Quat::Identity(), "", ""};
  body.shapes.push_back(description);
  builder.add_body(body);
}

void add_floor(ModelBuilder& builder) {
  const Shape floor = Box{Vec3(200, 200, 1)};
  add("floor", MotionType::fixed, floor, Vec3(0, 0, -1), builder);
}

/// Touching unit boxes, `rows` of them at the bottom.
std::shared_ptr<const Model> pyramid(int rows) {
  ModelBuilder builder;
  add_floor(builder);
  const Shape box = Box{Vec3(0.5, 0.5, 0.5)};
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < rows - i; ++j)
      add("b" + std::to_string(1000 * i + j), MotionType::dynamic, box,
          Vec3(j - 0.5 * (rows - i - 1), 0, 0.5 + i), builder);
  }
  return builder.build();
}

/// A heap of about the density of one that has settled, turning and moving slowly: boxes of three kinds, or
/// balls.
std::shared_ptr<const Model> heap(int count, bool is_of_balls, double pitch) {
  std::mt19937 generator(17);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto vector = [&] {
    const double x = uniform(generator), y = uniform(generator), z = uniform(generator);
    return Vec3(x, y, z);
  };
  const std::vector<Shape> boxes = {Box{Vec3(0.5, 0.5, 0.5)}, Box{Vec3(0.6, 0.3, 0.4)},
                                    Box{Vec3(0.3, 0.3, 0.7)}};
  const Shape ball = Sphere{0.5};
  const int side = static_cast<int>(std::ceil(std::cbrt(count)));
  ModelBuilder builder;
  add_floor(builder);
  for (int i = 0; i < count; ++i) {
    BodyDescription body;
    body.name = "b" + std::to_string(i);
    body.p_WU = pitch * Vec3(i % side, i / side % side, i / (side * side)) + 0.05 * vector();
    body.q_WU =
        Quat(uniform(generator), uniform(generator), uniform(generator), uniform(generator)).normalized();
    body.velocity = 0.1 * vector();
    body.angular_velocity = 0.1 * vector();
    const ShapeDescription description{is_of_balls ? ball : boxes[static_cast<std::size_t>(i % 3)],
                                       Vec3::Zero(), Quat::Identity(), "", ""};
    body.shapes.push_back(description);
    builder.add_body(body);
  }
  return builder.build();
}

/// The least time of a search, with one and with two threads.
void time_search(const char* name, const std::shared_ptr<const Model>& model) {
  const BulkBodies bodies = read_bulk_bodies(*model, make_initial_state(*model));
  PairFinder finder(*model);
  std::vector<ShapePair> pairs;
  double least_cpu = 1e30, least_wall = 1e30;
  const Executor one(1), two(2);
  for (int run = 0; run < kRuns; ++run) {
    const double start = cpu_seconds();
    finder.find_pairs(bodies, kStep, kMargin, one, pairs);
    least_cpu = std::min(least_cpu, cpu_seconds() - start);
    const double wall_start = wall_seconds();
    finder.find_pairs(bodies, kStep, kMargin, two, pairs);
    least_wall = std::min(least_wall, wall_seconds() - wall_start);
  }
  fmt::print("  {:<20} {:>8} {:>9} {:>12.3f} {:>14.3f} {:>10.0f}\n", name, model->body_count() - 1,
             pairs.size(), 1e3 * least_cpu, 1e3 * least_wall, 1e9 * least_cpu / (model->body_count() - 1));
  std::fflush(stdout);
}

/// The least mean time of a loop of 64 rounds that do next to nothing.
double launch_time(int threads) {
  constexpr int launches = 2000;
  const Executor executor(threads);
  std::vector<int> counts(64);
  double least = 1e30;
  for (int run = 0; run < kRuns; ++run) {
    const double start = wall_seconds();
    for (int i = 0; i < launches; ++i) {
      executor.for_ranges(64, 8, [&](int begin, int end) {
        for (int k = begin; k < end; ++k) ++counts[static_cast<std::size_t>(k)];
      });
    }
    least = std::min(least, (wall_seconds() - start) / launches);
  }
  return least;
}

}  // namespace

int main() {
  fmt::print("Pairs of the many-body path: least of {} searches\n", kRuns);
  fmt::print("  {:<20} {:>8} {:>9} {:>12} {:>14} {:>10}\n", "", "bodies", "pairs", "1 thread ms",
             "2 threads ms", "ns a body");
  time_search("pyramid", pyramid(20));
  time_search("pyramid", pyramid(100));
  time_search("heap of balls", heap(1000, true, 1.0));
  time_search("rain of boxes", heap(8000, false, 1.7));
  for (const int count : {1000, 8000, 99999}) time_search("heap of boxes", heap(count, false, 1.1));
  fmt::print("A loop of 64 short rounds: {:.2f} us on one thread, {:.2f} us on two, {:.2f} us on eight\n",
             1e6 * launch_time(1), 1e6 * launch_time(2), 1e6 * launch_time(8));
}
