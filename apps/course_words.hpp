#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rigor {

/// A word of the courses on rigid-body dynamics (Baraff's notes, Mirtich's thesis, lectures that teach with
/// PQP or SWIFT++), and what stands for it here. docs/methods.md has the same table.
struct CourseWord {
  std::string_view names;   ///< "RAPID, OBB tree": all by which it is found.
  std::string_view here;    ///< What stands for it.
  std::string_view chosen;  ///< Where it is chosen: "`method.toi`"; "always" where it is no choice.
  std::string_view page;    ///< Where it is explained, from docs/: "theory/meshes.md#the-tree".
};

std::span<const CourseWord> course_words();

/// The names of a word, one by one.
std::vector<std::string> names_of(const CourseWord& word);

/// Whether a text speaks of what was written: case, spaces and hyphens, s or z, accents do not matter.
bool speaks_of(std::string_view text, std::string_view written);

}  // namespace rigor
