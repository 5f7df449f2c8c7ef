#include "rigor/view/plot/markup_text.hpp"

#include "rigor/core/quoted.hpp"

namespace rigor {

std::string markup_text(std::string_view text) {
  std::string result;
  for (const char c : escaped_text(text)) {
    switch (c) {
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '&':
        result += "&amp;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

}  // namespace rigor
