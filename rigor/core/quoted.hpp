#pragma once

#include <string>
#include <string_view>

namespace rigor {

/// 'text' for a message: truncated after 60 bytes (at a character boundary), with control characters and
/// bytes that are not UTF-8 written as \xNN, so that no message can corrupt a terminal, a log or a JSON file.
std::string quoted_text(std::string_view text);

/// Length in bytes of the UTF-8 character at the start of the text (1 to 4), or 0 if there is none: not UTF-8
/// (overlong forms and surrogates are refused) or empty.
int utf8_length(std::string_view text);

}  // namespace rigor
