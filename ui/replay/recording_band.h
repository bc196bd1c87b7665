// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

// The band across the top of a replay. In every theme it looks like nothing in the window of the station, so that
// nobody takes a recording for the present. Gui thread.
namespace boresight::ui {

class RecordingBand : public QWidget
{
    Q_OBJECT

public:
    // `title` is large, `detail` is at the right end.
    RecordingBand(const QString& title, const QString& detail, QWidget* parent = nullptr);

    [[nodiscard]] const QString& title() const { return m_title; }
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return {0, sizeHint().height()}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QString m_title;
    QString m_detail;
};

}  // namespace boresight::ui
