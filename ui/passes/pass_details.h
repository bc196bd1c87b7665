// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/passes/pass_light.h"
#include "core/targets/cable_turns.h"
#include "ui/passes/pass_book.h"

#include <QObject>
#include <QTimer>

#include <deque>
#include <memory>
#include <unordered_map>

// What takes some milliseconds to work out of a pass: only of the passes that are looked at, once, and never while they
// are painted. Gui thread.
namespace boresight::ui {

// Whether the mount tracks it in one go.
[[nodiscard]] targets::CableTurns cableOf(const BookedPass& one, const PassBook& book);

class PassDetails : public QObject
{
    Q_OBJECT

public:
    struct Facts
    {
        passes::PassLight light;
        Seconds sunlit{0.0};
        targets::CableTurns cable;
    };

    static constexpr std::size_t kMostKept = 500;
    static constexpr std::size_t kMostWanted = 100;  // more rows are never seen at once

    explicit PassDetails(QObject* parent = nullptr);

    void begin(const std::shared_ptr<const PassBook>& book);
    // By the number of the pass in the book. Null: not yet. It is worked out when the window has nothing else to do.
    [[nodiscard]] const Facts* find(std::size_t pass);

    [[nodiscard]] std::size_t kept() const { return m_facts.size(); }
    [[nodiscard]] std::size_t wanted() const { return m_wanted.size(); }

Q_SIGNALS:
    void workedOut(std::size_t pass);

private:
    void workOne();

    std::shared_ptr<const PassBook> m_book;
    std::unordered_map<std::size_t, Facts> m_facts;
    std::deque<std::size_t> m_order;   // of m_facts, the oldest first
    std::deque<std::size_t> m_wanted;  // the newest first: what was scrolled past comes last
    QTimer m_idle;                     // without a parent: it waits for no time, so no test turns it
};

}  // namespace boresight::ui
