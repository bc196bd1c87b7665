// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/followed_rotctld/followed_rotctld.h"

#include "core/base/text.h"
#include "core/rotator_box/tcp_box_line.h"

namespace boresight::rotctl {
namespace {

constexpr std::chrono::seconds kBetweenTries{1};

}  // namespace

FollowedRotctld::FollowedRotctld(const BusName& rotctld, SteadyTime now, QObject* parent)
    : QObject(parent), m_line(std::make_unique<TcpBoxLine>(rotctld)), m_heard(now)
{
    connect(m_line.get(), &BoxLine::received, this, [this](const QByteArray& bytes) {
        m_poll.take({bytes.constData(), static_cast<std::size_t>(bytes.size())});
    });
    connect(m_line.get(), &BoxLine::stateChanged, this, &FollowedRotctld::showLine);
}

FollowedRotctld::~FollowedRotctld()
{
    m_line->disconnect(this);
}

// Before the first position a refused connection is not tried again.
void FollowedRotctld::showLine()
{
    m_poll.restart();
    if (m_line->state() == BoxLine::State::Lost) {
        m_trouble = m_line->problem();
        if (!m_found) {
            giveUp();
        }
    }
}

void FollowedRotctld::tick(SteadyTime now)
{
    if (m_over) {
        return;
    }
    if (now - m_heard > kLongestSilence) {
        giveUp();
    } else if (m_line->state() == BoxLine::State::Up) {
        talk(now);
    } else if (!m_tried || now - *m_tried >= kBetweenTries) {
        m_tried = now;
        m_line->open();
    }
}

void FollowedRotctld::talk(SteadyTime now)
{
    if (const auto answered = m_poll.takeAnswer()) {
        take(*answered, now);
        return;
    }
    if (m_poll.hangs(now)) {
        m_trouble = Text::tr("%1 does not answer").arg(name());
        m_line->close();  // tick() opens it again
    } else if (const std::string question = m_poll.ask(now); !question.empty()) {
        m_line->write(QByteArray::fromStdString(question));
    }
}

void FollowedRotctld::take(const Result<AxisPosition>& answered, SteadyTime now)
{
    if (answered) {
        m_heard = now;
        m_found = true;
        Q_EMIT read(
            {.name = name(), .direction = SkyPointing{.azimuth = answered->azimuth, .elevation = answered->elevation}});
        return;
    }
    m_trouble = QStringLiteral("%1: %2").arg(name(), answered.error().text);
    if (answered.error().code == ErrorCode::Refused) {
        m_line->close();
    }
}

void FollowedRotctld::giveUp()
{
    m_over = true;
    const QString why = m_trouble.isEmpty() ? Text::tr("%1 does not answer").arg(name()) : m_trouble;
    Q_EMIT read({.name = name(), .direction = failure(ErrorCode::NoAnswer, why)});
}

}  // namespace boresight::rotctl

#include "moc_followed_rotctld.cpp"
