#include "pipeline/dicom/write_volume.h"

#include <unistd.h>

#include <fstream>
#include <stdexcept>

namespace vallecula::pipeline {

void write_volume(const CtVolume& volume, const std::filesystem::path& file) {
  const auto& g = volume.geometry;
  auto aside = file;
  aside += ".part-" + std::to_string(::getpid());
  std::ofstream out(aside, std::ios::binary);
  out.precision(17);
  const auto vector = [&](const Vector3& v) { out << " (" << v[0] << ',' << v[1] << ',' << v[2] << ')'; };
  out << "NRRD0004\ntype: int16\ndimension: 3\nspace: left-posterior-superior\nsizes: " << g.size[0] << ' ' << g.size[1]
      << ' ' << g.size[2] << "\nspace directions:";
  for (const auto& step : g.step) vector(step);
  out << "\nkinds: domain domain domain\nendian: little\nencoding: raw\nspace units: \"mm\" \"mm\" \"mm\"\nspace "
         "origin:";
  vector(g.origin);
  out << "\n\n";
  out.write(reinterpret_cast<const char*>(volume.voxels.get()),
            static_cast<std::streamsize>(g.count() * sizeof(std::int16_t)));
  out.close();
  std::error_code error;
  if (out) std::filesystem::rename(aside, file, error);
  if (!out || error) {
    std::filesystem::remove(aside, error);
    throw std::runtime_error("volume: it cannot be written there; check the folder, its permissions and the space");
  }
}

}  // namespace vallecula::pipeline
