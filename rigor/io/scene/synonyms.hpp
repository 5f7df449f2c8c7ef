#pragma once

#include "rigor/io/files/yaml_document.hpp"
#include "rigor/io/scene/scene_errors.hpp"

namespace rigor {

/// The scene with the words of other engines and of textbooks replaced by those of the format: a joint of
/// type `revolute` becomes a `hinge`, the `half_extents` of a box its `size`, twice as large. One line of
/// advice a word, as a warning at its first place. A word that the mapping has in both spellings is left as
/// it is, for the reader to refuse.
YamlNode::Pointer with_synonyms(const YamlNode::Pointer& root, SceneErrors& errors);

}  // namespace rigor
