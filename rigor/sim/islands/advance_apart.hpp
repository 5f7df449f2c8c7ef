#pragma once

#include "rigor/bulk/threads/executor.hpp"
#include "rigor/sim/islands/groups_apart.hpp"
#include "rigor/sim/report/advance_report.hpp"

#include <functional>
#include <vector>

namespace rigor {

/// A group of bodies that is advanced by itself.
struct ApartGroup {
  BodyGroup bodies;
  State state;             ///< As it sees it: the bodies of other groups stay where they were.
  AdvanceReport report;    ///< Of the span.
  BodyRanges ranges = {};  ///< Where its bodies have been, with what they may touch there.
  double work = 0;         ///< Operations (count_work, count_following) of the span.
};

/// How groups are advanced.
struct ApartWork {
  /// Is told of each group that will be advanced, on the thread that asks.
  std::function<void(const BodyGroup&)> begin;
  /// Advances a group as far as it comes: its state, report and ranges; on any thread, which asks the
  /// interrupt of whoever asked.
  std::function<void(ApartGroup&)> advance;
};

/// Advances groups of the State through one span side by side, those that could have met once more, as one.
/// The groups that are left, each at the end of the span. One that has not come there ends all: then the last
/// groups, among them this one. None if all bodies could have met. work_of_bodies: the operations of each
/// body in the last span, which say what is begun first; they become those of this one.
std::vector<ApartGroup> advance_apart(const Model& model, const Executor& executor,
                                      std::vector<BodyGroup> groups, const State& state,
                                      std::vector<double>& work_of_bodies, const ApartWork& work);

/// Why these groups did not all come to the end: an interrupt, if there was one.
StopReason reason_of(const std::vector<ApartGroup>& groups);

/// What the groups have done, in their order, with the events in the order of time; the State becomes that at
/// the end.
AdvanceReport put_together(const Model& model, const std::vector<ApartGroup>& groups, State& state);

}  // namespace rigor
