#include "rigor/io/trajectory/hdf5_series.hpp"

#include <algorithm>

namespace rigor {

namespace {

/// Target size of a chunk: large compared with its entry in the index, small compared with memory.
constexpr hsize_t chunk_bytes = hsize_t{1} << 15;

std::vector<hsize_t> with_rows(hsize_t rows, const std::vector<hsize_t>& row_shape) {
  std::vector<hsize_t> shape = {rows};
  shape.insert(shape.end(), row_shape.begin(), row_shape.end());
  return shape;
}

}  // namespace

template <typename Value>
Hdf5Series<Value>::Hdf5Series(hid_t parent, const std::string& name, std::vector<hsize_t> row_shape,
                              hid_t file_type, hsize_t expected_rows)
    : row_shape_(std::move(row_shape)) {
  for (const hsize_t length : row_shape_) row_size_ *= length;
  const int rank = static_cast<int>(row_shape_.size()) + 1;
  const std::vector<hsize_t> none = with_rows(0, row_shape_), most = with_rows(H5S_UNLIMITED, row_shape_);
  const Hdf5Handle space(H5Screate_simple(rank, none.data(), most.data()), H5Sclose);
  const Hdf5Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  const hsize_t row_bytes = std::max<hsize_t>(1, row_size_ * sizeof(Value));
  const hsize_t most_rows = std::clamp<hsize_t>(expected_rows, 1, most_chunk_rows);
  const std::vector<hsize_t> chunk =
      with_rows(std::clamp<hsize_t>(chunk_bytes / row_bytes, 1, most_rows), row_shape_);
  H5Pset_chunk(creation, rank, chunk.data());
  dataset_ = Hdf5Handle(
      H5Dcreate2(parent, name.c_str(), file_type, space, H5P_DEFAULT, creation, H5P_DEFAULT), H5Dclose);
  memory_type_ = Hdf5Handle(H5Tget_native_type(file_type, H5T_DIR_ASCEND), H5Tclose);
}

template <typename Value>
bool Hdf5Series<Value>::write_pending() {
  const hsize_t count = pending_.size() / row_size_;
  if (count == 0) return true;
  const std::vector<hsize_t> shape = with_rows(rows_ + count, row_shape_);
  if (H5Dset_extent(dataset_, shape.data()) < 0) return false;
  const Hdf5Handle target(H5Dget_space(dataset_), H5Sclose);
  const std::vector<hsize_t> block = with_rows(count, row_shape_);
  std::vector<hsize_t> start(shape.size(), 0);
  start[0] = rows_;
  const Hdf5Handle source(H5Screate_simple(static_cast<int>(block.size()), block.data(), nullptr), H5Sclose);
  if (H5Sselect_hyperslab(target, H5S_SELECT_SET, start.data(), nullptr, block.data(), nullptr) < 0)
    return false;
  if (H5Dwrite(dataset_, memory_type_, source, target, H5P_DEFAULT, pending_.data()) < 0) return false;
  rows_ += count;
  pending_.erase(pending_.begin(), pending_.begin() + static_cast<std::ptrdiff_t>(count * row_size_));
  return true;
}

template class Hdf5Series<double>;
template class Hdf5Series<int>;
template class Hdf5Series<signed char>;

}  // namespace rigor
