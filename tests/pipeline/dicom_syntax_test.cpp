// Every transfer syntax and kind of pixel gives the values that were written.
#include "tests/pipeline/ct_stack.h"
#include "tests/pipeline/gdcm_syntax.h"

namespace vallecula::pipeline {
namespace {

namespace fs = std::filesystem;

constexpr int kColumns = 24;
constexpr int kRows = 20;
constexpr int kSlices = 4;

class Syntax : public test::CtFolder {
 protected:
  static int stored(int i, int j, int k) { return (i * 131 + j * 17 + k * 401 + i * j) % 4000; }

  /// Values from `low` on, in words of 16 bits of which `bits` count.
  test::DicomSlice slice(int k, bool is_signed, int bits, int low) const {
    test::DicomSlice d;
    d.columns = kColumns;
    d.rows = kRows;
    d.is_signed = is_signed;
    d.instance = std::to_string(k + 1);
    d.position = test::decimal_string({-10, 20, 3.0 * k});
    d.intercept = "-24";
    for (int j = 0; j < kRows; ++j) {
      for (int i = 0; i < kColumns; ++i)
        d.stored.push_back(static_cast<std::uint16_t>((stored(i, j, k) + low) & ((1 << bits) - 1)));
    }
    d.extra[0x00280101] = {"US", test::bytes_of(static_cast<std::uint32_t>(bits), 2)};
    d.extra[0x00280102] = {"US", test::bytes_of(static_cast<std::uint32_t>(bits - 1), 2)};
    return d;
  }

  void expect_values(int low, const std::string& what) const {
    CtVolume volume;
    ASSERT_NO_THROW(volume = read_ct_volume(dir_)) << what;
    ASSERT_EQ(volume.geometry.size, (std::array<int, 3>{kColumns, kRows, kSlices})) << what;
    EXPECT_LT(norm(volume.geometry.position(0, 0, kSlices - 1) - Vector3{-10, 20, 3.0 * (kSlices - 1)}), 1e-9);
    int different = 0;
    for (int k = 0; k < kSlices; ++k) {
      for (int j = 0; j < kRows; ++j) {
        for (int i = 0; i < kColumns; ++i) different += volume.at(i, j, k) != stored(i, j, k) + low - 24 ? 1 : 0;
      }
    }
    EXPECT_EQ(different, 0) << what;
  }
};

TEST_F(Syntax, EachGivesTheValuesThatWereWritten) {
  int read = 0;
  for (const auto& [name, uid] : test::syntaxes()) {
    for (const auto& [is_signed, bits, low] : {std::tuple{false, 12, 0}, std::tuple{false, 16, 9000},
                                               std::tuple{true, 16, -2000}, std::tuple{true, 13, -2000}}) {
      renew();
      const auto what = name + (is_signed ? ", signed " : ", unsigned ") + std::to_string(bits) + " bits";
      bool can = true;
      for (int k = 0; k < kSlices && can; ++k) {
        const auto file = dir_ / ("i" + std::to_string(k));
        test::write_dicom(slice(k, is_signed, bits, low), file);
        can = test::rewrite(file, file, uid);
      }
      if (!can) continue;
      expect_values(low, what);
      ++read;
    }
  }
  EXPECT_GE(read, 36) << "GDCM of Debian 12 writes nearly all of them";
}

TEST_F(Syntax, WhatStandsInUnusedBitsIsNoPartOfTheValue) {
  for (const bool is_signed : {false, true}) {
    const int low = is_signed ? -2000 : 0;
    renew();
    for (int k = 0; k < kSlices; ++k) {
      auto d = slice(k, is_signed, 12, low);
      for (auto& v : d.stored) v = static_cast<std::uint16_t>(v | 0x5000);
      test::write_dicom(d, dir_ / std::to_string(k));
    }
    if (is_signed) {
      // 0..3999 - 2000 fits 12 signed bits but for what lies above 2047: none does.
      expect_values(low, "signed with an overlay");
    } else {
      expect_values(low, "unsigned with an overlay");
    }
  }
}

TEST_F(Syntax, EightAndThirtyTwoBits) {
  for (int k = 0; k < kSlices; ++k) {
    auto d = slice(k, false, 16, 0);
    std::string pixels;
    for (const auto v : d.stored) pixels += test::bytes_of(v + 70000u, 4);
    d.intercept = "-70024";
    d.extra = {{0x00280100, {"US", test::bytes_of(32, 2)}},
               {0x00280101, {"US", test::bytes_of(32, 2)}},
               {0x00280102, {"US", test::bytes_of(31, 2)}},
               {0x7fe00010, {"OW", pixels}}};
    test::write_dicom(d, dir_ / std::to_string(k));
  }
  expect_values(0, "32 bits");
  renew();
  for (int k = 0; k < kSlices; ++k) {
    auto d = slice(k, false, 16, 0);
    std::string pixels;
    for (const auto v : d.stored) pixels += static_cast<char>(v % 251);
    d.slope = "8";
    d.extra = {{0x00280100, {"US", test::bytes_of(8, 2)}},
               {0x00280101, {"US", test::bytes_of(8, 2)}},
               {0x00280102, {"US", test::bytes_of(7, 2)}},
               {0x7fe00010, {"OW", pixels}}};
    test::write_dicom(d, dir_ / std::to_string(k));
  }
  const auto volume = read_ct_volume(dir_);
  EXPECT_EQ(volume.at(5, 3, 2), stored(5, 3, 2) % 251 * 8 - 24);
}

TEST_F(Syntax, ARescaleOfEachSliceAndFractionsRoundToTheNearest) {
  for (int k = 0; k < kSlices; ++k) {
    auto d = slice(k, false, 12, 0);
    d.slope = std::to_string(k + 1) + ".3";
    d.intercept = std::to_string(-1000 - k) + ".25";
    test::write_dicom(d, dir_ / std::to_string(k));
  }
  const auto volume = read_ct_volume(dir_);
  for (int k = 0; k < kSlices; ++k) {
    const double exact = (k + 1.3) * stored(7, 9, k) - 1000.25 - k;
    EXPECT_LE(std::abs(volume.at(7, 9, k) - exact), 0.5 + 1e-9);
  }
}

}  // namespace
}  // namespace vallecula::pipeline
