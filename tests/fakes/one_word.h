// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QTranslator>

// While an object exists, every text of the core is the same word. A decision that depends on a text goes wrong then.
// The word has no place for the arguments of the texts, so the warnings of Qt about them are dropped. Needs a
// QCoreApplication.
namespace boresight::fakes {

class OneWord : public QTranslator
{
public:
    OneWord() : m_before(qInstallMessageHandler([](QtMsgType, const QMessageLogContext&, const QString&) {}))
    {
        QCoreApplication::installTranslator(this);
    }
    ~OneWord() override
    {
        QCoreApplication::removeTranslator(this);
        qInstallMessageHandler(m_before);
    }

    [[nodiscard]] bool isEmpty() const override { return false; }
    [[nodiscard]] QString translate(const char* context, const char* /*source*/, const char* /*disambiguation*/,
                                    int /*n*/) const override
    {
        return qstrcmp(context, "Text") == 0 ? QStringLiteral("Wort") : QString();
    }

private:
    QtMessageHandler m_before;
};

}  // namespace boresight::fakes
