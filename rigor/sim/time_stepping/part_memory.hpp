#pragma once

#include "rigor/sim/islands/cluster.hpp"
#include "rigor/sim/report/advance_report.hpp"

#include <functional>
#include <vector>

namespace rigor {

/// A part of the bodies after a step: bodies that contacts, joints or springs connect.
struct MovedPart {
  std::vector<BodyPhase> struck;  ///< After the impacts at the beginning, one per body.
  std::vector<BodyPhase> end;     ///< One per body.
  AdvanceReport report;
};

/// The parts that the tries of one step have moved. Where tries differ elsewhere only, a part is the same
/// problem again, bit for bit, and its answer is known.
class PartMemory {
 public:
  /// Forgets all: another step begins.
  void clear() { known_.clear(); }
  /// The part moved by h with the share theta as `move` does it, asked only the first time. The reference is
  /// valid until the next call.
  const MovedPart& moved(double h, double theta, const Cluster& part,
                         const std::function<MovedPart(const Cluster&)>& move);

 private:
  struct Known {
    double h, theta;
    Cluster part;
    MovedPart moved;
  };
  std::vector<Known> known_;
};

}  // namespace rigor
