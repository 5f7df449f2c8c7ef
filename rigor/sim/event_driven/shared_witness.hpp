#pragma once

#include "rigor/sim/witness/passage_witness.hpp"

#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <utility>

namespace rigor {

/// One witness for steppers that advance the bodies of one model side by side: what it knows of large meshes
/// is made once, when somebody first asks.
class SharedWitness {
 public:
  explicit SharedWitness(std::shared_ptr<const Model> model) : model_(std::move(model)) {}
  /// As PassageWitness does; for any thread, one at a time.
  void watch(std::span<const BodyPath> paths, AdvanceReport& report) {
    const std::lock_guard<std::mutex> lock(turn_);
    if (!witness_) witness_.emplace(model_);
    witness_->watch(paths, report);
  }

 private:
  std::shared_ptr<const Model> model_;
  std::mutex turn_;
  std::optional<PassageWitness> witness_;
};

}  // namespace rigor
