#include "rigor/sim/time_stepping/part_memory.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/core/work_count.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace rigor {

bool are_same_contacts(const std::vector<Contact>& a, const std::vector<Contact>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Contact& x, const Contact& y) {
    return x.key() == y.key() && x.point.gap == y.point.gap && x.point.p_WA == y.point.p_WA &&
           x.point.p_WB == y.point.p_WB && x.point.n_W == y.point.n_W;
  });
}

bool is_same_phase(const BodyPhase& a, const BodyPhase& b) {
  return a.P == b.P && a.L == b.L && a.x == b.x && a.q.coeffs() == b.q.coeffs();
}

bool are_same_phases(const std::vector<BodyPhase>& a, const std::vector<BodyPhase>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), is_same_phase);
}

const MovedPart* PartMemory::find(double h, double theta, StepAccuracy accuracy, const Cluster& part) const {
  const auto known = std::find_if(known_.begin(), known_.end(), [&](const Known& other) {
    const bool is_accurate = accuracy == StepAccuracy::rough || other.moved.accuracy == StepAccuracy::exact;
    return is_accurate && other.h == h && other.theta == theta && other.part.bodies == part.bodies &&
           are_same_contacts(other.part.contacts, part.contacts);
  });
  return known == known_.end() ? nullptr : &known->moved;
}

std::vector<const MovedPart*> PartMemory::moved(double h, double theta, StepAccuracy accuracy,
                                                const std::vector<Cluster>& parts, const Move& move,
                                                const Executor& executor) {
  // Which parts are known, and which have to be moved.
  std::vector<const MovedPart*> result;
  std::vector<std::size_t> fresh;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    result.push_back(find(h, theta, accuracy, parts[i]));
    if (result.back() == nullptr) fresh.push_back(i);
  }

  // Each part is a problem of its own: no thread writes what another reads.
  std::vector<MovedPart> answers(fresh.size());
  std::vector<std::uint64_t> operations(fresh.size());
  const std::function<bool()> interrupt = shared_interrupt();
  const double left = most_work_ - static_cast<double>(work_);
  const auto is_too_much = [left](std::uint64_t work) { return static_cast<double>(work) > left; };
  executor.for_ranges(static_cast<int>(fresh.size()), 1, [&](int begin, int end) {
    for (int k = begin; k < end; ++k) {
      // A part that does too much is ended as by an interrupt, at a place that its own work decides.
      const std::uint64_t before = work_counted();
      const auto work = [before] { return work_counted() - before; };
      const std::function<bool()> ends = [&] { return is_too_much(work()) || (interrupt && interrupt()); };
      const InterruptScope scope(ends);
      try {
        answers[at(k)] = move(parts[fresh[at(k)]]);
      } catch (const Interrupted&) {
        if (!is_too_much(work())) throw;
      }
      operations[at(k)] = work();
    }
  });
  work_ = std::accumulate(operations.begin(), operations.end(), work_);
  if (std::any_of(operations.begin(), operations.end(), is_too_much)) throw TooMuchWork();
  for (std::size_t k = 0; k < fresh.size(); ++k) {
    known_.push_back({h, theta, parts[fresh[k]], std::move(answers[k])});
    result[fresh[k]] = &known_.back().moved;
  }
  return result;
}

}  // namespace rigor
