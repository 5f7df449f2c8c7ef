#pragma once

#include <string>
#include <string_view>

namespace rigor {

/// A text of a user as it is shown to people: control characters, marks of the direction of writing and bytes
/// that are not UTF-8 are written as \xNN, so that no name can drive a terminal or look like another one.
std::string escaped_text(std::string_view text);

/// 'text' for a message: escaped, and truncated after 60 bytes (at a character boundary).
std::string quoted_text(std::string_view text);

/// Length in bytes of the UTF-8 character at the start of the text (1 to 4), or 0 if there is none: not UTF-8
/// (overlong forms and surrogates are refused) or empty.
int utf8_length(std::string_view text);

}  // namespace rigor
