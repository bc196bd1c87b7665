// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/host_search.h"

#include "app/link_scan.h"
#include "app/scan_report.h"
#include "core/base/text.h"
#include "core/moteus/describe.h"
#include "core/station/mount_factory.h"

namespace boresight::app {
namespace {

using moteus::Register;

ScannedDrive described(const drive_check::FoundController& found)
{
    const auto uuid = found.known.uuid();
    return {.id = found.id,
            .uuid = uuid ? QString::fromStdString(moteus::uuidText(*uuid)) : QString(),
            .firmware = QString::fromStdString(moteus::firmwareText(found.known)),
            .voltage = found.known.value(Register::Voltage),
            .temperature = found.known.value(Register::Temperature)};
}

ScanResult resultOf(const QString& bus, const std::vector<drive_check::FoundController>& found)
{
    ScanResult result{.bus = bus, .drives = {}, .problems = problems(found), .simulated = isSimulatedBus(bus)};
    for (const drive_check::FoundController& one : found) {
        result.drives.push_back(described(one));
    }
    if (found.empty()) {
        result.problems << silenceText(bus);
    }
    return result;
}

}  // namespace

// The thread of one scan, with the link and the scan that live on this thread.
struct HostSearch::Scan
{
    QThread thread;
    SystemClock clock;
    std::unique_ptr<QObject> context = std::make_unique<QObject>();  // lives on the thread
    std::unique_ptr<CanLink> link;
    std::unique_ptr<LinkScan> scan;

    ~Scan()
    {
        thread.quit();
        thread.wait();
    }

    void clear()  // on the thread
    {
        scan.reset();
        link.reset();
        context.reset();
    }

    // Runs on the thread of the scan, and calls `done` there.
    void begin(const QString& bus, const MakeLink& makeLink, const std::function<void(const ScanResult&)>& done)
    {
        const auto fail = [&](const QString& why) { done({.bus = bus, .drives = {}, .problems = {why}}); };
        auto made = makeLink(bus.toStdString(), clock);
        if (!made) {
            return fail(made.error().text);
        }
        link = std::move(*made);
        const Result<> opened = mayBeScanned(bus).and_then([this] { return link->open(); });
        if (!opened) {
            return fail(opened.error().text);
        }
        if (link->status().state != LinkState::Up) {
            return fail(link->status().text);
        }
        scan = std::make_unique<LinkScan>(*link);
        QObject::connect(scan.get(), &LinkScan::finished, context.get(), [this, bus, done](const QString& problem) {
            done(problem.isEmpty() ? resultOf(bus, scan->controllers())
                                   : ScanResult{.bus = bus, .drives = {}, .problems = {problem}});
        });
        scan->start();
    }
};

HostSearch::HostSearch(MakeLink makeLink, QObject* parent) : QObject(parent), m_makeLink(std::move(makeLink))
{
    qRegisterMetaType<std::vector<Adapter>>();
    qRegisterMetaType<profile::GpredictFiles>();
    qRegisterMetaType<RotatorModels>();
    qRegisterMetaType<ScanResult>();
    m_files.setMaxThreadCount(1);
}

HostSearch::~HostSearch()
{
    m_files.waitForDone();
}

void HostSearch::findAdapters(const QString& namedBus)
{
    m_files.start([this, namedBus] { Q_EMIT adaptersFound(withNamed(boresight::findAdapters(), namedBus)); });
}

void HostSearch::findRotatorModels()
{
    m_files.start([this] { Q_EMIT rotatorModelsFound(rotatorModels()); });
}

void HostSearch::findGpredict(const QString& folder)
{
    m_files.start([this, folder] { Q_EMIT gpredictFound(profile::findGpredict(folder)); });
}

void HostSearch::scan(const QString& bus)
{
    if (m_scan) {
        Q_EMIT scanned(
            {.bus = bus, .drives = {}, .problems = {Text::tr("Boresight is scanning another bus. Wait a moment.")}});
        return;
    }
    m_scan = std::make_unique<Scan>();
    Scan* const scan = m_scan.get();
    scan->context->moveToThread(&scan->thread);
    const auto done = [this](const ScanResult& result) {
        QMetaObject::invokeMethod(
            this, [this, result] { endScan(result); }, Qt::QueuedConnection);
    };
    connect(&scan->thread, &QThread::started, scan->context.get(),
            [scan, bus, done, makeLink = m_makeLink] { scan->begin(bus, makeLink, done); });
    // Objects that live on the thread must end on it.
    connect(
        &scan->thread, &QThread::finished, scan->context.get(), [scan] { scan->clear(); }, Qt::DirectConnection);
    scan->thread.setObjectName(QStringLiteral("scan"));
    scan->thread.start();
}

// The adapter is released before the result is reported, because the receiver may use the adapter next.
void HostSearch::endScan(const ScanResult& result)
{
    m_scan.reset();
    Q_EMIT scanned(result);
}

}  // namespace boresight::app

#include "moc_host_search.cpp"
