#include "gui/views/airway_marks.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTextProperty.h>

#include <QCoreApplication>
#include <QString>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "engine/types.h"
#include "gui/session/log_conversion.h"
#include "gui/views/theme.h"

namespace vallecula::gui {
namespace {

using engine::Vec3;

constexpr double kGoodDepthType = 14.0, kNumberType = 11.0;  // points
constexpr double kLeader = 16.0, kBesideLeader = 4.0;        // px
constexpr double kLetter = 0.6;  // of a bold letter's type, its width on average: rather too much than too little

/// A cut's ends in the sagittal plane, m, and how far it is along the chain.
struct Cut {
  double along;
  Vec3 front, back;
};

std::vector<Cut> cuts_of(const std::vector<engine::AirwayRing>& chain) {
  std::vector<Cut> cuts;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const auto& ring = chain[i];
    const Vec3 front = ring.along.cross(ring.left);
    cuts.push_back({i == 0 ? 0.0 : cuts.back().along + (ring.centre - chain[i - 1].centre).norm(),
                    ring.centre + ring.to_front_m * front, ring.centre - ring.to_back_m * front});
  }
  return cuts;
}

Cut cut_at(const std::vector<Cut>& cuts, double along) {
  std::size_t i = 1;
  while (i + 1 < cuts.size() && cuts[i].along < along) ++i;
  const Cut &a = cuts[i - 1], &b = cuts[i];
  const double t = (along - a.along) / std::max(1e-9, b.along - a.along);
  return {along, a.front + t * (b.front - a.front), a.back + t * (b.back - a.back)};
}

class Drawing {
 public:
  Drawing(double x_mm) : x_(x_mm) {}
  vtkIdType point(const Vec3& m) { return points_->InsertNextPoint(x_, 1e3 * m.y(), 1e3 * m.z()); }
  void strip(const std::vector<Cut>& cuts) {
    vtkIdType before[2] = {-1, -1};
    for (const Cut& cut : cuts) {
      const vtkIdType front = point(cut.front), back = point(cut.back);
      if (before[0] >= 0) {
        const vtkIdType quad[4] = {before[0], front, back, before[1]};
        polygons_->InsertNextCell(4, quad);
      }
      before[0] = front;
      before[1] = back;
    }
  }
  void line(const Vec3& from, const Vec3& to) {
    const vtkIdType ids[2] = {point(from), point(to)};
    lines_->InsertNextCell(2, ids);
  }
  vtkSmartPointer<vtkActor> actor(const QColor& colour, double opacity) const {
    vtkNew<vtkPolyData> data;
    data->SetPoints(points_);
    data->SetPolys(polygons_);
    data->SetLines(lines_);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->SetColor(colour.redF(), colour.greenF(), colour.blueF());
    actor->GetProperty()->SetOpacity(opacity);
    actor->GetProperty()->SetLineWidth(1.3f);
    return actor;
  }

 private:
  double x_;
  vtkNew<vtkPoints> points_;
  vtkNew<vtkCellArray> polygons_, lines_;
};

vtkSmartPointer<vtkBillboardTextActor3D> text(const std::string& words, const Vec3& at_m, double x_mm, double points,
                                              const QColor& colour, bool to_the_left) {
  auto actor = vtkSmartPointer<vtkBillboardTextActor3D>::New();
  actor->SetInput(words.c_str());
  actor->SetPosition(x_mm, 1e3 * at_m.y(), 1e3 * at_m.z());
  auto* property = actor->GetTextProperty();
  property->SetFontSize(static_cast<int>(std::lround(points)));
  property->SetBold(true);
  property->SetColor(colour.redF(), colour.greenF(), colour.blueF());
  property->SetVerticalJustificationToCentered();
  if (to_the_left) property->SetJustificationToRight();
  return actor;
}

std::size_t cords_in(const engine::AirwayCourse& course) {
  for (std::size_t i = 0; i + 1 < course.airway.size(); ++i)
    if (course.airway[i].part == engine::AirwayPart::cords) return i;
  throw std::runtime_error("the airway has no cords above its carina: import the patient again");
}

}  // namespace

void AirwayMarks::set_type(double text_scale, double px_per_cm, double before_px) const {
  const auto type = [&](vtkBillboardTextActor3D& word, double points) {
    word.GetTextProperty()->SetFontSize(static_cast<int>(std::lround(points * text_scale)));
  };
  type(*good_depth, kGoodDepthType);
  const double letters = QString::fromUtf8(good_depth->GetInput()).size();
  const bool room = letters * kLetter * kGoodDepthType * text_scale + kLeader + kBesideLeader < before_px;
  good_depth->SetVisibility(room);
  leader->SetVisibility(room);
  const Eigen::Vector2d end = good_front_mm + 10.0 * kLeader / std::max(px_per_cm, 1.0) * good_out;
  double at[3];
  good_depth->GetPosition(at);
  good_depth->SetPosition(at[0], end.x(), end.y());
  good_depth->SetDisplayOffset(-static_cast<int>(kBesideLeader), 0);
  auto* line = vtkPolyData::SafeDownCast(leader->GetMapper()->GetInputDataObject(0, 0))->GetPoints();
  line->GetPoint(1, at);
  line->SetPoint(1, at[0], end.x(), end.y());
  line->Modified();
  // At VTK's 72 dots an inch a point is a pixel, and a digit is not quite as tall as its type.
  const double tall = kNumberType * text_scale;
  const int each = std::max(1, static_cast<int>(std::ceil(tall / std::max(px_per_cm, 1.0))));
  for (std::size_t i = 0; i < centimetres.size(); ++i) {
    type(*centimetres[i], kNumberType);
    centimetres[i]->SetVisibility((static_cast<int>(i) + 1) % each == 0);
  }
}

AirwayMarks airway_marks(const engine::AirwayCourse& course, double midline_x_mm, double behind_mm, double layer_mm) {
  AirwayMarks marks;
  const auto put = [&](vtkProp3D* prop, double towards_mm) {
    double at[3];
    prop->GetPosition(at);
    prop->SetPosition(at[0] + towards_mm, at[1], at[2]);
    marks.props.emplace_back(prop);
  };
  if (course.oesophagus.size() > 1) {
    Drawing food(midline_x_mm);
    food.strip(cuts_of(course.oesophagus));
    put(food.actor(QColor(120, 52, 54), 1.0), behind_mm);
  }
  const auto cuts = cuts_of(course.airway);
  const double from = cuts[cords_in(course)].along, length = cords_to_carina_m(course);
  const double good_from = from + kGoodDepthFrom * length, good_to = from + kGoodDepthTo * length;
  std::vector<Cut> good{cut_at(cuts, good_from)};
  for (const Cut& cut : cuts)
    if (cut.along > good_from && cut.along < good_to) good.push_back(cut);
  good.push_back(cut_at(cuts, good_to));
  Drawing band(midline_x_mm), centimetres(midline_x_mm);
  band.strip(good);
  put(band.actor(theme::within().lighter(130), 1.0), layer_mm);
  const Cut middle = cut_at(cuts, 0.5 * (good_from + good_to));
  const Vec3 out = (middle.front - middle.back).normalized();
  marks.good_depth = text(QCoreApplication::translate("AirwayMarks", "good depth").toUtf8().constData(),
                          middle.front + 0.003 * out, midline_x_mm, kGoodDepthType, QColor(250, 252, 250), true);
  put(marks.good_depth, layer_mm + 0.2);
  marks.good_front_mm = 1e3 * Eigen::Vector2d(middle.front.y(), middle.front.z());
  marks.good_out = Eigen::Vector2d(out.y(), out.z()).normalized();
  Drawing leader(midline_x_mm);
  leader.line(middle.front, middle.front + 0.003 * out);
  marks.leader = leader.actor(QColor(250, 252, 250), 1.0);
  put(marks.leader, layer_mm + 0.1);
  for (int cm = 1; 0.01 * cm < length; ++cm) {
    const Cut cut = cut_at(cuts, from + 0.01 * cm);
    const Vec3 across = (cut.back - cut.front).normalized();
    centimetres.line(cut.front, cut.back + 0.0012 * across);
    marks.centimetres.push_back(
        text(std::to_string(cm), cut.back + 0.0022 * across, midline_x_mm, kNumberType, QColor(245, 246, 250), false));
    put(marks.centimetres.back(), layer_mm + 0.2);
  }
  put(centimetres.actor(QColor(245, 246, 250), 1.0), layer_mm + 0.1);
  return marks;
}

}  // namespace vallecula::gui
