// The library is found, or it is said exactly what was looked for and what is wrong.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "device/drivers/hdapi/hd_library.h"

namespace vallecula::device::hdapi {
namespace {

namespace fs = std::filesystem;

class HdapiLibrary : public ::testing::Test {
 protected:
  HdapiLibrary() : folder_(fs::temp_directory_path() / ("vallecula-hdapi-" + std::to_string(getpid()))) {
    fs::create_directories(folder_);
  }
  ~HdapiLibrary() override { fs::remove_all(folder_); }

  static std::string error_of(const std::vector<std::string>& paths) {
    try {
      load_library(paths);
    } catch (const HdError& error) {
      EXPECT_FALSE(error.problem.empty());
      EXPECT_FALSE(error.mend.empty());
      return error.what();
    }
    return "loaded";
  }
  /// The stand-in with one byte changed.
  std::string spoilt(std::size_t at, char value) const {
    std::ifstream in(VALLECULA_STAND_IN_HD, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(in), {}};
    bytes.at(at) = value;
    const fs::path file = folder_ / ("spoilt-" + std::to_string(at) + ".so");
    std::ofstream(file, std::ios::binary) << bytes;
    return file.string();
  }
  bool says(const std::string& text, const std::string& part) const { return text.find(part) != std::string::npos; }

  const fs::path folder_;
};

TEST_F(HdapiLibrary, TheVariableIsTriedFirstThenTheLoaderThenTheInstallersPlaces) {
  setenv("VALLECULA_LIBHD", "/chosen/libHD.so", 1);
  const auto paths = library_paths();
  unsetenv("VALLECULA_LIBHD");
  const auto without = library_paths();
  ASSERT_EQ(paths.size(), without.size() + 1);
  EXPECT_EQ(paths[0], "/chosen/libHD.so");
  EXPECT_EQ(paths[1], "libHD.so");
  EXPECT_EQ(without[0], "libHD.so");
}

TEST_F(HdapiLibrary, NoLibraryNamesEveryPathTried) {
  const std::vector<std::string> paths = {(folder_ / "a" / "libHD.so").string(), (folder_ / "b.so").string()};
  const std::string error = error_of(paths);
  for (const std::string& path : paths) EXPECT_TRUE(says(error, path + ": not there")) << error;
  EXPECT_TRUE(says(error, "Install OpenHaptics")) << error;
  EXPECT_LT(error.find("Install OpenHaptics"), error.find(paths[0])) << "the mend before what was tried: " << error;
  EXPECT_TRUE(says(error, "VALLECULA_LIBHD")) << error;
}

TEST_F(HdapiLibrary, WhatTheVariableNamesIsToldWithoutItsFolder) {
  const std::string file = (folder_ / "libHD.so").string();
  setenv("VALLECULA_LIBHD", file.c_str(), 1);
  const std::string error = error_of({file});
  unsetenv("VALLECULA_LIBHD");
  EXPECT_TRUE(says(error, "$VALLECULA_LIBHD: not there")) << error;
  EXPECT_FALSE(says(error, folder_.string())) << error;
}

TEST_F(HdapiLibrary, AFileThatIsNoLibraryIsSaidSo) {
  const fs::path file = folder_ / "libHD.so";
  std::ofstream(file) << "this is a text, and longer than the header of a library would have to be, by a good deal";
  const std::string error = error_of({file.string()});
  EXPECT_TRUE(says(error, "ELF")) << error;
  EXPECT_TRUE(says(error, "damaged")) << error;
}

TEST_F(HdapiLibrary, ALibraryForAnotherProcessorIsSaidSo) {
  const std::string narrow = error_of({spoilt(4, 1)});  // EI_CLASS: 32 bits
  EXPECT_TRUE(says(narrow, "processor")) << narrow;
  const std::string other = error_of({spoilt(18, static_cast<char>(0xB7))});  // e_machine: another one
  EXPECT_TRUE(says(other, "processor")) << other;
}

TEST_F(HdapiLibrary, ALibraryThatLacksFunctionsNamesThem) {
  const std::string error = error_of({VALLECULA_STAND_IN_HD_LACKING});
  EXPECT_TRUE(says(error, "hdEndFrame, hdCheckCalibration")) << error;
  EXPECT_FALSE(says(error, "hdInitDevice")) << error;
  EXPECT_TRUE(says(error, "3.4")) << error;
}

TEST_F(HdapiLibrary, TheFirstThatLoadsIsTaken) {
  const Functions hd = load_library({(folder_ / "none.so").string(), VALLECULA_STAND_IN_HD});
  EXPECT_EQ(hd.get_error().code, kSuccess);
}

}  // namespace
}  // namespace vallecula::device::hdapi
