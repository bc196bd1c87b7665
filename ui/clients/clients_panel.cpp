// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/clients/clients_panel.h"

#include "core/base/peer_address.h"
#include "ui/clients/client_model.h"
#include "ui/clients/gpredict_settings.h"
#include "ui/kit/caption.h"
#include "ui/kit/choice_button.h"
#include "ui/kit/command_button.h"
#include "ui/kit/push_button.h"
#include "ui/kit/read_table.h"
#include "ui/kit/value_label.h"
#include "ui/kit/widest.h"

#include <QApplication>
#include <QButtonGroup>
#include <QClipboard>
#include <QHeaderView>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace boresight::ui {

namespace {
constexpr int kCellMargins = 10;  // px beside the text of a cell, on both sides together
const QString kWidestCommand = QStringLiteral("P 000.00 -00.00");
const QString kWidestProgram = QStringLiteral("boresightctl");

QString whyNoClient(const ClientStatus* client)
{
    return client == nullptr ? ClientsPanel::tr("Select a client first.") : QString();
}

QString addressAndOdd(const ClientStatus& client)
{
    return client.oddCommands == 0
               ? client.address
               : ClientsPanel::tr("%1 (odd commands: %2)").arg(client.address, QString::number(client.oddCommands));
}

}  // namespace

ClientsPanel::ClientsPanel(ProfileDraft& draft, RequestDesk& desk, QWidget* parent)
    : QWidget(parent),
      m_draft(draft),
      m_model(new ClientModel(this)),
      m_table(makeTable()),
      m_access(new ValueLabel(tr("Who may connect"), fonts::label(), {}, this)),
      m_broker(new ValueLabel(tr("MQTT broker"), fonts::label(), {}, this)),
      m_detail(new ValueLabel(tr("About the selected client"), fonts::label(), {}, this)),
      m_notice(new ValueLabel(tr("Refused"), fonts::label(), {}, this)),
      m_gpredict(new ValueLabel(tr("Settings for Gpredict"), fonts::label(), {}, this)),
      m_first(new ChoiceButton(
          tr("First"), tr("The first client moves the mount until it disconnects or commands no motion for 10 s"),
          this)),
      m_last(new ChoiceButton(tr("Last"), tr("The client that sent the last target moves the mount, as with Hamlib"),
                              this)),
      m_locked(new ChoiceButton(tr("Locked"), tr("Only the host of the selected client moves the mount"), this)),
      m_give(new CommandButton(tr("Give control"), tr("The selected client moves the mount from now on"), desk,
                               *m_notice, this)),
      m_readOnly(
          new CommandButton(tr("Read-only"), tr("The selected client may only read and stop"), desk, *m_notice, this)),
      m_disconnect(new CommandButton(tr("Disconnect"), tr("Close the connection. The program may connect again"), desk,
                                     *m_notice, this)),
      m_lock(new CommandButton(tr("Lock"), tr("Only programs on the host of the selected client move the mount"), desk,
                               *m_notice, this))
{
    build();
    connectButtons();
}

void ClientsPanel::build()
{
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(6, 6, 6, 6);
    column->setSpacing(4);
    auto* const buttons = new QHBoxLayout;
    buttons->setSpacing(4);
    for (CommandButton* const button : {m_give, m_readOnly, m_disconnect, m_lock}) {
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        buttons->addWidget(button);
    }
    for (ValueLabel* const line : {m_access, m_broker, m_detail, m_notice, m_gpredict}) {
        line->setStretching(true);
    }
    m_detail->setLines(2);
    m_gpredict->setLines(2);
    m_notice->setCollapsing(true);
    m_broker->setCollapsing(true);
    column->addWidget(makeRules());
    column->addWidget(m_access);
    column->addWidget(m_broker);
    column->addWidget(m_table, 1);
    column->addWidget(m_detail);
    column->addLayout(buttons);
    column->addWidget(m_notice);
    column->addWidget(makeLastRow());
    setTabOrder(m_locked, m_table);
    setTabOrder(m_table, m_give);
}

QWidget* ClientsPanel::makeRules()
{
    auto* const box = new QWidget(this);
    auto* const row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    row->addWidget(makeCaption(tr("Control goes to:"), box));
    auto* const group = new QButtonGroup(box);
    for (ChoiceButton* const button : {m_first, m_last, m_locked}) {
        group->addButton(button);
        row->addWidget(button);
    }
    return box;
}

QTableView* ClientsPanel::makeTable()
{
    QTableView* const table = makeReadTable(tr("Clients"), *m_model, this);
    table->setObjectName(QStringLiteral("clients"));
    const QFontMetrics metrics = table->fontMetrics();
    QHeaderView* const header = table->horizontalHeader();
    header->setSectionResizeMode(QHeaderView::Stretch);
    // A header measures its contents only when rows are added or removed, so the widths here leave room for all words.
    const auto reserve = [&](ClientModel::Column column, QStringList texts) {
        texts << m_model->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
        header->setSectionResizeMode(column, QHeaderView::Fixed);
        header->resizeSection(column, metrics.horizontalAdvance(widest(table->font(), texts)) + kCellMargins);
    };
    reserve(ClientModel::Address, {QStringLiteral("000.000.000.000:00000")});
    reserve(ClientModel::Rate,
            {QStringLiteral("00.0"), ClientModel::tr("%1 k", "thousand").arg(QStringLiteral("000"))});
    reserve(ClientModel::Role, roleWords());
    reserve(ClientModel::LastCommand, {kWidestCommand});
    return table;
}

// The name of a program is shown completely. If there is no room beside it, the last command is in the line of the
// selected client and in the tooltip.
void ClientsPanel::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    const QHeaderView& header = *m_table->horizontalHeader();
    int room = layout()->contentsRect().width() - 2 * m_table->frameWidth();
    for (const QString& text : {kWidestProgram, kWidestCommand}) {
        room -= m_table->fontMetrics().horizontalAdvance(text) + kCellMargins;
    }
    for (const int column : {ClientModel::Address, ClientModel::Rate, ClientModel::Role}) {
        room -= header.sectionSize(column);
    }
    m_table->setColumnHidden(ClientModel::LastCommand, room < 0);
}

// The settings for Gpredict, and the way to the protocol log.
QWidget* ClientsPanel::makeLastRow()
{
    auto* const box = new QWidget(this);
    auto* const row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    QPushButton* const copy = makePushButton({.text = tr("Copy"),
                                              .name = tr("Copy the settings for Gpredict"),
                                              .help = tr("The settings for the dialogs of Gpredict")},
                                             box);
    copy->setMinimumWidth(kTouchSize);
    connect(copy, &QPushButton::clicked, this, &ClientsPanel::copySettings);
    m_protocolLog = makePushButton({.text = tr("Protocol …"),
                                    .name = tr("Protocol log"),
                                    .help = tr("What the clients send, what Boresight understands and answers")},
                                   box);
    connect(m_protocolLog, &QPushButton::clicked, this, &ClientsPanel::protocolLogWanted);
    row->addWidget(m_gpredict, 1);
    row->addWidget(copy);
    row->addWidget(m_protocolLog);
    return box;
}

void ClientsPanel::focusProtocolLog()
{
    m_protocolLog->setFocus();
}

void ClientsPanel::connectButtons()
{
    connect(m_first, &ChoiceButton::clicked, this, [this] { choose(profile::ControlRule::First, {}); });
    connect(m_last, &ChoiceButton::clicked, this, [this] { choose(profile::ControlRule::Last, {}); });
    connect(m_locked, &ChoiceButton::clicked, this, &ClientsPanel::lock);
    connect(m_lock, &QPushButton::clicked, this, &ClientsPanel::lock);
    connect(m_give, &QPushButton::clicked, this, [this] {
        if (const ClientStatus* const client = selected()) {
            m_give->ask(request::GiveControl{.clientId = client->id});
        }
    });
    connect(m_readOnly, &QPushButton::clicked, this, [this] {
        if (const ClientStatus* const client = selected()) {
            m_readOnly->ask(request::SetReadOnly{.clientId = client->id, .readOnly = !client->readOnly});
        }
    });
    connect(m_disconnect, &QPushButton::clicked, this, [this] {
        if (const ClientStatus* const client = selected()) {
            m_disconnect->ask(request::Disconnect{.clientId = client->id});
        }
    });
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex& now) {
        if (now.isValid()) {
            m_selected = m_model->client(now.row()).id;
        }
        showSelected();
    });
}

const ClientStatus* ClientsPanel::selected() const
{
    const auto row = m_selected ? m_model->rowOf(*m_selected) : std::nullopt;
    return row ? &m_model->client(*row) : nullptr;
}

void ClientsPanel::showStatus(const StationStatus& status)
{
    m_status = status;
    nameLockedTarget();
    m_model->show(m_status.clients);
    const int row = m_selected ? m_model->rowOf(*m_selected).value_or(-1) : -1;
    if (row >= 0 && row != m_table->currentIndex().row()) {
        m_table->selectRow(row);  // the rows have moved when clients came or left
    }
    m_gpredict->setValue(gpredictInBrief(status), Tone::Secondary);
    showRules();
    showAccess();
    showBroker();
    showSelected();
}

// The points of a client whose target Boresight tracks do not move the mount.
void ClientsPanel::nameLockedTarget()
{
    if (!m_status.clientTarget || !m_status.clientTarget->isLocked) {
        return;
    }
    for (ClientStatus& client : m_status.clients) {
        if (client.id == m_status.clientTarget->clientId) {
            client.lastCommand = tr("Boresight tracks %1").arg(m_status.clientTarget->name);
        }
    }
}

void ClientsPanel::showRules()
{
    const profile::RotctldSettings& rules = m_status.profile->rotctld;
    m_first->setChecked(rules.control == profile::ControlRule::First);
    m_last->setChecked(rules.control == profile::ControlRule::Last);
    m_locked->setChecked(rules.control == profile::ControlRule::Locked);
    const QString locked = QString::fromStdString(rules.lockedTo);
    m_locked->setText(rules.control == profile::ControlRule::Locked ? tr("Locked to\n%1").arg(locked) : tr("Locked"));
    const QString reason = whyNoChange();
    for (ChoiceButton* const button : {m_first, m_last}) {
        button->setEnabled(reason.isEmpty());
    }
    m_locked->setEnabled(reason.isEmpty() && (selected() != nullptr || rules.control == profile::ControlRule::Locked));
}

void ClientsPanel::showAccess()
{
    if (m_status.listening.isEmpty()) {
        m_access->setValue(tr("rotctld does not listen. No program can connect"), Tone::Warning, Symbol::Warning);
        return;
    }
    const bool here =
        m_status.listening.startsWith(QLatin1String("127.")) || m_status.listening.startsWith(QLatin1String("[::1]"));
    QStringList allowed;
    for (const std::string& entry : m_status.profile->rotctld.allow) {
        allowed << QString::fromStdString(entry);
    }
    const QString text = !allowed.isEmpty()
                             ? tr("May connect to %1: %2").arg(m_status.listening, allowed.join(QStringLiteral(", ")))
                         : here ? tr("Any program on this computer may connect (%1)").arg(m_status.listening)
                                : tr("Every computer that reaches %1 may connect").arg(m_status.listening);
    m_access->setValue(text, Tone::Secondary);
}

// Hidden while nothing uses a broker.
void ClientsPanel::showBroker()
{
    const BrokerStatus& broker = m_status.broker;
    if (!broker.wanted) {
        m_broker->setValue({});
    } else if (broker.connected) {
        m_broker->setValue(tr("Connected to the MQTT broker %1").arg(broker.name), Tone::Secondary);
    } else if (broker.problem.isEmpty()) {
        m_broker->setValue(tr("Connecting to the MQTT broker %1").arg(broker.name), Tone::Secondary);
    } else {
        const QString again = broker.retryIn
                                  ? tr(" (next attempt in %1 s)").arg(std::ceil(broker.retryIn->count()), 0, 'f', 0)
                                  : QString();
        m_broker->setValue(broker.problem + again, Tone::Warning, Symbol::Warning);
    }
}

// Without a selection the line shows the advice for the client that needs it.
void ClientsPanel::showSelected()
{
    const ClientStatus* const client = selected();
    m_give->setBlocked(client == nullptr ? whyNoClient(client) : client->controlObstacle);
    m_disconnect->setBlocked(whyNoClient(client));
    m_readOnly->setBlocked(whyNoClient(client));
    const bool readOnly = client != nullptr && client->readOnly;
    m_readOnly->setCommand(readOnly ? tr("May move") : tr("Read-only"),
                           readOnly ? tr("The selected client may move the mount again")
                                    : tr("The selected client may only read and stop"));
    const QString reason = whyNoChange();
    m_lock->setBlocked(reason.isEmpty() ? whyNoClient(client) : reason);

    const auto advised = std::ranges::find_if(m_status.clients, [](const auto& one) { return !one.advice.isEmpty(); });
    if (client != nullptr && client->advice.isEmpty()) {
        m_detail->setValue(tr("%1: last command %2").arg(addressAndOdd(*client), client->lastCommand));
    } else if (client != nullptr || advised != m_status.clients.end()) {
        const ClientStatus& shown = client != nullptr ? *client : *advised;
        m_detail->setValue(tr("%1: %2").arg(addressAndOdd(shown), shown.advice), Tone::Advisory, Symbol::Advisory);
    } else if (m_status.authority == Authority::Operator) {
        m_detail->setValue(tr("You have control. Boresight refuses motion commands of clients"));
    } else {
        m_detail->setValue(m_status.clients.empty() ? tr("No program is connected. Gpredict disengages after 6 errors "
                                                         "in a row. Then press Engage in Gpredict again")
                                                    : tr("Select a client to give it control or to make it read-only"),
                           Tone::Secondary);
    }
    explainOdd(client);
}

// An own tooltip replaces that of a text that does not fit, so it contains the text.
void ClientsPanel::explainOdd(const ClientStatus* client)
{
    const QString odd = client != nullptr ? oddHelp(*client) : QString();
    const QString help = odd.isEmpty() ? QString() : m_detail->text() + QLatin1Char('\n') + odd;
    if (m_detail->toolTip() != help) {
        m_detail->setToolTip(help);
    }
}

// Edits of other settings must not be applied along with the rule.
QString ClientsPanel::whyNoChange() const
{
    const auto ours = [](const std::string& key) { return key == "rotctld.lead" || key == "rotctld.locked_to"; };
    return std::ranges::all_of(m_draft.editedKeys(), ours)
               ? QString()
               : tr("Apply or revert the edits of the profile first (Ctrl+3).");
}

void ClientsPanel::lock()
{
    if (const ClientStatus* const client = selected()) {
        choose(profile::ControlRule::Locked, boresight::hostOf(client->address.toStdString()));
    }
}

void ClientsPanel::choose(profile::ControlRule lead, const std::string& lockedTo)
{
    m_draft.edit([&](profile::Profile& profile) {
        profile.rotctld.control = lead;
        profile.rotctld.lockedTo = lockedTo;
    });
    if (m_draft.hasEdits()) {
        m_draft.apply(this, [this](const std::optional<Error>& error) {
            if (error) {
                m_draft.revert();
            }
            m_notice->setValue(error ? tr("Control goes to: %1").arg(error->text) : QString(), Tone::Warning,
                               error ? Symbol::Warning : Symbol::None);
        });
    }
    showRules();  // the rule of the station, until it answers
}

void ClientsPanel::copySettings() const
{
    QApplication::clipboard()->setText(gpredictSettings(m_status));
}

}  // namespace boresight::ui

#include "moc_clients_panel.cpp"
