#pragma once

#include "rigor/io/files/yaml_document.hpp"
#include "rigor/model/model.hpp"
#include "rigor/model/time_function.hpp"
#include "rigor/sim/method/method.hpp"
#include "rigor/sim/method/run_settings.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rigor {

/// The place of a body at a certain time, known independently: from a closed form or a reference of many
/// digits.
struct ExpectedPlace {
  /// Its name.
  std::string body;
  double time = 0;                  ///< [s].
  std::optional<Vec3> position;     ///< Position of the origin of the user frame [m].
  std::optional<Quat> orientation;  ///< Orientation of the user frame.
  double error = 0;                 ///< Uncertainty of the position itself [m].
};

/// The contents of a scene file: what is simulated, how, and for how long.
struct Scene {
  /// Bodies, materials, forces and joints.
  std::shared_ptr<const Model> model;
  /// How it is computed.
  Method method;
  /// For how long, and in which steps.
  RunSettings run;
  /// Of the scene.
  std::string name;
  std::vector<ExpectedPlace> expected;  ///< What `rigor compare` measures errors against.
  std::vector<std::string> warnings;    ///< Allowed but probably unintended, each with its position.
};

/// Reads a scene file (strict YAML; JSON is read in the same way). docs/scene.md lists every key.
///
/// overrides: "key.path=value" as of `--set`: keys joined by points, list entries by their name or index
/// ("bodies.ball.velocity=[0, 0, 1]"); the value is YAML. Overrides are checked like the file.
/// Messages call the last `varied` of them `--vary`.
///
/// Throws InputError with all errors of the file, in the order of its lines.
Scene read_scene(const std::filesystem::path& path, const std::vector<std::string>& overrides = {},
                 std::size_t varied = 0);

/// The same from text; file_name appears in messages, and folder is where mesh files are looked for (and may
/// not lie outside of).
Scene parse_scene(const std::string& text, const std::string& file_name, const std::filesystem::path& folder,
                  const std::vector<std::string>& overrides = {}, std::size_t varied = 0);

/// Makes a function of a formula in t; throws InputError, without a place, with what is wrong with it.
using FormulaReader = std::function<TimeFunction(const std::string& text)>;
/// Says how formulas of the time in scene files are read from now on. The library has no reader of its own,
/// since that would take another library (docs/decisions/0021-functions-of-time.md); the program and the
/// Python module have one. To be called before threads read scenes.
void use_formula_reader(FormulaReader reader);

/// The same from a document that has been parsed already; the first of the sources is the scene file.
Scene read_scene_tree(const YamlNode::Pointer& root, const YamlSources& sources,
                      const std::filesystem::path& folder);

}  // namespace rigor
