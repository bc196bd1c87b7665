// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/passes/pass_searcher.h"

#include "core/passes/pass_finder.h"

#include <algorithm>
#include <utility>

namespace boresight::ui {

namespace {

std::shared_ptr<const PassBook> bookOf(const PassQuery& query, const std::vector<passes::PassList>& lists)
{
    auto book = std::make_shared<PassBook>();
    book->satellites = query.satellites;
    book->site = query.search.site;
    book->antenna = query.antenna;
    for (const auto& [number, own] : query.own) {
        book->own[number] = own.antenna;
    }
    for (std::size_t satellite = 0; satellite < lists.size(); ++satellite) {
        for (const passes::Pass& pass : lists[satellite].passes) {
            book->passes.push_back({.satellite = satellite, .pass = pass});
        }
    }
    std::ranges::stable_sort(book->passes, {}, [](const BookedPass& one) { return one.pass.aos.utc; });
    return book;
}

}  // namespace

PassSearcher::PassSearcher(QObject* parent) : QObject(parent)
{
    m_pool.setMaxThreadCount(1);
    m_pool.setThreadPriority(QThread::LowestPriority);
}

PassSearcher::~PassSearcher()
{
    m_stop.request_stop();
    m_pool.waitForDone();
}

void PassSearcher::search(const PassQuery& query)
{
    m_stop.request_stop();
    m_stop = std::stop_source();
    m_searching = true;
    m_pool.start([this, query, stop = m_stop.get_token()] {
        std::vector<passes::SatelliteSearch> searches;
        searches.reserve(query.satellites->size());
        for (const orbit::ElementSet& set : *query.satellites) {
            searches.push_back({.orbit = orbit::Sgp4(set), .search = query.search});
            if (const auto own = query.own.find(set.number); own != query.own.end()) {
                searches.back().search.isClear = own->second.isClear;
            }
        }
        const auto tell = [&, last = -1](std::size_t finished) mutable {
            const int percent = static_cast<int>(100 * finished / searches.size());
            if (percent != std::exchange(last, percent)) {
                QMetaObject::invokeMethod(this, [this, stop, percent] {
                    if (!stop.stop_requested()) {
                        Q_EMIT progressed(percent);
                    }
                });
            }
        };
        const auto book = bookOf(query, passes::findPasses(searches, stop, tell));
        QMetaObject::invokeMethod(this, [this, stop, book] {
            if (!stop.stop_requested()) {
                m_searching = false;
                Q_EMIT found(book);
            }
        });
    });
}

}  // namespace boresight::ui

#include "moc_pass_searcher.cpp"
