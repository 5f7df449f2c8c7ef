#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace rigor {

/// The parts of a request that decide whether it is answered.
struct LiveRequestHead {
  std::string_view method;  ///< "GET".
  std::string_view target;  ///< "/live?token=...".
  std::string_view host;    ///< Empty if the request has none.
  std::string_view origin;  ///< Empty if the request has none.
  bool is_upgrade = false;  ///< Requests a WebSocket.
  bool has_body = false;
};

/// Who may see the page and change the simulation: programs on this machine that know the token, and in a
/// browser only the page itself.
class LiveAccess {
 public:
  enum class Resource { none, page, script, socket };
  struct Verdict {
    Resource resource;       ///< `none` if refused.
    unsigned status;         ///< HTTP status: 200, 101, or the reason for the refusal.
    std::string_view words;  ///< Message for the reader.
    std::string_view path;   ///< Of a page or a script: "/", "/run/12", "/viewer.js".
  };

  /// has_pages: there are more pages than one, whose paths are not judged here.
  LiveAccess(std::uint16_t port, std::string token, bool has_pages = false);

  /// Refusals: 421 if Host is not 127.0.0.1, localhost or [::1] with our port (a page elsewhere whose name
  /// was made to point here); 403 for a page or socket without the token, and for a socket from a page that
  /// is not ours.
  Verdict judge(const LiveRequestHead& request) const;
  std::string url() const;
  const std::string& token() const { return token_; }

 private:
  bool is_own_host(std::string_view host) const;

  std::uint16_t port_;
  std::string token_;
  bool has_pages_;
};

/// 32 hexadecimal digits from the system's source of randomness.
std::string make_live_token();

/// Content-Security-Policy of a page that is served at this host: it allows the page's own script, data and
/// socket and nothing else.
std::string live_policy(std::string_view host);

}  // namespace rigor
