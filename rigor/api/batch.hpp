#pragma once

#include "rigor/api/simulation.hpp"

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace rigor {

/// Many worlds that begin as the same scene and go their own ways, on several threads. A world is a
/// Simulation on one thread; its motion does not depend on the others, nor on how many threads there are.
class Batch {
 public:
  /// 1 to 1,000,000 worlds; at most 1024 threads, 0: as many as the machine has. Throws as Simulation does.
  Batch(const Scene& scene, int count, int threads = 0);
  /// Worlds go their own ways: they can be moved, and each be cloned.
  Batch(Batch&& other) = default;
  /// Likewise.
  Batch& operator=(Batch&& other) = default;

  /// Number of worlds.
  int size() const { return static_cast<int>(worlds_.size()); }
  /// Number of threads.
  int threads() const { return threads_; }
  /// Throws InputError for an index that does not exist. A world is used by one thread at a time.
  Simulation& world(int index);
  /// The same to look at.
  const Simulation& world(int index) const;

  /// Advances every world by one step, or to t [s]. A world that stops stays as it is, with its reason in
  /// stops(); the others go on. An interrupt of a world, or an error of a controller, is thrown when all have
  /// ended.
  void step();
  /// The same to t [s], at least the time of every world.
  void advance_to(double t);
  /// A controller for every world, called with its index as Simulation::set_controller says: on the threads,
  /// for one world by one thread at a time. An empty one ends it.
  using Controller = std::function<void(int index, Simulation& world)>;
  /// Period in s.
  void set_controller(const Controller& controller, double period = 0);
  /// Asked by every world at each event or step, on its thread: true ends the call with Interrupted. The
  /// worlds may then be at different times. While the batch advances it is in place of a world's own.
  void set_interrupt(std::function<bool()> interrupt) { interrupt_ = std::move(interrupt); }
  /// Returns a world to t = 0; it goes on if it had stopped. What is set in it stays.
  void reset(int index);
  /// Calls `work` with every world, on the threads; each call touches its own world only.
  void for_each(const std::function<void(int index, Simulation& world)>& work);
  /// Why each world has stopped; empty where it has not. reset() of a world goes with clear_stop().
  const std::vector<std::string>& stops() const { return stops_; }
  /// Lets a world go on that has stopped.
  void clear_stop(int index);

  /// The bodies of all worlds: 13 numbers each, position, orientation (w, x, y, z), velocity, angular
  /// velocity, body by body and world by world.
  const std::vector<double>& states();
  /// Puts the dynamic and kinematic bodies of all worlds where these numbers say, in the order of states(),
  /// with these velocities; of a kinematic body the velocities are left out. A quaternion has norm 1, to
  /// 1e-3.
  void set_states(std::span<const double> states);

 private:
  int checked(int index) const;
  void advance_each(const std::function<void(Simulation& world)>& advance);

  int threads_;
  std::vector<Simulation> worlds_;
  std::vector<std::string> stops_;
  std::vector<double> states_;
  std::function<bool()> interrupt_;
};

}  // namespace rigor
