// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/wind_status.h"

#include <QWidget>

// The wind and the age of its last reading, in one line below the axes. An old speed is not shown. Hidden while the
// profile reads no wind. Gui thread.
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
