// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/table_file_reader.h"

#include <QDeadlineTimer>
#include <QFileInfo>

#include <algorithm>
#include <chrono>
#include <memory>
#include <utility>

namespace boresight::app {
namespace {

constexpr std::chrono::seconds kPatienceAtTheEnd{1};

// Without looking at the disk.
QString folderOf(const QString& path)
{
    return QFileInfo(path).path();
}

// The time of the last change of content, owner or permissions.
TableContent::State stateOf(const QString& path)
{
    const QFileInfo there(path);
    return there.exists()
               ? TableContent::State{.exists = true, .bytes = there.size(), .changed = there.metadataChangeTime()}
               : TableContent::State{};
}

// A folder that failed once may answer the next time, while the file has not changed.
bool isFinal(const Result<targets::Target>& table)
{
    return table || table.error().code == ErrorCode::InvalidInput;
}

SharedTableContent contentOf(const QString& path, const SharedTableContent& known, const TableFileReader::Read& read)
{
    const TableContent::State state = stateOf(path);
    if (known && known->path == path && known->state == state && isFinal(known->table)) {
        return known;
    }
    return std::make_shared<const TableContent>(
        TableContent{.path = path, .state = state, .table = read(path).map(&targets::tableTarget)});
}

}  // namespace

TableFileReader::TableFileReader(Read read, QObject* parent) : QObject(parent), m_read(std::move(read)) {}

TableFileReader::~TableFileReader()
{
    const QDeadlineTimer patience(kPatienceAtTheEnd);
    for (const auto& [thread, folder] : m_threads) {
        if (thread->wait(patience)) {
            delete thread;
        }
    }
}

void TableFileReader::read(const QString& path, const SharedTableContent& known)
{
    m_next = Question{.path = path, .known = known};
    beginNext();
}

void TableFileReader::beginNext()
{
    if (m_next && m_threads.size() < kMostThreads && !isRead(folderOf(m_next->path))) {
        begin(*std::exchange(m_next, std::nullopt));
    }
}

bool TableFileReader::isRead(const QString& folder) const
{
    return std::ranges::any_of(m_threads, [&](const auto& thread) { return thread.second == folder; });
}

void TableFileReader::begin(const Question& question)
{
    const auto content = std::make_shared<SharedTableContent>();
    QThread* const thread = QThread::create(
        [content, question, read = m_read] { *content = contentOf(question.path, question.known, read); });
    connect(thread, &QThread::finished, this, [this, thread, content] { take(thread, *content); });
    connect(thread, &QThread::finished, thread, &QObject::deleteLater);
    m_threads.emplace(thread, folderOf(question.path));
    thread->setObjectName(QStringLiteral("table"));
    thread->start(QThread::LowestPriority);
}

void TableFileReader::take(QThread* thread, const SharedTableContent& content)
{
    m_threads.erase(thread);
    beginNext();
    Q_EMIT wasRead(content);
}

}  // namespace boresight::app

#include "moc_table_file_reader.cpp"
