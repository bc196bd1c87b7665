// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QProcess>
#include <QString>
#include <QStringList>

// A program started as from a shell, with its output. It is killed when it goes out of scope. Waiting runs the event
// loop.
namespace boresight::fakes {

class Program
{
public:
    Program(const QString& path, const QStringList& arguments);
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    // True once a line of standard output begins with `text`.
    [[nodiscard]] bool waitForLine(const QString& text);
    // True once standard error contains `text`.
    [[nodiscard]] bool waitForError(const QString& text);
    // The exit status, or -1 if the program crashed, was killed or does not end.
    [[nodiscard]] int waitForEnd();
    void type(const QByteArray& text);           // and then ends standard input
    void terminate() { m_process.terminate(); }  // SIGTERM
    void kill() { m_process.kill(); }            // SIGKILL

    [[nodiscard]] QString output() const { return QString::fromUtf8(m_output); }
    [[nodiscard]] QString errors() const { return QString::fromUtf8(m_errors); }
    // The complete lines of standard output so far.
    [[nodiscard]] QStringList lines() const;

private:
    QProcess m_process;
    QByteArray m_output;
    QByteArray m_errors;
};

}  // namespace boresight::fakes
