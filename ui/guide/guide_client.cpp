// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guide/guide_client.h"

#include "ui/clients/gpredict_settings.h"
#include "ui/kit/command_button.h"
#include "ui/kit/push_button.h"
#include "ui/kit/value_label.h"

#include <QApplication>
#include <QClipboard>
#include <QPlainTextEdit>
#include <QVBoxLayout>

namespace boresight::ui {

namespace {

QString clientsText(const StationStatus& status)
{
    QStringList clients;
    for (const ClientStatus& client : status.clients) {
        clients << (client.program.isEmpty() ? client.address
                                             : QStringLiteral("%1 %2").arg(client.program, client.address));
    }
    return clients.join(QStringLiteral(", "));
}

}  // namespace

GuideClient::GuideClient(QWidget* parent)
    : QWidget(parent),
      m_settings(new QPlainTextEdit(this)),
      m_copy(makePushButton({.text = tr("Copy"),
                             .name = tr("Copy the settings for Gpredict"),
                             .help = tr("Put the settings for Gpredict into the clipboard")},
                            this)),
      m_there(new ValueLabel(tr("Programs that are connected"), fonts::label(), {}, this))
{
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    m_settings->setFont(fonts::label());
    m_settings->setReadOnly(true);
    m_settings->setTabChangesFocus(true);
    m_settings->setAccessibleName(tr("Settings for Gpredict"));
    m_copy->setMinimumWidth(2 * kTouchSize);
    m_there->setStretching(true);
    m_there->setLines(2);
    auto* const row = new QHBoxLayout;
    row->addWidget(m_there, 1);
    row->addWidget(m_copy);
    column->addWidget(m_settings, 1);
    column->addLayout(row);
    connect(m_copy, &QPushButton::clicked, this, &GuideClient::copy);
}

void GuideClient::showStatus(const StationStatus& status)
{
    const bool listens = !status.listening.isEmpty();
    const QString text =
        listens ? gpredictSettings(status) + tr("Any other client of rotctld works as well, at the same address.")
                : tr("The rotctld port is closed. No program can connect. The alarm shows the reason.");
    if (text != m_settings->toPlainText()) {
        m_settings->setPlainText(text);
    }
    m_copy->setEnabled(listens);
    m_there->setValue(
        status.clients.empty() ? tr("No program is connected yet") : tr("Connected: %1").arg(clientsText(status)),
        status.clients.empty() ? Tone::Secondary : Tone::Normal);
}

void GuideClient::copy()
{
    QApplication::clipboard()->setText(m_settings->toPlainText());
}

}  // namespace boresight::ui

#include "moc_guide_client.cpp"
