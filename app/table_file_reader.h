// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/messages/table_content.h"
#include "core/table_file/table_file.h"

#include <QObject>
#include <QThread>

#include <functional>
#include <map>
#include <optional>

// Reads the file of a table for the window, which never waits for it. Each file is read on a thread of its own, because
// the folder of another computer may block a reader for ever. In each folder only one file at a time is read, so such a
// folder holds one thread. Lives on the main thread; the answer is a signal on that
// thread.
namespace boresight::app {

class TableFileReader : public QObject
{
    Q_OBJECT

public:
    // Blocking; called on other threads.
    using Read = std::function<Result<tables::SharedTable>(const QString& path)>;
    // While this many folders do not answer, or that of the file, only the newest question waits.
    static constexpr std::size_t kMostThreads = 4;

    explicit TableFileReader(Read read = &tables::readTableFile, QObject* parent = nullptr);
    ~TableFileReader() override;  // leaves a blocked thread alone: it must not keep the program from ending

public Q_SLOTS:
    // `known`: an earlier answer, or null. It is the answer again if the file has not changed since.
    void read(const QString& path, const boresight::SharedTableContent& known);

Q_SIGNALS:
    void wasRead(const boresight::SharedTableContent& content);

private:
    struct Question
    {
        QString path;
        SharedTableContent known;
    };

    void beginNext();
    void begin(const Question& question);
    void take(QThread* thread, const SharedTableContent& content);
    [[nodiscard]] bool isRead(const QString& folder) const;

    Read m_read;
    std::map<QThread*, QString> m_threads;  // that read, with the folder of their file
    std::optional<Question> m_next;
};

}  // namespace boresight::app
