// The import wizard as a clinician uses it: from a folder to a patient to practise with.
#include "tests/gui/window_import.h"

#include <QCheckBox>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QSpinBox>
#include <QTabWidget>
#include <QTableWidget>
#include <algorithm>

#include "gui/import/build_page.h"
#include "gui/import/structure_panel.h"
#include "gui/views/slice_view.h"
#include "pipeline/package/label_map.h"

namespace vallecula::gui::window_test {
namespace {

fs::path real_series() {
  const char* data = std::getenv("VALLECULA_DATA");
  const fs::path root = data != nullptr ? fs::path(data) : fs::path(VALLECULA_SOURCE_DIR) / ".." / "shared" / "data";
  return root / "cerr_head_neck_ct" / "dicom";
}

TEST_F(WindowImport, FromAFolderToAPatientThatIsChosenOnTheFirstPage) {
  segment(series());
  ASSERT_FALSE(HasFatalFailure());
  const auto* table = wizard().source_page().findChild<QTableWidget*>();
  ASSERT_EQ(table->rowCount(), 1);
  EXPECT_EQ(table->item(0, 3)->text(), "can be imported");
  const auto* thumbnail = qobject_cast<QLabel*>(table->cellWidget(0, 1));
  ASSERT_NE(thumbnail, nullptr);
  EXPECT_GT(colours_in(thumbnail->pixmap(Qt::ReturnByValue).toImage()), 6) << "a picture of the head";
  EXPECT_NE(table->item(0, 2)->text().indexOf("CT axial, 272 x 272"), -1);
  EXPECT_EQ(left_behind(), std::vector<std::string>{}) << "nothing is written before it is saved";
  picture("3-check");

  // What is shown is what is there: the manikin's true landmarks and labels, in the scan's own millimetres.
  const pipeline::Manikin truth(kWeight, kSeed);
  for (const char* name : {"vallecula", "glottis_centre"}) {
    const Point shown = check().scene().landmarks().at(name).at, wanted = truth.landmarks().at(name);
    EXPECT_LT(length_mm(shown, wanted), 1.8) << name;
  }
  const auto& labels = *check().scene().labels();
  int same = 0, all = 0;
  for (std::size_t i = 0; i < labels.voxels.size(); i += 997) {
    if (labels.voxels[i] == 0) continue;
    ++all;
    same += truth.label_at(labels.grid.position(i)) == labels.voxels[i] ? 1 : 0;
  }
  EXPECT_GT(same, 0.95 * all);
  EXPECT_GT(colours_in(check().view_3d().picture()), 20);

  // A landmark is dragged, taken back, and dragged again: by so many pixels, so many millimetres.
  SliceView& sagittal = check().slice(SlicePlane::sagittal);
  const Point found = check().scene().landmarks().at("vallecula").at;
  check().scene().set_crosshair(found);
  const QPointF at = sagittal.pixel_of(found);
  drag(sagittal, at, at + QPointF(6, 0));
  const Point wanted{found[0], found[1] + 6.0 / sagittal.pixels_per_mm(), found[2]};
  EXPECT_NEAR(check().history().state().landmarks.at("vallecula")[1], wanted[1], 1e-9);
  check().history().stack().undo();
  EXPECT_TRUE(check().history().state().landmarks.empty());
  EXPECT_EQ(check().scene().landmarks().at("vallecula").at, found) << "undo puts the picture back too";
  check().history().stack().redo();
  check().structures().select("airway");
  button(check(), "&Accept")->click();
  EXPECT_EQ(check().history().state().accepted, std::set<std::string>{"airway"});
  picture("3-check-moved");
  // One view alone takes the room of all, by the key; and gives it back.
  const int wide = sagittal.width(), high = sagittal.height();
  for (QWidget* view : {static_cast<QWidget*>(&sagittal), static_cast<QWidget*>(&check().view_3d())}) {
    QKeyEvent key(QEvent::KeyPress, Qt::Key_F, Qt::NoModifier);
    QApplication::sendEvent(view, &key);
    QApplication::processEvents();
    EXPECT_GT(view->width(), 1.95 * wide);
    EXPECT_GT(view->height(), 1.95 * high);
    picture(view == &sagittal ? "3-alone" : "3-alone-3d");
    QApplication::sendEvent(view, &key);
    QApplication::processEvents();
    EXPECT_EQ(sagittal.size(), QSize(wide, high));
  }
  auto* tabs = check().findChild<QTabWidget*>();
  for (const int tab : {1, 2, 0}) {
    tabs->setCurrentIndex(tab);
    expect_each_its_own_key(check());
    picture("3-tab-" + std::to_string(tab));
  }

  button(check(), "&Build the patient")->click();
  ASSERT_EQ(wizard().step(), "build");
  ASSERT_TRUE(wait_for([&] { return !wizard().work().busy(); }, 180000));
  const auto edits = wizard().work().import()->options().edits;
  ASSERT_EQ(edits.landmarks.size(), 1u);
  for (int a = 0; a < 3; ++a) EXPECT_NEAR(edits.landmarks.at("vallecula")[a], wanted[a], 1e-9);
  EXPECT_EQ(left_behind(), std::vector<std::string>{});
  picture("4-built");
  expect_each_its_own_key(wizard().build_page());
  // Another program takes the name meanwhile: another is chosen, and nothing has to be done again.
  fs::create_directories(patients_folder() / "patient-1.patient");
  button(wizard().build_page(), "&Save the patient")->click();
  ASSERT_TRUE(wait_for([&] { return !wizard().work().busy(); }, 60000));
  EXPECT_EQ(wizard().step(), "build");
  EXPECT_FALSE(button(wizard().build_page(), "&Save the patient")->isEnabled());
  fs::remove(patients_folder() / "patient-1.patient");
  const fs::path package = patients_folder() / "another.patient";
  for (auto* line : wizard().build_page().findChildren<QLineEdit*>())
    if (line->accessibleName() == "Name of the new patient") line->setText("another");
  button(wizard().build_page(), "&Save the patient")->click();
  wizard().work().cancel();  // too late or not: a whole package or none
  ASSERT_TRUE(wait_for([&] { return !wizard().work().busy(); }, 60000));
  EXPECT_EQ(wizard().step(), "build");
  if (!fs::exists(package)) {
    EXPECT_EQ(left_behind(), std::vector<std::string>{});
    button(wizard().build_page(), "&Save the patient")->click();
    ASSERT_TRUE(wait_for([&] { return !wizard().work().busy(); }, 60000));
  }
  picture("4-saved");
  EXPECT_NO_THROW(pipeline::read_package(package));
  for (const char* stage :
       {"Reading the series", "Finding the airway", "Finding the tongue", "Making the surface of face and throat"})
    EXPECT_EQ(std::count(stages_.begin(), stages_.end(), QString(stage)) > 0, true) << stage;
  // At once, whatever is done next; and Enter goes on to it.
  EXPECT_EQ(window_->start_page().hands().patient, package);
  EXPECT_EQ(window_->focusWidget(), button(wizard().build_page(), "&Practise with this patient"));
  button(wizard().build_page(), "&Practise with this patient")->click();
  EXPECT_EQ(window_->page_name(), "start");
  EXPECT_EQ(window_->start_page().choice().patient, package);
  // The course's nearest to 0.8 kg instead of its first, which is made for 3.2 kg; and the page says so.
  ASSERT_TRUE(wait_for([&] { return window_->start_page().choice().scenario.id == "preterm"; }, 20000));
  const QList<QLabel*> words = window_->start_page().findChildren<QLabel*>();
  EXPECT_TRUE(std::any_of(words.begin(), words.end(), [](const QLabel* one) {
    return one->isVisible() && one->text().contains("\"Preterm infant, 1.2 kg\" was chosen");
  }));
  picture("5-start");
  EXPECT_EQ(window_->focusWidget(), button(window_->start_page(), "Prepare the trial")) << "Enter prepares the trial";
}

TEST_F(WindowImport, SeedsAndThresholdsReachTheImportAndAWrongOneIsSaid) {
  segment(series());
  ASSERT_FALSE(HasFatalFailure());
  const auto before = check().scene().shared_labels();
  check().structures().select("tongue");
  SliceView& axial = check().slice(SlicePlane::axial);
  const Point outside = check().scene().scan()->grid.position(1, 1, 1);
  check().scene().set_crosshair(outside);
  button(check(), "Give a &seed ...")->click();
  ASSERT_EQ(check().scene().tool(), SliceTool::seed);
  drag(axial, axial.pixel_of(outside), axial.pixel_of(outside));
  ASSERT_EQ(check().history().state().seeds.count("tongue"), 1u);
  EXPECT_EQ(check().scene().tool(), SliceTool::crosshair) << "one seed, then the pointer is itself again";
  EXPECT_TRUE(check().edits_waiting());
  button(check(), "Run a&gain with the edits")->click();
  ASSERT_TRUE(wait_for([&] { return !wizard().work().busy(); }, 180000));
  EXPECT_EQ(check().scene().shared_labels(), before) << "what was found stays when the new seed finds nothing";
  EXPECT_TRUE(check().edits_waiting());
  picture("3-wrong-seed");
  const auto said = check().findChildren<QLabel*>();
  EXPECT_TRUE(std::any_of(said.begin(), said.end(), [](QLabel* l) { return l->text().contains("outside the head"); }));

  const Point tongue = [&] {  // a voxel of the true tongue
    const pipeline::Manikin truth(kWeight, kSeed);
    Point p = truth.landmarks().at("vallecula");
    while (truth.label_at(p) != pipeline::kTongue) p[1] -= 1.0;
    p[1] -= 4.0;
    return p;
  }();
  check().scene().set_crosshair(tongue);
  check().scene().set_tool(SliceTool::seed);
  drag(axial, axial.pixel_of(tongue), axial.pixel_of(tongue));
  const auto boxes = check().structures().findChildren<QSpinBox*>();
  ASSERT_EQ(boxes.size(), 2);
  boxes[0]->setValue(-40);
  boxes[1]->setValue(130);
  button(check(), "&Use the threshold")->click();
  button(check(), "Run a&gain with the edits")->click();
  ASSERT_TRUE(wait_for([&] { return !wizard().work().busy(); }, 180000));
  const auto& edits = wizard().work().import()->options().edits;
  EXPECT_LT(length_mm(edits.seeds.at("tongue"), tongue), 1.0) << "half a slice and half a pixel";
  EXPECT_EQ(edits.thresholds.at("tongue"), (std::array<double, 2>{-40.0, 130.0}));
  EXPECT_NE(check().scene().shared_labels(), before);
  EXPECT_FALSE(check().edits_waiting());
}

TEST_F(WindowImport, LabelsGoOutToAnotherProgramAndComeBack) {
  segment(series());
  ASSERT_FALSE(HasFatalFailure());
  const auto before = check().scene().shared_labels();
  const auto done = [&] { return wait_for([&] { return !wizard().work().busy(); }); };
  check().save(box_ / "labels.nrrd");
  ASSERT_TRUE(done());
  EXPECT_EQ(pipeline::read_label_map(box_ / "labels.nrrd").voxels, before->voxels);
  check().load(box_ / "labels.nrrd", "tongue");
  ASSERT_TRUE(done());
  const auto edits = check().history().state().edits();
  EXPECT_EQ(edits.replaced, std::set<std::uint8_t>{pipeline::kTongue});
  for (std::size_t i = 0; i < before->voxels.size(); ++i)
    ASSERT_EQ(edits.labels->voxels[i] == pipeline::kTongue, before->voxels[i] == pipeline::kTongue);
  check().history().stack().undo();
  EXPECT_TRUE(check().history().state().replaced.empty());

  // Landmarks: what another program moved comes back as moved by so much, the rest as it was.
  check().load(box_ / "labels.mrk.json", "");
  ASSERT_TRUE(done());
  EXPECT_TRUE(check().history().state().landmarks.empty());
  QFile file(QString::fromStdString((box_ / "labels.mrk.json").string()));
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  QJsonObject all = QJsonDocument::fromJson(file.readAll()).object();
  file.close();
  QJsonArray markups = all["markups"].toArray();
  QJsonObject list = markups[0].toObject();
  QJsonArray points = list["controlPoints"].toArray();
  for (int i = 0; i < points.size(); ++i) {
    QJsonObject point = points[i].toObject();
    const bool normal = point["label"].toString() == "glottis_normal";
    if (point["label"].toString() != "vallecula" && !normal) continue;
    QJsonArray at = point["position"].toArray();
    at[normal ? 0 : 2] = at[normal ? 0 : 2].toDouble() + 3.0;  // towards the head, in LPS and RAS
    point["position"] = at;
    points[i] = point;
  }
  list["controlPoints"] = points;
  markups[0] = list;
  all["markups"] = markups;
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(QJsonDocument(all).toJson());
  file.close();
  const Point found = check().scene().landmarks().at("vallecula").at;
  check().load(box_ / "labels.mrk.json", "");
  ASSERT_TRUE(done());
  ASSERT_EQ(check().history().state().landmarks.size(), 2u);
  EXPECT_EQ(check().history().state().landmarks.count("glottis_normal"), 1u) << "given to the import";
  EXPECT_EQ(check().scene().landmarks().count("glottis_normal"), 0u) << "a direction is no place to be drawn";
  const Point moved = check().history().state().landmarks.at("vallecula");
  EXPECT_LT(length_mm(moved, {found[0], found[1], found[2] + 3.0}), 1e-3);
  check().history().stack().undo();

  check().load(box_ / "labels7.nrrd", "");
  ASSERT_TRUE(done());
  EXPECT_TRUE(check().history().state().replaced.empty());
  const auto said = check().findChildren<QLabel*>();
  EXPECT_TRUE(std::any_of(said.begin(), said.end(), [](QLabel* l) { return l->text().contains("labels7.nrrd"); }));
}

TEST_F(WindowImport, SaysWhatIsWrongWithAFolderWithoutACt) {
  fs::create_directory(box_ / "empty");
  open(QString::fromStdString((box_ / "empty").string()));
  const auto* table = wizard().source_page().findChild<QTableWidget*>();
  ASSERT_EQ(table->rowCount(), 1);
  EXPECT_EQ(table->item(0, 0)->text(), "") << "no series, no number";
  EXPECT_EQ(table->item(0, 3)->text(), "The folder is empty; choose a folder with a CT series");
  expect_each_its_own_key(wizard().source_page());
  EXPECT_FALSE(button(wizard().source_page(), "&Read and find the structures")->isEnabled());
  auto* name = wizard().source_page().findChildren<QLineEdit*>().at(1);
  name->setText("Anna Schmidt");
  EXPECT_FALSE(button(wizard().source_page(), "&Read and find the structures")->isEnabled());
  picture("1-nothing");
}

TEST_F(WindowImport, AskedForAnotherFolderWhileOneIsListedItListsTheLastOneOnly) {
  open_window();
  ASSERT_FALSE(HasFatalFailure());
  auto& page = wizard().source_page();
  const auto* table = page.findChild<QTableWidget*>();
  QPushButton* read = button(page, "&Read and find the structures");
  const QString empty = QString::fromStdString(box_.home().string());
  int lists = 0;
  QObject::connect(&wizard().work(), &ImportWork::listed, &page, [&] { ++lists; });
  const auto listed = [&] { return wait_for([&] { return lists > 0 && !wizard().work().busy(); }); };
  page.look_at(empty);
  ASSERT_TRUE(wizard().work().busy());
  page.look_at(empty + "/nothing");
  page.look_at(series());
  ASSERT_TRUE(listed());
  EXPECT_EQ(lists, 1) << "the others were given up";
  EXPECT_EQ(page.choice().source, series().toStdString());
  ASSERT_EQ(table->rowCount(), 1);
  EXPECT_EQ(table->item(0, 0)->text(), "1");
  EXPECT_TRUE(read->isEnabled());
  lists = 0;
  page.look_at(series());
  page.look_at(empty);
  ASSERT_TRUE(listed());
  EXPECT_EQ(lists, 1);
  EXPECT_EQ(table->item(0, 0)->text(), "");
  EXPECT_FALSE(read->isEnabled()) << "the first folder's series is not the second's";
  // Left while one waits, nothing is listed any more.
  lists = 0;
  page.look_at(series());
  page.look_at(empty);
  button(page, "&Back to the start")->click();
  ASSERT_TRUE(wait_for([&] { return !wizard().work().busy(); }));
  for (int i = 0; i < 20; ++i) QApplication::processEvents(QEventLoop::AllEvents, 10);
  EXPECT_FALSE(wizard().work().busy());
  EXPECT_EQ(lists, 0);
  EXPECT_EQ(window_->page_name(), "start");
}

TEST_F(WindowImport, FromAnEditedPathNothingIsReadBeforeItIsListed) {
  open(series());
  ASSERT_FALSE(HasFatalFailure());
  auto& page = wizard().source_page();
  QPushButton* read = button(page, "&Read and find the structures");
  ASSERT_TRUE(read->isEnabled());
  auto* place = page.findChild<QLineEdit*>();
  place->setFocus();
  place->end(false);
  place->insert("-of-another-patient");
  EXPECT_FALSE(read->isEnabled());
  EXPECT_EQ(page.findChild<QTableWidget*>()->rowCount(), 0);
  EXPECT_EQ(page.choice().series, "") << "no number of the first folder for the second";
}

TEST_F(WindowImport, FromABuildThatScalesWhatIsSavedForAnotherProgramStillLiesAsScanned) {
  open(series());
  ASSERT_FALSE(HasFatalFailure());
  wizard().source_page().findChild<QCheckBox*>()->setChecked(true);  // the generic face
  button(wizard().source_page(), "&Read and find the structures")->click();
  ASSERT_TRUE(wait_for([&] { return wizard().step() == "check"; }, 180000));
  const auto points = [&](const fs::path& name) -> QJsonArray {
    check().save(box_ / name);
    EXPECT_TRUE(wait_for([&] { return !wizard().work().busy(); }));
    QFile file(QString::fromStdString((box_ / name).replace_extension(".mrk.json").string()));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    const QJsonObject all = QJsonDocument::fromJson(file.readAll()).object();
    return all["markups"].toArray().at(0).toObject().value("controlPoints").toArray();
  };
  const auto before = points("before.nrrd");
  EXPECT_FALSE(before.isEmpty());
  for (auto* box : wizard().build_page().findChildren<QCheckBox*>())
    if (box->text().contains("newborn")) box->setChecked(true);
  wizard().build_page().findChild<QSpinBox*>()->setValue(2000);
  button(check(), "&Build the patient")->click();
  ASSERT_TRUE(wait_for([&] { return !wizard().work().busy(); }, 180000));
  ASSERT_TRUE(wizard().build_page().built());
  const auto& import = *wizard().work().import();
  EXPECT_GT(import.segmentation().pose.scale, 1.05) << "a head of 0.8 kg";
  EXPECT_LT(import.package().tongue.tets.size(), 2400u);
  EXPECT_EQ(points("after.nrrd"), before);
  const auto skin = [](const pipeline::Labels& l) {
    return std::count(l.voxels.begin(), l.voxels.end(), static_cast<std::uint8_t>(pipeline::kSkin));
  };
  EXPECT_LT(skin(pipeline::read_label_map(box_ / "after.nrrd")), skin(*check().scene().labels()))
      << "the patient's own face does not leave with the labels";
}

class WindowImportRealCt : public WindowImport {
 protected:
  static void SetUpTestSuite() { Screen::SetUpTestSuite(); }  // needs no manikin
};

TEST_F(WindowImportRealCt, ARealClosedMouthGetsItsTongueFromASeed) {
  if (!fs::exists(real_series()))
    GTEST_SKIP() << "outside data absent: cerr_head_neck_ct is looked for in $VALLECULA_DATA, else in ../shared/data";
  segment(QString::fromStdString(real_series().string()));
  ASSERT_FALSE(HasFatalFailure());
  EXPECT_NE(check().scene().scan(), nullptr) << "the scan is there to be looked at, whatever was found in it";
  const Point tongue{244, -341, -138};  // read by hand: README of the data
  check().scene().set_crosshair(tongue);
  picture("3-before");
  check().structures().select("tongue");
  check().scene().set_tool(SliceTool::seed);
  SliceView& sagittal = check().slice(SlicePlane::sagittal);
  drag(sagittal, sagittal.pixel_of(tongue), sagittal.pixel_of(tongue));
  picture("3-seed");
  button(check(), "Run a&gain with the edits")->click();
  picture("3-running");
  ASSERT_TRUE(wait_for([&] { return !wizard().work().busy(); }, 300000));
  ASSERT_NE(check().scene().labels(), nullptr);
  const auto& labels = *check().scene().labels();
  const auto c = labels.grid.nearest(tongue);
  EXPECT_EQ(labels.at(c[0], c[1], c[2]), pipeline::kTongue);
  // The head lies askew and is put upright for the package; what is shown lies where the scan has it.
  EXPECT_LT(length_mm(check().scene().landmarks().at("glottis_centre").at, {239, -312, -219}), 4.0);
  ASSERT_TRUE(wait_for([&] { return check().view_3d().up_to_date(); }));
  check().scene().set_crosshair(tongue);
  picture("3-after");
  check().scene().set_tool(SliceTool::ruler);
  drag(sagittal, sagittal.pixel_of({244, -372, -141}), sagittal.pixel_of({244, -305, -141}));
  check().structures().findChild<QCheckBox*>()->setChecked(true);
  check().scene().set_tool(SliceTool::angle);
  for (const Point& p : {Point{244, -372, -141}, Point{244, -341, -138}, Point{239, -312, -219}})
    drag(sagittal, sagittal.pixel_of(p), sagittal.pixel_of(p));
  EXPECT_EQ(check().scene().measures().size(), 2u);
  picture("3-measured");
  check().structures().findChild<QCheckBox*>()->setChecked(false);
  emit sagittal.alone_wanted();
  picture("3-alone");
  emit sagittal.alone_wanted();
  button(check(), "&Build the patient")->click();
  ASSERT_TRUE(wait_for([&] { return !wizard().work().busy(); }, 300000));
  picture("4-built");
  const auto said = wizard().build_page().findChildren<QLabel*>();
  const bool explained =
      std::any_of(said.begin(), said.end(), [](QLabel* l) { return l->text().contains("Go back to the check"); });
  EXPECT_NE(button(wizard().build_page(), "&Save the patient")->isEnabled(), explained)
      << "either there is a patient to save, or it is said what to mend";
}

}  // namespace
}  // namespace vallecula::gui::window_test
