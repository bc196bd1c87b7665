// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/ui/window_fixture.h"
#include "ui/drives/protection_model.h"
#include "ui/kit/command_button.h"
#include "ui/window/panel_tabs.h"

#include <QPlainTextEdit>
#include <QTableView>

// The panels of the drives in the window, their questions and the table of the settings.
namespace boresight::ui {

class DrivesTest : public WindowFixture
{
protected:
    template <class Panel>
    Panel& open()
    {
        auto* const panel = window.findChild<Panel*>();
        window.findChild<PanelTabs*>()->bringUp(*panel);
        return *panel;
    }

    void click(const char* button) { QTest::mouseClick(named<QPushButton>(button), Qt::LeftButton); }
    void expectBlocked(const char* button, const char* why)
    {
        auto* const one = named<CommandButton>(button);
        EXPECT_FALSE(one->isEnabled()) << button;
        EXPECT_TRUE(one->toolTip().contains(QString::fromUtf8(why))) << one->toolTip().toStdString();
    }

    // The button of the open question.
    CommandButton* act(const char* text) { return &findSeen<CommandButton>(window, text); }
    QString questionText()
    {
        for (const QPlainTextEdit* const text : window.findChildren<QPlainTextEdit*>()) {
            if (text->isVisible()) {
                return text->toPlainText();
            }
        }
        return {};
    }
    QString cell(int row, ProtectionModel::Column column) { return model().index(row, column).data().toString(); }
    int rowOf(const char* setting)
    {
        for (int row = 0; row < model().rowCount(); ++row) {
            if (cell(row, ProtectionModel::Setting) == QLatin1String(setting)) {
                return row;
            }
        }
        ADD_FAILURE() << "no row " << setting;
        return 0;
    }
    ProtectionModel& model() { return *window.findChild<ProtectionModel*>(); }
    QTableView& table() { return *named<QTableView>("Protection"); }
};

}  // namespace boresight::ui
