// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include <optional>

// A thin line below the header that shows how much of the slew is done. Without a slew it is a hairline.
namespace boresight::ui {

class ProgressLine : public QWidget
{
    Q_OBJECT

public:
    explicit ProgressLine(QWidget* parent = nullptr);

    void setDone(const std::optional<double>& done);  // 0 to 1; empty: no slew
    [[nodiscard]] std::optional<double> done() const { return m_done; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    std::optional<double> m_done;
};

}  // namespace boresight::ui
