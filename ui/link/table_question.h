// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "core/messages/table_content.h"
#include "ui/link/host_desk.h"

#include <QObject>

#include <chrono>
#include <optional>

// Asks for the table in a file, and keeps the newest answer about this file. It asks after a pause, because a path that
// is being typed names no file yet, and again while the status comes, because the file may change. Gui thread.
namespace boresight::ui {

class TableQuestion : public QObject
{
    Q_OBJECT

public:
    explicit TableQuestion(HostDesk& host, QObject* parent = nullptr);

    void ask(const QString& path);  // absolute
    void drop();                    // the answer is not needed any more
    void showStatus(const StationStatus& status);

    [[nodiscard]] bool isOpen() const { return !m_path.isEmpty(); }
    [[nodiscard]] bool isReading() const { return isOpen() && !m_content && !isBlocked(); }
    // Empty: there is none, or the file was not read yet.
    [[nodiscard]] std::optional<targets::Target> table() const;
    // No answer comes. An earlier one counts no longer.
    [[nodiscard]] bool isBlocked() const { return isOpen() && m_waits && isPast(kLongestTableReading); }
    // Empty: the file has a table, or nothing was asked, or no answer comes.
    [[nodiscard]] QString whyNot() const;
    // Empty: an answer came, or may still come.
    [[nodiscard]] QString doubt() const;

Q_SIGNALS:
    void answered();  // the file was read, or has changed

private:
    void send();
    void take(const SharedTableContent& content);
    [[nodiscard]] bool isPast(std::chrono::milliseconds time) const;

    HostDesk& m_host;
    QString m_path;
    SharedTableContent m_content;
    bool m_waits = false;
    UtcTime m_now{};
    UtcTime m_since{};  // of the last question, or of the last change of the path
};

}  // namespace boresight::ui
