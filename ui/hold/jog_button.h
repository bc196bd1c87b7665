// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPushButton>
#include <QTimer>

// A button that acts only while it is pressed. Sliding off it, disabling or hiding it and switching the window release
// it, and then a new press is needed. It takes no keyboard focus, because keys jog through the armed pad. On a page
// without a pad it can take the focus. Then pressing Space is the same as pressing the mouse button, and losing the
// focus releases it.
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
