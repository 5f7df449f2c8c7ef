#pragma once

#include "rigor/solver/linear/lcp.hpp"

namespace rigor {

/// The solution record of a given z: w, residual and whether that is small.
LcpSolution finish_lcp(const MatX& M, const VecX& q, const VecX& z, int pivots);

}  // namespace rigor
