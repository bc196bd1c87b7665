// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"

#include <QWidget>

#include <optional>

// The error of one axis in beam widths: the middle is the target, an end is a whole beam width. Beyond it the mark
// stays at the end as an arrow. An unplanned large error has the warning colour. Gui thread.
namespace boresight::ui {

class ErrorBar : public QWidget
{
    Q_OBJECT

public:
    explicit ErrorBar(const QString& accessibleName, QWidget* parent = nullptr);

    // `share` is the angle on the sky from the beam to the target, in beam widths. Empty if there is nothing to
    // compare.
    void setError(const std::optional<double>& share, bool unplanned);

    [[nodiscard]] const std::optional<double>& error() const { return m_share; }
    [[nodiscard]] bool isUnplanned() const { return m_unplanned; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    std::optional<double> m_share;
    bool m_unplanned = false;
};

}  // namespace boresight::ui
