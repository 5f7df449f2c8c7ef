#pragma once

#include "rigor/io/scene/scene_reader.hpp"

namespace rigor {

/// As read_scene_tree, of a document that is known to have no synonyms in it: they are not looked for, which
/// takes a fifth of the time. That a document like it was read without warnings tells it.
Scene read_tree_without_synonyms(const YamlNode::Pointer& root, const YamlSources& sources,
                                 const std::filesystem::path& folder);

}  // namespace rigor
