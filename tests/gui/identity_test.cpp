// No identity of a patient leaves the source: everything that is written or said after reading a series full of it is
// searched for every identifying value it held.
#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <zlib.h>

#include <cstdint>
#include <cstring>
#include <fstream>
#include <map>

#include "tests/gui/block_patient.h"
#include "tests/gui/program.h"

namespace vallecula::gui::test {
namespace {

namespace fs = std::filesystem;

/// A DICOM file in explicit VR little endian without sequences, as elements in the order of their tags.
class Elements {
 public:
  explicit Elements(const fs::path& file) : bytes_(text_of(file)) {
    for (std::size_t at = 132; at + 8 <= bytes_.size();) {
      const std::uint32_t tag = (number(at, 2) << 16) | number(at + 2, 2);
      const std::string vr = bytes_.substr(at + 4, 2);
      const bool is_long = vr == "OB" || vr == "OW" || vr == "UN" || vr == "UT" || vr == "SQ";
      const std::size_t head = is_long ? 12 : 8;
      const std::size_t length = is_long ? number(at + 8, 4) : number(at + 6, 2);
      elements_[tag] = bytes_.substr(at, head + length);
      at += head + length;
    }
  }
  void put(std::uint32_t tag, const std::string& vr, std::string value) {
    if (value.size() % 2 != 0) value += vr == "UI" ? '\0' : ' ';
    elements_[tag] = element(tag, vr, value);
  }
  void write(const fs::path& file) const {
    std::string out = bytes_.substr(0, 132);
    for (const auto& [tag, element] : elements_) out += element;
    std::ofstream(file, std::ios::binary) << out;
  }
  static std::string element(std::uint32_t tag, const std::string& vr, const std::string& value) {
    std::string t = little(tag >> 16, 2) + little(tag & 0xffff, 2) + vr;
    const bool is_long = vr == "OB" || vr == "UT" || vr == "SQ" || vr == "UN";
    return t + (is_long ? std::string(2, '\0') + little(value.size(), 4) : little(value.size(), 2)) + value;
  }
  static std::string item(const std::string& content) {
    return little(0xfffe, 2) + little(0xe000, 2) + little(content.size(), 4) + content;
  }

 private:
  std::size_t number(std::size_t at, int count) const {
    std::size_t v = 0;
    for (int i = 0; i < count; ++i)
      v |= static_cast<std::size_t>(static_cast<unsigned char>(bytes_.at(at + i))) << (8 * i);
    return v;
  }
  static std::string little(std::size_t v, int count) {
    std::string t;
    for (int i = 0; i < count; ++i) t += static_cast<char>((v >> (8 * i)) & 0xff);
    return t;
  }
  std::string bytes_;
  std::map<std::uint32_t, std::string> elements_;
};

struct Identifying {
  std::uint32_t tag;
  const char* vr;
  const char* value;
};

// Of the attributes that DICOM PS3.15 Table E.1-1 (basic profile) removes, empties or replaces: those a CT may carry,
// each with a value found nowhere else, and private and retired ones.
constexpr Identifying kIdentity[] = {
    {0x00080012, "DA", "19870611"},          {0x00080013, "TM", "101112.131"},
    {0x00080014, "UI", "1.2.826.0.1.77001"}, {0x00080020, "DA", "19870612"},
    {0x00080021, "DA", "19870613"},          {0x00080022, "DA", "19870614"},
    {0x00080023, "DA", "19870615"},          {0x0008002a, "DT", "19870616101113.5"},
    {0x00080030, "TM", "101114.141"},        {0x00080031, "TM", "101115.151"},
    {0x00080032, "TM", "101116.161"},        {0x00080050, "SH", "ACCESSION77"},
    {0x00080080, "LO", "StElsewhere"},       {0x00080081, "ST", "12 Hidden Lane"},
    {0x00080090, "PN", "Referrer^Rita"},     {0x00080092, "ST", "13 Covert Close"},
    {0x00080094, "SH", "5550177"},           {0x00080201, "SH", "+0377"},
    {0x00081010, "SH", "STATION77"},         {0x00081030, "LO", "Study of Jane"},
    {0x0008103e, "LO", "Series of Jane"},    {0x00081040, "LO", "WardNine"},
    {0x00081048, "PN", "Record^Rhea"},       {0x00081050, "PN", "Perform^Pia"},
    {0x00081060, "PN", "Reading^Rob"},       {0x00081070, "PN", "Operator^Ole"},
    {0x00081080, "LO", "DiagnosisSecret"},   {0x00084000, "LT", "Retired remark"},
    {0x00100010, "PN", "Doe^Janet"},         {0x00100020, "LO", "MRN-0077"},
    {0x00100021, "LO", "IssuerOfIds"},       {0x00100030, "DA", "19870601"},
    {0x00100032, "TM", "040506.070"},        {0x00101000, "LO", "OTHERID77"},
    {0x00101001, "PN", "Othername^Jo"},      {0x00101005, "PN", "Birthname^Jo"},
    {0x00101040, "LO", "7 Secret Street"},   {0x00101060, "PN", "Mother^Maiden"},
    {0x00102000, "LO", "AlertMedical"},      {0x00102110, "LO", "AllergyCats"},
    {0x00102150, "LO", "Atlantis"},          {0x00102154, "SH", "5550199"},
    {0x00102160, "SH", "EthnicSecret"},      {0x00102180, "SH", "OccupationSpy"},
    {0x001021b0, "LT", "HistorySecret"},     {0x00104000, "LT", "CommentSecret"},
    {0x00181000, "LO", "SERIAL-7788"},       {0x00181030, "LO", "ProtocolJane"},
    {0x00181400, "LO", "ProcessingJane"},    {0x0020000d, "UI", "1.2.826.0.1.77002"},
    {0x0020000e, "UI", "1.2.826.0.1.77003"}, {0x00200010, "SH", "STUDYID77"},
    {0x00200052, "UI", "1.2.826.0.1.77004"}, {0x00204000, "LT", "ImageCommentJane"},
    {0x00321032, "PN", "Requester^Ruth"},    {0x00324000, "LT", "StudyCommentJane"},
    {0x00380010, "LO", "ADMISSION77"},       {0x00380300, "LO", "BedSeventySeven"},
    {0x00380500, "LO", "PatientStateSecret"}, {0x00400244, "DA", "19870617"},
    {0x00400245, "TM", "101117.171"},        {0x00400253, "SH", "STEPID77"},
    {0x00400254, "LO", "StepDescription"},   {0x00402017, "LO", "FILLER77"},
    {0x00090010, "LO", "PRIVATECREATOR77"},  {0x00091001, "LO", "PrivateJane"},
    {0x00091002, "UN", "PrivateBytesJane"}};

/// In a sequence and in an item of it.
constexpr const char* kNested = "NESTEDID77";
constexpr const char* kFolder = "DOE_JANET_1987";
constexpr const char* kFile = "MRN0077SLICE";

void identify(const fs::path& clean, const fs::path& named) {
  fs::create_directories(named);
  int n = 0;
  for (const auto& entry : fs::directory_iterator(clean)) {
    if (entry.path().extension() != ".dcm") continue;
    Elements elements(entry.path());
    for (const Identifying& e : kIdentity) elements.put(e.tag, e.vr, e.value);
    std::string nested = kNested;
    elements.put(0x00101002, "SQ", Elements::item(Elements::element(0x00100020, "LO", nested)));
    elements.put(0x00080018, "UI", "1.2.826.0.1.77005." + std::to_string(++n));
    elements.write(named / (kFile + std::to_string(n) + ".dcm"));
  }
  ASSERT_GT(n, 50);
}

std::string inflated(const std::string& packed) {
  std::string out(std::size_t{1} << 16, '\0'), all;
  z_stream stream{};
  inflateInit2(&stream, 15 + 32);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  int state = Z_OK;
  while (state == Z_OK) {
    stream.next_out = reinterpret_cast<Bytef*>(out.data());
    stream.avail_out = static_cast<uInt>(out.size());
    state = inflate(&stream, Z_NO_FLUSH);
    all.append(out, 0, out.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  return all;
}

/// Text that VTK's files keep packed.
template <class Reader>
std::string strings_of(const fs::path& file) {
  vtkNew<Reader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  std::string all;
  for (vtkFieldData* fields :
       {reader->GetOutput()->GetFieldData(), static_cast<vtkFieldData*>(reader->GetOutput()->GetPointData()),
        static_cast<vtkFieldData*>(reader->GetOutput()->GetCellData())})
    for (int i = 0; i < fields->GetNumberOfArrays(); ++i) {
      all += std::string(fields->GetAbstractArray(i)->GetName()) + "\n";
      if (auto* text = vtkStringArray::SafeDownCast(fields->GetAbstractArray(i)))
        for (vtkIdType k = 0; k < text->GetNumberOfValues(); ++k) all += text->GetValue(k) + "\n";
    }
  return all;
}

/// The file's bytes, and what it holds packed.
std::string all_of(const fs::path& file) {
  std::string text = text_of(file);
  const std::string packed_after = "encoding: gzip";
  const auto header_end = text.find("\n\n");
  if (file.extension() == ".nrrd" && text.find(packed_after) < header_end) text += inflated(text.substr(header_end + 2));
  if (file.extension() == ".vtp") text += strings_of<vtkXMLPolyDataReader>(file);
  if (file.extension() == ".vtu") text += strings_of<vtkXMLUnstructuredGridReader>(file);
  return text;
}

void expect_nobody(const std::string& text, const std::string& where, bool folder_may_be_named) {
  for (const Identifying& e : kIdentity) EXPECT_EQ(text.find(e.value), std::string::npos) << where << " holds " << e.value;
  // Names without the DICOM separator, and the UIDs of the slices.
  for (const char* part : {"Janet", "Doe^", kNested, "1.2.826.0.1.77005", kFile})
    EXPECT_EQ(text.find(part), std::string::npos) << where << " holds " << part;
  if (!folder_may_be_named) {
    EXPECT_EQ(text.find(kFolder), std::string::npos) << where << " holds the folder's name";
  }
}

TEST(Identity, NothingWrittenOrSaidHoldsAnyOfIt) {
  const Sandbox box;
  ASSERT_EQ(box.run({"manikin", "--out", (box / "clean").string(), "--weight", "0.8"}).exit_code, 0);
  const fs::path source = box / kFolder;
  identify(box / "clean", source);
  const fs::path temporary = box / "tmp";
  fs::create_directory(temporary);
  const std::vector<std::string> environment = {"TMPDIR=" + temporary.string()};
  const auto say = [&](const std::vector<std::string>& arguments, int exit_code) {
    const Outcome outcome = box.run(arguments, environment);
    EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
    // A person is told the folder that the person named.
    expect_nobody(outcome.out + outcome.err, arguments[0] + "'s words", true);
  };
  const fs::path made = box / "made";
  fs::create_directory(made);
  const std::string patient = (made / "infant.patient").string();
  say({"import", source.string(), "--out", patient}, 0);
  const fs::path press = write_press(box.folder());
  say({"trial", "--patient", patient, "--scenario", write_curriculum(box.folder()).string() + ":plain", "--device",
       "scripted:" + press.string(), "--headless", "--asap", "--out", (made / "trial").string()},
      0);
  for (const fs::path& folder : {made, box.home(), temporary})
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      expect_nobody(entry.path().string().substr(box.folder().string().size()), "a file's name", false);
      if (entry.is_regular_file()) expect_nobody(all_of(entry.path()), entry.path().filename().string(), false);
    }

  // What goes wrong is told without it too: a slice cut short, one missing, one of another modality.
  const fs::path first = source / (std::string(kFile) + "1.dcm");
  const std::string whole = text_of(first);
  write_text(first, whole.substr(0, whole.size() / 2));
  say({"import", source.string(), "--out", (box / "other.patient").string()}, 1);
  fs::remove(first);
  say({"import", (box / "nowhere").string(), "--out", (box / "other.patient").string()}, 1);
  for (const auto& entry : fs::directory_iterator(source)) {
    Elements elements(entry.path());
    elements.put(0x00080060, "CS", "MR");
    elements.write(entry.path());
  }
  say({"import", source.string(), "--out", (box / "other.patient").string()}, 1);
}

}  // namespace
}  // namespace vallecula::gui::test
