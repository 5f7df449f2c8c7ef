#pragma once

#include <exception>
#include <string>
#include <utility>
#include <vector>

namespace rigor {

/// Thrown within a stepper where a motion is faster than any useful part of a step follows: advance() then
/// stops with StopReason::unresolved instead of going on for hours, or with books that do not add up.
class Unresolved : public std::exception {
 public:
  /// The bodies that move so, and what they would need.
  Unresolved(std::vector<int> bodies, std::string detail)
      : bodies_(std::move(bodies)), detail_(std::move(detail)) {}
  /// The detail.
  const char* what() const noexcept override { return detail_.c_str(); }
  /// Model indices.
  const std::vector<int>& bodies() const { return bodies_; }

 private:
  std::vector<int> bodies_;
  std::string detail_;
};

/// Parts of a step that are shorter than this share of it are of no use: where forces ask for so many of them
/// in a row that nothing but short ones is to be expected, the motion is unresolved.
inline constexpr double useless_share = 1e-4;
/// How many in a row.
inline constexpr long most_useless_parts = 5000;

}  // namespace rigor
