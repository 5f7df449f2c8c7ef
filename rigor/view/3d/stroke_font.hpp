#pragma once

#include "rigor/math/types.hpp"

#include <string_view>
#include <vector>

namespace rigor {

using Polyline = std::vector<Vec2>;

/// Lines of a text in Rigor's own font, whose letters are pen strokes: capitals are 7 units high and small
/// letters 5, with x to the right and y up, and the first letter at (0, 0) on the base line. A character that
/// the font lacks becomes an empty frame.
struct TextLines {
  std::vector<Polyline> lines;  ///< A dot is a line of two equal points.
  double width;                 ///< From the left end of the first letter to the right end of the last.
};
TextLines text_lines(std::string_view utf8);

/// Height of capitals in units of the font.
inline constexpr double capital_height = 7;

}  // namespace rigor
