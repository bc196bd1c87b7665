// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/strip_charts.h"
#include "ui/replay/replay_tape.h"

#include <QWidget>

// The strip charts of a recording. Their right end is the moment that is shown. The charts keep half an hour, so in a
// longer recording a jump back fills them again. Gui thread.
namespace boresight::ui {

// The time of the recording, as the charts need it.
class ReplayClock final : public Clock
{
public:
    void setMoment(UtcTime utc) { m_utc = utc; }

    [[nodiscard]] SteadyTime now() const override;
    [[nodiscard]] UtcTime utc() const override { return m_utc; }
    [[nodiscard]] bool synchronised() const override { return true; }
    [[nodiscard]] std::optional<Seconds> error() const override { return std::nullopt; }
    [[nodiscard]] Seconds slept() const override { return Seconds(0.0); }

private:
    UtcTime m_utc{};
};

class ReplayCharts : public QWidget
{
    Q_OBJECT

public:
    explicit ReplayCharts(SharedTape tape, QWidget* parent = nullptr);

    void show(const StationStatus& status);
    using QWidget::show;

    [[nodiscard]] StripCharts& charts() { return *m_charts; }

private:
    void fill(std::size_t until);

    SharedTape m_tape;
    ReplayClock m_clock;
    StripCharts* m_charts;
    std::size_t m_first = 0;  // the charts have the ticks from here…
    std::size_t m_until = 0;  // …to here, but at most those of half an hour
};

}  // namespace boresight::ui
