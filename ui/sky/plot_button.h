// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/kit/command_button.h"

#include <QToolButton>

// A button of the plot: a symbol on a card, in the colours of the theme. Its text is its name for a screen reader. The
// tooltip describes its action and names its key.
namespace boresight::ui {

class PlotButton : public QToolButton
{
    Q_OBJECT

public:
    enum class Glyph
    {
        Edit,
        Zoom,
        Save
    };

    PlotButton(Glyph glyph, const QString& text, const QString& help, QWidget* parent = nullptr);

    static constexpr int kSize = kTouchSize;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    Glyph m_glyph;
};

}  // namespace boresight::ui
