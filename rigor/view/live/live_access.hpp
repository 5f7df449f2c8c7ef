#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace rigor {

/// What of a request decides whether it is answered.
struct LiveRequestHead {
  std::string_view method;  ///< "GET".
  std::string_view target;  ///< "/live?token=...".
  std::string_view host;    ///< Empty if the request has none.
  std::string_view origin;  ///< Empty if the request has none.
  bool is_upgrade = false;  ///< Asks for a WebSocket.
  bool has_body = false;
};

/// Who may see the page and change the simulation: programs on this machine that know the token, and in a
/// browser only the page itself.
class LiveAccess {
 public:
  enum class Resource { none, page, script, socket };
  struct Verdict {
    Resource resource;       ///< none: refused.
    unsigned status;         ///< Of HTTP: 200, 101 or why it is refused.
    std::string_view words;  ///< For the reader.
  };

  LiveAccess(std::uint16_t port, std::string token);

  /// Host names another than 127.0.0.1, localhost or [::1] with our port: 421 (a page elsewhere whose name
  /// was made to point here). Page and socket without the token: 403. Socket from a page that is not ours:
  /// 403.
  Verdict judge(const LiveRequestHead& request) const;
  std::string url() const;
  const std::string& token() const { return token_; }

 private:
  bool is_own_host(std::string_view host) const;

  std::uint16_t port_;
  std::string token_;
};

/// 32 hexadecimal digits from the system's source of randomness.
std::string make_live_token();

/// Content-Security-Policy of a page that is served at this host: its script, its data, its socket, no more.
std::string live_policy(std::string_view host);

}  // namespace rigor
