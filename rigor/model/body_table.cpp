#include "rigor/model/body_table.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/core/suggestion.hpp"
#include "rigor/model/force.hpp"

namespace rigor {

std::string unknown_body(const std::string& name, const BodyTable& bodies) {
  std::vector<std::string> names;
  for (const auto& [known, index] : bodies.index) names.push_back(known);
  return "unknown body " + quoted_text(name) + suggestion(name, names);
}

std::optional<std::vector<int>> find_bodies(const std::vector<std::string>& names, const BodyTable& bodies,
                                            Findings& findings) {
  std::vector<int> indices;
  bool has_dynamic = false, is_good = true;
  for (const std::string& name : names) {
    if (name == "world") {
      indices.push_back(world_body);
      continue;
    }
    const auto found = bodies.index.find(name);
    if (found == bodies.index.end()) {
      findings.add(unknown_body(name, bodies));
      is_good = false;
      continue;
    }
    indices.push_back(found->second);
    has_dynamic |= bodies.bodies[at(found->second)].motion == MotionType::dynamic;
  }
  if (!is_good) return std::nullopt;
  if (!findings.require(has_dynamic, "it moves nothing: none of its bodies is dynamic")) return std::nullopt;
  if (!findings.require(indices.size() < 2 || indices[0] != indices[1], "both ends are on the same body")) {
    return std::nullopt;
  }
  return indices;
}

}  // namespace rigor
