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
                 : new LinesView(tr("Why did it move?"), QStringLiteral("boresight-moves.txt"), *m_filter, this)),
      m_source(new QComboBox(this)),
      m_text(new QLineEdit(this))
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
    m_source->setAccessibleName(tr("Filter by source"));
    m_source->addItem(tr("All sources"), QVariant::fromValue(int(LogSource::All)));
    m_source->addItem(tr("Operator"), QVariant::fromValue(int(LogSource::Operator)));
    m_source->addItem(tr("rotctld clients"), QVariant::fromValue(int(LogSource::Clients)));
    m_source->addItem(tr("Station"), QVariant::fromValue(int(LogSource::Station)));
    connect(m_source, &QComboBox::currentIndexChanged, this,
            [this] { m_filter->setSource(static_cast<LogSource>(m_source->currentData().toInt())); });
    m_view->addControl(*m_source);
}

void LogPage::addSeverity()
{
    m_warnings = new QCheckBox(tr("▲ only"), this);
    m_warnings->setAccessibleName(tr("Warnings and alarms only"));
    m_warnings->setToolTip(tr("Warnings and alarms only"));
    connect(m_warnings, &QCheckBox::toggled, m_filter, &LogFilter::setWarningsOnly);
    m_view->addControl(*m_warnings);
}

void LogPage::addText()
{
    m_text->setAccessibleName(tr("Filter by text"));
    m_text->setPlaceholderText(tr("contains"));
    m_text->setClearButtonEnabled(true);
    connect(m_text, &QLineEdit::textChanged, m_filter, &LogFilter::setText);
    m_view->addControl(*m_text, 1);
}

void LogPage::reveal(int row)
{
    const auto place = [this, row] { return m_filter->mapFromSource(m_filter->sourceModel()->index(row, 0)); };
    if (!place().isValid()) {
        m_source->setCurrentIndex(0);
        m_text->clear();
        if (m_warnings != nullptr) {
            m_warnings->setChecked(false);
        }
    }
    m_view->select(place().row());
}

}  // namespace boresight::ui

#include "moc_log_page.cpp"
