// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guide/guide_connect.h"

#include "core/profile/commissioning.h"
#include "ui/guide/bus_picture.h"
#include "ui/guide/guide_boards.h"
#include "ui/guide/rotator_choice.h"
#include "ui/kit/axes.h"
#include "ui/kit/command_button.h"
#include "ui/kit/format.h"
#include "ui/kit/push_button.h"
#include "ui/kit/value_label.h"
#include "ui/link/drive_check_words.h"
#include "ui/link/host_desk.h"

#include <QListWidget>
#include <QPlainTextEdit>
#include <QVBoxLayout>

#include <algorithm>

namespace boresight::ui {

namespace {

QString quantity(const std::optional<double>& value, const QString& unit)
{
    return value ? QStringLiteral("%1 %2").arg(*value, 0, 'f', 1).arg(unit) : QStringLiteral("---");
}

QString line(const ScannedDrive& drive)
{
    return GuideConnect::tr("id %1: %2, %3, firmware %4")
        .arg(drive.id)
        .arg(quantity(drive.voltage, QStringLiteral("V")), quantity(drive.temperature, QStringLiteral("°C")),
             drive.firmware.isEmpty() ? QStringLiteral("---") : drive.firmware);
}

QString line(const StationStatus& status, Axis axis)
{
    const AxisStatus& one = axisOf(status, axis);
    const int id = status.profile->axis(axis).id;
    if (freshness(one.age) == Freshness::NoData) {
        return GuideConnect::tr("%1, id %2: no answer").arg(name(axis)).arg(id);
    }
    return GuideConnect::tr("%1, id %2: %3, %4")
        .arg(name(axis))
        .arg(id)
        .arg(quantity(one.busVoltage, QStringLiteral("V")), quantity(one.boardTemperature, QStringLiteral("°C")));
}

// Empty if the mount has no such drives.
QStringList linesOfDrives(const StationStatus& status)
{
    QStringList lines;
    if (status.drives) {
        for (const Axis axis : kAxes) {
            if (driveOf(status, axis).present) {
                lines << line(status, axis);
            }
        }
        for (const UnknownBoard& one : status.drives->unknownBoards) {
            lines << GuideConnect::tr("id %1: not in the profile").arg(one.id);
        }
    }
    return lines;
}

// Marks each simulated drive, because it answers like a real one.
QStringList tagged(QStringList drives, bool simulated)
{
    if (simulated) {
        for (QString& drive : drives) {
            drive = GuideConnect::tr("%1 (simulated)").arg(drive);
        }
    }
    return drives;
}

}  // namespace

GuideConnect::GuideConnect(ProfileChange& change, RequestDesk& desk, HostDesk& host, QWidget* parent)
    : QWidget(parent),
      m_change(change),
      m_host(host),
      m_notice(new ValueLabel(tr("Refused"), fonts::label(), {}, this)),
      m_choice(new RotatorChoice(host.rotators(), this)),
      m_list(new QListWidget(this)),
      m_found(new QPlainTextEdit(this)),
      m_picture(new BusPicture(this)),
      m_boards(new GuideBoards(desk, this)),
      m_refresh(makePushButton({.text = tr("Refresh"), .help = tr("List the adapters again, after one was plugged in")},
                               this)),
      m_scan(new CommandButton(tr("Scan"), tr("List the drives on the selected bus. Nothing moves"), desk, *m_notice,
                               this)),
      m_use(new CommandButton(tr("Connect"), tr("Connect to the mount by the selected adapter"), desk, *m_notice, this))
{
    build();
    connect(m_refresh, &QPushButton::clicked, this, [this] { Q_EMIT m_host.adaptersWanted(busInUse()); });
    connect(m_refresh, &QPushButton::clicked, m_choice, &RotatorChoice::refreshModels);
    connect(m_choice, &RotatorChoice::modelsWanted, &m_host, &HostDesk::rotatorModelsWanted);
    connect(&m_host, &HostDesk::rotatorModelsFound, m_choice, &RotatorChoice::showModels);
    connect(m_scan, &QPushButton::clicked, this, &GuideConnect::scan);
    connect(m_use, &QPushButton::clicked, this, &GuideConnect::use);
    connect(m_choice, &RotatorChoice::changed, this, &GuideConnect::showButtons);
    connect(m_list, &QListWidget::currentRowChanged, this, &GuideConnect::showButtons);
    connect(m_boards, &AskingPanel::currentChanged, this, &GuideConnect::showButtons);
    connect(&m_host, &HostDesk::adaptersFound, this, &GuideConnect::showAdapters);
    connect(&m_host, &HostDesk::scanned, this, &GuideConnect::showResult);
}

void GuideConnect::build()
{
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    m_list->setFont(fonts::label());
    m_list->setAccessibleName(tr("Adapters of this computer"));
    m_list->setWordWrap(true);
    m_list->setResizeMode(QListView::Adjust);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setMinimumHeight(3 * m_list->fontMetrics().lineSpacing() + 8);
    m_found->setFont(fonts::label());
    m_found->setReadOnly(true);
    m_found->setTabChangesFocus(true);
    m_found->setAccessibleName(tr("Who answers"));
    m_found->setMinimumHeight(3 * m_found->fontMetrics().lineSpacing() + 8);
    m_refresh->setMinimumSize(m_scan->minimumSizeHint());
    m_notice->setStretching(true);
    m_notice->setCollapsing(true);
    auto* const row = new QHBoxLayout;
    row->setSpacing(4);
    for (QPushButton* const button : {m_refresh, static_cast<QPushButton*>(m_scan), static_cast<QPushButton*>(m_use)}) {
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        row->addWidget(button);
    }
    column->addWidget(m_choice);
    column->addWidget(m_list, 2);
    auto* const who = new QHBoxLayout;
    who->addWidget(m_found, 1);
    who->addWidget(m_picture, 0, Qt::AlignTop);
    column->addLayout(who, 1);
    column->addWidget(m_boards, 2);
    m_boards->hide();
    column->addLayout(row);
    column->addWidget(m_notice);
}

void GuideConnect::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    if (m_adapters.empty()) {
        Q_EMIT m_host.adaptersWanted(busInUse());
    }
}

void GuideConnect::showAdapters(const std::vector<Adapter>& adapters)
{
    // The bus of the command line is known only with the first status, which may come after the first list. A rotator
    // in use is in neither list.
    const bool isListed = std::ranges::find(m_adapters, busInUse(), &Adapter::bus) != m_adapters.end();
    const bool isChosen = !m_adapters.empty() && !m_status.drives;
    const QString selected = isListed || isChosen ? selectedBus() : busInUse();
    m_choice->showAdapters(adapters);
    m_adapters.clear();
    std::ranges::copy_if(adapters, std::back_inserter(m_adapters), &Adapter::hasDrives);
    m_list->clear();
    for (const Adapter& adapter : m_adapters) {
        QString text = adapter.recognised ? adapter.name : tr("%1 (unknown to Boresight)").arg(adapter.name);
        text += QStringLiteral("  ·  ") + adapter.detail;
        if (adapter.simulated) {
            text = tr("SIMULATED  ·  %1").arg(text);
        }
        auto* const item = new QListWidgetItem(text, m_list);
        item->setToolTip(adapter.bus);
    }
    auto at = std::ranges::find(m_adapters, selected, &Adapter::bus);
    if (at == m_adapters.end()) {
        at = std::ranges::find(m_adapters, true, &Adapter::recognised);  // the operator has to choose any other device
    }
    m_list->setCurrentRow(at == m_adapters.end() ? -1 : static_cast<int>(at - m_adapters.begin()));
    showButtons();
}

QString GuideConnect::selectedBus() const
{
    const int row = m_list->currentRow();
    return row >= 0 && row < static_cast<int>(m_adapters.size()) ? m_adapters[static_cast<std::size_t>(row)].bus
                                                                 : QString();
}

bool GuideConnect::isSimulated(const QString& bus) const
{
    const auto adapter = std::ranges::find(m_adapters, bus, &Adapter::bus);
    return adapter != m_adapters.end() && adapter->simulated;
}

QString GuideConnect::busInUse() const
{
    return m_status.simulated ? QStringLiteral("simulated") : QString::fromStdString(m_status.profile->bus);
}

void GuideConnect::showStatus(const StationStatus& status)
{
    const QString before = busInUse();
    m_status = status;
    m_choice->showStatus(status);
    for (int row = 0; row < m_list->count(); ++row) {
        QFont font = fonts::label();
        font.setBold(m_adapters[static_cast<std::size_t>(row)].bus == busInUse());
        if (m_list->item(row)->font() != font) {
            m_list->item(row)->setFont(font);
        }
    }
    if (busInUse() != before) {
        m_result.reset();  // the result belongs to the previous bus
        Q_EMIT m_host.adaptersWanted(busInUse());
    }
    showButtons();
}

void GuideConnect::showButtons()
{
    const QString bus = selectedBus();
    const bool inUse = bus == busInUse();
    const bool listed = m_choice->isListed();
    const bool asks = m_boards->isAsking();  // the question about a board has all the room
    m_choice->setHidden(asks);
    m_use->setHidden(asks);
    m_list->setVisible(listed && !asks);
    m_scan->setVisible(listed && !asks);
    m_refresh->setVisible((listed || m_choice->onSerialPort()) && !asks);
    const QString none = !listed         ? m_choice->whyIncomplete()
                         : bus.isEmpty() ? tr("Select an adapter first.")
                                         : QString();
    m_scan->setBlocked(!none.isEmpty()         ? none
                       : !m_scanning.isEmpty() ? tr("Boresight is scanning %1. Wait a moment.").arg(m_scanning)
                       : inUse                 ? m_status.permissions.reason(Action::ReadDrives)
                                               : QString());
    const auto take = useSelected();
    m_use->setBlocked(!none.isEmpty()            ? none
                      : m_change.isAlready(take) ? whyAlready()
                                                 : m_change.whyNot(m_status, take));
    showFound();
    showBoards();
}

// The reason why nothing is left to apply.
QString GuideConnect::whyAlready() const
{
    if (m_choice->isListed()) {
        return tr("The mount is already connected by this adapter.");
    }
    return m_status.state == StationState::Disconnected
               ? tr("These settings are in force. Press Reconnect to try again (tab Mount, Profile).")
               : tr("This rotator is already connected.");
}

void GuideConnect::showBoards()
{
    const bool listed = m_choice->isListed();
    const bool here = selectedBus().isEmpty() || selectedBus() == busInUse();
    const bool needed = m_boards->isAsking() || (here && listed && GuideBoards::isNeeded(m_status));
    m_boards->setVisible(needed);
    m_found->setVisible(!needed);
    m_picture->setVisible(!needed && listed && m_status.drives);
    if (needed) {
        m_boards->showStatus(m_status);
    }
}

// If the simulated mount is in use, the bus in the profile stays.
ProfileChange::Edit GuideConnect::useSelected() const
{
    if (!m_choice->isListed()) {
        return m_choice->edit();
    }
    const std::string bus = selectedBus() == busInUse() ? m_status.profile->bus : selectedBus().toStdString();
    return [bus, ids = idsFound()](profile::Profile& profile) { profile::useBus(profile, bus, ids); };
}

// The ids that were found on the selected bus. Which drive turns which axis shows when they move.
std::vector<int> GuideConnect::idsFound() const
{
    std::vector<int> ids;
    const bool ownSilent = std::ranges::all_of(kAxes, [this](Axis axis) {
        return !driveOf(m_status, axis).present || freshness(axisOf(m_status, axis).age) == Freshness::NoData;
    });
    if (selectedBus() == busInUse() && ownSilent) {
        std::ranges::transform(drivesOf(m_status).unknownBoards, std::back_inserter(ids), &UnknownBoard::id);
    } else if (m_result && m_result->bus == selectedBus()) {
        std::ranges::transform(m_result->drives, std::back_inserter(ids), &ScannedDrive::id);
    }
    return ids;
}

void GuideConnect::showFound()
{
    QStringList lines;
    if (!m_choice->isListed()) {
        lines = m_choice->words(m_use->obstacle());
    } else if (selectedBus() == busInUse()) {
        lines << (m_status.drives ? tr("In use. %1.").arg(driveCheckSentence(*m_status.drives).text)
                                  : tr("In use. This rotator has no boards that can be listed."));
        lines << tagged(linesOfDrives(m_status), isSimulated(selectedBus()));
    } else if (selectedBus() == m_scanning) {
        lines << tr("Scanning …");
    } else if (m_result && m_result->bus == selectedBus()) {
        QStringList drives;
        for (const ScannedDrive& one : m_result->drives) {
            drives << line(one);
        }
        lines << tagged(drives, m_result->simulated);
        lines << m_result->problems;
    } else {
        lines << tr("Press Scan to list the drives on this bus. Scanning moves nothing.");
    }
    const QString text = lines.join(QLatin1Char('\n'));
    if (text != m_found->toPlainText()) {
        m_found->setPlainText(text);
    }
}

void GuideConnect::scan()
{
    if (selectedBus() == busInUse()) {
        m_scan->ask(request::ReadDrives{});
        return;
    }
    m_scanning = selectedBus();
    m_result.reset();
    showButtons();
    Q_EMIT m_host.scanWanted(m_scanning);
}

void GuideConnect::showResult(const ScanResult& result)
{
    m_scanning.clear();
    m_result = result;
    showButtons();
}

void GuideConnect::use()
{
    m_change.ask(*m_use, useSelected());
}

}  // namespace boresight::ui

#include "moc_guide_connect.cpp"
