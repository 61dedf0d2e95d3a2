// The pipeline's messages advise options of the command line; a person at the window has other means.
#pragma once

#include <QString>

namespace vallecula::gui {

/// The message with what the window offers in the place of each option.
QString window_message(const QString& message);
/// A failure of the pipeline as a sentence of its own: without the word for what a person knows he is reading.
QString window_sentence(const QString& message);
/// "1 skin, 2 bone_skull, ...": what the values of a label map without names are taken for.
QString label_values_text();

}  // namespace vallecula::gui
