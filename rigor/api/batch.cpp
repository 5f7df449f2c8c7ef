#include "rigor/api/batch.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/input_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>

namespace rigor {

Batch::Batch(const Scene& scene, int count, int threads) : threads_(threads) {
  if (count < 1) throw InputError(fmt::format("the batch has {} worlds, must be at least 1", count));
  if (threads < 0) throw InputError(fmt::format("threads is {}, must be at least 0", threads));
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
    for (int i = 0; i < helpers; ++i) pool.emplace_back(take_worlds);
    take_worlds();
  }
  for (const std::exception_ptr& error : errors) {
    if (error) std::rethrow_exception(error);
  }
}

void Batch::step() {
  for_each([this](int i, Simulation& world) {
    if (!stops_[at(i)].empty()) return;
    try {
      world.step();
    } catch (const SimulationStopped& stop) {
      stops_[at(i)] = stop.what();
    }
  });
}

void Batch::advance_to(double t) {
  for_each([this, t](int i, Simulation& world) {
    if (!stops_[at(i)].empty()) return;
    try {
      world.advance_to(t);
    } catch (const SimulationStopped& stop) {
      stops_[at(i)] = stop.what();
    }
  });
}

const std::vector<double>& Batch::states() {
  constexpr std::size_t width = 13;
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
