#pragma once

#include "rigor/bulk/state/bulk_bodies.hpp"
#include "rigor/bulk/threads/executor.hpp"

#include <vector>

namespace rigor {

/// Keeps linear velocities of bodies in flight to more than 32 bits. A substep adds a ten-thousandth of a
/// fast body's velocity to it, always with the same rounding: at 500 m/s gravity would be wrong by a
/// thousandth. So of bodies that are that fast what forces alone give in a whole step is added in double
/// precision, and what 32 bits do not hold of the sum stays for the next step (BulkBodies::finer_v). Each
/// component of a velocity that nothing else has changed in the step is one in flight.
class FlightVelocities {
 public:
  /// Takes note of the bodies among `moving` that touch nothing (`touches`, by body), before a step of h [s]
  /// in so many substeps by constant accelerations, by body, changes velocities (with HalfKicks).
  void begin(const std::vector<int>& moving, const std::vector<char>& touches,
             const std::vector<MotionRow>& accelerations, double h, int substeps, const BulkBodies& bodies);
  /// After the solver has changed velocities: those in flight are what they should be, and `finer_v` is
  /// known.
  void end(const Executor& executor, BulkBodies& bodies);
  /// After the step: what has been changed since end() has no finer part.
  void drop_changed(BulkBodies& bodies) const;

 private:
  /// A body that may fly: its velocity as substeps by forces alone round it, after end() as it was left, and
  /// as it should be [m/s].
  struct Flight {
    int body;
    float rounded[3];
    Vec3 v;
  };
  std::vector<Flight> flights_;
};

}  // namespace rigor
