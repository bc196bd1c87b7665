// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/mount/mount_driver.h"
#include "core/profile/in_force.h"
#include "core/rotator_box/axis_of_box.h"
#include "core/rotator_box/box_console.h"
#include "core/rotator_box/home_run.h"
#include "core/rotator_box/rotator_talk.h"
#include "core/rotator_box/switched_motors.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>

// The driver of a rotator that moves to its target by itself: steps, no rates, no watchdog. It is sent only where the
// leeway of the control permits, because the range beyond may be forbidden. A target is sent only when it changes
// (SwitchedMotors), so taking the rotator over moves nothing. RotatorTalk has the protocol of each kind. No I/O: bytes
// and time are passed in. Station thread only. Mechanical angles are those that the rotator counts.
namespace boresight {

class BoxMount : public MountDriver
{
public:
    void take(std::string_view bytes, SteadyTime now) { talk().take(bytes, now); }
    // After each typed line the rotator is stopped, and must be seen standing still before it is taken over.
    [[nodiscard]] BoxConsole& console() { return m_console; }
    // Call it after the control has commanded. Returns the bytes to send.
    [[nodiscard]] std::string send();
    // The line was opened again, perhaps to another device.
    void lineOpened();
    void lineClosed()
    {
        m_lineOpen = false;
        m_broke = true;
        m_console.drop();
        m_home.end();
    }
    // The rotator drives to its own switches. Boresight lets it go, watches it, and takes it over when it stands.
    void home();
    [[nodiscard]] virtual RotatorTalk& talk() = 0;
    [[nodiscard]] virtual const RotatorTalk& talk() const = 0;
    // The kind as a short word for the screen.
    [[nodiscard]] virtual QString kind() const = 0;
    // The kind with its article, for the alarm about a foreign device: "a GS-232 rotator".
    [[nodiscard]] virtual QString kindInWords() const = 0;

    // What the box reports of itself, in words. Empty: nothing.
    [[nodiscard]] virtual QString condition() const { return {}; }
    // The offsets of its sensor, as the profile saves them. Empty: not known.
    [[nodiscard]] virtual std::string sensorOffsets() const { return {}; }

    [[nodiscard]] Capabilities capabilities() const override { return m_capabilities; }
    [[nodiscard]] const QString& name(Axis axis) const override;
    [[nodiscard]] QString label(Axis axis) const override;
    [[nodiscard]] std::optional<QString> identity(Axis axis) const override;
    [[nodiscard]] QString lastIdentity(Axis /*axis*/) const override { return {}; }
    [[nodiscard]] AxisReport report(Axis axis) const override;
    // Empty: the rotator does not turn this axis.
    [[nodiscard]] std::optional<MotorStarts> starts(Axis axis) const;
    [[nodiscard]] Result<> available() const override { return {}; }
    [[nodiscard]] Result<> mayType() const override { return m_console.admits(talk(), answers()); }
    [[nodiscard]] Result<> mayMakeHomeRun() const override { return m_home.admits(talk(), answers() && placed()); }
    [[nodiscard]] MountService* service() override { return nullptr; }
    [[nodiscard]] const MountService* service() const override { return nullptr; }
    void observe(SteadyTime now) override;
    [[nodiscard]] MountFindings supervise(const MountSituation& known) override;
    void engage() override { m_state.wanted = !m_state.lost; }
    [[nodiscard]] std::optional<Angle> takeFollowing(Axis axis) override;
    void command(Axis axis, const tracking::Setpoint& setpoint) override { of(axis).setpoint = setpoint; }
    void setLeeway(Axis axis, const tracking::Leeway& leeway) override { m_motors.setLeeway(axis, leeway); }
    void retake() override;
    void brakeHard(bool hard) override;
    void seize() override;
    void recover() override { m_state.lost = false; }
    void rearmed() override;
    void leave(profile::OnExit how) override;
    void setSensor(Axis /*axis*/, const std::optional<Angle>& /*heading*/) override {}

protected:
    // The references outlive this. `axes`: the axes that the rotator turns. `each`: the capabilities of both axes, also
    // of one that the rotator does not turn.
    // `count`: the resolution of its positions. Smaller changes are noise of its sensor.
    BoxMount(const profile::InForce& profile, AlarmBoard& alarms, const AxisSet& axes,
             const std::array<AxisCapabilities, 2>& each, Angle count);

    // Sets the target of both axes, in steps. An axis that this mount does not turn is sent to where it is. False if
    // the rotator cannot be sent there.
    virtual bool goTo(const RotatorTalk::Places& target) = 0;
    // The advice while nothing answers.
    [[nodiscard]] virtual QString remedyOfNoAnswer() const = 0;

    // For the constructor of a rotator whose protocol has a command for it.
    void offerHomeRuns() { m_capabilities.makesHomeRuns = true; }
    [[nodiscard]] const profile::InForce& profile() const { return m_profile; }
    // The believed position, also of an axis that this mount does not turn.
    [[nodiscard]] const std::optional<Angle>& believed(Axis axis) const { return of(axis).filter.place(); }
    // The rotator does not reach its targets, so the motion of all axes ends.
    void loseAll(MountFindings& found, const AlarmCase& alarm);

private:
    [[nodiscard]] AxisOfBox& of(Axis axis) { return m_axes[index(axis)]; }
    [[nodiscard]] const AxisOfBox& of(Axis axis) const { return m_axes[index(axis)]; }
    [[nodiscard]] bool rareStarts() const { return m_each[0].rareStarts; }  // the same for both axes
    [[nodiscard]] Seconds silence() const { return m_each[0].silence; }
    [[nodiscard]] bool answers() const;
    [[nodiscard]] AxisSet turned() const;  // the axes that it has
    [[nodiscard]] bool placed() const;
    [[nodiscard]] bool moves() const;
    void takePlaces(const RotatorTalk::Places& places);
    void beginSilence(MountFindings& found);
    void showNoAnswer();
    void superviseAxis(Axis axis, MountFindings& found);
    void lose(MountFindings& found, Axis axis, const AlarmCase& alarm);
    void lose(MountFindings& found, AxisSet axes, const AlarmKey& key, const AlarmCase& alarm);
    void begin();
    void stop();
    void letGo();
    [[nodiscard]] std::optional<Angle> targetOf(Axis axis) const;
    void order();
    void orderEachStep();
    void sendOrdered();
    void sendAgain(Axis axis);
    void sendTo(const SwitchedMotors::Targets& targets);
    void forgetPlaces();

    const profile::InForce& m_profile;
    AlarmBoard& m_alarms;
    Capabilities m_capabilities;
    std::array<AxisCapabilities, 2> m_each;
    Angle m_count;
    std::array<AxisOfBox, 2> m_axes;
    SwitchedMotors m_motors;  // with rare starts
    BoxConsole m_console;
    HomeRun m_home;
    StateOfBox m_state;
    std::optional<SteadyTime> m_heard;   // when the last answer came
    std::optional<SteadyTime> m_opened;  // when the line was opened or a position was last known
    bool m_lineOpen = false;
    bool m_broke = false;  // since the last tick the line was lost, perhaps only for a moment, or nobody read it
    SteadyTime m_now{};    // of the current or last tick
};

}  // namespace boresight
