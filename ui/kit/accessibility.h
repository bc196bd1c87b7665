// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What a screen reader is told about the widgets that are not Qt's own: what they are, and their value in words. Their
// names and words stand in accessibleName and accessibleDescription. Gui thread.
namespace boresight::ui {

// Once per program; again does nothing.
void describeOwnWidgets();

}  // namespace boresight::ui
