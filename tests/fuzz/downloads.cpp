// SPDX-License-Identifier: GPL-3.0-or-later
// REQ-ELEMENTWEB-950 (Fuzz.downloads): Whatever a server answers ends in a stored answer with element sets, or in one
// short printable problem with what the cache has. What was stored before is never replaced by something without sets.
#include "core/base/control_characters.h"
#include "core/element_web/element_web.h"
#include "core/elements/element_reader.h"
#include "tests/fakes/canned_web.h"
#include "tests/fakes/hand_turned_timers.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fuzz/harness.h"

#include <QCoreApplication>
#include <QDir>
#include <QEventLoop>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTimer>

#include <chrono>
#include <string>

namespace boresight::fuzz {
namespace {

using namespace boresight::orbit;

const std::string kSet =
    R"({"OBJECT_NAME":"MADE UP","OBJECT_ID":"2026-001A","EPOCH":"2026-11-20T12:00:00","MEAN_MOTION":15.5,)"
    R"("ECCENTRICITY":0.001,"INCLINATION":51.6,"RA_OF_ASC_NODE":100,"ARG_OF_PERICENTER":90,"MEAN_ANOMALY":270,)"
    R"("EPHEMERIS_TYPE":0,"NORAD_CAT_ID":90001,"BSTAR":2e-5})";

std::string answerText(const std::string& status, const std::string& headers, const std::string& content)
{
    return "HTTP/1.1 " + status + "\r\nContent-Length: " + std::to_string(content.size()) + "\r\n" + headers + "\r\n" +
           content;
}

// One server and one cache for all inputs, as one that is asked for years.
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
        const QByteArray before = cached();
        m_server.answers("/a", answer);
        m_stored = false;
        m_clock.advance(ElementWeb::kLongestPeriod);
        m_web.setAddresses({m_address});
        const UtcTime asked = m_clock.utc();
        while (m_web.isBusy()) {
            // An answer that ends within the head of a chunk has no end for Qt. We give up after a silence.
            m_patience.start(kPatience);
            m_loop.exec();
            if (m_web.isBusy()) {
                m_timers.elapse(ElementDownload::kLongestSilence);
            }
        }
        checkProblems();
        const QByteArray after = cached();
        require(m_stored || after == before, "what is not told as stored is not stored");
        require(!m_stored || after == before || hasSets(after), "what is stored has element sets");
        const CacheState state = ElementCache(m_folder.path()).state(m_address);
        require(state.lastTry == asked, "it is kept that the server was asked");
        require(!state.etag.contains('\n') && !state.lastModified.contains('\n'), "a header is one line");
        if (m_stored) {
            accept();
        }
    }

private:
    static constexpr std::chrono::milliseconds kPatience{500};

    [[nodiscard]] QByteArray cached() const
    {
        QFile file(ElementCache(m_folder.path()).fileOf(m_address));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    static bool hasSets(const QByteArray& bytes)
    {
        return !readElements({bytes.data(), static_cast<std::size_t>(bytes.size())}).sets.empty();
    }
    void checkProblems() const
    {
        require(!m_stored || m_web.problems().isEmpty(), "what is stored is no problem");
        require(m_web.problems().size() <= 1, "an address has one problem");
        for (const QString& problem : m_web.problems()) {
            require(problem.startsWith(m_address.name), "a problem names the address");
            require(problem.size() < 800, "a problem is short");
            require(!hasControlCharacters(problem.toStdString()), "a problem is one printable line");
        }
    }

    fakes::CannedWeb m_server;
    fakes::ManualClock m_clock;
    // In memory where there is such a folder: each answer is written to the disk.
    QTemporaryDir m_folder{
        (QFileInfo::exists(QStringLiteral("/dev/shm")) ? QStringLiteral("/dev/shm") : QDir::tempPath()) +
        QStringLiteral("/fuzz_downloads-XXXXXX")};
    ElementAddress m_address = *parseElementAddress(m_server.address("/a"));
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
    Grammar grammar;
    const std::string two = "[" + kSet + "]";
    grammar.corpus = {answerText("200 OK", "ETag: \"one\"\r\nLast-Modified: Sat, 21 Nov 2026 00:00:00 GMT\r\n", two),
                      answerText("200 OK", "Content-Type: text/plain\r\n",
                                 "ISS\n1 25544U 98067A   24130.36689744  .00016024  00000+0  27777-3 0  9992\n"
                                 "2 25544  51.6381 147.8590 0003466 150.4670 338.5502 15.51043222452521\n"),
                      "HTTP/1.0 200 OK\r\n\r\n" + two,
                      "HTTP/1.1 200 OK\r\nTransfer-Encoding: chunked\r\n\r\n2\r\n[\n\r\n0\r\n\r\n",
                      "HTTP/1.1 304 Not Modified\r\n\r\n",
                      answerText("302 Found", "Location: /a\r\n", {}),
                      answerText("403 Forbidden", "Content-Type: text/plain\r\n", "Too many questions\n")};
    grammar.tokens = {"HTTP/1.1 ",
                      "200 OK",
                      "304",
                      "401 Unauthorized",
                      "407",
                      "100 Continue\r\n\r\n",
                      "\r\n",
                      "\r\n\r\n",
                      "Content-Length: ",
                      "Content-Length: 99999999999\r\n",
                      "Content-Length: -1\r\n",
                      "Transfer-Encoding: chunked\r\n",
                      "Content-Encoding: gzip\r\n",
                      "Content-Encoding: deflate\r\n",
                      "Location: /a\r\n",
                      "Location: http://127.0.0.1:1/\r\n",
                      "Location: file:///etc/hostname\r\n",
                      "WWW-Authenticate: Basic realm=\"x\"\r\n",
                      "Proxy-Authenticate: NTLM\r\n",
                      "Set-Cookie: a=b\r\n",
                      "Connection: keep-alive\r\n",
                      "Upgrade: h2c\r\n",
                      "ffffffff\r\n",
                      "0\r\n\r\n",
                      "ETag: \"\x01\"\r\n",
                      "<html>",
                      "\x1f\x8b\x08",
                      "\xff",
                      "\x1b"};
    grammar.separators = "\r\n :,\"";
    grammar.maxLength = 2048;
    grammar.persistence = 30;
    return grammar;
}

// No other computer is asked.
void feed(std::span<const std::uint8_t> input)
{
    const std::string_view text = asText(input);
    const QByteArray bytes(text.data(), static_cast<qsizetype>(text.size()));
    if (!bytes.toLower().contains("https")) {
        answer(bytes);
    }
}

}  // namespace boresight::fuzz
