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

// Searches this computer for the window without delaying it: which adapters and models of rotators there are, which
// drives answer on a bus that no station uses, and what Gpredict on this computer knows. Lives on the main thread; each
// answer is a signal on that thread.
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
    // Sends only queries: nothing moves. One scan at a time. A second call during a scan is answered with a problem.
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
