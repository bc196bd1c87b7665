// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/contacts/output_name.h"
#include "core/outputs/output.h"
#include "core/profile/in_force.h"

#include <QObject>
#include <QString>

#include <functional>
#include <memory>
#include <optional>
#include <string>

// The output that the profile names, from open() to close(). It is off at first, and it is off again before another
// output takes its place or the object ends. Its owner decides between on and off. Station thread; outputs have threads
// of their own for files, ports and programs.
namespace boresight::outputs {

class NamedOutput : public QObject
{
    Q_OBJECT

public:
    using Make = std::function<std::unique_ptr<Output>(const contacts::OutputName& name)>;
    // Where the profile has the name of the output.
    using NameIn = const std::string& (*)(const profile::Profile& profile);

    // The output is set again after this time. So a lost output is found, and its reader knows that Boresight is alive.
    static constexpr std::chrono::seconds kRepeat{1};
    // An output that does not answer within this time has failed.
    static constexpr std::chrono::seconds kPatience{5};

    // Profile and clock outlive this. `use` is one word for the MQTT client id.
    NamedOutput(const profile::InForce& profile, NameIn nameIn, const QString& use, const Clock& clock,
                QObject* parent = nullptr);
    ~NamedOutput() override;

    // Replaces how outputs are made. Call before open().
    void setMaker(Make make) { m_make = std::move(make); }

    void open();
    // Switches the output off without waiting for its answer. The destructor waits.
    void close();
    // The profile names another output, or the output needs another broker.
    [[nodiscard]] bool differs(const profile::Profile& before, const profile::Profile& after) const;
    // Opens the output of the profile in force as soon as the output before is off.
    void reopen();

    // The profile names an output, and the previous output has ended.
    [[nodiscard]] bool isThere() const { return m_output != nullptr; }
    // The output before has not ended yet.
    [[nodiscard]] bool isAwaited() const { return m_former != nullptr && m_open; }
    [[nodiscard]] QString name() const;

    // Once per tick. Does nothing without an output.
    void order(bool on);
    [[nodiscard]] bool ordered() const { return m_order.on; }
    // By the last answer, perhaps to an earlier order.
    [[nodiscard]] bool isOn() const { return m_isOn; }
    // What the output answered to the present order, and what is wrong with the output.
    [[nodiscard]] contacts::OutputAnswer answer() const;

Q_SIGNALS:
    void reached(bool on);
    void failed(const QString& reason);

private:
    struct Order
    {
        bool on = false;
        bool isReached = false;
        std::optional<SteadyTime> at = {};
        std::optional<SteadyTime> unanswered = {};  // the oldest order without an answer
    };

    void begin();
    void retire();
    void take(bool on);
    void fail(const QString& reason);

    const profile::InForce& m_profile;
    NameIn m_nameIn;
    const Clock& m_clock;
    Make m_make;
    bool m_open = false;
    std::unique_ptr<Output> m_output;  // null: the profile names none, or m_former has to end first
    std::unique_ptr<Output> m_former;  // the previous output, until it is off
    SteadyTime m_retired{};            // since when m_former is to be off
    Order m_order;
    bool m_isOn = false;
    QString m_problem;
};

}  // namespace boresight::outputs
