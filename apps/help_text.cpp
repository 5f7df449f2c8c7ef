#include "apps/command_pages.hpp"
#include "rigor/core/index.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace rigor {

namespace {

/// Number of characters, not bytes.
int characters(std::string_view text) {
  return static_cast<int>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string spaces(int count) {
  return std::string(at(std::max(0, count)), ' ');
}

/// The text in lines of at most `width` characters, the first one after `used` of them, the others indented.
std::string wrapped(std::string_view text, int used, int indent, int width) {
  std::string lines;
  int column = used;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const bool is_first = column == used && lines.empty();
    if (!is_first && column + 1 + characters(word) > width) {
      lines += "\n" + spaces(indent);
      column = indent;
    } else if (!is_first) {
      lines += ' ';
      ++column;
    }
    lines += word;
    column += characters(word);
  }
  return lines;
}

/// A list of terms with what they mean: "  -o, --output OUT  by suffix: ...".
struct Term {
  std::string name, what;
};
std::string list_of(const std::string& title, const std::vector<Term>& terms, int width) {
  constexpr int widest_name = 26;
  if (terms.empty()) return {};
  int column = 0;
  for (const Term& term : terms) column = std::max(column, std::min(characters(term.name), widest_name));
  column += 4;
  std::string text = "\n" + title + ":\n";
  for (const Term& term : terms) {
    std::string line = "  " + term.name;
    const int count = characters(line);
    // A long name has a line of its own.
    line += count + 2 > column ? "\n" + spaces(column) : spaces(column - count);
    text += line + wrapped(term.what, column, column, width) + "\n";
  }
  return text;
}

Term term_of(const OptionPage& option) {
  std::string name = option.names.empty() ? option.placeholder + (option.is_list ? "..." : "")
                                          : fmt::format("{}", fmt::join(option.names, ", "));
  if (!option.names.empty() && !option.placeholder.empty()) name += " " + option.placeholder;
  return {name, option.what};
}

std::vector<Term> terms_of(const std::vector<OptionPage>& options) {
  std::vector<Term> terms;
  terms.reserve(options.size());
  for (const OptionPage& option : options) terms.push_back(term_of(option));
  return terms;
}

/// Examples, with remarks beside those that are short and below the others.
std::string examples_text(const std::vector<Example>& examples) {
  constexpr int widest_beside = 50;
  if (examples.empty()) return {};
  int column = 0;
  for (const Example& example : examples) {
    const int count = characters(example.line);
    if (!example.remark.empty() && count <= widest_beside) column = std::max(column, count);
  }
  std::string text = "\nExamples:\n";
  for (const Example& example : examples) {
    const int count = characters(example.line);
    text += fmt::format("  {}", example.line);
    if (!example.remark.empty()) text += count <= column ? spaces(column - count + 4) : "\n      ";
    text += fmt::format("{}\n", example.remark);
  }
  return text;
}

std::string exit_codes_text(int width) {
  std::string text = "Exit codes:";
  for (const ExitMeaning& exit : exit_meanings())
    text += fmt::format("{} {} {}", exit.code == 0 ? "" : ",", exit.code, exit.meaning);
  return "\n" + wrapped(text + ".", 0, 12, width) + "\n";
}

}  // namespace

std::string usage_line(const CommandPage& command) {
  std::string line = fmt::format("rigor {}{}", command.name, command.options.empty() ? "" : " [OPTIONS]");
  for (const OptionPage& argument : command.arguments) {
    const std::string name = argument.placeholder + (argument.is_list ? "..." : "");
    line += argument.is_required ? fmt::format(" {}", name) : fmt::format(" [{}]", name);
  }
  return line;
}

std::string help_text(const ProgramPages& pages, int width) {
  std::vector<Term> commands;
  for (const CommandPage& command : pages.commands) commands.push_back({command.name, command.what});
  return pages.what + "\n\nUsage: rigor COMMAND [OPTIONS] ...\n" + list_of("Commands", commands, width) +
         list_of("Options", terms_of(pages.options), width) + examples_text(examples_of("")) +
         exit_codes_text(width) + "\n'rigor help COMMAND' tells all about a command.\n";
}

std::string help_text(const CommandPage& command, int width) {
  return fmt::format("rigor {}: {}\n\nUsage: {}\n", command.name, command.what, usage_line(command)) +
         list_of("Arguments", terms_of(command.arguments), width) +
         list_of("Options", terms_of(command.options), width) + examples_text(examples_of(command.name));
}

}  // namespace rigor
