#include "gui/report/clip_writer.h"

#include <algorithm>
#include <fstream>
#include <opencv2/videoio.hpp>
#include <stdexcept>
#include <system_error>

namespace vallecula::gui {

namespace fs = std::filesystem;

struct ClipWriter::Impl {
  fs::path file, part;
  cv::VideoWriter writer;
  QSize size;
  int rate = 30, pictures = 0;

  [[noreturn]] void fail() {
    throw std::runtime_error(file.string() +
                             ": the clip could not be written; is the folder there, and is there room on the disk?");
  }
};

ClipWriter::ClipWriter(const fs::path& file, int frames_per_second) : impl_(std::make_unique<Impl>()) {
  impl_->file = file;
  impl_->part = file.string() + ".part.mp4";  // OpenCV takes the container from the name
  impl_->rate = std::clamp(frames_per_second, 1, 60);
  // OpenCV would only say so on stderr.
  if (!std::ofstream(impl_->part, std::ios::binary)) impl_->fail();
}

ClipWriter::~ClipWriter() {
  impl_->writer.release();
  std::error_code ignored;
  fs::remove(impl_->part, ignored);
}

void ClipWriter::add(const QImage& picture) {
  Impl& m = *impl_;
  if (picture.isNull()) throw std::logic_error("a clip needs pictures");
  if (m.size.isEmpty()) {
    m.size = QSize(picture.width() & ~1, picture.height() & ~1);  // colours have half the resolution: no odd sides
    if (!m.writer.open(m.part.string(), cv::CAP_FFMPEG, cv::VideoWriter::fourcc('a', 'v', 'c', '1'), m.rate,
                       cv::Size(m.size.width(), m.size.height())))
      m.fail();
  }
  QImage bgr = (picture.width() / 2 == m.size.width() / 2 && picture.height() / 2 == m.size.height() / 2
                    ? picture.copy(QRect(QPoint(0, 0), m.size))
                    : picture.scaled(m.size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation))
                   .convertToFormat(QImage::Format_BGR888);
  m.writer.write(cv::Mat(bgr.height(), bgr.width(), CV_8UC3, bgr.bits(), static_cast<std::size_t>(bgr.bytesPerLine())));
  ++m.pictures;
}

void ClipWriter::finish() {
  Impl& m = *impl_;
  if (m.pictures == 0) throw std::runtime_error(m.file.string() + ": no picture was added, so there is no clip");
  m.writer.release();
  // A full disk is not reported while it is written: what can be read back tells.
  cv::VideoCapture back;
  if (!back.open(m.part.string(), cv::CAP_FFMPEG) ||
      static_cast<int>(back.get(cv::CAP_PROP_FRAME_COUNT)) != m.pictures)
    m.fail();
  back.release();
  std::error_code error;
  fs::rename(m.part, m.file, error);
  if (error) m.fail();
}

}  // namespace vallecula::gui
