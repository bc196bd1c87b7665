// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include <functional>

class QWidget;

// The keys that stop the mount. Pause and F12 stop from anywhere in the program, also in a modal dialog or an open
// menu, which a QShortcut would not reach. Esc first leaves the part that has the keyboard: a field, a list or a table
// loses the focus, a question or a prompt closes, the presets hide, a drag of the mouse or the editing of the sky ends.
// If there is nothing to leave Esc stops the mount. Auto-repeat is ignored. Gui thread.
namespace boresight::ui {

class StopKeys : public QObject
{
    Q_OBJECT

public:
    explicit StopKeys(QWidget& window);

    // An action of Esc before it stops, for example to cancel a drag. The function returns whether there was something
    // to do.
    void setFirstUse(const std::function<bool()>& firstUse) { m_firstUse = firstUse; }

    bool eventFilter(QObject* watched, QEvent* event) override;

Q_SIGNALS:
    void stopPressed();

private:
    [[nodiscard]] bool leave() const;
    [[nodiscard]] bool closeQuestion() const;
    [[nodiscard]] bool isStop(QObject* watched, int key) const;

    QWidget& m_window;
    std::function<bool()> m_firstUse = [] { return false; };
};

}  // namespace boresight::ui
