#pragma once

#include "rigor/core/index.hpp"
#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/model/model_changes.hpp"
#include "rigor/sim/fixed_steps/stepper.hpp"
#include "rigor/view/live/live_history.hpp"
#include "rigor/view/page/page_run.hpp"

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rigor {

/// A pull: a spring draws a point of a body towards a point of the world.
struct LivePull {
  int body;     ///< Model index of a dynamic body.
  Vec3 p_BP;    ///< Point that is held, in B [m].
  Vec3 target;  ///< Point that it is pulled to, in W [m].
};

/// A simulation whose scene may be changed while it runs. A changed scene is a new Model with the same State
/// (anchored anew, so that the past stays as it was) and a new stepper. All functions that change something
/// throw InputError and leave everything as it was if the change is invalid.
class LiveRun {
 public:
  /// Throws InputError if bodies overlap.
  explicit LiveRun(Scene scene);

  /// Asked within advance(): true ends it with everything as it was before.
  void set_interrupt(std::function<bool()> interrupt);

  double time() const { return state_.t; }
  const Scene& scene() const { return scene_; }
  const State& state() const { return state_; }
  const Method& method() const { return method_; }
  double target_step() const { return step_; }  ///< H [s].
  const ModelChanges& changes() const { return changes_; }
  /// Empty, or the reason why the simulation cannot continue; a change or reset lets it try again.
  const std::string& stop_text() const { return stop_text_; }

  /// Advances by at most this time [s] > 0, and not past the next output time.
  void advance(double longest);
  /// Advances to the next output time.
  void step() { advance(scene_.run.output_interval); }
  /// Returns to t = 0 and keeps the changes that were made.
  void reset();
  /// Returns to the output time before this one, as far as they are kept; a pull ends, other changes stay.
  /// The recording and the balances begin anew there.
  void go_back();
  /// How many output times can be gone back.
  std::size_t earlier_count() const {
    return before_.size() - (!before_.empty() && before_.back().t >= state_.t ? 1 : 0);
  }

  void set_gravity(const Vec3& g_W);
  void set_surface(const std::string& material, std::optional<double> friction,
                   std::optional<double> restitution);
  void set_target_step(double step);
  /// Drives a coordinate of a joint at this velocity [rad/s] or [m/s], with the force that the scene gives
  /// its motor, any if it has none. Without a velocity there is no motor.
  void set_motor(int joint, int coordinate, std::optional<double> velocity);
  /// Where the spring of a coordinate rests [rad] or [m].
  void set_rest(int joint, int coordinate, double rest);
  /// The laws of a coordinate as they are now.
  JointAxis laws(int joint, int coordinate) const;
  void set_method(const std::string& key, const std::string& value);
  /// Applies an impulse [N s], in W, to a dynamic body at p_BP [m], in B.
  void push(int body, const Vec3& p_BP, const Vec3& j_W);
  void pull(const LivePull& pull);
  void release();

  /// Contacts at this moment.
  const std::vector<TouchingPoint>& contacts();
  /// The frame of this moment in the format of docs/live.md. generation: the scene that it belongs to.
  std::string frame(std::uint32_t generation);
  /// What happened since the last reset.
  const LiveHistory& history() const { return history_; }
  /// Points in frames and histories are sent relative to this point [m].
  const Vec3& origin() const { return scale_.origin; }
  /// A checkpoint in the format of `rigor run --resume`, of the scene with its changes but without the pull.
  std::string checkpoint() const;
  /// The recording since the last reset, as a page of its own. The recording starts over when it holds
  /// most_recorded positions of bodies.
  std::string page() const;
  /// This moment alone as the data of a page, with which a live page begins.
  std::vector<PageBlock> blocks();
  static constexpr std::size_t most_recorded = 20'000'000;
  std::size_t recorded_frames() const { return at(recording_->frame_count()); }

 private:
  void change(ModelChanges changes);
  void rebuild();
  void begin_books();
  void begin_recording();
  void record();
  void check_dynamic(int body) const;
  void set_laws(int joint, int coordinate, const JointAxis& laws);
  void check_coordinate(int joint, int coordinate) const;
  /// The scene as it is now, with its changes.
  Scene present() const;
  Audit audit() const;

  Scene scene_;  ///< As read from the file.
  ModelChanges changes_;
  Method method_;
  double step_;
  std::optional<LivePull> pull_;
  std::shared_ptr<const Model> free_model_;  ///< With the changes but without the pull.
  std::shared_ptr<const Model> model_;       ///< The one that is simulated.
  State state_;
  std::function<bool()> interrupt_;
  std::unique_ptr<Stepper> stepper_;
  std::unique_ptr<Auditor> auditor_;
  std::optional<Audit> earlier_;  ///< Balances of the previous models.
  std::unique_ptr<PageRun> recording_;
  LiveHistory history_;
  std::deque<State> before_;  ///< At the last output times.
  AdvanceReport unrecorded_;  ///< What happened since the last output time.
  AdvanceReport last_;        ///< Of the last advance: its contacts alone.
  PageScale scale_;
  std::optional<std::vector<TouchingPoint>> contacts_;  ///< Of the state, when they are known.
  std::string stop_text_;
};

}  // namespace rigor
