#pragma once

#include "apps/browser.hpp"
#include "rigor/view/live/live_server.hpp"

namespace rigor {

/// Tells the address of a server, and opens it in the browser if that is wanted.
void announce(const LiveServer& server, Browser& browser, bool opens_browser);

}  // namespace rigor
