#include "rigor/core/assert.hpp"

#include "rigor/core/broken_promise.hpp"

#include <cstddef>
#include <string>
#include <string_view>

namespace rigor {

namespace {

/// The path from the folder of the sources on, wherever the program was built.
std::string_view source_path(std::string_view file) {
  const std::size_t root = file.rfind("/rigor/");
  return root == std::string_view::npos ? file : file.substr(root + 1);
}

}  // namespace

void assertion_failed(const char* condition, const char* file, int line) {
  throw BrokenPromise(std::string(source_path(file)) + ":" + std::to_string(line) +
                      ": broken promise: " + condition);
}

}  // namespace rigor
