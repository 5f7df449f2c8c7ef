#include "apps/text_table.hpp"

#include "rigor/core/index.hpp"

#include <algorithm>

namespace rigor {

namespace {

constexpr std::size_t gap = 2;

bool begins_character(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
}

std::size_t width_of(const TableColumn& column) {
  std::size_t width = std::max(text_length(column.top), text_length(column.bottom));
  for (const TableCell& cell : column.cells) width = std::max(width, text_length(cell.text));
  return width;
}

std::size_t width_of(const std::vector<const TableColumn*>& columns) {
  std::size_t width = 0;
  for (const TableColumn* const column : columns) width += (width > 0 ? gap : 0) + width_of(*column);
  return width;
}

using Block = std::vector<const TableColumn*>;

/// Width of a column together with those that belong beside it, with the gaps before them.
std::size_t group_width(const std::vector<TableColumn>& columns, std::size_t first) {
  std::size_t width = gap + width_of(columns[first]);
  for (std::size_t i = first; i + 1 < columns.size() && columns[i].is_with_next; ++i)
    width += gap + width_of(columns[i + 1]);
  return width;
}

/// The groups of columns that stand side by side.
std::vector<Block> blocks_of(const std::vector<TableColumn>& columns, std::size_t key_count,
                             std::size_t width) {
  Block keys;
  for (std::size_t i = 0; i < key_count; ++i) keys.push_back(&columns[i]);
  if (width_of(keys) > width / 2) keys.resize(1);
  std::vector<Block> blocks = {keys};
  for (std::size_t i = keys.size(); i < columns.size(); ++i) {
    // A group that is too wide for any line is split where necessary.
    const std::size_t group = group_width(columns, i), one = gap + width_of(columns[i]);
    const std::size_t wanted = width_of(keys) + group <= width ? group : one;
    const bool fits = width_of(blocks.back()) + wanted <= width;
    if (!fits && blocks.back().size() > keys.size()) blocks.push_back(keys);
    blocks.back().push_back(&columns[i]);
  }
  return blocks;
}

/// Joins the cells of a line; the tone applies to the text of a cell, not to the spaces around it.
class Line {
 public:
  explicit Line(std::FILE* stream) : stream_(stream) {}

  void add(const TableColumn& column, const TableCell& cell) {
    const std::size_t room = width_of(column) - text_length(cell.text);
    if (column.is_right) spaces_ += room;
    if (!cell.text.empty()) {
      text_.append(spaces_, ' ').append(toned(cell.text, cell.tone, stream_));
      spaces_ = 0;
    }
    spaces_ += (column.is_right ? 0 : room) + gap;
  }

  /// The line without trailing spaces.
  std::string text() const { return text_ + "\n"; }

 private:
  std::FILE* stream_;
  std::string text_;
  std::size_t spaces_ = 0;  ///< Spaces before the next text.
};

std::string block_text(const Block& block, std::FILE* stream) {
  std::string text;
  for (const auto part : {&TableColumn::top, &TableColumn::bottom}) {
    Line line(stream);
    for (const TableColumn* const column : block) line.add(*column, {column->*part, Tone::strong});
    text += line.text();
  }
  std::size_t rows = 0;
  for (const TableColumn* const column : block) rows = std::max(rows, column->cells.size());
  for (std::size_t row = 0; row < rows; ++row) {
    Line line(stream);
    for (const TableColumn* const column : block) line.add(*column, column->cells[row]);
    text += line.text();
  }
  return text;
}

}  // namespace

std::string wrapped_text(std::string_view text, std::size_t indent, int width) {
  const std::size_t most = at(std::max(width, 1));
  std::string lines, line(indent, ' ');
  bool is_empty = true;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (!is_empty && text_length(line) + 1 + text_length(word) > most) {
      lines += line + "\n";
      line.assign(indent + 2, ' ');
      is_empty = true;
    }
    if (!is_empty) line += ' ';
    line += word;
    is_empty = false;
  }
  return lines + line + "\n";
}

std::size_t text_length(std::string_view text) {
  return at(std::count_if(text.begin(), text.end(), begins_character));
}

std::string shortened(std::string_view text, std::size_t most) {
  if (text_length(text) <= most) return std::string(text);
  std::size_t end = 0;
  for (std::size_t count = 0; end < text.size(); ++end) {
    if (begins_character(text[end]) && count++ == most - 1) break;
  }
  return std::string(text.substr(0, end)) + "…";
}

std::string table_text(const std::vector<TableColumn>& columns, std::size_t key_count, int width,
                       std::FILE* stream) {
  std::string text;
  for (const Block& block : blocks_of(columns, key_count, at(std::max(width, 1)))) {
    if (!text.empty()) text += "\n";
    text += block_text(block, stream);
  }
  return text;
}

}  // namespace rigor
