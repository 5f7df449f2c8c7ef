#include "rigor/core/input_error.hpp"

#include "rigor/core/assert.hpp"

#include <utility>

namespace rigor {

namespace {

std::string joined(const std::vector<std::string>& messages) {
  RIGOR_ASSERT(!messages.empty());
  std::string text;
  for (const std::string& message : messages) text += (text.empty() ? "" : "\n") + message;
  return text;
}

}  // namespace

InputError::InputError(std::string message) : InputError(std::vector<std::string>{std::move(message)}) {}

InputError::InputError(std::vector<std::string> messages)
    : std::runtime_error(joined(messages)), messages_(std::move(messages)) {}

}  // namespace rigor
