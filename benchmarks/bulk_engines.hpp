#pragma once

#include "rigor/model/model.hpp"
#include "rigor/model/state.hpp"

#include <memory>
#include <string>

namespace rigor::bench {

/// What the last step of the many-body path worked on.
struct BulkCounts {
  int pairs = 0;      ///< Of shapes that the broad phase found.
  int manifolds = 0;  ///< Of those with points.
  int points = 0;
};

/// An engine at work on a scene of many bodies, from its State at t = 0.
class BulkEngine {
 public:
  BulkEngine() = default;
  BulkEngine(const BulkEngine&) = delete;
  BulkEngine& operator=(const BulkEngine&) = delete;
  virtual ~BulkEngine() = default;
  /// h > 0 [s].
  virtual void step(double h) = 0;
  /// Poses and momenta of now.
  virtual State state() const = 0;
  /// Of the many-body path; zero for the others.
  virtual BulkCounts counts() const { return {}; }
};

struct BulkEngineOptions {
  int threads = 1;
  int substeps = 0;       ///< Of a step of the many-body path; 0: as many as it takes by default.
  bool measures = false;  ///< Whether steps report impacts, work and the error of momentum.
};

/// The many-body path.
std::unique_ptr<BulkEngine> make_bulk_world_engine(std::shared_ptr<const Model> model,
                                                   const BulkEngineOptions& options);
/// Time stepping with the exact solver, on one thread.
std::unique_ptr<BulkEngine> make_time_stepping_engine(std::shared_ptr<const Model> model);
#ifdef RIGOR_BENCH_BULLET
/// Bullet as it comes (single precision, 10 iterations), without sleeping, on one thread.
std::unique_ptr<BulkEngine> make_bullet_engine(std::shared_ptr<const Model> model);
#endif

}  // namespace rigor::bench
