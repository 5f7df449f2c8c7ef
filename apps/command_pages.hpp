#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rigor {

// What the program says of its own commands: in help, man pages and the completion of shells. All of it comes
// from the definitions that read the command line, and from the table of examples.

/// An option or an argument of a command.
struct OptionPage {
  std::vector<std::string> names;  ///< "-o", "--output"; none for an argument.
  std::string placeholder;         ///< "OUT"; empty for a flag. Of an argument its name: "SCENE".
  std::string what;
  bool is_required = false;
  bool is_list = false;  ///< Of an argument: whether there may be several.
};

struct CommandPage {
  std::string name, what;
  std::vector<OptionPage> arguments, options;
};

struct ProgramPages {
  std::string what, version;
  std::vector<OptionPage> options;  ///< Those of the program without a command.
  std::vector<CommandPage> commands;
};

/// A command line to try, and what it shows (empty where that is plain).
struct Example {
  std::string_view command, line, remark;
};

/// The examples of a command; of an empty name the first one of each command.
std::vector<Example> examples_of(std::string_view command);

/// What the exit codes mean, code by code.
struct ExitMeaning {
  int code;
  std::string_view meaning;
};
const std::vector<ExitMeaning>& exit_meanings();

/// "rigor run [OPTIONS] SCENE".
std::string usage_line(const CommandPage& command);

/// Help of the program, or of one command alone, in lines of `width` characters at most where words allow it.
std::string help_text(const ProgramPages& pages, int width);
std::string help_text(const CommandPage& command, int width);

/// The man page of section 1 of the program, or of one command (rigor-run).
std::string manual_text(const ProgramPages& pages);
std::string manual_text(const ProgramPages& pages, const CommandPage& command);

/// What a shell can complete in place of a word.
struct Candidates {
  std::vector<std::string> words;     ///< Only these, unless empty.
  bool is_file = false;               ///< Names of files,
  std::vector<std::string> suffixes;  ///< with one of these suffixes (no point), unless empty.
};
Candidates candidates_of(const OptionPage& option, const ProgramPages& pages);

/// The shells that there is a completion for: bash, zsh, fish.
const std::vector<std::string>& completion_shells();
/// The script that completes the command line of the program in one of these shells.
std::string completion_text(const ProgramPages& pages, std::string_view shell);

}  // namespace rigor
