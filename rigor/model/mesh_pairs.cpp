#include "rigor/model/mesh_pairs.hpp"

#include "rigor/core/quoted.hpp"
#include "rigor/model/limits.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

namespace rigor {

namespace {

/// What decides, exclusions aside, whether two bodies may collide.
using Kind = std::tuple<bool, std::uint32_t, std::uint32_t>;

bool has_mesh(const Body& body) {
  return std::any_of(body.shapes.begin(), body.shapes.end(),
                     [](const BodyShape& shape) { return std::holds_alternative<Mesh>(shape.shape); });
}

bool kinds_collide(const Kind& a, const Kind& b) {
  const auto [a_is_dynamic, a_group, a_mask] = a;
  const auto [b_is_dynamic, b_group, b_mask] = b;
  return (a_is_dynamic || b_is_dynamic) && (a_group & b_mask) != 0 && (b_group & a_mask) != 0;
}

/// The first pair that may collide. Only excluded pairs are passed over, so this ends soon.
std::optional<std::pair<int, int>> find_pair(const Model& model, const std::vector<int>& as,
                                             const std::vector<int>& bs) {
  for (const int a : as) {
    for (const int b : bs) {
      if (model.may_collide(a, b)) return std::minmax({a, b});
    }
  }
  return std::nullopt;
}

}  // namespace

void check_mesh_pairs(const Model& model, const std::vector<std::string>& wheres,
                      std::vector<std::string>& messages) {
  std::map<Kind, std::vector<int>> bodies_of_kind;
  for (int i = 0; i < model.body_count(); ++i) {
    const Body& body = model.body(i);
    if (!has_mesh(body)) continue;
    bodies_of_kind[{body.motion == MotionType::dynamic, body.group, body.mask}].push_back(i);
  }
  for (auto a = bodies_of_kind.begin(); a != bodies_of_kind.end(); ++a) {
    for (auto b = a; b != bodies_of_kind.end(); ++b) {
      if (!kinds_collide(a->first, b->first)) continue;
      const std::optional<std::pair<int, int>> pair = find_pair(model, a->second, b->second);
      if (!pair) continue;
      messages.push_back(
          wheres[static_cast<std::size_t>(pair->second)] + "body " +
          quoted_text(model.body(pair->second).name) + ": it may collide with " +
          quoted_text(model.body(pair->first).name) +
          ", and contacts between two meshes are not available in this version; use 'convex' shapes, or "
          "keep the two apart with 'exclude' or 'group' and 'mask'");
      if (messages.size() >= limits::message_count) return;
    }
  }
}

}  // namespace rigor
