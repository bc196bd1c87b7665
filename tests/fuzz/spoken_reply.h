// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QNetworkAccessManager>
#include <QNetworkReply>

// A network with one prepared answer: each request receives it, without a socket and without waiting. It reports the
// same as Qt's network classes, in the same order: the head, the content in pieces, the end.
namespace boresight::fuzz {

struct SpokenAnswer
{
    enum class End
    {
        Comes,
        IsCut,     // the connection closes before the content is complete
        Never,     // the server sends nothing more
        NoServer,  // the name of the server is unknown
        GoesOn     // sends spaces for ever
    };

    int status = 200;
    QByteArray phrase;
    QList<QNetworkReply::RawHeaderPair> headers;
    QByteArray content;
    qsizetype piece = 1;  // of the content: how many bytes come at once
    End end = End::Comes;
};

// Splits the bytes of an answer: its first line, its header lines, an empty line, its content.
[[nodiscard]] SpokenAnswer readAnswer(const QByteArray& bytes);

class SpokenReply : public QNetworkReply
{
public:
    // `isSilent` becomes true when nothing more comes although the answer has not ended. It must outlive this object.
    SpokenReply(const QNetworkRequest& request, const SpokenAnswer& answer, bool& isSilent, QObject* parent);

    void abort() override;
    [[nodiscard]] qint64 bytesAvailable() const override
    {
        return m_ready.size() - m_read + QIODevice::bytesAvailable();
    }
    [[nodiscard]] bool isSequential() const override { return true; }

protected:
    qint64 readData(char* data, qint64 most) override;

private:
    void speak();
    void next();
    void later();
    void end(NetworkError error);

    SpokenAnswer m_answer;
    bool& m_isSilent;
    qsizetype m_said = 0;  // sent part of the content
    QByteArray m_ready;    // sent last
    qsizetype m_read = 0;  // read part of it
};

class SpokenNetwork : public QNetworkAccessManager
{
public:
    void setAnswer(const SpokenAnswer& answer) { m_answer = answer; }
    [[nodiscard]] bool isSilent() const { return m_isSilent; }

protected:
    QNetworkReply* createRequest(Operation operation, const QNetworkRequest& request, QIODevice* body) override;

private:
    SpokenAnswer m_answer;
    bool m_isSilent = false;
};

}  // namespace boresight::fuzz
