#pragma once

#include "rigor/model/model.hpp"
#include "rigor/sim/method/method.hpp"
#include "rigor/sim/method/run_settings.hpp"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rigor {

/// Where a body is at a time, known from elsewhere: a closed form, or a reference of many digits.
struct ExpectedPlace {
  std::string body;
  double time = 0;                  ///< [s].
  std::optional<Vec3> position;     ///< Of the user's frame's origin [m].
  std::optional<Quat> orientation;  ///< Of the user's frame.
  double error = 0;                 ///< How far the position may be wrong itself [m].
};

/// What a scene file says: what is simulated, how, and for how long.
struct Scene {
  std::shared_ptr<const Model> model;
  Method method;
  RunSettings run;
  std::string name;
  std::vector<ExpectedPlace> expected;  ///< What `rigor compare` measures errors against.
  std::vector<std::string> warnings;    ///< What is allowed but probably not meant, each with its place.
};

/// Reads a scene file (strict YAML; JSON is the same thing). docs/scene.md lists every key.
///
/// overrides: "key.path=value" as of `--set`: keys joined by points, list entries by their name or index
/// ("bodies.ball.velocity=[0, 0, 1]"); the value is YAML. Overrides are checked like the file.
/// The last `varied` of them are called `--vary` in messages.
///
/// Throws InputError with all errors of the file, in the order of its lines.
Scene read_scene(const std::filesystem::path& path, const std::vector<std::string>& overrides = {},
                 std::size_t varied = 0);

/// The same from text; file_name is what messages show, folder is where mesh files are looked for (and kept
/// inside).
Scene parse_scene(const std::string& text, const std::string& file_name, const std::filesystem::path& folder,
                  const std::vector<std::string>& overrides = {}, std::size_t varied = 0);

}  // namespace rigor
