// fuzz_seeds FOLDER: small good files of every kind the reader knows, for the fuzz targets to begin with.
#include <zlib.h>

#include <cstdio>
#include <cstring>

#include "tests/pipeline/dicom_file.h"
#include "tests/pipeline/gdcm_syntax.h"

namespace {

using namespace vallecula::pipeline::test;

DicomSlice slice(int k) {
  DicomSlice d;
  d.columns = 12;
  d.rows = 10;
  d.instance = std::to_string(k + 1);
  d.position = decimal_string({0, 0, 2.0 * k});
  for (int i = 0; i < 120; ++i) d.stored.push_back(static_cast<std::uint16_t>((i * 19 + k) % 4096));
  return d;
}

std::string nifti() {
  std::string h(352, '\0');
  const auto put = [&](std::size_t at, auto v) { std::memcpy(h.data() + at, &v, sizeof v); };
  put(0, 348);
  const std::int16_t dim[8] = {3, 4, 4, 4, 1, 1, 1, 1};
  std::memcpy(h.data() + 40, dim, sizeof dim);
  put(70, std::int16_t{4});
  put(108, 352.0f);
  put(254, std::int16_t{1});
  const float rows[12] = {-2, 0, 0, 39, 0, -2, 0, 35, 0, 0, 2, -29};
  std::memcpy(h.data() + 280, rows, sizeof rows);
  std::memcpy(h.data() + 344, "n+1", 4);
  return h + std::string(128, '\5');
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: fuzz_seeds FOLDER\n", stderr);
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  for (std::size_t i = 0; i < syntaxes().size(); ++i) {
    const auto file = folder / ("dicom-" + std::to_string(i));
    write_dicom(slice(1), file);
    if (!rewrite(file, file, syntaxes()[i].second)) std::filesystem::remove(file);
  }
  auto odd = slice(1);
  odd.padding = 5;
  odd.extra[0x00080008] = {"CS", "ORIGINAL\\PRIMARY\\AXIAL"};
  odd.extra[0x00181210] = {"SH", "H30s"};
  odd.extra[0x00200012] = {"IS", "2"};
  write_dicom(odd, folder / "dicom-odd");
  write_bytes(dicom_bytes(slice(1)).substr(132), folder / "dicom-bare");
  write_bytes(enhanced_bytes({slice(2), slice(0), slice(1)}), folder / "enhanced");
  write_bytes(nifti(), folder / "nifti");
  const std::string geometry =
      "space: left-posterior-superior\nsizes: 4 4 4\nspace directions: (2,0,0) (0,2,0) (0,0,2)\n";
  write_bytes("NRRD0004\ntype: short\ndimension: 3\n" + geometry +
                  "encoding: raw\nendian: little\nspace origin: (-39,-35,-29)\n\n" + std::string(128, '\5'),
              folder / "nrrd");
  write_bytes(
      "NDims = 3\nDimSize = 4 4 4\nElementSpacing = 2 2 2\nOffset = 1 2 3\nTransformMatrix = 1 0 0 0 1 0 0 0 1\n"
      "ElementType = MET_FLOAT\nElementDataFile = LOCAL\n" +
          std::string(256, '\5'),
      folder / "meta");
  uLongf size = 4096;
  std::string packed(size, '\0');
  const auto plain = nifti();
  z_stream z{};
  deflateInit2(&z, 6, Z_DEFLATED, 31, 8, Z_DEFAULT_STRATEGY);
  z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(plain.data()));
  z.avail_in = static_cast<uInt>(plain.size());
  z.next_out = reinterpret_cast<Bytef*>(packed.data());
  z.avail_out = static_cast<uInt>(size);
  deflate(&z, Z_FINISH);
  packed.resize(z.total_out);
  deflateEnd(&z);
  write_bytes(packed, folder / "nifti-packed");
  return 0;
}
