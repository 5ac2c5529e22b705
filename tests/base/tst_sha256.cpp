// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/sha256.h"

#include "tests/support/registered_test.h"

#include <QByteArray>
#include <QCryptographicHash>
#include <QTest>
#include <random>

using namespace odo;

class TestSha256 : public QObject
{
    Q_OBJECT

    static QByteArray hashOf(const QByteArray &bytes, const std::vector<qsizetype> &pieces)
    {
        Sha256 hash;
        qsizetype at = 0;
        for (const qsizetype piece : pieces) {
            hash.add(bytes.constData() + at, static_cast<std::size_t>(std::min(piece, bytes.size() - at)));
            at += std::min(piece, bytes.size() - at);
        }
        hash.add(bytes.constData() + at, static_cast<std::size_t>(bytes.size() - at));
        return QByteArray::fromStdString(hash.hex());
    }

private Q_SLOTS:
    /// The examples of FIPS 180-4.
    void examples()
    {
        QCOMPARE(hashOf("abc", {}),
                 QByteArray("ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"));
        QCOMPARE(hashOf("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq", {}),
                 QByteArray("248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1"));
        QCOMPARE(hashOf({}, {}),
                 QByteArray("e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"));
    }
    /// Every length around the blocks of 64 bytes, in pieces of any size.
    void asQtComputesIt()
    {
        std::mt19937 random(3);
        QByteArray bytes(700, '\0');
        for (char &byte : bytes)
            byte = char(random());
        for (qsizetype size = 0; size <= bytes.size(); ++size) {
            std::vector<qsizetype> pieces;
            for (int i = 0; i < 8; ++i)
                pieces.push_back(qsizetype(random() % 150));
            const QByteArray part = bytes.first(size);
            QCOMPARE(hashOf(part, pieces),
                     QCryptographicHash::hash(part, QCryptographicHash::Sha256).toHex());
        }
    }
};

ODOGRAPH_TEST(TestSha256, QCoreApplication)
#include "tst_sha256.moc"
