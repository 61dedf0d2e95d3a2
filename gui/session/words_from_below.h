// Fixed words and sentences that come as std::string out of device, pipeline and curricula, in the window's language.
#pragma once

#include <QString>
#include <string>
#include <vector>

namespace vallecula::gui {

/// The text in the window's language, its figures with this language's decimal point; as it is where it is none of
/// sentences_from_below() and not put together of them (it holds a name, or nobody has listed it).
QString in_words(const std::string& text);

/// A course's text in the window's language: of one that is, word for word, one of the shipped courses'. What an
/// educator wrote stays as it is.
QString course_words(const std::string& text);

/// A figure for the window, with so many digits after its language's decimal point. Files keep points.
QString decimal(double value, int digits);
/// The same with so many significant digits, as short as it can be.
QString short_decimal(double value, int significant);

/// All that in_words() may know, as the folders below write them.
std::vector<std::string> sentences_from_below();

}  // namespace vallecula::gui
