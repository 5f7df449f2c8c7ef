#pragma once

#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/sim/audit/audit.hpp"
#include "rigor/view/page/page_contacts.hpp"
#include "rigor/view/page/page_frames.hpp"

#include <future>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rigor {

/// Where forces are not known from the run, those of groups of at most so many contacts are solved for: some
/// milliseconds each.
inline constexpr std::size_t most_contacts_solved = 48;

/// The contacts of the state that an advance has left, with the forces that moved it. Where the scheme keeps
/// none, at the start, and of a stored motion, they are those of contact_snapshot within
/// most_contacts_solved.
std::vector<TouchingPoint> known_contacts(const Model& model, const Method& method, const State& state,
                                          const AdvanceReport& since);

/// The page keeps so many events: of more, those with the largest impulses.
inline constexpr std::size_t most_page_events = 20000;
/// The `most` events with the largest impulses, in their order; of equal ones the earlier.
std::vector<MotionEvent> strongest_events(const std::vector<MotionEvent>& events, std::size_t most);

/// One run as a page shows it, collected while it runs: memory grows with the quantised motion alone, a few
/// bytes per body and frame.
class PageRun {
 public:
  /// label: name of the run on a page with several runs, otherwise empty.
  PageRun(const Scene& scene, const State& start, std::string label = {});

  /// Adds an output time with what happened since the last one.
  void add(const State& state, const AdvanceReport& since, const Energy& energy);
  /// The same for known contacts of the state.
  void add(const State& state, const AdvanceReport& since, const Energy& energy,
           std::vector<TouchingPoint> contacts);
  /// Continues with another model that has the same bodies; the header describes the last one.
  void continue_with(std::shared_ptr<const Model> model) { latest_model_ = std::move(model); }
  /// Values of the series at the last output time, in the order of the list in the header.
  std::vector<double> last_row() const;
  int frame_count() const { return frames_.frame_count(); }
  /// Returns all blocks, the header first (docs/page.md gives the format), and ends the run.
  std::vector<PageBlock> finish(const Audit& audit);

  const std::string& name() const { return name_; }

 private:
  void keep(std::optional<PagePacking> chunk);
  PageBlock events_block() const;
  PageBlock series_block() const;

  std::shared_ptr<const Model> model_, latest_model_;
  Method method_;
  RunSettings run_;
  std::string name_, label_;
  PageScale scale_;
  PageFrames frames_;
  PageContacts contacts_;
  /// Chunks of frames and contacts, in the order they were filled; packed on another thread while the run
  /// goes on.
  std::vector<std::shared_future<PageBlock>> chunks_;
  std::vector<std::vector<double>> series_;  ///< One column per quantity.
  double work_ = 0;                          ///< Work supplied so far [J].
  std::vector<MotionEvent> events_;
};

/// Merges the rows of the series of two successive intervals: values at the end of the later one, sums of
/// counts, and the larger of two maxima.
std::vector<double> joined_rows(const std::vector<double>& earlier, const std::vector<double>& later);

}  // namespace rigor
