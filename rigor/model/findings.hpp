#pragma once

#include "rigor/core/range.hpp"
#include "rigor/math/types.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace rigor {

/// Collects the mistakes in the description of one object: each message is where + "body 'ball': " + what was
/// found and what is allowed.
class Findings {
 public:
  /// The messages must outlive this.
  Findings(std::string where, std::string whose, std::vector<std::string>& messages)
      : prefix_(std::move(where) + std::move(whose) + ": "), messages_(messages) {}

  void add(std::string_view message) { messages_.push_back(prefix_ + std::string(message)); }
  /// Adds the message unless the condition holds, and returns the condition.
  bool require(bool condition, std::string_view message);
  bool check(std::string_view quantity, double value, const Range& range, std::string_view unit);
  /// The same for each component.
  bool check(std::string_view quantity, const Vec3& value, const Range& range, std::string_view unit);
  /// The norm of q must be within limits::quaternion_error of 1.
  bool check(std::string_view quantity, const Quat& q);
  /// A name is not empty, not too long, and UTF-8 without control characters.
  bool check_name(std::string_view name);

 private:
  std::string prefix_;
  std::vector<std::string>& messages_;
};

/// "[1, 0, -2.5]".
std::string vector_text(const Vec3& v);

/// Why this cannot be a name; empty if it can.
std::string name_error(std::string_view name);

/// Whether the text is "#rgb" or "#rrggbb".
bool is_color(std::string_view text);

}  // namespace rigor
