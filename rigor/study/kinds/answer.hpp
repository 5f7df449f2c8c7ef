#pragma once

#include <optional>
#include <string>
#include <vector>

namespace rigor {

/// A number that a study found, with its confidence interval or bracket.
struct Finding {
  std::string name;
  double value = 0;
  std::optional<double> low, high;
  std::string note = {};
};

/// Numbers in rows, one of which may stand for a point, a bin or a parameter.
struct AnswerTable {
  std::string title;
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows;
  std::vector<std::string> labels = {};  ///< Of the rows, or none.
};

/// What is to be drawn of an answer.
struct AnswerFigure {
  enum class Kind {
    points,   ///< y over x, with bars from low to high where these are given.
    bars,     ///< Values y with labels, from low to high: a tornado.
    columns,  ///< A histogram: y over the bins from x to low.
  };
  Kind kind;
  std::string title, x_label, y_label;
  std::vector<double> x, y, low, high;
  std::vector<std::string> labels = {};
};

/// What a study says, as far as its runs are done.
struct StudyAnswer {
  std::vector<Finding> findings;
  std::vector<AnswerTable> tables;
  std::vector<AnswerFigure> figures;
  std::vector<std::string> warnings;
};

}  // namespace rigor
