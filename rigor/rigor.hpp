#pragma once

// All of Rigor for a program: scenes from files, text or code, simulations in every scheme, many of them on
// threads, and geometry (docs/cpp.md).

#include "rigor/api/batch.hpp"
#include "rigor/api/run_record.hpp"
#include "rigor/api/simulation.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/geometry.hpp"
#include "rigor/io/files/file_error.hpp"
#include "rigor/model/model_builder.hpp"
