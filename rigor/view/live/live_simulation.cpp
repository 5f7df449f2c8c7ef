#include "rigor/view/live/live_simulation.hpp"

#include "rigor/core/input_error.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/io/files/json_text.hpp"
#include "rigor/view/live/live_frame.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <exception>
#include <type_traits>
#include <utility>

namespace rigor {

namespace {

using Json = nlohmann::ordered_json;
using Seconds = std::chrono::duration<double>;

constexpr Seconds frame_interval{1.0 / 60};
constexpr Seconds file_interval{0.5};
constexpr Seconds rate_interval{0.5}, status_interval{0.25}, history_interval{0.25};
/// A pause, reset or reload breaks off a step that has lasted this long: it is undone.
constexpr Seconds patience{0.2};
/// If the simulation is farther behind the clock than this, it does not try to catch up.
constexpr Seconds most_behind{0.1};

std::string error_text(const std::vector<std::string>& messages) {
  return json_line(Json{{"type", "error"}, {"messages", messages}});
}

/// File names consist of letters, digits and "-_." only, whatever the name of the scene.
std::string file_name(const std::string& scene, double time, const char* suffix) {
  std::string name = fmt::format("{}-{:.4g}s", scene.substr(0, 60), time);
  for (char& c : name) {
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                          c == '-' || c == '_' || c == '.';
    if (!is_plain) c = '_';
  }
  return name + suffix;
}

/// Whether a command ends or replaces what is being computed.
bool is_urgent(const LiveCommand& command) {
  return std::holds_alternative<live::Pause>(command) || std::holds_alternative<live::Reset>(command) ||
         std::holds_alternative<live::Reload>(command);
}

/// What can be set of the coordinates of the joints: a motor of each, and where its spring rests.
Json axes_json(const LiveRun& run) {
  constexpr std::size_t most_axes = 60;
  Json axes = Json::array();
  const std::vector<Joint>& joints = run.scene().model->joints();
  for (std::size_t j = 0; j < joints.size(); ++j) {
    if (joints[j].type == JointType::distance) continue;
    for (std::size_t k = 0; k < joints[j].axes.size() && axes.size() < most_axes; ++k) {
      const JointAxis& laws = run.laws(static_cast<int>(j), static_cast<int>(k));
      axes.push_back({{"joint", j},
                      {"coordinate", k},
                      {"name", joints[j].name},
                      {"unit", is_angle(joints[j].type, static_cast<int>(k)) ? "rad" : "m"},
                      {"motor", laws.motor ? Json(laws.motor->velocity) : Json()},
                      {"rest", laws.stiffness > 0 ? Json(laws.rest) : Json()}});
    }
  }
  return axes;
}

Json vector_json(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

}  // namespace

LiveSimulation::LiveSimulation(LiveFile file, std::function<void()> notify,
                               std::function<void(LiveReply)> reply)
    : file_(std::move(file)), notify_(std::move(notify)), reply_(std::move(reply)) {
  Scene scene = file_.read();
  warnings_ = scene.warnings;
  begin_run(std::move(scene));
  publish_frame();
  publish_status();
  thread_ = std::thread([this] { run(); });
}

LiveSimulation::~LiveSimulation() {
  {
    const std::lock_guard lock(mutex_);
    is_ending_ = true;  // Under the mutex, so that a wait that begins now sees it.
  }
  wake_.notify_one();
  thread_.join();
}

bool LiveSimulation::post(std::uint64_t client, LiveCommand command) {
  {
    const std::lock_guard lock(mutex_);
    Request* const last = requests_.empty() ? nullptr : &requests_.back();
    if (last && last->client == client && std::holds_alternative<live::Pull>(command) &&
        std::holds_alternative<live::Pull>(last->command)) {
      last->command = std::move(command);
      return true;
    }
    if (requests_.size() >= most_waiting && !std::holds_alternative<live::Release>(command)) return false;
    if (is_urgent(command)) is_urgent_ = true;
    requests_.push_back({client, std::move(command)});
  }
  wake_.notify_one();
  return true;
}

LiveSnapshot LiveSimulation::newest() const {
  const std::lock_guard lock(mutex_);
  return newest_;
}

void LiveSimulation::set_watched(bool is_watched) {
  {
    const std::lock_guard lock(mutex_);
    is_watched_ = is_watched;
  }
  wake_.notify_one();
}

bool LiveSimulation::should_break_off() const {
  return is_ending_ || (is_urgent_ && Clock::now() - busy_since_ > patience);
}

void LiveSimulation::begin_run(Scene scene) {
  run_ = std::make_unique<LiveRun>(std::move(scene));
  run_->set_interrupt([this] { return should_break_off(); });
}

void LiveSimulation::run() {
  // What is read or drawn is broken off at the end only.
  const std::function<bool()> ends = [this] { return is_ending_.load(); };
  const InterruptScope scope(ends);
  pace_anew();
  while (!is_ending_) {
    try {
      work();
    } catch (const Interrupted&) {
      return;
    } catch (const std::exception& error) {
      // A defect of the program, or no memory: the page says so, and the next command may help.
      is_running_ = false;
      frame_is_new_ = false;
      failure_ = error.what();
      status_is_new_ = true;
    }
    wait();
  }
}

/// What is due now.
void LiveSimulation::work() {
  carry_out_requests();
  look_at_file();
  if (is_running_) go_on();
  if (frame_is_new_ && Clock::now() - published_ >= frame_interval) publish_frame();
  if (run_->history().revision() != history_revision_ && Clock::now() - remembered_ >= history_interval)
    publish_history();
  if (status_is_new_ || Clock::now() - told_ >= status_interval) publish_status();
}

/// Waits until the next step or check of the file is due, a request arrives or a viewer connects.
void LiveSimulation::wait() {
  const auto after = [](Clock::time_point from, Seconds span) {
    return from + std::chrono::duration_cast<Clock::duration>(span);
  };
  Clock::time_point due = after(looked_at_file_, file_interval);
  if (is_running_) due = std::min(due, after(paced_from_, Seconds((run_->time() - pace_time_) / speed_)));
  std::unique_lock lock(mutex_);
  const bool was_watched = is_watched_;
  if (frame_is_new_ && was_watched) due = std::min(due, after(published_, frame_interval));
  const bool history_is_new = run_->history().revision() != history_revision_;
  if (history_is_new && was_watched) due = std::min(due, after(remembered_, history_interval));
  wake_.wait_until(lock, due, [this, was_watched] {
    return is_ending_ || !requests_.empty() || is_watched_ != was_watched;
  });
}

void LiveSimulation::carry_out_requests() {
  while (true) {
    Request request;
    {
      const std::lock_guard lock(mutex_);
      if (requests_.empty() || is_ending_) return;
      request = std::move(requests_.front());
      requests_.pop_front();
      is_urgent_ = std::any_of(requests_.begin(), requests_.end(),
                               [](const Request& waiting) { return is_urgent(waiting.command); });
      failure_.clear();
    }
    carry_out(request);
  }
}

void LiveSimulation::carry_out(const Request& request) {
  status_is_new_ = true;
  busy_since_ = Clock::now();
  try {
    apply(request.command, request.client);
    frame_is_new_ = true;
  } catch (const InputError& error) {
    reply_({request.client, true, error_text(error.messages())});
  } catch (const std::exception& error) {
    // For example the memory for a huge recording: the simulation itself is unaffected.
    reply_({request.client, true, error_text({error.what()})});
  }
}

void LiveSimulation::apply(const LiveCommand& command, std::uint64_t client) {
  const auto apply_one = [this, client](const auto& one) {
    using Command = std::decay_t<decltype(one)>;
    if constexpr (std::is_same_v<Command, live::Run>) {
      is_running_ = true;
    } else if constexpr (std::is_same_v<Command, live::Pause>) {
      is_running_ = false;
    } else if constexpr (std::is_same_v<Command, live::Step>) {
      is_running_ = false;
      run_->step();
    } else if constexpr (std::is_same_v<Command, live::Back>) {
      is_running_ = false;
      run_->go_back();
    } else if constexpr (std::is_same_v<Command, live::Reset>) {
      run_->reset();
    } else if constexpr (std::is_same_v<Command, live::Reload>) {
      reload();
    } else if constexpr (std::is_same_v<Command, live::Follow>) {
      follows_file_ = one.value;
    } else if constexpr (std::is_same_v<Command, live::Speed>) {
      speed_ = one.value;
    } else if constexpr (std::is_same_v<Command, live::Gravity>) {
      run_->set_gravity(one.value);
    } else if constexpr (std::is_same_v<Command, live::Surface>) {
      run_->set_surface(one.material, one.friction, one.restitution);
    } else if constexpr (std::is_same_v<Command, live::TargetStep>) {
      run_->set_target_step(one.value);
    } else if constexpr (std::is_same_v<Command, live::MethodValue>) {
      run_->set_method(one.key, one.value);
    } else if constexpr (std::is_same_v<Command, live::Pull>) {
      run_->pull(one.pull);
      puller_ = client;
    } else if constexpr (std::is_same_v<Command, live::Release>) {
      if (client == puller_) run_->release();
    } else if constexpr (std::is_same_v<Command, live::Push>) {
      run_->push(one.body, one.p_BP, one.j_W);
    } else if constexpr (std::is_same_v<Command, live::Motor>) {
      run_->set_motor(one.joint, one.coordinate, one.velocity);
    } else if constexpr (std::is_same_v<Command, live::Rest>) {
      run_->set_rest(one.joint, one.coordinate, one.value);
    } else if constexpr (std::is_same_v<Command, live::Save>) {
      const std::string name = file_name(run_->scene().name, run_->time(), ".checkpoint");
      reply_({client, false, live_file_bytes(name, run_->checkpoint())});
    } else {
      static_assert(std::is_same_v<Command, live::Export>);
      const std::string name = file_name(run_->scene().name, run_->time(), ".html");
      reply_({client, false, live_file_bytes(name, run_->page())});
    }
  };
  std::visit(apply_one, command);
  pace_anew();
}

void LiveSimulation::look_at_file() {
  if (Clock::now() - looked_at_file_ < file_interval) return;
  looked_at_file_ = Clock::now();
  const bool had_changed = file_has_changed_;
  file_has_changed_ = file_.has_changed();
  if (!file_has_changed_ || had_changed || !follows_file_) return;
  try {
    reload();
  } catch (const InputError&) {
    // The status reports the error; the old scene continues.
  }
}

void LiveSimulation::reload() {
  try {
    file_has_changed_ = false;
    begin_run(file_.read());
    file_messages_.clear();
  } catch (const InputError& error) {
    file_messages_ = error.messages();
    throw;
  }
  ++generation_;
  history_revision_ = 0;
  status_is_new_ = true;
  pace_anew();
  publish_frame();
}

/// Advances as far as the clock, times the speed, has come, in parts no longer than a frame.
void LiveSimulation::go_on() {
  const Clock::time_point begin = Clock::now();
  const Seconds passed = begin - paced_from_;
  const double wanted = pace_time_ + speed_ * passed.count();
  const double longest = std::min(run_->scene().run.output_interval, speed_ * frame_interval.count());
  // The loop returns before long, so that requests are served.
  const Clock::time_point until = begin + std::chrono::duration_cast<Clock::duration>(frame_interval);
  while (run_->time() < wanted && run_->stop_text().empty() && Clock::now() < until) {
    busy_since_ = Clock::now();
    run_->advance(longest);
    frame_is_new_ = true;
    if (should_break_off()) return;
  }
  if (!run_->stop_text().empty()) is_running_ = false;
  if (wanted - run_->time() > speed_ * most_behind.count()) pace_anew();
  const Seconds rated = Clock::now() - rated_from_;
  if (rated < rate_interval) return;
  rate_ = std::max(0.0, run_->time() - rate_time_) / rated.count();
  rate_time_ = run_->time();
  rated_from_ = Clock::now();
}

void LiveSimulation::pace_anew() {
  paced_from_ = Clock::now();
  pace_time_ = run_->time();
}

void LiveSimulation::publish_frame() {
  published_ = Clock::now();
  {
    const std::lock_guard lock(mutex_);
    const bool is_new_scene = newest_.generation != generation_;
    if (!is_watched_ && !is_new_scene) return;
  }
  auto frame = std::make_shared<const std::string>(run_->frame(generation_));
  std::shared_ptr<const std::vector<PageBlock>> blocks;
  if (newest_.generation != generation_)
    blocks = std::make_shared<const std::vector<PageBlock>>(run_->blocks());
  frame_is_new_ = false;
  {
    const std::lock_guard lock(mutex_);
    newest_.frame = std::move(frame);
    if (blocks) newest_.blocks = std::move(blocks);
    newest_.generation = generation_;
    newest_.scene = run_->scene().name;
  }
  notify_();
}

void LiveSimulation::publish_history() {
  {
    const std::lock_guard lock(mutex_);
    if (!is_watched_) return;
  }
  remembered_ = Clock::now();
  history_revision_ = run_->history().revision();
  auto history =
      std::make_shared<const std::string>(live_history_bytes(run_->history(), generation_, run_->origin()));
  {
    const std::lock_guard lock(mutex_);
    newest_.history = std::move(history);
  }
  notify_();
}

void LiveSimulation::publish_status() {
  told_ = Clock::now();
  status_is_new_ = false;
  std::string text = status();
  {
    const std::lock_guard lock(mutex_);
    if (newest_.status && *newest_.status == text) return;
    newest_.status = std::make_shared<const std::string>(std::move(text));
  }
  notify_();
}

std::string LiveSimulation::status() const {
  Json surfaces = Json::array();
  const std::vector<Material>& materials = run_->scene().model->materials();
  for (std::size_t i = 0; i < materials.size(); ++i) {
    const ModelChanges::Surface& surface = run_->changes().surfaces[i];
    surfaces.push_back({{"material", materials[i].name},
                        {"friction", surface.friction},
                        {"restitution", surface.restitution}});
  }
  Json method = Json::array();
  for (const std::string& key : method_choice_keys()) {
    method.push_back(
        {{"key", key}, {"value", method_choice(run_->method(), key)}, {"values", method_values(key)}});
  }
  return json_line(Json{{"type", "status"},
                        {"generation", generation_},
                        {"running", is_running_},
                        {"speed", speed_},
                        {"rate", is_running_ ? rate_ : 0},
                        {"gravity", vector_json(run_->changes().g_W)},
                        {"surfaces", surfaces},
                        {"axes", axes_json(*run_)},
                        {"earlier", run_->earlier_count()},
                        {"target_step", run_->target_step()},
                        {"method", method},
                        {"stopped", failure_.empty() ? run_->stop_text() : failure_},
                        {"recorded", run_->recorded_frames()},
                        {"file",
                         {{"name", file_.name()},
                          {"follow", follows_file_},
                          {"changed", file_has_changed_},
                          {"messages", file_messages_}}}});
}

}  // namespace rigor
