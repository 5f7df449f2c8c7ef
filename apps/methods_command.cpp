#include "apps/commands.hpp"
#include "apps/course_words.hpp"
#include "apps/terminal.hpp"
#include "apps/usage_error.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/core/suggestion.hpp"
#include "rigor/sim/method/method.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

namespace rigor {

namespace {

/// Lines of the listing that speak of a word; of none, all.
class Listing {
 public:
  explicit Listing(const std::string& word) : word_(word) {}

  /// Whether anything was printed.
  bool is_found() const { return is_found_; }

  void print_choices() {
    const Method defaults;
    std::string_view previous;
    for (const MethodChoice& choice : method_choices()) {
      if (!speaks({choice.key, choice.value, choice.meaning, choice.source})) continue;
      if (choice.key != previous) fmt::print("{}\n", toned(choice.key, Tone::strong, stdout));
      previous = choice.key;
      const char* const mark = method_choice(defaults, choice.key) == choice.value ? "default" : "";
      fmt::print("  {:<20} {} {}\n", choice.value, toned(fmt::format("{:<8}", mark), Tone::good, stdout),
                 choice.meaning);
      fmt::print("  {:<20} {:<8} {}\n", "", "", choice.source);
    }
  }

  void print_numbers() {
    bool is_first = true;
    for (const MethodNumber& number : method_numbers()) {
      if (!speaks({number.key, number.meaning})) continue;
      if (is_first) fmt::print("\n{}\n", toned("numbers", Tone::strong, stdout));
      is_first = false;
      fmt::print("  {:<20} {:<8} {}; {}\n", number.key, number.fallback, number.meaning,
                 range_text(number.range, number.unit));
    }
  }

  void print_course_words() {
    bool is_first = true;
    for (const CourseWord& word : course_words()) {
      if (!speaks({word.names, word.here, word.chosen})) continue;
      if (is_first) fmt::print("\n{}\n", toned("words of the courses", Tone::strong, stdout));
      is_first = false;
      fmt::print("  {}\n", word.names);
      if (!word_.empty())
        fmt::print("    {}\n    chosen: {}; see docs/{}\n", word.here, word.chosen, word.page);
    }
  }

 private:
  bool speaks(std::initializer_list<std::string_view> texts) {
    const bool is_wanted =
        word_.empty() || std::any_of(texts.begin(), texts.end(),
                                     [&](std::string_view text) { return speaks_of(text, word_); });
    is_found_ = is_found_ || is_wanted;
    return is_wanted;
  }

  const std::string& word_;
  bool is_found_ = false;
};

/// Everything that can be looked for by its name.
std::vector<std::string> known_names() {
  std::vector<std::string> names = method_choice_keys();
  for (const MethodChoice& choice : method_choices()) names.emplace_back(choice.value);
  for (const MethodNumber& number : method_numbers()) names.emplace_back(number.key);
  for (const CourseWord& word : course_words()) {
    for (std::string& name : names_of(word)) names.push_back(std::move(name));
  }
  return names;
}

}  // namespace

ExitCode execute(const MethodsOptions& options) {
  std::string word;
  for (const std::string& part : options.words) word += (word.empty() ? "" : " ") + part;
  if (word.empty())
    fmt::print(
        "Choices of 'method' in a scene, or --set method.KEY=VALUE; 'default' marks what holds without "
        "one.\n'rigor methods WORD' says what stands for a word of the courses, and finds choices and "
        "authors.\n\n");
  Listing listing(word);
  listing.print_choices();
  listing.print_numbers();
  listing.print_course_words();
  if (listing.is_found()) return exit_done;
  const std::optional<std::string> nearest = find_nearest_name(word, known_names());
  throw UsageError("nothing here is called " + quoted_text(word) +
                   (nearest ? "; did you mean '" + *nearest + "'?" : "; 'rigor methods' lists all that is"));
}

}  // namespace rigor
