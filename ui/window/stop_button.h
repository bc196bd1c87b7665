// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>

// STOP: an octagon of at least 150 by 64 pixels. It acts on press, not on release, in every state, and never asks. It
// is a function of the program. The hard-wired emergency stop is another device, and the tooltip says so.
namespace boresight::ui {

class StopButton : public QAbstractButton
{
    Q_OBJECT

public:
    enum class Phase
    {
        Ready,
        Requested,  // pressed, and the status does not show it yet
        Latched
    };

    explicit StopButton(QWidget* parent = nullptr);

    void setPhase(Phase phase);
    [[nodiscard]] Phase phase() const { return m_phase; }
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    [[nodiscard]] QString phaseText() const;

    Phase m_phase = Phase::Ready;
};

}  // namespace boresight::ui
