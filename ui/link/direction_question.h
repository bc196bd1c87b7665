// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/kit/request_desk.h"

#include <QObject>

#include <memory>
#include <optional>

// Asks the station whether the mount may be sent to a direction, and keeps the newest answer about this direction. It
// never shows an answer about another direction. Gui thread.
namespace boresight::ui {

class DirectionQuestion : public QObject
{
    Q_OBJECT

public:
    explicit DirectionQuestion(RequestDesk& desk, QObject* parent = nullptr) : QObject(parent), m_desk(desk) {}

    void ask(const SkyPointing& direction);
    void drop();  // the answer is not needed any more
    // Asks again when the profile changes, and once a second, because the Sun and the mount move.
    void showStatus(const StationStatus& status);

    [[nodiscard]] bool isAbout(const SkyPointing& direction) const { return m_direction == direction; }
    // In the words of the station. Empty if the mount may go there, or there is no answer yet.
    [[nodiscard]] QString whyNot() const;
    // The nearest allowed direction. Empty if the direction itself is allowed, or there is no answer yet.
    [[nodiscard]] std::optional<SkyPointing> nearest() const { return m_verdict.nearest; }

Q_SIGNALS:
    void answered();

private:
    void send();
    void take(const Answer& answer);

    RequestDesk& m_desk;
    std::optional<SkyPointing> m_direction;
    DirectionVerdict m_verdict;
    std::uint64_t m_number = 0;  // number of the last question: answers to older ones are about other directions
    bool m_waits = false;
    std::shared_ptr<const profile::Profile> m_profile;  // the profile of the last status, to detect a change
    UtcTime m_now{};
    UtcTime m_sent{};
};

}  // namespace boresight::ui
