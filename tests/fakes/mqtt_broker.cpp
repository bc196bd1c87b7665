// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fakes/mqtt_broker.h"

#include "tests/fakes/unused_port.h"
#include "tests/fakes/wait_until.h"

#include <QDir>
#include <QFile>
#include <QStandardPaths>

#include <gtest/gtest.h>

namespace boresight::fakes {
namespace {

const QByteArray kGuarded =
    R"({"defaultACLAccess": {"publishClientSend": true, "publishClientReceive": true, "subscribe": false},
        "roles": [{"rolename": "reader",
                   "acls": [{"acltype": "subscribePattern", "topic": "permitted/#", "allow": true},
                            {"acltype": "publishClientSend", "topic": "$CONTROL/#", "allow": true}]}],
        "groups": [{"groupname": "all", "roles": [{"rolename": "reader"}]}], "anonymousGroup": "all", "clients": []})";

// Debian installs mosquitto in a folder that is only in the search path of root.
QString broker()
{
    const QString name = QStringLiteral("mosquitto");
    const QString found = QStandardPaths::findExecutable(name);
    return found.isEmpty()
               ? QStandardPaths::findExecutable(name, {QStringLiteral("/usr/sbin"), QStringLiteral("/usr/local/sbin")})
               : found;
}

// Debian installs the plugin in the folder of the architecture.
QString guard()
{
    const QDir libraries(QStringLiteral("/usr/lib"));
    for (const QString& folder : libraries.entryList(QDir::Dirs | QDir::NoDotDot)) {
        const QString file = libraries.filePath(folder + QStringLiteral("/mosquitto_dynamic_security.so"));
        if (QFile::exists(file)) {
            return file;
        }
    }
    return {};
}

void run(const QString& program, const QStringList& arguments)
{
    Program running(program, arguments);
    EXPECT_EQ(running.waitForEnd(), 0) << running.errors().toStdString();
}

}  // namespace

bool MqttBroker::isInstalled()
{
    const auto isThere = [](const char* name) {
        return !QStandardPaths::findExecutable(QLatin1String(name)).isEmpty();
    };
    return !broker().isEmpty() && isThere("mosquitto_passwd") && isThere("openssl");
}

bool MqttBroker::canBeGuarded()
{
    return !guard().isEmpty();
}

MqttBroker::MqttBroker(Door door) : m_door(door), m_port(unusedPort())
{
    if (m_door == Door::Tls || m_door == Door::TlsOther) {
        makeCertificates();
    } else if (m_door == Door::Password) {
        run(QStringLiteral("mosquitto_passwd"), {QStringLiteral("-c"), QStringLiteral("-b"), file("passwords"),
                                                 QStringLiteral("mount"), QStringLiteral("s3cret")});
    }
    configure();
}

void MqttBroker::write(const char* name, const QByteArray& bytes) const
{
    QFile target(file(name));
    ASSERT_TRUE(target.open(QIODevice::WriteOnly));
    target.write(bytes);
}

void MqttBroker::makeCertificates() const
{
    const auto request = [this](const char* name, const QStringList& more) {
        QStringList arguments{QStringLiteral("req"),
                              QStringLiteral("-x509"),
                              QStringLiteral("-nodes"),
                              QStringLiteral("-days"),
                              QStringLiteral("2"),
                              QStringLiteral("-newkey"),
                              QStringLiteral("ec"),
                              QStringLiteral("-pkeyopt"),
                              QStringLiteral("ec_paramgen_curve:P-256"),
                              QStringLiteral("-subj"),
                              QStringLiteral("/CN=%1").arg(QLatin1String(name)),
                              QStringLiteral("-out"),
                              file(name) + QStringLiteral(".pem"),
                              QStringLiteral("-keyout"),
                              file(name) + QStringLiteral(".key")};
        run(QStringLiteral("openssl"), arguments + more);
    };
    const QString names =
        m_door == Door::Tls ? QStringLiteral("DNS:localhost,IP:127.0.0.1") : QStringLiteral("DNS:broker.example");
    request("ca", {});
    request("stranger", {});
    request("server", {QStringLiteral("-CA"), file("ca.pem"), QStringLiteral("-CAkey"), file("ca.key"),
                       QStringLiteral("-addext"), QStringLiteral("subjectAltName=") + names, QStringLiteral("-addext"),
                       QStringLiteral("basicConstraints=CA:FALSE")});
}

void MqttBroker::configure()
{
    // "user root": without it a mosquitto that root starts changes to a user that cannot read the folder.
    QString text =
        QStringLiteral("listener %1 127.0.0.1\nuser root\npersistence false\nlog_dest stderr\nlog_type all\n")
            .arg(m_port);
    switch (m_door) {
        case Door::Open:
            text += QStringLiteral("allow_anonymous true\n");
            break;
        case Door::Password:
            text += QStringLiteral("allow_anonymous false\npassword_file %1\n").arg(file("passwords"));
            break;
        case Door::Tls:
        case Door::TlsOther:
            text += QStringLiteral("allow_anonymous true\ncafile %1\ncertfile %2\nkeyfile %3\n")
                        .arg(caFile(), file("server.pem"), file("server.key"));
            break;
        case Door::AccessList:
            write("acl", "topic write #\ntopic read permitted/#\n");
            text += QStringLiteral("allow_anonymous true\nacl_file %1\n").arg(file("acl"));
            break;
        case Door::Guarded:
            write("guard.json", kGuarded);
            text += QStringLiteral("allow_anonymous true\nplugin %1\nplugin_opt_config_file %2\n")
                        .arg(guard(), file("guard.json"));
            break;
    }
    write("mosquitto.conf", text.toUtf8());
}

// Another test may have taken the free port meanwhile.
bool MqttBroker::start()
{
    const auto isTaken = [this] { return log().contains(QLatin1String("Address already in use")); };
    const bool first = !m_process;
    for (int attempt = 0; attempt < 3; ++attempt) {
        m_process = std::make_unique<Program>(broker(), QStringList{QStringLiteral("-c"), file("mosquitto.conf")});
        if (!waitUntil([&] { return isTaken() || log().contains(QLatin1String(" running")); })) {
            return false;
        }
        if (!isTaken()) {
            return true;
        }
        if (first) {
            m_port = unusedPort();
            configure();
        }
    }
    return false;
}

void MqttBroker::stop()
{
    m_process->terminate();
    EXPECT_EQ(m_process->waitForEnd(), 0);
}

void MqttBroker::kill()
{
    m_process->kill();
    EXPECT_EQ(m_process->waitForEnd(), -1);
}

}  // namespace boresight::fakes
