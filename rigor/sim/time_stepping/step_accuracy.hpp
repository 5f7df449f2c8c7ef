#pragma once

#include <cstddef>

namespace rigor {

/// How well the contact problems of a try are solved: roughly, where it is only to show which contacts there
/// are, or to the residual that steps are taken with.
enum class StepAccuracy { rough, exact };

/// Problems of fewer contacts are always solved exactly, which takes no longer: in heaps of 100 mixed bodies
/// rough answers from 48 on would cost a tenth of the run.
inline constexpr std::size_t kFewestRough = 96;

}  // namespace rigor
