#pragma once

#include "rigor/model/body_table.hpp"
#include "rigor/model/model_builder.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rigor {

/// The joints of a scene by name and type, for gears; indices in the order in which they were added.
struct JointTable {
  std::vector<JointType> types;
  std::map<std::string, int> index;
};

/// The joint with its bodies (a gear: its joints) by index and its frames on them; nothing, and why in the
/// messages, if it makes no sense. Velocities at t = 0 that contradict it are not looked for here.
std::optional<Joint> make_joint(const ModelBuilder::JointDescription& description, const std::string& where,
                                const BodyTable& bodies, const JointTable& joints,
                                std::vector<std::string>& messages);

}  // namespace rigor
