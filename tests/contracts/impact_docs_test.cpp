#include "contracts/program.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <sstream>

// The pages on impacts, docs/impact.md and docs/theory/impact.md, show what the program says.

namespace rigor::impact_docs_test {
namespace {

using Words = std::vector<std::string>;

std::string page(const std::string& name) {
  return text_of(std::string(RIGOR_SOURCE_DIR) + "/docs/" + name);
}

/// The indented block of a page that begins with this line, without its indent.
std::string block_of(const std::string& text, const std::string& first_line) {
  const std::size_t begin = text.find("    " + first_line);
  EXPECT_NE(begin, std::string::npos) << first_line;
  std::istringstream lines(text.substr(begin));
  std::string block;
  for (std::string line; std::getline(lines, line) && line.starts_with("    ");)
    block += line.substr(4) + "\n";
  return block;
}

Words words_of(std::string text) {
  std::erase_if(text, [](char c) { return c == '[' || c == ']' || c == ',' || c == '|'; });
  std::istringstream stream(text);
  Words words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

/// The same words, and numbers to twelve digits of the largest on the page: their last ones are rounding.
void expect_same_words(const std::string& found, const std::string& expected) {
  const Words a = words_of(found), b = words_of(expected);
  ASSERT_EQ(a.size(), b.size()) << found;
  for (std::size_t k = 0; k < a.size(); ++k) {
    char *end_a = nullptr, *end_b = nullptr;
    const double x = std::strtod(a[k].c_str(), &end_a), y = std::strtod(b[k].c_str(), &end_b);
    if (end_a != a[k].c_str() && *end_a == 0 && end_b != b[k].c_str() && *end_b == 0) {
      EXPECT_NEAR(x, y, 1e-10);
    } else {
      EXPECT_EQ(a[k], b[k]);
    }
  }
}

TEST(ImpactPage, TheExampleRunsAndSaysWhatThePageShows) {
  const ProgramFolder folder;
  const std::string text = page("impact.md");
  folder.write("box.yaml", block_of(text, "rigor: 1\n"));
  const std::string shown = block_of(text, "$ rigor impact ");
  const std::size_t first_end = shown.find('\n');
  const Words command = words_of(shown.substr(0, first_end));
  const ProgramResult result = folder.run({command.begin() + 2, command.end()});
  ASSERT_EQ(result.code, 0) << result.error;
  expect_same_words(result.out, shown.substr(first_end + 1));
}

/// Places of the ends of all lines, in the order of the drawing, and all texts.
struct FigureContent {
  std::vector<double> ends;
  Words labels;
};
FigureContent content_of(const std::string& svg) {
  FigureContent content;
  std::istringstream lines(svg);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("<path d=\"M")) {
      std::string points = line.substr(10, line.find('"', 10) - 10);
      std::erase(points, 'L');
      std::istringstream stream(points);
      std::vector<double> numbers;
      for (double number; stream >> number;) numbers.push_back(number);
      content.ends.insert(content.ends.end(), numbers.begin(), numbers.begin() + 2);
      content.ends.insert(content.ends.end(), numbers.end() - 2, numbers.end());
    } else if (line.starts_with("<text")) {
      content.labels.push_back(line.substr(line.find('>') + 1));
    } else if (line.starts_with("<rect")) {
      content.labels.push_back(line);
    }
  }
  return content;
}

TEST(ImpactPage, TheFigureAndTheTableOfTheTheoryAreThoseOfTheProgram) {
  const ProgramFolder folder;
  const std::string text = page("theory/impact.md");
  std::istringstream stream(block_of(text, "rigor impact --K "));
  Words command;
  for (std::string word; stream >> word;) command.push_back(word);
  ASSERT_EQ(command.back(), "docs/img/impact_paths.svg");
  command.back() = "paths.svg";
  command.insert(command.end(), {"--json", "-"});
  const ProgramResult result = folder.run({command.begin() + 1, command.end()});
  ASSERT_EQ(result.code, 0) << result.error;

  const FigureContent found = content_of(folder.read("paths.svg")),
                      shown = content_of(page("img/impact_paths.svg"));
  EXPECT_EQ(found.labels, shown.labels);
  ASSERT_EQ(found.ends.size(), shown.ends.size());
  // Written to a hundredth.
  for (std::size_t k = 0; k < found.ends.size(); ++k) EXPECT_NEAR(found.ends[k], shown.ends[k], 0.011);

  const nlohmann::json json = nlohmann::json::parse(result.out);
  const double removable = json["removable_energy"].get<double>();
  const auto list = [](const nlohmann::json& v) {
    return fmt::format("{:.4g}, {:.4g}, {:.4g}", v[0].get<double>(), v[1].get<double>(), v[2].get<double>());
  };
  for (const auto& [law, name] :
       {std::pair{"newton", "Newton"}, std::pair{"poisson", "Poisson"}, std::pair{"stronge", "Stronge"}}) {
    const nlohmann::json& outcome = json["laws"][law];
    const double loss = -outcome["energy_change"].get<double>();
    expect_contains(text, fmt::format("| {} | {} | {} | {:.4g} | {:.1f} % |", name, list(outcome["velocity"]),
                                      list(outcome["impulse"]), loss, 100 * loss / removable));
  }
  expect_contains(text, fmt::format("{:.4g} of the normal force", json["sticking"]["ratio"].get<double>()));
  for (const nlohmann::json& direction : json["invariant_directions"]) {
    if (direction["is_growing"].get<bool>()) {
      expect_contains(text, fmt::format("at {:.2f} degrees", direction["angle"].get<double>() * 180 / M_PI));
      expect_contains(text, fmt::format("du_n/dp = {:.1f}.", direction["normal_rate"].get<double>()));
    }
  }
}

}  // namespace
}  // namespace rigor::impact_docs_test
