#include "rigor/view/page/page_run.hpp"

#include "rigor/core/interrupt.hpp"
#include "rigor/io/files/version.hpp"
#include "rigor/io/trajectory/audit_json.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/view/page/page_geometry.hpp"
#include "rigor/view/page/page_json.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <utility>

namespace rigor {

namespace {

using Json = nlohmann::ordered_json;

/// How the values of two successive intervals combine.
enum class Joined { last, sum, largest };
struct Quantity {
  const char* name;
  const char* unit;
  Joined joined = Joined::last;
};
/// Columns of the series, in this order.
constexpr std::array quantities = {Quantity{"time", "s"},
                                   Quantity{"kinetic", "J"},
                                   Quantity{"potential", "J"},
                                   Quantity{"elastic", "J"},
                                   Quantity{"work", "J"},
                                   Quantity{"momentum", "kg m/s"},
                                   Quantity{"angular_momentum", "kg m²/s"},
                                   Quantity{"penetration", "m", Joined::largest},
                                   Quantity{"steps", "", Joined::sum},
                                   Quantity{"impacts", "", Joined::sum},
                                   Quantity{"iterations", "", Joined::largest}};

const char* motion_name(MotionType motion) {
  switch (motion) {
    case MotionType::dynamic:
      return "dynamic";
    case MotionType::kinematic:
      return "kinematic";
    case MotionType::fixed:
      return "static";
  }
  return "";
}

Json body_json(const Body& body, int look) {
  return {{"name", body.name},
          {"motion", motion_name(body.motion)},
          {"mass", body.mass},
          {"moments", json_of(body.moments)},
          {"radius", body.bounding_radius},
          {"frame", {{"p", json_of(body.X_BU.p)}, {"q", json_of(quaternion_of(body.X_BU.R))}}},
          {"start", {{"p", json_of(body.p_WB)}, {"q", json_of(body.q_WB)}}},
          {"look", look}};
}

Json bodies_json(const Model& model, const PageGeometry& geometry) {
  Json bodies = Json::array();
  for (std::size_t i = 0; i < model.bodies().size(); ++i) {
    poll_interrupt();
    bodies.push_back(body_json(model.bodies()[i], geometry.look_of_body[i]));
  }
  return bodies;
}

Json materials_json(const Model& model) {
  Json materials = Json::array();
  for (const Material& material : model.materials()) {
    materials.push_back({{"name", material.name},
                         {"density", material.density},
                         {"friction", material.friction},
                         {"restitution", material.restitution}});
  }
  return materials;
}

Json springs_json(const Model& model) {
  Json springs = Json::array();
  for (const Force& force : model.forces()) {
    const Spring* const spring = std::get_if<Spring>(&force);
    if (!spring) continue;
    springs.push_back({{"bodies", {spring->body_A, spring->body_B}},
                       {"points", {json_of(spring->p_AP), json_of(spring->p_BQ)}}});
  }
  return springs;
}

/// Direction of an axis of the joint fixed to its body A (side 0) or B; null if there is none on that side.
Json axis_json(const Joint& joint, std::size_t side) {
  const JointAxes axes = joint_traits(joint.type).axes;
  if (side == 0) return axes == JointAxes::none ? Json() : json_of(Vec3(joint.X_AF.R.col(2)));
  return axes == JointAxes::z_and_x_of_K ? json_of(Vec3(joint.X_BK.R.col(0))) : Json();
}

/// All joints that have an anchor; gears have none.
Json joints_json(const Model& model) {
  Json joints = Json::array();
  for (const Joint& joint : model.joints()) {
    if (joint_traits(joint.type).drawing == JointDrawing::nothing) continue;
    joints.push_back({{"name", joint.name},
                      {"type", joint_type_name(joint.type)},
                      {"bodies", {joint.body_A, joint.body_B}},
                      {"points", {json_of(joint.X_AF.p), json_of(joint.X_BK.p)}},
                      {"axes", {axis_json(joint, 0), axis_json(joint, 1)}}});
  }
  return joints;
}

Json series_json() {
  Json series = Json::array();
  for (const Quantity& quantity : quantities) {
    series.push_back({{"name", quantity.name}, {"unit", quantity.unit}});
  }
  return series;
}

}  // namespace

std::vector<TouchingPoint> known_contacts(const Model& model, const Method& method, const State& state,
                                          const AdvanceReport& since) {
  if (since.contacts) {
    if (std::optional<std::vector<TouchingPoint>> known = since.contacts(state)) return std::move(*known);
  }
  return contact_snapshot(model, method, state, most_contacts_solved);
}

PageRun::PageRun(const Scene& scene, const State& start, std::string label)
    : model_(scene.model),
      latest_model_(scene.model),
      method_(scene.method),
      run_(scene.run),
      name_(scene.name),
      label_(std::move(label)),
      scale_(page_scale(*scene.model, start)),
      frames_(*model_, scale_),
      contacts_(*model_, scale_, scene.method.contact_tolerance),
      series_(quantities.size()) {}

void PageRun::add(const State& state, const AdvanceReport& since, const Energy& energy) {
  add(state, since, energy, known_contacts(*model_, method_, state, since));
}

void PageRun::add(const State& state, const AdvanceReport& since, const Energy& energy,
                  std::vector<TouchingPoint> contacts) {
  const std::shared_ptr<const State> phases = phases_of(state);
  keep(frames_.add(phases));
  keep(contacts_.add(std::move(contacts), phases));
  // One row of the series, in the order of `quantities`.
  work_ += since.work;
  const Momentum momentum = total_momentum(*latest_model_, state);
  const std::array<double, quantities.size()> row = {state.t,
                                                     energy.kinetic,
                                                     energy.potential,
                                                     energy.elastic,
                                                     work_,
                                                     momentum.linear.norm(),
                                                     momentum.angular.norm(),
                                                     since.max_penetration,
                                                     static_cast<double>(since.steps),
                                                     static_cast<double>(since.impacts),
                                                     static_cast<double>(since.max_iterations)};
  for (std::size_t i = 0; i < row.size(); ++i) series_[i].push_back(row[i]);
  events_.insert(events_.end(), since.events.begin(), since.events.end());
}

std::vector<double> PageRun::last_row() const {
  std::vector<double> row;
  for (const std::vector<double>& column : series_) row.push_back(column.empty() ? 0 : column.back());
  return row;
}

std::vector<MotionEvent> strongest_events(const std::vector<MotionEvent>& events, std::size_t most) {
  if (events.size() <= most) return events;
  std::vector<std::size_t> places(events.size());
  std::iota(places.begin(), places.end(), 0);
  const auto size = [&](std::size_t i) { return events[i].j_W.allFinite() ? events[i].j_W.norm() : 0; };
  std::nth_element(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(most), places.end(),
                   [&](std::size_t a, std::size_t b) {
                     const double first = size(a), second = size(b);
                     return first != second ? first > second : a < b;
                   });
  places.resize(most);
  std::sort(places.begin(), places.end());
  std::vector<MotionEvent> kept;
  kept.reserve(places.size());
  for (const std::size_t i : places) kept.push_back(events[i]);
  return kept;
}

std::vector<PageBlock> PageRun::finish(const Audit& audit) {
  events_ = strongest_events(events_, most_page_events);
  const PageGeometry geometry = page_geometry(*model_);
  // The frames hold the final poses of the bodies.
  Audit without_bodies = audit;
  without_bodies.bodies.clear();
  Json audit_of_run = Json::parse(audit_json(without_bodies));
  audit_of_run.erase("bodies");
  Json header = {{"format", 2},
                 {"rigor", version},
                 {"scene", name_},
                 {"duration", run_.duration},
                 {"step", run_.step},
                 {"output_interval", run_.output_interval},
                 {"gravity", json_of(latest_model_->g_W())},
                 {"origin", json_of(scale_.origin)},
                 {"extent", scale_.extent},
                 {"position_step", scale_.position_step},
                 {"position_error", 0.5 * scale_.position_step},
                 {"orientation_parts", scale_.orientation_parts},
                 {"orientation_error", packing_error_of(scale_.orientation_parts)},
                 {"contact_tolerance", method_.contact_tolerance},
                 {"frames", frames_.frame_count()},
                 {"events", events_.size()},
                 {"series", series_json()},
                 {"bodies", bodies_json(*model_, geometry)},
                 {"looks", geometry.looks},
                 {"meshes", geometry.meshes},
                 {"materials", materials_json(*latest_model_)},
                 {"springs", springs_json(*latest_model_)},
                 {"joints", joints_json(*model_)},
                 {"audit", audit_of_run}};
  // On a page of several runs, each says its label and why it stopped.
  if (!label_.empty()) {
    header["label"] = label_;
    if (audit.report.reason != StopReason::reached_end) header["stopped"] = audit.report.detail;
  }
  // The blocks of the run: header, meshes, series, events, then the chunks of frames and contacts.
  std::vector<PageBlock> blocks = {
      make_page_block("header", header.dump(-1, ' ', false, Json::error_handler_t::replace)),
      make_page_block("meshes", geometry.mesh_bytes), series_block(), events_block()};
  keep(frames_.finish());
  keep(contacts_.finish());
  for (const std::shared_future<PageBlock>& chunk : chunks_) {
    poll_interrupt();
    blocks.push_back(chunk.get());
  }
  return blocks;
}

void PageRun::keep(std::optional<PagePacking> chunk) {
  if (!chunk) return;
  // Two are packed at a time, so that a run which is quicker than its page does not fill the memory.
  if (chunks_.size() > 1) chunks_[chunks_.size() - 2].wait();
  chunks_.push_back(std::async(std::launch::async, std::move(*chunk)).share());
}

PageBlock PageRun::series_block() const {
  std::string bytes;
  for (const std::vector<double>& column : series_) append_exact_column(column, bytes);
  return make_page_block("series", bytes);
}

PageBlock PageRun::events_block() const {
  // Steps of times and impulses; points take the step of positions.
  double largest = 0;
  std::vector<std::int64_t> times;
  const double time_step = power_of_two_below(1e-9 * run_.output_interval);
  for (const MotionEvent& event : events_) {
    times.push_back(quantised(event.time, time_step));
    if (event.j_W.allFinite()) largest = std::max(largest, event.j_W.norm());
  }
  const double impulse_step = largest > 1e-300 ? power_of_two_below(largest / 32768) : 1;
  std::string bytes;
  // Columns of times, points, impulses, then bodies and kinds.
  append_f64(time_step, bytes);
  append_f64(impulse_step, bytes);
  append_column(times, bytes);
  for (const MotionEvent& event : events_) {
    for (int k = 0; k < 3; ++k)
      append_varint(quantised(event.p_W[k] - scale_.origin[k], scale_.position_step), bytes);
  }
  for (const MotionEvent& event : events_) {
    for (const double j : event.j_W) append_varint(quantised(j, impulse_step), bytes);
  }
  for (const MotionEvent& event : events_) {
    append_varint(event.body_A, bytes);
    append_varint(event.body_B, bytes);
    append_varint(static_cast<std::int64_t>(event.kind), bytes);
  }
  return make_page_block("events", bytes);
}

std::vector<double> joined_rows(const std::vector<double>& earlier, const std::vector<double>& later) {
  std::vector<double> row = later;
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    if (quantities[i].joined == Joined::sum) row[i] += earlier[i];
    if (quantities[i].joined == Joined::largest) row[i] = std::max(row[i], earlier[i]);
  }
  return row;
}

}  // namespace rigor
