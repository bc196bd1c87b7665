// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/clients/client_model.h"

#include "ui/kit/theme.h"

#include <algorithm>

namespace boresight::ui {

namespace {

// "1.3", "655", "6.6 k", "66 k": never wider than its column.
QString commandsPerSecondText(double perSecond)
{
    constexpr double kThousand = 1000.0;
    const auto digits = [](double value, double exactBelow) {
        return QString::number(value, 'f', value < exactBelow ? 1 : 0);
    };
    return perSecond < kThousand - 0.5 ? digits(perSecond, 99.95)
                                       : ClientModel::tr("%1 k", "thousand").arg(digits(perSecond / kThousand, 9.95));
}

QString cell(const ClientStatus& client, int column)
{
    switch (column) {
        case ClientModel::Address:
            return client.address;
        case ClientModel::Program:
            return client.program.isEmpty() ? ClientModel::tr("unknown") : client.program;
        case ClientModel::Rate:
            return commandsPerSecondText(client.commandsPerSecond);
        case ClientModel::LastCommand:
            return client.lastCommand;
        default:
            return roleWord(client);
    }
}

QString help(const ClientStatus& client)
{
    QString text = ClientModel::tr("%1, %2: %3 commands a second, last %4")
                       .arg(client.address, cell(client, ClientModel::Program), cell(client, ClientModel::Rate),
                            client.lastCommand.isEmpty() ? ClientModel::tr("none") : client.lastCommand);
    if (!client.advice.isEmpty()) {
        text += QLatin1Char('\n') + client.advice;
    }
    if (client.oddCommands > 0) {
        text += QLatin1Char('\n') + oddHelp(client);
    }
    return text;
}

}  // namespace

QStringList roleWords()
{
    QStringList words;
    for (const ClientStatus& one : {ClientStatus{.readOnly = true}, ClientStatus{.driving = true},
                                    ClientStatus{.driving = true, .inControl = true}, ClientStatus{.inControl = true},
                                    ClientStatus{.wanting = true}, ClientStatus{}}) {
        ClientStatus locked = one;
        locked.locked = true;
        words << roleWord(one) << roleWord(locked);
    }
    return words;
}

QString roleWord(const ClientStatus& client)
{
    QString word = client.readOnly ? ClientModel::tr("read-only")
                   : client.inControl
                       ? (client.driving ? ClientModel::tr("● in control") : ClientModel::tr("in control"))
                   : client.driving ? ClientModel::tr("● moves the mount")
                   : client.wanting ? ClientModel::tr("▲ waiting")
                                    : QString();
    if (client.locked) {
        word += (word.isEmpty() ? QString() : QStringLiteral(", ")) + ClientModel::tr("locked");
    }
    return word;
}

QString oddHelp(const ClientStatus& client)
{
    return client.oddCommands == 0
               ? QString()
               : ClientModel::tr(
                     "Odd commands: %1. A command is odd if Boresight does not know it, if its numbers "
                     "are invalid (such as NaN), or if this mount does not have what the command asks "
                     "for. An odd command does not move the mount.")
                     .arg(client.oddCommands);
}

ClientModel::ClientModel(QObject* parent)
    : TableModel({tr("Address"), tr("Program"), tr("1/s"), tr("Last"), tr("Control")}, parent)
{}

void ClientModel::show(const std::vector<ClientStatus>& clients)
{
    if (std::ranges::equal(clients, m_clients, {}, &ClientStatus::id, &ClientStatus::id)) {
        m_clients = clients;
        changeCells();
        return;
    }
    beginResetModel();
    m_clients = clients;
    endResetModel();
}

std::optional<int> ClientModel::rowOf(std::uint64_t id) const
{
    const auto found = std::ranges::find(m_clients, id, &ClientStatus::id);
    return found == m_clients.end() ? std::nullopt : std::optional(static_cast<int>(found - m_clients.begin()));
}

QVariant ClientModel::data(const QModelIndex& index, int role) const
{
    const ClientStatus& one = client(index.row());
    switch (role) {
        case Qt::DisplayRole:
            return cell(one, index.column());
        case Qt::ToolTipRole:
            return help(one);
        case Qt::TextAlignmentRole:
            return index.column() == Rate ? QVariant(Qt::AlignRight | Qt::AlignVCenter) : QVariant();
        case Qt::ForegroundRole:
            return one.wanting && index.column() == Role ? QVariant(currentTheme().warning) : QVariant();
        default:
            return {};
    }
}

}  // namespace boresight::ui

#include "moc_client_model.cpp"
