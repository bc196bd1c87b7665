// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/passes/pass.h"
#include "core/passes/pass_light.h"
#include "core/targets/cable_turns.h"
#include "ui/passes/pass_book.h"

#include <QCoreApplication>
#include <QString>

namespace boresight::ui {

// Translates the texts about a pass.
struct PassWords
{
    Q_DECLARE_TR_FUNCTIONS(PassWords)
};

[[nodiscard]] QString lengthText(Seconds time);  // "10:12", "2 h 05"
[[nodiscard]] QString riseText(
    const passes::Pass& pass);  // "17:05:59"; "up" if the satellite is up when the search begins
[[nodiscard]] QString setText(
    const passes::Pass& pass);  // "17:16:11"; "up" if the satellite is up when the search ends
[[nodiscard]] QString partText(Seconds part, Seconds whole);             // "no", "all", or a length
[[nodiscard]] QString untilText(const passes::Pass& pass, UtcTime now);  // "in 5 min"; "up" during the pass
[[nodiscard]] Seconds hiddenTime(const passes::Pass& pass);              // hidden by horizon, keep-outs or limits
// The age of the elements, and the error that it causes.
struct ElementAge
{
    QString days;
    Seconds late;
    Angle shift;            // the error at the highest moment
    Angle beam;             // the beam width
    bool isTooOld = false;  // the error exceeds half the beam width
};

[[nodiscard]] ElementAge ageOf(const BookedPass& one, const PassBook& book, UtcTime now);

[[nodiscard]] QString daysText(const ElementAge& age);  // "4.4 d", "4.4 d, too old"

// One line for each fact.
[[nodiscard]] QString factsOf(const BookedPass& one, const PassBook& book, UtcTime now);
// The facts that the table does not show: where the satellite rises and sets, how long the limits hide it, and the age
// of the elements. `isNamed`: with the name, for views that do not show it.
[[nodiscard]] QString briefFactsOf(const BookedPass& one, const PassBook& book, UtcTime now, bool isNamed);

// One line: "in sunlight", "enters the shadow 17:05:59Z".
[[nodiscard]] QString lightText(const passes::PassLight& light);
[[nodiscard]] QString cableFact(const targets::CableTurns& cable);  // one line: where the cable ends
// `cableText`: sentences about whether the cable has room for the whole pass, and what happens if not.
[[nodiscard]] QString briefCableText(const targets::CableTurns& cable);  // "no", "0:37", "over the top"
[[nodiscard]] QString cableText(const targets::CableTurns& cable);

}  // namespace boresight::ui
