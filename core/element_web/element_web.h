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

// Keeps the element sets of some addresses in the cache up to date. It reads and writes files and checks answers on its
// own thread, so give it a separate thread if the caller must not wait.
namespace boresight::orbit {

class ElementWeb final : public QObject
{
    Q_OBJECT

public:
    // No address is requested more often, whatever the result and however often a program starts. CelesTrak publishes
    // new elements every two hours. It blocks clients that ask more often or that continue after a refusal.
    static constexpr std::chrono::hours kPeriod{2};
    static constexpr std::chrono::hours kLongestPeriod{8};  // after failures
    static constexpr std::chrono::minutes kLook{1};
    // If the name of a server cannot be resolved, no server was reached.
    static constexpr std::chrono::minutes kAfterNoNetwork{5};

    // The clock must outlive this object.
    ElementWeb(const Clock& clock, const QString& folder, QObject* parent = nullptr);
    // Uses this network manager.
    ElementWeb(const Clock& clock, const QString& folder, std::unique_ptr<QNetworkAccessManager> network,
               QObject* parent = nullptr);
    ~ElementWeb() override;

    // Requests the addresses that are due, now and later. Addresses that are not in the list are no longer requested.
    void setAddresses(const std::vector<ElementAddress>& addresses);

    // A request is running.
    [[nodiscard]] bool isBusy() const;
    // One line for each address with a problem. The line names what the cache has instead.
    [[nodiscard]] const QStringList& problems() const { return m_problems; }

Q_SIGNALS:
    void stored();  // new sets are in the cache
    void problemsChanged(const QStringList& problems);
    void idle();  // all due requests are finished

private:
    struct Source
    {
        ElementAddress address;
        CacheState state;
        std::unique_ptr<ElementDownload> download;  // null: no request is running
        std::optional<UtcTime> triedBefore;
        std::optional<SteadyTime> notBefore;
        QString cacheProblem;
        QString told;  // the line in problems(); stays during a request
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
