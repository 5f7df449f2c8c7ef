#pragma once

#include <cstdint>
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

struct ViewOptions {
  std::string file;                    ///< Scene or trajectory (.h5).
  std::vector<std::string> overrides;  ///< "key=value".
  std::uint16_t port = 0;              ///< 0: a free one.
  bool opens_browser = false;
};

using Command =
    std::variant<RunOptions, ViewOptions, CheckOptions, MassOptions, DistanceOptions, MethodsOptions>;

}  // namespace rigor
