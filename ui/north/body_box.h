// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QWidget>

class QCheckBox;

// The Sun or the Moon as a known direction: its present apparent direction, a button to track it, and one to take the
// point when it is centred.
namespace boresight::ui {

class CommandButton;
class RequestDesk;
class TouchCombo;
class ValueLabel;

class BodyBox : public QWidget
{
    Q_OBJECT

public:
    BodyBox(RequestDesk& desk, ValueLabel& notice, QWidget* parent = nullptr);

    void setBody(ephemeris::Body body);
    void showStatus(const StationStatus& status);

    [[nodiscard]] bool isFollowed() const;

private:
    void build();
    void describe();
    void followOrHold();
    [[nodiscard]] QString whyNotFollowed() const;
    [[nodiscard]] QString whereText() const;
    [[nodiscard]] QString besideText() const;

    StationStatus m_status;
    ephemeris::Body m_body = ephemeris::Body::Sun;
    ValueLabel* m_where;
    CommandButton* m_follow;
    CommandButton* m_take;
    TouchCombo* m_refraction;  // for the next tracking
    QCheckBox* m_overTheTop;   // the same; only if the elevation travel goes past the zenith
};

}  // namespace boresight::ui
