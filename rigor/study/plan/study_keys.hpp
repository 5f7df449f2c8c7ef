#pragma once

#include "rigor/io/scene/scene_keys.hpp"

#include <string_view>
#include <vector>

namespace rigor {

/// The tables of the keys of a study file, in the order of the documentation: "study", "parameter",
/// "outcome", "expected finding".
const std::vector<KeyTable>& study_key_tables();
const KeyTable& study_key_table(std::string_view object);
/// The keys of `study` in a scene: those of a study file, but for its version and its scene.
const KeyTable& scene_study_table();

}  // namespace rigor
