// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fakes/rotctld_case_runner.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QRegularExpression>
#include <QSet>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace boresight::fakes {
namespace {

using namespace std::chrono_literals;

constexpr double kThere = 0.3;  // degrees: near enough to count as arrived
constexpr auto kQuiet = 10ms;   // silence of this length ends a reply

std::string bytes(const QJsonValue& text)
{
    return text.toString().toLatin1().toStdString();
}

QString text(const std::string& bytes)
{
    return QString::fromLatin1(bytes.data(), static_cast<qsizetype>(bytes.size()));
}

const QRegularExpression& decimalNumber()
{
    static const QRegularExpression expression(QStringLiteral("-?\\d+\\.(\\d+)"));
    return expression;
}

// Replaces every decimal number by the number of its decimals.
QString shape(const QString& reply)
{
    QString result;
    qsizetype last = 0;
    for (auto matches = decimalNumber().globalMatch(reply); matches.hasNext();) {
        const auto match = matches.next();
        result += reply.mid(last, match.capturedStart() - last);
        result += QStringLiteral("<%1>").arg(match.capturedLength(1));
        last = match.capturedEnd();
    }
    return result + reply.mid(last);
}

bool numbersAreNear(const QString& reply, const QString& expected, double tolerance)
{
    auto left = decimalNumber().globalMatch(reply);
    auto right = decimalNumber().globalMatch(expected);
    while (left.hasNext() && right.hasNext()) {
        if (std::abs(left.next().captured().toDouble() - right.next().captured().toDouble()) > tolerance) {
            return false;
        }
    }
    return left.hasNext() == right.hasNext();
}

QList<QSet<QString>> wordSets(const QString& reply)
{
    QList<QSet<QString>> lines;
    for (const QString& line : reply.split(QLatin1Char('\n'))) {
        const QStringList words = line.split(QLatin1Char(' '), Qt::SkipEmptyParts);
        lines.append(QSet<QString>(words.begin(), words.end()));
    }
    return lines;
}

QStringList codes(const QString& reply)
{
    static const QRegularExpression code(QStringLiteral("RPRT -?\\d+"));
    QStringList list;
    for (auto matches = code.globalMatch(reply); matches.hasNext();) {
        list.append(matches.next().captured());
    }
    return list;
}

bool matchesWhole(const QString& pattern, const QString& reply)
{
    return QRegularExpression(QRegularExpression::anchoredPattern(pattern)).match(reply).hasMatch();
}

QString withoutLimitCode(QString reply, const QJsonObject& exchange)
{
    return exchange[QStringLiteral("or_limit")].toBool()
               ? reply.replace(QStringLiteral("RPRT -21"), QStringLiteral("RPRT -1"))
               : reply;
}

bool containsAll(const QJsonObject& exchange, const QString& joined)
{
    const QJsonArray patterns = exchange[QStringLiteral("contains")].toArray();
    const qsizetype longest = exchange[QStringLiteral("maxlen")].toInt(1'000'000);
    return joined.size() <= longest && std::ranges::all_of(patterns, [&joined](const QJsonValue& pattern) {
               return QRegularExpression(pattern.toString()).match(joined).hasMatch();
           });
}

bool replyFits(const QJsonObject& exchange, std::size_t step, const QString& received, const QString& expected)
{
    const QJsonObject stepObject = exchange[QStringLiteral("steps")].toArray()[static_cast<qsizetype>(step)].toObject();
    if (stepObject.contains(QStringLiteral("regex"))) {
        return matchesWhole(stepObject[QStringLiteral("regex")].toString(), received);
    }
    const QString compare = exchange[QStringLiteral("compare")].toString();
    const QString reply = withoutLimitCode(received, exchange);
    if (compare == QLatin1String("regex")) {
        const QJsonArray patterns = exchange[QStringLiteral("regex")].toArray();
        return matchesWhole(patterns[static_cast<qsizetype>(step)].toString(), reply);
    }
    if (compare == QLatin1String("format")) {
        return shape(reply) == shape(expected);
    }
    if (compare == QLatin1String("near")) {
        return shape(reply) == shape(expected) &&
               numbersAreNear(reply, expected, exchange[QStringLiteral("tol")].toDouble());
    }
    if (compare == QLatin1String("flags")) {
        return wordSets(reply) == wordSets(expected);
    }
    if (compare == QLatin1String("rprt")) {
        return codes(reply) == codes(expected);
    }
    return compare == QLatin1String("contains") ? containsAll(exchange, reply) : reply == expected;
}

}  // namespace

std::vector<QJsonObject> loadRotctldCases(const std::string& path)
{
    QFile file(QString::fromStdString(path));
    std::vector<QJsonObject> cases;
    if (file.open(QIODevice::ReadOnly)) {
        for (const auto& value : QJsonDocument::fromJson(file.readAll())[QStringLiteral("cases")].toArray()) {
            cases.push_back(value.toObject());
        }
    }
    return cases;
}

std::string RotctldCaseRunner::run(const QJsonObject& exchange)
{
    const QJsonArray steps = exchange[QStringLiteral("steps")].toArray();
    const QJsonObject expect = exchange[QStringLiteral("expect")].toObject();
    const QJsonArray replies = expect[QStringLiteral("replies")].toArray();
    const bool halfClose = exchange[QStringLiteral("end")].toString() == QLatin1String("half_close");
    m_connections.clear();
    for (qsizetype i = 0; i < steps.size(); ++i) {
        const std::string expected = bytes(replies[i]);
        const auto fits = [&](const std::string& received) {
            return replyFits(exchange, static_cast<std::size_t>(i), text(received), text(expected));
        };
        const bool last = halfClose && i == steps.size() - 1;
        const std::string received = last ? playToTheEnd(steps[i].toObject()) : play(steps[i].toObject(), fits);
        if (!fits(received)) {
            return "step " + std::to_string(i) + ": expected \"" + expected + "\", received \"" + received + "\"";
        }
    }
    const bool closed = expect[QStringLiteral("closed")].toBool();
    if (connection(m_lastConnection).closedByServer() != closed) {
        return std::string("the connection should be ") + (closed ? "closed" : "open");
    }
    return {};
}

// The last step of a client that shuts down its sending side and then reads to the end.
std::string RotctldCaseRunner::playToTheEnd(const QJsonObject& step)
{
    for (const auto& chunk : step[QStringLiteral("send")].toArray()) {
        connection(0).send(bytes(chunk));
    }
    connection(0).endSending();
    return connection(0).receiveUntilClosed();
}

TcpPeer& RotctldCaseRunner::connection(int number)
{
    auto& peer = m_connections[number];
    if (!peer) {
        peer = std::make_unique<TcpPeer>(m_target.host, m_target.port, m_target.pump);
    }
    return *peer;
}

std::string RotctldCaseRunner::play(const QJsonObject& step, const TcpPeer::Enough& fits)
{
    const auto pair = [](const QJsonValue& value) {
        return Position{.azimuth = value[0].toDouble(), .elevation = value[1].toDouble()};
    };
    if (step.contains(QStringLiteral("settle"))) {
        return settle(pair(step[QStringLiteral("settle")])) ? "settled" : "not settled";
    }
    if (step.contains(QStringLiteral("wait_pos"))) {
        return reach(pair(step[QStringLiteral("wait_pos")])) ? "there" : "not there";
    }
    if (step.contains(QStringLiteral("motion"))) {
        const QJsonValue motion = step[QStringLiteral("motion")];
        const QString word = motion[0].toString() + motion[1].toString();
        return moves(motion[0].toString(), motion[1].toString()) ? word.toStdString()
                                                                 : "no motion " + word.toStdString();
    }
    if (step.contains(QStringLiteral("still"))) {
        return stays(step[QStringLiteral("still")].toDouble()) ? "still" : "moving";
    }
    return converse(step, fits);
}

std::string RotctldCaseRunner::converse(const QJsonObject& step, const TcpPeer::Enough& fits)
{
    const int number = step[QStringLiteral("conn")].toInt();
    m_lastConnection = number;
    TcpPeer& peer = connection(number);
    const int times = step[QStringLiteral("atomic")].toInt(1);
    std::string received;
    for (int i = 0; i < times; ++i) {
        const std::size_t readsBefore = peer.segments().size();
        for (const auto& chunk : step[QStringLiteral("send")].toArray()) {
            peer.send(bytes(chunk));
            for (int turn = 0; turn < 5; ++turn) {
                m_target.pump();  // so that chunks arrive one by one
            }
        }
        received = peer.receive(fits, kQuiet, m_target.patience);
        if (times > 1 && peer.segments().size() != readsBefore + 1) {
            return received + " in " + std::to_string(peer.segments().size() - readsBefore) + " reads";
        }
    }
    if (step[QStringLiteral("close")].toBool()) {
        m_connections.erase(number);
    }
    return received;
}

RotctldCaseRunner::Position RotctldCaseRunner::position()
{
    if (!m_observer) {
        m_observer = std::make_unique<TcpPeer>(m_target.host, m_target.port, m_target.pump);
    }
    const QStringList lines = text(m_observer->ask("p\n", 2)).split(QLatin1Char('\n'));
    return {.azimuth = lines.value(0).toDouble(), .elevation = lines.value(1).toDouble()};
}

bool RotctldCaseRunner::reach(Position goal)
{
    for (int i = 0; i < 400; ++i) {
        const Position now = position();
        if (std::abs(now.azimuth - goal.azimuth) < kThere && std::abs(now.elevation - goal.elevation) < kThere) {
            return true;
        }
        m_target.elapse(100ms);
    }
    return false;
}

bool RotctldCaseRunner::settle(Position goal)
{
    TcpPeer driver(m_target.host, m_target.port, m_target.pump);
    const std::string command = "P " + std::to_string(goal.azimuth) + " " + std::to_string(goal.elevation) + "\n";
    if (driver.ask(command) != "RPRT 0\n" || !reach(goal)) {
        return false;
    }
    bool atRest = stays(0.3);
    for (int i = 0; i < 10 && !atRest; ++i) {
        atRest = stays(0.3);  // a mount with ramps is still braking when it is near
    }
    return atRest;
}

bool RotctldCaseRunner::moves(const QString& axis, const QString& sign)
{
    constexpr double kSeen = 0.3;  // degrees
    const auto value = [&axis](Position at) { return axis == QLatin1String("az") ? at.azimuth : at.elevation; };
    double before = value(position());
    for (int i = 0; i < 40; ++i) {
        m_target.elapse(100ms);
        const double now = value(position());
        const double change = sign == QLatin1String("+") ? now - before : before - now;
        if (change > kSeen) {
            return true;
        }
        before = change < 0.0 ? now : before;  // still moving in the other direction
    }
    return false;
}

bool RotctldCaseRunner::stays(double seconds)
{
    constexpr double kMoved = 0.05;  // degrees
    const Position before = position();
    for (double waited = 0.0; waited < seconds; waited += 0.1) {
        m_target.elapse(100ms);
        const Position now = position();
        if (std::abs(now.azimuth - before.azimuth) > kMoved || std::abs(now.elevation - before.elevation) > kMoved) {
            return false;
        }
    }
    return true;
}

}  // namespace boresight::fakes
