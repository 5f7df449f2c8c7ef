#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <fcntl.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

/// Runs the real program in an empty folder of its own, as a user does.
namespace rigor {

struct ProgramResult {
  int code;           ///< Exit code, or minus the signal that ended it.
  std::string out;    ///< stdout; with a terminal also stderr.
  std::string error;  ///< stderr.
};

/// Text of a regular file, else nothing (a device may be endless).
inline std::string text_of(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path)) return {};
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

class ProgramFolder {
 public:
  ProgramFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "rigor_program_XXXXXX").string();
    if (!::mkdtemp(name.data())) std::abort();
    path_ = name;
  }
  ProgramFolder(const ProgramFolder&) = delete;
  ProgramFolder& operator=(const ProgramFolder&) = delete;
  ~ProgramFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  void write(const std::string& name, const std::string& text) const { std::ofstream(path_ / name) << text; }
  std::string read(const std::string& name) const { return text_of(path_ / name); }
  bool has(const std::string& name) const { return std::filesystem::exists(path_ / name); }

  /// Starts the program in the folder, its output in the files .out and .err there.
  pid_t start(const std::vector<std::string>& arguments) const {
    const pid_t child = ::fork();
    if (child == 0) {
      redirect(".out", STDOUT_FILENO);
      redirect(".err", STDERR_FILENO);
      execute(arguments);
    }
    return child;
  }

  ProgramResult wait(pid_t child) const {
    const int code = exit_code(child);
    return {code, read(".out"), read(".err")};
  }

  ProgramResult run(const std::vector<std::string>& arguments) const { return wait(start(arguments)); }

  /// Runs it on a terminal of 100 columns.
  ProgramResult run_on_terminal(const std::vector<std::string>& arguments, bool no_color) const {
    winsize size{};
    size.ws_row = 25, size.ws_col = 100;
    int terminal = -1;
    const pid_t child = ::forkpty(&terminal, nullptr, nullptr, &size);
    if (child == 0) {
      ::setenv("TERM", "xterm", 1);
      no_color ? ::setenv("NO_COLOR", "1", 1) : ::unsetenv("NO_COLOR");
      execute(arguments);
    }
    std::string out;
    char bytes[4096];
    // A terminal whose other end is closed gives an error instead of an end.
    for (ssize_t count = 0;
         (count = ::read(terminal, bytes, sizeof bytes)) > 0 || (count < 0 && errno == EINTR);) {
      if (count > 0) out.append(bytes, static_cast<std::size_t>(count));
    }
    ::close(terminal);
    return {exit_code(child), out, ""};
  }

 private:
  [[noreturn]] void execute(const std::vector<std::string>& arguments) const {
    if (::chdir(path_.c_str()) != 0) ::_exit(99);
    std::vector<std::string> words = {"rigor"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    ::execv(RIGOR_PROGRAM, pointers.data());
    ::_exit(98);
  }

  void redirect(const std::string& name, int descriptor) const {
    const int file = ::open((path_ / name).c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if (file < 0 || ::dup2(file, descriptor) < 0) ::_exit(97);
  }

  static int exit_code(pid_t child) {
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

  std::filesystem::path path_;
};

/// A ball that bounces on a floor.
inline const std::string ball_scene = R"(rigor: 1
name: ball
world: {gravity: [0, 0, -9.81]}
run: {duration: 1, output_interval: 0.1}
materials: [{name: rubber, restitution: 0.8, friction: 0.2}]
bodies:
  - {name: floor, motion: static, shapes: [{type: plane, normal: [0, 0, 1], offset: 0, material: rubber}]}
  - {name: ball, position: [0, 0, 1], velocity: [0.5, 0, 0], mass: 1, shapes: [{type: sphere, radius: 0.1, material: rubber}]}
)";

inline void expect_contains(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "no '" << part << "' in:\n" << text;
}

inline std::size_t line_count(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace rigor
