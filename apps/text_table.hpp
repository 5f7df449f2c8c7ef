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
  bool is_right = false;      ///< Numbers end at the same place.
  bool is_with_next = false;  ///< Stands beside the next column if there is room for both.
  std::vector<TableCell> cells = {};
};

/// The columns side by side, at most `width` characters a line: what does not fit goes on below, with the
/// first `key_count` columns again (with the first one alone if all of them take more than half of the
/// width). A column that is wider than the rest of a line stands there alone. Colours if the stream, where
/// the text will be printed, is a terminal.
std::string table_text(const std::vector<TableColumn>& columns, std::size_t key_count, int width,
                       std::FILE* stream);

/// The text in lines of at most `width` characters, broken at spaces; the first line after `indent` blanks,
/// the others after two more. A word that is longer than a line stands there alone. Each line ends with a
/// newline.
std::string wrapped_text(std::string_view text, std::size_t indent, int width);

/// Characters of UTF-8 text.
std::size_t text_length(std::string_view text);
/// The text, or so many of its characters that there are `most` with the "…" that stands for the rest.
std::string shortened(std::string_view text, std::size_t most);

}  // namespace rigor
