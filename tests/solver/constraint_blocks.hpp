#pragma once

#include "rigor/math/types.hpp"

#include <vector>

namespace rigor {

/// The rows of a link on one of its nodes.
using ConstraintRows = Eigen::Matrix<double, Eigen::Dynamic, 6, Eigen::ColMajor, 6, 6>;

/// The blocks of all links on their nodes, each with zeros up to six rows: as ConstrainedMass takes them.
inline std::vector<Mat6> blocks_of(const std::vector<std::vector<ConstraintRows>>& links) {
  std::vector<Mat6> blocks;
  for (const std::vector<ConstraintRows>& link : links) {
    for (const ConstraintRows& rows : link) {
      blocks.emplace_back(Mat6::Zero());
      blocks.back().topRows(rows.rows()) = rows;
    }
  }
  return blocks;
}

}  // namespace rigor
