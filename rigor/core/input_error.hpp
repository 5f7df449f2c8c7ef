#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace rigor {

/// Invalid input: the fault of a file or a user. Each message says where (file, line, column, name), what was
/// found with its unit, and what is allowed. Thrown only by builders, io/, view/ and apps/.
class InputError : public std::runtime_error {
 public:
  /// One mistake.
  explicit InputError(std::string message);
  /// All errors of one input at once; messages must not be empty.
  explicit InputError(std::vector<std::string> messages);

  /// All mistakes, one each.
  const std::vector<std::string>& messages() const { return messages_; }

 private:
  std::vector<std::string> messages_;
};

}  // namespace rigor
