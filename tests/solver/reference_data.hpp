#pragma once

#include "rigor/math/types.hpp"

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

namespace rigor::reference {

/// The file's content, which stays: a loop over read(name)["cases"] would else go over what is gone.
inline const nlohmann::json& read(const std::string& name) {
  static std::map<std::string, nlohmann::json> files;
  const auto [file, is_new] = files.try_emplace(name);
  if (is_new) file->second = nlohmann::json::parse(std::ifstream(std::string(RIGOR_TEST_DATA) + "/" + name));
  return file->second;
}

inline VecX vector(const nlohmann::json& values) {
  VecX result(static_cast<Eigen::Index>(values.size()));
  for (Eigen::Index i = 0; i < result.size(); ++i)
    result(i) = values[static_cast<std::size_t>(i)].get<double>();
  return result;
}

inline MatX matrix(const nlohmann::json& rows) {
  MatX result(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(rows[0].size()));
  for (Eigen::Index i = 0; i < result.rows(); ++i)
    result.row(i) = vector(rows[static_cast<std::size_t>(i)]).transpose();
  return result;
}

}  // namespace rigor::reference
