#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace rigor {

/// A key of a scene and the values that it takes in turn.
struct Variation {
  std::string key;                  ///< As given with --set: "method.toi".
  std::vector<std::string> values;  ///< As written; at least one, none twice.
};

/// Parses the variation "KEY=a,b,c" of --vary. Values are separated by commas outside brackets [], braces {}
/// and quotes, and are stripped of surrounding spaces. Throws UsageError: no key, an empty value, a repeated
/// value (as text or as a number), or an unclosed bracket or quote.
Variation parse_variation(const std::string& text);

/// One value of each variation; the last variation changes fastest.
using Combination = std::vector<std::string>;

/// All combinations. Throws UsageError if there are more than `most`, or two variations have the same key.
std::vector<Combination> combinations(const std::vector<Variation>& variations, std::size_t most);

/// "method.toi=ratio, run.step=0.01".
std::string combination_label(const std::vector<Variation>& variations, const Combination& combination);

}  // namespace rigor
