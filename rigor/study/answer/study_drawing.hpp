#pragma once

#include "rigor/study/kinds/answer.hpp"
#include "rigor/view/plot/drawing.hpp"

#include <string>
#include <vector>

namespace rigor {

/// A figure of an answer as a drawing; nothing to draw gives an empty one.
Drawing figure_drawing(const AnswerFigure& figure);
/// All figures of an answer, one below the other.
Drawing answer_drawing(const StudyAnswer& answer);

/// Parallel coordinates: an axis a column, a line a run in the colour of its value in the column `main`
/// (none: grey). What is not finite interrupts a line.
///
/// Source: Inselberg, The plane with parallel coordinates, The Visual Computer 1, 1985.
Drawing parallel_drawing(const std::vector<std::string>& names,
                         const std::vector<std::vector<double>>& columns, std::size_t main);

/// Each column against each other one, dots: a scatter matrix of at most six columns.
Drawing scatter_matrix(const std::vector<std::string>& names,
                       const std::vector<std::vector<double>>& columns);

}  // namespace rigor
