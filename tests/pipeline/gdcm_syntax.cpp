#include "tests/pipeline/gdcm_syntax.h"

#include <gdcmImageChangeTransferSyntax.h>
#include <gdcmImageReader.h>
#include <gdcmImageWriter.h>
#include <gdcmTrace.h>

namespace vallecula::pipeline::test {

const std::vector<std::pair<std::string, std::string>>& syntaxes() {
  static const std::vector<std::pair<std::string, std::string>> kSyntaxes = {
      {"implicit little endian", "1.2.840.10008.1.2"},
      {"explicit little endian", "1.2.840.10008.1.2.1"},
      {"deflated", "1.2.840.10008.1.2.1.99"},
      {"explicit big endian", "1.2.840.10008.1.2.2"},
      {"RLE", "1.2.840.10008.1.2.5"},
      {"JPEG lossless, process 14", "1.2.840.10008.1.2.4.57"},
      {"JPEG lossless, selection 1", "1.2.840.10008.1.2.4.70"},
      {"JPEG-LS lossless", "1.2.840.10008.1.2.4.80"},
      {"JPEG 2000 lossless", "1.2.840.10008.1.2.4.90"},
      {"JPEG 2000", "1.2.840.10008.1.2.4.91"}};
  return kSyntaxes;
}

bool rewrite(const std::filesystem::path& from, const std::filesystem::path& to, const std::string& syntax) {
  gdcm::Trace::WarningOff();
  gdcm::Trace::ErrorOff();
  gdcm::ImageReader reader;
  reader.SetFileName(from.c_str());
  if (!reader.Read()) return false;
  gdcm::ImageChangeTransferSyntax change;
  change.SetTransferSyntax(gdcm::TransferSyntax(gdcm::TransferSyntax::GetTSType(syntax.c_str())));
  change.SetInput(reader.GetImage());
  if (!change.Change()) return false;
  gdcm::ImageWriter writer;
  writer.SetFile(reader.GetFile());
  writer.SetImage(change.GetOutput());
  writer.SetFileName(to.c_str());
  return writer.Write();
}

}  // namespace vallecula::pipeline::test
