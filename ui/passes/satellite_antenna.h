// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/profile/profile.h"
#include "ui/kit/touch_combo.h"

#include <optional>

// The antenna with which a satellite is tracked, stored in the profile. Hidden if the mount has one antenna only. Gui
// thread.
namespace boresight::ui {

class ProfileDraft;
class ValueLabel;

class SatelliteAntenna : public TouchCombo
{
    Q_OBJECT

public:
    SatelliteAntenna(ProfileDraft& draft, ValueLabel& notice, QWidget* parent = nullptr);

    // Empty: no satellite is selected.
    void show(const std::optional<int>& satellite, const profile::Profile& profile);
    void setRoom(bool has);  // whether there is room for it

private:
    void store(int index);
    void showStored();

    ProfileDraft& m_draft;
    ValueLabel& m_notice;
    std::optional<int> m_satellite;
    QStringList m_names;  // the first name is empty: no antenna of its own
    QString m_stored;
    bool m_hasRoom = true;
};

}  // namespace boresight::ui
