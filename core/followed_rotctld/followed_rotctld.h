// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bus_name.h"
#include "core/followed_rotctld/position_poll.h"
#include "core/messages/rotator_report.h"
#include "core/rotator_box/box_line.h"

#include <QObject>

#include <memory>
#include <optional>

// Asks the rotctld of another rotator for its position, from the first tick until the object is destroyed or gives up.
// Station thread only; nothing blocks.
namespace boresight::rotctl {

class FollowedRotctld : public QObject
{
    Q_OBJECT

public:
    // Gives up after this time without a position.
    static constexpr std::chrono::seconds kLongestSilence{5};

    FollowedRotctld(const BusName& rotctld, SteadyTime now, QObject* parent = nullptr);
    ~FollowedRotctld() override;

    [[nodiscard]] QString name() const { return m_line->name(); }
    void tick(SteadyTime now);

Q_SIGNALS:
    // Emitted from the event loop or by tick(). An error is the last report.
    void read(const boresight::RotatorReport& report);

private:
    void showLine();
    void talk(SteadyTime now);
    void take(const Result<AxisPosition>& answer, SteadyTime now);
    void giveUp();

    std::unique_ptr<BoxLine> m_line;
    PositionPoll m_poll;
    QString m_trouble;                  // the last problem
    SteadyTime m_heard;                 // time of the last position; before the first one, time of the start
    std::optional<SteadyTime> m_tried;  // time of the last attempt to connect
    bool m_found = false;
    bool m_over = false;
};

}  // namespace boresight::rotctl
