// What it costs that bodies come and go: grains in a hopper, of which some are taken out and put in above in
// each step.

#include "bulk_runs.hpp"
#include "bulk_scenes.hpp"

#include "rigor/sim/bulk/bulk_simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <random>
#include <vector>

namespace rigor::bench {

namespace {

/// A hopper whose grains come and go.
class Churn {
 public:
  Churn(std::shared_ptr<const Model> model, int changes)
      : simulation_(std::move(model), {.sleeping = false}), changes_(changes) {
    for (const BodyId& body : simulation_.bodies()) {
      const Body& own = simulation_.model().body(body.place);
      if (own.motion == MotionType::dynamic) grains_.push_back(body);
    }
    top_ = 0;
    for (const BodyId& grain : grains_) top_ = std::max(top_, simulation_.pose(grain)->p.z());
  }

  /// CPU time of the changes, and of the step with all [s].
  std::pair<double, double> step() {
    const double begin = bulk_cpu_seconds();
    for (int k = 0; k < changes_; ++k) {
      BodyId& grain = grains_[random_() % grains_.size()];
      // It comes back above the others, as another body.
      BodyDescription description;
      description.p_WU =
          Vec3(simulation_.pose(grain)->p.x(), simulation_.pose(grain)->p.y(), top_ + 0.3 * (k % 20));
      description.shapes.push_back({Sphere{0.125}});
      simulation_.remove_body(grain);
      grain = simulation_.add_body(description);
    }
    const double changed = bulk_cpu_seconds();
    simulation_.step();
    return {changed - begin, bulk_cpu_seconds() - begin};
  }

 private:
  BulkSimulation simulation_;
  int changes_;
  std::vector<BodyId> grains_;
  std::mt19937 random_{1};
  double top_;
};

}  // namespace

void print_churn(int grains, int steps) {
  fmt::print(
      "{} balls in a hopper, one thread; so many taken out and put in before each step, in turns; CPU ms a "
      "step\n",
      grains);
  const std::vector<int> counts = {0, 1, 10, 167, 1000};
  std::vector<std::unique_ptr<Churn>> churns;
  for (const int count : counts)
    churns.push_back(std::make_unique<Churn>(make_hopper(grains, Grain::sphere), count));
  std::vector<std::pair<double, double>> sums(counts.size());
  const int first = steps / 4;
  for (int k = 0; k < steps; ++k) {
    for (std::size_t i = 0; i < counts.size(); ++i) {
      const auto [changes, step] = churns[i]->step();
      if (k < first) continue;
      sums[i].first += changes;
      sums[i].second += step;
    }
  }
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double per_step = 1e3 / (steps - first);
    fmt::print("{:>5} out and in: changes {:>7.3f}, all {:>7.3f}\n", counts[i], per_step * sums[i].first,
               per_step * sums[i].second);
  }
}

}  // namespace rigor::bench
