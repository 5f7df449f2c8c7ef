#pragma once

#include "rigor/study/plan/study_plan.hpp"

#include <filesystem>
#include <string>

namespace rigor {

/// Reads a study file, or a scene file with a study in it (strict YAML). docs/studies.md lists every key.
/// What needs the scene (its keys, its bodies) is checked when the study is prepared. Throws InputError with
/// all errors of the file, in the order of its lines.
StudyPlan read_study(const std::filesystem::path& path);

/// The same from text; path appears in messages, and its folder is where the scene is looked for.
StudyPlan parse_study(const std::string& text, const std::filesystem::path& path);

/// Whether a file is a scene with a study in it. Throws InputError if it cannot be read or is not YAML.
bool is_scene_with_study(const std::filesystem::path& path);

}  // namespace rigor
