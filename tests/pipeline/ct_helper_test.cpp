// What becomes of this process when the one that reads dies, falls silent, talks nonsense, or wants too much memory.
#include "pipeline/dicom/ct_helper.h"

#include <signal.h>
#include <stdlib.h>
#include <sys/wait.h>

#include <chrono>
#include <fstream>
#include <thread>

#include "tests/pipeline/ct_stack.h"

namespace vallecula::pipeline {
namespace {

namespace fs = std::filesystem;

class CtHelper : public test::CtFolder {
 protected:
  void TearDown() override {
    ::unsetenv("VALLECULA_HELPERS");
    CtFolder::TearDown();
  }
  /// A program in place of the helper.
  void put_in_place(const std::string& script) const {
    const auto folder = dir_ / "helpers";
    fs::create_directories(folder);
    const auto program = folder / "vallecula-ct";
    std::ofstream(program) << "#!/bin/bash\n" << script << "\n";
    fs::permissions(program, fs::perms::owner_all);
    ::setenv("VALLECULA_HELPERS", folder.c_str(), 1);
  }
  std::string told(const HelperLimits& limits = {}) const {
    ReadRequest request;
    request.place = dir_.string();
    try {
      run_ct_helper(request, {}, limits);
    } catch (const SeriesError& e) {
      return e.what();
    }
    return "no error";
  }
  void expect_told(const std::string& words, const HelperLimits& limits = {}) const {
    const auto message = told(limits);
    EXPECT_NE(message.find(words), std::string::npos) << message;
  }
};

TEST_F(CtHelper, DeathsAreErrors) {
  put_in_place("kill -SEGV $$");
  expect_told("does not survive this file");
  put_in_place("kill -XCPU $$");
  expect_told("took more than its time");
  put_in_place("exit 1");
  expect_told("the reading program failed");
  put_in_place("exit 0");
  expect_told("the reading program failed");  // the request still lies where the answer should
  put_in_place("head -c 500 /dev/urandom > /proc/self/fd/3");
  expect_told("the reading program failed");
  put_in_place("printf 'a' > /proc/self/fd/3");
  expect_told("the reading program failed");
}

TEST_F(CtHelper, SilenceIsEndedWithAllItStarted) {
  const auto mark = dir_ / "mark";
  put_in_place("(sleep 4; touch " + mark.string() + ") & sleep 60");
  HelperLimits limits;
  limits.stall_seconds = 1;
  const auto start = std::chrono::steady_clock::now();
  expect_told("did not get on for 1 s", limits);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(4));
  std::this_thread::sleep_for(std::chrono::seconds(4));
  EXPECT_FALSE(fs::exists(mark)) << "what the helper started must end with it";
}

TEST_F(CtHelper, ItsMemoryIsBounded) {
  const auto file = dir_ / "volume.nrrd";
  test::write_bytes(
      "NRRD0004\ntype: short\ndimension: 3\nspace: left-posterior-superior\nsizes: 512 512 200\n"
      "space directions: (1,0,0) (0,1,0) (0,0,1)\nencoding: raw\nendian: little\nspace origin: (0,0,0)\n\n",
      file);
  fs::resize_file(file, fs::file_size(file) + 512 * 512 * 200 * 2);  // 105 MB
  ReadRequest request;
  request.place = file.string();
  EXPECT_EQ(run_ct_helper(request).answer.slices, 200);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  HelperLimits limits;
  limits.memory_bytes = 96U << 20;
  EXPECT_THROW(run_ct_helper(request, {}, limits), SeriesError);
#endif
}

TEST_F(CtHelper, WhatProgressThrowsEndsTheReading) {
  write(test::Stack{});
  struct Cancelled {};
  int calls = 0;
  EXPECT_THROW(read_ct_series(dir_,
                              [&](double) {
                                if (++calls == 2) throw Cancelled();
                              }),
               Cancelled);
  EXPECT_EQ(calls, 2);
  errno = 0;
  EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1) << "no process is left over";
}

TEST_F(CtHelper, ProgressRisesToOne) {
  write(test::Stack{});
  std::vector<double> seen;
  read_ct_series(dir_, [&](double f) { seen.push_back(f); });
  ASSERT_FALSE(seen.empty());
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
  EXPECT_EQ(seen.back(), 1.0);
}

}  // namespace
}  // namespace vallecula::pipeline
