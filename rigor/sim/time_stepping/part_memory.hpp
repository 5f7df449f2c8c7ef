#pragma once

#include "rigor/bulk/threads/executor.hpp"
#include "rigor/sim/islands/cluster.hpp"
#include "rigor/sim/report/advance_report.hpp"
#include "rigor/sim/time_stepping/step_accuracy.hpp"

#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <vector>

namespace rigor {

/// A part of the bodies after a step: bodies that contacts, joints or springs connect.
struct MovedPart {
  std::vector<BodyPhase> struck;     ///< After the impacts at the beginning, one per body.
  std::vector<BodyPhase> end;        ///< One per body.
  std::vector<ContactForce> forces;  ///< All through the step.
  AdvanceReport report;
  StepAccuracy accuracy = StepAccuracy::exact;
  std::vector<ContactForce> strikes = {};  ///< Of contacts that may have had a part in the impacts.
};

/// Whether two lists of contacts, found at one instant, pose the same problem. What a model says of a pair,
/// and how surfaces bend, follows from the key and the points.
bool are_same_contacts(const std::vector<Contact>& a, const std::vector<Contact>& b);

/// Whether bodies are at the same places with the same momenta, bit for bit.
bool is_same_phase(const BodyPhase& a, const BodyPhase& b);
bool are_same_phases(const std::vector<BodyPhase>& a, const std::vector<BodyPhase>& b);

/// A step has done more work than it may.
struct TooMuchWork {};

/// The parts that the tries of one step have moved. Where tries differ elsewhere only, a part is the same
/// problem again, bit for bit, and its answer is known.
class PartMemory {
 public:
  using Move = std::function<MovedPart(const Cluster&)>;

  /// Forgets all: another step begins, whose parts may do so many operations (count_work).
  void clear(double most_work = std::numeric_limits<double>::infinity()) {
    known_.clear();
    work_ = 0;
    most_work_ = most_work;
  }
  /// The parts, of which no two share a body, moved by h with the share theta as `move` does it. Only parts
  /// that are not known as accurately as this are moved, side by side on the threads of the executor; the
  /// answer does not depend on them. One pointer per part, valid until clear(). Throws TooMuchWork where one
  /// part alone does more than is left.
  std::vector<const MovedPart*> moved(double h, double theta, StepAccuracy accuracy,
                                      const std::vector<Cluster>& parts, const Move& move,
                                      const Executor& executor);
  /// Operations (count_work) of all parts moved since clear(), each once.
  std::uint64_t work() const { return work_; }

 private:
  struct Known {
    double h, theta;
    Cluster part;
    MovedPart moved;
  };
  const MovedPart* find(double h, double theta, StepAccuracy accuracy, const Cluster& part) const;

  std::deque<Known> known_;
  std::uint64_t work_ = 0;
  double most_work_ = std::numeric_limits<double>::infinity();
};

}  // namespace rigor
