#pragma once

#include "rigor/study/answer/study_output.hpp"
#include "rigor/study/study.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace rigor::studies {

/// The study of this text on so many threads, at its end.
inline std::unique_ptr<Study> finished(const std::string& text, int threads = 1,
                                       const StudySettings& settings = {}) {
  const std::string path = std::string(RIGOR_SOURCE_DIR) + "/scenes/studies/test.yaml";
  auto study = std::make_unique<Study>(parse_study(text, path));
  const std::unique_ptr<WorkerPool> pool = make_thread_pool([&] { return study->make_executor(); }, threads);
  EXPECT_TRUE(study->run(*pool, settings));
  return study;
}

inline Finding finding_of(const Study& study, const std::string& name) {
  for (const Finding& finding : study.answer().findings) {
    if (finding.name == name) return finding;
  }
  ADD_FAILURE() << "no finding " << name;
  return {};
}

}  // namespace rigor::studies
