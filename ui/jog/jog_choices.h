// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/link/profile_draft.h"

#include <QWidget>

#include <optional>
#include <vector>

// The settings of the pad: the rate while a button is pressed, between the slow and the fast rate of the profile in
// effect, and the size of a step. Until the cable wraps are known and the directions are confirmed, the rate is
// limited, and the label says so. The chosen rate is restored afterwards.
namespace boresight::ui {

class ChoiceButton;
class JogPad;
class RateSlider;
class ValueLabel;

class JogChoices : public QWidget
{
    Q_OBJECT

public:
    JogChoices(const ProfileDraft& draft, JogPad& pad, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);

private:
    [[nodiscard]] QLayout* makeRate();
    [[nodiscard]] QWidget* makeSteps();
    void choose(AngularRate rate);
    [[nodiscard]] const profile::JogSettings& rates() const { return m_draft.inForce().jog; }
    void showRate();
    void showSteps(const Capabilities& capabilities);

    const ProfileDraft& m_draft;
    JogPad& m_pad;
    ValueLabel* m_rate;
    RateSlider* m_slider;
    std::optional<AngularRate> m_chosen;  // empty: the normal rate of the profile
    AngularRate m_fastest;
    std::vector<ChoiceButton*> m_steps;
};

}  // namespace boresight::ui
