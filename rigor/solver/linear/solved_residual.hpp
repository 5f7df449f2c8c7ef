#pragma once

namespace rigor {

/// Relative residual up to which the solvers of this layer call a problem solved: some thousand roundings of
/// its largest term.
inline constexpr double solved_residual = 1e-12;

}  // namespace rigor
