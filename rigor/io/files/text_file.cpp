#include "rigor/io/files/text_file.hpp"

#include "rigor/core/input_error.hpp"
#include "rigor/core/quoted.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <string_view>
#include <system_error>

namespace rigor {

namespace {

/// "UTF-16" or "UTF-32" if the text starts as such, by its byte order mark or by the NUL bytes of its first
/// letters.
std::string_view wide_encoding(std::string_view text) {
  using namespace std::string_view_literals;
  if (text.starts_with("\xFF\xFE\0\0"sv) || text.starts_with("\0\0\xFE\xFF"sv)) return "UTF-32";
  if (text.starts_with("\xFF\xFE"sv) || text.starts_with("\xFE\xFF"sv)) return "UTF-16";
  if (text.size() >= 4 && text[0] != 0 && text[1] == 0 && text[2] != 0 && text[3] == 0) return "UTF-16";
  if (text.size() >= 4 && text[0] == 0 && text[1] != 0 && text[2] == 0 && text[3] != 0) return "UTF-16";
  return {};
}

std::string place(const std::string& name, std::string_view text, std::size_t at) {
  const std::string_view before = text.substr(0, at);
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t start = before.rfind('\n');
  const std::size_t column = start == std::string_view::npos ? at + 1 : at - start;
  return name + ":" + std::to_string(line) + ":" + std::to_string(column) + ": ";
}

}  // namespace

void check_text(const std::string& text, const std::string& name) {
  const std::string_view encoding = wide_encoding(text);
  if (!encoding.empty()) {
    throw InputError(name + ": the file is " + std::string(encoding) + ", must be UTF-8; save it as UTF-8");
  }
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] == 0) throw InputError(place(name, text, i) + "a NUL byte; the file must be text in UTF-8");
    const int length = utf8_length(std::string_view(text).substr(i, 4));
    if (length == 0) {
      throw InputError(place(name, text, i) + "the bytes " +
                       quoted_text(std::string_view(text).substr(i, 1)) +
                       " are not UTF-8; save the file as UTF-8");
    }
    i += static_cast<std::size_t>(length);
  }
}

std::string read_text_file(const std::filesystem::path& path, std::uintmax_t max_bytes) {
  const std::string name = path.string();
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw InputError(name + ": there is no such file");
  if (std::filesystem::is_directory(status)) throw InputError(name + ": it is a directory, not a file");
  if (!std::filesystem::is_regular_file(status)) throw InputError(name + ": it is not a regular file");
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) throw InputError(name + ": cannot be read (" + error.message() + ")");
  if (size > max_bytes) {
    throw InputError(name + ": the file has " + std::to_string(size) + " bytes, must be at most " +
                     std::to_string(max_bytes));
  }

  std::ifstream file(path, std::ios::binary);
  std::string text(static_cast<std::size_t>(size), '\0');
  if (!file || (size > 0 && !file.read(text.data(), static_cast<std::streamsize>(size)))) {
    throw InputError(name + ": cannot be read (" + std::strerror(errno) + ")");
  }
  check_text(text, name);
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
  return text;
}

}  // namespace rigor
