#pragma once

#include "rigor/sim/islands/cluster.hpp"
#include "rigor/sim/report/advance_report.hpp"

#include <deque>
#include <functional>
#include <mutex>
#include <vector>

namespace rigor {

/// The impacts of the tries of one step. A body that is struck meets its neighbour in the next try, and that
/// one its neighbour in the try after it: each repeats the impacts before, bit for bit, and their answers are
/// known. Several threads may ask at once; what they get does not depend on who was first.
class ImpactMemory {
 public:
  using Collide = std::function<void(Cluster&, AdvanceReport&)>;

  /// Forgets all: another step begins.
  void clear() { known_.clear(); }
  /// The bodies of the part after the impact of its contacts, as `collide` does it.
  void collide(Cluster& part, const Collide& collide, AdvanceReport& report);

 private:
  struct Known {
    Cluster before;
    std::vector<BodyPhase> after;
    AdvanceReport report;
  };
  const Known* find(const Cluster& part) const;

  std::mutex mutex_;
  std::deque<Known> known_;  ///< Places stay valid while it grows.
};

}  // namespace rigor
