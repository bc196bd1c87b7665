// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/supervision/symptom.h"

#include <functional>
#include <limits>
#include <optional>

// One symptom with hysteresis in value and in time, so that an alarm does not flicker: it begins when a value has
// stayed at or beyond a limit for a time, and ends when it has stayed below a lower value for another. Pure.
namespace boresight::supervision {

struct WatchLimits
{
    double hint = std::numeric_limits<double>::infinity();
    double stop = std::numeric_limits<double>::infinity();
    double release = 0.0;   // ends below it
    Seconds after{0.0};     // at or beyond a limit for so long
    Seconds quietFor{1.0};  // below `release` for so long
};

class Watch
{
public:
    explicit Watch(Symptom symptom) : m_symptom(symptom) {}

    // `words` is asked when the symptom begins, becomes a stop or has doubled: the text keeps the numbers of then.
    void update(SteadyTime now, double value, const WatchLimits& limits, const std::function<QString()>& words);
    void forget() { *this = Watch(m_symptom); }

    [[nodiscard]] const std::optional<Observed>& observed() const { return m_observed; }

private:
    Symptom m_symptom;
    std::optional<SteadyTime> m_hintSince;
    std::optional<SteadyTime> m_stopSince;
    std::optional<SteadyTime> m_quietSince;
    std::optional<Observed> m_observed;
    double m_told = 0.0;  // the value in the text
};

}  // namespace boresight::supervision
