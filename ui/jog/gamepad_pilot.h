// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The report of a gamepad and its meaning for the mount. Pure: SdlGamepad reads the device, and the jog pad sends the
// requests. The stick counts only while its dead-man switch, a shoulder button, is pressed. If it was already pressed
// when the gamepad was plugged in, or while motion was blocked, it must be released first.
namespace boresight::ui {

struct GamepadSample
{
    double right = 0.0;  // of the stick, -1 … 1
    double up = 0.0;
    bool deadMan = false;
    bool stop = false;
};

// The part of the jog rate for each axis, -1 … 1.
struct Steering
{
    double azimuth = 0.0;
    double elevation = 0.0;

    bool operator==(const Steering&) const = default;
};

class GamepadPilot
{
public:
    // Called with every sample. `permitted`: the gamepad may move the mount now.
    [[nodiscard]] Steering take(const GamepadSample& sample, bool permitted);
    void letGo() { m_held = false; }  // something else ended the motion, so a new press is needed
    void gone();                      // unplugged

    [[nodiscard]] bool isHeld() const { return m_held; }
    [[nodiscard]] bool takeStop();  // STOP was pressed since the last call

private:
    bool m_held = false;
    bool m_wasDeadMan = true;
    bool m_wasStop = true;
    bool m_stopPressed = false;
};

}  // namespace boresight::ui
