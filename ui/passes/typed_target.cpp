// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/passes/typed_target.h"

#include "core/targets/target_text.h"
#include "core/targets/track_rules.h"

#include <QFileInfo>

#include <chrono>

namespace boresight::ui {

TypedTarget::TypedTarget(RequestDesk& desk, HostDesk& host, QObject* parent)
    : QObject(parent), m_question(desk), m_table(host)
{
    connect(&m_question, &DirectionQuestion::answered, this, &TypedTarget::judged);
    connect(&m_table, &TableQuestion::answered, this, &TypedTarget::takeTable);
}

void TypedTarget::setText(const QString& text)
{
    m_text = text.trimmed();
    read();
    Q_EMIT judged();
}

void TypedTarget::showStatus(const StationStatus& status)
{
    const bool hasOtherSatellites = status.satellites != m_satellites;
    const bool isElsewhere = !m_profile || m_profile->site != status.profile->site;
    const bool isNextSecond = std::chrono::abs(status.utc - m_now) >= std::chrono::seconds(1);
    m_profile = status.profile;
    m_satellites = status.satellites;
    m_permissions = status.permissions;
    m_now = isNextSecond ? status.utc : m_now;
    if (hasOtherSatellites) {
        read();
    } else if (isElsewhere) {
        place();
    } else if (isNextSecond) {
        look();
    }
    m_question.showStatus(status);
    m_table.showStatus(status);
}

void TypedTarget::read()
{
    m_problem.clear();
    m_request.reset();
    m_target.reset();
    const std::string text = m_text.toStdString();
    const auto file = targets::tableFile(text);
    if (!file) {
        m_table.drop();
    }
    if (m_text.isEmpty() || !m_satellites) {
        m_problem = tr("Type a target first.");
    } else if (file) {
        const QString path = QFileInfo(*file).absoluteFilePath();
        m_request = request::TrackFile{path};
        m_table.ask(path);
        m_target = m_table.table();
    } else if (const auto other = targets::otherRotator(text)) {
        m_request = request::FollowRotator{*other};
    } else if (const auto target = targets::parseTarget(text, *m_satellites)) {
        m_request = request::Track{*target};
        m_target = *target;
    } else {
        m_problem = target.error().text;
    }
    place();
}

void TypedTarget::takeTable()
{
    m_target = m_table.table();
    place();
    Q_EMIT judged();
}

void TypedTarget::place()
{
    m_place.reset();
    m_question.drop();
    if (m_target && (m_profile->site.known || !targets::needsSite(*m_target))) {
        m_place.emplace(*m_target, m_profile->site.place(), m_profile->orbit.refraction);
        look();
    }
}

void TypedTarget::look()
{
    if (!m_place) {
        return;
    }
    m_place->setRule(m_profile->orbit.refraction);
    m_place->look(m_now);
    if (targets::stays(*m_target) && m_place->direction() && !m_question.isAbout(*m_place->direction())) {
        m_question.ask(*m_place->direction());
    }
}

QString TypedTarget::whyNot() const
{
    if (!m_request) {
        return m_problem;
    }
    const Action action = m_target && targets::isSun(*m_target) ? Action::TrackSun : Action::Track;
    return m_permissions.allows(action) ? whyNotTarget() : m_permissions.reason(action);
}

Sentence TypedTarget::aboutTable() const
{
    if (m_table.isBlocked()) {
        return {m_table.doubt(), Tone::Warning, Symbol::Warning};
    }
    const QString why = m_table.isOpen() ? whyNotTarget() : QString();
    return m_table.isReading() ? Sentence{why} : Sentence{why, Tone::Warning, Symbol::Warning};
}

QString TypedTarget::whyNotTarget() const
{
    if (const QString why = m_table.whyNot(); !why.isEmpty() || !m_target || m_table.isBlocked()) {
        return why;
    }
    const Result<> may = targets::hasSite(*m_target, m_profile->site.known)
                             .and_then([&] { return targets::isFresh(*m_target, m_now, m_profile->orbit.oldestDays); })
                             .and_then([&] { return m_place->isSoon(m_now); });
    return may ? m_question.whyNot() : may.error().text;
}

}  // namespace boresight::ui

#include "moc_typed_target.cpp"
