#include "rigor/io/files/output_file.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/io/files/file_error.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace rigor {

namespace {

/// A name in the same folder, hence on the same file system, that no other process uses.
std::filesystem::path temporary_path(const std::filesystem::path& path) {
  std::filesystem::path temporary = path;
  temporary += fmt::format(".{}.tmp", ::getpid());
  return temporary;
}

}  // namespace

FileError write_error(const std::filesystem::path& path, int error_number) {
  return FileError(fmt::format("cannot write {}: {}", quoted_text(path.string()),
                               std::generic_category().message(error_number)));
}

OutputFile::OutputFile(std::filesystem::path path) : path_(std::move(path)) {
  descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor_ < 0) throw write_error(path_, errno);
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void OutputFile::flush() {
  const std::string text = std::exchange(pending_, {});
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t written = ::write(descriptor_, text.data() + done, text.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw write_error(path_, errno);
    done += at(written);
  }
}

void OutputFile::sync() {
  flush();
  // EINVAL: this kind of file cannot be synchronised.
  if (::fsync(descriptor_) != 0 && errno != EINVAL) throw write_error(path_, errno);
}

void OutputFile::close() {
  if (descriptor_ < 0) return;
  flush();
  if (::close(std::exchange(descriptor_, -1)) != 0) throw write_error(path_, errno);
}

bool FlushTimer::is_due() {
  constexpr std::chrono::milliseconds pause(20);
  const std::chrono::steady_clock::time_point now = std::chrono::steady_clock::now();
  if (last_ != std::chrono::steady_clock::time_point::min() && now - last_ < pause) return false;
  last_ = now;
  return true;
}

void check_can_write(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) throw write_error(path, EISDIR);
  const std::filesystem::path temporary = temporary_path(path);
  const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor < 0) throw write_error(path, errno);
  ::close(descriptor);
  ::unlink(temporary.c_str());
}

void write_atomically(const std::filesystem::path& path, std::string_view bytes) {
  const std::filesystem::path temporary = temporary_path(path);
  try {
    OutputFile file(temporary);
    file.append(bytes);
    file.sync();
    file.close();
    if (::rename(temporary.c_str(), path.c_str()) != 0) throw write_error(path, errno);
  } catch (const FileError&) {
    ::unlink(temporary.c_str());
    throw;
  }
}

}  // namespace rigor
