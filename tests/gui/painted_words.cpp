#include "tests/gui/painted_words.h"

#include <QFontInfo>
#include <QFontMetricsF>
#include <QPaintDevice>
#include <QPaintEngine>
#include <cmath>

namespace vallecula::gui::window_test {
namespace {

class Recorder : public QPaintEngine {
 public:
  Recorder() : QPaintEngine(QPaintEngine::AllFeatures) {}
  bool begin(QPaintDevice*) override { return true; }
  bool end() override { return true; }
  void updateState(const QPaintEngineState&) override {}
  void drawPixmap(const QRectF&, const QPixmap&, const QRectF&) override {}
  void drawPath(const QPainterPath&) override {}
  void drawPolygon(const QPointF*, int, PolygonDrawMode) override {}
  Type type() const override { return QPaintEngine::User; }
  void drawTextItem(const QPointF& at, const QTextItem& item) override {
    if (item.text().trimmed().isEmpty()) return;
    const QRectF ink = QFontMetricsF(item.font()).tightBoundingRect(item.text()).translated(at);
    words.push_back({item.text(), painter()->combinedTransform().mapRect(ink), QFontInfo(item.font()).pixelSize()});
  }
  std::vector<PaintedWord> words;
};

class Device : public QPaintDevice {
 public:
  explicit Device(const QSize& size) : size_(size) {}
  QPaintEngine* paintEngine() const override { return &recorder; }
  mutable Recorder recorder;

 protected:
  int metric(PaintDeviceMetric metric) const override {
    switch (metric) {
      case PdmWidth:
        return size_.width();
      case PdmHeight:
        return size_.height();
      case PdmWidthMM:
        return size_.width() * 254 / 960;
      case PdmHeightMM:
        return size_.height() * 254 / 960;
      case PdmNumColors:
        return 1 << 24;
      case PdmDepth:
        return 32;
      case PdmDevicePixelRatio:
        return 1;
      case PdmDevicePixelRatioScaled:
        return static_cast<int>(devicePixelRatioFScale());
      default:
        return 96;  // all the resolutions
    }
  }

 private:
  QSize size_;
};

std::string told(const PaintedWord& word) {
  return "\"" + word.text.toStdString() + "\" from " + std::to_string(std::lround(word.place.left())) + ", " +
         std::to_string(std::lround(word.place.top())) + " to " + std::to_string(std::lround(word.place.right())) +
         ", " + std::to_string(std::lround(word.place.bottom()));
}

}  // namespace

std::vector<PaintedWord> painted_words(const QSize& size, const std::function<void(QPainter&)>& paint) {
  Device device(size);
  QPainter painter(&device);
  paint(painter);
  painter.end();
  return device.recorder.words;
}

std::vector<PaintedWord> painted_words(QWidget& widget) {
  return painted_words(widget.size(), [&](QPainter& painter) {
    widget.render(&painter, QPoint(), QRegion(), QWidget::RenderFlags(QWidget::DrawWindowBackground));
  });
}

std::vector<std::string> trouble_of(const std::vector<PaintedWord>& words, const QSize& size) {
  std::vector<std::string> found;
  const QRectF whole(0.0, 0.0, size.width(), size.height());
  for (std::size_t i = 0; i < words.size(); ++i) {
    // The spacing of letters differs by fractions from that on the screen.
    if (!whole.adjusted(-2.5, -2.5, 2.5, 2.5).contains(words[i].place))
      found.push_back(told(words[i]) + " leaves its place of " + std::to_string(size.width()) + " x " +
                      std::to_string(size.height()));
    for (std::size_t j = i + 1; j < words.size(); ++j)
      if (words[i].place.adjusted(0.5, 0.5, -0.5, -0.5).intersects(words[j].place.adjusted(0.5, 0.5, -0.5, -0.5)))
        found.push_back(told(words[i]) + " lies on " + told(words[j]));
  }
  return found;
}

}  // namespace vallecula::gui::window_test
