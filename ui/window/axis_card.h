// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/kit/steady_number.h"

#include <QWidget>

#include <optional>

class QGridLayout;

// One axis: actual and target as true directions, error (target minus actual, along the real way of the axis), rate and
// a state word. Below it the error as a bar, and further values: the trim, the axis angle if it is not the true
// direction (named X or Y on an X/Y mount), a detail. An old number is dimmed with its age, a very old one is not
// shown. While the wrap is unknown there is no number. Gui thread. More than 15 members: the widgets that it composes.
namespace boresight::ui {

class ErrorBar;
class ValueLabel;

// The size of the number of the actual angle, by the available room in the window.
enum class Numerals
{
    Bare,    // 20 pt, the word beside the name, without bar and detail: a long alarm in a low window
    Beside,  // 22 pt, without a line for the rate: both cards in one row, while an alarm needs room
    Small,   // 28 pt, without a line for the rate: a window of 1024×700 has no room for more
    Row,     // 44 pt, without error and rate: both cards in one row, while an alarm needs room in a usual window
    Usual,   // 44 pt
    Large    // 60 pt
};

// Whether both cards are side by side.
[[nodiscard]] constexpr bool areBeside(Numerals numerals)
{
    return numerals == Numerals::Bare || numerals == Numerals::Beside || numerals == Numerals::Row;
}

class AxisCard : public QWidget
{
    Q_OBJECT

public:
    explicit AxisCard(Axis axis, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);
    void setNumerals(Numerals numerals);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void build(Numerals numerals);
    void buildBeside(QGridLayout& grid, Numerals numerals);
    void buildRow(QGridLayout& grid);
    void chooseShown();
    void showNumbers(bool turnKnown);
    void showError(const StationStatus& status, bool known);
    [[nodiscard]] QString detail();
    [[nodiscard]] Angle trim() const;

    const Axis m_axis;
    QWidget* m_name;
    ValueLabel* m_actual;
    ValueLabel* m_target;
    ValueLabel* m_error;
    ValueLabel* m_rate;
    ValueLabel* m_state;
    QWidget* m_targetCaption;
    QWidget* m_errorCaption;
    QWidget* m_rateCaption;
    ErrorBar* m_bar;
    ValueLabel* m_detail;
    std::optional<Numerals> m_numerals;
    AxisStatus m_shown;
    QString m_registers;  // the values reported by the drive
    std::optional<SkyPointing> m_trim;
    bool m_hasModel = false;  // the axis angle is not the true direction
    bool m_isXY = false;      // the axis is X or Y: error and rate are its own, the numbers are of the beam
    // A measured value varies a little even while the axis stands still.
    SteadyNumber m_steadyActual;
    SteadyNumber m_steadyAxis{2};
    SteadyNumber m_steadyError{2};
    SteadyNumber m_steadyRate{1};  // the second decimal of a drive's velocity is noise
};

}  // namespace boresight::ui
