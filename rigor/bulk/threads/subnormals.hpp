#pragma once

namespace rigor {

/// Whether a thread computes with subnormal numbers (below 1.2e-38 in 32 bits), which takes processors a
/// hundred times as long, or has zeros in their place, as operands and as results.
enum class Subnormals { kept, flushed };

/// How the calling thread takes them: kept, unless somebody has changed it.
Subnormals subnormals_now();

/// As long as it lives, its thread takes subnormal numbers so; then as before. The other modes of the thread
/// (rounding, traps) stay as they are. Without effect on processors other than x86-64 and 64-bit ARM.
class SubnormalScope {
 public:
  explicit SubnormalScope(Subnormals now);
  ~SubnormalScope();
  SubnormalScope(const SubnormalScope&) = delete;
  SubnormalScope& operator=(const SubnormalScope&) = delete;

 private:
  unsigned before_;  ///< The bits of the mode that it changes.
};

}  // namespace rigor
