// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plan/pass_plan.h"
#include "ui/look/pass_time_axis.h"

#include <QPainterPath>
#include <QWidget>

#include <vector>

// One variant of a plan over time. Above: the azimuth of the axis between the ends of the cable. Below: the pointing
// error with its bound. Ramp and unwrap are shaded, the parts that the limits hide are hatched. Passive. Gui thread,
// UTC.
namespace boresight::ui {

class PlanChart : public QWidget
{
    Q_OBJECT

public:
    explicit PlanChart(QWidget* parent = nullptr);

    // Null: none, and `words` say why.
    void show(const plan::SharedVariant& variant, const TravelRange& azimuths, Angle bound, const QString& words);
    void setNow(UtcTime now);

    [[nodiscard]] QPainterPath azimuthLine() const;  // in pixels
    [[nodiscard]] QPainterPath errorLine() const;    // without the hidden parts
    [[nodiscard]] std::vector<plan::PlanSpan> hiddenSpans() const;
    [[nodiscard]] Angle errorTop() const;  // upper end of the scale of the error
    [[nodiscard]] double xOf(UtcTime utc) const;
    [[nodiscard]] double yOfAzimuth(Angle azimuth) const;
    [[nodiscard]] double yOfError(Angle error) const;
    [[nodiscard]] const QString& words() const { return m_words; }

    [[nodiscard]] QSize minimumSizeHint() const override { return {200, 64}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    [[nodiscard]] QRectF canvas() const;
    [[nodiscard]] QRectF azimuthLane() const;  // inside the bands of the ends of the cable
    [[nodiscard]] QRectF errorLane() const;
    [[nodiscard]] PassTimeAxis timeAxis() const;
    [[nodiscard]] QRectF boxOf(const plan::PlanSpan& span) const;
    void paintSpans(QPainter& painter) const;
    void paintCableEnds(QPainter& painter) const;
    void paintScales(QPainter& painter) const;
    void paintLines(QPainter& painter) const;
    void paintNames(QPainter& painter) const;

    plan::SharedVariant m_variant;
    TravelRange m_azimuths;
    Angle m_bound;
    QString m_words;
    UtcTime m_now{};
};

}  // namespace boresight::ui
