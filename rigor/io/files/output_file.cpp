#include "rigor/io/files/output_file.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/io/files/file_error.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace rigor {

namespace {

void write_all(int descriptor, std::string_view text, const std::filesystem::path& path) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t written = ::write(descriptor, text.data() + done, text.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw write_error(path, errno);
    done += at(written);
  }
}

void sync(int descriptor, const std::filesystem::path& path) {
  // EINVAL: this kind of file cannot be synchronised.
  if (::fsync(descriptor) != 0 && errno != EINVAL) throw write_error(path, errno);
}

std::filesystem::path folder_of(const std::filesystem::path& path) {
  const std::filesystem::path folder = path.parent_path();
  return folder.empty() ? "." : folder;
}

/// Whether a file of this name is a temporary one of `path`: "run.cp.123-0.tmp".
bool is_temporary_name(const std::string& name, const std::filesystem::path& path) {
  const std::string start = path.filename().string() + ".", end = ".tmp";
  if (name.size() <= start.size() + end.size() || !name.starts_with(start) || !name.ends_with(end))
    return false;
  return name.find_first_not_of("0123456789-", start.size()) == name.size() - end.size();
}

/// Removes the temporary files that processes left behind which were killed. A process locks its own as long
/// as it lives, so what can be locked belongs to nobody.
void remove_stale_temporaries(const std::filesystem::path& path) {
  std::error_code ignored;
  for (const std::filesystem::directory_entry& entry :
       std::filesystem::directory_iterator(folder_of(path), ignored)) {
    if (!is_temporary_name(entry.path().filename().string(), path)) continue;
    // Neither a link is followed nor a pipe waited for.
    const int descriptor = ::open(entry.path().c_str(), O_WRONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0) continue;
    struct stat file {};
    const bool is_stale = ::fstat(descriptor, &file) == 0 && S_ISREG(file.st_mode) &&
                          file.st_uid == ::geteuid() && ::flock(descriptor, LOCK_EX | LOCK_NB) == 0;
    if (is_stale) ::unlink(entry.path().c_str());
    ::close(descriptor);
  }
}

/// A file beside `path`, hence on the same file system, that is this process's alone: its name is new, and it
/// is locked. It is removed unless it has been moved to its place.
class TemporaryFile {
 public:
  /// Throws FileError, in the name of `path`.
  explicit TemporaryFile(const std::filesystem::path& path) : path_(path) {
    constexpr int most_tries = 100;
    for (int k = 0; descriptor_ < 0 && k < most_tries; ++k) {
      name_ = path;
      name_ += fmt::format(".{}-{}.tmp", ::getpid(), k);
      descriptor_ = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (descriptor_ < 0 && errno != EEXIST) throw write_error(path, errno);
      // Another process may have taken it for a stale one before it was locked.
      if (descriptor_ >= 0 && !lock()) ::close(std::exchange(descriptor_, -1));
    }
    if (descriptor_ < 0) throw write_error(path, EEXIST);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (!is_in_place_) ::unlink(name_.c_str());
    ::close(descriptor_);
  }

  void write(std::string_view bytes) const {
    write_all(descriptor_, bytes, path_);
    sync(descriptor_, path_);
  }
  void move_to_its_place() {
    if (::rename(name_.c_str(), path_.c_str()) != 0) throw write_error(path_, errno);
    is_in_place_ = true;
    // The new name is on the disk when its folder is.
    const int folder = ::open(folder_of(path_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder < 0) return;
    ::fsync(folder);
    ::close(folder);
  }

 private:
  bool lock() const {
    struct stat file {};
    // A file system without locks has no stale files removed either.
    const bool is_locked = ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
    return is_locked && ::fstat(descriptor_, &file) == 0 && file.st_nlink > 0;
  }

  const std::filesystem::path& path_;
  std::filesystem::path name_;
  int descriptor_ = -1;
  bool is_in_place_ = false;
};

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
  write_all(descriptor_, text, path_);
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
  remove_stale_temporaries(path);
  const TemporaryFile temporary(path);
}

void write_atomically(const std::filesystem::path& path, std::string_view bytes) {
  remove_stale_temporaries(path);
  TemporaryFile temporary(path);
  temporary.write(bytes);
  temporary.move_to_its_place();
}

}  // namespace rigor
