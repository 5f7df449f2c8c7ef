// What it costs that bodies, joints and materials come and go: grains in a hopper, of which some are taken
// out and put in above in each step, or some joints between them.

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

enum class What { bodies, joints, materials };

/// A hopper in which something comes and goes.
class Churn {
 public:
  Churn(std::shared_ptr<const Model> model, What what, int changes)
      : simulation_(std::move(model), {.sleeping = false}), what_(what), changes_(changes) {
    for (const BodyId& body : simulation_.bodies()) {
      const Body& own = simulation_.model().body(body.place);
      if (own.motion == MotionType::dynamic) grains_.push_back(body);
    }
    for (const BodyId& grain : grains_) top_ = std::max(top_, simulation_.pose(grain)->p.z());
    // Two grains after each other are neighbours.
    for (std::size_t k = 0; what == What::joints && 2 * k + 1 < grains_.size(); ++k)
      joints_.push_back(join(k));
  }

  /// CPU time of the changes, and of the step with all [s].
  std::pair<double, double> step() {
    const double begin = bulk_cpu_seconds();
    for (int k = 0; k < changes_; ++k) {
      if (what_ == What::bodies) {
        move_up(grains_[random_() % grains_.size()], k);
      } else if (what_ == What::joints) {
        const std::size_t joint = random_() % joints_.size();
        simulation_.remove_joint(joints_[joint]);
        joints_[joint] = join(joint);
      } else {
        simulation_.remove_material(simulation_.add_material({.name = "other", .friction = 0.1}));
      }
    }
    const double changed = bulk_cpu_seconds();
    simulation_.step();
    return {changed - begin, bulk_cpu_seconds() - begin};
  }

 private:
  /// A grain goes and comes back above the others, as another body.
  void move_up(BodyId& grain, int k) {
    BodyDescription description;
    const Vec3 p = simulation_.pose(grain)->p;
    description.p_WU = Vec3(p.x(), p.y(), top_ + 0.3 * (k % 20));
    description.shapes.push_back({Sphere{0.125}});
    simulation_.remove_body(grain);
    grain = simulation_.add_body(description);
  }
  /// A ball joint at the middle of a grain, which holds the next one.
  JointId join(std::size_t k) {
    ModelBuilder::JointDescription ball;
    ball.type = JointType::ball;
    ball.anchors = {simulation_.pose(grains_[2 * k])->p};
    return *simulation_.add_joint(ball, grains_[2 * k], grains_[2 * k + 1]);
  }

  BulkSimulation simulation_;
  What what_;
  int changes_;
  std::vector<BodyId> grains_;
  std::vector<JointId> joints_;
  std::mt19937 random_{1};
  double top_ = 0;
};

}  // namespace

void print_churn(int grains, int steps) {
  fmt::print(
      "{} balls in a hopper, one thread; so many taken out and put in before each step, or as many joints of "
      "pairs of them, or materials; in turns; CPU ms a step\n",
      grains);
  struct Case {
    const char* name;
    What what;
    int count;
  };
  const std::vector<Case> cases = {{"bodies", What::bodies, 0},    {"bodies", What::bodies, 1},
                                   {"bodies", What::bodies, 10},   {"bodies", What::bodies, 167},
                                   {"bodies", What::bodies, 1000}, {"joints", What::joints, 0},
                                   {"joints", What::joints, 167},  {"materials", What::materials, 167}};
  std::vector<std::unique_ptr<Churn>> churns;
  for (const Case& own : cases)
    churns.push_back(std::make_unique<Churn>(make_hopper(grains, Grain::sphere), own.what, own.count));
  std::vector<std::pair<double, double>> sums(cases.size());
  const int first = steps / 4;
  for (int k = 0; k < steps; ++k) {
    for (std::size_t i = 0; i < cases.size(); ++i) {
      const auto [changes, step] = churns[i]->step();
      if (k < first) continue;
      sums[i].first += changes;
      sums[i].second += step;
    }
  }
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const double per_step = 1e3 / (steps - first);
    fmt::print("{:>9} {:>5} out and in: changes {:>7.3f}, all {:>7.3f}\n", cases[i].name, cases[i].count,
               per_step * sums[i].first, per_step * sums[i].second);
  }
}

}  // namespace rigor::bench
