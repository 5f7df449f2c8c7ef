#include "rigor/model/joint.hpp"

#include "rigor/core/index.hpp"

#include <cstddef>

namespace rigor {

const char* joint_type_name(JointType type) {
  static constexpr const char* names[] = {"fixed",       "ball",   "hinge",    "slider", "universal",
                                          "cylindrical", "planar", "distance", "screw",  "gear"};
  return names[at(type)];
}

int coordinate_count(JointType type) {
  switch (type) {
    case JointType::hinge:
    case JointType::slider:
    case JointType::ball:
    case JointType::distance:
    case JointType::screw:
      return 1;
    case JointType::cylindrical:
    case JointType::universal:
      return 2;
    case JointType::planar:
      return 3;
    case JointType::fixed:
    case JointType::gear:
      break;
  }
  return 0;
}

bool is_angle(JointType type, int k) {
  switch (type) {
    case JointType::slider:
    case JointType::distance:
      return false;
    case JointType::cylindrical:
      return k == 1;
    case JointType::planar:
      return k == 2;
    default:
      return true;
  }
}

}  // namespace rigor
