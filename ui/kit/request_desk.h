// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/request.h"
#include "core/messages/station_status.h"

#include <QObject>
#include <QPointer>

#include <functional>
#include <map>
#include <optional>
#include <vector>

// Numbers every request of the window, and passes the answer of the station to the control that asked. Gui thread.
namespace boresight::ui {

class RequestDesk : public QObject
{
    Q_OBJECT

public:
    using Reply = std::function<void(const std::optional<Error>&)>;
    using WholeReply = std::function<void(const Answer&)>;

    using QObject::QObject;

    // `reply` is called once, unless `asker` was deleted meanwhile.
    void send(const Request& request, QObject* asker, const Reply& reply);
    // The same for a question, whose answer is more than yes or no.
    void ask(const Request& question, QObject* asker, WholeReply reply);
    void take(const std::vector<Answer>& answers);

Q_SIGNALS:
    void requested(const boresight::NumberedRequest& request);

private:
    struct Waiting
    {
        QPointer<QObject> asker;
        WholeReply reply;
    };

    void answer(std::map<std::uint64_t, Waiting>::iterator waiting, const Answer& answer);

    std::map<std::uint64_t, Waiting> m_waiting;
    std::uint64_t m_last = 0;
};

}  // namespace boresight::ui
