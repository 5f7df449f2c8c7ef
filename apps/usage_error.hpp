#pragma once

#include <stdexcept>

namespace rigor {

/// An invalid command line; the message says what is wrong and what would be right.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace rigor
