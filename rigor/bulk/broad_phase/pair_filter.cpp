#include "rigor/bulk/broad_phase/pair_filter.hpp"

#include "rigor/core/index.hpp"

#include <algorithm>

namespace rigor {

PairFilter::PairFilter(const Model& model) : entries_(at(model.body_count())) {
  for (int i = 0; i < model.body_count(); ++i) set_body(model, i);
  set_excluded(model);
}

void PairFilter::set_body(const Model& model, int body) {
  entries_[at(body)].group = model.body(body).group;
  entries_[at(body)].mask = model.body(body).mask;
}

void PairFilter::set_excluded(const Model& model) {
  // How many excluded partners each body has, both ways; its section of the list of all.
  std::vector<int> counts(entries_.size(), 0);
  for (const auto& [a, b] : model.excluded_pairs()) {
    ++counts[at(a)];
    ++counts[at(b)];
  }
  int end = 0;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    entries_[i].excluded_begin = entries_[i].excluded_end = end;
    end += counts[i];
  }
  // Pairs are in order, so that the lower partners of a body come first, and each kind ascends.
  excluded_.resize(at(end));
  for (const auto& [a, b] : model.excluded_pairs()) excluded_[at(entries_[at(b)].excluded_end++)] = a;
  for (const auto& [a, b] : model.excluded_pairs()) excluded_[at(entries_[at(a)].excluded_end++)] = b;
}

/// Searches the shorter of the two bodies' lists.
bool PairFilter::is_excluded(int a, int b) const {
  const Entry *list = &entries_[at(a)], *other = &entries_[at(b)];
  int wanted = b;
  if (other->excluded_end - other->excluded_begin < list->excluded_end - list->excluded_begin) {
    list = other;
    wanted = a;
  }
  return std::binary_search(excluded_.begin() + list->excluded_begin, excluded_.begin() + list->excluded_end,
                            wanted);
}

}  // namespace rigor
