// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace boresight::ui {

// A part of the window that Esc leaves before it stops the mount, while the keyboard is in this part. Gui thread.
class Leavable
{
public:
    Leavable() = default;
    Leavable(const Leavable&) = delete;
    Leavable& operator=(const Leavable&) = delete;
    virtual ~Leavable() = default;

    virtual bool leave() = 0;  // true if there was something to leave
};

}  // namespace boresight::ui
