#pragma once

#include <hdf5.h>

namespace rigor {

/// Outcome of a file that is written through the driver; it must outlive the file.
struct Hdf5FileStatus {
  int error = 0;  ///< System error number of the first write that failed, or 0. All later writes are skipped.
};

/// HDF5 file driver for a file that can be opened at any instant, whatever happens to the writing process.
///
/// HDF5 itself, in single-writer mode (H5Fstart_swmr_write), orders its writes so that the structures on the
/// disk always agree. Two things would still keep a plain reader out of the file of a killed process: the
/// mark "open for writing" in its superblock, and an end-of-file address there that lags behind the
/// structures. So this driver never lets the mark reach the disk, and reserves space in large steps (a sparse
/// tail), with the reserved size as the address. When the file is closed, both are what HDF5 writes, and the
/// tail is cut off: the file is an ordinary one.
///
/// A failed write (disk full) is remembered in the status, and the file on the disk stays as it was before
/// it; HDF5 is not told, because it cannot close a file that it cannot write to.
class Hdf5FileDriver {
 public:
  explicit Hdf5FileDriver(Hdf5FileStatus& status);
  Hdf5FileDriver(const Hdf5FileDriver&) = delete;
  Hdf5FileDriver& operator=(const Hdf5FileDriver&) = delete;
  ~Hdf5FileDriver();

  /// Makes a file access list use the driver; false if HDF5 fails.
  bool set_in(hid_t access_list) const;

 private:
  hid_t id_;
  Hdf5FileStatus* status_;
};

}  // namespace rigor
