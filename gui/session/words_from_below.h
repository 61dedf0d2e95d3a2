// Fixed words and sentences that come as std::string out of device, pipeline and curricula, in the window's language.
#pragma once

#include <QString>
#include <string>
#include <vector>

namespace vallecula::gui {

/// The text in the window's language; as it is where it is none of sentences_from_below() (it holds a number or a name,
/// or nobody has listed it).
QString in_words(const std::string& text);

/// All that in_words() may know, as the folders below write them.
std::vector<std::string> sentences_from_below();

}  // namespace vallecula::gui
