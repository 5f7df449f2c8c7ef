#pragma once

#include "rigor/study/workers/row_table.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace rigor {

/// The rows of a study as they come, in a file that survives the end of the process at any instant: each row
/// is appended by one call of the system, with its length and a checksum, so that a row that was cut off is
/// recognised and left out.
class Journal {
 public:
  /// Opens the file to append, and makes it if it is not there. identity: of the study; a file of another one
  /// is an InputError. What was cut off at its end is removed. Throws FileError.
  Journal(std::filesystem::path path, std::uint64_t identity, std::size_t columns);
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;
  ~Journal();

  const std::filesystem::path& path() const { return path_; }
  /// Appends a row. Throws FileError.
  void append(const RunRow& row);

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
};

/// Keeps the journal of a study to one process, as long as this object lives or the process does: two that
/// append would write over each other.
class JournalLock {
 public:
  /// Makes the file if it is not there, and waits so long [s] for a process that ends. Throws FileError if
  /// the file cannot be written, InputError if another process has it all the time.
  explicit JournalLock(const std::filesystem::path& path, double wait = 10);
  JournalLock(const JournalLock&) = delete;
  JournalLock& operator=(const JournalLock&) = delete;
  ~JournalLock();

 private:
  int descriptor_;
};

/// Enters the rows of a journal into the table; the number of them. A file that is not there has none. Throws
/// InputError if it belongs to another study, FileError if it cannot be read.
std::uint64_t read_journal(const std::filesystem::path& path, std::uint64_t identity, RowTable& table);

/// Bytes of a row in a journal, without its reason.
std::size_t journal_row_bytes(std::size_t columns);

// A row as bytes, and back; also for messages between processes.
std::string row_bytes(const RunRow& row);
RunRow row_of_bytes(std::string_view bytes);

/// FNV-1a.
std::uint64_t hash_of(std::string_view bytes, std::uint64_t start = 14695981039346656037u);

}  // namespace rigor
