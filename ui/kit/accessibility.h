// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Tells a screen reader the role and the value of widgets that are not Qt's own. Their names and words are in
// accessibleName and accessibleDescription. Gui thread.
namespace boresight::ui {

// Once per program. Further calls do nothing.
void describeOwnWidgets();

}  // namespace boresight::ui
