#include "pipeline/dicom/picture_reader.h"

#include <gdcmImageReader.h>
#include <gdcmSequenceOfFragments.h>
#include <gdcmTrace.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "pipeline/dicom/mapped_file.h"
#include "pipeline/dicom/series_error.h"

namespace vallecula::pipeline {
namespace {

constexpr std::int16_t kAirHu = -1024;

/// How a stored number lies in its word: PS3.5 8.1.1. What stands in the other bits is no part of it.
struct StoredBits {
  unsigned allocated = 16;
  unsigned stored = 16;
  unsigned high = 15;
  bool is_signed = false;

  std::int64_t value(std::uint32_t word) const {
    const auto shifted = static_cast<std::uint64_t>(word) >> (high + 1 - stored);
    const auto mask = (std::uint64_t{1} << stored) - 1;
    const auto bits = static_cast<std::int64_t>(shifted & mask);
    const bool negative = is_signed && ((bits >> (stored - 1)) & 1) != 0;
    return negative ? bits - (std::int64_t{1} << stored) : bits;
  }
};

struct Rescale {
  double slope;
  double intercept;
  bool padded;
  std::pair<double, double> padding;

  /// `clamped` is set when the value does not fit.
  std::int16_t hu(std::int64_t stored, bool& clamped) const {
    const auto v = static_cast<double>(stored);
    if (padded && v >= padding.first && v <= padding.second) return kAirHu;
    const double exact = slope * v + intercept;
    clamped = exact > 32767.5 || exact < -32768.5;
    return rounded_hu(v, slope, intercept);
  }
};

/// All values of a word of 8 or 16 bits once, instead of the arithmetic for each voxel.
template <class Word>
std::size_t convert(const char* words, std::size_t count, const StoredBits& bits, const Rescale& rescale,
                    std::int16_t* hu) {
  std::size_t clamped = 0;
  if constexpr (sizeof(Word) <= 2) {
    const std::size_t values = std::size_t{1} << (8 * sizeof(Word));
    std::vector<std::int16_t> table(values);
    std::vector<bool> over(values);
    bool any = false;
    for (std::size_t w = 0; w < values; ++w) {
      bool is_over = false;
      table[w] = rescale.hu(bits.value(static_cast<std::uint32_t>(w)), is_over);
      over[w] = is_over;
      any = any || is_over;
    }
    for (std::size_t i = 0; i < count; ++i) {
      Word w;
      std::memcpy(&w, words + i * sizeof(Word), sizeof(Word));
      hu[i] = table[w];
      if (any && over[w]) ++clamped;
    }
  } else {
    for (std::size_t i = 0; i < count; ++i) {
      Word w;
      std::memcpy(&w, words + i * sizeof(Word), sizeof(Word));
      bool is_over = false;
      hu[i] = rescale.hu(bits.value(w), is_over);
      clamped += is_over ? 1 : 0;
    }
  }
  return clamped;
}

}  // namespace

std::int16_t rounded_hu(double stored, double slope, double intercept) {
  return static_cast<std::int16_t>(std::clamp(std::round(slope * stored + intercept), -32768.0, 32767.0));
}

struct PictureReader::OpenFile {
  OpenFile(const std::filesystem::path& path, int number) : file(number), map(path), stream(map.bytes()) {}
  int file;
  MappedFile map;
  ByteStream stream;
  gdcm::ImageReader reader;
  std::vector<char> all;  ///< every frame, where they could not be told apart while packed
};

PictureReader::PictureReader(const FileList& files, Padding padding) : files_(files), padding_(padding) {
  gdcm::Trace::WarningOff();
  gdcm::Trace::ErrorOff();
  gdcm::Trace::DebugOff();
}
PictureReader::~PictureReader() = default;

void PictureReader::open(const Picture& picture) {
  if (open_ && open_->file == picture.file) return;
  open_.reset();
  auto opened = std::make_unique<OpenFile>(files_.path(picture.file), picture.file);
  opened->reader.SetStream(opened->stream);
  if (!opened->reader.Read())
    throw SeriesError("cannot be read as a DICOM image (cut short or damaged); copy the file again");
  open_ = std::move(opened);
}

std::size_t PictureReader::read(const Picture& picture, std::int16_t* hu) {
  const auto fail = [&](const std::string& what) -> SeriesError {
    return SeriesError(files_.name(picture.file) + ": " + what);
  };
  try {
    open(picture);
  } catch (const std::exception& e) {
    throw fail(e.what());
  }
  const gdcm::Image& image = open_->reader.GetImage();
  const auto columns = static_cast<unsigned>(picture.columns);
  const auto rows = static_cast<unsigned>(picture.rows);
  const auto frames = static_cast<unsigned>(picture.frames);
  const std::string damaged = "its picture is cut short or damaged; copy the file again";
  if (image.GetDimension(0) != columns || image.GetDimension(1) != rows) throw fail(damaged);
  if (image.GetPixelFormat().GetSamplesPerPixel() != 1)
    throw fail("is a colour picture, not a CT slice; take it out of the folder");

  // One frame by itself: where the packed frames lie apart, or unpacked ones one after the other.
  gdcm::Bitmap single;
  single.SetNumberOfDimensions(2);
  single.SetDimension(0, columns);
  single.SetDimension(1, rows);
  single.SetPixelFormat(image.GetPixelFormat());
  single.SetPhotometricInterpretation(image.GetPhotometricInterpretation());
  single.SetTransferSyntax(image.GetTransferSyntax());
  single.SetNeedByteSwap(image.GetNeedByteSwap());
  const auto& element = image.GetDataElement();
  const auto* fragments = element.GetSequenceOfFragments();
  const auto* bytes = element.GetByteValue();
  const std::size_t word_bytes = image.GetPixelFormat().GetPixelSize();
  const std::size_t count = static_cast<std::size_t>(columns) * rows;
  const char* words = nullptr;
  gdcm::PixelFormat format = image.GetPixelFormat();
  gdcm::DataElement of_frame(gdcm::Tag(0x7fe0, 0x0010));
  bool alone = frames == 1;
  if (alone) {
    of_frame = element;
  } else if (fragments != nullptr && fragments->GetNumberOfFragments() == frames) {
    auto fragment = gdcm::SequenceOfFragments::New();
    fragment->AddFragment(fragments->GetFragment(static_cast<unsigned>(picture.frame)));
    of_frame.SetValue(*fragment);
    alone = true;
  } else if (fragments == nullptr && bytes != nullptr && bytes->GetLength() >= count * word_bytes * frames) {
    of_frame.SetByteValue(bytes->GetPointer() + count * word_bytes * static_cast<std::size_t>(picture.frame),
                          static_cast<std::uint32_t>(count * word_bytes));
    alone = true;
  }
  if (alone) {
    single.SetDataElement(of_frame);
    buffer_.assign(std::max<std::size_t>(single.GetBufferLength(), count * word_bytes), 0);
    // A cut-short packed picture passes Read() and fails only here.
    if (single.GetBufferLength() < count * word_bytes || !single.GetBuffer(buffer_.data())) throw fail(damaged);
    words = buffer_.data();
    format = single.GetPixelFormat();  // a JPEG 2000 stream may hold more bits than the header says
  } else {
    if (open_->all.empty()) {
      std::vector<char> all(image.GetBufferLength());
      if (all.size() < count * word_bytes * frames || !image.GetBuffer(all.data())) throw fail(damaged);
      open_->all = std::move(all);
    }
    words = open_->all.data() + count * word_bytes * static_cast<std::size_t>(picture.frame);
    format = image.GetPixelFormat();
  }

  const StoredBits bits{format.GetBitsAllocated(), format.GetBitsStored(), format.GetHighBit(),
                        format.GetPixelRepresentation() == 1};
  if (bits.stored < 1 || bits.stored > bits.allocated || bits.high + 1 < bits.stored || bits.high >= bits.allocated)
    throw fail("its header contradicts itself about the bits of a voxel; export the series again");
  const Rescale rescale{picture.slope, picture.intercept, padding_ == Padding::to_air && picture.padding.has_value(),
                        picture.padding.value_or(std::pair{0.0, 0.0})};
  if (bits.allocated != 8 * word_bytes) throw fail(damaged);
  switch (word_bytes) {
    case 1:
      return convert<std::uint8_t>(words, count, bits, rescale, hu);
    case 2:
      return convert<std::uint16_t>(words, count, bits, rescale, hu);
    case 4:
      return convert<std::uint32_t>(words, count, bits, rescale, hu);
    default:
      throw fail("has an unknown number of bits a voxel; export the series again");
  }
}

}  // namespace vallecula::pipeline
