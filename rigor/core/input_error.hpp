#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace rigor {

/// Input that makes no sense: a file's or a user's fault. Each message says where (file, line, column, name),
/// what was found with its unit, and what is allowed. Thrown only by builders, io/, view/ and apps/.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::string message);
  /// All errors of one input in one go; messages must not be empty.
  explicit InputError(std::vector<std::string> messages);

  const std::vector<std::string>& messages() const { return messages_; }

 private:
  std::vector<std::string> messages_;
};

}  // namespace rigor
