#include "apps/command_pages.hpp"

#include <fmt/format.h>

#include <cctype>

namespace rigor {

namespace {

/// The text as roff shows it: backslashes, hyphens and signs that begin a request stand for themselves.
std::string roff(std::string_view text) {
  std::string escaped;
  bool begins_line = true;
  for (const char c : text) {
    if (begins_line && (c == '.' || c == '\'')) escaped += "\\&";
    if (c == '\\') {
      escaped += "\\e";
    } else if (c == '-') {
      escaped += "\\-";
    } else {
      escaped += c;
    }
    begins_line = c == '\n';
  }
  return escaped;
}

std::string bold(std::string_view text) {
  return "\\fB" + roff(text) + "\\fR";
}
std::string italic(std::string_view text) {
  return "\\fI" + roff(text) + "\\fR";
}

std::string heading(const std::string& page, const std::string& version, const std::string& what) {
  std::string title;
  for (const char c : page) title += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return fmt::format(
      ".\\\" Made by 'rigor manual'.\n.TH {} 1 \"\" \"rigor {}\" \"Rigor\"\n.SH NAME\n{} \\- {}\n",
      roff(title), version, roff(page), roff(what));
}

std::string option_list(const std::vector<OptionPage>& options) {
  std::string text;
  for (const OptionPage& option : options) {
    text += ".TP\n";
    for (std::size_t i = 0; i < option.names.size(); ++i)
      text += (i == 0 ? "" : ", ") + bold(option.names[i]);
    if (!option.placeholder.empty()) {
      if (!option.names.empty()) text += ' ';
      text += italic(option.placeholder) + (option.is_list ? "..." : "");
    }
    text += "\n" + roff(option.what) + "\n";
  }
  return text;
}

std::string examples_section(const std::vector<Example>& examples) {
  if (examples.empty()) return {};
  std::string text = ".SH EXAMPLES\n";
  for (const Example& example : examples) {
    text += ".PP\n.nf\n    " + roff(example.line) + "\n.fi\n";
    if (!example.remark.empty()) text += ".RS 8\n" + roff(example.remark) + "\n.RE\n";
  }
  return text;
}

std::string exit_section() {
  std::string text = ".SH EXIT STATUS\n";
  for (const ExitMeaning& exit : exit_meanings())
    text += fmt::format(".TP\n{}\n{}\n", bold(std::to_string(exit.code)), roff(exit.meaning));
  return text;
}

/// The text as a sentence.
std::string sentence(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text + ".";
}

std::string references(const std::vector<std::string>& pages) {
  std::string text = ".SH SEE ALSO\n";
  for (std::size_t i = 0; i < pages.size(); ++i)
    text += fmt::format("{}(1){}\n", bold(pages[i]), i + 1 < pages.size() ? "," : "");
  return text;
}

}  // namespace

std::string manual_text(const ProgramPages& pages) {
  std::string text = heading("rigor", pages.version, "rigid-body dynamics whose answers can be trusted") +
                     ".SH SYNOPSIS\n" + bold("rigor") + " " + italic("COMMAND") + " [" + italic("OPTIONS") +
                     "] ...\n.SH COMMANDS\n";
  std::vector<std::string> others;
  for (const CommandPage& command : pages.commands) {
    text += ".TP\n" + bold(command.name) + "\n" + roff(command.what) + "\n";
    others.push_back("rigor-" + command.name);
  }
  return text + ".SH OPTIONS\n" + option_list(pages.options) + examples_section(examples_of("")) +
         exit_section() + references(others);
}

std::string manual_text(const ProgramPages& pages, const CommandPage& command) {
  return heading("rigor-" + command.name, pages.version, command.what) + ".SH SYNOPSIS\n" +
         bold(usage_line(command)) + "\n.SH DESCRIPTION\n" + roff(sentence(command.what)) + "\n" +
         option_list(command.arguments) + ".SH OPTIONS\n" + option_list(command.options) +
         examples_section(examples_of(command.name)) + exit_section() + references({"rigor"});
}

}  // namespace rigor
