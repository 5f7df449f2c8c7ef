#pragma once

#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/model/state.hpp"

#include <string>
#include <vector>

namespace rigor {

/// Where the run of a scene begins.
struct RunStart {
  State state;
  std::vector<std::string> warnings;  ///< Distances by which bodies were pushed apart.
};

/// The state at t = 0. Bodies that overlap there are pushed apart if `separate`; if they are not, or that
/// fails, throws an InputError that names the scene file.
RunStart make_run_start(const std::string& scene_file, const Scene& scene, bool separate);

}  // namespace rigor
