#pragma once

#include "rigor/core/index.hpp"

#include <cstddef>
#include <vector>

namespace rigor {

/// Where the shapes of each body are in a list of the shapes of all bodies. A body that comes to have more
/// shapes than its section has room for gets a new section at the end; the old one stays unused.
class ShapeRanges {
 public:
  explicit ShapeRanges(std::size_t body_count)
      : begin_(body_count, 0), count_(body_count, 0), room_(count_) {}

  /// Gives the body a section of so many shapes. The caller's list must then have room for size() shapes.
  void give(int body, int count) {
    if (count > room_[at(body)]) {
      begin_[at(body)] = size_;
      room_[at(body)] = count;
      size_ += count;
    }
    count_[at(body)] = count;
  }
  int begin(int body) const { return begin_[at(body)]; }
  int count(int body) const { return count_[at(body)]; }
  int end(int body) const { return begin_[at(body)] + count_[at(body)]; }
  /// Number of places in all sections.
  std::size_t size() const { return at(size_); }

 private:
  std::vector<int> begin_, count_, room_;
  int size_ = 0;
};

}  // namespace rigor
