#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace rigor {

// What the command line asks for. An empty path: not asked for; the JSON path "-": stdout.

struct RunOptions {
  std::string scene;
  std::vector<std::string> outputs;
  std::vector<std::string> overrides;  ///< "key=value".
  std::optional<double> duration;      ///< [s].
  int threads = 1;
  std::string json;
  bool is_quiet = false;
  bool separate = false;
  std::string checkpoint;
  std::optional<double> checkpoint_every;  ///< Simulated time [s].
  std::string resume;
};

struct CheckOptions {
  std::vector<std::string> scenes;
};

struct MassOptions {
  std::string file;
  std::optional<double> density;  ///< [kg/m³].
  int samples = 500000;           ///< Points a body.
  std::string json;
};

struct DistanceOptions {
  std::string scene, body_A, body_B;
  std::optional<double> tolerance;  ///< Of the contact set [m].
  std::string json;
};

struct MethodsOptions {};

using Command = std::variant<RunOptions, CheckOptions, MassOptions, DistanceOptions, MethodsOptions>;

}  // namespace rigor
