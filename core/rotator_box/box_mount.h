// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/mount/mount_driver.h"
#include "core/profile/in_force.h"
#include "core/rotator_box/obedience_watch.h"
#include "core/rotator_box/place_filter.h"
#include "core/rotator_box/rotator_talk.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>

// A rotator behind the port of the mount that runs to where it is sent by itself: steps, no rates, no watchdog. It is
// sent only as far ahead of a set-point as that needs to stop: what lies beyond may be forbidden. It is sent elsewhere
// only when the step changes, so taking it over moves nothing. What it says and what is said to it is the matter of
// each kind. No I/O: bytes and time are passed in. Station thread only. Mechanical angles are those that the rotator
// counts.
namespace boresight {

class BoxMount : public MountDriver
{
public:
    void take(std::string_view bytes, SteadyTime now) { talk().take(bytes, now); }
    // After the control has commanded: what is to be written now.
    [[nodiscard]] std::string send();
    // The line was opened again, and nobody knows what is behind it.
    void lineOpened();
    void lineClosed()
    {
        m_lineOpen = false;
        m_broke = true;
    }
    [[nodiscard]] virtual RotatorTalk& talk() = 0;
    [[nodiscard]] virtual const RotatorTalk& talk() const = 0;
    // In a short word, for the screen.
    [[nodiscard]] virtual QString kind() const = 0;
    // What a device that is none of these is not, in a sentence.
    [[nodiscard]] virtual QString kindInWords() const = 0;

    [[nodiscard]] Capabilities capabilities() const override { return m_capabilities; }
    [[nodiscard]] const QString& name(Axis axis) const override { return m_names[index(axis)]; }
    [[nodiscard]] QString label(Axis axis) const override;
    [[nodiscard]] std::optional<QString> identity(Axis axis) const override;
    [[nodiscard]] QString lastIdentity(Axis /*axis*/) const override { return {}; }
    [[nodiscard]] AxisReport report(Axis axis) const override;
    [[nodiscard]] Result<> available() const override { return {}; }
    [[nodiscard]] MountService* service() override { return nullptr; }
    [[nodiscard]] const MountService* service() const override { return nullptr; }
    void observe(SteadyTime now) override;
    [[nodiscard]] MountFindings supervise(const MountSituation& known) override;
    void engage() override { m_state.wanted = !m_state.lost; }
    [[nodiscard]] std::optional<Angle> takeFollowing(Axis axis) override;
    void command(Axis axis, const tracking::Setpoint& setpoint) override { of(axis).setpoint = setpoint; }
    void retake() override;
    void brakeHard(bool hard) override;
    void seize() override;
    void recover() override { m_state.lost = false; }
    void rearmed() override;
    void leave(profile::OnExit how) override;
    void setSensor(Axis /*axis*/, const std::optional<Angle>& /*heading*/) override {}

protected:
    // They outlive this. `axes` are those that the rotator turns, each of them can do `each`.
    BoxMount(const profile::InForce& profile, AlarmBoard& alarms, const AxisSet& axes, const AxisCapabilities& each);

    // The target of both axes, in steps. An axis that this mount does not turn is sent to where it stands. False: it
    // cannot be sent there.
    virtual bool goTo(const RotatorTalk::Places& target) = 0;
    // What to do while nothing answers.
    [[nodiscard]] virtual QString remedyOfNoAnswer() const = 0;
    // How finely the places are compared to see whether an axis moves: finer is the noise of its sensor.
    [[nodiscard]] virtual Angle grain() const { return Angle{}; }

    [[nodiscard]] const profile::InForce& profile() const { return m_profile; }
    // Where the rotator says that it stands, if that is credible. Also of an axis that this mount does not turn.
    [[nodiscard]] const std::optional<Angle>& believed(Axis axis) const { return of(axis).filter.place(); }
    // The rotator does not go where it is sent: the motion of all axes ends.
    void loseAll(MountFindings& found, const AlarmCase& alarm);

private:
    struct AxisOfBox
    {
        PlaceFilter filter;
        ObedienceWatch watch;
        std::optional<PlaceFilter::Jump> jump;  // not reported yet
        tracking::Setpoint setpoint{};
        std::optional<Angle> ordered;  // in steps; where it was sent last, or stood when it was taken over
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
    [[nodiscard]] bool answers() const;
    [[nodiscard]] bool placed() const;
    [[nodiscard]] bool moves() const;
    [[nodiscard]] Angle aimOf(Axis axis) const;
    void takePlaces(const RotatorTalk::Places& places);
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
    AxisCapabilities m_each;
    std::array<QString, 2> m_names;
    std::array<AxisOfBox, 2> m_axes;
    State m_state;
    std::optional<SteadyTime> m_heard;   // an answer
    std::optional<SteadyTime> m_opened;  // the line, or since then it stands somewhere
    bool m_lineOpen = false;
    bool m_broke = false;  // the line, since the last tick: it may be open again
    SteadyTime m_now{};    // of the running or last tick
};

// The multiples of `step` inside the travel; min > max if there is none.
[[nodiscard]] TravelRange stepsIn(const TravelRange& travel, Angle step);
// "azimuth", "elevation": the table of an axis in the profile.
[[nodiscard]] QString tableOf(Axis axis);
// The rotator counts by itself, and its count is the angle of the axis: a sign or an offset of the profile would have
// no effect.
[[nodiscard]] Result<> countsAsTheRotator(const profile::Profile& profile, Axis axis);

}  // namespace boresight
