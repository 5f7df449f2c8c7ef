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
#include <poll.h>
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
    int terminal = -1, program_side = -1;
    if (::openpty(&terminal, &program_side, nullptr, nullptr, &size) < 0) return {-1, "", "no terminal"};
    const pid_t child = ::fork();
    if (child == 0) {
      ::close(terminal);
      for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(program_side, stream);
      ::close(program_side);
      ::setenv("TERM", "xterm", 1);
      no_color ? ::setenv("NO_COLOR", "1", 1) : ::unsetenv("NO_COLOR");
      execute(arguments);
    }
    std::string out = read_terminal(terminal, program_side, child);
    ::close(program_side);
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

  /// All that the child writes on the terminal. A terminal whose other end is closed may lose what was not
  /// yet read, so this process keeps that end open, and a mark of its own comes after the last that the child
  /// wrote.
  static std::string read_terminal(int terminal, int program_side, pid_t child) {
    constexpr char end_mark = '\x03';
    std::string out;
    bool ended = false;
    while (out.empty() || out.back() != end_mark) {
      pollfd readable{terminal, POLLIN, 0};
      if (::poll(&readable, 1, ended ? 1000 : 5) > 0) {
        char bytes[4096];
        const ssize_t count = ::read(terminal, bytes, sizeof bytes);
        if (count > 0) out.append(bytes, static_cast<std::size_t>(count));
        if (count < 0 && errno != EINTR) return out;
      } else if (ended) {
        return out;
      } else if (siginfo_t state{};
                 ::waitid(P_PID, static_cast<id_t>(child), &state, WEXITED | WNOHANG | WNOWAIT) == 0 &&
                 state.si_pid == child) {
        ended = true;
        if (::write(program_side, &end_mark, 1) != 1) return out;
      }
    }
    out.pop_back();
    return out;
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
