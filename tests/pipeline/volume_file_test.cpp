// NIfTI, NRRD and MetaImage files written byte by byte.
#include "pipeline/dicom/volume_file.h"

#include <zlib.h>

#include <cstring>

#include "tests/pipeline/ct_stack.h"

namespace vallecula::pipeline {
namespace {

constexpr int kSize[3] = {40, 36, 30};

class VolumeFile : public test::CtFolder {
 protected:
  /// A ball of tissue in air, 2 mm voxels, centred at the origin, along index axes that are turned by `axes`.
  static std::int16_t value(int i, int j, int k) {
    return static_cast<std::int16_t>(std::lround(test::scene({2.0 * i - 39, 2.0 * j - 35, 2.0 * k - 29})));
  }
  template <class T>
  static std::string voxels(bool big = false) {
    std::string out;
    for (int k = 0; k < kSize[2]; ++k) {
      for (int j = 0; j < kSize[1]; ++j) {
        for (int i = 0; i < kSize[0]; ++i) {
          const T v = static_cast<T>(value(i, j, k));
          char raw[sizeof(T)];
          std::memcpy(raw, &v, sizeof(T));
          if (big) std::reverse(raw, raw + sizeof(T));
          out.append(raw, sizeof(T));
        }
      }
    }
    return out;
  }
  static std::string gzip(const std::string& bytes) {
    std::string out(compressBound(bytes.size()) + 64, '\0');
    z_stream z{};
    deflateInit2(&z, 6, Z_DEFLATED, 31, 8, Z_DEFAULT_STRATEGY);
    z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    z.avail_in = static_cast<uInt>(bytes.size());
    z.next_out = reinterpret_cast<Bytef*>(out.data());
    z.avail_out = static_cast<uInt>(out.size());
    deflate(&z, Z_FINISH);
    out.resize(z.total_out);
    deflateEnd(&z);
    return out;
  }
  static std::string nrrd_head(const std::string& type = "short", const std::string& encoding = "raw",
                               const std::string& more = "endian: little\n") {
    return "NRRD0004\n# a comment\ntype: " + type +
           "\ndimension: 3\nspace: left-posterior-superior\nsizes: 40 36 30\n" +
           "space directions: (2,0,0) (0,2,0) (0,0,2)\nkinds: domain domain domain\nencoding: " + encoding +
           "\nspace origin: (-39,-35,-29)\n" + more + "\n";
  }
  static std::string meta_head(const std::string& more, const std::string& data = "LOCAL") {
    return "ObjectType = Image\nNDims = 3\nBinaryData = True\n" + more +
           "TransformMatrix = 1 0 0 0 1 0 0 0 1\nOffset = -39 -35 -29\nElementSpacing = 2 2 2\nDimSize = 40 36 30\n"
           "ElementDataFile = " +
           data + "\n";
  }
  /// sform or qform with turned signs, for NIfTI's axes are RAS.
  static std::string nifti(bool sform, bool qform, float slope = 0.0f, std::int16_t type = 4) {
    std::string h(352, '\0');
    const auto put = [&](std::size_t at, auto v) { std::memcpy(h.data() + at, &v, sizeof v); };
    put(0, std::int32_t{348});
    const std::int16_t dim[8] = {3, 40, 36, 30, 1, 1, 1, 1};
    std::memcpy(h.data() + 40, dim, sizeof dim);
    put(70, type);
    const float pixdim[8] = {1.0f, 2.0f, 2.0f, 2.0f, 0, 0, 0, 0};
    std::memcpy(h.data() + 76, pixdim, sizeof pixdim);
    put(108, 352.0f);
    put(112, slope);
    put(116, 0.0f);
    h[123] = 2;
    put(252, std::int16_t{qform});
    put(254, std::int16_t{sform});
    put(264, 1.0f);  // half a turn about z: x and y change sign
    put(268, 39.0f);
    put(272, 35.0f);
    put(276, -29.0f);
    const float rows[12] = {-2, 0, 0, 39, 0, -2, 0, 35, 0, 0, 2, -29};
    std::memcpy(h.data() + 280, rows, sizeof rows);
    std::memcpy(h.data() + 344, "n+1", 4);
    return h;
  }

  void expect_read(const std::string& bytes, const std::string& name) const {
    const auto file = dir_ / name;
    test::write_bytes(bytes, file);
    CtSeries series;
    ASSERT_NO_THROW(series = read_ct_series(file)) << name;
    ASSERT_EQ(series.hu.grid.size, (std::array<int, 3>{40, 36, 30})) << name;
    EXPECT_FALSE(series.resampled);
    EXPECT_LT(norm(series.hu.grid.position(0, 0, 0) - Vector3{-39, -35, -29}), 1e-9) << name;
    std::size_t different = 0;
    for (int k = 0; k < 30; ++k) {
      for (int j = 0; j < 36; ++j) {
        for (int i = 0; i < 40; ++i) different += series.hu.at(i, j, k) != value(i, j, k) ? 1 : 0;
      }
    }
    EXPECT_EQ(different, 0u) << name;
  }
  void expect_refused(const std::string& bytes, const std::string& words, const char* name = "volume.nrrd") const {
    const auto file = dir_ / name;
    test::write_bytes(bytes, file);
    try {
      read_ct_series(file);
      FAIL() << "was read: " << words;
    } catch (const SeriesError& e) {
      EXPECT_NE(std::string(e.what()).find(words), std::string::npos) << e.what();
      EXPECT_EQ(std::string(e.what()).find(dir_.string()), std::string::npos) << e.what();
    }
  }
};

TEST_F(VolumeFile, NrrdInItsEncodings) {
  expect_read(nrrd_head() + voxels<std::int16_t>(), "volume.nrrd");
  expect_read(nrrd_head("int", "gzip", "endian: big\n") + gzip(voxels<std::int32_t>(true)), "volume.nrrd");
  expect_read(nrrd_head("double", "gzip") + gzip(voxels<double>()), "volume.nrrd");
  test::write_bytes(voxels<float>(), dir_ / "beside.raw");
  expect_read(nrrd_head("float", "raw", "endian: little\ndata file: beside.raw\n"), "volume.nhdr");
  auto ras = nrrd_head();
  ras.replace(ras.find("left-posterior"), 14, "right-anterior");
  ras.replace(ras.find("(2,0,0) (0,2,0)"), 15, "(-2,0,0) (0,-2,0)");
  ras.replace(ras.find("(-39,-35,-29)"), 13, "(39,35,-29)");
  expect_read(ras + voxels<std::int16_t>(), "volume.nrrd");
}

TEST_F(VolumeFile, MetaImageWithItsDataInsideAndBeside) {
  expect_read(meta_head("ElementType = MET_SHORT\n") + voxels<std::int16_t>(), "volume.mha");
  expect_read(meta_head("BinaryDataByteOrderMSB = True\nElementType = MET_SHORT\n") + voxels<std::int16_t>(true),
              "volume.mha");
  test::write_bytes(gzip(voxels<float>()), dir_ / "volume.zraw");
  expect_read(meta_head("CompressedData = True\nElementType = MET_FLOAT\n", "volume.zraw"), "volume.mhd");
}

TEST_F(VolumeFile, NiftiByEitherOfItsTransforms) {
  expect_read(nifti(true, false) + voxels<std::int16_t>(), "volume.nii");
  expect_read(nifti(false, true) + voxels<std::int16_t>(), "volume.nii");
  expect_read(gzip(nifti(true, true, 1.0f, 16) + voxels<float>()), "volume.nii.gz");
  expect_refused(nifti(false, false) + voxels<std::int16_t>(), "does not say which side is left", "volume.nii");
}

TEST_F(VolumeFile, ValuesThatAreNoNumberAreAirAndThoseBeyondInt16AreClamped) {
  auto bytes = voxels<float>();
  const float odd[3] = {std::nanf(""), 1e9f, -1e9f};
  std::memcpy(bytes.data(), odd, sizeof odd);
  test::write_bytes(nrrd_head("float") + bytes, dir_ / "volume.nrrd");
  const auto volume = read_ct_volume(dir_ / "volume.nrrd");
  EXPECT_EQ(volume.at(0, 0, 0), -1024);
  EXPECT_EQ(volume.at(1, 0, 0), 32767);
  EXPECT_EQ(volume.at(2, 0, 0), -32768);
  EXPECT_TRUE(noted(volume.notes, "2 voxels lay outside"));
}

TEST_F(VolumeFile, WhatIsNoCtIsRefusedWithItsReason) {
  const auto good = nrrd_head() + voxels<std::int16_t>();
  const auto changed = [&](const std::string& from, const std::string& to) {
    auto text = good;
    return text.replace(text.find(from), from.size(), to);
  };
  expect_refused(good.substr(0, good.size() - 1), "cut short");
  expect_refused(good.substr(0, 100), "header is cut short");
  expect_refused(changed("sizes: 40 36 30", "sizes: 65535 65535 65535"), "more than any CT");
  expect_refused(changed("sizes: 40 36 30", "sizes: -40 36 30"), "no whole number");
  expect_refused(changed("sizes: 40 36 30", "sizes: 1e300 36 30"), "no whole number");
  expect_refused(changed("dimension: 3", "dimension: 4"), "three dimensions");
  expect_refused(changed("space: left-posterior-superior", "space dimension: 3"), "which side is left");
  expect_refused(changed("(2,0,0) (0,2,0)", "(2,0,0) (2,0,0)"), "no place and size");
  expect_refused(changed("(2,0,0)", "(nan,0,0)"), "damaged");
  expect_refused(changed("encoding: raw", "encoding: bzip2"), "neither raw nor gzip");
  expect_refused(changed("type: short", "type: block"), "of a kind no CT has");
  expect_refused(changed("# a comment", "Segment0_Name:=tongue"), "is a segmentation");
  expect_refused(changed("endian: little", "data file: ../other"), "in another folder");
  expect_refused(changed("endian: little", "data file: /etc/hostname"), "in another folder");
  expect_refused(nrrd_head("short", "gzip") + gzip(voxels<std::int16_t>()).substr(0, 900), "cut short");
  expect_refused(meta_head("ElementType = MET_SHORT\n", "LIST"), "spread over several", "volume.mha");
  expect_refused(meta_head("ElementType = MET_SHORT\n").substr(0, 60), "cut short", "volume.mha");
  expect_refused(meta_head("ElementNumberOfChannels = 3\nElementType = MET_SHORT\n"), "of a kind no CT", "volume.mha");
  expect_refused(nifti(true, false).substr(0, 340), "no DICOM file", "volume.nii");
  expect_refused(nifti(true, false), "cut short", "volume.nii");
  expect_refused(std::string(1000, '\0') + "hello", "no DICOM file", "volume.nii");
  std::string labels(good.size(), '\0');
  expect_refused(nrrd_head() + labels, "do not look like Hounsfield units");
}

}  // namespace
}  // namespace vallecula::pipeline
