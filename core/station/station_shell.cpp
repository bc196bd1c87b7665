// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/station_shell.h"

#include "core/base/text.h"

namespace boresight {
namespace {

constexpr int kShellLinesPerSecond = 4;

Source shellSource()
{
    return {.kind = SourceKind::Operator, .name = QStringLiteral("shell")};
}

// None of them moves the mount.
Request requestOf(local::LocalCommand command)
{
    switch (command) {
        case local::LocalCommand::Take:
            return request::TakeAuthority{};
        case local::LocalCommand::Release:
            return request::GiveAuthority{};
        case local::LocalCommand::ResetStop:
            return request::ResetStop{};
        case local::LocalCommand::Stop:
            break;
    }
    return request::Stop{};
}

}  // namespace

StationShell::StationShell(Ask ask, EventLog& log, const Clock& clock, QObject* parent)
    : m_ask(std::move(ask)),
      m_lines(log, clock, kShellLinesPerSecond),
      m_server([this](local::LocalCommand command) { return obey(command); }, parent)
{}

void StationShell::open(std::uint16_t port)
{
    if (!m_runtimeFolder) {
        return;
    }
    const Result<> listening = m_server.listen(*m_runtimeFolder, port);
    if (listening) {
        m_lines.insist(Severity::Advisory, shellSource().name, Text::tr("listening on %1").arg(m_server.path()));
        return;
    }
    // A program without a session of its user has no folder for it.
    const bool isUsual = listening.error().code == ErrorCode::NotAvailable;
    m_lines.insist(isUsual ? Severity::Advisory : Severity::Warning, shellSource().name,
                   Text::tr("The local socket did not open: %1. Commands of the shell that need it do not reach this "
                            "station.")
                       .arg(listening.error().text));
}

Result<> StationShell::obey(local::LocalCommand command)
{
    const Result<> answer = m_ask(requestOf(command), shellSource());
    if (!answer) {
        m_lines.add(Severity::Warning, shellSource().name,
                    Text::tr("%1 refused: %2").arg(QString::fromLatin1(local::wordOf(command)), answer.error().text));
    }
    return answer;
}

}  // namespace boresight
