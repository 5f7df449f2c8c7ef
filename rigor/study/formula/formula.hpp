#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace rigor {

/// A formula of named numbers, read once and evaluated many times: arithmetic, comparisons and logic (1 for
/// true), `condition ? a : b`, and the functions of the library muParser. Names begin with a letter and may
/// hold points and brackets: "body.die.position.z". `pi` is the constant. An object is used by one thread.
class Formula {
 public:
  /// Throws InputError with a message that says what is wrong with the text, without a place.
  explicit Formula(const std::string& text);
  Formula(Formula&&) noexcept;
  Formula& operator=(Formula&&) noexcept;
  ~Formula();

  const std::string& text() const;
  /// The names that the formula uses, ascending.
  const std::vector<std::string>& names() const;
  /// The value where the names have these values, in the order of names(). NaN where it is not defined.
  double value(std::span<const double> values) const;

 private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
};

}  // namespace rigor
