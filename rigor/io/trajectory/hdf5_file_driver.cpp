#include "rigor/io/trajectory/hdf5_file_driver.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <limits>

#include <fcntl.h>
#include <unistd.h>

namespace rigor {

namespace {

// Superblock of version 3, all numbers little-endian (HDF5 File Format Specification 3.0, II.A).
constexpr std::size_t superblock_size = 48;
constexpr std::size_t version_at = 8, marks_at = 11, end_at = 28, checksum_at = 44;
using Superblock = std::array<unsigned char, superblock_size>;

constexpr haddr_t smallest_reserve = haddr_t{1} << 16;

/// The file as the driver sees it. HDF5 allocates none of it; base must come first, as HDF5 requires.
struct DriverFile {
  H5FD_t base{};
  int descriptor = -1;
  haddr_t end_of_allocation = 0;
  haddr_t reserved = 0;  ///< Size of the file on the disk.
  Hdf5FileStatus* status = nullptr;
  Superblock superblock{};  ///< As HDF5 wrote it last.
  bool has_superblock = false;
};

DriverFile* driver_file(H5FD_t* file) {
  return reinterpret_cast<DriverFile*>(file);
}
const DriverFile* driver_file(const H5FD_t* file) {
  return reinterpret_cast<const DriverFile*>(file);
}

/// Jenkins' hash, with which HDF5 protects its structures, for a number of bytes that is 8 more than a
/// multiple of 12.
///
/// Source: Jenkins, lookup3 (hashlittle with initial value 0), 2006.
std::uint32_t lookup3(const unsigned char* bytes, std::uint32_t length) {
  const auto word = [&](std::uint32_t at) {
    return static_cast<std::uint32_t>(bytes[at]) | static_cast<std::uint32_t>(bytes[at + 1]) << 8 |
           static_cast<std::uint32_t>(bytes[at + 2]) << 16 | static_cast<std::uint32_t>(bytes[at + 3]) << 24;
  };
  std::uint32_t a = 0xdeadbeefu + length, b = a, c = a;
  std::uint32_t at = 0;
  for (; length - at > 12; at += 12) {
    a += word(at), b += word(at + 4), c += word(at + 8);
    a -= c, a ^= std::rotl(c, 4), c += b;
    b -= a, b ^= std::rotl(a, 6), a += c;
    c -= b, c ^= std::rotl(b, 8), b += a;
    a -= c, a ^= std::rotl(c, 16), c += b;
    b -= a, b ^= std::rotl(a, 19), a += c;
    c -= b, c ^= std::rotl(b, 4), b += a;
  }
  a += word(at), b += word(at + 4);
  c ^= b, c -= std::rotl(b, 14);
  a ^= c, a -= std::rotl(c, 11);
  b ^= a, b -= std::rotl(a, 25);
  c ^= b, c -= std::rotl(b, 16);
  a ^= c, a -= std::rotl(c, 4);
  b ^= a, b -= std::rotl(a, 14);
  c ^= b, c -= std::rotl(b, 24);
  return c;
}

void put_number(std::uint64_t value, std::size_t length, unsigned char* at) {
  for (std::size_t i = 0; i < length; ++i) at[i] = static_cast<unsigned char>(value >> (8 * i));
}

/// Writes all bytes unless a write has failed before.
void write_bytes(DriverFile& file, haddr_t address, const void* bytes, std::size_t size) {
  const char* const from = static_cast<const char*>(bytes);
  for (std::size_t done = 0; done < size && file.status->error == 0;) {
    const ssize_t written =
        ::pwrite(file.descriptor, from + done, size - done, static_cast<off_t>(address + done));
    if (written < 0 && errno != EINTR) file.status->error = errno;
    if (written > 0) done += static_cast<std::size_t>(written);
  }
}

/// Writes the superblock. While HDF5 marks the file as open, it is written without this mark and with all
/// reserved space as part of the file.
void write_superblock(DriverFile& file) {
  Superblock bytes = file.superblock;
  if (bytes[version_at] == 3 && bytes[marks_at] != 0) {
    bytes[marks_at] = 0;
    put_number(file.reserved, 8, &bytes[end_at]);
    put_number(lookup3(bytes.data(), checksum_at), 4, &bytes[checksum_at]);
  }
  write_bytes(file, 0, bytes.data(), bytes.size());
}

/// Grows the file on the disk at least to this size, and records the size in its superblock, before anything
/// is written there.
void reserve(DriverFile& file, haddr_t end) {
  if (end <= file.reserved || file.status->error != 0) return;
  file.reserved = std::max(smallest_reserve, end + end / 4);
  if (::ftruncate(file.descriptor, static_cast<off_t>(file.reserved)) != 0) {
    file.status->error = errno;
  } else if (file.has_superblock) {
    write_superblock(file);
  }
}

// The functions of the driver, as declared by H5FDpublic.h.

H5FD_t* open_file(const char* name, unsigned, hid_t access_list, haddr_t) {
  Hdf5FileStatus* const* const status = static_cast<Hdf5FileStatus* const*>(H5Pget_driver_info(access_list));
  if (!status) return nullptr;
  const int descriptor = ::open(name, O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0) {
    (*status)->error = errno;
    return nullptr;
  }
  DriverFile* const file = new DriverFile;
  file->descriptor = descriptor;
  file->status = *status;
  return &file->base;
}

herr_t close_file(H5FD_t* base) {
  DriverFile* const file = driver_file(base);
  if (::close(file->descriptor) != 0 && file->status->error == 0) file->status->error = errno;
  delete file;
  return 0;
}

int compare(const H5FD_t* a, const H5FD_t* b) {
  const int first = driver_file(a)->descriptor, second = driver_file(b)->descriptor;
  return first < second ? -1 : first > second;
}

herr_t query(const H5FD_t*, unsigned long* flags) {
  // No flag may let HDF5 cache metadata in the driver: the order of its writes must reach the disk unchanged.
  *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_AGGREGATE_SMALLDATA | H5FD_FEAT_SUPPORTS_SWMR_IO |
           H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
  return 0;
}

haddr_t end_of_allocation(const H5FD_t* file, H5FD_mem_t) {
  return driver_file(file)->end_of_allocation;
}

herr_t set_end_of_allocation(H5FD_t* file, H5FD_mem_t, haddr_t end) {
  driver_file(file)->end_of_allocation = end;
  reserve(*driver_file(file), end);
  return 0;
}

haddr_t end_of_file(const H5FD_t* file, H5FD_mem_t) {
  return driver_file(file)->reserved;
}

herr_t read(H5FD_t* base, H5FD_mem_t, hid_t, haddr_t address, std::size_t size, void* bytes) {
  DriverFile* const file = driver_file(base);
  char* const to = static_cast<char*>(bytes);
  std::size_t done = 0;
  while (done < size) {
    const ssize_t count =
        ::pread(file->descriptor, to + done, size - done, static_cast<off_t>(address + done));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    done += static_cast<std::size_t>(count);
  }
  // Bytes beyond the end of the file read as zeros.
  std::memset(to + done, 0, size - done);
  return 0;
}

herr_t write(H5FD_t* base, H5FD_mem_t, hid_t, haddr_t address, std::size_t size, const void* bytes) {
  DriverFile* const file = driver_file(base);
  if (address == 0 && size == superblock_size) {
    std::memcpy(file->superblock.data(), bytes, size);
    file->has_superblock = true;
    write_superblock(*file);
  } else {
    write_bytes(*file, address, bytes, size);
  }
  return 0;
}

herr_t truncate(H5FD_t* base, hid_t, hbool_t is_closing) {
  DriverFile* const file = driver_file(base);
  if (!is_closing || file->status->error != 0) return 0;
  if (::ftruncate(file->descriptor, static_cast<off_t>(file->end_of_allocation)) != 0)
    file->status->error = errno;
  return 0;
}

H5FD_class_t driver_class() {
  H5FD_class_t driver{};
  driver.name = "rigor";
  driver.maxaddr = static_cast<haddr_t>(std::numeric_limits<off_t>::max());
  driver.fc_degree = H5F_CLOSE_STRONG;
  // NOLINTNEXTLINE(bugprone-sizeof-expression): the library copies the pointer.
  driver.fapl_size = sizeof(Hdf5FileStatus*);
  driver.open = open_file;
  driver.close = close_file;
  driver.cmp = compare;
  driver.query = query;
  driver.get_eoa = end_of_allocation;
  driver.set_eoa = set_end_of_allocation;
  driver.get_eof = end_of_file;
  driver.read = read;
  driver.write = write;
  driver.truncate = truncate;
  std::fill(std::begin(driver.fl_map), std::end(driver.fl_map), H5FD_MEM_SUPER);
  return driver;
}

}  // namespace

Hdf5FileDriver::Hdf5FileDriver(Hdf5FileStatus& status) : status_(&status) {
  const H5FD_class_t driver = driver_class();
  id_ = H5FDregister(&driver);
}

Hdf5FileDriver::~Hdf5FileDriver() {
  if (id_ >= 0) H5FDunregister(id_);
}

bool Hdf5FileDriver::set_in(hid_t access_list) const {
  return id_ >= 0 && H5Pset_driver(access_list, id_, &status_) >= 0;
}

}  // namespace rigor
