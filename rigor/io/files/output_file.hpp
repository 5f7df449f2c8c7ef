#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <string_view>

namespace rigor {

/// Writers of long files flush when this many bytes are pending, and whenever their FlushTimer is due.
inline constexpr std::size_t kMostPendingBytes = std::size_t{1} << 20;

/// A text file that is written from its start. Flushed text survives the end of the process, however it ends.
class OutputFile {
 public:
  /// Creates or truncates the file. Throws FileError.
  explicit OutputFile(std::filesystem::path path);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  /// Closes silently; call close() to learn of errors.
  ~OutputFile();

  const std::filesystem::path& path() const { return path_; }
  /// Keeps the text for the next flush.
  void append(std::string_view text) { pending_ += text; }
  /// Bytes kept for the next flush.
  std::size_t pending() const { return pending_.size(); }
  /// Passes all text to the system. Throws FileError; text that could not be written is discarded.
  void flush();
  void close();

 private:
  std::filesystem::path path_;
  std::string pending_;
  int descriptor_ = -1;
};

/// Tells when to flush: at once the first time and then at intervals, so that flushing costs little and a
/// killed process loses only a moment.
class FlushTimer {
 public:
  bool is_due();

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::time_point::min();
};

/// Throws FileError unless a file of this name could be created or overwritten; it changes nothing but that
/// it removes what a killed process left behind.
void check_can_write(const std::filesystem::path& path);
/// Writes the bytes atomically: at any instant, a failure of power included, the file holds either its
/// previous contents or all of them. A process that is killed meanwhile leaves a temporary file beside it,
/// which the next one that writes this file removes. Throws FileError.
void write_atomically(const std::filesystem::path& path, std::string_view bytes);

}  // namespace rigor
