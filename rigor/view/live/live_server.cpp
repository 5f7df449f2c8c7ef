#include "rigor/view/live/live_server.hpp"

#include "rigor/core/input_error.hpp"
#include "rigor/io/files/file_error.hpp"
#include "rigor/io/files/json_text.hpp"
#include "rigor/view/live/live_access.hpp"
#include "rigor/view/page/page_writer.hpp"

#include <fmt/format.h>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <nlohmann/json.hpp>

#include <atomic>
#include <chrono>
#include <deque>
#include <map>
#include <optional>
#include <utility>

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

namespace rigor {

namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using asio::ip::tcp;
using boost::system::error_code;
using Clock = std::chrono::steady_clock;
using Text = std::shared_ptr<const std::string>;

Clock::duration seconds(double span) {
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(span));
}

std::string_view view_of(beast::string_view text) {
  return {text.data(), text.size()};
}

constexpr std::size_t most_replies = 16;  // waiting for a slow client

}  // namespace

/// Everything here runs on the serving thread, except notify() and reply(), which the simulation's thread
/// calls.
class LiveServer::Impl {
 public:
  Impl(std::uint16_t port, const LiveLimits& limits);
  void serve(const std::function<bool()>& should_end);
  std::string url() const { return access_.url(); }

  /// An HTTP connection, until its request has been answered.
  class Request;
  /// A connection that has become a WebSocket.
  class Socket;

  void accept();
  void watch(const std::function<bool()>& should_end);
  void send_newest();
  void deliver(const LiveReply& reply);
  void update_watched() { simulation->set_watched(!sockets.empty()); }
  /// The page at a path; null if there is none.
  Text page(std::string_view path, std::string_view host);
  /// Lets requests for more pages than one through.
  void offer(const LivePages& given);

  /// Connections that have not shown the token, the oldest first. They leave this list when they end, some of
  /// them together with the context.
  std::map<std::uint64_t, std::weak_ptr<Request>> strangers;
  asio::io_context context{1};
  tcp::acceptor acceptor{context};
  asio::steady_timer accept_timer{context}, watch_timer{context};
  Clock::time_point next_accept;
  const LiveLimits limits;
  LiveAccess access_;
  LiveSimulation* simulation = nullptr;
  std::string title;             ///< Title of the page of a recorded run.
  std::vector<PageBlock> still;  ///< Data of that page.
  const LivePages* pages = nullptr;
  std::uint64_t last_number = 0;
  std::map<std::uint64_t, std::shared_ptr<Socket>> sockets;
  std::atomic<bool> is_notified{false};

 private:
  void open(std::uint16_t port);
};

/// Sends frames, history, status and answers to a browser, and receives commands from it. Whatever has not
/// been sent when something newer arrives is dropped, so a slow client loses nothing but pictures of its own.
class LiveServer::Impl::Socket : public std::enable_shared_from_this<Socket> {
 public:
  Socket(Impl& server, std::uint64_t number, beast::tcp_stream stream)
      : server_(server), number_(number), stream_(std::move(stream)), buffer_(server.limits.message_bytes) {}

  void begin(const http::request<http::empty_body>& request) {
    beast::get_lowest_layer(stream_).expires_never();
    websocket::stream_base::timeout timeout{};
    timeout.handshake_timeout = seconds(server_.limits.request_time);
    timeout.idle_timeout = seconds(server_.limits.idle_time);
    timeout.keep_alive_pings = true;
    stream_.set_option(timeout);
    stream_.read_message_max(server_.limits.message_bytes);
    stream_.async_accept(request, [self = shared_from_this()](error_code error) {
      if (error) return self->end();
      self->is_open_ = true;
      self->read();
      self->send();
    });
  }

  /// Sends the newest data unless something is still being sent.
  void send() {
    if (!is_open_ || on_its_way_) return;
    const LiveSnapshot newest = server_.simulation->newest();
    if (!replies_.empty()) {
      is_text_ = replies_.front().is_text;
      is_reply_ = true;
      on_its_way_ = std::make_shared<const std::string>(std::move(replies_.front().bytes));
      replies_.pop_front();
    } else if (newest.status != status_) {
      is_text_ = true;
      on_its_way_ = status_ = newest.status;
    } else if (newest.history != history_) {
      is_text_ = false;
      on_its_way_ = history_ = newest.history;
    } else if (newest.frame != frame_) {
      is_text_ = false;
      on_its_way_ = frame_ = newest.frame;
    } else {
      return;
    }
    stream_.text(is_text_);
    stream_.async_write(asio::buffer(*on_its_way_),
                        [self = shared_from_this()](error_code error, std::size_t) {
                          self->on_its_way_.reset();
                          if (std::exchange(self->is_reply_, false)) self->awaits_file_ = false;
                          if (error) return self->end();
                          self->send();
                        });
  }

  void reply(LiveReply reply) {
    if (replies_.size() >= most_replies) return;
    replies_.push_back(std::move(reply));
    send();
  }

  void close() { beast::get_lowest_layer(stream_).close(); }

 private:
  void read() {
    buffer_.clear();
    stream_.async_read(buffer_, [self = shared_from_this()](error_code error, std::size_t) {
      if (error) return self->end();
      if (!self->is_within_rate()) return self->end();
      self->take(beast::buffers_to_string(self->buffer_.data()));
      self->read();
    });
  }

  bool is_within_rate() {
    const Clock::time_point now = Clock::now();
    if (now - second_ > std::chrono::seconds(1)) {
      second_ = now;
      messages_ = 0;
    }
    return ++messages_ <= server_.limits.messages;
  }

  void take(const std::string& message) {
    try {
      if (!stream_.got_text()) throw InputError("commands are texts");
      LiveCommand command = parse_live_command(message);
      const bool wants_file =
          std::holds_alternative<live::Save>(command) || std::holds_alternative<live::Export>(command);
      if (wants_file && awaits_file_) throw InputError("a file is still on its way");
      awaits_file_ |= wants_file;
      if (!server_.simulation->post(number_, std::move(command)))
        throw InputError("the simulation is busy; the command was not taken");
    } catch (const InputError& error) {
      const nlohmann::ordered_json text = {{"type", "error"}, {"messages", error.messages()}};
      reply({number_, true, json_line(text)});
    }
  }

  void end() {
    is_open_ = false;
    close();
    if (server_.sockets.erase(number_) == 0) return;
    server_.simulation->post(number_, live::Release{});
    server_.update_watched();
  }

  Impl& server_;
  std::uint64_t number_;
  websocket::stream<beast::tcp_stream, false> stream_;  ///< Without compression.
  beast::flat_buffer buffer_;
  bool is_open_ = false, is_text_ = false,
       is_reply_ = false;  ///< The last two describe the message being sent.
  bool awaits_file_ = false;
  Text on_its_way_, status_, history_, frame_;  ///< The last three: as sent last.
  std::deque<LiveReply> replies_;
  Clock::time_point second_;
  int messages_ = 0;
};

class LiveServer::Impl::Request : public std::enable_shared_from_this<Request> {
 public:
  Request(Impl& server, std::uint64_t number, tcp::socket socket)
      : server_(server),
        number_(number),
        stream_(std::move(socket)),
        buffer_(server.limits.header_bytes + 1024) {
    parser_.header_limit(static_cast<std::uint32_t>(server.limits.header_bytes));
  }
  ~Request() { server_.strangers.erase(number_); }

  void begin() {
    stream_.expires_after(seconds(server_.limits.request_time));
    http::async_read_header(
        stream_, buffer_, parser_,
        [self = shared_from_this()](error_code error, std::size_t) { self->judge(error); });
  }
  void close() { stream_.close(); }

 private:
  void judge(error_code error) {
    if (error == http::error::header_limit || error == http::error::buffer_overflow)
      return refuse(431, "The header is too long.");
    if (error == http::error::body_limit) return refuse(413, "Requests with a body are not taken.");
    if (error.category() == http::make_error_code(http::error::bad_method).category() &&
        error != http::error::end_of_stream && error != http::error::partial_message)
      return refuse(400, "This is not HTTP.");
    if (error) return;
    const http::request<http::empty_body>& request = parser_.get();
    host_ = std::string(view_of(request[http::field::host]));
    const std::string method(view_of(request.method_string())), target(view_of(request.target()));
    const std::string origin(view_of(request[http::field::origin]));
    const LiveAccess::Verdict verdict =
        server_.access_.judge({.method = method,
                               .target = target,
                               .host = host_,
                               .origin = origin,
                               .is_upgrade = websocket::is_upgrade(request),
                               .has_body = parser_.chunked() || parser_.content_length().value_or(0) > 0});
    switch (verdict.resource) {
      case LiveAccess::Resource::none:
        return refuse(verdict.status, verdict.words);
      case LiveAccess::Resource::script:
        return respond_with_script(verdict.path);
      case LiveAccess::Resource::page:
        server_.strangers.erase(number_);
        text_ = server_.page(verdict.path, host_);
        if (!text_) return refuse(404, "There is no such page.");
        policy_ = live_policy(host_);
        return respond(200, "text/html; charset=utf-8", *text_);
      case LiveAccess::Resource::socket:
        return become_socket();
    }
  }

  void respond_with_script(std::string_view path) {
    const std::optional<std::string_view> script =
        path == "/viewer.js" ? std::optional(viewer_script()) : server_.pages->script(path);
    if (!script) return refuse(404, "There is no such script.");
    script_ = *script;
    respond(200, "text/javascript; charset=utf-8", script_);
  }

  void become_socket() {
    if (!server_.simulation) return refuse(404, "This page stands still.");
    if (server_.sockets.size() >= server_.limits.sockets) return refuse(503, "Too many pages are open.");
    const auto socket = std::make_shared<Socket>(server_, number_, std::move(stream_));
    server_.strangers.erase(number_);
    server_.sockets[number_] = socket;
    server_.update_watched();
    socket->begin(parser_.get());
  }

  void refuse(unsigned status, std::string_view words) {
    text_ = std::make_shared<const std::string>(fmt::format("{}\n", words));
    respond(status, "text/plain; charset=utf-8", *text_);
  }

  void respond(unsigned status, const char* type, std::string_view body) {
    response_.result(status);
    response_.version(11);
    response_.set(http::field::content_type, type);
    response_.set(http::field::cache_control, "no-store");
    response_.set("Content-Security-Policy", policy_ + "; frame-ancestors 'none'");
    response_.set("X-Content-Type-Options", "nosniff");
    response_.set("Referrer-Policy", "no-referrer");
    response_.set("Cross-Origin-Resource-Policy", "same-origin");
    response_.set("Cross-Origin-Opener-Policy", "same-origin");
    response_.keep_alive(false);
    response_.body() = {body.data(), body.size()};
    response_.prepare_payload();
    stream_.expires_after(seconds(server_.limits.response_time));
    http::async_write(stream_, response_, [self = shared_from_this()](error_code, std::size_t) {
      error_code ignored;
      self->stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
    });
  }

  Impl& server_;
  std::uint64_t number_;
  beast::tcp_stream stream_;
  beast::flat_buffer buffer_;
  http::request_parser<http::empty_body> parser_;
  http::response<http::span_body<const char>> response_;
  std::string host_, policy_ = "default-src 'none'";
  std::string_view script_;
  Text text_;  ///< Keeps the body alive while it is sent.
};

LiveServer::Impl::Impl(std::uint16_t port, const LiveLimits& given) : limits(given), access_(0, "") {
  open(port);
  access_ = LiveAccess(acceptor.local_endpoint().port(), make_live_token());
}

void LiveServer::Impl::open(std::uint16_t port) {
  const tcp::endpoint endpoint(asio::ip::address_v4::loopback(), port);
  error_code error;
  acceptor.open(endpoint.protocol(), error);
  // A port that was in use a moment ago may be reused; one that is still in use may not.
  if (!error) acceptor.set_option(tcp::acceptor::reuse_address(true), error);
  if (!error) acceptor.bind(endpoint, error);
  if (!error) acceptor.listen(asio::socket_base::max_listen_connections, error);
#ifdef TCP_DEFER_ACCEPT
  // Where the system can, it keeps connections to itself until they have sent something: idle ones cost
  // nothing and stand in nobody's way.
  const int patience = static_cast<int>(limits.request_time);
  if (!error && patience > 0)
    ::setsockopt(acceptor.native_handle(), IPPROTO_TCP, TCP_DEFER_ACCEPT, &patience, sizeof patience);
#endif
  if (error) {
    throw FileError(fmt::format("cannot serve on port {} of 127.0.0.1: {}; choose another --port, or none",
                                port, error.message()));
  }
}

/// After a burst, connections are accepted with a pause between them, so that a flood of them costs little
/// time; when too many have not shown the token, the oldest of these is closed.
void LiveServer::Impl::accept() {
  acceptor.async_accept([this](error_code error, tcp::socket socket) {
    if (error == asio::error::operation_aborted) return;
    if (!error) {
      if (strangers.size() >= limits.connections) {
        if (const std::shared_ptr<Request> oldest = strangers.begin()->second.lock()) oldest->close();
        strangers.erase(strangers.begin());
      }
      const std::uint64_t number = ++last_number;
      const auto request = std::make_shared<Request>(*this, number, std::move(socket));
      strangers[number] = request;
      request->begin();
    }
    const Clock::time_point now = Clock::now();
    next_accept = std::max(next_accept, now - limits.burst * seconds(limits.accept_pause)) +
                  seconds(limits.accept_pause);
    if (next_accept <= now) return accept();
    accept_timer.expires_at(next_accept);
    accept_timer.async_wait([this](error_code stopped) {
      if (!stopped) accept();
    });
  });
}

void LiveServer::Impl::watch(const std::function<bool()>& should_end) {
  watch_timer.expires_after(std::chrono::milliseconds(50));
  watch_timer.async_wait([this, &should_end](error_code error) {
    if (error || should_end()) return context.stop();
    watch(should_end);
  });
}

void LiveServer::Impl::serve(const std::function<bool()>& should_end) {
  accept();
  watch(should_end);
  context.run();
  for (const auto& [number, socket] : sockets) socket->close();
}

void LiveServer::Impl::send_newest() {
  is_notified = false;
  for (const auto& [number, socket] : sockets) socket->send();
}

void LiveServer::Impl::deliver(const LiveReply& reply) {
  const auto found = sockets.find(reply.client);
  if (found != sockets.end()) found->second->reply(reply);
}

void LiveServer::Impl::offer(const LivePages& given) {
  pages = &given;
  access_ = LiveAccess(acceptor.local_endpoint().port(), access_.token(), true);
}

Text LiveServer::Impl::page(std::string_view path, std::string_view host) {
  if (pages) {
    std::optional<std::string> text = pages->page(path, live_policy(host));
    return text ? std::make_shared<const std::string>(*std::move(text)) : nullptr;
  }
  ServedPage served{.policy = live_policy(host), .script = "/viewer.js"};
  if (!simulation) return std::make_shared<const std::string>(page_text(title + " · Rigor", {still}, served));
  const LiveSnapshot newest = simulation->newest();
  served.mark = fmt::format("{}", newest.generation);
  return std::make_shared<const std::string>(page_text(newest.scene + " · Rigor", {*newest.blocks}, served));
}

LiveServer::LiveServer(std::uint16_t port, const LiveLimits& limits)
    : impl_(std::make_unique<Impl>(port, limits)) {}
LiveServer::~LiveServer() = default;

void LiveServer::notify() {
  if (impl_->is_notified.exchange(true)) return;
  asio::post(impl_->context, [impl = impl_.get()] { impl->send_newest(); });
}

void LiveServer::reply(LiveReply reply) {
  asio::post(impl_->context, [impl = impl_.get(), reply = std::move(reply)] { impl->deliver(reply); });
}

std::string LiveServer::url() const {
  return impl_->url();
}

void LiveServer::serve(LiveSimulation& simulation, const std::function<bool()>& should_end) {
  impl_->simulation = &simulation;
  impl_->serve(should_end);
}

void LiveServer::serve(const std::string& title, std::vector<PageBlock> blocks,
                       const std::function<bool()>& should_end) {
  impl_->title = title;
  impl_->still = std::move(blocks);
  impl_->serve(should_end);
}

void LiveServer::serve(const LivePages& pages, const std::function<bool()>& should_end) {
  impl_->offer(pages);
  impl_->serve(should_end);
}

}  // namespace rigor
