#pragma once

namespace rigor {

/// How well the contact problems of a try are solved: roughly, where it is only to show which contacts there
/// are, or to the residual that steps are taken with.
enum class StepAccuracy { rough, exact };

}  // namespace rigor
