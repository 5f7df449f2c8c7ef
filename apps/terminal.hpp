#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace rigor {

/// Whether the stream is a terminal that can move its cursor.
bool is_terminal(std::FILE* stream);
/// Number of columns of the terminal; 80 if unknown.
int terminal_width(std::FILE* stream);

/// Whether the locale of the environment (LC_ALL, LC_CTYPE or LANG) writes UTF-8.
bool speaks_utf8();

enum class Tone { plain, strong, good, bad, doubtful };
/// The text, escaped (escaped_text), in colour if the stream is a terminal and NO_COLOR is not set, else as
/// it is.
///
/// Source: https://no-color.org.
std::string toned(std::string_view text, Tone tone, std::FILE* stream);

/// The text with each of its lines escaped: what may hold names of a scene is printed through it.
std::string escaped_lines(std::string_view text);
/// "error: message" as a line on stderr.
void print_error(std::string_view message);
/// "warning: message" as a line on stderr.
void print_warning(std::string_view message);
/// Text to stdout, or to the file of that name; nothing if the path is empty. Throws FileError.
void write_text(const std::string& path, std::string_view text);

}  // namespace rigor
