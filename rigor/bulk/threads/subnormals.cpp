// In a file of its own: calls from elsewhere keep the compiler from moving arithmetic across a change of the
// mode.

#include "rigor/bulk/threads/subnormals.hpp"

#include <cstdint>

namespace rigor {

namespace {

#if defined(__x86_64__)
// MXCSR: results are flushed to zero (bit 15), operands are taken as zero (bit 6).
constexpr unsigned flush_bits = 1U << 15 | 1U << 6;
unsigned control_register() {
  return __builtin_ia32_stmxcsr();
}
void set_control_register(unsigned value) {
  __builtin_ia32_ldmxcsr(value);
}
#elif defined(__aarch64__)
// FPCR: operands and results are flushed to zero (bit 24).
constexpr unsigned flush_bits = 1U << 24;
unsigned control_register() {
  std::uint64_t value;
  asm volatile("mrs %0, fpcr" : "=r"(value));
  return static_cast<unsigned>(value);
}
void set_control_register(unsigned value) {
  asm volatile("msr fpcr, %0" : : "r"(std::uint64_t{value}));
}
#else
constexpr unsigned flush_bits = 0;
unsigned control_register() {
  return 0;
}
void set_control_register(unsigned) {}
#endif

void set_flush_bits(unsigned bits) {
  set_control_register((control_register() & ~flush_bits) | bits);
}

}  // namespace

Subnormals subnormals_now() {
  return flush_bits != 0 && (control_register() & flush_bits) == flush_bits ? Subnormals::flushed
                                                                            : Subnormals::kept;
}

SubnormalScope::SubnormalScope(Subnormals now) : before_(control_register() & flush_bits) {
  set_flush_bits(now == Subnormals::flushed ? flush_bits : 0);
}

SubnormalScope::~SubnormalScope() {
  set_flush_bits(before_);
}

}  // namespace rigor
