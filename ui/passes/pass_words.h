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

// A pass in words.
struct PassWords
{
    Q_DECLARE_TR_FUNCTIONS(PassWords)
};

[[nodiscard]] QString lengthText(Seconds time);               // "10:12", "2 h 05"
[[nodiscard]] QString riseText(const passes::Pass& pass);     // "17:05:59"; "up" where the span begins with it
[[nodiscard]] QString setText(const passes::Pass& pass);      // "17:16:11"; "up" where the span ends with it
[[nodiscard]] QString partText(Seconds part, Seconds whole);  // "no", "all", or how long
[[nodiscard]] QString untilText(const passes::Pass& pass, UtcTime now);  // "in 5 min"; "up" until it sets
[[nodiscard]] Seconds hiddenTime(const passes::Pass& pass);              // by horizon, keep-outs or limits
// How old the elements are, and what that means for the beam.
struct ElementAge
{
    QString days;
    Seconds late;
    Angle shift;            // at the highest moment
    Angle beam;             // its width
    bool isTooOld = false;  // more than half the beam
};

[[nodiscard]] ElementAge ageOf(const BookedPass& one, const PassBook& book, UtcTime now);

[[nodiscard]] QString daysText(const ElementAge& age);  // "4.4 d", "4.4 d, too old"

// A line for each fact.
[[nodiscard]] QString factsOf(const BookedPass& one, const PassBook& book, UtcTime now);
// What the table does not show of it: where it rises and sets, what the limits hide, and how old the elements are.
// Its name is in the table, too, but in no picture.
[[nodiscard]] QString briefFactsOf(const BookedPass& one, const PassBook& book, UtcTime now, bool isNamed);

// One line: "in sunlight", "enters the shadow 17:05:59Z".
[[nodiscard]] QString lightText(const passes::PassLight& light);
[[nodiscard]] QString cableFact(const targets::CableTurns& cable);  // one line, where the cable ends
// Sentences: whether the cable has room for all of a pass, and what happens where it has not.
[[nodiscard]] QString briefCableText(const targets::CableTurns& cable);  // "no", "0:37", "0:37 or flip"
[[nodiscard]] QString cableText(const targets::CableTurns& cable);

}  // namespace boresight::ui
