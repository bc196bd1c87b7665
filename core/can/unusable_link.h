// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/can/can_link.h"

// The bus of a name that means no bus. It never opens and reports why. So a station can always be built: it shows the
// fault, and another mount or bus can be chosen.
namespace boresight {

class UnusableLink : public CanLink
{
    Q_OBJECT

public:
    UnusableLink(QString name, Error why, QObject* parent = nullptr);

    [[nodiscard]] QString name() const override { return m_name; }
    [[nodiscard]] LinkStatus status() const override;
    Result<> open() override;
    void close() override {}
    Result<> send(std::span<const CanFrame> frames) override;

private:
    QString m_name;
    Error m_why;
};

}  // namespace boresight
