// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/supervision/symptom.h"

#include <QString>

#include <limits>
#include <optional>

// One symptom with hysteresis in value and in time, so that its alarm does not flicker. The symptom begins when a value
// has stayed at or above a limit for `after`. It ends when the value has stayed below `release` for `quietFor`. Pure.
namespace boresight::supervision {

struct WatchLimits
{
    double hint = std::numeric_limits<double>::infinity();
    double stop = std::numeric_limits<double>::infinity();
    double release = 0.0;   // the symptom ends below this value
    Seconds after{0.0};     // time at or above a limit until the symptom begins
    Seconds quietFor{1.0};  // time below `release` until the symptom ends
};

class Watch
{
public:
    explicit Watch(Symptom symptom) : m_symptom(symptom) {}

    // Calls `words` when the symptom begins, becomes a stop, or its value has doubled. Else the text stays as it is.
    template <class Words>
    void update(SteadyTime now, double value, const WatchLimits& limits, const Words& words)
    {
        if (const auto weight = judge(now, value, limits)) {
            m_observed = Observed{.symptom = m_symptom, .weight = *weight, .what = words()};
            m_told = value;
        }
    }
    void forget() { *this = Watch(m_symptom); }

    [[nodiscard]] const std::optional<Observed>& observed() const { return m_observed; }

private:
    // The weight of a symptom that needs a new text.
    [[nodiscard]] std::optional<Weight> judge(SteadyTime now, double value, const WatchLimits& limits);

    Symptom m_symptom;
    std::optional<SteadyTime> m_hintSince;
    std::optional<SteadyTime> m_stopSince;
    std::optional<SteadyTime> m_quietSince;
    std::optional<Observed> m_observed;
    double m_told = 0.0;  // the value in the text
};

}  // namespace boresight::supervision
