// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/followed_rotctld/followed_rotctld.h"

#include "core/base/text.h"
#include "core/rotator_box/tcp_box_line.h"

#include <utility>

namespace boresight::rotctl {
namespace {

constexpr std::chrono::seconds kBetweenTries{1};

}  // namespace

void FollowedRotctld::find(const BusName& rotctld, SteadyTime now, Then then)
{
    forget();
    close();
    m_line = std::make_unique<TcpBoxLine>(rotctld);
    m_line->setParent(this);
    connect(m_line.get(), &BoxLine::received, this, [this](const QByteArray& bytes) {
        m_poll.take({bytes.constData(), static_cast<std::size_t>(bytes.size())});
    });
    connect(m_line.get(), &BoxLine::stateChanged, this, &FollowedRotctld::showLine);
    m_then = std::move(then);
    m_heard = now;
    tick(now);
}

void FollowedRotctld::forget()
{
    if (m_then) {
        close();
        answer(failure(ErrorCode::Refused,
                       Text::tr("Another command came before the rotctld had answered. Track it again.")));
    }
}

void FollowedRotctld::close()
{
    if (m_line) {
        m_line->disconnect(this);
        m_line->close();
        m_line.release()->deleteLater();  // it may be the one who calls
    }
    m_poll.restart();
    m_trouble.clear();
    m_tried.reset();
}

// Who waits need not wait for a host that refuses.
void FollowedRotctld::showLine()
{
    m_poll.restart();
    if (m_line->state() == BoxLine::State::Lost) {
        m_trouble = m_line->problem();
        if (m_then) {
            giveUp();
        }
    }
}

void FollowedRotctld::tick(SteadyTime now)
{
    if (!m_line) {
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
        if (!m_line || m_line->state() != BoxLine::State::Up) {
            return;
        }
    }
    if (m_poll.hangs(now)) {
        m_trouble = Text::tr("%1 does not answer").arg(m_line->name());
        connectAnew();
    } else if (const std::string question = m_poll.ask(now); !question.empty()) {
        m_line->write(QByteArray::fromStdString(question));
    }
}

void FollowedRotctld::take(const Result<AxisPosition>& answered, SteadyTime now)
{
    if (answered) {
        m_heard = now;
        const RotatorReading reading{.name = m_line->name(),
                                     .direction = {.azimuth = answered->azimuth, .elevation = answered->elevation}};
        if (m_then) {
            answer(reading);
        } else {
            Q_EMIT read(reading);
        }
        return;
    }
    m_trouble = QStringLiteral("%1: %2").arg(m_line->name(), answered.error().text);
    if (answered.error().code == ErrorCode::Refused) {
        connectAnew();
    }
}

void FollowedRotctld::connectAnew()
{
    m_line->close();  // and tick() opens it
}

void FollowedRotctld::giveUp()
{
    const QString why = m_trouble.isEmpty() ? Text::tr("%1 does not answer").arg(m_line->name()) : m_trouble;
    close();
    answer(failure(ErrorCode::NoAnswer, why));
}

// Who is answered may ask for another one.
void FollowedRotctld::answer(const Result<RotatorReading>& first)
{
    if (const Then then = std::exchange(m_then, {})) {
        then(first);
    }
}

}  // namespace boresight::rotctl

#include "moc_followed_rotctld.cpp"
