#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <string_view>

namespace rigor {

/// Writers of long files flush when this many bytes wait, and whenever their FlushTimer is due.
inline constexpr std::size_t kMostPendingBytes = std::size_t{1} << 20;

/// A text file that is written from its start. What was flushed survives the end of the process, however it
/// comes.
class OutputFile {
 public:
  /// Creates the file or empties it. Throws FileError.
  explicit OutputFile(std::filesystem::path path);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  /// Closes without a word; call close() to hear of errors.
  ~OutputFile();

  const std::filesystem::path& path() const { return path_; }
  /// Keeps the text for the next flush.
  void append(std::string_view text) { pending_ += text; }
  /// Bytes kept for the next flush.
  std::size_t pending() const { return pending_.size(); }
  /// Gives all text to the system. Throws FileError; what it could not write is forgotten.
  void flush();
  /// Also waits until the text is on the disk.
  void sync();
  void close();

 private:
  std::filesystem::path path_;
  std::string pending_;
  int descriptor_ = -1;
};

/// Tells when to flush: at once the first time, then when some time has passed, so that flushing costs little
/// and what a killed process loses is a moment.
class FlushTimer {
 public:
  bool is_due();

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::time_point::min();
};

/// Throws FileError unless a file of this name could be created or overwritten; changes nothing.
void check_can_write(const std::filesystem::path& path);
/// Writes the bytes so that the file holds either what it held before or all of them, at any instant. Throws
/// FileError.
void write_atomically(const std::filesystem::path& path, std::string_view bytes);

}  // namespace rigor
