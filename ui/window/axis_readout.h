// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/window/axis_card.h"

#include <QWidget>

#include <map>

class QBoxLayout;

// A card for each axis. Gui thread.
namespace boresight::ui {

// The largest numbers that fit into a window of this size.
[[nodiscard]] Numerals numeralsFor(QSize window);
// True for a window lower or narrower than 1280×760, which has no room for additional lines.
[[nodiscard]] bool isLow(QSize window);

class AxisReadout : public QWidget
{
    Q_OBJECT

public:
    explicit AxisReadout(QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);
    void setNumerals(Numerals numerals);
    [[nodiscard]] QSize sizeWith(Numerals numerals);  // px that this form needs

private:
    QBoxLayout* m_cards;
    AxisCard* m_azimuth;
    AxisCard* m_elevation;
    Numerals m_numerals = Numerals::Small;
    std::map<Numerals, QSize> m_sizes;
};

}  // namespace boresight::ui
