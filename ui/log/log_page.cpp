// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/log/log_page.h"

#include "ui/kit/lines_view.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QVBoxLayout>

namespace boresight::ui {

LogPage::LogPage(LogModel& model, Lines lines, QWidget* parent)
    : QWidget(parent),
      m_filter(new LogFilter(this)),
      m_view(lines == Lines::All
                 ? new LinesView(tr("Events"), QStringLiteral("boresight-events.txt"), *m_filter, this)
                 : new LinesView(tr("Why did it move?"), QStringLiteral("boresight-moves.txt"), *m_filter, this))
{
    m_filter->setSourceModel(&model);
    m_view->setFollowing();
    m_view->setColumnRoom(LogModel::Time, QStringLiteral("00:00:00"));
    m_view->setColumnRoom(LogModel::From, sourceText(QStringLiteral("elevation drive")));
    addSources();
    if (lines == Lines::All) {
        addSeverity();
    } else {
        m_filter->setKind(LogKind::MotionStart);
    }
    addText();
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_view);
}

void LogPage::addSources()
{
    auto* const source = new QComboBox(this);
    source->setAccessibleName(tr("Filter by source"));
    source->addItem(tr("All sources"), QVariant::fromValue(int(LogSource::All)));
    source->addItem(tr("Operator"), QVariant::fromValue(int(LogSource::Operator)));
    source->addItem(tr("rotctld clients"), QVariant::fromValue(int(LogSource::Clients)));
    source->addItem(tr("Station"), QVariant::fromValue(int(LogSource::Station)));
    connect(source, &QComboBox::currentIndexChanged, this,
            [this, source] { m_filter->setSource(static_cast<LogSource>(source->currentData().toInt())); });
    m_view->addControl(*source);
}

void LogPage::addSeverity()
{
    auto* const warnings = new QCheckBox(tr("▲ only"), this);
    warnings->setAccessibleName(tr("Warnings and alarms only"));
    warnings->setToolTip(tr("Warnings and alarms only"));
    connect(warnings, &QCheckBox::toggled, m_filter, &LogFilter::setWarningsOnly);
    m_view->addControl(*warnings);
}

void LogPage::addText()
{
    auto* const text = new QLineEdit(this);
    text->setAccessibleName(tr("Filter by text"));
    text->setPlaceholderText(tr("contains"));
    text->setClearButtonEnabled(true);
    connect(text, &QLineEdit::textChanged, m_filter, &LogFilter::setText);
    m_view->addControl(*text, 1);
}

}  // namespace boresight::ui

#include "moc_log_page.cpp"
