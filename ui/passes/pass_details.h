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

// Facts of a pass that take some milliseconds to compute. They are computed once, only for passes that are shown, and
// never while the window paints. Gui thread.
namespace boresight::ui {

// Whether the cable lets the mount track the whole pass without a turn back.
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
    static constexpr std::size_t kMostWanted = 100;  // more rows are never visible at the same time

    explicit PassDetails(QObject* parent = nullptr);

    void begin(const std::shared_ptr<const PassBook>& book);
    // `pass`: index in the book. Null: not computed yet. Then it is computed as soon as the window has nothing else to
    // do.
    [[nodiscard]] const Facts* find(std::size_t pass);

    [[nodiscard]] std::size_t kept() const { return m_facts.size(); }
    [[nodiscard]] std::size_t wanted() const { return m_wanted.size(); }

Q_SIGNALS:
    void workedOut(std::size_t pass);

private:
    void workOne();

    std::shared_ptr<const PassBook> m_book;
    std::unordered_map<std::size_t, Facts> m_facts;
    std::deque<std::size_t> m_order;   // keys of m_facts, the oldest first
    std::deque<std::size_t> m_wanted;  // the newest first, because rows that were scrolled away can wait
    QTimer m_idle;                     // without a parent, so tests that find and fire timers do not find this one
};

}  // namespace boresight::ui
