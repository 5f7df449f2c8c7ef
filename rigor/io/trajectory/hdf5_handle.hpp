#pragma once

#include <hdf5.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace rigor {

/// An HDF5 identifier that is closed on destruction. Negative: none.
class Hdf5Handle {
 public:
  using Close = herr_t (*)(hid_t);

  Hdf5Handle() = default;
  Hdf5Handle(hid_t id, Close close) : id_(id), close_(close) {}
  Hdf5Handle(Hdf5Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Hdf5Handle& operator=(Hdf5Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Hdf5Handle() { reset(); }

  operator hid_t() const { return id_; }
  bool is_open() const { return id_ >= 0; }
  /// Closes now; false if HDF5 fails.
  bool reset() {
    const hid_t id = std::exchange(id_, -1);
    return id < 0 || close_(id) >= 0;
  }

 private:
  hid_t id_ = -1;
  Close close_ = nullptr;
};

/// Type of a text of so many bytes, UTF-8, padded with NUL; at least one byte.
inline Hdf5Handle hdf5_text_type(std::size_t length) {
  Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type, std::max<std::size_t>(1, length));
  H5Tset_cset(type, H5T_CSET_UTF8);
  H5Tset_strpad(type, H5T_STR_NULLPAD);
  return type;
}

/// HDF5 prints its errors to stderr; while an object of this class exists, it does not.
class Hdf5Quiet {
 public:
  Hdf5Quiet() {
    H5Eget_auto2(H5E_DEFAULT, &print_, &client_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  Hdf5Quiet(const Hdf5Quiet&) = delete;
  Hdf5Quiet& operator=(const Hdf5Quiet&) = delete;
  /// Keeps HDF5 silent even after destruction: it cannot release a file with damaged parts, and would report
  /// that at the end of the process.
  void stay() { print_ = nullptr, client_ = nullptr; }
  ~Hdf5Quiet() { H5Eset_auto2(H5E_DEFAULT, print_, client_); }

 private:
  H5E_auto2_t print_ = nullptr;
  void* client_ = nullptr;
};

/// Writes a list of texts as a data set of strings of equal length, padded with NUL; false if it did not
/// work.
inline bool write_hdf5_texts(hid_t parent, const char* name, const std::vector<std::string>& texts) {
  std::size_t longest = 1;
  for (const std::string& text : texts) longest = std::max(longest, text.size());
  std::string bytes;
  for (const std::string& text : texts) bytes.append(text).append(longest - text.size(), '\0');
  const Hdf5Handle type = hdf5_text_type(longest);
  const hsize_t count = texts.size();
  const Hdf5Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose);
  const Hdf5Handle data(H5Dcreate2(parent, name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                        H5Dclose);
  return data.is_open() &&
         (count == 0 || H5Dwrite(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()) >= 0);
}

}  // namespace rigor
