#include "rigor/bulk/pair_order.hpp"

#include <cstddef>
#include <tuple>
#include <utility>

namespace rigor {

namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

bool is_before(const ShapePair& a, const ShapePair& b) {
  return std::tie(a.body_A, a.body_B, a.shape_A, a.shape_B) <
         std::tie(b.body_A, b.body_B, b.shape_A, b.shape_B);
}

}  // namespace

void PairOrder::clear(int body_count) {
  added_.clear();
  begin_A_.assign(at(body_count) + 1, 0);
  begin_B_.assign(at(body_count) + 1, 0);
}

void PairOrder::add(const std::vector<ShapePair>& pairs) {
  added_.insert(added_.end(), pairs.begin(), pairs.end());
  for (const ShapePair& pair : pairs) {
    ++begin_A_[at(pair.body_A) + 1];
    ++begin_B_[at(pair.body_B) + 1];
  }
}

/// By the second body, then, keeping that order, by the first: each pair goes straight to its place.
void PairOrder::write(std::vector<ShapePair>& pairs) {
  for (std::vector<int>* begin : {&begin_A_, &begin_B_}) {
    for (std::size_t i = 1; i < begin->size(); ++i) (*begin)[i] += (*begin)[i - 1];
  }
  by_second_.resize(added_.size());
  for (const ShapePair& pair : added_) by_second_[at(begin_B_[at(pair.body_B)]++)] = pair;
  pairs.resize(added_.size());
  for (const ShapePair& pair : by_second_) pairs[at(begin_A_[at(pair.body_A)]++)] = pair;
  // What is left are shapes of the same two bodies.
  for (std::size_t i = 1; i < pairs.size(); ++i) {
    for (std::size_t k = i; k > 0 && is_before(pairs[k], pairs[k - 1]); --k)
      std::swap(pairs[k], pairs[k - 1]);
  }
}

}  // namespace rigor
