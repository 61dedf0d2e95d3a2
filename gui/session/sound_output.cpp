#include "gui/session/sound_output.h"

#include <QAudioDeviceInfo>
#include <QAudioOutput>
#include <QIODevice>
#include <QThread>
#include <chrono>
#include <mutex>
#include <vector>

namespace vallecula::gui {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kRate_hz = 44100;
constexpr double kBuffer_s = 0.08;  // late by less than a beat is long, and not cut by a busy computer
constexpr auto kStale = std::chrono::seconds(1);
constexpr unsigned long kPatience_ms = 1000;

QAudioFormat wanted_format() {
  QAudioFormat format;
  format.setSampleRate(kRate_hz);
  format.setChannelCount(1);
  format.setSampleSize(16);
  format.setSampleType(QAudioFormat::SignedInt);
  format.setByteOrder(QAudioFormat::Endian(QSysInfo::ByteOrder));
  format.setCodec("audio/pcm");
  return format;
}

}  // namespace

/// Said on the window's thread, read on the sound's; the lock is held for a copy.
struct SoundOutput::Shared {
  std::mutex mutex;
  MonitorState state;
  double volume = 0.0;
  Clock::time_point said;
};

namespace {

/// The tones as a stream of 16 bit samples, the same on every channel.
template <class Shared>
class ToneStream : public QIODevice {
 public:
  ToneStream(std::shared_ptr<Shared> shared, const QAudioFormat& format)
      : shared_(std::move(shared)), channels_(format.channelCount()), tones_(format.sampleRate()) {
    open(QIODevice::ReadOnly);
  }
  bool isSequential() const override { return true; }
  qint64 bytesAvailable() const override { return (1 << 16) + QIODevice::bytesAvailable(); }

 protected:
  qint64 readData(char* data, qint64 most) override {
    {
      const std::lock_guard<std::mutex> lock(shared_->mutex);
      tones_.set(Clock::now() - shared_->said < kStale ? shared_->state : MonitorState());
      tones_.set_volume(shared_->volume);
    }
    const std::size_t frames = static_cast<std::size_t>(most) / (2 * static_cast<std::size_t>(channels_));
    mono_.resize(frames);
    tones_.fill(mono_.data(), frames);
    auto* out = reinterpret_cast<qint16*>(data);
    for (const float sample : mono_)
      for (int c = 0; c < channels_; ++c) *out++ = static_cast<qint16>(32767.0f * sample);
    return static_cast<qint64>(frames) * 2 * channels_;
  }
  qint64 writeData(const char*, qint64) override { return -1; }

 private:
  std::shared_ptr<Shared> shared_;
  int channels_;
  MonitorTones tones_;
  std::vector<float> mono_;
};

/// Lives on the sound's thread.
class Speaker : public QObject {
  Q_OBJECT
 public:
  /// Opens it and plays; says why it does not, or nothing.
  template <class Shared>
  QString play(const std::shared_ptr<Shared>& shared) {
    const QAudioDeviceInfo speaker = QAudioDeviceInfo::defaultOutputDevice();
    if (speaker.isNull()) return SoundOutput::tr("No sound: this computer has no loudspeaker that can be used.");
    QAudioFormat format = wanted_format();
    if (!speaker.isFormatSupported(format)) format = speaker.nearestFormat(format);
    if (format.sampleSize() != 16 || format.sampleType() != QAudioFormat::SignedInt || format.channelCount() < 1)
      return SoundOutput::tr("No sound: the loudspeaker takes no 16 bit samples.");
    auto* stream = new ToneStream<Shared>(shared, format);
    stream->setParent(this);
    auto* output = new QAudioOutput(speaker, format, this);
    output->setBufferSize(static_cast<int>(kBuffer_s * format.sampleRate()) * format.channelCount() * 2);
    output->start(stream);
    return output->error() == QAudio::NoError
               ? QString()
               : SoundOutput::tr("No sound: the loudspeaker could not be opened. Another program may have it.");
  }

 signals:
  void answered(const QString& remark);
};

}  // namespace

SoundOutput::SoundOutput(QObject* parent) : QObject(parent), shared_(std::make_shared<Shared>()) {}

SoundOutput::~SoundOutput() {
  if (thread_ == nullptr) return;
  thread_->quit();
  if (thread_->wait(kPatience_ms))
    delete thread_;
  else  // a sound system that does not answer keeps its thread until it does; the window does not wait for it
    connect(thread_, &QThread::finished, thread_, &QObject::deleteLater);
}

void SoundOutput::open() {
  if (thread_ != nullptr) return;
  thread_ = new QThread;
  thread_->setObjectName("monitor's sound");
  auto* speaker = new Speaker;
  speaker->moveToThread(thread_);
  connect(thread_, &QThread::finished, speaker, &QObject::deleteLater);
  connect(thread_, &QThread::started, speaker,
          [speaker, shared = shared_] { emit speaker->answered(speaker->play(shared)); });
  connect(speaker, &Speaker::answered, this, [this](const QString& remark) {
    remark_ = remark;
    emit answered();
  });
  thread_->start();
}

void SoundOutput::hear(const MonitorState& state) {
  const std::lock_guard<std::mutex> lock(shared_->mutex);
  shared_->state = state;
  shared_->said = Clock::now();
}

void SoundOutput::set_volume(double volume) {
  const std::lock_guard<std::mutex> lock(shared_->mutex);
  shared_->volume = volume;
}

}  // namespace vallecula::gui

#include <sound_output.moc>  // of the Speaker above
