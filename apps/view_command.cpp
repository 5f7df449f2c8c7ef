#include "apps/announcement.hpp"
#include "apps/browser.hpp"
#include "apps/commands.hpp"
#include "apps/interrupt.hpp"
#include "apps/terminal.hpp"
#include "apps/usage_error.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/view/live/live_replay.hpp"
#include "rigor/view/live/live_server.hpp"

#include <filesystem>
#include <functional>

namespace rigor {

ExitCode execute(const ViewOptions& options) {
  const InterruptWatch interrupt;
  const std::function<bool()> is_interrupted = [&interrupt] { return interrupt.is_requested(); };
  const InterruptScope scope(is_interrupted);
  Browser browser;
  const auto should_end = [&] {
    browser.look_after();
    return is_interrupted();
  };
  if (std::filesystem::path(options.file).extension() == ".h5") {
    if (!options.overrides.empty()) throw UsageError("--set does not go with a trajectory");
    LiveReplay replay = read_live_replay(options.file);
    for (const std::string& warning : replay.warnings) print_warning(warning);
    LiveServer server(options.port);
    announce(server, browser, options.opens_browser);
    server.serve(replay.title, std::move(replay.blocks), should_end);
  } else {
    LiveServer server(options.port);
    LiveSimulation simulation(
        LiveFile(options.file, options.overrides), [&server] { server.notify(); },
        [&server](LiveReply reply) { server.reply(std::move(reply)); });
    for (const std::string& warning : simulation.warnings()) print_warning(warning);
    announce(server, browser, options.opens_browser);
    server.serve(simulation, should_end);
  }
  return exit_interrupted;
}

}  // namespace rigor
