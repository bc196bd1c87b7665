// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/moteus_mount/drive_care.h"
#include "core/sim/simulated_pair.h"
#include "tests/core/control/station_rig.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fakes/text_of.h"

#include <algorithm>
#include <deque>
#include <string>
#include <vector>

// The drive check and the control of motion together, on drives with their own consoles.
namespace boresight {

inline constexpr Seconds kDriveCareTick{0.02};

struct CareRig
{
    explicit CareRig(const sim::PairSettings& settings = sim::commissionedPair()) : pair(settings) {}

    void tick()
    {
        control.tick();
        const auto motion = mount.frames();
        std::vector<CanFrame> frames(motion.begin(), motion.end());
        std::ranges::copy(care.tick(clock.now()), std::back_inserter(frames));
        sent = 0;
        if (linkOpen) {
            sent = frames.size();
            for (const CanFrame& frame : frames) {
                std::ranges::copy(pair.exchange(frame, elapsed), std::back_inserter(underWay));
            }
        }
        mount.framesSent();
        checked = checked || frames.size() > motion.size();
        clock.advance(kDriveCareTick);
        elapsed += kDriveCareTick;
        pair.advanceTo(elapsed);
        deliver();
    }

    void run(Seconds time)
    {
        for (const Seconds end = elapsed + time; elapsed < end;) {
            tick();
        }
    }

    bool reaches(DriveCheckState state, Seconds within = Seconds(12.0))
    {
        for (const Seconds end = elapsed + within; elapsed < end && drives().driveCheck != state;) {
            tick();
        }
        return drives().driveCheck == state;
    }

    // Runs until the check is done and the station has received its result.
    [[nodiscard]] bool endsItsDriveCheck()
    {
        const bool ended = reaches(DriveCheckState::Done);
        run(Seconds(0.2));
        return ended;
    }

    [[nodiscard]] DrivesStatus drives() const
    {
        DrivesStatus status = *control.status().drives;
        care.fill(status);
        return status;
    }

    [[nodiscard]] std::string obstacle(Action action) const
    {
        Permissions may = control.status().permissions;
        care.judge(may);
        return may.reason(action).toStdString();
    }

    // The refusal of the drive check, before the control is asked.
    [[nodiscard]] std::string refusal(const Request& request) const
    {
        const Result<> may = care.admits(request);
        return may ? std::string() : textOf(may.error());
    }

    // Handles a request as the station does. Empty when accepted, else the reason.
    std::string ask(const Request& request)
    {
        const Result<> answer =
            control.request(request, kOperator).and_then([&] { return care.carryOut(request, clock.now()); });
        return answer ? std::string() : textOf(answer.error());
    }

    // Applies a profile as the station does.
    void setProfile(const profile::Profile& wanted)
    {
        const auto before = inForce.shared();
        inForce.apply(wanted);
        control.profileChanged(*before, *inForce);
        care.profileChanged(*before, *inForce);
    }

    void otherToolSays(Axis axis, const std::string& command)
    {
        const std::string text = command + '\n';
        pair.drive(axis).receiveText(1, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    }

    [[nodiscard]] bool alarm(const char* words) const
    {
        return std::ranges::any_of(control.status().alarms, [&](const Alarm& one) {
            return one.active && one.what.contains(QString::fromUtf8(words));
        });
    }

    [[nodiscard]] bool logSays(const char* words) const
    {
        return std::ranges::any_of(log.since(0, EventLog::kCapacity),
                                   [&](const LogEntry& line) { return line.text.contains(QString::fromUtf8(words)); });
    }

    fakes::ManualClock clock;
    EventLog log{clock};
    profile::Profile profile;
    profile::InForce inForce{profile};
    AlarmBoard alarms{log, clock};
    MoteusMount mount{inForce, clock, log, alarms, {.trustFirstContact = true}};
    StationControl control{inForce, clock, log, alarms, mount, motionSources};
    DriveCare care{inForce, mount, alarms, log};
    sim::SimulatedPair pair;
    Seconds elapsed{0.0};
    bool linkOpen = true;
    std::size_t sent = 0;  // frames in the last tick
    bool checked = false;  // DriveCare has sent something

private:
    void deliver()
    {
        std::deque<sim::PairReply> later;
        for (const sim::PairReply& reply : underWay) {
            if (reply.due > elapsed) {
                later.push_back(reply);
                continue;
            }
            CanFrame frame = reply.frame;
            frame.received = clock.now();
            mount.take(frame);
            care.take(frame);
        }
        underWay = std::move(later);
    }

    std::deque<sim::PairReply> underWay;
};

inline const Request kGo = request::PointAxes{{.azimuth = 30_deg, .elevation = 30_deg}};

}  // namespace boresight
