#include "rigor/io/trajectory/json_writer.hpp"

#include "rigor/io/files/json_text.hpp"
#include "rigor/io/files/version.hpp"
#include "rigor/io/trajectory/audit_json.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace rigor {

namespace {

using Json = nlohmann::ordered_json;

/// Values as a list of rows.
Json rows(const std::vector<double>& values, std::size_t width) {
  Json list = Json::array();
  for (std::size_t i = 0; i < values.size(); i += width) {
    Json row = Json::array();
    for (std::size_t k = 0; k < width; ++k) row.push_back(values[i + k]);
    list.push_back(std::move(row));
  }
  return list;
}

/// Values as a list of rows of these lengths.
Json rows(const std::vector<double>& values, const std::vector<std::size_t>& lengths) {
  Json list = Json::array();
  auto first = values.begin();
  for (const std::size_t length : lengths) {
    const auto end = first + static_cast<std::ptrdiff_t>(length);
    list.push_back(std::vector<double>(first, end));
    first = end;
  }
  return list;
}

Json joints_json(const TrajectorySample& sample, const std::vector<std::size_t>& coordinate_counts) {
  Json joints = {{"coordinate", rows(sample.joint_coordinate, coordinate_counts)},
                 {"rate", rows(sample.joint_rate, coordinate_counts)}};
  if (!sample.joint_effort.empty()) joints["effort"] = rows(sample.joint_effort, coordinate_counts);
  if (sample.joint_force.empty()) return joints;
  joints["force"] = rows(sample.joint_force, 3);
  joints["torque"] = rows(sample.joint_torque, 3);
  return joints;
}

Json events_json(std::span<const MotionEvent> events) {
  Json list = Json::array();
  for (const MotionEvent& event : events) {
    list.push_back({{"time", event.time},
                    {"kind", event_kind_name(event.kind)},
                    {"bodies", {event.body_A, event.body_B}},
                    {"point", {event.p_W.x(), event.p_W.y(), event.p_W.z()}},
                    {"impulse", {event.j_W.x(), event.j_W.y(), event.j_W.z()}}});
  }
  return list;
}

}  // namespace

JsonWriter::JsonWriter(const std::filesystem::path& path, const TrajectoryHeader& header) : file_(path) {
  Json joints = Json::array();
  for (const TrajectoryJoint& joint : header.joints) {
    joints.push_back(joint.name);
    coordinate_counts_.push_back(joint.units.size());
  }
  file_.append(fmt::format("{{\n\"rigor\": {},\n\"scene\": {},\n\"bodies\": {},\n", json_line(version),
                           json_line(header.scene), json_line(header.bodies)));
  if (!joints.empty()) file_.append(fmt::format("\"joints\": {},\n", json_line(joints)));
  file_.append("\"trajectory\": [");
  file_.flush();
}

void JsonWriter::write(const TrajectorySample& sample, std::span<const MotionEvent> events) {
  const Json energy = {{"kinetic", sample.energy.kinetic},
                       {"potential", sample.energy.potential},
                       {"elastic", sample.energy.elastic}};
  Json row = {{"time", sample.time},
              {"position", rows(sample.position, 3)},
              {"orientation", rows(sample.orientation, 4)},
              {"velocity", rows(sample.velocity, 3)},
              {"angular_velocity", rows(sample.angular_velocity, 3)}};
  if (!coordinate_counts_.empty()) row["joints"] = joints_json(sample, coordinate_counts_);
  row["energy"] = energy;
  row["events"] = events_json(events);
  file_.append(is_first_ ? "\n" : ",\n");
  file_.append(json_line(row));
  is_first_ = false;
  if (flush_timer_.is_due() || file_.pending() > kMostPendingBytes) file_.flush();
}

void JsonWriter::close(const Audit& audit) {
  file_.append(fmt::format("\n],\n\"audit\": {}\n}}\n", audit_json(audit)));
  file_.close();
}

}  // namespace rigor
