#pragma once

#include "apps/terminal.hpp"

#include <cstddef>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

namespace rigor {

struct TableCell {
  std::string text;
  Tone tone = Tone::plain;
};

/// A column with a heading of two lines, either of which may be empty.
struct TableColumn {
  std::string top, bottom;
  bool is_right = false;      ///< Right-aligned, for numbers.
  bool is_with_next = false;  ///< Stays beside the next column if both fit.
  std::vector<TableCell> cells = {};
};

/// The columns side by side, at most `width` characters per line: columns that do not fit continue below,
/// after the first `key_count` columns again (after the first one alone if all of them take more than half of
/// the width). A column that is wider than the rest of a line stands there alone. In colour if the stream to
/// which the text will be printed is a terminal.
std::string table_text(const std::vector<TableColumn>& columns, std::size_t key_count, int width,
                       std::FILE* stream);

/// The text in lines of at most `width` characters, broken at spaces; the first line is indented by `indent`,
/// the others by two more. A word longer than a line stands alone. Each line ends with a newline.
std::string wrapped_text(std::string_view text, std::size_t indent, int width);

/// Number of characters of a UTF-8 text.
std::size_t text_length(std::string_view text);
/// The text, truncated to `most` characters with "…" at the end if it is longer.
std::string shortened(std::string_view text, std::size_t most);

}  // namespace rigor
