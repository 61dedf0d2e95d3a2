#include "curricula/score/criterion.h"

#include <QString>

namespace vallecula::curricula {

std::string fixed(double value, int decimals) { return QString::number(value, 'f', decimals).toStdString(); }
std::string millimetres(double m) { return fixed(1e3 * m, 1) + " mm"; }
std::string second(double time_s) { return fixed(time_s, 2) + " s"; }
std::string limit_text(double value) { return QString::number(value, 'g', 6).toStdString(); }

/// Two decimals, or four where two would make an excess look like equality.
std::string figure(const Criterion& c) {
  if (c.unit == "%" || c.unit == "per minute") {  // nobody reads a monitor, or a view, to a part of one
    int decimals = 0;
    const auto shown = [&] { return QString::number(c.value, 'f', decimals).toDouble(); };
    // Rounded it must not lie on the other side of the limit, nor, where that was missed, on it.
    const bool above = c.value > c.limit;
    while (decimals < 4 && c.value != c.limit && (above ? shown() < c.limit : shown() > c.limit)) ++decimals;
    while (!c.met && decimals < 4 && fixed(c.value, decimals) == fixed(c.limit, decimals)) ++decimals;
    return fixed(c.value, decimals);
  }
  const std::string text = fixed(c.value, 2);
  return text == fixed(c.limit, 2) && c.value != c.limit ? fixed(c.value, 4) : text;
}

Criterion at_most(const char* name, const char* unit, double value, double limit, double at_s, const std::string& what,
                  const std::string& when) {
  Criterion c{name, unit, value, limit, at_s, value <= limit, {}};
  c.sentence = what + " " + figure(c) + " " + unit + when + (c.met ? ", within the " : ", more than the ") +
               limit_text(limit) + " " + unit + " allowed";
  return c;
}

Criterion at_least(const char* name, const char* unit, double value, double limit, double at_s, const std::string& what,
                   const std::string& when) {
  Criterion c{name, unit, value, limit, at_s, value >= limit, {}};
  c.sentence = what + " " + figure(c) + " " + unit + when + (c.met ? ", at least the " : ", less than the ") +
               limit_text(limit) + " " + unit + " asked for";
  return c;
}

Criterion fact(const char* name, bool met, double at_s, const std::string& sentence) {
  return {name, "", met ? 1.0 : 0.0, 1.0, at_s, met, sentence};
}

}  // namespace vallecula::curricula
