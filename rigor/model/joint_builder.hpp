#pragma once

#include "rigor/model/body_table.hpp"
#include "rigor/model/model_builder.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rigor {

/// The joints of a scene by name and type, for gears to find them; indices are in the order in which joints
/// were added.
struct JointTable {
  std::vector<JointType> types;
  std::map<std::string, int> index;
};

/// The joint with its bodies (a gear: its joints) by index and its frames on them; nothing, and the reason in
/// the messages, if the description is invalid. Velocities at t = 0 that contradict it are not detected here.
std::optional<Joint> make_joint(const ModelBuilder::JointDescription& description, const std::string& where,
                                const BodyTable& bodies, const JointTable& joints,
                                std::vector<std::string>& messages);

}  // namespace rigor
