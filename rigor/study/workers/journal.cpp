#include "rigor/study/workers/journal.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/io/files/file_error.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <memory>
#include <thread>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace rigor {

namespace {

constexpr std::string_view magic = "rigor study 1\n";
constexpr std::uint32_t longest_row = 1u << 24;
constexpr std::size_t longest_reason = 400;

template <typename Number>
void put(Number number, std::string& bytes) {
  std::array<char, sizeof(Number)> raw;
  std::memcpy(raw.data(), &number, sizeof(Number));
  bytes.append(raw.data(), raw.size());
}

/// Takes a number from the front of the bytes.
template <typename Number>
Number take(std::string_view& bytes) {
  RIGOR_ASSERT(bytes.size() >= sizeof(Number));
  Number number;
  std::memcpy(&number, bytes.data(), sizeof(Number));
  bytes.remove_prefix(sizeof(Number));
  return number;
}

std::string header_bytes(std::uint64_t identity, std::size_t columns) {
  std::string bytes(magic);
  put(identity, bytes);
  put(static_cast<std::uint64_t>(columns), bytes);
  return bytes;
}

/// A row as it stands in the file: length, bytes, checksum.
std::string framed(const std::string& row) {
  std::string bytes;
  put(static_cast<std::uint32_t>(row.size()), bytes);
  bytes += row;
  put(hash_of(row), bytes);
  return bytes;
}

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

bool read_exactly(std::FILE* file, std::size_t count, std::string& bytes) {
  bytes.resize(count);
  return std::fread(bytes.data(), 1, count, file) == count;
}

/// Calls `enter` with each whole row; returns where the last one ends, or 0 if even the header is not whole.
template <typename Enter>
long scan_rows(std::FILE* file, const std::filesystem::path& path, const std::string& header,
               const Enter& enter) {
  std::string bytes;
  if (!read_exactly(file, header.size(), bytes)) {
    const std::size_t n = std::min({bytes.size(), magic.size(), std::strlen(bytes.c_str())});
    if (bytes.compare(0, n, magic.substr(0, n)) != 0)
      throw InputError(path.string() + ": is not the journal of a study");
    return 0;
  }
  if (!std::string_view(bytes).starts_with(magic))
    throw InputError(path.string() + ": is not the journal of a study");
  if (bytes != header)
    throw InputError(path.string() +
                     ": is the journal of another study, or of this one before it was changed; remove it, or "
                     "give another with --journal");
  long end = static_cast<long>(header.size());
  while (true) {
    if (!read_exactly(file, sizeof(std::uint32_t), bytes)) return end;
    std::string_view view = bytes;
    const std::uint32_t length = take<std::uint32_t>(view);
    if (length > longest_row || !read_exactly(file, length + sizeof(std::uint64_t), bytes)) return end;
    view = std::string_view(bytes).substr(0, length);
    std::string_view check = std::string_view(bytes).substr(length);
    if (hash_of(view) != take<std::uint64_t>(check)) return end;
    enter(row_of_bytes(view));
    end += static_cast<long>(sizeof(std::uint32_t) + length + sizeof(std::uint64_t));
  }
}

}  // namespace

std::uint64_t hash_of(std::string_view bytes, std::uint64_t start) {
  std::uint64_t hash = start;
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
  return hash;
}

std::string row_bytes(const RunRow& row) {
  std::string bytes;
  put(row.run, bytes);
  put(static_cast<std::uint32_t>(row.status), bytes);
  put(row.cpu_time, bytes);
  put(static_cast<std::uint32_t>(row.outcomes.size()), bytes);
  for (const double value : row.outcomes) put(value, bytes);
  bytes += row.reason.substr(0, longest_reason);
  return bytes;
}

RunRow row_of_bytes(std::string_view bytes) {
  RunRow row;
  row.run = take<std::uint64_t>(bytes);
  row.status = static_cast<RunStatus>(take<std::uint32_t>(bytes));
  row.cpu_time = take<double>(bytes);
  row.outcomes.resize(take<std::uint32_t>(bytes));
  for (double& value : row.outcomes) value = take<double>(bytes);
  row.reason = bytes;
  return row;
}

std::size_t journal_row_bytes(std::size_t columns) {
  return framed(row_bytes({0, RunStatus::done, 0, std::vector<double>(columns), {}})).size();
}

Journal::Journal(std::filesystem::path path, std::uint64_t identity, std::size_t columns)
    : path_(std::move(path)) {
  const std::string header = header_bytes(identity, columns);
  long end = 0;
  if (const File file{std::fopen(path_.c_str(), "rb")})
    end = scan_rows(file.get(), path_, header, [](const RunRow&) {});
  descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor_ < 0) throw write_error(path_, errno);
  if (::ftruncate(descriptor_, end) != 0 || ::lseek(descriptor_, 0, SEEK_END) < 0)
    throw write_error(path_, errno);
  if (end == 0 && ::write(descriptor_, header.data(), header.size()) != static_cast<ssize_t>(header.size()))
    throw write_error(path_, errno);
}

Journal::~Journal() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void Journal::append(const RunRow& row) {
  const std::string bytes = framed(row_bytes(row));
  const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
  if (written != static_cast<ssize_t>(bytes.size())) throw write_error(path_, written < 0 ? errno : ENOSPC);
}

JournalLock::JournalLock(const std::filesystem::path& path, double wait)
    : descriptor_(::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666)) {
  if (descriptor_ < 0) throw write_error(path, errno);
  constexpr double pause = 0.05;
  const auto give_up = [this] { ::close(descriptor_); };
  for (double waited = 0;; waited += pause) {
    try {
      poll_interrupt();
    } catch (const Interrupted&) {
      give_up();
      throw;
    }
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
    // Some file systems of networks have no locks.
    if (errno != EWOULDBLOCK) return;
    if (waited >= wait) break;
    std::this_thread::sleep_for(std::chrono::duration<double>(pause));
  }
  give_up();
  throw InputError(
      path.string() +
      ": is the journal of a study that another process carries out; give another with --journal");
}

JournalLock::~JournalLock() {
  ::close(descriptor_);
}

std::uint64_t read_journal(const std::filesystem::path& path, std::uint64_t identity, RowTable& table) {
  const File file{std::fopen(path.c_str(), "rb")};
  std::uint64_t count = 0;
  if (!file) return count;
  scan_rows(file.get(), path, header_bytes(identity, table.columns()), [&](const RunRow& row) {
    if (row.outcomes.size() == table.columns() && table.enter(row)) ++count;
  });
  return count;
}

}  // namespace rigor
