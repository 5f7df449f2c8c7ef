#pragma once

#include "rigor/io/files/yaml_document.hpp"

#include <string>
#include <vector>

namespace rigor {

/// The document with "key.path=value" inserted, as given with --set: keys joined by points, list entries by
/// name or index ("bodies.ball.shapes.0.radius=2", also "shapes[0]"). Missing keys are added, so that the
/// reader can check them; of a list that is missing the other numbers are those of its default. source: index
/// of the override in sources. Throws InputError if the text has no '=', the value is not YAML, or the path
/// leads nowhere.
YamlNode::Pointer with_override(const YamlNode::Pointer& root, const std::string& text, int source,
                                const YamlSources& sources);

/// The document with a value put at "key.path", as above. where: in front of messages.
YamlNode::Pointer with_value(const YamlNode::Pointer& root, const std::string& path,
                             const YamlNode::Pointer& value, const std::string& where);

}  // namespace rigor
