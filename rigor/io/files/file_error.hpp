#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace rigor {

/// An error of the system, not of the input: a file cannot be created, a disk is full. The message names the
/// file.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// FileError "cannot write 'out.csv': No space left on device" for a system error number.
FileError write_error(const std::filesystem::path& path, int error_number);

}  // namespace rigor
