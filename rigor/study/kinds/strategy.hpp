#pragma once

#include "rigor/study/kinds/answer.hpp"
#include "rigor/study/plan/study_plan.hpp"
#include "rigor/study/workers/row_table.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace rigor {

/// A kind of study: which runs it wants, and what they say. Runs are numbered from 0; the point of each is a
/// function of the plan, its number and the rows of earlier runs that were all known when it was first
/// wanted, so that it is the same for any number of threads, any order, and after a new start.
class Strategy {
 public:
  virtual ~Strategy() = default;

  /// How many runs, from the first, are wanted now that all those below known.prefix() are known. Equal to
  /// the number of known ones: the study is at its end. Never less than at an earlier call.
  virtual std::uint64_t wanted(const RowTable& known) = 0;
  /// Coordinates of a run that is wanted.
  virtual std::vector<double> point(std::uint64_t run) const = 0;
  /// The most runs that it may come to want.
  virtual std::uint64_t most() const = 0;
  /// What the runs say, of which those below known.prefix() count.
  virtual StudyAnswer answer(const RowTable& known) const = 0;
  /// The estimate so far in a few words, for the progress line; it may be empty.
  virtual std::string brief(const RowTable&) const { return {}; }
};

/// The strategy of the plan's kind, which must outlive it.
std::unique_ptr<Strategy> make_strategy(const StudyPlan& plan);

// One a kind.
std::unique_ptr<Strategy> make_sweep(const StudyPlan& plan);
std::unique_ptr<Strategy> make_monte_carlo(const StudyPlan& plan);
std::unique_ptr<Strategy> make_bisection(const StudyPlan& plan);
std::unique_ptr<Strategy> make_sensitivity(const StudyPlan& plan);
std::unique_ptr<Strategy> make_morris(const StudyPlan& plan);
std::unique_ptr<Strategy> make_optimum(const StudyPlan& plan);

}  // namespace rigor
