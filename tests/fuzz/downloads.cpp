// SPDX-License-Identifier: GPL-3.0-or-later
// REQ-ELEMENTWEB-950 (Fuzz.downloads): Every answer of a server ends with a stored answer that has element sets, or
// with one short printable problem while the cache is used. An earlier stored answer is never replaced by one without
// sets.
//
// Here the answer goes through a socket and Qt's own reading. An answer without an end costs half a second, so there
// are few inputs. answers.cpp tests what Boresight does with an answer.
#include "core/element_web/element_web.h"
#include "tests/fakes/canned_web.h"
#include "tests/fakes/hand_turned_timers.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fuzz/answer_grammar.h"
#include "tests/fuzz/download_promises.h"
#include "tests/fuzz/harness.h"
#include "tests/fuzz/memory_folder.h"

#include <QCoreApplication>
#include <QEventLoop>
#include <QTemporaryDir>
#include <QTimer>

#include <chrono>

namespace boresight::fuzz {
namespace {

using namespace boresight::orbit;

// One server and one cache for all inputs, as after years of requests.
class Downloads
{
public:
    Downloads()
    {
        QObject::connect(&m_web, &ElementWeb::stored, &m_web, [this] { m_stored = true; });
        QObject::connect(&m_web, &ElementWeb::idle, &m_loop, &QEventLoop::quit);
        QObject::connect(&m_patience, &QTimer::timeout, &m_loop, &QEventLoop::quit);
    }

    void take(const QByteArray& answer)
    {
        m_server.answers("/a", answer);
        m_stored = false;
        m_clock.advance(ElementWeb::kLongestPeriod);
        m_web.setAddresses({m_address});
        const UtcTime asked = m_clock.utc();
        while (m_web.isBusy()) {
            // For Qt an answer that ends within the head of a chunk has no end. The download gives up after a silence.
            m_patience.start(kPatience);
            m_loop.exec();
            if (m_web.isBusy()) {
                m_timers.elapse(ElementDownload::kLongestSilence);
            }
        }
        m_promises.check(m_stored, m_web.problems(), asked);
    }

private:
    static constexpr std::chrono::milliseconds kPatience{500};

    fakes::CannedWeb m_server;
    fakes::ManualClock m_clock;
    QTemporaryDir m_folder{memoryFolder(QStringLiteral("fuzz_downloads"))};
    ElementAddress m_address = *parseElementAddress(m_server.address("/a"));
    DownloadPromises m_promises{m_folder.path(), m_address};
    ElementWeb m_web{m_clock, m_folder.path()};
    fakes::HandTurnedTimers m_timers{m_web, m_clock};
    QEventLoop m_loop;
    QTimer m_patience;
    bool m_stored = false;
};

void answer(const QByteArray& bytes)
{
    static int count = 1;
    static char name[] = "fuzz_downloads";
    static char* words[] = {name, nullptr};
    static const QCoreApplication app(count, words);
    static Downloads downloads;
    downloads.take(bytes);
}

}  // namespace

Grammar grammar()
{
    return answerGrammar();
}

// No other computer is contacted.
void feed(std::span<const std::uint8_t> input)
{
    const std::string_view text = asText(input);
    const QByteArray bytes(text.data(), static_cast<qsizetype>(text.size()));
    if (!bytes.toLower().contains("https")) {
        answer(bytes);
    }
}

}  // namespace boresight::fuzz
