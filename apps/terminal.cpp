#include "apps/terminal.hpp"

#include "rigor/core/quoted.hpp"
#include "rigor/io/files/output_file.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cstdlib>

#include <sys/ioctl.h>
#include <unistd.h>

namespace rigor {

bool is_terminal(std::FILE* stream) {
  const char* const kind = std::getenv("TERM");
  return ::isatty(::fileno(stream)) == 1 && kind != nullptr && std::string_view(kind) != "dumb";
}

int terminal_width(std::FILE* stream) {
  constexpr int usual_width = 80;
  winsize size{};
  return ::ioctl(::fileno(stream), TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : usual_width;
}

bool speaks_utf8() {
  for (const char* const variable : {"LC_ALL", "LC_CTYPE", "LANG"}) {
    const char* const value = std::getenv(variable);
    if (value == nullptr || *value == 0) continue;
    std::string locale;
    for (const char c : std::string_view(value)) {
      if (c != '-') locale += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return locale.find("utf8") != std::string::npos;
  }
  return false;
}

std::string toned(std::string_view given, Tone tone, std::FILE* stream) {
  std::string text = escaped_text(given);
  const char* const no_color = std::getenv("NO_COLOR");
  const bool has_colors = is_terminal(stream) && (no_color == nullptr || *no_color == 0);
  if (!has_colors || tone == Tone::plain) return text;
  const int code = tone == Tone::strong ? 1 : tone == Tone::good ? 32 : tone == Tone::bad ? 31 : 33;
  return fmt::format("\x1b[{}m{}\x1b[0m", code, text);
}

std::string escaped_lines(std::string_view text) {
  std::string result;
  while (true) {
    const std::size_t end = text.find('\n');
    result += escaped_text(text.substr(0, end));
    if (end == std::string_view::npos) return result;
    result += '\n';
    text.remove_prefix(end + 1);
  }
}

void print_error(std::string_view message) {
  // Results that were printed earlier must appear earlier.
  std::fflush(stdout);
  fmt::print(stderr, "{} {}\n", toned("error:", Tone::bad, stderr), escaped_lines(message));
}

void print_warning(std::string_view message) {
  std::fflush(stdout);
  fmt::print(stderr, "{} {}\n", toned("warning:", Tone::doubtful, stderr), escaped_lines(message));
}

void write_text(const std::string& path, std::string_view text) {
  if (path.empty()) return;
  if (path == "-") {
    std::fwrite(text.data(), 1, text.size(), stdout);
    return;
  }
  OutputFile file(path);
  file.append(text);
  file.close();
}

}  // namespace rigor
