#include "contracts/program.hpp"

#include <gtest/gtest.h>

#include <map>
#include <sstream>

// What the program tells of its own commands: help, man pages and the completion of three shells, all made
// from the definitions that read the command line.

namespace rigor::command_help_test {
namespace {

/// Lines below a title of a help text: first words of those that begin a term.
std::vector<std::string> terms_below(const std::string& help, const std::string& title) {
  std::istringstream lines(help);
  std::vector<std::string> terms;
  bool is_below = false;
  for (std::string line; std::getline(lines, line);) {
    if (is_below && line.empty()) break;
    if (is_below && line.size() > 2 && line[2] != ' ') terms.push_back(line.substr(2));
    if (line == title) is_below = true;
  }
  return terms;
}

std::string first_word(const std::string& text) {
  return text.substr(0, text.find_first_of(" ,"));
}

/// The long options of each command.
std::map<std::string, std::vector<std::string>> long_options(const ProgramFolder& folder) {
  std::map<std::string, std::vector<std::string>> options;
  for (const std::string& term : terms_below(folder.run({"--help"}).out, "Commands:")) {
    const std::string command = first_word(term);
    for (const std::string& line : terms_below(folder.run({"help", command}).out, "Options:")) {
      const std::size_t dashes = line.find("--");
      options[command].push_back(first_word(line.substr(dashes)));
    }
  }
  return options;
}

/// Output of a command line of a shell in the folder; nothing where the shell is not installed.
std::string output_of(const ProgramFolder& folder, const std::string& shell, const std::string& command) {
  folder.write("try.sh", command);
  const std::string line = "cd '" + (folder / "").string() + "' && " + shell + " try.sh > try.out 2>&1";
  const int code = std::system(line.c_str());
  const std::string text = folder.read("try.out");
  return code == 0 ? text : "failed: " + text;
}
bool has_shell(const std::string& shell) {
  return std::system(("command -v " + shell + " > /dev/null 2>&1").c_str()) == 0;
}

TEST(CommandHelp, OfACommandIsAboutThatCommand) {
  const ProgramFolder folder;
  const auto options = long_options(folder);
  EXPECT_GE(options.size(), 14u);
  for (const auto& [command, names] : options) {
    const std::string help = folder.run({command, "--help"}).out;
    EXPECT_EQ(help, folder.run({"help", command}).out);
    expect_contains(help, "Usage: rigor " + command);
    expect_contains(help, "Examples:");
    for (const auto& [other, theirs] : options) {
      // `manual` shows how to hand its page to another program.
      const bool is_named = help.find("rigor " + other + " ") != std::string::npos;
      EXPECT_TRUE(other == command || !is_named) << help;
    }
  }
  EXPECT_EQ(folder.run({"help"}).out, folder.run({"--help"}).out);
  EXPECT_EQ(folder.run({"-v"}).out, folder.run({"--version"}).out);
}

TEST(CommandHelp, FitsAHundredColumns) {
  const ProgramFolder folder;
  for (const auto& [command, names] : long_options(folder)) {
    std::istringstream lines(folder.run({"help", command}).out);
    for (std::string line; std::getline(lines, line);) {
      const auto length = std::count_if(
          line.begin(), line.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; });
      EXPECT_LE(length, 100) << line;
    }
  }
}

TEST(CommandHelp, UnknownWordsAreToldWithTheNearest) {
  const ProgramFolder folder;
  const ProgramResult command = folder.run({"help", "rnu"});
  EXPECT_EQ(command.code, 2);
  EXPECT_EQ(command.error, "error: unknown command 'rnu'; did you mean 'run'?\n");
  const ProgramResult shell = folder.run({"completion", "fisch"});
  EXPECT_EQ(shell.code, 2);
  EXPECT_EQ(shell.error, "error: unknown shell 'fisch'; did you mean 'fish'?\n");
  EXPECT_EQ(folder.run({"completion"}).code, 2);
  EXPECT_EQ(folder.run({"manual", "nothing"}).code, 2);
}

TEST(CommandHelp, BashCompletesCommandsOptionsAndFiles) {
  if (!has_shell("bash")) GTEST_SKIP() << "no bash";
  const ProgramFolder folder;
  folder.write("rigor.bash", folder.run({"completion", "bash"}).out);
  for (const char* file : {"ball.yaml", "ball.h5", "ball.txt", "a b.yaml"}) folder.write(file, "");
  const auto completed = [&](const std::string& words) {
    return output_of(
        folder, "bash",
        "source rigor.bash\nCOMP_WORDS=(rigor " + words +
            ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_rigor\nprintf '%s\\n' \"${COMPREPLY[@]}\"\n");
  };
  EXPECT_EQ(completed("ren"), "render\n");
  EXPECT_EQ(completed("run --se"), "--set\n--separate\n");
  EXPECT_EQ(completed("run ball.y"), "ball.yaml\n");
  EXPECT_EQ(completed("run a"), "a b.yaml\n");
  EXPECT_EQ(completed("plot ball."), "ball.h5\n");
  EXPECT_EQ(completed("run ball.yaml -o ball.t"), "ball.txt\n");
  EXPECT_EQ(completed("run ball.yaml --duration b"), "\n");
  EXPECT_EQ(completed("completion f"), "fish\n");
  EXPECT_EQ(completed("help comp"), "compare\ncompletion\n");
  // Every option of every command, in one shell.
  std::string script = "source rigor.bash\nCOMP_CWORD=2\n";
  const auto options = long_options(folder);
  for (const auto& [command, names] : options) {
    for (const std::string& name : names)
      script += "COMP_WORDS=(rigor " + command + " " + name + ")\n_rigor\necho \" ${COMPREPLY[*]} \"\n";
  }
  std::istringstream lines(output_of(folder, "bash", script));
  for (const auto& [command, names] : options) {
    for (const std::string& name : names) {
      std::string line;
      std::getline(lines, line);
      expect_contains(line, " " + name + " ");
    }
  }
}

TEST(CommandHelp, ZshAndFishReadTheirScripts) {
  const ProgramFolder folder;
  for (const std::string shell : {"zsh", "fish"}) {
    const std::string script = folder.run({"completion", shell}).out;
    folder.write("script", script);
    for (const auto& [command, options] : long_options(folder)) {
      expect_contains(script, command);
      for (const std::string& option : options)
        expect_contains(script, shell == "zsh" ? option : "-l " + option.substr(2));
    }
    if (!has_shell(shell)) continue;
    EXPECT_EQ(output_of(folder, shell, "true\n") + output_of(folder, shell + " -n", script), "");
  }
  if (!has_shell("fish")) return;
  folder.write("rigor.fish", folder.run({"completion", "fish"}).out);
  folder.write("ball.yaml", "");
  EXPECT_EQ(output_of(folder, "fish", "source rigor.fish\ncomplete -C 'rigor run --sep'\n"),
            "--separate\tpush apart bodies that overlap at t = 0\n");
  expect_contains(output_of(folder, "fish", "source rigor.fish\ncomplete -C 'rigor run b'\n"), "ball.yaml");
  expect_contains(output_of(folder, "fish", "source rigor.fish\ncomplete -C 'rigor ren'\n"), "render");
  // A number is no file.
  EXPECT_EQ(output_of(folder, "fish", "source rigor.fish\ncomplete -C 'rigor run --threads '\n"), "");
}

TEST(CommandHelp, ManPagesHaveEveryOptionAndAreProperRoff) {
  const ProgramFolder folder;
  const std::string overview = folder.run({"manual"}).out;
  for (const auto& [command, options] : long_options(folder)) {
    expect_contains(overview, "\\fBrigor\\-" + command + "\\fR(1)");
    const std::string page = folder.run({"manual", command}).out;
    folder.write("page.1", page);
    if (!has_shell("groff")) continue;
    const std::string shown = output_of(folder, "bash", "groff -k -man -ww -Tutf8 -P-cbou page.1\n");
    EXPECT_EQ(shown.find("warning"), std::string::npos) << shown;
    for (const std::string& option : options) expect_contains(shown, option);
    expect_contains(shown, "EXIT STATUS");
  }
}

}  // namespace
}  // namespace rigor::command_help_test
