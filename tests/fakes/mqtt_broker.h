// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/fakes/program.h"

#include <QString>
#include <QTemporaryDir>

#include <cstdint>
#include <memory>

// The real mosquitto on a free loopback port, with its files in its own folder. Waiting runs the event loop.
namespace boresight::fakes {

class MqttBroker
{
public:
    enum class Door
    {
        Open,
        Password,  // user "mount", password "s3cret"
        Tls,       // certificate for localhost and 127.0.0.1, signed by caFile()
        TlsOther,  // the same for broker.example
        // Anybody may connect, write everything, and read what is below "permitted/":
        AccessList,  // by acl_file, which accepts every subscription and then does not deliver the rest
        Guarded      // by the dynamic-security plugin, which refuses the subscription
    };

    [[nodiscard]] static bool isInstalled();
    [[nodiscard]] static bool canBeGuarded();  // the plugin is installed
    explicit MqttBroker(Door door = Door::Open);

    // True when it listens. After stop() or kill() it uses the same port again.
    [[nodiscard]] bool start();
    void stop();
    void kill();

    [[nodiscard]] std::uint16_t port() const { return m_port; }
    [[nodiscard]] QString caFile() const { return file("ca.pem"); }
    [[nodiscard]] QString strangersCaFile() const { return file("stranger.pem"); }  // this CA signed nothing here
    // The log of the broker so far.
    [[nodiscard]] QString log() const { return m_process ? m_process->errors() : QString(); }
    [[nodiscard]] qsizetype count(const char* text) const { return log().count(QLatin1String(text)); }

private:
    [[nodiscard]] QString file(const char* name) const { return m_folder.filePath(QLatin1String(name)); }
    void write(const char* name, const QByteArray& bytes) const;
    void makeCertificates() const;
    void configure();

    Door m_door;
    QTemporaryDir m_folder;
    std::uint16_t m_port = 0;
    std::unique_ptr<Program> m_process;
};

}  // namespace boresight::fakes
