#include "rigor/study/formula/formula.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/core/quoted.hpp"

#include <muParser.h>

#include <algorithm>
#include <cctype>
#include <limits>
#include <numbers>
#include <string_view>

namespace rigor {

namespace {

constexpr const char* name_characters = "0123456789_.[]abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
/// Longest text of a formula: far above any, and far below what would exhaust the stack of a parser.
constexpr std::size_t longest_formula = 4096;

[[noreturn]] void fail(const std::string& text, const std::string& what) {
  throw InputError("formula " + quoted_text(text) + ": " + what);
}

/// muParser assigns with '='; here it can only be meant as a comparison.
void check_characters(const std::string& text) {
  if (text.size() > longest_formula)
    fail(text, "it has more than " + std::to_string(longest_formula) + " characters");
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (static_cast<unsigned char>(text[i]) > 126) fail(text, "its characters must be those of ASCII");
    if (text[i] != '=') continue;
    const bool is_second = i > 0 && std::string_view("=<>!").find(text[i - 1]) != std::string_view::npos;
    const bool is_first = i + 1 < text.size() && text[i + 1] == '=';
    if (!is_second && !is_first) fail(text, "'=' does not compare, write '=='");
    if (is_first) ++i;
  }
}

}  // namespace

struct Formula::Parser {
  std::string text;
  std::vector<std::string> names;
  std::vector<double> values;  // Where muParser looks for the names.
  mu::Parser parser;
};

Formula::Formula(const std::string& text) : parser_(std::make_unique<Parser>()) {
  check_characters(text);
  parser_->text = text;
  mu::Parser& parser = parser_->parser;
  try {
    parser.DefineNameChars(name_characters);
    parser.DefineConst("pi", std::numbers::pi);
    parser.SetExpr(text);
    for (const auto& [name, place] : parser.GetUsedVar()) parser_->names.push_back(name);
    std::sort(parser_->names.begin(), parser_->names.end());
    parser_->values.assign(parser_->names.size(), 1.0);
    for (std::size_t i = 0; i < parser_->names.size(); ++i)
      parser.DefineVar(parser_->names[i], &parser_->values[i]);
    // Syntax is checked by the first evaluation only.
    parser.Eval();
  } catch (const mu::Parser::exception_type& error) {
    fail(text, error.GetMsg());
  }
  if (parser.GetNumResults() != 1) fail(text, "it has several values, separated by commas");
}

Formula::Formula(Formula&&) noexcept = default;
Formula& Formula::operator=(Formula&&) noexcept = default;
Formula::~Formula() = default;

const std::string& Formula::text() const {
  return parser_->text;
}

const std::vector<std::string>& Formula::names() const {
  return parser_->names;
}

double Formula::value(std::span<const double> values) const {
  RIGOR_ASSERT(values.size() == parser_->values.size());
  std::copy(values.begin(), values.end(), parser_->values.begin());
  try {
    return parser_->parser.Eval();
  } catch (const mu::Parser::exception_type&) {
    return std::numeric_limits<double>::quiet_NaN();
  }
}

}  // namespace rigor
