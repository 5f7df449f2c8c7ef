#pragma once

#include "rigor/view/page/page_block.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace rigor {

/// A stored run as the data of a page.
struct LiveReplay {
  std::string title;
  std::vector<PageBlock> blocks;
  std::vector<std::string> warnings;  ///< That the run ended early, or the file is truncated.
};

/// Reads a trajectory (.h5) with the scene that it carries; mesh files of the scene are looked for beside it.
/// The file holds neither an audit nor the effort of the solver: energies and impacts are the stored ones,
/// everything else is empty. Throws InputError.
LiveReplay read_live_replay(const std::filesystem::path& path);

}  // namespace rigor
