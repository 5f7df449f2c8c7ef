#pragma once

#include "rigor/io/files/file_error.hpp"
#include "rigor/view/3d/image.hpp"

#include <filesystem>
#include <string>

#include <sys/types.h>

namespace rigor {

/// Whether a program of that name is on the PATH.
bool has_program(const std::string& name);

/// A film encoded by the program ffmpeg from pictures that are handed over one by one (H.264 in an MP4 file,
/// which plays everywhere). All functions throw FileError.
class MovieFile {
 public:
  static constexpr int frames_per_second = 30;

  /// Starts ffmpeg without a shell. Width and height must be even, as the format requires.
  MovieFile(const std::filesystem::path& path, int width, int height);
  MovieFile(const MovieFile&) = delete;
  MovieFile& operator=(const MovieFile&) = delete;
  /// Ends ffmpeg silently; call close() to learn of errors.
  ~MovieFile();

  void add(const Image& image);
  void close();
  /// Ends ffmpeg at once and removes what it has written; nothing is to be added then.
  void give_up();

 private:
  int end();
  FileError ended_error(int code) const;

  std::filesystem::path path_;
  pid_t process_ = -1;
  int input_ = -1;
};

}  // namespace rigor
