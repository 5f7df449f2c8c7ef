#pragma once

#include "rigor/io/trajectory/hdf5_handle.hpp"

#include <cstdint>
#include <filesystem>

namespace rigor {

/// An HDF5 file that lost its end: a copy that was broken off, a disk that was full.
struct CutOffFile {
  Hdf5Handle file;  ///< Open for reading, with zeros in place of what is lost; or not open.
  std::uint64_t present = 0, whole = 0;  ///< Bytes that are there and that the file had; 0 if not known.
};

/// Opens a file that is shorter than it says itself. What can be read from it may be zeros: intact_rows()
/// tells how much is data. Not open if the file is not of that kind, or lost its first parts too.
CutOffFile open_cut_off_file(const std::filesystem::path& path);

/// Number of rows at the start of a dataset that are in the first `present` bytes of its file: up to the
/// first chunk that is not.
std::uint64_t intact_rows(hid_t dataset, std::uint64_t present);

}  // namespace rigor
