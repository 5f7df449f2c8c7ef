#include "rigor/view/live/live_access.hpp"

#include <fmt/format.h>

#include <random>
#include <utility>

namespace rigor {

namespace {

/// The value of token=... in "/path?token=...", the only thing that may follow the path.
std::string_view token_of(std::string_view target) {
  constexpr std::string_view key = "token=";
  const std::size_t question = target.find('?');
  if (question == std::string_view::npos) return {};
  const std::string_view query = target.substr(question + 1);
  return query.starts_with(key) ? query.substr(key.size()) : std::string_view{};
}

/// Compares in constant time, so that the time does not reveal where the texts differ.
bool is_equal(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) difference |= static_cast<unsigned>(a[i] ^ b[i]);
  return difference == 0;
}

}  // namespace

LiveAccess::LiveAccess(std::uint16_t port, std::string token, bool has_pages)
    : port_(port), token_(std::move(token)), has_pages_(has_pages) {}

std::string LiveAccess::url() const {
  return fmt::format("http://127.0.0.1:{}/?token={}", port_, token_);
}

bool LiveAccess::is_own_host(std::string_view host) const {
  for (const char* const name : {"127.0.0.1", "localhost", "[::1]"}) {
    if (host == fmt::format("{}:{}", name, port_)) return true;
  }
  return false;
}

LiveAccess::Verdict LiveAccess::judge(const LiveRequestHead& request) const {
  const auto refused = [](unsigned status, std::string_view words) {
    return Verdict{Resource::none, status, words};
  };
  if (!is_own_host(request.host)) return refused(421, "This server answers to its own address only.");
  if (request.has_body) return refused(413, "Requests with a body are not taken.");
  if (request.method != "GET") return refused(405, "Only GET is answered.");
  const std::string_view path = request.target.substr(0, request.target.find('?'));
  if (path == "/viewer.js" || (has_pages_ && path.ends_with(".js"))) return {Resource::script, 200, "", path};
  const bool is_socket = path == "/live";
  if (path != "/" && !is_socket && !has_pages_) return refused(404, "There is no such page.");
  if (!is_equal(token_of(request.target), token_))
    return refused(403, "The token is missing or wrong: open the address that rigor view printed.");
  if (!is_socket) return {Resource::page, 200, "", path};
  if (request.origin != fmt::format("http://{}", request.host))
    return refused(403, "Only the page itself may do this.");
  if (!request.is_upgrade) return refused(426, "This address speaks WebSocket.");
  return {Resource::socket, 101, ""};
}

std::string make_live_token() {
  std::random_device random;  // getrandom() or the processor, by libstdc++
  std::string token;
  for (int i = 0; i < 4; ++i) token += fmt::format("{:08x}", static_cast<std::uint32_t>(random()));
  return token;
}

std::string live_policy(std::string_view host) {
  return fmt::format(
      "default-src 'none'; script-src 'self'; img-src data: blob:; "
      "connect-src ws://{}; base-uri 'none'; form-action 'none'",
      host);
}

}  // namespace rigor
