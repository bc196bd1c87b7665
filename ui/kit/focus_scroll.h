// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QScrollArea;
class QWidget;

namespace boresight::ui {

// Scrolls a page vertically where its room is low, and is never narrower than the page. A control that receives the
// focus from another control is scrolled into view. Nothing moves under a pressed mouse button, when the window is
// activated again, or when a blocked button gives its focus to its page.
[[nodiscard]] QScrollArea* makeFocusScroll(QWidget& page, QWidget& parent);

}  // namespace boresight::ui
