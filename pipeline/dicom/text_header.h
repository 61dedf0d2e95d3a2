// Words and numbers of text headers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace vallecula::pipeline {

/// Without the blanks at both ends.
std::string stripped(std::string_view text);
std::string lower_case(std::string text);
/// All numbers in `text`, brackets and commas taken as blanks; throws SeriesError when something else stands there.
std::vector<double> numbers_in(std::string text);
/// The sizes of three axes; throws SeriesError when there are not three or they are no whole numbers.
void sizes_in(const std::string& text, int (&sizes)[3]);
/// A plain file name, of a file beside the header; throws SeriesError when it leads elsewhere.
std::string file_beside(const std::string& text);

}  // namespace vallecula::pipeline
