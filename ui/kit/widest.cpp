// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/widest.h"

#include "core/messages/station_status.h"

#include <QFontMetrics>

#include <algorithm>

namespace boresight::ui {

namespace {

template <class State>
QString widestWord(const QFont& font, State last)
{
    QStringList words;
    for (int state = 0; state <= static_cast<int>(last); ++state) {
        words << word(static_cast<State>(state));
    }
    return widest(font, words);
}

int linesNeeded(const QFontMetrics& metrics, const QStringList& words, int width)
{
    int lines = 1;
    QString line;
    for (const QString& word : words) {
        const QString longer = line.isEmpty() ? word : line + QLatin1Char(' ') + word;
        const bool fits = line.isEmpty() || metrics.horizontalAdvance(longer) <= width;
        lines += fits ? 0 : 1;
        line = fits ? longer : word;
    }
    return lines;
}

QString narrowestLine(const QFontMetrics& metrics, const QString& text, int lines)
{
    const QStringList words = text.split(QLatin1Char(' '));
    const auto wide = [&](const QString& run) { return metrics.horizontalAdvance(run); };
    const int least = wide(*std::ranges::max_element(words, {}, wide));
    QString best = text;
    for (qsizetype first = 0; first < words.size(); ++first) {
        for (qsizetype count = 1; first + count <= words.size(); ++count) {
            const QString run = words.mid(first, count).join(QLatin1Char(' '));
            if (wide(run) >= least && wide(run) < wide(best) && linesNeeded(metrics, words, wide(run)) <= lines) {
                best = run;
            }
        }
    }
    return best;
}

}  // namespace

QString widestLine(const QFont& font, const QStringList& texts, int lines)
{
    const QFontMetrics metrics(font);
    QStringList narrow;
    for (const QString& text : texts) {
        narrow << narrowestLine(metrics, text, lines);
    }
    return widest(font, narrow);
}

QString widest(const QFont& font, const QStringList& texts)
{
    const QFontMetrics metrics(font);
    const auto wide = [&](const QString& text) { return metrics.horizontalAdvance(text); };
    const auto found = std::ranges::max_element(texts, {}, wide);
    return found == texts.end() ? QString() : *found;
}

QString widestStationState(const QFont& font)
{
    return widestWord(font, StationState::Fault);
}

QString widestAxisState(const QFont& font)
{
    return widestWord(font, AxisState::Missing);
}

}  // namespace boresight::ui
