// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/north/run_line.h"

#include "ui/kit/format.h"
#include "ui/kit/value_label.h"

#include <QProgressBar>
#include <QVBoxLayout>

namespace boresight::ui {

namespace {
constexpr int kBarHeight = 6;        // px
constexpr int kRunLineParts = 1000;  // of a run
}  // namespace

RunLine::RunLine(CalibrationRun run, const QString& name, QWidget* parent)
    : QWidget(parent), m_run(run), m_text(new ValueLabel(name, fonts::label(), {}, this)), m_bar(new QProgressBar(this))
{
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    column->addWidget(m_text);
    column->addWidget(m_bar);
    m_text->setStretching(true);
    m_text->setLines(2);
    m_bar->setFixedHeight(kBarHeight);
    m_bar->setTextVisible(false);
    m_bar->setRange(0, kRunLineParts);
    m_bar->setAccessibleName(tr("%1: part that is done").arg(name));
    QSizePolicy keeping = m_bar->sizePolicy();
    keeping.setRetainSizeWhenHidden(true);
    m_bar->setSizePolicy(keeping);
    m_bar->hide();
}

void RunLine::showProgress(const CalibrationProgress& progress, const QString& otherwise)
{
    const bool running = progress.run == m_run;
    if (progress.run != CalibrationRun::None) {
        m_isOurs = running;
    }
    m_bar->setVisible(running);
    m_bar->setValue(static_cast<int>(progress.done * kRunLineParts));
    if (running) {
        // a scan waits for people and receivers, so its end is unknown
        const bool isForeseen = progress.left > Seconds(0.0);
        m_text->setValue(isForeseen ? tr("%1, %2 left").arg(progress.text, waitText(progress.left)) : progress.text,
                         Tone::Advisory, Symbol::Advisory);
    } else if (m_isOurs && !progress.outcome.isEmpty()) {
        m_text->setValue(progress.outcome, progress.failed ? Tone::Warning : Tone::Normal,
                         progress.failed ? Symbol::Warning : Symbol::None);
    } else {
        m_text->setValue(otherwise, Tone::Secondary);
    }
}

}  // namespace boresight::ui

#include "moc_run_line.cpp"
