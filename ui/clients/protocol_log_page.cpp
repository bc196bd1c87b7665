// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/clients/protocol_log_page.h"

#include "ui/kit/command_button.h"
#include "ui/kit/lines_view.h"
#include "ui/kit/push_button.h"
#include "ui/kit/value_label.h"

#include <QComboBox>
#include <QVBoxLayout>

namespace boresight::ui {

namespace {
// The newest clients. A program may connect again for each command.
constexpr int kMostClients = 20;

// "go to 100.0° / 10.0°", in the language of the window.
QString usualMeaning()
{
    ProtocolLine line;
    line.acts = {{.kind = ProtocolAct::Kind::Point, .azimuth = 100_deg, .elevation = 10_deg}};
    return understoodText(line);
}

}  // namespace

ProtocolLogPage::ProtocolLogPage(RequestDesk& desk, QWidget* parent)
    : QWidget(parent),
      m_model(new ProtocolLogModel(this)),
      m_filter(new ProtocolLogFilter(this)),
      m_view(new LinesView(tr("Protocol log"), QStringLiteral("boresight-protocol.txt"), *m_filter, this)),
      m_switch(new CommandButton(tr("Begin log"), {}, desk, m_view->notice(), this)),
      m_state(new ValueLabel(tr("State of the protocol log"), fonts::label(), {}, this)),
      m_client(new QComboBox(this))
{
    m_filter->setSourceModel(m_model);
    m_view->setFollowing();
    m_view->setColumnRoom(ProtocolLogModel::Time, QStringLiteral("00:00:00.000"));
    m_view->setColumnRoom(ProtocolLogModel::Client, QStringLiteral("rotctld :00000"));
    m_view->setColumnRoom(ProtocolLogModel::Line, QStringLiteral("P 000.00 00.00"));
    m_view->setColumnRoom(ProtocolLogModel::Understood, usualMeaning());
    addClients();
    QPushButton* const back = makePushButton(
        {.text = tr("Clients"), .name = tr("Back to the clients"), .help = tr("Show the list of clients again")}, this);
    connect(back, &QPushButton::clicked, this, &ProtocolLogPage::closed);
    connect(m_switch, &QPushButton::clicked, this, [this] { m_switch->ask(request::LogProtocol{.on = !m_on}); });
    m_state->setStretching(true);
    m_state->setLines(2);
    auto* const head = new QHBoxLayout;
    head->setSpacing(4);
    head->addWidget(back);
    head->addWidget(m_switch);
    head->addWidget(m_state, 1);
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(6, 6, 6, 6);
    column->setSpacing(4);
    column->addLayout(head);
    column->addWidget(m_view, 1);
    setTabOrder(back, m_switch);
    setTabOrder(m_switch, m_client);
    setFocusProxy(m_switch);
    showState();
}

void ProtocolLogPage::addClients()
{
    m_client->setAccessibleName(tr("Filter by client"));
    m_client->setToolTip(tr("Show only the lines of this client"));
    m_client->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_client->addItem(tr("All clients"), QVariant::fromValue<qulonglong>(0));
    connect(m_client, &QComboBox::currentIndexChanged, this,
            [this] { m_filter->setClient(m_client->currentData().toULongLong()); });
    m_view->addControl(*m_client, 1);
}

void ProtocolLogPage::append(const std::vector<ProtocolLine>& lines)
{
    m_model->append(lines);
    std::uint64_t last = 0;
    for (const ProtocolLine& line : lines) {
        if (line.clientId != last) {
            last = line.clientId;
            offer(line);
        }
    }
    showState();
}

// The newest client is the first below "All clients". The chosen client stays in the list.
void ProtocolLogPage::offer(const ProtocolLine& line)
{
    const auto id = QVariant::fromValue<qulonglong>(line.clientId);
    if (m_client->findData(id) >= 0) {
        return;
    }
    m_client->insertItem(1, line.client, id);
    if (m_client->count() > kMostClients + 1) {
        const int eldest = m_client->count() - 1;
        m_client->removeItem(m_client->currentIndex() == eldest ? eldest - 1 : eldest);
    }
}

void ProtocolLogPage::showStatus(const StationStatus& status)
{
    m_on = status.isProtocolLogged;
    showState();
}

void ProtocolLogPage::showState()
{
    m_switch->setCommand(m_on ? tr("End log") : tr("Begin log"),
                         m_on ? tr("Log no more lines. The lines in the list stay")
                              : tr("Log each line of all clients. The log is off after each start and reconnect"));
    const QString lines = tr("lines: %1, older lines dropped: %2")
                              .arg(QString::number(m_model->rowCount()), QString::number(m_model->dropped()));
    m_state->setValue(
        m_on ? tr("Log on, %1").arg(lines) : (m_model->rowCount() > 0 ? tr("Log off, %1").arg(lines) : tr("Log off")),
        m_on ? Tone::Normal : Tone::Secondary);
}

}  // namespace boresight::ui

#include "moc_protocol_log_page.cpp"
