#pragma once

#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

/// A client of the live server that can also behave badly: plain sockets, no library between.
namespace rigor::test {

class Connection {
 public:
  /// receive_buffer [bytes]: what the system keeps for who does not read; 0: as usual.
  explicit Connection(int port, int receive_buffer = 0) : descriptor_(::socket(AF_INET, SOCK_STREAM, 0)) {
    if (receive_buffer > 0)
      ::setsockopt(descriptor_, SOL_SOCKET, SO_RCVBUF, &receive_buffer, sizeof receive_buffer);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (::connect(descriptor_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
      throw std::runtime_error("cannot connect");
  }
  Connection(Connection&& other) noexcept
      : descriptor_(std::exchange(other.descriptor_, -1)), left_(std::move(other.left_)) {}
  Connection& operator=(Connection&&) = delete;
  ~Connection() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

  void send(const std::string& bytes) {
    std::size_t sent = 0;
    while (sent < bytes.size()) {
      const ssize_t count = ::send(descriptor_, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
      if (count <= 0) return;
      sent += static_cast<std::size_t>(count);
    }
  }

  /// All that comes until the other side closes, or for this long [s].
  std::string read_all(double patience = 10) {
    std::string text = std::exchange(left_, {});
    while (const std::optional<std::string> more = read_some(patience)) {
      if (more->empty()) break;
      text += *more;
    }
    return text;
  }
  /// Whether the other side closes within this time [s].
  bool is_closed_within(double patience) {
    const auto begin = std::chrono::steady_clock::now();
    const auto passed = [&begin] {
      return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    };
    while (passed() < patience) {
      const std::optional<std::string> more = read_some(patience - passed());
      if (more && more->empty()) return true;
    }
    return false;
  }

  /// Exactly so many bytes; throws when they do not come.
  std::string read(std::size_t count) {
    while (left_.size() < count) {
      const std::optional<std::string> more = read_some(10);
      if (!more || more->empty()) throw std::runtime_error("the connection ended");
      left_ += *more;
    }
    std::string part = left_.substr(0, count);
    left_.erase(0, count);
    return part;
  }
  /// The head of an HTTP answer.
  std::string read_head() {
    std::string head;
    while (!head.ends_with("\r\n\r\n")) head += read(1);
    return head;
  }

 private:
  /// Nothing: nothing came. Empty: closed.
  std::optional<std::string> read_some(double patience) {
    pollfd ready{descriptor_, POLLIN, 0};
    if (::poll(&ready, 1, static_cast<int>(1000 * patience)) <= 0) return std::nullopt;
    std::string bytes(65536, '\0');
    const ssize_t count = ::recv(descriptor_, bytes.data(), bytes.size(), 0);
    bytes.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    return bytes;
  }

  int descriptor_;
  std::string left_;
};

struct LiveAddress {
  int port;
  std::string token;
  std::string host() const { return "127.0.0.1:" + std::to_string(port); }
};
/// Of "http://127.0.0.1:8080/?token=abc".
inline LiveAddress address_of(const std::string& url) {
  const std::size_t colon = url.find(':', 7), equals = url.find('=');
  return {std::atoi(url.c_str() + colon + 1), url.substr(equals + 1, 32)};
}

/// The answer to a request of these lines (without the last empty one).
inline std::string answer(int port, const std::string& lines) {
  Connection connection(port);
  connection.send(lines + "\r\n");
  return connection.read_all();
}
inline std::string get(const LiveAddress& address, const std::string& target, const std::string& more = "") {
  return answer(address.port, "GET " + target + " HTTP/1.1\r\nHost: " + address.host() + "\r\n" + more);
}
/// Status of an answer, 0 if there is none.
inline int status_of(const std::string& text) {
  return text.starts_with("HTTP/1.1 ") ? std::atoi(text.c_str() + 9) : 0;
}

/// A WebSocket to the simulation. Source: Fette and Melnikov, The WebSocket Protocol, RFC 6455, 2011,
/// section 5.
class LiveSocket {
 public:
  explicit LiveSocket(const LiveAddress& address, int receive_buffer = 0)
      : connection_(address.port, receive_buffer) {
    connection_.send("GET /live?token=" + address.token + " HTTP/1.1\r\nHost: " + address.host() +
                     "\r\nOrigin: http://" + address.host() +
                     "\r\nConnection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
                     "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n");
    status = status_of(connection_.read_head());
  }

  void send(const std::string& message, int opcode = 1) {
    std::string frame(1, static_cast<char>(0x80 | opcode));
    if (message.size() < 126) {
      frame += static_cast<char>(0x80 | message.size());
    } else {
      frame += static_cast<char>(0x80 | 126);
      frame += static_cast<char>(message.size() >> 8 & 0xff);
      frame += static_cast<char>(message.size() & 0xff);
    }
    // The mask of four zeros leaves the message as it is.
    connection_.send(frame + std::string(4, '\0') + message);
  }

  struct Message {
    int opcode;  ///< 1 text, 2 bytes, 8 the end.
    std::string bytes;
  };
  Message next() {
    const std::string head = connection_.read(2);
    std::uint64_t size = static_cast<unsigned char>(head[1]) & 127;
    const int length_bytes = size == 126 ? 2 : size == 127 ? 8 : 0;
    if (length_bytes > 0) {
      size = 0;
      for (const char c : connection_.read(static_cast<std::size_t>(length_bytes)))
        size = size << 8 | static_cast<unsigned char>(c);
    }
    return {head[0] & 15, connection_.read(static_cast<std::size_t>(size))};
  }
  /// The next message for which this holds; throws when none comes.
  template <typename Predicate>
  Message next(Predicate is_wanted) {
    for (int i = 0; i < 2000; ++i) {
      Message message = next();
      if (is_wanted(message)) return message;
      if (message.opcode == 8) break;
    }
    throw std::runtime_error("the message never came");
  }
  Connection& connection() { return connection_; }

  int status = 0;

 private:
  Connection connection_;
};

}  // namespace rigor::test
