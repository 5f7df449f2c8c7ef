#pragma once

#include "rigor/io/trajectory/hdf5_handle.hpp"

#include <string>
#include <vector>

namespace rigor {

/// A dataset that grows by rows, with the rows that wait for the next flush. Value is double, int or signed
/// char.
template <typename Value>
class Hdf5Series {
 public:
  /// row_shape: extents of a row (empty for one value per row); file_type: how values are stored;
  /// expected_rows: chunks have at most this many rows. The dataset is not open if HDF5 fails.
  Hdf5Series(hid_t parent, const std::string& name, std::vector<hsize_t> row_shape, hid_t file_type,
             hsize_t expected_rows = most_chunk_rows);

  static constexpr hsize_t most_chunk_rows = 256;

  bool is_open() const { return dataset_.is_open(); }
  hid_t id() const { return dataset_; }
  void append(const Value* values, std::size_t count) {
    pending_.insert(pending_.end(), values, values + count);
  }
  void append(Value value) { pending_.push_back(value); }
  std::size_t pending_bytes() const { return pending_.size() * sizeof(Value); }
  /// Passes all complete rows to HDF5; false if it fails.
  bool write_pending();

 private:
  std::vector<hsize_t> row_shape_;
  hsize_t row_size_ = 1;
  hsize_t rows_ = 0;
  std::vector<Value> pending_;
  Hdf5Handle dataset_;
  Hdf5Handle memory_type_;  ///< HDF5 type of Value.
};

}  // namespace rigor
