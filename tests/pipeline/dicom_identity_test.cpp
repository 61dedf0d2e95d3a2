// No message, list or note of the reader tells who the patient is, whatever the files say and are called.
#include "pipeline/dicom/file_list.h"
#include "tests/pipeline/ct_stack.h"

namespace vallecula::pipeline {
namespace {

namespace fs = std::filesystem;
using test::slice_at;
using test::Stack;

class ReaderIdentity : public test::CtFolder {};

TEST_F(ReaderIdentity, NothingThatIdentifiesIsTold) {
  // Every free text, every date, every UID a secret; also in the names of files and folders.
  const auto folder = dir_ / "DOE^JANE_19870401";
  fs::create_directories(folder);
  const Stack s;
  for (int k = 0; k < s.slices; ++k) {
    auto d = slice_at(s, k);
    d.series = "1.2.777.1";
    d.extra[0x0008103e] = {"LO", "SECRET head of Jane"};
    d.extra[0x00081030] = {"LO", "SECRET study"};
    d.extra[0x00080020] = {"DA", "19870401"};
    d.extra[0x00080080] = {"LO", "SECRET hospital"};
    d.extra[0x00181210] = {"SH", "SECRET kernel"};
    d.extra[0x00080008] = {"CS", "SECRET\\TYPE"};
    d.extra[0x00281054] = {"LO", "SECRET"};
    d.extra[0x00091010] = {"LO", "SECRET private"};
    test::write_dicom(d, folder / ("DOE^JANE_" + std::to_string(4711000 + k) + ".dcm"));
  }
  std::string told;
  const auto collect = [&] {
    for (const auto& e : list_series(dir_)) told += described(e) + e.reason + '\n';
    for (const char* choice : {"", "1", "1.2.777.1", "1.2.777.2", "9"}) {
      told += message(choice) + '\n';
      try {
        for (const auto& note : read_ct_volume(dir_, choice).notes) told += note + '\n';
      } catch (const SeriesError& e) {
        told += e.what() + std::string("\n");
      }
    }
  };
  collect();
  const auto victim = folder / "DOE^JANE_4711007.dcm";
  for (const double share : {0.9, 0.1, 0.02}) {
    fs::resize_file(victim, static_cast<std::uintmax_t>(share * static_cast<double>(fs::file_size(victim))));
    collect();
  }
  fs::remove(victim);
  collect();
  EXPECT_NE(told.find("file 8 of 36: is no whole DICOM file"), std::string::npos) << told;
  for (const char* secret : {"SECRET", "Doe", "DOE", "Jane", "JANE", "1987", "777", "4711", "vallecula-read-test"})
    EXPECT_EQ(told.find(secret), std::string::npos) << secret << " in\n" << told;
}

TEST(FileNames, OnlyUsualWordsAndSmallNumbersAreNeutral) {
  for (const char* name : {"IM-0001-0012.dcm", "img12.dcm", "ct-0004.dcm", "I00000012", "Slice_7.ima", "3.dcm",
                           "labels.nrrd", "label.seg.nrrd", "landmarks.mrk.json"})
    EXPECT_TRUE(is_neutral_file_name(name)) << name;
  for (const char* name : {"DOE^JOHN_123.dcm", "1.2.840.113619.2.55.dcm", "CT19870401.dcm", "jane.nii", "IM0047110.dcm",
                           "MRN 12.dcm", "J\xc3\xb6rg.dcm"})
    EXPECT_FALSE(is_neutral_file_name(name)) << name;
  EXPECT_EQ(told_name("/home/jane/labels.nrrd"), "labels.nrrd");
  EXPECT_EQ(told_name("/scans/jane.nii"), "(name withheld)");
}

}  // namespace
}  // namespace vallecula::pipeline
