#pragma once

#include "rigor/bulk/bulk_bodies.hpp"

#include <vector>

namespace rigor {

/// The kinematic bodies of a Model among the many: at the begin of each step they are where they are to be.
class PrescribedBodies {
 public:
  explicit PrescribedBodies(const Model& model);

  /// Puts them where they are to be at t [s], with the velocities that take them to where they are to be h
  /// later.
  void place(const Model& model, double t, double h, BulkBodies& bodies) const;

 private:
  std::vector<int> kinematic_;
};

}  // namespace rigor
