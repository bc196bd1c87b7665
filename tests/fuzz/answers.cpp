// SPDX-License-Identifier: GPL-3.0-or-later
// REQ-ELEMENTWEB-951 (Fuzz.answers): REQ-ELEMENTWEB-950 holds for any status, headers and content that Boresight
// receives, in pieces, cut, without an end or too large, and for any earlier content of the cache.
#include "core/element_web/element_web.h"
#include "tests/fakes/hand_turned_timers.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fuzz/answer_grammar.h"
#include "tests/fuzz/download_promises.h"
#include "tests/fuzz/harness.h"
#include "tests/fuzz/memory_folder.h"
#include "tests/fuzz/spoken_reply.h"

#include <QCoreApplication>
#include <QFile>
#include <QTemporaryDir>

#include <cstddef>
#include <memory>

namespace boresight::fuzz {
namespace {

using namespace boresight::orbit;

constexpr std::size_t kOneForEver = 5'000;  // one of this number of answers never ends, and takes as long as 500 others
constexpr int kMostLooks = 100'000;

// One cache for all inputs. Each input continues with the result of the previous one.
class Answers
{
public:
    Answers()
    {
        auto network = std::make_unique<SpokenNetwork>();
        m_network = network.get();
        m_web = std::make_unique<ElementWeb>(m_clock, m_folder.path(), std::move(network));
        m_timers = std::make_unique<fakes::HandTurnedTimers>(*m_web, m_clock);
        QObject::connect(m_web.get(), &ElementWeb::stored, m_web.get(), [this] { m_stored = true; });
    }

    void take(const QByteArray& bytes)
    {
        SpokenAnswer answer = readAnswer(bytes);
        ++m_count;
        if (m_count % kOneForEver == 0) {
            answer.end = SpokenAnswer::End::GoesOn;
        }
        m_network->setAnswer(answer);
        m_stored = false;
        m_clock.advance(ElementWeb::kLongestPeriod);
        const UtcTime asked = m_clock.utc();
        m_web->setAddresses({m_address});
        finish();
        const bool noServer = answer.end == SpokenAnswer::End::NoServer;
        m_promises.check(m_stored, m_web->problems(), noServer ? std::nullopt : std::optional(asked));
    }

private:
    // Runs to the end, or until nothing more is sent. Then the time limit for silence has passed.
    void finish()
    {
        for (int looks = 0; m_web->isBusy(); ++looks) {
            require(looks < kMostLooks, "a download ends");
            QCoreApplication::sendPostedEvents();
            if (m_web->isBusy() && m_network->isSilent()) {
                m_timers->elapse(ElementDownload::kLongestSilence);
            }
        }
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }

    fakes::ManualClock m_clock;
    QTemporaryDir m_folder{memoryFolder(QStringLiteral("fuzz_answers"))};
    // An address on this computer: for others Qt looks up the system's proxy in a separate thread.
    ElementAddress m_address = *parseElementAddress("http://127.0.0.1/a");
    DownloadPromises m_promises{m_folder.path(), m_address};
    SpokenNetwork* m_network = nullptr;
    std::unique_ptr<ElementWeb> m_web;
    std::unique_ptr<fakes::HandTurnedTimers> m_timers;
    std::size_t m_count = 0;
    bool m_stored = false;
};

void answer(const QByteArray& bytes)
{
    static int count = 1;
    static char name[] = "fuzz_answers";
    static char* words[] = {name, nullptr};
    static const QCoreApplication app(count, words);
    static Answers answers;
    answers.take(bytes);
}

}  // namespace

Grammar grammar()
{
    return answerGrammar();
}

void feed(std::span<const std::uint8_t> input)
{
    const std::string_view text = asText(input);
    answer(QByteArray(text.data(), static_cast<qsizetype>(text.size())));
}

}  // namespace boresight::fuzz
