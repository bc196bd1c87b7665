// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QWidget>

class QPlainTextEdit;
class QPushButton;

// The guide's step for a client: the settings for Gpredict, ready to be copied, and whether a program is connected.
namespace boresight::ui {

class ValueLabel;

class GuideClient : public QWidget
{
    Q_OBJECT

public:
    explicit GuideClient(QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);

private:
    void copy();

    QPlainTextEdit* m_settings;
    QPushButton* m_copy;
    ValueLabel* m_there;
};

}  // namespace boresight::ui
