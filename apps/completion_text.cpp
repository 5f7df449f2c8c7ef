#include "apps/command_pages.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

namespace rigor {

namespace {

/// The text in single quotes, as all three shells read it; fish alone lets backslashes escape in there.
std::string in_quotes(std::string_view text, bool escapes_by_backslash = false) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'') {
      result += escapes_by_backslash ? "\\'" : "'\\''";
    } else {
      if (c == '\\' && escapes_by_backslash) result += '\\';
      result += c;
    }
  }
  return result + "'";
}

std::vector<std::string> names_of(const std::vector<OptionPage>& options) {
  std::vector<std::string> names;
  for (const OptionPage& option : options)
    names.insert(names.end(), option.names.begin(), option.names.end());
  return names;
}

std::vector<std::string> command_names(const ProgramPages& pages) {
  std::vector<std::string> names;
  for (const CommandPage& command : pages.commands) names.push_back(command.name);
  return names;
}

std::string header(std::string_view shell) {
  return fmt::format("# Completion of rigor for {0}, made by 'rigor completion {0}'.\n", shell);
}

// bash

/// What fills COMPREPLY for a word: names of files, words, or nothing.
std::string bash_reply(const Candidates& candidates) {
  if (!candidates.words.empty())
    return fmt::format("_rigor_words {}", in_quotes(fmt::format("{}", fmt::join(candidates.words, " "))));
  if (candidates.is_file)
    return fmt::format("_rigor_files {}", in_quotes(fmt::format("{}", fmt::join(candidates.suffixes, "|"))));
  return ":";
}

std::string bash_command(const CommandPage& command, const ProgramPages& pages) {
  std::string text = fmt::format("    {})\n      case $before in\n", command.name);
  for (const OptionPage& option : command.options) {
    if (option.placeholder.empty()) continue;
    text += fmt::format("        {}) {}; return ;;\n", fmt::join(option.names, "|"),
                        bash_reply(candidates_of(option, pages)));
  }
  text += "      esac\n";
  const std::string options =
      fmt::format("_rigor_words {}", in_quotes(fmt::format("{}", fmt::join(names_of(command.options), " "))));
  const Candidates first =
      command.arguments.empty() ? Candidates{} : candidates_of(command.arguments.front(), pages);
  return text +
         fmt::format("      if [[ $word == -* ]]; then {}; else {}; fi ;;\n", options, bash_reply(first));
}

std::string bash_completion(const ProgramPages& pages) {
  std::vector<std::string> begin = command_names(pages);
  for (const std::string& name : names_of(pages.options)) begin.push_back(name);
  std::string text = header("bash") +
                     "_rigor_words() { COMPREPLY=($(compgen -W \"$1\" -- \"$word\")); }\n"
                     "_rigor_files() {  # Those with one of the suffixes, and folders.\n"
                     "  local file\n"
                     "  compopt -o filenames 2>/dev/null\n"
                     "  while IFS= read -r file; do\n"
                     "    if [[ -d $file || -z $1 || $file =~ \\.($1)$ ]]; then COMPREPLY+=(\"$file\"); fi\n"
                     "  done < <(compgen -f -- \"$word\")\n"
                     "}\n"
                     "_rigor() {\n"
                     "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]}\n"
                     "  COMPREPLY=()\n";
  text += fmt::format("  if ((COMP_CWORD == 1)); then _rigor_words {}; return; fi\n",
                      in_quotes(fmt::format("{}", fmt::join(begin, " "))));
  text += "  case ${COMP_WORDS[1]} in\n";
  for (const CommandPage& command : pages.commands) text += bash_command(command, pages);
  return text + "  esac\n}\ncomplete -F _rigor rigor\n";
}

// zsh

/// What stands in brackets or between colons of a specification of _arguments.
std::string zsh_text(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

/// ":message:action" of a value.
std::string zsh_value(const OptionPage& option, const ProgramPages& pages) {
  const Candidates candidates = candidates_of(option, pages);
  std::string action = " ";
  if (!candidates.words.empty()) action = fmt::format("({})", fmt::join(candidates.words, " "));
  if (candidates.is_file) {
    action = candidates.suffixes.empty()
                 ? "_files"
                 : fmt::format("_files -g \"*.({})\"", fmt::join(candidates.suffixes, "|"));
  }
  return fmt::format(":{}:{}", zsh_text(option.placeholder), action);
}

std::string zsh_completion(const ProgramPages& pages) {
  std::string text = "#compdef rigor\n" + header("zsh") + "_rigor() {\n  local -a commands=(\n";
  for (const CommandPage& command : pages.commands)
    text += "    " + in_quotes(command.name + ":" + zsh_text(command.what)) + "\n";
  text += "  )\n  if (( CURRENT == 2 )); then\n    _describe command commands\n    _arguments";
  for (const OptionPage& option : pages.options) {
    for (const std::string& name : option.names)
      text += " " + in_quotes(name + "[" + zsh_text(option.what) + "]");
  }
  text += "\n    return\n  fi\n  shift words\n  (( CURRENT-- ))\n  case $words[1] in\n";
  for (const CommandPage& command : pages.commands) {
    text += fmt::format("    {}) _arguments", command.name);
    for (const OptionPage& option : command.options) {
      const std::string value = option.placeholder.empty() ? "" : zsh_value(option, pages);
      for (const std::string& name : option.names)
        text += " \\\n      " + in_quotes(fmt::format("*{}[{}]{}", name, zsh_text(option.what), value));
    }
    for (const OptionPage& argument : command.arguments)
      text += " \\\n      " + in_quotes((argument.is_list ? "*" : "") + zsh_value(argument, pages));
    text += " ;;\n";
  }
  return text +
         "  esac\n}\nif [ \"$funcstack[1]\" = _rigor ]; then _rigor \"$@\"; else compdef _rigor rigor; fi\n";
}

// fish

/// Option of `complete` that says what a value may be.
std::string fish_value(const Candidates& candidates) {
  if (!candidates.words.empty())
    return " -a " + in_quotes(fmt::format("{}", fmt::join(candidates.words, " ")), true);
  if (!candidates.is_file) return "";
  if (candidates.suffixes.empty()) return " -F";
  std::string commands;
  for (const std::string& suffix : candidates.suffixes)
    commands += fmt::format("{}__fish_complete_suffix .{}", commands.empty() ? "" : "; ", suffix);
  return " -k -a " + in_quotes("(" + commands + ")", true);
}

std::string fish_option(const OptionPage& option, const std::string& where, const ProgramPages& pages) {
  std::string text = "complete -c rigor" + where;
  for (const std::string& name : option.names)
    text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  // What takes no file (-x) is offered none.
  if (!option.placeholder.empty()) {
    const Candidates candidates = candidates_of(option, pages);
    text += (candidates.is_file ? " -r" : " -x") + fish_value(candidates);
  }
  return text + " -d " + in_quotes(option.what, true) + "\n";
}

std::string fish_completion(const ProgramPages& pages) {
  std::string text = header("fish") + "complete -c rigor -f\n";
  for (const OptionPage& option : pages.options)
    text += fish_option(option, " -n __fish_use_subcommand", pages);
  for (const CommandPage& command : pages.commands) {
    text += fmt::format("complete -c rigor -n __fish_use_subcommand -a {} -d {}\n", command.name,
                        in_quotes(command.what, true));
    const std::string where = " -n " + in_quotes("__fish_seen_subcommand_from " + command.name, true);
    for (const OptionPage& option : command.options) text += fish_option(option, where, pages);
    if (command.arguments.empty()) continue;
    const std::string value = fish_value(candidates_of(command.arguments.front(), pages));
    if (!value.empty()) text.append("complete -c rigor").append(where).append(value).append("\n");
  }
  return text;
}

struct Shell {
  std::string name;
  std::string (*script)(const ProgramPages& pages);
};
const std::vector<Shell>& shells() {
  static const std::vector<Shell> all = {
      {"bash", bash_completion}, {"zsh", zsh_completion}, {"fish", fish_completion}};
  return all;
}

}  // namespace

Candidates candidates_of(const OptionPage& option, const ProgramPages& pages) {
  if (option.placeholder == "SHELL") return {completion_shells(), false, {}};
  if (option.placeholder == "COMMAND") return {command_names(pages), false, {}};
  struct Kind {
    std::string_view part;
    std::vector<std::string> suffixes;
  };
  static const std::vector<Kind> kinds = {{"SCENE", {"yaml", "json"}},
                                          {"MESH", {"obj", "stl", "ply"}},
                                          {"IN", {"obj", "stl", "ply"}},
                                          {"TRAJECTORY", {"h5"}},
                                          {"RUN.h5", {"h5"}},
                                          {"OUT", {}},
                                          {"OUT.png", {}},
                                          {"OUT.mp4", {}},
                                          {"FILE", {}},
                                          {"FILE.csv", {}}};
  Candidates candidates;
  bool is_any = false;
  std::string_view rest = option.placeholder;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('|'), rest.size());
    const auto kind = std::ranges::find(kinds, rest.substr(0, end), &Kind::part);
    if (kind != kinds.end()) {
      candidates.is_file = true;
      is_any = is_any || kind->suffixes.empty();
      candidates.suffixes.insert(candidates.suffixes.end(), kind->suffixes.begin(), kind->suffixes.end());
    }
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  if (is_any) candidates.suffixes.clear();
  return candidates;
}

const std::vector<std::string>& completion_shells() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Shell& shell : shells()) all.push_back(shell.name);
    return all;
  }();
  return names;
}

std::string completion_text(const ProgramPages& pages, std::string_view shell) {
  const auto found = std::ranges::find(shells(), shell, &Shell::name);
  return found == shells().end() ? std::string() : found->script(pages);
}

}  // namespace rigor
