// SPDX-License-Identifier: MIT
// Helpers that the tests of this room share.
#pragma once

#include "cageproof/core/cage/cage.h"
#include "cageproof/core/input_error.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <string>
#include <string_view>

#include <unistd.h>

namespace cageproof::testing_support {

/// The message of the InputError that f throws; a failed expectation and "" when it throws none. Messages are one line.
template <class F>
std::string input_error_of(F&& f) {
  try {
    f();
  } catch (const InputError& error) {
    std::string message = error.what();
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    return message;
  }
  ADD_FAILURE() << "no InputError";
  return "";
}

/// Expects every part in the message.
inline void expect_parts(const std::string& message, std::initializer_list<std::string_view> parts) {
  for (const std::string_view part : parts)
    EXPECT_NE(message.find(part), std::string::npos) << message << "\nlacks: " << part;
}

/// A folder of its own for a test's files, removed at the end.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    static int count = 0;
    path_ = std::filesystem::temp_directory_path() /
            (std::string("cageproof.") + info->name() + "." + std::to_string(getpid()) + "." + std::to_string(++count));
    std::filesystem::create_directories(path_);
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path write(const std::string& name, std::string_view text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

/// Volume of the triangles, from the divergence theorem.
inline double volume(const Cage& cage, Triangulation rule = Triangulation::Shortest) {
  double six_times = 0;
  for (const auto& [a, b, c] : cage.triangulate(rule).triangles)
    six_times += cage.vertices()[a].dot(cage.vertices()[b].cross(cage.vertices()[c]));
  return six_times / 6;
}

}  // namespace cageproof::testing_support
