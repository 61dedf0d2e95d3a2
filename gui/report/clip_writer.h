// Pictures of one size as a clip that slide programs, browsers and players show: H.264 in MP4, by OpenCV.
#pragma once

#include <QImage>
#include <filesystem>
#include <memory>

namespace vallecula::gui {

class ClipWriter {
 public:
  /// FILE is written aside (FILE.part.mp4) until finish(). `frames_per_second`: 1 to 60.
  ClipWriter(const std::filesystem::path& file, int frames_per_second);
  ~ClipWriter();  ///< not finished: nothing is left behind
  ClipWriter(const ClipWriter&) = delete;
  ClipWriter& operator=(const ClipWriter&) = delete;
  /// The first picture says the clip's size (an odd side loses a pixel); later ones are brought to it. Throws std::runtime_error naming the file.
  void add(const QImage& picture);
  /// Throws std::runtime_error: nothing was added, the disk is full.
  void finish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace vallecula::gui
