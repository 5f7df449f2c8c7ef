#pragma once

#include "rigor/model/drives.hpp"
#include "rigor/model/findings.hpp"

#include <vector>

namespace rigor {

/// Checks the drives of a joint, gives its coordinates the motors that they are at t = 0, and returns them
/// with the joint's index.
std::vector<JointDrive> make_drives(std::vector<JointDrive> drives, int index, Joint& joint,
                                    Findings& findings);
/// Checks a function of the time and its value at t = 0.
bool check_function(const std::string& quantity, const TimeFunction& function, const Range& range,
                    const std::string& unit, Findings& findings);

}  // namespace rigor
