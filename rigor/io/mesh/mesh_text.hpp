#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rigor {

/// The text of a mesh file as lines of words. Every error message names the file and the line.
class MeshText {
 public:
  /// A line ends at the comment sign, unless that is 0.
  MeshText(std::string_view text, std::string name, char comment);

  /// Moves to the next line that has words; false at the end.
  bool next_line();
  /// Adds the words of the next line to this one; false at the end.
  bool append_line();
  std::vector<std::string_view>& words() { return words_; }
  /// Number of bytes that have not been read.
  std::size_t bytes_left() const { return text_.size() - position_; }
  std::size_t line() const { return line_; }

  /// The word as a finite number: digits with a point and an exponent, nothing else.
  double number(std::string_view word) const;
  /// The word as an integer, within ± 2⁶³.
  std::int64_t whole_number(std::string_view word) const;

  /// Throws InputError; the message begins with the file and the current line.
  [[noreturn]] void fail(const std::string& what) const;
  [[noreturn]] void fail_at(std::size_t line, const std::string& what) const;

 private:
  void split(std::string_view line);

  std::string_view text_;
  std::string name_;
  char comment_;
  std::size_t position_ = 0;
  std::size_t line_ = 0;  ///< Counting from 1.
  std::vector<std::string_view> words_;
};

/// Whether the words are equal except for the case of ASCII letters; keyword is in lower case.
bool is_keyword(std::string_view word, std::string_view keyword);

}  // namespace rigor
