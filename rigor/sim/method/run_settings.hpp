#pragma once

#include <cstdint>

namespace rigor {

/// How long a scene runs and what it writes.
struct RunSettings {
  double duration = 10;           ///< [s], > 0.
  double step = 0.01;             ///< Target step H [s], > 0.
  double output_interval = 0.01;  ///< Time between outputs [s], > 0.
  int threads = 1;                ///< >= 1, of schemes that use several. The answer does not depend on it.
  std::uint64_t seed = 1;         ///< Of everything drawn at random (jitter of repeated bodies).
};

}  // namespace rigor
