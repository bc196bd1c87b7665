// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPushButton>
#include <QTimer>

// A button that counts only while it is held: sliding off it, disabling or hiding it and switching the window all let
// go, and then a fresh press is needed. It takes no keyboard focus, because keys jog through the armed pad; where there
// is no pad it can be told to take it, and then Space held is the same as the mouse held, and losing the focus lets go.
namespace boresight::ui {

class JogButton : public QPushButton
{
    Q_OBJECT

public:
    JogButton(const QString& text, const QString& help, QWidget* parent = nullptr);

    void setKeyHeld(bool on);
    void setHelp(const QString& help);
    void setBlocked(const QString& reason);  // empty: can act
    void letGo();

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

Q_SIGNALS:
    void holdBegan();
    void holdEnded();

protected:
    bool event(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;

private:
    void hold();
    void showHelp();

    QString m_help;
    QString m_reason;
    bool m_held = false;
    QTimer m_bounce{this};  // runs after the key was released
};

}  // namespace boresight::ui
