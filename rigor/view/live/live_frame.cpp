#include "rigor/view/live/live_frame.hpp"

#include "rigor/view/page/page_block.hpp"
#include "rigor/view/page/page_contacts.hpp"

#include <algorithm>

namespace rigor {

namespace {

constexpr std::uint32_t frame_kind = 1, file_kind = 2;

void append_vector(const Vec3& v, std::string& bytes) {
  for (const double x : v) append_f32(static_cast<float>(x), bytes);
}

void append_body(const LiveFrame& frame, int body, std::string& bytes) {
  const Quat q = frame.state.orientation(body);
  append_vector(frame.state.position(body) - frame.origin, bytes);
  append_vector(q.vec(), bytes);
  append_f32(static_cast<float>(q.w()), bytes);
  append_vector(linear_velocity(frame.model, frame.state, body), bytes);
  append_vector(angular_velocity(frame.model, frame.state, body), bytes);
}

void append_contact(const TouchingPoint& point, const Vec3& origin, std::string& bytes) {
  append_u32(static_cast<std::uint32_t>(point.body_A), bytes);
  append_u32(static_cast<std::uint32_t>(point.body_B), bytes);
  append_u32(static_cast<std::uint32_t>(point.mode), bytes);
  append_f32(static_cast<float>(point.gap), bytes);
  append_vector(point.p_W - origin, bytes);
  append_vector(point.n_W, bytes);
  append_vector(point.force_W.allFinite() ? point.force_W : Vec3::Zero(), bytes);
}

}  // namespace

std::string live_frame_bytes(const LiveFrame& frame) {
  std::vector<int> moving;
  for (int i = 0; i < frame.model.body_count(); ++i) {
    if (frame.model.body(i).motion != MotionType::fixed) moving.push_back(i);
  }
  const std::size_t contacts = std::min(frame.contacts.size(), PageContacts::most_in_frame);
  std::string bytes;
  for (const std::size_t count :
       {std::size_t{frame_kind}, std::size_t{frame.generation}, moving.size(), contacts, frame.series.size()})
    append_u32(static_cast<std::uint32_t>(count), bytes);
  append_f64(frame.state.t, bytes);
  for (const double value : frame.series) append_f64(value, bytes);
  for (const int body : moving) append_body(frame, body, bytes);
  for (std::size_t i = 0; i < contacts; ++i) append_contact(frame.contacts[i], frame.origin, bytes);
  return bytes;
}

std::string live_file_bytes(std::string_view name, std::string_view bytes) {
  std::string message;
  append_u32(file_kind, message);
  append_u32(static_cast<std::uint32_t>(name.size()), message);
  message.append(name).append(bytes);
  return message;
}

}  // namespace rigor
