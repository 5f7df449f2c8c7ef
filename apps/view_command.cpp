#include "apps/commands.hpp"
#include "apps/interrupt.hpp"
#include "apps/terminal.hpp"
#include "apps/usage_error.hpp"
#include "rigor/view/live/live_replay.hpp"
#include "rigor/view/live/live_server.hpp"

#include <fmt/format.h>

#include <spawn.h>
#include <sys/wait.h>
#include <cstdlib>
#include <filesystem>

extern char** environ;

namespace rigor {

namespace {

bool has_display() {
  return std::getenv("DISPLAY") != nullptr || std::getenv("WAYLAND_DISPLAY") != nullptr;
}

/// Opens the address in the browser of the user, or says why it could not.
void open_browser(std::string url) {
  if (!has_display())
    return print_warning("there is no display to open a browser on; open the address yourself");
  std::string program = "xdg-open";
  char* const arguments[] = {program.data(), url.data(), nullptr};
  pid_t child = 0;
  int status = 0;
  const bool is_open = ::posix_spawnp(&child, program.c_str(), nullptr, nullptr, arguments, environ) == 0 &&
                       ::waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
  if (!is_open) print_warning("xdg-open could not open a browser; open the address yourself");
}

void announce(const ViewOptions& options, const LiveServer& server) {
  fmt::print("{}\n", server.url());
  std::fflush(stdout);
  fmt::print(stderr, "Open this address in a browser on this machine; Ctrl-C ends.\n");
  if (options.opens_browser) open_browser(server.url());
}

}  // namespace

ExitCode execute(const ViewOptions& options) {
  const InterruptWatch interrupt;
  const auto should_end = [&interrupt] { return interrupt.is_requested(); };
  if (std::filesystem::path(options.file).extension() == ".h5") {
    if (!options.overrides.empty()) throw UsageError("--set does not go with a trajectory");
    LiveReplay replay = read_live_replay(options.file);
    LiveServer server(options.port);
    announce(options, server);
    server.serve(replay.title, std::move(replay.blocks), should_end);
  } else {
    LiveServer server(options.port);
    LiveSimulation simulation(
        LiveFile(options.file, options.overrides), [&server] { server.notify(); },
        [&server](LiveReply reply) { server.reply(std::move(reply)); });
    for (const std::string& warning : simulation.warnings()) print_warning(warning);
    announce(options, server);
    server.serve(simulation, should_end);
  }
  return exit_interrupted;
}

}  // namespace rigor
