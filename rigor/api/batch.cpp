#include "rigor/api/batch.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <thread>
#include <utility>

namespace rigor {

namespace {

/// What is surely a slip: a world takes some kilobytes.
constexpr int most_worlds = 1'000'000, most_threads = 1024;

}  // namespace

Batch::Batch(const Scene& scene, int count, int threads) : threads_(threads) {
  if (count < 1 || count > most_worlds)
    throw InputError(fmt::format("the batch has {} worlds, must be from 1 to {}", count, most_worlds));
  if (threads < 0 || threads > most_threads)
    throw InputError(fmt::format("threads is {}, must be from 0 (all) to {}", threads, most_threads));
  if (threads_ == 0) threads_ = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  Scene of_world = scene;
  of_world.run.threads = 1;
  worlds_.reserve(at(count));
  for (int i = 0; i < count; ++i) worlds_.emplace_back(of_world);
  stops_.resize(at(count));
}

int Batch::checked(int index) const {
  if (index >= 0 && index < size()) return index;
  throw InputError(fmt::format("the world is {}, must be from 0 to {}", index, size() - 1));
}

Simulation& Batch::world(int index) {
  return worlds_[at(checked(index))];
}

const Simulation& Batch::world(int index) const {
  return worlds_[at(checked(index))];
}

void Batch::clear_stop(int index) {
  stops_[at(checked(index))].clear();
}

void Batch::reset(int index) {
  world(index).reset();
  clear_stop(index);
}

void Batch::set_controller(const Controller& controller, double period) {
  for (int i = 0; i < size(); ++i) {
    Simulation::Controller of_world;
    if (controller) of_world = [controller, i](Simulation& world) { controller(i, world); };
    worlds_[at(i)].set_controller(std::move(of_world), period);
  }
}

void Batch::for_each(const std::function<void(int, Simulation&)>& work) {
  // Each thread takes the next world that nobody has taken; the first error, by index, is thrown at the end.
  std::atomic<int> next{0};
  std::vector<std::exception_ptr> errors(worlds_.size());
  const auto take_worlds = [&] {
    for (int i = next++; i < size(); i = next++) {
      try {
        work(i, worlds_[at(i)]);
      } catch (...) {
        errors[at(i)] = std::current_exception();
      }
    }
  };
  const int helpers = std::min(threads_, size()) - 1;
  {
    std::vector<std::jthread> pool;
    pool.reserve(at(std::max(0, helpers)));
    for (int i = 0; i < helpers; ++i) pool.emplace_back(take_worlds);
    take_worlds();
  }
  for (const std::exception_ptr& error : errors) {
    if (error) std::rethrow_exception(error);
  }
}

void Batch::step() {
  advance_each([](Simulation& world) { world.step(); });
}

void Batch::advance_to(double t) {
  advance_each([t](Simulation& world) { world.advance_to(t); });
}

namespace {

/// A world that asks the interrupt of its batch, set while it is at work: one pass over all worlds would
/// bring each into the cache once more.
class AskingWorld {
 public:
  AskingWorld(Simulation& world, const std::function<bool()>& interrupt)
      : world_(world), asks_(static_cast<bool>(interrupt)) {
    if (asks_) world_.set_interrupt([&interrupt] { return interrupt(); });
  }
  ~AskingWorld() {
    if (asks_) world_.set_interrupt({});
  }
  AskingWorld(const AskingWorld&) = delete;
  AskingWorld& operator=(const AskingWorld&) = delete;

 private:
  Simulation& world_;
  bool asks_;
};

}  // namespace

void Batch::advance_each(const std::function<void(Simulation& world)>& advance) {
  for_each([&](int i, Simulation& world) {
    if (!stops_[at(i)].empty()) return;
    const AskingWorld asking(world, interrupt_);
    try {
      advance(world);
    } catch (const SimulationStopped& stop) {
      stops_[at(i)] = stop.what();
    }
  });
}

namespace {

/// Numbers of a body in Batch::states().
constexpr std::size_t width = 13;

/// Throws if the numbers of a body of a world cannot be.
void check_body(const Model& model, std::size_t world, std::size_t body, const double* numbers) {
  const Body& own = model.body(static_cast<int>(body));
  if (own.motion == MotionType::fixed) return;
  const Quat q(numbers[3], numbers[4], numbers[5], numbers[6]);
  std::string fault;
  if (!(std::abs(q.norm() - 1) <= limits::quaternion_error))
    fault = fmt::format("the quaternion (w, x, y, z) has norm {}, must have 1", q.norm());
  const auto check = [&](const char* quantity, std::size_t first, const Range& range, const char* unit) {
    for (std::size_t k = first; k < first + 3 && fault.empty(); ++k)
      fault = range_error(quantity, numbers[k], range, unit);
  };
  check("position", 0, limits::position, "m");
  if (own.motion == MotionType::dynamic) {
    check("velocity", 7, limits::speed, "m/s");
    check("angular velocity", 10, limits::angular_speed, "rad/s");
  }
  if (!fault.empty())
    throw InputError(fmt::format("world {}, body {}: {}", world, quoted_text(own.name), fault));
}

/// Puts a body where its numbers say.
void set_body(Simulation& world, int i, const double* numbers) {
  const MotionType motion = world.model().body(i).motion;
  if (motion == MotionType::fixed) return;
  const Quat q(numbers[3], numbers[4], numbers[5], numbers[6]);
  world.set_pose(BodyHandle{i}, {rotation_matrix(q.normalized()), Vec3::Map(numbers)});
  if (motion == MotionType::dynamic)
    world.set_velocity(BodyHandle{i}, Vec3::Map(numbers + 7), Vec3::Map(numbers + 10));
}

}  // namespace

void Batch::set_states(std::span<const double> states) {
  const std::size_t bodies = at(worlds_.front().body_count());
  const std::size_t count = width * bodies * worlds_.size();
  if (states.size() != count) {
    throw InputError(
        fmt::format("the states are {} numbers, must be {}: {} for each of {} bodies of {} worlds",
                    states.size(), count, width, bodies, worlds_.size()));
  }
  // All are looked at before one is put anywhere.
  const Model& model = worlds_.front().model();
  for (std::size_t k = 0; k < bodies * worlds_.size(); ++k)
    check_body(model, k / bodies, k % bodies, &states[width * k]);
  for_each([&](int i, Simulation& world) {
    for (std::size_t k = 0; k < bodies; ++k)
      set_body(world, static_cast<int>(k), &states[width * (at(i) * bodies + k)]);
  });
}

const std::vector<double>& Batch::states() {
  const std::size_t bodies = at(worlds_.front().body_count());
  states_.resize(width * bodies * worlds_.size());
  for (std::size_t i = 0; i < worlds_.size(); ++i) {
    const Simulation& world = worlds_[i];
    for (std::size_t k = 0; k < bodies; ++k) {
      const Eigen::Index row = static_cast<Eigen::Index>(k);
      double* const out = &states_[width * (i * bodies + k)];
      Vec3::Map(out) = world.positions().row(row);
      Vec4::Map(out + 3) = world.orientations().row(row);
      Vec3::Map(out + 7) = world.velocities().row(row);
      Vec3::Map(out + 10) = world.angular_velocities().row(row);
    }
  }
  return states_;
}

}  // namespace rigor
