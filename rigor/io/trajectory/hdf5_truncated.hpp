#pragma once

#include "rigor/io/trajectory/hdf5_handle.hpp"

#include <cstdint>
#include <filesystem>

namespace rigor {

/// A truncated HDF5 file: an interrupted copy, or a disk that was full.
struct TruncatedFile {
  Hdf5Handle file;  ///< Open for reading, with zeros in place of the lost part; or not open.
  std::uint64_t present = 0, whole = 0;  ///< Bytes that are present and that the file had; 0 if not known.
};

/// Opens a file that is shorter than it declares. Some of what can be read from it may be zeros:
/// intact_rows() tells how much is data. It is not open if the file is not of that kind, or has lost its
/// first parts too.
TruncatedFile open_truncated_file(const std::filesystem::path& path);

/// Number of rows at the start of a dataset that lie in the first `present` bytes of its file: up to the
/// first chunk that does not.
std::uint64_t intact_rows(hid_t dataset, std::uint64_t present);

}  // namespace rigor
