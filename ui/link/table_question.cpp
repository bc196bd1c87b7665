// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/link/table_question.h"

#include <chrono>

namespace boresight::ui {

namespace {

constexpr std::chrono::milliseconds kPauseOfTyping{500};
constexpr std::chrono::seconds kFileAskedAgainAfter{2};

}  // namespace

TableQuestion::TableQuestion(HostDesk& host, QObject* parent) : QObject(parent), m_host(host)
{
    connect(&host, &HostDesk::tableRead, this, &TableQuestion::take);
}

void TableQuestion::ask(const QString& path)
{
    if (path != m_path) {
        drop();
        m_path = path;
        m_since = m_now;
    }
}

void TableQuestion::drop()
{
    m_path.clear();
    m_content.reset();
    m_waits = false;
}

void TableQuestion::showStatus(const StationStatus& status)
{
    m_now = status.utc;
    if (isOpen() && !m_waits && isPast(m_content ? kFileAskedAgainAfter : kPauseOfTyping)) {
        send();
    }
}

// The clock may have been set.
bool TableQuestion::isPast(std::chrono::milliseconds time) const
{
    return std::chrono::abs(m_now - m_since) >= time;
}

void TableQuestion::send()
{
    m_waits = true;
    m_since = m_now;
    Q_EMIT m_host.tableWanted(m_path, m_content);
}

void TableQuestion::take(const SharedTableContent& content)
{
    if (content->path != m_path) {
        return;
    }
    m_waits = false;
    if (content != m_content) {
        m_content = content;
        Q_EMIT answered();
    }
}

std::optional<targets::Target> TableQuestion::table() const
{
    return m_content && m_content->table ? std::optional(*m_content->table) : std::nullopt;
}

QString TableQuestion::whyNot() const
{
    if (!isOpen() || isBlocked()) {
        return {};
    }
    if (!m_content) {
        return tr("Boresight is reading the file. Wait a moment.");
    }
    return m_content->table ? QString() : m_content->table.error().text;
}

QString TableQuestion::doubt() const
{
    return isBlocked() ? tr("%1 was not read within %2 s. Its folder or that of an earlier file may not answer. "
                            "Track tries to read the file all the same.")
                             .arg(m_path)
                             .arg(kLongestTableReading.count())
                       : QString();
}

}  // namespace boresight::ui

#include "moc_table_question.cpp"
