// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/passes/pass_book.h"

#include <QObject>
#include <QThreadPool>

#include <functional>
#include <map>
#include <memory>
#include <stop_token>

// Finds the passes of many satellites on another thread, with the lowest priority. A new search cancels the previous
// one. The result arrives on the gui thread. Gui thread.
namespace boresight::ui {

// For a satellite that is tracked with its own antenna.
struct OwnAntenna
{
    PassAntenna antenna;
    std::function<bool(const SkyPointing&)> isClear;
};

struct PassQuery
{
    Satellites satellites;
    passes::PassSearch search;
    PassAntenna antenna;
    std::map<std::int64_t, OwnAntenna> own;  // by satellite number
};

class PassSearcher : public QObject
{
    Q_OBJECT

public:
    explicit PassSearcher(QObject* parent = nullptr);
    ~PassSearcher() override;

    void search(const PassQuery& query);
    [[nodiscard]] bool isSearching() const { return m_searching; }

Q_SIGNALS:
    void progressed(int percent);
    void found(const std::shared_ptr<const boresight::ui::PassBook>& book);

private:
    QThreadPool m_pool;
    std::stop_source m_stop;
    bool m_searching = false;
};

}  // namespace boresight::ui
