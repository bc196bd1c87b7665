// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/night/report_file.h"

#include "core/base/file_name.h"
#include "core/base/text.h"
#include "core/profile/small_file.h"
#include "core/schedule/report_text.h"

#include <QFile>

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

ReportFile::ReportFile(const QString& path, QObject* parent)
    : QObject(parent), m_path(path), m_pass(path.isEmpty() ? QString() : path + QStringLiteral(".pass"), this)
{
    connect(&m_writer, &NewestWriter::written, this, [this] { m_problem.clear(); });
    connect(&m_writer, &NewestWriter::failed, this, [this](const QString& reason) {
        m_problem = Text::tr("The night report could not be written: %1").arg(reason);
    });
    load();
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
        m_problem = Text::tr("The stored night report cannot be read: %1. The new report is kept in memory only.")
                        .arg(read.error().text);
    }
}

void ReportFile::keep(const schedule::NightReport& report)
{
    m_report = report;
    if (!m_path.isEmpty() && !m_unreadable) {
        m_writer.write([path = m_path, report] { return writeReport(path, report); });
    }
}

void ReportFile::keepPass(const schedule::PassRecord& pass)
{
    m_pass.keep({.pass = pass, .earlier = schedule::partsOf(m_report, pass)});
}

std::optional<schedule::PassRecord> ReportFile::lostPass() const
{
    const std::optional<schedule::NewestPass>& found = m_pass.found();
    if (!found || schedule::partsOf(m_report, found->pass) > found->earlier) {
        return std::nullopt;
    }
    schedule::PassRecord lost = found->pass;
    if (lost.end == schedule::PassEnd::Running) {
        lost.end = schedule::PassEnd::Interrupted;
        lost.why = Text::tr("Boresight ended during this pass");
    }
    return lost;
}

}  // namespace boresight

#include "moc_report_file.cpp"
