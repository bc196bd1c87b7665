// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/jog/gamepad_pilot.h"

#include <QObject>

#include <memory>

// A gamepad, if the program is built with SDL: the first one that is plugged in. It is read every 20 ms. Without a
// gamepad the program searches once a second. Gui thread, never blocks.
namespace boresight::ui {

class Gamepad : public QObject
{
    Q_OBJECT

public:
    // Null: this program is built without SDL.
    [[nodiscard]] static std::unique_ptr<Gamepad> create();

Q_SIGNALS:
    void plugged(const QString& name);  // empty: it was unplugged
    void sampled(const boresight::ui::GamepadSample& sample);

protected:
    Gamepad() = default;
};

}  // namespace boresight::ui
