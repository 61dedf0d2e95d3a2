// Files that are cut, damaged or lie: always a SeriesError (or, where a byte did no harm, a volume), soon, and within a
// bounded memory. The process that reads is another one; this one must never notice more than the error.
#include <sys/resource.h>

#include <chrono>
#include <random>

#include "pipeline/dicom/whole_file.h"
#include "tests/pipeline/ct_stack.h"
#include "tests/pipeline/gdcm_syntax.h"

namespace vallecula::pipeline {
namespace {

namespace fs = std::filesystem;

class Damage : public test::CtFolder {
 protected:
  static test::DicomSlice slice(int k) {
    test::DicomSlice d;
    d.columns = 16;
    d.rows = 12;
    d.instance = std::to_string(k + 1);
    d.position = test::decimal_string({0, 0, 2.0 * k});
    for (int i = 0; i < 16 * 12; ++i) d.stored.push_back(static_cast<std::uint16_t>(i * 19 + k));
    return d;
  }
  /// Three good slices and a fourth that is `bytes`.
  void write(const std::string& bytes) const {
    for (int k = 0; k < 3; ++k) test::write_dicom(slice(k), dir_ / ("IM" + std::to_string(k)));
    test::write_bytes(bytes, victim());
  }
  fs::path victim() const { return dir_ / "IM3.dcm"; }

  /// "" when a volume came out, else the message; anything but SeriesError fails the test.
  std::string told() const {
    const auto start = std::chrono::steady_clock::now();
    std::string message;
    try {
      read_ct_volume(dir_);
    } catch (const SeriesError& e) {
      message = e.what();
    }
    EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 30.0);
    EXPECT_EQ(message.find("Doe"), std::string::npos) << message;
    EXPECT_EQ(message.find(dir_.string()), std::string::npos) << message;
    return message;
  }
  void expect_refused(const std::string& bytes, const std::string& words, const std::string& what) const {
    write(bytes);
    const auto message = told();
    EXPECT_NE(message.find(words), std::string::npos) << what << ": " << message;
  }
  static std::string with(std::uint32_t tag, const char* vr, const std::string& value) {
    auto d = slice(3);
    d.extra[tag] = {vr, value};
    return test::dicom_bytes(d);
  }
  void TearDown() override {
    rusage children{};
    getrusage(RUSAGE_CHILDREN, &children);
    EXPECT_LT(children.ru_maxrss, 600 * 1024) << "KiB: a header must not decide how much memory is used";
    CtFolder::TearDown();
  }
};

TEST_F(Damage, CutAnywhereIsNamed) {
  const auto whole = test::dicom_bytes(slice(3));
  std::vector<std::size_t> lengths = {0, 1, 127, 128, 131, 132, 133, whole.size() - 1, whole.size() - 2};
  for (std::size_t n = 136; n + 1 < whole.size(); n += n < 900 ? 13 : 101) lengths.push_back(n);
  for (const auto n : lengths) expect_refused(whole.substr(0, n), "(IM3.dcm)", "cut to " + std::to_string(n));
}

TEST_F(Damage, PackedFilesCutAnywhereAreNamed) {
  for (const auto& [name, uid] : test::syntaxes()) {
    write(test::dicom_bytes(slice(3)));
    ASSERT_TRUE(test::rewrite(victim(), victim(), uid)) << name;
    ASSERT_EQ(told(), "") << name;
    const auto size = fs::file_size(victim());
    for (int part = 1; part < 8; ++part) {
      fs::resize_file(victim(), size * static_cast<unsigned>(8 - part) / 8);
      EXPECT_NE(told().find("(IM3.dcm)"), std::string::npos)
          << name << " cut to " << 8 - part << "/8 of " << size << ": " << told();
    }
  }
}

TEST_F(Damage, HeadersThatLieAboutSizesAreRefusedBeforeAnythingIsAllocated) {
  const auto us = [](std::uint32_t v) { return test::bytes_of(v, 2); };
  expect_refused(with(0x00280010, "US", us(0)), "has no picture", "no rows");
  expect_refused(with(0x00280011, "US", us(0)), "has no picture", "no columns");
  expect_refused(with(0x00280010, "US", us(13)), "cut short", "one row more than there is");
  auto huge = slice(3);
  huge.extra[0x00280010] = {"US", us(65535)};
  huge.extra[0x00280011] = {"US", us(65535)};
  expect_refused(test::dicom_bytes(huge), "asks for 65535 x 65535", "65535 x 65535");
  huge.extra[0x00280010] = {"US", us(8000)};
  huge.extra[0x00280011] = {"US", us(8000)};
  expect_refused(test::dicom_bytes(huge), "cut short", "8000 x 8000");
  for (const char* frames : {"2147483648", "-5", "0", "99999999999999999999", "16385", "NaN"})
    EXPECT_NE((write(with(0x00280008, "IS", frames)), told()), "") << frames << " frames";
  for (const std::uint32_t bits : {0u, 1u, 12u, 13u, 64u, 65535u})
    expect_refused(with(0x00280100, "US", us(bits)), "bits a voxel", std::to_string(bits) + " bits");
  for (const std::uint32_t bits : {0u, 17u, 65535u})
    EXPECT_NE((write(with(0x00280101, "US", us(bits))), told()), "") << bits << " bits stored";
  EXPECT_NE((write(with(0x00280102, "US", us(40))), told()), "") << "high bit 40";
  expect_refused(with(0x00281053, "DS", "0"), "rescale gives no HU", "slope 0");
  expect_refused(with(0x00281053, "DS", "1e400"), "is not a number", "slope beyond a double");
  expect_refused(with(0x00280030, "DS", "0\\1"), "PixelSpacing", "spacing 0");
  expect_refused(with(0x00280030, "DS", "-1\\1"), "PixelSpacing", "spacing below 0");
  expect_refused(with(0x00280030, "DS", "1"), "wrong number of values", "one spacing");
  expect_refused(with(0x00200037, "DS", "0\\0\\0\\0\\0\\0"), "ImageOrientationPatient", "no direction");
  expect_refused(with(0x00200032, "DS", "1e30\\0\\0"), "ImagePositionPatient", "far away");
  expect_refused(with(0x00200032, "DS", "\\\\"), "ImagePositionPatient", "empty values");
  expect_refused(with(0x00280010, "US", ""), "has no picture", "rows without a value");
}

/// A compressed picture whose own header asks for far more than the DICOM header does.
TEST_F(Damage, StreamsThatLieAboutTheirSizeStayBounded) {
  write(test::dicom_bytes(slice(3)));
  ASSERT_TRUE(test::rewrite(victim(), victim(), "1.2.840.10008.1.2.4.90"));
  std::ifstream in(victim(), std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(in)), {});
  in.close();
  const auto siz = bytes.find("\xff\x4f\xff\x51");
  ASSERT_NE(siz, std::string::npos);
  for (const std::size_t at : {siz + 8, siz + 12}) {  // the picture's width, its height
    auto lying = bytes;
    lying.replace(at, 4, "\x00\x00\xff\xff", 4);
    test::write_bytes(lying, victim());
    EXPECT_NE(told(), "") << at - siz;
  }
}

TEST_F(Damage, DeepAndCyclicSequencesAreRefused) {
  const auto undefined = test::bytes_of(0xffffffffU, 4);
  const auto item = test::bytes_of(0xe000fffe, 4);
  const auto end_item = test::bytes_of(0xe00dfffe, 4) + test::bytes_of(0, 4);
  const auto end_sequence = test::bytes_of(0xe0ddfffe, 4) + test::bytes_of(0, 4);
  const auto open = test::bytes_of(0x11400008, 4) + "SQ" + std::string(2, '\0');
  const auto base = test::dicom_bytes(slice(3));
  const auto at = base.find(test::bytes_of(0x00100010, 4) + "PN");
  ASSERT_NE(at, std::string::npos);
  const auto put_in = [&](const std::string& what) { return base.substr(0, at) + what + base.substr(at); };
  for (const int depth : {40, 2000, 100000}) {
    std::string nested;
    std::string closing;
    for (int n = 0; n < depth; ++n) {
      nested += open + undefined + item + undefined;
      closing += end_item + end_sequence;
    }
    expect_refused(put_in(nested + closing), "(IM3.dcm)", "nested and closed");
    expect_refused(put_in(nested), "(IM3.dcm)", "nested and never closed");
  }
  // Lengths stated, each level 20 bytes shorter: 16000 deep.
  std::string stated;
  for (std::uint32_t n = 16000; n > 0; --n)
    stated += open + test::bytes_of(20 * n - 12, 4) + item + test::bytes_of(20 * (n - 1), 4);
  write(put_in(stated));
  told();
  // An item that claims to hold what comes before it ends, itself, everything.
  for (const std::uint32_t length : {0u, 1u, 7u, 0x7fffffffU, 0xfffffffeU}) {
    write(put_in(open + undefined + item + test::bytes_of(length, 4)));
    EXPECT_NE(told(), "") << "item of length " << length;
    write(put_in(open + test::bytes_of(length, 4) + item + test::bytes_of(8, 4)));
    EXPECT_NE(told(), "") << "sequence of length " << length;
  }
}

TEST_F(Damage, FlippedBytesNeverDoMoreThanAnError) {
  std::mt19937 random(7);
  std::vector<std::string> sources = {test::dicom_bytes(slice(3))};
  for (const char* uid : {"1.2.840.10008.1.2", "1.2.840.10008.1.2.1.99", "1.2.840.10008.1.2.5",
                          "1.2.840.10008.1.2.4.70", "1.2.840.10008.1.2.4.80", "1.2.840.10008.1.2.4.90"}) {
    write(sources[0]);
    ASSERT_TRUE(test::rewrite(victim(), victim(), uid));
    std::ifstream in(victim(), std::ios::binary);
    sources.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  int errors = 0;
  for (const auto& source : sources) {
    for (int n = 0; n < 25; ++n) {
      auto bytes = source;
      for (int flips = 1 + n % 4; flips > 0; --flips) bytes[random() % bytes.size()] = static_cast<char>(random());
      write(bytes);
      errors += told().empty() ? 0 : 1;
    }
  }
  EXPECT_GT(errors, 25);
}

TEST_F(Damage, AnyFileAtAllIsRefusedOrLeftAlone) {
  for (int k = 0; k < 3; ++k) test::write_dicom(slice(k), dir_ / ("IM" + std::to_string(k)));
  std::mt19937 random(3);
  for (int n = 0; n < 20; ++n) {
    std::string noise(random() % 3000, '\0');
    for (char& c : noise) c = static_cast<char>(random());
    if (n % 2 == 0) noise = std::string(128, '\0') + "DICM" + noise;
    test::write_bytes(noise, dir_ / "noise");
    told();
    test::write_bytes(noise, dir_ / "alone");
    EXPECT_THROW(read_ct_volume(dir_ / "alone"), SeriesError);
  }
  fs::remove(dir_ / "noise");
  fs::remove(dir_ / "alone");
  EXPECT_EQ(told(), "");
}

TEST(DicomCheck, FindsTheModalityAndSeriesOfADamagedFile) {
  test::DicomSlice d;
  d.modality = "MR";
  const auto bytes = test::dicom_bytes(d);
  const auto check = check_dicom(std::string_view(bytes).substr(0, bytes.size() - 3));
  EXPECT_TRUE(check.dicom);
  EXPECT_FALSE(check.fault.empty());
  EXPECT_EQ(check.modality, "MR");
  EXPECT_EQ(check.series, "1.2.3.4.5");
}

}  // namespace
}  // namespace vallecula::pipeline
