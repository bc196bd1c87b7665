// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bus_name.h"
#include "core/followed_rotctld/position_poll.h"
#include "core/messages/rotator_report.h"
#include "core/rotator_box/box_line.h"

#include <QObject>

#include <memory>
#include <optional>

// Another rotator, asked by its rotctld where it points, from the first tick until it is destroyed or given up.
// Station thread only; nothing blocks.
namespace boresight::rotctl {

class FollowedRotctld : public QObject
{
    Q_OBJECT

public:
    // Without a position for so long it is given up.
    static constexpr std::chrono::seconds kLongestSilence{5};

    FollowedRotctld(const BusName& rotctld, SteadyTime now, QObject* parent = nullptr);
    ~FollowedRotctld() override;

    [[nodiscard]] QString name() const { return m_line->name(); }
    void tick(SteadyTime now);

Q_SIGNALS:
    // From the event loop or from tick(). After an error there is no more.
    void read(const boresight::RotatorReport& report);

private:
    void showLine();
    void talk(SteadyTime now);
    void take(const Result<AxisPosition>& answer, SteadyTime now);
    void giveUp();

    std::unique_ptr<BoxLine> m_line;
    PositionPoll m_poll;
    QString m_trouble;                  // the last one
    SteadyTime m_heard;                 // of the last position; before it, the start
    std::optional<SteadyTime> m_tried;  // to connect
    bool m_found = false;
    bool m_over = false;
};

}  // namespace boresight::rotctl
