#pragma once

#include "rigor/model/body.hpp"
#include "rigor/model/findings.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rigor {

/// The bodies of a scene, built, with their names.
struct BodyTable {
  const std::vector<Body>& bodies;
  const std::map<std::string, int>& index;
};

/// Message about a body that does not exist: "unknown body 'bal'; did you mean 'ball'?".
std::string unknown_body(const std::string& name, const BodyTable& bodies);

/// Indices of the named bodies, "world" as world_body; nothing, and the reason in the findings, if one is
/// unknown, none of them is dynamic or two are the same.
std::optional<std::vector<int>> find_bodies(const std::vector<std::string>& names, const BodyTable& bodies,
                                            Findings& findings);

}  // namespace rigor
