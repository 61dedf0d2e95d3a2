// The sentences that in_words() may know, a file for each place below that they come from; listed for lupdate, and read
// by no one else than sentences_from_below(): whoever changes one below changes it here.
#pragma once

#include <iterator>
#include <string>
#include <vector>

namespace vallecula::gui::from_below {

using Sentences = std::vector<std::string>;

Sentences device();
Sentences pipeline();
Sentences scores();
Sentences reasons();
Sentences courses();
Sentences trials();
/// Titles and texts; in a translation context of their own, "Courses".
Sentences shipped_courses();
/// Those with places for words: names, or others of these sentences.
Sentences built();

}  // namespace vallecula::gui::from_below
