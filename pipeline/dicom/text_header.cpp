#include "pipeline/dicom/text_header.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>

#include "pipeline/dicom/series_error.h"

namespace vallecula::pipeline {

std::string stripped(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return std::string(text);
}

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::vector<double> numbers_in(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '(' || c == ')' || c == ','; }, ' ');
  std::vector<double> values;
  const char* at = text.c_str();
  for (;;) {
    while (*at == ' ' || *at == '\t') ++at;
    if (*at == '\0') return values;
    char* rest = nullptr;
    const double value = std::strtod(at, &rest);
    if (rest == at || !std::isfinite(value) || values.size() > 64)
      throw SeriesError("its header is damaged: a number was expected; export it again");
    values.push_back(value);
    at = rest;
  }
}

void sizes_in(const std::string& text, int (&sizes)[3]) {
  const auto values = numbers_in(text);
  if (values.size() != 3) throw SeriesError("is no volume of three dimensions; export the CT as one volume");
  for (int a = 0; a < 3; ++a) {
    if (!(values[a] >= 1.0 && values[a] < 2e9) || values[a] != std::floor(values[a]))
      throw SeriesError("its header is damaged: a size is no whole number; export it again");
    sizes[a] = static_cast<int>(values[a]);
  }
}

std::string file_beside(const std::string& text) {
  if (text.empty() || text.find('/') != std::string::npos || text.find('\0') != std::string::npos || text == ".." ||
      text == ".") {
    throw SeriesError("its voxels lie in another folder; put both files into one folder and name them so");
  }
  return text;
}

}  // namespace vallecula::pipeline
