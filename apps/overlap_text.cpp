#include "apps/overlap_text.hpp"

#include "rigor/core/quoted.hpp"

#include <fmt/format.h>

namespace rigor {

std::vector<std::string> overlap_messages(const std::string& scene, const Model& model,
                                          const std::vector<Overlap>& overlaps, double tolerance) {
  constexpr std::size_t most_pairs = 10;
  std::vector<std::string> messages;
  for (const Overlap& overlap : overlaps) {
    if (messages.size() == most_pairs) break;
    messages.push_back(
        fmt::format("{}: bodies {} and {} overlap by {:.6g} m at t = 0, must be at most {:g} m "
                    "(method.contact_tolerance)",
                    scene, quoted_text(model.body(overlap.body_A).name),
                    quoted_text(model.body(overlap.body_B).name), overlap.depth, tolerance));
  }
  if (overlaps.size() > most_pairs) {
    messages.push_back(fmt::format("{}: and {} more pairs overlap", scene, overlaps.size() - most_pairs));
  }
  if (!messages.empty()) {
    messages.push_back(
        fmt::format("{}: move these bodies, or let 'rigor run --separate' push them apart", scene));
  }
  return messages;
}

}  // namespace rigor
