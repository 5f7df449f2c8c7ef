#include "rigor/io/mesh/height_file.hpp"

#include "rigor/core/input_error.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/core/range.hpp"
#include "rigor/io/files/scalar_text.hpp"
#include "rigor/io/files/text_file.hpp"
#include "rigor/model/limits.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

namespace rigor {

namespace {

/// The largest file: as many heights as allowed, with 24 bytes each, the length of a double with all digits.
constexpr std::uintmax_t max_bytes = 32 * std::uintmax_t{limits::height_count};

constexpr std::string_view blanks = " \t\r";

/// Reads the text line by line and keeps track of the position.
class HeightParser {
 public:
  HeightParser(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  HeightRows parse() {
    while (!text_.empty()) {
      ++line_;
      const std::string_view line = text_.substr(0, text_.find('\n'));
      text_.remove_prefix(std::min(line.size() + 1, text_.size()));
      if (line.find_first_not_of(blanks) != std::string_view::npos) add_row(line);
    }
    if (rows_.empty()) {
      throw InputError(name_ + ": the file is empty, must have rows of numbers between commas");
    }
    return std::move(rows_);
  }

 private:
  void add_row(std::string_view line) {
    std::vector<double> row;
    for (std::size_t start = 0; start <= line.size();) {
      const std::string_view cell = line.substr(start, line.find(',', start) - start);
      row.push_back(height(cell, start + 1));
      start += cell.size() + 1;
      if (++count_ > limits::height_count) {
        fail(1, fmt::format("more heights than allowed, must be at most {} in all", limits::height_count));
      }
    }
    if (rows_.empty()) first_line_ = line_;
    if (!rows_.empty() && row.size() != rows_.front().size()) {
      fail(1, fmt::format("the row has {} numbers, must have {} as the one in line {}", row.size(),
                          rows_.front().size(), first_line_));
    }
    rows_.push_back(std::move(row));
  }

  /// column: that of the first byte of the cell, counted from 1.
  double height(std::string_view cell, std::size_t column) const {
    const std::size_t start = cell.find_first_not_of(blanks);
    if (start == std::string_view::npos) fail(column, "nothing between commas, must be a number (m)");
    const std::string_view word = cell.substr(start, cell.find_last_not_of(blanks) + 1 - start);
    const NumberText number = parse_number(word);
    if (!number.value) fail(column + start, quoted_text(word) + " is not a number" + number.hint);
    const std::string error = range_error("the height", *number.value, limits::position, "m");
    if (!error.empty()) fail(column + start, error);
    return *number.value;
  }

  [[noreturn]] void fail(std::size_t column, const std::string& what) const {
    throw InputError(fmt::format("{}:{}:{}: {}", name_, line_, column, what));
  }

  std::string_view text_;
  const std::string& name_;
  HeightRows rows_;
  std::size_t line_ = 0, first_line_ = 0, count_ = 0;
};

}  // namespace

HeightRows read_heights(const std::filesystem::path& path) {
  std::string suffix = path.extension().string();
  for (char& c : suffix) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  if (suffix != ".csv") {
    throw InputError(path.string() + ": unknown kind of file of heights '" + suffix + "'; allowed is .csv");
  }
  return parse_heights(read_text_file(path, max_bytes), path.string());
}

HeightRows parse_heights(std::string_view text, const std::string& name) {
  return HeightParser(text, name).parse();
}

}  // namespace rigor
