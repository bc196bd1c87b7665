// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/north/swing_page.h"

#include "ui/kit/caption.h"
#include "ui/kit/command_button.h"
#include "ui/kit/guide_fields.h"
#include "ui/kit/value_label.h"
#include "ui/north/calibration_words.h"
#include "ui/north/deviation_plot.h"
#include "ui/north/run_line.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QPlainTextEdit>
#include <QSpinBox>

#include <utility>

namespace boresight::ui {

namespace {

constexpr double kSlowest = 0.5;
constexpr double kFastest = calibration::kFastestSwing.degrees();
constexpr int kMostHeadings = 72;
constexpr int kFoundLines = 5;  // if there is room

QSpinBox* makeHeadings(QWidget* parent)
{
    auto* const box = new QSpinBox(parent);
    box->setFont(fonts::label());
    box->setRange(0, kMostHeadings);
    box->setSpecialValueText(SwingPage::tr("sweep"));
    box->setMinimumHeight(kTouchSize);
    box->setAccessibleName(SwingPage::tr("Headings to stop at"));
    box->setToolTip(SwingPage::tr("Stops in each direction. Sweep: no stops, one slow turn each way"));
    return box;
}

}  // namespace

SwingPage::SwingPage(RequestDesk& desk, QWidget* parent)
    : QWidget(parent),
      m_desk(desk),
      m_rate(makeField({.name = tr("Rate of the swing"),
                        .help = tr("The sensor averages over a second. A slow swing is more exact"),
                        .min = kSlowest,
                        .max = kFastest,
                        .decimals = 1,
                        .unit = QStringLiteral(" °/s")},
                       this)),
      m_headings(makeHeadings(this)),
      m_run(new RunLine(CalibrationRun::Swing, tr("Compass swing"), this)),
      m_plot(new DeviationPlot(this)),
      m_found(new QPlainTextEdit(this)),
      m_notice(new ValueLabel(tr("Refused"), fonts::label(), {}, this)),
      m_start(new CommandButton(tr("Start swing"), {}, desk, *m_notice, this))
{
    m_rate->setValue(request::StartSwing{}.rate.degrees());
    m_rate->setSingleStep(0.5);
    build();
    connect(m_rate, &QDoubleSpinBox::valueChanged, this, &SwingPage::plan);
    connect(m_headings, &QSpinBox::valueChanged, this, &SwingPage::plan);
    connect(m_start, &QPushButton::clicked, this, &SwingPage::startOrEnd);
}

void SwingPage::build()
{
    auto* const row = new QHBoxLayout;
    row->setSpacing(4);
    for (const auto& [text, field] : {std::pair(tr("Rate"), static_cast<QWidget*>(m_rate)),
                                      std::pair(tr("Stops"), static_cast<QWidget*>(m_headings))}) {
        row->addWidget(makeCaption(text, *field));
        row->addWidget(field);
        field->setMinimumHeight(kTouchSize);
    }
    row->addStretch(1);
    row->addWidget(m_start);
    m_found->setFont(fonts::label());
    m_found->setReadOnly(true);
    m_found->setTabChangesFocus(true);
    m_found->setAccessibleName(tr("Result of the swing"));
    m_found->setPlaceholderText(tr("No swing yet"));
    m_found->setMinimumHeight(2 * m_found->fontMetrics().lineSpacing() + 12);
    m_found->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);
    m_notice->setStretching(true);
    m_notice->setCollapsing(true);
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(6, 4, 6, 0);
    column->setSpacing(4);
    column->addLayout(row);
    column->addWidget(m_run);
    column->addWidget(m_notice);
    column->addWidget(m_plot, 3);
    column->addWidget(m_found, 2);
}

void SwingPage::showStatus(const StationStatus& status)
{
    const CalibrationStatus& calibration = calibrationOf(status);
    const bool wasRunning = std::exchange(m_running, calibration.progress.run == CalibrationRun::Swing);
    const QString reason = m_running ? QString() : status.permissions.reason(Action::Swing);
    m_run->showProgress(calibration.progress,
                        reason.isEmpty() ? calibration.swingPlan.text : tr("Not now: %1").arg(reason));
    m_rate->setEnabled(!m_running);
    m_headings->setEnabled(!m_running);
    m_start->setCommand(m_running ? tr("End swing") : tr("Start swing"),
                        m_running ? tr("End the swing without a result. The mount holds (as with STOP)")
                                  : tr("The mount moves: %1").arg(calibration.swingPlan.text));
    m_start->setBlocked(reason);
    const int lines = m_running ? 2 : kFoundLines;  // this leaves more room for the plot
    m_found->setMaximumHeight(lines * m_found->fontMetrics().lineSpacing() + 18);
    if (m_running) {
        m_plot->showDots(calibration.swingSoFar, calibration.progress.text);
        if (!wasRunning) {
            m_found->setPlainText(tr("Readings around their mean so far. Boresight fits the curve at the end."));
        }
    } else if (wasRunning || calibration.swing != m_swing) {
        m_swing = calibration.swing;
        m_plot->showSwing(m_swing);
        m_found->setPlainText(m_swing ? swingText(*m_swing) : QString());
    }
}

void SwingPage::plan()
{
    m_desk.send(request::PlanSwing{.rate = AngularRate::fromDegrees(m_rate->value()), .headings = m_headings->value()},
                this, [this](const std::optional<Error>& error) {
                    m_notice->setValue(error ? tr("Plan: %1").arg(error->text) : QString(), Tone::Warning,
                                       error ? Symbol::Warning : Symbol::None);
                });
}

void SwingPage::startOrEnd()
{
    if (m_running) {
        m_start->ask(request::EndCalibration{});
    } else {
        m_start->ask(
            request::StartSwing{.rate = AngularRate::fromDegrees(m_rate->value()), .headings = m_headings->value()});
    }
}

}  // namespace boresight::ui

#include "moc_swing_page.cpp"
