// The command line itself: what it lists, and what it answers to wrong usage and to bad input.
#include <gtest/gtest.h>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <cstdlib>
#include <sstream>

#include "gui/commands/number_options.h"
#include "gui/session/user_paths.h"
#include "pipeline/dicom/write_series.h"
#include "pipeline/package/label_map.h"
#include "pipeline/package/patient_package.h"
#include "tests/gui/block_patient.h"
#include "tests/gui/program.h"

namespace vallecula::gui::test {
namespace {

namespace fs = std::filesystem;

/// One line on stderr, the message, and nothing on stdout.
void expect_refused(const Outcome& outcome, int exit_code, const std::string& naming) {
  EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
  ASSERT_EQ(outcome.messages().size(), 1u) << outcome.err;
  EXPECT_EQ(outcome.err, outcome.messages()[0] + "\n") << "nothing but the message";
  EXPECT_NE(outcome.err.find(naming), std::string::npos) << "names " << naming << ": " << outcome.err;
  EXPECT_EQ(outcome.out, "");
}

TEST(CommandLine, HelpListsTheCommandsOwedNowAndEachHasItsOwn) {
  const Sandbox box;
  const Outcome help = box.run({"--help"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_EQ(help.err, "");
  for (const std::string command : {"demo", "manikin", "import", "series", "compare", "export", "devices", "trial",
                                    "replay", "score", "records", "curriculum", "lab"}) {
    EXPECT_NE(help.out.find("\n  " + command + " "), std::string::npos) << command << "\n" << help.out;
    EXPECT_EQ(box.run({command, "--help"}).exit_code, 0) << command;
  }
}

TEST(CommandLine, VersionIsTheProjects) {
  const Sandbox box;
  const Outcome version = box.run({"--version"});
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_EQ(version.out.rfind("vallecula ", 0), 0u) << version.out;
}

TEST(CommandLine, WrongUsageIsTwo) {
  const Sandbox box;
  expect_refused(box.run({"intubate"}), 2, "unknown command 'intubate'");
  expect_refused(box.run({"--colour"}), 2, "--colour");
  expect_refused(box.run({"score"}), 2, "TRIAL");
  expect_refused(box.run({"score", "a", "--colour"}), 2, "--colour");
  expect_refused(box.run({"score", "a", "b"}), 2, "'b'");
  expect_refused(box.run({"curriculum"}), 2, "subcommand");
  expect_refused(box.run({"curriculum", "eat", "a"}), 2, "eat");
  expect_refused(box.run({"import", "series"}), 2, "--out");
  expect_refused(box.run({"import", "series", "--out", "a.patient", "--seed", "tongue=1,2"}), 2, "tongue=1,2");
  expect_refused(box.run({"compare", "a.nrrd"}), 2, "B is required");
  expect_refused(box.run({"export", "a.patient"}), 2, "--stl");
  expect_refused(box.run({"import", "series", "--window", "--out", "a.patient"}), 2, "--out");
  expect_refused(box.run({"import", "series", "--window", "--generic-face"}), 2, "--generic-face");
  expect_refused(box.run({"import", "series", "--window"}), 1, "no window can be opened");
  const std::vector<std::string> trial = {"trial", "--patient", "p", "--scenario", "s", "--out", "o", "--device"};
  const auto with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all = trial;
    all.insert(all.end(), more.begin(), more.end());
    return box.run(all);
  };
  expect_refused(with({"joystick"}), 2, "joystick");
  expect_refused(with({"scripted:acrobat"}), 2, "scripted:acrobat");
  expect_refused(with({"scripted"}), 2, "scripted");
  for (const std::string live : {"mouse", "touch", "falcon", "spacemouse:A17"}) {
    expect_refused(with({live, "--headless"}), 2, live);
    expect_refused(with({live, "--headless", "--asap"}), 2, "real time");
  }
  expect_refused(with({"mouse", "--asap"}), 2, "--asap");
}

TEST(ImportCommand, EditsThatCannotBeMeantAreWrongUsage) {
  const Sandbox box;
  const auto refused = [&](const std::vector<std::string>& edits, const std::string& naming) {
    std::vector<std::string> all = {"import", "series", "--out", "a.patient"};
    all.insert(all.end(), edits.begin(), edits.end());
    expect_refused(box.run(all), 2, naming);
  };
  refused({"--seed", "tongue=1,2"}, "tongue=1,2");
  refused({"--seed", "tongue=1,2,3,4"}, "tongue=1,2,3,4");
  refused({"--seed", "tongue=1,nan,3"}, "tongue");
  refused({"--seed", "toe=1,2,3"}, "toe");
  refused({"--seed", "tongue=1,2,3", "--seed", "tongue=1,2,4"}, "twice");
  refused({"--threshold", "bone_skull=300"}, "bone_skull=300");
  refused({"--threshold", "bone_skull=300,200"}, "bone_skull");
  refused({"--threshold", "liver=1,2"}, "liver");
  refused({"--threshold", "skin=-400,3000"}, "no highest");
  refused({"--threshold", "skin=-400", "--threshold", "airway=-1024,-500"}, "airway and skin");
  refused({"--labels", "l.nii", "--label-value", "tongue=1.5"}, "tongue=1.5");
  refused({"--labels", "l.nii", "--label-value", "liver=1"}, "liver");
  refused({"--labels", "l.nii", "--label-value", "tongue=1", "--label-value", "airway=1"}, "twice");
  refused({"--label-value", "tongue=1"}, "--labels");
}

TEST(CompareCommand, PrintsATableAndJson) {
  const Sandbox box;
  pipeline::Grid grid;
  grid.size = {10, 10, 10};
  pipeline::Labels a(grid), b(grid);
  for (int z = 2; z < 6; ++z) {
    for (int y = 2; y < 6; ++y) {
      for (int x = 2; x < 6; ++x) a.at(x, y, z) = b.at(x + 1, y, z) = pipeline::kTongue;
    }
  }
  b.at(0, 0, 0) = pipeline::kAirway;
  pipeline::write_label_map(a, box / "a.nrrd");
  pipeline::write_label_map(b, box / "b.nrrd");
  const std::string first = (box / "a.nrrd").string();
  const std::string second = (box / "b.nrrd").string();
  const Outcome table = box.run({"compare", first, second});
  EXPECT_EQ(table.exit_code, 0) << table.err;
  EXPECT_NE(table.out.find("0.7500"), std::string::npos) << "3 of 4 layers overlap\n" << table.out;
  EXPECT_NE(table.out.find("only in B"), std::string::npos) << table.out;
  const Outcome json = box.run({"compare", first, second, "--json"});
  const auto root = QJsonDocument::fromJson(QByteArray::fromStdString(json.out)).object();
  const auto structures = root["structures"].toArray();
  ASSERT_EQ(structures.size(), 2) << json.out;
  EXPECT_EQ(structures[0].toObject()["name"].toString(), "tongue");
  EXPECT_EQ(structures[0].toObject()["dice"].toDouble(), 0.75);
  EXPECT_EQ(structures[0].toObject()["hausdorff_mm"].toDouble(), 1.0);
  EXPECT_TRUE(structures[1].toObject()["hausdorff_mm"].isNull());
  expect_refused(box.run({"compare", first, (box / "labels8.nrrd").string()}), 1, "labels8.nrrd");
  write_text(box / "labels9.nrrd", "not a label map");
  expect_refused(box.run({"compare", (box / "labels9.nrrd").string(), first}), 1, "labels9.nrrd");
  // A name that may be a person's is withheld: then it is said which of the two is meant.
  const std::string named = (box / "Doe_Jane.nrrd").string();
  expect_refused(box.run({"compare", named, first}), 1, "A: label map (name withheld)");
  expect_refused(box.run({"compare", first, named}), 1, "B: label map (name withheld)");
}

TEST(ExportCommand, WritesSurfacesAndLeavesThePackage) {
  const Sandbox box;
  write_block_patient(box.folder());
  const Outcome outcome = box.run({"export", (box / "block.patient").string(), "--stl", (box / "stl").string()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("tongue.stl"), std::string::npos);
  EXPECT_TRUE(fs::exists(box / "stl" / "face.stl"));
  EXPECT_NO_THROW(pipeline::read_package(box / "block.patient"));
  expect_refused(box.run({"export", (box / "none.patient").string(), "--stl", (box / "stl").string()}), 1,
                 "none.patient");
}

/// The same files read and measured by SimpleITK, nibabel, pydicom and scipy (the recipe in tests/truth).
TEST(CompareCommand, AgreesWithOtherPrograms) {
  const char* python = std::getenv("VALLECULA_PYTHON");
  if (python == nullptr)
    GTEST_SKIP() << "VALLECULA_PYTHON names no Python with SimpleITK, nibabel, pydicom, scipy and meshio";
  const std::string command = std::string(python) + " " VALLECULA_SOURCE_DIR "/tests/truth/exchange_formats.py " +
                              VALLECULA_BINARY_DIR "/vallecula";
  EXPECT_EQ(std::system(command.c_str()), 0);
}

TEST(CommandLine, WhatIsMissingIsNamed) {
  const Sandbox box;
  const std::string nothing = (box / "nothing").string();
  expect_refused(box.run({"score", nothing}), 1, nothing);
  expect_refused(box.run({"replay", nothing, "--verify"}), 1, nothing);
  expect_refused(box.run({"curriculum", "check", nothing}), 1, nothing);
  const fs::path curriculum = write_curriculum(box.folder());
  expect_refused(box.run({"trial", "--patient", nothing, "--scenario", curriculum.string() + ":plain", "--device",
                          "scripted:press", "--headless", "--out", (box / "out").string()}),
                 1, nothing);
  EXPECT_FALSE(fs::exists(box / "out"));
}

TEST(CurriculumCommand, FirstStepsIsMeantWhenNoneIsNamedWhateverElseIsShipped) {
  ::unsetenv("VALLECULA_CURRICULA");
  EXPECT_EQ(default_curriculum().filename(), "first-steps.yaml");
  const Sandbox box;
  ::setenv("VALLECULA_CURRICULA", box.folder().c_str(), 1);
  write_text(box / "b.yaml", "");
  write_text(box / "a.yaml", "");
  EXPECT_EQ(default_curriculum().filename(), "a.yaml");
  ::unsetenv("VALLECULA_CURRICULA");
}

TEST(CurriculumCommand, AcceptsTheShippedOneAndNamesTheLineOfAnError) {
  const Sandbox box;
  for (const auto& entry : fs::directory_iterator(fs::path(VALLECULA_SOURCE_DIR) / "curricula" / "courses")) {
    if (entry.path().extension() != ".yaml") continue;
    const Outcome outcome = box.run({"curriculum", "check", entry.path().string()});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  }
  const fs::path file = write_curriculum(box.folder());
  const Outcome good = box.run({"curriculum", "check", file.string()});
  EXPECT_EQ(good.exit_code, 0) << good.err;
  EXPECT_NE(good.out.find("plain"), std::string::npos);
  std::string text = text_of(file);
  text.replace(text.find("max_attempt_s: 40"), 17, "max_attempt_s: ten");
  write_text(file, text);
  const Outcome bad = box.run({"curriculum", "check", file.string()});
  expect_refused(bad, 1, "max_attempt_s");
  EXPECT_NE(bad.err.find("ten"), std::string::npos) << bad.err;
  EXPECT_NE(bad.err.find("plain.yaml:12"), std::string::npos) << "the line: " << bad.err;
}

/// Import may show progress on stderr before it fails.
void expect_import_refused(const Sandbox& box, const fs::path& series, const std::string& naming) {
  const Outcome outcome = box.run({"import", series.string(), "--out", (box / "p.patient").string()});
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  ASSERT_EQ(outcome.messages().size(), 1u) << outcome.err;
  EXPECT_NE(outcome.messages()[0].find(naming), std::string::npos) << outcome.err;
  EXPECT_FALSE(fs::exists(box / "p.patient"));
}

TEST(ImportCommand, WhatIsNoSeriesIsRefusedAndNothingIsLeft) {
  const Sandbox box;
  fs::create_directory(box / "empty");
  fs::create_directory(box / "letters");
  write_text(box / "letters" / "a.dcm", "not DICOM at all");
  const std::size_t before = box.names("").size();
  expect_import_refused(box, box / "nowhere", "the folder or file given does not exist");
  EXPECT_EQ(box.run({"import", (box / "nowhere").string(), "--out", (box / "p.patient").string()}).err.find('%'),
            std::string::npos)
      << "no progress of what cannot begin";
  expect_import_refused(box, box / "empty", "empty");
  expect_import_refused(box, box / "letters", "file 1 of 1: is no DICOM file");
  EXPECT_EQ(box.names("").size(), before);
}

TEST(SeriesCommand, ListsChoosesAndWritesTheVolume) {
  const Sandbox box;
  pipeline::Grid grid;
  grid.size = {32, 30, 20};
  grid.origin = {-5.5, 7.0, -40.25};
  for (const char* name : {"one", "two"}) {
    fs::create_directories(box / "both" / name);
    pipeline::SeriesDescription description;
    description.unique_key = name;
    description.patient_name = "Doe^Jane";
    pipeline::write_ct_series(pipeline::Hounsfield(grid, 40), description, box / "both" / name);
    grid.size[2] = 30;
  }
  const std::string both = (box / "both").string();
  const Outcome list = box.run({"series", both});
  EXPECT_EQ(list.exit_code, 0) << list.err;
  EXPECT_EQ(list.out,
            "  1  usable  CT axial, 32 x 30 x 30, 1 x 1 x 1 mm\n  2  usable  CT axial, 32 x 30 x 20, 1 x 1 x 1 mm\n");
  const Outcome json = box.run({"series", both, "--json"});
  EXPECT_NE(json.out.find("{\"number\": 2, \"modality\": \"CT\", \"columns\": 32, \"rows\": 30, \"slices\": 20, "
                          "\"spacing_mm\": [1, 1, 1], \"orientation\": \"axial\", \"kernel\": \"\", \"usable\": true"),
            std::string::npos)
      << json.out;
  const std::string out = (box / "v.nrrd").string();
  expect_refused(box.run({"series", both, "--volume", out}), 1, "2 CT series could be meant");
  EXPECT_FALSE(fs::exists(out));
  expect_import_refused(box, box / "both", "choose one with --series");
  EXPECT_EQ(box.run({"series", both, "--series", "2", "--volume", out}).exit_code, 0);
  const std::string file = text_of(out);
  const auto end = file.find("\n\n");
  EXPECT_NE(file.find("sizes: 32 30 20"), std::string::npos);
  EXPECT_NE(file.find("space origin: (-5.5,7,-40.25)"), std::string::npos);
  EXPECT_EQ(file.substr(end + 2, 4), std::string("\x28\0\x28\0", 4));
  EXPECT_EQ(file.size() - end - 2, 32u * 30u * 20u * 2u);
  expect_refused(box.run({"series", both, "--volume", "v.png"}), 2, "must end in .nrrd");
  expect_refused(box.run({"series", both, "--series", "2"}), 2, "--volume");
}

TEST(ImportCommand, AnotherModalityOrATruncatedFileIsRefused) {
  const Sandbox box;
  pipeline::Grid grid;
  grid.size = {32, 32, 20};
  fs::create_directory(box / "series");
  pipeline::SeriesDescription description;
  description.unique_key = "test";
  pipeline::write_ct_series(pipeline::Hounsfield(grid, 40), description, box / "series");

  fs::copy(box / "series", box / "magnetic");
  for (const auto& entry : fs::directory_iterator(box / "magnetic")) {
    // (0008,0060) Modality, CS, two letters
    std::string bytes = text_of(entry.path());
    const std::size_t at =
        bytes.find(std::string("\x08\x00\x60\x00"
                               "CS\x02\x00"
                               "CT",
                               10));
    ASSERT_NE(at, std::string::npos);
    bytes.replace(at + 8, 2, "MR");
    write_text(entry.path(), bytes);
  }
  expect_import_refused(box, box / "magnetic", "MR, not CT");

  fs::copy(box / "series", box / "cut");
  fs::resize_file(box / "cut" / "ct-0005.dcm", fs::file_size(box / "cut" / "ct-0005.dcm") / 2);
  expect_import_refused(box, box / "cut", "ct-0005.dcm");
}

TEST(CommandLine, ANumberThatIsNoneOrOutOfItsRangeIsWrongUsage) {
  const Sandbox box;
  const std::string out = (box / "series").string();
  const std::vector<std::pair<std::string, std::vector<std::string>>> refused = {
      {"--seed", {"-1", "99999999999", "4294967296", "18446744073709551617", "1.5", "nan", "one"}},
      {"--weight", {"nan", "inf", "-inf", "70", "0", "3.2kg", "1e999"}},
      {"--noise", {"nan", "-1", "inf"}},
      {"--spacing", {"nan", "0", "5"}},
      {"--slice", {"nan", "-0.8", "1e"}},
  };
  for (const auto& [option, values] : refused) {
    for (const std::string& value : values) {
      expect_refused(box.run({"manikin", "--out", out, option, value}), 2, option);
      if (option == "--weight" || option == "--seed") {
        const Outcome demo = box.run({"demo", "--out", out, option, value});
        expect_refused(demo, 2, option);
        EXPECT_NE(demo.err.find("'" + value + "' is not a"), std::string::npos) << demo.err;
      }
      EXPECT_FALSE(fs::exists(out)) << option << " " << value;
    }
  }
}

TEST(NumberOptions, TakeBothEndsOfTheirRange) {
  const auto taken = [](const CLI::Validator& validator, std::string text) { return validator(text).empty(); };
  for (const std::string text : {"0.6", "4.5", "3", "6e-1"}) EXPECT_TRUE(taken(number_within(0.6, 4.5), text)) << text;
  for (const std::string text : {"0.59", "4.51", "", " 3", "+3", "NAN", "3 kg"})
    EXPECT_FALSE(taken(number_within(0.6, 4.5), text)) << text;
  for (const std::string text : {"0", "4294967295", "007"})
    EXPECT_TRUE(taken(whole_number_within(0, kLargestSeed), text)) << text;
  for (const std::string text : {"-0", "4294967296", "", "0x10", "1e3"})
    EXPECT_FALSE(taken(whole_number_within(0, kLargestSeed), text)) << text;
}

TEST(ManikinCommand, WhereNothingCanBeWrittenItSaysSo) {
  const Sandbox box;
  write_text(box / "file", "in the way");
  const Outcome outcome = box.run({"manikin", "--out", (box / "file" / "series").string()});
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  ASSERT_EQ(outcome.messages().size(), 1u) << outcome.err;
  EXPECT_NE(outcome.err.find("file/series"), std::string::npos) << outcome.err;
  EXPECT_EQ(text_of(box / "file"), "in the way");
  EXPECT_EQ(box.run({"manikin", "--out", (box / "heavy").string(), "--weight", "70"}).exit_code, 2);
  EXPECT_FALSE(fs::exists(box / "heavy"));
}

}  // namespace
}  // namespace vallecula::gui::test
