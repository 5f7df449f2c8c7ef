#include "rigor/view/page/page_writer.hpp"

#include "io/trajectory_samples.hpp"
#include "rigor/io/files/file_error.hpp"
#include "rigor/sim/simulation.hpp"
#include "rigor/view/page/page_geometry.hpp"
#include "view/page_reading.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace rigor::page_writer_test {
namespace {

using Json = nlohmann::json;

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

Scene scene_of(const std::string& file) {
  return read_scene(std::string(RIGOR_SOURCE_DIR) + "/scenes/" + file);
}

struct WrittenPage {
  std::string html;
  std::vector<test::ReadBlock> blocks;
  std::vector<State> states;
  std::vector<MotionEvent> events;
  std::vector<double> kinetic;
  std::vector<std::vector<TouchingPoint>> contacts;
  Audit audit;

  Json header() const { return Json::parse(blocks.at(0).bytes); }
  const std::string& bytes_of(const std::string& kind) const {
    for (const test::ReadBlock& block : blocks) {
      if (block.kind == kind) return block.bytes;
    }
    throw std::out_of_range(kind);
  }
};

WrittenPage page_of(const Scene& scene) {
  const TemporaryFolder folder;
  WrittenPage page;
  PageWriter writer(folder / "page.html", scene);
  const RunResult result =
      run_simulation(scene.model, scene.method, scene.run, std::nullopt,
                     [&](const State& state, const AdvanceReport& since, const Auditor& auditor) {
                       writer.write(state, since, auditor.energy());
                       page.states.push_back(state);
                       page.contacts.push_back(known_contacts(*scene.model, scene.method, state, since));
                       page.events.insert(page.events.end(), since.events.begin(), since.events.end());
                       page.kinetic.push_back(auditor.energy().kinetic);
                       return true;
                     });
  writer.close(result.audit);
  page.audit = result.audit;
  page.html = text_of(folder / "page.html");
  page.blocks = test::blocks_of_page(page.html);
  return page;
}

TEST(PageWriter, ThePolicyNamesTheOneScriptByItsHash) {
  const WrittenPage page = page_of(scene_of("bouncing_ball.yaml"));
  const std::string head = page.html.substr(0, page.html.find("<title>"));
  EXPECT_NE(head.find("default-src 'none'; script-src 'sha256-"), std::string::npos) << head;
  EXPECT_EQ(head.find("unsafe"), std::string::npos) << head;
  // The text of the element is what the hash is of, to the byte.
  const std::string script(viewer_script());
  EXPECT_NE(page.html.find("<script>" + script + "</script>"), std::string::npos);
  const std::string file = text_of(std::string(RIGOR_SOURCE_DIR) + "/viewer/dist/viewer.js");
  EXPECT_EQ(script, file);
  EXPECT_EQ(viewer_script_sha256().size(), 64u);
}

TEST(PageWriter, APageHoldsTheViewerAndSoundBlocksOfTheRun) {
  const WrittenPage page = page_of(scene_of("cradle.yaml"));
  EXPECT_EQ(page.html.rfind("<!doctype html>", 0), 0u);
  EXPECT_NE(page.html.find(viewer_script()), std::string::npos);
  EXPECT_NE(
      page.html.find("<meta name=\"rigor-blocks\" content=\"" + std::to_string(page.blocks.size()) + "\">"),
      std::string::npos);
  for (const test::ReadBlock& block : page.blocks) EXPECT_TRUE(block.is_sound) << block.kind;
  const Json header = page.header();
  EXPECT_EQ(header["format"], 2);
  EXPECT_EQ(header["scene"], "cradle");
  EXPECT_EQ(header["frames"], page.states.size());
  EXPECT_EQ(header["bodies"].size(), 5u);
  EXPECT_EQ(header["bodies"][0]["name"], "ball1");
  EXPECT_EQ(header["audit"]["events"]["impacts"], page.audit.report.impacts);
  EXPECT_LE(header["position_error"].get<double>(), 1e-5 * header["extent"].get<double>());
}

TEST(PageWriter, AFullPageEndsAsAnHtmlFileAndLoadsNothingFromElsewhere) {
  const WrittenPage page = page_of(scene_of("cradle.yaml"));
  EXPECT_EQ(page.html.substr(page.html.size() - 8), "</html>\n");
  for (const char* part : {" src=\"http", " href=\"http", "@import", "import("}) {
    EXPECT_EQ(page.html.find(part), std::string::npos) << part;
  }
}

TEST(PageWriter, RunsOfOnePageHaveNamesAndEndsAndASingleRunHasNeither) {
  const Scene scene = scene_of("cradle.yaml");
  const auto header_of = [&](PageRun run, const Audit& audit) {
    run.add(make_initial_state(*scene.model), {}, {});
    const TemporaryFolder folder;
    write_page(folder / "page.html", "title", {run.finish(audit)});
    return Json::parse(test::blocks_of_page(text_of(folder / "page.html")).at(0).bytes);
  };
  const State start = make_initial_state(*scene.model);
  Audit stopped;
  stopped.report.reason = StopReason::impact_unsolved;
  stopped.report.detail = "bodies approach";
  const Json named = header_of(PageRun(scene, start, "a=1 <b>"), {});
  EXPECT_EQ(named["label"], "a=1 <b>");
  EXPECT_FALSE(named.contains("stopped"));
  EXPECT_EQ(header_of(PageRun(scene, start, "a=1"), stopped)["stopped"], "bodies approach");
  const Json alone = header_of(PageRun(scene, start), stopped);
  EXPECT_FALSE(alone.contains("label"));
  EXPECT_FALSE(alone.contains("stopped"));
}

TEST(PageWriter, TheSeriesIsThatOfTheRunToTheLastBit) {
  const WrittenPage page = page_of(scene_of("bouncing_ball_e05.yaml"));
  const Json series = page.header()["series"];
  ASSERT_EQ(series[0]["name"], "time");
  ASSERT_EQ(series[1]["name"], "kinetic");
  test::BytesReader reader(page.bytes_of("series"));
  const std::vector<double> times = reader.exact_column(page.states.size());
  for (std::size_t i = 0; i < times.size(); ++i) EXPECT_EQ(times[i], page.states[i].t);
  EXPECT_EQ(reader.exact_column(page.kinetic.size()), page.kinetic);
}

TEST(PageWriter, EventsKeepTimesPlacesAndImpulses) {
  const WrittenPage page = page_of(scene_of("cradle.yaml"));
  ASSERT_FALSE(page.events.empty());
  const Json header = page.header();
  ASSERT_EQ(header["events"], page.events.size());
  test::BytesReader reader(page.bytes_of("events"));
  const double time_step = reader.take<double>(), impulse_step = reader.take<double>();
  EXPECT_LE(time_step, 1e-9 * header["output_interval"].get<double>());
  const std::vector<std::int64_t> times = reader.column(page.events.size());
  for (std::size_t i = 0; i < times.size(); ++i) {
    EXPECT_NEAR(static_cast<double>(times[i]) * time_step, page.events[i].time, 0.51 * time_step);
  }
  const double position_step = header["position_step"];
  for (const MotionEvent& event : page.events) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double origin = header["origin"][c];
      EXPECT_NEAR(static_cast<double>(reader.varint()) * position_step + origin,
                  event.p_W[static_cast<Eigen::Index>(c)], 0.51 * position_step);
    }
  }
  for (const MotionEvent& event : page.events) {
    for (const double j : event.j_W) {
      EXPECT_NEAR(static_cast<double>(reader.varint()) * impulse_step, j, 0.51 * impulse_step);
    }
  }
  for (const MotionEvent& event : page.events) {
    EXPECT_EQ(reader.varint(), event.body_A);
    EXPECT_EQ(reader.varint(), event.body_B);
    EXPECT_EQ(reader.varint(), static_cast<std::int64_t>(event.kind));
  }
  EXPECT_TRUE(reader.is_at_end());
}

/// A stored contact: its bodies and eleven whole numbers, and the same one of the frame before.
struct StoredContact {
  int body_A, body_B;
  int from = -1;
  std::array<std::int64_t, 11> numbers{};
};
using StoredFrame = std::vector<StoredContact>;

/// Which contacts of a frame of `count` stay.
std::vector<int> read_kept(test::BytesReader& reader, int count) {
  std::vector<int> kept;
  bool stays = true;
  for (int i = 0; i < count; stays = !stays) {
    for (int end = i + static_cast<int>(reader.varint()); i < end; ++i)
      if (stays) kept.push_back(i);
  }
  return kept;
}

std::vector<StoredFrame> read_contacts(test::BytesReader& reader, std::size_t frame_count, bool is_smooth) {
  std::vector<StoredFrame> added(frame_count), frames(frame_count);
  for (StoredFrame& frame : added) frame.resize(static_cast<std::size_t>(reader.varint()));
  std::vector<std::vector<int>> kept;
  for (const StoredFrame& frame : added) {
    const std::size_t last = kept.empty() ? 0 : kept.back().size() + added[kept.size() - 1].size();
    kept.push_back(read_kept(reader, static_cast<int>(last)));
    (void)frame;
  }
  for (StoredFrame& frame : added) {
    int body = 0;
    for (StoredContact& contact : frame) contact.body_A = body += static_cast<int>(reader.varint());
  }
  for (StoredFrame& frame : added)
    for (StoredContact& contact : frame) contact.body_B = contact.body_A + static_cast<int>(reader.varint());
  // A frame has what stays and what is new, in the order of bodies.
  for (std::size_t f = 0; f < frame_count; ++f) {
    for (const int from : kept[f]) {
      const StoredContact& earlier = frames[f - 1][static_cast<std::size_t>(from)];
      frames[f].push_back({earlier.body_A, earlier.body_B, from});
    }
    frames[f].insert(frames[f].end(), added[f].begin(), added[f].end());
    std::stable_sort(frames[f].begin(), frames[f].end(), [](const StoredContact& a, const StoredContact& b) {
      return std::pair(a.body_A, a.body_B) < std::pair(b.body_A, b.body_B);
    });
  }
  for (std::size_t k = 0; k < 11; ++k)
    for (StoredFrame& frame : frames)
      for (StoredContact& contact : frame) contact.numbers[k] = reader.varint();
  for (std::size_t f = 1; f < frame_count; ++f) {
    for (StoredContact& contact : frames[f]) {
      if (contact.from < 0) continue;
      const StoredContact& newer = frames[f - 1][static_cast<std::size_t>(contact.from)];
      for (std::size_t k = 0; k < 11; ++k) {
        contact.numbers[k] += newer.numbers[k];
        if (is_smooth && newer.from >= 0 && k >= 2 && k < 8)
          contact.numbers[k] +=
              newer.numbers[k] - frames[f - 2][static_cast<std::size_t>(newer.from)].numbers[k];
      }
    }
  }
  return frames;
}

/// Middle of the centres of mass of a contact's bodies that are not fixed, in steps of places.
double stored_middle(const Scene& scene, const State& state, const StoredContact& contact, const Json& header,
                     double place_step, int c) {
  double sum = 0;
  int count = 0;
  for (const int body : {contact.body_A, contact.body_B}) {
    if (scene.model->body(body).motion == MotionType::fixed) continue;
    const double step = header["position_step"], origin = header["origin"][static_cast<std::size_t>(c)];
    sum += static_cast<double>(std::llround((state.position(body)[c] - origin) / step)) * step / place_step;
    ++count;
  }
  return count == 0 ? 0 : std::floor(sum / count + 0.5);
}

TEST(PageWriter, TheContactsOfEveryFrameAreThoseThatTheRunKnows) {
  // Dominoes touch the floor and each other, and their contacts come and go.
  const Scene scene = scene_of("dominoes.yaml");
  const WrittenPage page = page_of(scene);
  const Json header = page.header();
  test::BytesReader reader(page.bytes_of("contacts"));
  const double force_step = reader.take<double>(), gap_step = reader.take<double>(),
               place_step = reader.take<double>(), normal_step = reader.take<double>();
  EXPECT_EQ(gap_step, scene.method.contact_tolerance / 16);
  EXPECT_EQ(normal_step, 1.0 / 1024);
  EXPECT_LE(place_step, 8e-5 * header["extent"].get<double>());
  const bool is_smooth = reader.take<std::uint32_t>() == 2;
  ASSERT_EQ(reader.take<std::uint32_t>(), page.states.size());
  const std::vector<StoredFrame> frames = read_contacts(reader, page.states.size(), is_smooth);
  EXPECT_TRUE(reader.is_at_end());
  for (std::size_t f = 0; f < frames.size(); ++f) {
    const StoredFrame& stored = frames[f];
    const std::vector<TouchingPoint>& points = page.contacts[f];
    ASSERT_EQ(stored.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto number = [&](std::size_t k) { return static_cast<double>(stored[i].numbers[k]); };
      EXPECT_EQ(stored[i].body_A, points[i].body_A);
      EXPECT_EQ(stored[i].body_B, points[i].body_B);
      EXPECT_EQ(number(0), static_cast<double>(points[i].mode));
      EXPECT_NEAR(number(1) * gap_step, points[i].gap, 0.51 * gap_step);
      for (int c = 0; c < 3; ++c) {
        const std::size_t place = static_cast<std::size_t>(c);
        const double origin = header["origin"][place];
        const double middle = stored_middle(scene, page.states[f], stored[i], header, place_step, c);
        EXPECT_NEAR((middle + number(2 + place)) * place_step + origin, points[i].p_W[c], 0.51 * place_step);
        EXPECT_NEAR(number(5 + place) * normal_step, points[i].n_W[c], 0.51 * normal_step);
        EXPECT_NEAR(number(8 + place) * force_step, points[i].force_W[c], 0.51 * force_step);
      }
    }
  }
}

TEST(PageContacts, PointsOfAPairAreJoinedWithTheSumOfTheirForcesWhereItActs) {
  const auto point = [](int A, int B, double x, double force, double gap) {
    return TouchingPoint{.body_A = A,
                         .body_B = B,
                         .p_W = {x, 0, 0},
                         .gap = gap,
                         .force_W = {0, 0, force},
                         .mode = force > 2 ? TouchingPoint::Mode::slide : TouchingPoint::Mode::stick};
  };
  const std::vector<TouchingPoint> joined =
      joined_by_pairs({point(0, 1, 0, 1, 0), point(0, 1, 4, 3, -1e-3), point(0, 2, 5, 0, 1e-4),
                       point(0, 2, 7, 0, 0), point(1, 2, 9, 2, 0)});
  ASSERT_EQ(joined.size(), 3u);
  EXPECT_EQ(joined[0].force_W, Vec3(0, 0, 4));
  // The same moment as before: 0 + 4 · 3 = 3 · 4.
  EXPECT_EQ(joined[0].p_W, Vec3(3, 0, 0));
  EXPECT_EQ(joined[0].gap, -1e-3);
  EXPECT_EQ(joined[0].mode, TouchingPoint::Mode::slide);
  EXPECT_EQ(joined[1].p_W, Vec3(6, 0, 0));
  EXPECT_EQ(joined[1].gap, 0);
  EXPECT_EQ(joined[2].body_A, 1);
  EXPECT_EQ(joined[2].force_W, Vec3(0, 0, 2));
}

TEST(PageWriter, NamesThatLookLikeTagsStayText) {
  const TemporaryFolder folder;
  write_page(folder / "page.html", "a</title><script>alert(1)</script>", {});
  const std::string html = text_of(folder / "page.html");
  EXPECT_EQ(html.find("<script>alert"), std::string::npos);
  EXPECT_NE(html.find("a&lt;/title&gt;&lt;script&gt;"), std::string::npos);
}

TEST(PageWriter, AFolderThatIsNotThereIsToldBeforeTheRun) {
  const Scene scene = scene_of("cradle.yaml");
  EXPECT_THROW(PageWriter("nowhere/page.html", scene), FileError);
}

TEST(PageGeometry, BodiesThatLookAlikeShareALookAndPolyhedraAMesh) {
  const Scene gas = scene_of("gas.yaml");
  const PageGeometry of_gas = page_geometry(*gas.model);
  ASSERT_EQ(of_gas.look_of_body.size(), static_cast<std::size_t>(gas.model->body_count()));
  EXPECT_LE(of_gas.looks.size(), 7u);  // Six walls and the balls.
  const Scene rocks = scene_of("rocks.yaml");
  const PageGeometry of_rocks = page_geometry(*rocks.model);
  std::size_t bytes = 0;
  for (const auto& mesh : of_rocks.meshes) {
    bytes += 12 * mesh["vertices"].get<std::size_t>() + 12 * mesh["triangles"].get<std::size_t>();
  }
  EXPECT_GT(of_rocks.meshes.size(), 0u);
  EXPECT_EQ(of_rocks.mesh_bytes.size(), bytes);
}

}  // namespace
}  // namespace rigor::page_writer_test
