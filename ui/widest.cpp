// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widest.h"

#include "core/station/station_status.h"

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

}  // namespace

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
    return widestWord(font, AxisState::Off);
}

}  // namespace boresight::ui
