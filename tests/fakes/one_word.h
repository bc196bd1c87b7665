// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QTranslator>

// While it lives, every text of the core is the same word. What decides by a text decides wrongly then. The arguments
// of the texts have no place in it: what Qt says about each of them is dropped. Needs a QCoreApplication.
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
