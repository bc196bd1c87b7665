// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/can/can_link.h"

#include <vector>

// A bus that the test controls. It keeps the frames that were sent.
namespace boresight::fakes {

class FakeCanLink final : public CanLink
{
    Q_OBJECT

public:
    [[nodiscard]] QString name() const override { return QStringLiteral("fake"); }
    [[nodiscard]] LinkStatus status() const override { return linkStatus; }
    Result<> open() override
    {
        ++openings;
        if (!openError.isEmpty()) {
            return failure(ErrorCode::NoDevice, openError);
        }
        linkStatus = {.state = LinkState::Up};
        return {};
    }
    void close() override { linkStatus.state = LinkState::Closed; }
    Result<> send(std::span<const CanFrame> frames) override
    {
        sent.insert(sent.end(), frames.begin(), frames.end());
        return {};
    }
    void report(const LinkStatus& news)
    {
        linkStatus = news;
        Q_EMIT statusChanged(linkStatus);
    }

    LinkStatus linkStatus;
    QString openError;
    int openings = 0;
    std::vector<CanFrame> sent;
};

}  // namespace boresight::fakes
