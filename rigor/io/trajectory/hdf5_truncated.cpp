#include "rigor/io/trajectory/hdf5_truncated.hpp"

#include "rigor/core/index.hpp"

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

namespace rigor {

namespace {

/// Larger files are not completed in memory, nor those of which hardly anything is left: a few bytes that
/// claim to be many must not take the memory of many.
constexpr std::uint64_t most_bytes = std::uint64_t{1} << 30;
constexpr std::uint64_t most_growth = 64, always_completed = std::uint64_t{1} << 20;

/// End-of-file address of a superblock of version 2 or 3 with 8-byte addresses (the only ones that Hdf5Writer
/// makes), 0 if the bytes do not begin with one.
///
/// Source: HDF5 File Format Specification Version 3.0, II.A: signature (8 bytes), version, size of offsets,
/// size of lengths, flags, base address (8), superblock extension (8), end of file (8), ... little-endian.
std::uint64_t end_of_file_address(const std::string& bytes) {
  constexpr std::size_t superblock_bytes = 48, version_offset = 8, size_offset = 9, end_offset = 28;
  if (bytes.size() < superblock_bytes || bytes.compare(0, 8, "\211HDF\r\n\032\n") != 0) return 0;
  if ((bytes[version_offset] != 2 && bytes[version_offset] != 3) || bytes[size_offset] != 8) return 0;
  std::uint64_t address = 0;
  for (std::size_t i = 8; i-- > 0;)
    address = address << 8 | static_cast<unsigned char>(bytes[end_offset + i]);
  return address;
}

std::string bytes_of(const std::filesystem::path& path) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error || size > most_bytes) return {};
  std::string bytes(size, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(bytes.data(), static_cast<std::streamsize>(size));
  bytes.resize(at(std::max<std::streamsize>(0, file.gcount())));
  return bytes;
}

Hdf5Handle open_in_memory(std::string& bytes) {
  constexpr std::size_t growth = 1 << 16;
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_fapl_core(access, growth, false);
  H5Pset_file_image(access, bytes.data(), bytes.size());
  return {H5Fopen("cut-off file", H5F_ACC_RDONLY, access), H5Fclose};
}

/// Number of rows, of the chunk that begins with this row, that lie in the present bytes. Chunks are not
/// compressed, so each row is a contiguous part of the bytes.
hsize_t present_rows(hid_t dataset, hsize_t row, const std::vector<hsize_t>& chunk, std::uint64_t present) {
  // Ask for the address of the chunk in the file.
  std::vector<hsize_t> place(chunk.size(), 0);
  place[0] = row;
  unsigned filters = 0;
  haddr_t address = HADDR_UNDEF;
  hsize_t size = 0;
  if (H5Dget_chunk_info_by_coord(dataset, place.data(), &filters, &address, &size) < 0) return 0;
  // Count the whole rows before the end of the present bytes.
  if (address == HADDR_UNDEF || address >= present || size < chunk[0]) return 0;
  return std::min<hsize_t>(chunk[0], (present - address) / (size / chunk[0]));
}

}  // namespace

TruncatedFile open_truncated_file(const std::filesystem::path& path) {
  TruncatedFile cut_off;
  // The superblock tells how long the file was when it was whole.
  std::string bytes = bytes_of(path);
  cut_off.whole = end_of_file_address(bytes);
  cut_off.present = bytes.size();
  if (cut_off.whole <= cut_off.present || cut_off.whole > most_bytes) return cut_off;
  if (cut_off.whole > std::max(always_completed, most_growth * cut_off.present)) return cut_off;
  // Fill the lost part with zeros, so that HDF5 opens the file.
  bytes.resize(cut_off.whole, '\0');
  cut_off.file = open_in_memory(bytes);
  return cut_off;
}

std::uint64_t intact_rows(hid_t dataset, std::uint64_t present) {
  // Shape of the dataset and of its chunks.
  const Hdf5Handle space(H5Dget_space(dataset), H5Sclose);
  const int rank = H5Sget_simple_extent_ndims(space);
  const Hdf5Handle creation(H5Dget_create_plist(dataset), H5Pclose);
  if (rank < 1 || H5Pget_layout(creation) != H5D_CHUNKED) return 0;
  const std::size_t dimensions = at(rank);
  std::vector<hsize_t> shape(dimensions, 0), chunk(dimensions, 0);
  if (H5Sget_simple_extent_dims(space, shape.data(), nullptr) < 0) return 0;
  if (H5Pget_chunk(creation, rank, chunk.data()) < 0 || chunk[0] == 0) return 0;
  // Chunks hold consecutive rows: the intact ones end with the first chunk that is not complete.
  hsize_t rows = 0;
  for (hsize_t found = chunk[0]; rows < shape[0] && found == chunk[0]; rows += found)
    found = present_rows(dataset, rows, chunk, present);
  return std::min<hsize_t>(rows, shape[0]);
}

}  // namespace rigor
