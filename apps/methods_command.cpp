#include "apps/commands.hpp"
#include "apps/terminal.hpp"
#include "rigor/sim/method/method.hpp"

#include <fmt/format.h>

namespace rigor {

namespace {

void print_choices() {
  const Method defaults;
  std::string_view previous;
  for (const MethodChoice& choice : method_choices()) {
    if (choice.key != previous) fmt::print("{}\n", toned(choice.key, Tone::strong, stdout));
    previous = choice.key;
    const char* const mark = method_choice(defaults, choice.key) == choice.value ? "default" : "";
    fmt::print("  {:<20} {} {}\n", choice.value, toned(fmt::format("{:<8}", mark), Tone::good, stdout),
               choice.meaning);
    fmt::print("  {:<20} {:<8} {}\n", "", "", choice.source);
  }
}

}  // namespace

ExitCode execute(const MethodsOptions&) {
  fmt::print(
      "Choices of 'method' in a scene, or --set method.KEY=VALUE; 'default' marks what holds without "
      "one.\n\n");
  print_choices();
  fmt::print("\n{}\n", toned("numbers", Tone::strong, stdout));
  for (const MethodNumber& number : method_numbers()) {
    fmt::print("  {:<20} {:<8} {}; {}\n", number.key, number.fallback, number.meaning,
               range_text(number.range, number.unit));
  }
  return exit_done;
}

}  // namespace rigor
