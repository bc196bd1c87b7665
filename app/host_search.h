// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/can/can_link.h"
#include "core/gpredict/gpredict_qth.h"
#include "core/messages/rotator_models.h"
#include "core/messages/scan_result.h"
#include "core/station/adapters.h"

#include <QObject>
#include <QThread>
#include <QThreadPool>

#include <functional>
#include <memory>

// Looks at this computer for the window, without ever making it wait: which adapters and models of rotators there are,
// who answers on one that no station works on, and what a Gpredict here knows. Lives on the main thread; each answer is
// a signal on it.
namespace boresight::app {

class HostSearch : public QObject
{
    Q_OBJECT

public:
    using MakeLink = std::function<Result<std::unique_ptr<CanLink>>(const std::string& bus, const Clock& clock)>;

    explicit HostSearch(MakeLink makeLink, QObject* parent = nullptr);
    ~HostSearch() override;  // ends a scan

public Q_SLOTS:
    void findAdapters(const QString& namedBus);
    void findRotatorModels();
    void findGpredict(const QString& folder);
    // Only asks: nothing moves. One at a time; a second while one runs is answered by a problem.
    void scan(const QString& bus);

Q_SIGNALS:
    void adaptersFound(const std::vector<boresight::Adapter>& adapters);
    void rotatorModelsFound(const boresight::RotatorModels& models);
    void gpredictFound(const boresight::profile::GpredictFiles& files);
    void scanned(const boresight::ScanResult& result);

private:
    struct Scan;

    void endScan(const ScanResult& result);

    MakeLink m_makeLink;
    std::unique_ptr<Scan> m_scan;
    QThreadPool m_files;
};

}  // namespace boresight::app
