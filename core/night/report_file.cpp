// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/night/report_file.h"

#include "core/base/file_name.h"
#include "core/base/text.h"
#include "core/profile/small_file.h"
#include "core/schedule/report_text.h"

#include <QFile>

#include <utility>

namespace boresight {
namespace {

Result<> writeReport(const QString& path, const schedule::NightReport& report)
{
    return schedule::toText(report).and_then(
        [&](const std::string& text) { return profile::writeFile(path, QByteArray::fromStdString(text)); });
}

}  // namespace

QString reportPath(const QString& stateDir, const QString& mountName, bool simulated)
{
    return QStringLiteral("%1/%2%3.night.toml")
        .arg(stateDir, safeFileName(mountName), simulated ? QStringLiteral(".simulated") : QString());
}

ReportFile::ReportFile(const QString& path, QObject* parent) : QObject(parent), m_path(path)
{
    m_writer.setMaxThreadCount(1);
    m_writer.setExpiryTimeout(-1);
    connect(this, &ReportFile::written, this, &ReportFile::finishWriting, Qt::QueuedConnection);
    load();
}

ReportFile::~ReportFile()
{
    m_writer.waitForDone();
    if (m_again) {
        *m_outcome = writeReport(m_path, m_report);
    }
}

void ReportFile::load()
{
    if (m_path.isEmpty() || !QFile::exists(m_path)) {
        return;
    }
    auto read = profile::readFile(m_path).and_then([&](const QByteArray& bytes) {
        return schedule::parseReport({bytes.constData(), static_cast<std::size_t>(bytes.size())}, m_path);
    });
    if (read) {
        m_report = *std::move(read);
    } else {
        m_unreadable = true;
        m_problem = Text::tr("The stored night report cannot be read. The new one is kept in memory only: %1")
                        .arg(read.error().text);
    }
}

void ReportFile::keep(const schedule::NightReport& report)
{
    m_report = report;
    if (m_path.isEmpty() || m_unreadable) {
        return;
    }
    if (m_writing) {
        m_again = true;
    } else {
        startWriting();
    }
}

void ReportFile::startWriting()
{
    m_writing = true;
    m_writer.start([this, path = m_path, report = m_report, outcome = m_outcome] {
        *outcome = writeReport(path, report);
        Q_EMIT written();
    });
}

void ReportFile::finishWriting()
{
    const Result<> result = *m_outcome;
    m_writing = false;
    m_problem = result ? QString() : Text::tr("The night report could not be written: %1").arg(result.error().text);
    if (std::exchange(m_again, false)) {
        startWriting();
    }
}

}  // namespace boresight

#include "moc_report_file.cpp"
