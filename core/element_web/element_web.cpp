// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/element_web/element_web.h"

#include "core/base/text.h"
#include "core/base/time_of_day.h"
#include "core/elements/element_check.h"
#include "core/elements/element_reader.h"

#include <QFile>

#include <algorithm>
#include <string_view>
#include <utility>

namespace boresight::orbit {

namespace {

constexpr qsizetype kQuotedBytes = 200;  // enough for a quotation in a message

ElementList elementsOf(const QByteArray& bytes)
{
    return readElements(std::string_view(bytes.data(), static_cast<std::size_t>(bytes.size())));
}

std::size_t setsIn(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? elementsOf(file.readAll()).sets.size() : 0;
}

// Whether an answer may replace the file at `path`. It must have sets. If the answer also has errors, it must not have
// fewer sets than the file.
Result<> judgeContent(const QByteArray& content, const QString& path)
{
    const QByteArray start = content.trimmed();
    if (start.isEmpty()) {
        return failure(ErrorCode::Protocol, Text::tr("The answer is empty."));
    }
    const ElementList list = elementsOf(content);
    if (list.sets.empty()) {
        const QByteArray line = start.left(kQuotedBytes).split('\n').front().trimmed();
        return failure(
            ErrorCode::Protocol,
            Text::tr("The answer has no element set. It begins with \"%1\".").arg(orbit::quoted(line.toStdString())));
    }
    if (!list.problems.empty() && list.sets.size() < setsIn(path)) {
        return failure(ErrorCode::Protocol, Text::tr("The answer is cut or damaged. Line %1: %2")
                                                .arg(list.problems.front().line)
                                                .arg(list.problems.front().reason));
    }
    return {};
}

// The pause doubles after each further failure.
std::chrono::hours pauseAfter(int failures)
{
    constexpr int kMostDoublings = 2;
    static_assert(ElementWeb::kPeriod * (1 << kMostDoublings) == ElementWeb::kLongestPeriod);
    return ElementWeb::kPeriod * (1 << std::clamp(failures - 1, 0, kMostDoublings));
}

}  // namespace

ElementWeb::ElementWeb(const Clock& clock, const QString& folder, QObject* parent)
    : ElementWeb(clock, folder, std::make_unique<QNetworkAccessManager>(), parent)
{}

// The network manager becomes a child, so that moveToThread() moves both objects.
ElementWeb::ElementWeb(const Clock& clock, const QString& folder, std::unique_ptr<QNetworkAccessManager> network,
                       QObject* parent)
    : QObject(parent), m_clock(clock), m_cache(folder), m_network(std::move(network))
{
    m_network->setParent(this);
    m_timer.setInterval(kLook);
    connect(&m_timer, &QTimer::timeout, this, &ElementWeb::look);
}

ElementWeb::~ElementWeb() = default;

void ElementWeb::setAddresses(const std::vector<ElementAddress>& addresses)
{
    std::vector<Source> sources;
    for (const ElementAddress& address : addresses) {
        const auto known = std::ranges::find(m_sources, address, &Source::address);
        sources.push_back(known != m_sources.end() ? std::move(*known) : Source{.address = address});
    }
    m_sources = std::move(sources);
    m_timer.start();
    look();
}

bool ElementWeb::isBusy() const
{
    return std::ranges::any_of(m_sources, [](const Source& source) { return source.download != nullptr; });
}

// Reads the state of the cache again each time, because another program may have made a request.
void ElementWeb::look()
{
    for (Source& source : m_sources) {
        if (!source.download) {
            source.state = m_cache.state(source.address);
            source.cacheProblem.clear();
            if (isDue(source)) {
                ask(source);
            }
        }
    }
    tell();
    if (!isBusy()) {
        Q_EMIT idle();
    }
}

// If the clock was set back, the waiting time starts again from the present time at the latest.
bool ElementWeb::isDue(Source& source)
{
    const UtcTime now = m_clock.utc();
    const auto& last = source.state.lastTry;
    if (last && *last > now) {
        source.state.lastTry = now;
        keepState(source);
        return false;
    }
    return (!last || now - *last >= pauseAfter(source.state.failures)) &&
           (!source.notBefore || m_clock.now() >= *source.notBefore);
}

// The cache records the time before the request is sent. So nothing that happens later can cause a request too early.
void ElementWeb::ask(Source& source)
{
    source.triedBefore = std::exchange(source.state.lastTry, m_clock.utc());
    keepState(source);
    if (!source.cacheProblem.isEmpty()) {
        return;
    }
    source.download = std::make_unique<ElementDownload>(*m_network, source.address.url, source.state.etag,
                                                        source.state.lastModified, this);
    connect(source.download.get(), &ElementDownload::finished, this,
            [this, file = source.address.file](const DownloadAnswer& answer) { take(file, answer); });
}

void ElementWeb::take(const QString& file, const DownloadAnswer& answer)
{
    const auto source = std::ranges::find(m_sources, file, [](const Source& one) { return one.address.file; });
    source->download.release()->deleteLater();
    judge(*source, answer);
    keepState(*source);
    tell();
    if (!isBusy()) {
        Q_EMIT idle();
    }
}

void ElementWeb::judge(Source& source, const DownloadAnswer& answer)
{
    using Kind = DownloadAnswer::Kind;
    if (answer.kind == Kind::NoNetwork) {
        source.state.lastTry = source.triedBefore;
        source.state.problem = answer.problem;
        source.notBefore = m_clock.now() + kAfterNoNetwork;
        return;
    }
    const Result<> outcome = answer.kind == Kind::Unchanged ? Result<>()
                             : answer.kind == Kind::Content ? store(source, answer)
                                                            : failure(ErrorCode::NoAnswer, answer.problem);
    if (outcome) {
        source.state.fetched = m_clock.utc();
        source.state.failures = 0;
        source.state.problem.clear();
        return;
    }
    ++source.state.failures;
    source.state.problem = (outcome.error().text + QChar(u' ') + answer.saying).trimmed();
}

Result<> ElementWeb::store(Source& source, const DownloadAnswer& answer)
{
    return judgeContent(answer.content, m_cache.fileOf(source.address))
        .and_then([&] {
            return m_cache.keepContent(source.address, answer.content).map_error([](const Error& error) {
                return Error{error.code, Text::tr("The answer cannot be stored: %1.").arg(error.text)};
            });
        })
        .map([&] {
            source.state.etag = answer.etag;
            source.state.lastModified = answer.lastModified;
            Q_EMIT stored();
        });
}

void ElementWeb::keepState(Source& source)
{
    if (const Result<> kept = m_cache.keepState(source.address, source.state); !kept) {
        source.cacheProblem = kept.error().text;
    }
}

void ElementWeb::tell()
{
    QStringList problems;
    for (Source& source : m_sources) {
        if (!source.download) {
            source.told = problemOf(source);
        }
        if (!source.told.isEmpty()) {
            problems << source.told;
        }
    }
    if (problems != m_problems) {
        m_problems = problems;
        Q_EMIT problemsChanged(m_problems);
    }
}

QString ElementWeb::problemOf(const Source& source) const
{
    const CacheState& state = source.state;
    QStringList sentences;
    if (!source.cacheProblem.isEmpty()) {
        sentences << Text::tr("The cache cannot be written, so nothing is downloaded: %1.").arg(source.cacheProblem);
    } else if (!state.problem.isEmpty()) {
        sentences << state.problem;
    } else if (state.fetched) {
        return {};
    }
    sentences << (state.fetched
                      ? Text::tr("Elements of %1 from the cache are used.").arg(dayAndTimeText(*state.fetched))
                      : Text::tr("The cache has no elements of this source."));
    const UtcTime next = state.lastTry.value_or(UtcTime()) + pauseAfter(state.failures);
    if (source.cacheProblem.isEmpty() && next > m_clock.utc()) {
        sentences << Text::tr("Next download: %1.").arg(dayAndTimeText(next));
    }
    return QStringLiteral("%1: %2").arg(source.address.name, sentences.join(QChar(u' ')));
}

}  // namespace boresight::orbit

#include "moc_element_web.cpp"
