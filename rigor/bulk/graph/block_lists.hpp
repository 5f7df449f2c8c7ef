#pragma once

#include "rigor/bulk/graph/graph_colouring.hpp"
#include "rigor/bulk/lanes/list_room.hpp"
#include "rigor/bulk/matching/manifold_blocks.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace rigor {

/// The blocks of all contacts, in one list per kind, and their impulses of a step. They are numbered as the
/// blocks of a colouring whose kinds of edges are block_kinds.
class BlockLists {
 public:
  /// Makes room for the blocks of a colouring; the caller fills them. There are no totals afterwards.
  void arrange(const GraphColouring& colouring) {
    // Each section of a colour is a stretch of the list of its kind.
    std::array<int, block_kind_count> counts{};
    sections_.clear();
    const auto& all = colouring.sections;
    for (std::size_t s = 0; s < all.size(); ++s) {
      const int end = s + 1 < all.size() ? all[s + 1].first_block : static_cast<int>(colouring.blocks.size());
      int& count = counts[at(all[s].kind)];
      sections_.push_back({all[s].kind, all[s].first_block, end, count});
      count += end - all[s].first_block;
    }
    count_ = static_cast<int>(colouring.blocks.size());
    for_lists([&](auto& list, int kind) { renew(at(counts[at(kind)]), list.blocks); });
    clear_totals();
  }
  int count() const { return count_; }

  /// Calls work(block, number) for each block of these numbers, in their order.
  template <class Work>
  void for_blocks(int begin, int end, const Work& work) {
    for_ranges(*this, begin, end,
               [&](auto& list, std::size_t place, int number) { work(list.blocks[place], number); });
  }

  /// The same with their impulses of the step: work(block, total, number).
  template <class Work>
  void for_totals(int begin, int end, const Work& work) {
    for_ranges(*this, begin, end, [&](auto& list, std::size_t place, int number) {
      work(list.blocks[place], list.totals[place], number);
    });
  }
  template <class Work>
  void for_totals(int begin, int end, const Work& work) const {
    for_ranges(*this, begin, end, [&](const auto& list, std::size_t place, int number) {
      work(list.blocks[place], list.totals[place], number);
    });
  }
  bool has_totals() const { return has_totals_; }
  void clear_totals() {
    for_lists([](auto& list, int) { list.totals.clear(); });
    has_totals_ = false;
  }
  /// Makes totals, all of them zero.
  void make_totals() {
    for_lists([](auto& list, int) {
      make_room(list.blocks.size(), list.totals);
      list.totals.resize(list.blocks.size());
    });
    has_totals_ = true;
  }

 private:
  template <BlockKind kind>
  struct List {
    std::vector<ManifoldBlock<kind>> blocks;
    std::vector<BlockImpulses<kind>> totals;  ///< Impulses of the step, if they are wanted.
  };
  template <class Numbers>
  struct ListsOf;
  template <std::size_t... kind>
  struct ListsOf<std::index_sequence<kind...>> {
    using Type = std::tuple<List<block_kinds[kind]>...>;
  };
  using Kinds = std::make_index_sequence<block_kinds.size()>;
  /// Blocks of one colour and kind.
  struct Section {
    int kind, begin, end;
    int first_place;  ///< Index of the first of them in the list of the kind.
  };

  template <class Work>
  void for_lists(const Work& work) {
    int kind = 0;
    std::apply([&](auto&... list) { (work(list, kind++), ...); }, lists_);
  }
  template <class Lists, class Work, std::size_t... kinds>
  static void with_list(Lists& lists, int kind, const Work& work, std::index_sequence<kinds...>) {
    ((kind == static_cast<int>(kinds) ? work(std::get<kinds>(lists)) : void()), ...);
  }
  template <class Self, class Work>
  static void for_ranges(Self& self, int begin, int end, const Work& work) {
    for (const Section& section : self.sections_) {
      const int first = std::max(begin, section.begin), last = std::min(end, section.end);
      if (first >= last) continue;
      const auto visit = [&](auto& list) {
        for (int k = first; k < last; ++k) work(list, at(section.first_place + k - section.begin), k);
      };
      with_list(self.lists_, section.kind, visit, Kinds{});
    }
  }

  ListsOf<Kinds>::Type lists_;
  std::vector<Section> sections_;
  int count_ = 0;
  bool has_totals_ = false;
};

}  // namespace rigor
