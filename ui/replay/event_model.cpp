// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/replay/event_model.h"

#include "core/messages/station_status.h"
#include "ui/kit/format.h"
#include "ui/kit/symbol.h"
#include "ui/kit/theme.h"

namespace boresight::ui {

namespace {

Severity severityOf(recording::EventLevel level)
{
    switch (level) {
        case recording::EventLevel::Alarm:
            return Severity::Alarm;
        case recording::EventLevel::Warning:
            return Severity::Warning;
        default:
            return Severity::Advisory;
    }
}

QString kindWord(recording::EventKind kind)
{
    switch (kind) {
        case recording::EventKind::MotionStart:
            return QStringLiteral("▶ ") + RecordedEventModel::tr("motion");
        case recording::EventKind::Alarm:
            return RecordedEventModel::tr("alarm");
        case recording::EventKind::ClientLine:
            return RecordedEventModel::tr("client");
        default:
            return RecordedEventModel::tr("event");
    }
}

}  // namespace

RecordedEventModel::RecordedEventModel(SharedTape tape, QObject* parent)
    : TableModel({tr("UTC"), tr("Kind"), tr("Source"), tr("What")}, parent), m_tape(std::move(tape))
{}

QString RecordedEventModel::sentence(const recording::Event& event)
{
    return clockText(event.utc) + QStringLiteral("Z  ") + sourceText(event.source) + QStringLiteral(": ") + event.text;
}

QVariant RecordedEventModel::data(const QModelIndex& index, int role) const
{
    const recording::Event& event = m_tape->events()[static_cast<std::size_t>(index.row())];
    const Severity severity = severityOf(event.level);
    const bool isMotion = event.kind == recording::EventKind::MotionStart;
    if (role == Qt::ToolTipRole) {
        return sentence(event);
    }
    if (role == Qt::ForegroundRole && (isMotion || severity != Severity::Advisory)) {
        return currentTheme().colour(severity != Severity::Advisory ? toneOf(severity) : Tone::Accent);
    }
    if (role == Qt::FontRole && isMotion) {
        QFont bold = fonts::label();
        bold.setBold(true);
        return bold;
    }
    if (role != Qt::DisplayRole) {
        return {};
    }
    switch (index.column()) {
        case Time:
            return clockText(event.utc);
        case Kind:
            return kindWord(event.kind);
        case From:
            return sourceText(event.source);
        default:
            return characterOf(severity) + event.text;
    }
}

}  // namespace boresight::ui

#include "moc_event_model.cpp"
