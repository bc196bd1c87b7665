// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bus_name.h"
#include "core/followed_rotctld/position_poll.h"
#include "core/messages/rotator_reading.h"
#include "core/rotator_box/box_line.h"

#include <QObject>

#include <functional>
#include <memory>
#include <optional>

// Another rotator, asked by its rotctld where it points. Station thread only; nothing blocks.
namespace boresight::rotctl {

class FollowedRotctld : public QObject
{
    Q_OBJECT

public:
    using Then = std::function<void(const Result<RotatorReading>& first)>;

    // Without a position for so long it is given up.
    static constexpr std::chrono::seconds kLongestSilence{5};

    using QObject::QObject;

    // Connects to it, in place of the one before. `then` gets its first position or the reason why there is none, once
    // and from the event loop or from tick().
    void find(const BusName& rotctld, SteadyTime now, Then then);
    // The mount was asked for something else meanwhile: who waits for the first position is refused.
    void forget();
    // Nobody follows it any more.
    void close();
    void tick(SteadyTime now);

Q_SIGNALS:
    // All positions but the first.
    void read(const boresight::RotatorReading& reading);

private:
    void showLine();
    void talk(SteadyTime now);
    void take(const Result<AxisPosition>& answer, SteadyTime now);
    void connectAnew();
    void giveUp();
    void answer(const Result<RotatorReading>& first);

    std::unique_ptr<BoxLine> m_line;  // null: nobody is asked
    PositionPoll m_poll;
    Then m_then;                        // empty: nobody waits for the first position
    QString m_trouble;                  // the last one
    SteadyTime m_heard;                 // of the last position; before it, when it was asked for
    std::optional<SteadyTime> m_tried;  // to connect
};

}  // namespace boresight::rotctl
