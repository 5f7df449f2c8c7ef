#pragma once

#include "rigor/study/kinds/strategy.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace rigor {

/// A parameter with coordinates, which vary together.
struct Factor {
  std::string name;
  std::size_t first, count;
};

/// A kind that asks how much each factor matters: `plan.runs` groups of as many runs, each group complete in
/// itself.
class FactorStrategy : public Strategy {
 public:
  std::uint64_t most() const override;
  std::uint64_t wanted(const RowTable&) override { return most(); }
  StudyAnswer answer(const RowTable& known) const override;

 protected:
  /// A group has one run for each factor and `further` runs.
  FactorStrategy(const StudyPlan& plan, std::size_t further);

  /// Adds what the runs say of an outcome.
  virtual void add_outcome(const RowTable& known, std::size_t outcome, StudyAnswer& answer) const = 0;

  const StudyPlan& plan() const { return plan_; }
  const std::vector<Factor>& factors() const { return factors_; }
  const std::string& column(std::size_t outcome) const { return columns_[outcome]; }
  /// Runs of a group.
  std::uint64_t stride() const { return stride_; }
  /// Groups all of whose runs have this outcome.
  std::vector<std::uint64_t> complete_groups(const RowTable& known, std::size_t outcome) const;

 private:
  const StudyPlan& plan_;
  std::vector<Factor> factors_;
  std::vector<std::string> columns_;
  std::uint64_t stride_;
};

}  // namespace rigor
