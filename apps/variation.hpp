#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace rigor {

/// A key of a scene and the values that it takes, one after the other.
struct Variation {
  std::string key;                  ///< As of --set: "method.toi".
  std::vector<std::string> values;  ///< As they were written, at least one, none twice.
};

/// The variation of "KEY=a,b,c", as of --vary. Values are parted at commas outside of brackets [], braces {}
/// and quotes, and lose the spaces around them. Throws UsageError: no key, an empty value, a value twice (as
/// text or as a number), a bracket or quote that is not closed.
Variation parse_variation(const std::string& text);

/// One value of each variation; the last variation changes fastest.
using Combination = std::vector<std::string>;

/// All combinations. Throws UsageError if there are more than `most`, or two variations have the same key.
std::vector<Combination> combinations(const std::vector<Variation>& variations, std::size_t most);

/// "method.toi=ratio, run.step=0.01".
std::string combination_label(const std::vector<Variation>& variations, const Combination& combination);

}  // namespace rigor
