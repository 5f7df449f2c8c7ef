#include "apps/announcement.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace rigor {

void announce(const LiveServer& server, Browser& browser, bool opens_browser) {
  fmt::print("{}\n", server.url());
  std::fflush(stdout);
  fmt::print(stderr, "Open this address in a browser on this machine; Ctrl-C ends.\n");
  if (opens_browser) browser.open(server.url());
}

}  // namespace rigor
