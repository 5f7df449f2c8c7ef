#pragma once

namespace rigor {

/// Throws BrokenPromise with the condition and its place. Use it through RIGOR_ASSERT.
[[noreturn]] void assertion_failed(const char* condition, const char* file, int line);

}  // namespace rigor

/// An assertion between parts of the program (never about input): it is always checked, and a failure throws.
#define RIGOR_ASSERT(condition) \
  ((condition) ? static_cast<void>(0) : ::rigor::assertion_failed(#condition, __FILE__, __LINE__))

/// The same for checks that are too slow for release builds.
#ifdef RIGOR_SLOW_ASSERTS
#define RIGOR_SLOW_ASSERT(condition) RIGOR_ASSERT(condition)
#else
#define RIGOR_SLOW_ASSERT(condition) static_cast<void>(0)
#endif
