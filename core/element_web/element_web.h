// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/element_web/element_cache.h"
#include "core/element_web/element_download.h"

#include <QNetworkAccessManager>
#include <QObject>
#include <QStringList>
#include <QTimer>

#include <chrono>
#include <memory>
#include <optional>
#include <vector>

// Keeps the element sets of some addresses in the cache fresh. Reads and writes files and checks answers on the thread
// on which it lives, so whoever must not wait gives it one of its own.
namespace boresight::orbit {

class ElementWeb final : public QObject
{
    Q_OBJECT

public:
    // No address is asked more often, whatever came of it and however often a program starts: CelesTrak has new
    // elements every two hours, and shuts out who asks more often or goes on after refusals.
    static constexpr std::chrono::hours kPeriod{2};
    static constexpr std::chrono::hours kLongestPeriod{8};  // after failures
    static constexpr std::chrono::minutes kLook{1};
    // Where no name of a server is known, no server was asked.
    static constexpr std::chrono::minutes kAfterNoNetwork{5};

    // The clock outlives this.
    ElementWeb(const Clock& clock, const QString& folder, QObject* parent = nullptr);
    // Asks by this network.
    ElementWeb(const Clock& clock, const QString& folder, std::unique_ptr<QNetworkAccessManager> network,
               QObject* parent = nullptr);
    ~ElementWeb() override;

    // Asks those that are due, now and later. What is not among them any more is not asked further.
    void setAddresses(const std::vector<ElementAddress>& addresses);

    // A server is being asked.
    [[nodiscard]] bool isBusy() const;
    // Of each address with a problem a line, with what the cache has in its place.
    [[nodiscard]] const QStringList& problems() const { return m_problems; }

Q_SIGNALS:
    void stored();  // new sets are in the cache
    void problemsChanged(const QStringList& problems);
    void idle();  // what was due has been asked

private:
    struct Source
    {
        ElementAddress address;
        CacheState state;
        std::unique_ptr<ElementDownload> download;  // null: is not asked now
        std::optional<UtcTime> triedBefore;
        std::optional<SteadyTime> notBefore;
        QString cacheProblem;
        QString told;  // of problems(); stays while it is asked
    };

    void look();
    [[nodiscard]] bool isDue(Source& source);
    void ask(Source& source);
    void take(const QString& file, const DownloadAnswer& answer);
    void judge(Source& source, const DownloadAnswer& answer);
    [[nodiscard]] Result<> store(Source& source, const DownloadAnswer& answer);
    void keepState(Source& source);
    void tell();
    [[nodiscard]] QString problemOf(const Source& source) const;

    const Clock& m_clock;
    ElementCache m_cache;
    std::unique_ptr<QNetworkAccessManager> m_network;
    QTimer m_timer{this};
    std::vector<Source> m_sources;
    QStringList m_problems;
};

}  // namespace boresight::orbit
