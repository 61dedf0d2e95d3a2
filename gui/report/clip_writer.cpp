#include "gui/report/clip_writer.h"

#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkOggTheoraWriter.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace vallecula::gui {

namespace fs = std::filesystem;

struct ClipWriter::Impl {
  fs::path file, part;
  vtkNew<vtkOggTheoraWriter> writer;
  vtkNew<vtkImageData> image;
  QSize size;
  bool open = false;

  [[noreturn]] void fail() {
    throw std::runtime_error(file.string() +
                             ": the clip could not be written; is the folder there, and is there room on the disk?");
  }
  void check() {
    if (writer->GetErrorCode() != vtkErrorCode::NoError || writer->GetError() != 0) fail();
  }
  void close() {
    if (open) writer->End();
    open = false;
  }
};

ClipWriter::ClipWriter(const fs::path& file, int frames_per_second) : impl_(std::make_unique<Impl>()) {
  impl_->file = file;
  impl_->part = file.string() + ".part";
  impl_->writer->SetRate(std::clamp(frames_per_second, 1, 60));
  impl_->writer->SetQuality(2);
  impl_->writer->SubsamplingOff();  // thin coloured lines and small letters
  impl_->writer->SetFileName(impl_->part.string().c_str());
  // VTK would only say so on stderr.
  if (!std::ofstream(impl_->part, std::ios::binary)) impl_->fail();
}

ClipWriter::~ClipWriter() {
  impl_->close();
  std::error_code ignored;
  fs::remove(impl_->part, ignored);
}

void ClipWriter::add(const QImage& picture) {
  Impl& m = *impl_;
  if (picture.isNull()) throw std::logic_error("a clip needs pictures");
  if (m.size.isEmpty()) {
    m.size = picture.size();
    m.image->SetDimensions(m.size.width(), m.size.height(), 1);
    m.image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  }
  const QImage rgb = (picture.size() == m.size
                          ? picture
                          : picture.scaled(m.size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation))
                         .convertToFormat(QImage::Format_RGB888);
  for (int y = 0; y < m.size.height(); ++y)  // VTK's first row is the lowest
    std::memcpy(m.image->GetScalarPointer(0, m.size.height() - 1 - y, 0), rgb.constScanLine(y),
                3 * static_cast<std::size_t>(m.size.width()));
  m.image->Modified();
  if (!m.open) {
    m.writer->SetInputData(m.image);
    m.writer->Start();
    m.open = true;
    m.check();
  }
  m.writer->Write();
  m.check();
}

void ClipWriter::finish() {
  Impl& m = *impl_;
  if (!m.open) throw std::runtime_error(m.file.string() + ": no picture was added, so there is no clip");
  m.close();
  m.check();
  std::error_code error;
  fs::rename(m.part, m.file, error);
  if (error) m.fail();
}

}  // namespace vallecula::gui
