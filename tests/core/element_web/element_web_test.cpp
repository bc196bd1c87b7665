// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/element_web/element_web.h"

#include "tests/fakes/canned_web.h"
#include "tests/fakes/hand_turned_timers.h"
#include "tests/fakes/wait_until.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <gmock/gmock.h>

namespace boresight::orbit {
namespace {

using fakes::CannedWeb;
using testing::AllOf;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;
using testing::StartsWith;

constexpr std::chrono::hours kPeriod = ElementWeb::kPeriod;

// An invented element set.
QByteArray setOf(int number)
{
    return R"({"OBJECT_NAME":"MADE UP","OBJECT_ID":"2026-001A","EPOCH":"2026-11-20T12:00:00.000000","MEAN_MOTION":15.5,)"
           R"("ECCENTRICITY":0.001,"INCLINATION":51.6,"RA_OF_ASC_NODE":100,"ARG_OF_PERICENTER":90,"MEAN_ANOMALY":270,)"
           R"("EPHEMERIS_TYPE":0,"CLASSIFICATION_TYPE":"U","NORAD_CAT_ID":)" +
           QByteArray::number(number) +
           R"(,"ELEMENT_SET_NO":999,"REV_AT_EPOCH":1,"BSTAR":2e-5,"MEAN_MOTION_DOT":1e-5,"MEAN_MOTION_DDOT":0})";
}

const QByteArray kTwo = "[" + setOf(90001) + ",\n" + setOf(90002) + "]";
const QByteArray kOne = "[" + setOf(90001) + "]";

class ElementWebTest : public testing::Test
{
protected:
    ElementWebTest() { start(); }

    // A program starts with the cache of the last one.
    void start()
    {
        timers.reset();
        web.reset();
        web = std::make_unique<ElementWeb>(clock, folder());
        timers = std::make_unique<fakes::HandTurnedTimers>(*web, clock);
        stored = 0;
        QObject::connect(web.get(), &ElementWeb::stored, web.get(), [this] { ++stored; });
    }
    [[nodiscard]] QString folder() const { return m_home.filePath(QStringLiteral("cache")); }
    // Waits until all requests that are due have been made.
    [[nodiscard]] bool settles()
    {
        return fakes::waitUntil([this] { return !web->isBusy(); });
    }
    [[nodiscard]] bool follow(const std::vector<std::string>& paths = {"/a"})
    {
        std::vector<std::string> entries;
        for (const std::string& path : paths) {
            entries.push_back(server.address(path));
        }
        web->setAddresses(elementAddresses(entries));
        return settles();
    }
    [[nodiscard]] bool elapse(Seconds time)
    {
        timers->elapse(time);
        return settles();
    }
    [[nodiscard]] QByteArray cached(const std::string& path = "/a") const
    {
        QFile file(ElementCache(folder()).fileOf(*parseElementAddress(server.address(path))));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    [[nodiscard]] std::string problem() const { return web->problems().join(u'\n').toStdString(); }
    // Puts two sets into the cache, and makes the next request due.
    void fill()
    {
        server.answersWith("/a", "200 OK", "ETag: \"one\"\r\nLast-Modified: Sat, 21 Nov 2026 00:00:00 GMT\r\n", kTwo);
        ASSERT_TRUE(follow());
        ASSERT_EQ(cached(), kTwo);
        clock.advance(kPeriod);
    }
    // The result of the next request must replace nothing.
    void staysWhole(const std::string& reason)
    {
        ASSERT_TRUE(follow());
        EXPECT_EQ(cached(), kTwo);
        EXPECT_THAT(problem(), AllOf(StartsWith(server.address("/a") + ": "), HasSubstr(reason),
                                     HasSubstr("Elements of 2026-11-21 00:00Z from the cache are used.")));
    }

    CannedWeb server;
    fakes::ManualClock clock;
    std::unique_ptr<ElementWeb> web;
    std::unique_ptr<fakes::HandTurnedTimers> timers;
    int stored = 0;

private:
    QTemporaryDir m_home;
};

// REQ-ELEMENTWEB-03: A good answer is stored without a report. The next request names the stored answer. If that is
// still the newest, only its age is reset.
TEST_F(ElementWebTest, AnAnswerIsStoredAndAskedForByItsTag)
{
    fill();
    EXPECT_EQ(stored, 1);
    EXPECT_THAT(problem(), IsEmpty());
    EXPECT_THAT(server.questions().at(0),
                AllOf(StartsWith("GET /a HTTP/1.1"), HasSubstr("User-Agent: Boresight/"), Not(HasSubstr("If-"))));
    server.answers("/a", "HTTP/1.1 304 Not Modified\r\n\r\n");
    ASSERT_TRUE(follow());
    ASSERT_THAT(server.questions(), SizeIs(2));
    EXPECT_THAT(server.questions().at(1), AllOf(HasSubstr("If-None-Match: \"one\""),
                                                HasSubstr("If-Modified-Since: Sat, 21 Nov 2026 00:00:00 GMT")));
    EXPECT_EQ(stored, 1);
    EXPECT_EQ(cached(), kTwo);
    EXPECT_THAT(problem(), IsEmpty());
    server.answersWith("/a", "500 Oh no", {}, {});
    ASSERT_TRUE(elapse(kPeriod));
    EXPECT_THAT(problem(), HasSubstr("Elements of 2026-11-21 02:00Z from the cache are used."));
}

// REQ-ELEMENTWEB-04: An address is requested at most once in two hours, also after a restart of the program and after a
// failure. After further failures it is requested less often.
TEST_F(ElementWebTest, ARestartAsksNoSooner)
{
    server.answersWith("/a", "200 OK", {}, kTwo);
    ASSERT_TRUE(follow());
    start();
    ASSERT_TRUE(follow());
    ASSERT_TRUE(elapse(kPeriod - Seconds(60)));
    EXPECT_THAT(server.questions(), SizeIs(1));
    start();
    ASSERT_TRUE(follow());
    ASSERT_TRUE(elapse(Seconds(60)));
    EXPECT_THAT(server.questions(), SizeIs(2));
}

// REQ-ELEMENTWEB-04
TEST_F(ElementWebTest, AFailureIsAskedAgainLaterAndLater)
{
    server.answersWith("/a", "403 Forbidden", "Content-Type: text/plain\r\n", "Too many questions\nand more");
    ASSERT_TRUE(follow());
    EXPECT_EQ(problem(), server.address("/a") +
                             ": The server answers 403 Forbidden. The server sent: \"Too many questions\". The "
                             "cache has no elements of this source. Next download: 2026-11-21 02:00Z.");
    start();
    ASSERT_TRUE(follow());
    EXPECT_THAT(problem(), HasSubstr("403 Forbidden")) << "also in the next program";
    std::vector<std::size_t> questions;
    for (const int hours : {1, 1, 2, 2, 4, 4, 8, 8}) {
        clock.advance(std::chrono::hours(hours));
        ASSERT_TRUE(elapse(Seconds(0.0)));  // one look
        questions.push_back(server.questions().size());
    }
    EXPECT_THAT(questions, ElementsAre(1, 2, 2, 3, 3, 4, 5, 6)) << "after 2, 6, 14, 22 and 30 hours";
}

// REQ-ELEMENTWEB-04
TEST_F(ElementWebTest, AClockThatIsSetBackDelaysByNoMoreThanTheRule)
{
    fill();
    clock.stepUtc(-std::chrono::hours(1000));
    ASSERT_TRUE(follow());
    EXPECT_THAT(server.questions(), SizeIs(1));
    ASSERT_TRUE(elapse(kPeriod));
    EXPECT_THAT(server.questions(), SizeIs(2));
}

// REQ-ELEMENTWEB-05: A failure, or an answer without good sets, never replaces the content of the cache. Each is
// reported with the address, the reason and the age of the used sets: an error of the server, an answer that is cut,
// empty, damaged, a web page, too large, too slow or endless, and a redirect away from https.
TEST_F(ElementWebTest, AnAnswerWithoutSetsReplacesNothing)
{
    fill();
    server.answersWith("/a", "404 Not Found", {}, "<html>Not here</html>");
    staysWhole("The server answers 404 Not Found.");
    clock.advance(kPeriod);
    server.answersWith("/a", "200 OK", "Content-Type: text/html\r\n", "<html>\n<p>Please log in</p></html>");
    staysWhole("The answer has no element set. It begins with \"<html>\".");
    clock.advance(2 * kPeriod);
    // CelesTrak sends this answer without a line end.
    server.answersWith("/a", "200 OK", {}, "No GP data found");
    staysWhole("The answer has no element set. It begins with \"No GP data found\".");
    clock.advance(4 * kPeriod);
    server.answersWith("/a", "200 OK", {}, {});
    staysWhole("The answer is empty.");
}

// REQ-ELEMENTWEB-05
TEST_F(ElementWebTest, ACutAnswerReplacesNothing)
{
    fill();
    server.answers("/a", "HTTP/1.1 200 OK\r\nContent-Length: 5000\r\n\r\n" + kTwo);
    staysWhole("The download has failed: ");
    clock.advance(kPeriod);
    // The server does not report the length of the answer.
    server.answers("/a", "HTTP/1.0 200 OK\r\n\r\n" + kTwo.left(kTwo.size() - 20));
    staysWhole("The answer is cut or damaged. Line 2: ");
}

TEST_F(ElementWebTest, FewerSetsAreTakenWhereNothingIsWrong)
{
    fill();
    server.answersWith("/a", "200 OK", {}, kOne);
    ASSERT_TRUE(follow());
    EXPECT_EQ(cached(), kOne);
    EXPECT_THAT(problem(), IsEmpty());
}

// REQ-ELEMENTWEB-05
TEST_F(ElementWebTest, AHugeAnswerIsNotReadToItsEnd)
{
    fill();
    server.answers("/a", "HTTP/1.1 200 OK\r\nContent-Length: 104857600\r\n\r\n", CannedWeb::Then::Waits);
    staysWhole("The answer is larger than 64 MB.");
    clock.advance(kPeriod);
    server.answers("/a", "HTTP/1.1 200 OK\r\n\r\n", CannedWeb::Then::GoesOn);
    staysWhole("The answer is larger than 64 MB.");
}

// REQ-ELEMENTWEB-05
TEST_F(ElementWebTest, ASilentServerIsNotWaitedFor)
{
    fill();
    server.answers("/a", "HTTP/1.1 200 OK\r\n", CannedWeb::Then::Waits);
    web->setAddresses(elementAddresses({server.address("/a")}));
    ASSERT_TRUE(fakes::waitUntil([this] { return server.questions().size() == 2; }));
    EXPECT_THAT(problem(), IsEmpty());
    timers->elapse(ElementDownload::kLongestSilence - Seconds(1));
    EXPECT_TRUE(web->isBusy());
    timers->elapse(Seconds(1));
    ASSERT_TRUE(settles());
    EXPECT_THAT(problem(), HasSubstr("The server has sent nothing for 30 s."));
    EXPECT_EQ(cached(), kTwo);
}

// REQ-ELEMENTWEB-05
TEST_F(ElementWebTest, NobodyIsLedAwayFromHttps)
{
    fill();
    server.answersWith("/a", "301 Moved", "Location: http://example.org/a.json?key=1\r\n", {});
    staysWhole("The server redirects to http://example.org/a.json. Only https:// is accepted.");
    clock.advance(kPeriod);
    server.answersWith("/a", "302 Found", "Location: /a\r\n", {});
    staysWhole("The server redirects more than 3 times.");
    EXPECT_THAT(server.questions(), SizeIs(2 + 1 + ElementDownload::kMostRedirects));
}

// REQ-ELEMENTWEB-06: Without a network the cache is used, and its age is reported. If the name of the server cannot be
// resolved, no request was made, so the next attempt comes after five minutes.
TEST_F(ElementWebTest, WithoutANetworkTheCacheIsUsed)
{
    fill();
    server.stopListening();
    start();
    staysWhole("The download has failed: ");
    const std::string nowhere = "https://nowhere.invalid/a.json";
    start();
    web->setAddresses(elementAddresses({nowhere}));
    ASSERT_TRUE(settles());
    EXPECT_EQ(problem(),
              nowhere + ": No network, or no server nowhere.invalid. The cache has no elements of this source.");
    const auto busyAfter = [this](Seconds time) {
        timers->elapse(time);
        return web->isBusy();
    };
    EXPECT_FALSE(busyAfter(ElementWeb::kAfterNoNetwork - Seconds(60)));
    EXPECT_TRUE(busyAfter(Seconds(60)));
}

// REQ-ELEMENTWEB-07: While the cache cannot be written no request is made, because it could not be recorded. This is
// reported with folder and reason. Requests continue as soon as the cache can be written.
TEST_F(ElementWebTest, WithoutACacheNobodyIsAsked)
{
    server.answersWith("/a", "200 OK", {}, kTwo);
    QFile inTheWay(folder());
    ASSERT_TRUE(inTheWay.open(QIODevice::WriteOnly));
    ASSERT_TRUE(follow());
    EXPECT_THAT(server.questions(), IsEmpty());
    EXPECT_EQ(problem(), server.address("/a") +
                             ": The cache cannot be written, so nothing is downloaded: " + folder().toStdString() +
                             ": this folder cannot be made. The cache has no elements of this source.");
    inTheWay.remove();
    ASSERT_TRUE(elapse(ElementWeb::kLook));
    EXPECT_EQ(cached(), kTwo);
    EXPECT_THAT(problem(), IsEmpty());
}

// REQ-ELEMENTWEB-07
TEST_F(ElementWebTest, AnAnswerThatCannotBeStoredIsTold)
{
    const QString path = ElementCache(folder()).fileOf(*parseElementAddress(server.address("/a")));
    ASSERT_TRUE(QDir().mkpath(path)) << "a folder in the place of the file";
    server.answersWith("/a", "200 OK", {}, kTwo);
    ASSERT_TRUE(follow());
    EXPECT_THAT(problem(), HasSubstr("The answer cannot be stored: " + path.toStdString()));
    EXPECT_EQ(stored, 0);
}

// REQ-ELEMENTWEB-08: Each address is requested, stored and reported independently.
TEST_F(ElementWebTest, AddressesDoNotDisturbEachOther)
{
    server.answersWith("/a", "200 OK", {}, kTwo);
    server.answers("/b", {}, CannedWeb::Then::Waits);
    server.answersWith("/c", "500 Oh no", {}, {});
    web->setAddresses(elementAddresses({server.address("/a"), server.address("/b"), server.address("/c")}));
    ASSERT_TRUE(fakes::waitUntil([this] { return stored == 1 && web->problems().size() == 1; }));
    EXPECT_EQ(cached("/a"), kTwo);
    EXPECT_THAT(problem(), StartsWith(server.address("/c")));
    EXPECT_TRUE(web->isBusy()) << "the silent one";
    ASSERT_TRUE(follow({"/a"}));
    EXPECT_THAT(problem(), IsEmpty()) << "the others are not asked any more";
    EXPECT_THAT(server.questions(), SizeIs(3));
}

}  // namespace
}  // namespace boresight::orbit
