// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/gs232_mount/box_talk.h"
#include "core/gs232_mount/obedience_watch.h"
#include "core/gs232_mount/place_filter.h"
#include "core/mount/mount_driver.h"
#include "core/profile/in_force.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>

// A GS-232 box behind the port of the mount: whole degrees, one speed, no rates, no watchdog. The box runs to where it
// is sent by itself, so it is sent only as far ahead of a set-point as that needs to stop: what lies beyond may be
// forbidden. It is sent elsewhere only when the whole degree changes, so taking it over moves nothing. No I/O: bytes
// and time are passed in. Station thread only. Mechanical angles are those that the box counts.
namespace boresight::gs232 {

class Gs232Mount final : public MountDriver
{
public:
    // Longer than three lost answers on the slowest line.
    static constexpr std::chrono::milliseconds kSilence{1800};

    // They outlive this. `axes` are those that the box turns.
    Gs232Mount(const profile::InForce& profile, AlarmBoard& alarms, const AxisSet& axes);

    void take(std::string_view bytes, SteadyTime now) { m_talk.take(bytes, now); }
    // After the control has commanded: what is to be written now.
    [[nodiscard]] std::string send();
    // The line was opened again, and nobody knows what is behind it.
    void lineOpened();
    void lineClosed()
    {
        m_lineOpen = false;
        m_broke = true;
    }
    [[nodiscard]] const BoxTalk& talk() const { return m_talk; }

    [[nodiscard]] Capabilities capabilities() const override { return m_capabilities; }
    [[nodiscard]] const QString& name(Axis axis) const override { return m_names[index(axis)]; }
    [[nodiscard]] QString label(Axis axis) const override;
    [[nodiscard]] std::optional<QString> identity(Axis axis) const override;
    [[nodiscard]] QString lastIdentity(Axis /*axis*/) const override { return {}; }
    [[nodiscard]] AxisReport report(Axis axis) const override;
    [[nodiscard]] Result<> available() const override { return {}; }
    [[nodiscard]] const Result<>& fitness() const override { return m_fitness; }
    [[nodiscard]] MountService* service() override { return nullptr; }
    [[nodiscard]] const MountService* service() const override { return nullptr; }
    void observe(SteadyTime now) override;
    [[nodiscard]] MountFindings supervise(const MountSituation& known) override;
    void engage() override { m_state.wanted = !m_state.lost; }
    [[nodiscard]] std::optional<Angle> takeFollowing(Axis axis) override;
    void command(Axis axis, const tracking::Setpoint& setpoint) override { of(axis).setpoint = setpoint; }
    void brakeHard(bool hard) override;
    void seize() override;
    void recover() override { m_state.lost = false; }
    void rearmed() override;
    void leave(profile::OnExit how) override;
    void setSensor(Axis /*axis*/, const std::optional<Angle>& /*heading*/) override {}

private:
    struct AxisOfBox
    {
        PlaceFilter filter;
        ObedienceWatch watch;
        std::optional<PlaceFilter::Jump> jump;  // not reported yet
        tracking::Setpoint setpoint{};
        std::optional<Angle> ordered;  // whole degrees; where it was sent last, or stood when it was taken over
        bool begins = false;           // to follow, not taken yet
    };
    struct State
    {
        bool wanted = false;  // to be taken over
        bool follows = false;
        bool lost = false;    // nothing moves before recover()
        bool silent = false;  // it answered, and does not any more
        bool hard = false;    // behind STOP
    };

    [[nodiscard]] AxisOfBox& of(Axis axis) { return m_axes[index(axis)]; }
    [[nodiscard]] const AxisOfBox& of(Axis axis) const { return m_axes[index(axis)]; }
    [[nodiscard]] bool answers() const { return m_lineOpen && m_heard && m_now - *m_heard <= kSilence; }
    [[nodiscard]] bool placed() const;
    [[nodiscard]] bool moves() const;
    [[nodiscard]] Angle aimOf(Axis axis) const;
    void takePlaces(const Position& position);
    void beginSilence(MountFindings& found);
    void showNoAnswer();
    void superviseAxis(Axis axis, MountFindings& found);
    void lose(MountFindings& found, Axis axis, const AlarmCase& alarm);
    void begin();
    void stop();
    void letGo();
    void order();
    void sendOrdered();

    const profile::InForce& m_profile;
    AlarmBoard& m_alarms;
    Capabilities m_capabilities;
    std::array<QString, 2> m_names;
    Result<> m_fitness;
    BoxTalk m_talk;
    std::array<AxisOfBox, 2> m_axes;
    State m_state;
    std::optional<SteadyTime> m_heard;   // an answer
    std::optional<SteadyTime> m_opened;  // the line
    bool m_lineOpen = false;
    bool m_broke = false;  // the line, since the last tick: it may be open again
    SteadyTime m_now{};    // of the running or last tick
};

}  // namespace boresight::gs232
