#include "rigor/view/3d/movie_file.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/quoted.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace rigor {

namespace {

std::vector<std::string> arguments(const std::filesystem::path& path, int width, int height) {
  const std::string rate = std::to_string(MovieFile::frames_per_second);
  // The prefix "file:" keeps ffmpeg from taking a name with a colon for an address.
  return {"ffmpeg", "-y", "-loglevel", "error", "-f", "rawvideo", "-pixel_format", "rgb24", "-video_size",
          fmt::format("{}x{}", width, height), "-framerate", rate, "-i", "-", "-an", "-c:v", "libx264",
          "-pix_fmt", "yuv420p",
          // The file states its colour space, because players guess it differently for large and small films.
          "-vf", "scale=out_color_matrix=bt709", "-colorspace", "bt709", "-color_primaries", "bt709",
          "-color_trc", "bt709", "-crf", "18", "-movflags", "+faststart", "-f", "mp4",
          "file:" + path.string()};
}

}  // namespace

bool has_program(const std::string& name) {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::filesystem::path file = std::filesystem::path(folder.empty() ? "." : folder) / name;
    if (std::filesystem::is_regular_file(file) && ::access(file.c_str(), X_OK) == 0) return true;
  }
  return false;
}

MovieFile::MovieFile(const std::filesystem::path& path, int width, int height) : path_(path) {
  // A socket replaces the pipe: writing to a program that has ended is then an error and not a signal.
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) throw write_error(path, errno);
  std::vector<std::string> words = arguments(path, width, height);
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
  ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  const int error = ::posix_spawnp(&process_, words[0].c_str(), &actions, nullptr, pointers.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  ::close(ends[0]);
  input_ = ends[1];
  if (error != 0) {
    process_ = -1;
    ::close(std::exchange(input_, -1));
    throw write_error(path, error);
  }
}

MovieFile::~MovieFile() {
  end();
}

void MovieFile::add(const Image& image) {
  for (std::size_t done = 0; done < image.rgb.size();) {
    const ssize_t sent = ::send(input_, image.rgb.data() + done, image.rgb.size() - done, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) throw ended_error(end());
    done += at(sent);
  }
}

void MovieFile::close() {
  const int code = end();
  if (code != 0) throw ended_error(code);
}

void MovieFile::give_up() {
  if (process_ >= 0) ::kill(process_, SIGKILL);
  end();
  std::error_code ignored;
  if (std::filesystem::is_regular_file(path_, ignored)) std::filesystem::remove(path_, ignored);
}

FileError MovieFile::ended_error(int code) const {
  return FileError(fmt::format("cannot write {}: ffmpeg ended too early, with code {}",
                               quoted_text(path_.string()), code));
}

/// Waits for ffmpeg and returns its exit code, or 0 if that has happened before.
int MovieFile::end() {
  if (input_ >= 0) ::close(std::exchange(input_, -1));
  if (process_ < 0) return 0;
  int status = 0;
  while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) continue;
  process_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace rigor
