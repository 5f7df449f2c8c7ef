#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace rigor {

/// Number of insertions, deletions, substitutions and swaps of neighbouring letters that change a into b
/// (each letter is edited at most once: optimal string alignment). Bytes, case matters.
///
/// Source: Damerau, A Technique for Computer Detection and Correction of Spelling Errors, CACM 7(3), 1964.
int edit_distance(std::string_view a, std::string_view b);

/// The name nearest to the given one, or nothing if none is near: case is ignored, and at most a third of the
/// letters (at least one) may differ. Of equally near names the first one.
std::optional<std::string> find_nearest_name(std::string_view written, std::span<const std::string> names);

/// "; did you mean 'friction'?", or without a near name the list "; one of: a, b, c" (the first twelve).
std::string suggestion(std::string_view written, std::span<const std::string> names);

}  // namespace rigor
