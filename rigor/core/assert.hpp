#pragma once

namespace rigor {

/// Prints the broken promise with its place and aborts. Use through RIGOR_ASSERT.
[[noreturn]] void assertion_failed(const char* condition, const char* file, int line);

}  // namespace rigor

/// A promise between parts of the program (never about input): always checked; a broken one aborts.
#define RIGOR_ASSERT(condition) \
  ((condition) ? static_cast<void>(0) : ::rigor::assertion_failed(#condition, __FILE__, __LINE__))

/// The same for checks too slow for release builds.
#ifdef RIGOR_SLOW_ASSERTS
#define RIGOR_SLOW_ASSERT(condition) RIGOR_ASSERT(condition)
#else
#define RIGOR_SLOW_ASSERT(condition) static_cast<void>(0)
#endif
