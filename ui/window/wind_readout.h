// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/wind_status.h"

#include <QWidget>

// The wind and how old its last reading is, in one line below the axes. A speed that is not of now is not shown. Not
// there while the profile reads no wind. Gui thread.
namespace boresight::ui {

class ValueLabel;

class WindReadout : public QWidget
{
    Q_OBJECT

public:
    explicit WindReadout(QWidget* parent = nullptr);

    void showStatus(const WindStatus& wind);
    [[nodiscard]] bool isConfigured() const { return m_isConfigured; }

private:
    ValueLabel* m_speed;
    ValueLabel* m_detail;
    ValueLabel* m_age;
    bool m_isConfigured = false;
};

}  // namespace boresight::ui
