// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/station/mount_factory.h"
#include "tests/fakes/hand_turned_timers.h"
#include "tests/fakes/manual_clock.h"
#include "tests/ui/find_widget.h"
#include "tests/ui/sample_status.h"
#include "ui/kit/value_label.h"
#include "ui/window/main_window.h"

#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

#include <functional>
#include <string_view>
#include <utility>
#include <vector>

// A visible and active window at 1024×700 with a hand-turned clock, and all its requests to the station. Its beat, its
// dead-man switch and its other timers use this clock, too.
namespace boresight::ui {

class WindowFixture : public ::testing::Test
{
protected:
    explicit WindowFixture(const WindowSettings& windowSettings = settings()) : window(clock, windowSettings)
    {
        QObject::connect(&window, &MainWindow::requested, &window, [this](const NumberedRequest& request) {
            const bool isQuestion = std::holds_alternative<request::JudgeDirection>(request.request);
            (isQuestion ? questions : requests).push_back(request);
        });
        window.resize(1024, 700);
        window.QWidget::show();
        window.activateWindow();
        EXPECT_TRUE(becomesActive(window));
        give(samples::update(samples::idle()));
    }

    static WindowSettings settings() { return {.rotators = rotatorOffers()}; }

    // Opens a panel by its key, Ctrl+digit.
    void openPanel(char digit) { QTest::keyClick(&window, digit, Qt::ControlModifier); }
    // The keys of all panels that are always present.
    static constexpr std::string_view kPanels = "123456789T";

    // Adds the verdicts on the directions that the window has asked about.
    void give(StationUpdate update)
    {
        for (const NumberedRequest& one : std::exchange(questions, {})) {
            update.answers.push_back(
                {.requestId = one.id, .verdict = judge(std::get<request::JudgeDirection>(one.request).direction)});
        }
        window.showUpdate(update);
    }
    void elapse(Seconds time) { timers.elapse(time); }

    template <class T>
    T* named(const char* name)
    {
        return findNamed<T>(window, name);
    }

    QString text(const char* name) { return named<ValueLabel>(name)->text(); }
    void chooseFile(const QString& path) { ui::chooseFile(window, path); }

    template <class R>
    std::vector<R> asked() const
    {
        std::vector<R> found;
        for (const NumberedRequest& request : requests) {
            if (const auto* const one = std::get_if<R>(&request.request)) {
                found.push_back(*one);
            }
        }
        return found;
    }

    fakes::ManualClock clock;
    std::vector<NumberedRequest> requests;   // without the questions
    std::vector<NumberedRequest> questions;  // not answered yet
    // The answer of the station to a question.
    std::function<DirectionVerdict(const SkyPointing&)> judge = [](const SkyPointing&) { return DirectionVerdict{}; };
    MainWindow window;
    fakes::HandTurnedTimers timers{window, clock};
};

}  // namespace boresight::ui
