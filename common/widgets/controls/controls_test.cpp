#include "widgets/controls/flow_layout.h"
#include "widgets/controls/folding_section.h"
#include "widgets/controls/number_slider.h"
#include "widgets/controls/scrub_label.h"
#include "widgets/controls/segmented_switch.h"
#include "widgets/controls/track_slider.h"
#include "widgets/testing/widget_test_main.h"

#include <QAbstractButton>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <limits>

using namespace ductus;

namespace {

// What the signals of a slider were, in order: "b", the values, "e".
struct Heard
{
    QStringList words;
    explicit Heard(NumberSlider &slider)
    {
        QObject::connect(&slider, &NumberSlider::editBegun, [this] { words << "b"; });
        QObject::connect(&slider, &NumberSlider::valueChanged,
                         [this](double v) { words << QString::number(v); });
        QObject::connect(&slider, &NumberSlider::editEnded, [this] { words << "e"; });
    }
};

SegmentedSwitch *threeViews(QWidget &window)
{
    return new SegmentedSwitch("View", {{"Sketch", "Strokes."}, {"Proxy", "Skin."}, {"Surface", "Result."}},
                               true, &window);
}

// The key 2, at a time in milliseconds as the window system would say it.
void sendKey(QWidget &window, QEvent::Type type, quint64 timestamp)
{
    QKeyEvent event(type, Qt::Key_2, Qt::NoModifier, QStringLiteral("2"));
    event.setTimestamp(timestamp);
    QApplication::sendEvent(&window, &event);
}

} // namespace

class ControlsTest : public QObject
{
    Q_OBJECT
private slots:
    void decimalsFitTheSize();
    void aTypedNumberIsOneEdit();
    void keysStep();
    void aDragIsOneEdit();
    void theLabelScrubs();
    void doubleClickResets();
    void valuesFromTheProgramAreSilent();
    void logarithmicSlidersAreEvenInFactors();
    void valuesStayInTheRange();
    void keysChooseViews();
    void aHeldKeyPeeks();
    void aTapIsNoPeekHoweverSlowTheWindow();
    void keysAreLeftToFieldsAndOtherKeys();
    void disabledViewsAreNotChosen();
    void arrowsMoveTheSwitch();
    void sectionsFold();
    void cardsWrap();
};

void ControlsTest::aTypedNumberIsOneEdit()
{
    NumberSlider slider("Size", {0.0, 10.0, 0.5, 1.0, 1, "mm"});
    Heard heard(slider);
    auto *field = slider.findChild<QDoubleSpinBox *>();
    field->selectAll();
    QTest::keyClicks(field, "7.5");
    QCOMPARE(heard.words, QStringList()); // half typed numbers are none
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(heard.words, (QStringList{"b", "7.5", "e"}));
    QVERIFY(field->text().endsWith("mm"));
    QCOMPARE(slider.accessibleName(), QString("Size"));
    QCOMPARE(field->accessibleName(), QString("Size"));
}

void ControlsTest::keysStep()
{
    NumberSlider slider("Size", {0.0, 10.0, 0.5, 1.0, 1});
    Heard heard(slider);
    auto *track = slider.findChild<TrackSlider *>();
    QTest::keyClick(track, Qt::Key_Right);
    QTest::keyClick(track, Qt::Key_Left);
    QTest::keyClick(track, Qt::Key_End);
    QTest::keyClick(track, Qt::Key_Right); // nowhere to go
    QTest::keyClick(track, Qt::Key_Delete);
    QCOMPARE(heard.words, (QStringList{"b", "1.5", "e", "b", "1", "e", "b", "10", "e", "b", "1", "e"}));
}

void ControlsTest::aDragIsOneEdit()
{
    NumberSlider slider("Size", {0.0, 1.0, 0.01, 0.0, 2});
    slider.resize(300, 60);
    slider.show();
    Heard heard(slider);
    auto *track = slider.findChild<TrackSlider *>();
    const int y = track->height() / 2;
    QTest::mousePress(track, Qt::LeftButton, {}, {track->width() / 2, y});
    for (int i = 1; i <= 5; ++i)
        QTest::mouseMove(track, {track->width() / 2 + 10 * i, y});
    QTest::mouseRelease(track, Qt::LeftButton, {}, {track->width() / 2 + 50, y});
    QCOMPARE(heard.words.count("b"), 1);
    QCOMPARE(heard.words.count("e"), 1);
    QVERIFY(heard.words.first() == "b" && heard.words.last() == "e" && heard.words.size() >= 7);
    QVERIFY(slider.value() > 0.6 && slider.value() < 0.8);
    QCOMPARE(slider.value(), std::round(slider.value() * 100.0) / 100.0);
}

void ControlsTest::theLabelScrubs()
{
    NumberSlider slider("Size", {0.0, 100.0, 1.0, 50.0, 0});
    slider.resize(300, 60);
    slider.show();
    Heard heard(slider);
    auto *label = slider.findChild<ScrubLabel *>();
    QTest::mousePress(label, Qt::LeftButton, {}, {5, 5});
    QTest::mouseMove(label, {7, 5}); // not yet a drag
    QCOMPARE(heard.words, QStringList());
    QTest::mouseMove(label, {45, 5});
    QTest::mouseRelease(label, Qt::LeftButton, {}, {45, 5});
    QVERIFY(slider.value() > 60.0 && slider.value() <= 75.0);
    QVERIFY(heard.words.first() == "b" && heard.words.last() == "e");
}

void ControlsTest::doubleClickResets()
{
    NumberSlider slider("Size", {0.0, 1.0, 0.01, 0.25, 2});
    slider.setValue(0.9);
    QTest::mouseDClick(slider.findChild<ScrubLabel *>(), Qt::LeftButton);
    QCOMPARE(slider.value(), 0.25);
}

void ControlsTest::valuesFromTheProgramAreSilent()
{
    NumberSlider slider("Size", {0.0, 1.0, 0.01, 0.25, 2});
    Heard heard(slider);
    slider.setValue(0.5);
    slider.setRange({0.0, 0.4, 0.01, 0.1, 2});
    QCOMPARE(slider.value(), 0.4);
    QCOMPARE(heard.words, QStringList());
}

void ControlsTest::logarithmicSlidersAreEvenInFactors()
{
    NumberSlider slider("Size", {0.1, 10.0, 0.1, 1.0, 3, {}, true});
    QVERIFY(std::abs(slider.findChild<TrackSlider *>()->share() - 0.5) < 1e-9);
    slider.setValue(10.0);
    QVERIFY(std::abs(slider.findChild<TrackSlider *>()->share() - 1.0) < 1e-9);
}

void ControlsTest::valuesStayInTheRange()
{
    NumberSlider slider("Size", {-1.0, 1.0, 0.1, 0.0, 1});
    slider.setValue(7.0);
    QCOMPARE(slider.value(), 1.0);
    slider.setValue(-7.0);
    QCOMPARE(slider.value(), -1.0);
}

void ControlsTest::keysChooseViews()
{
    QWidget window;
    SegmentedSwitch *views = threeViews(window);
    window.show();
    QSignalSpy current(views, &SegmentedSwitch::currentChanged);
    QSignalSpy shown(views, &SegmentedSwitch::shownChanged);
    QTest::keyClick(&window, Qt::Key_3);
    QCOMPARE(views->current(), 2);
    QCOMPARE(current.count(), 1);
    QCOMPARE(shown.count(), 1);
    QTest::keyClick(&window, Qt::Key_9); // there are three
    QCOMPARE(views->current(), 2);
    QTest::mouseClick(views->findChildren<QAbstractButton *>()[1], Qt::LeftButton);
    QCOMPARE(views->current(), 1);
    QCOMPARE(shown.last()[0].toInt(), 1);
}

void ControlsTest::aHeldKeyPeeks()
{
    QWidget window;
    SegmentedSwitch *views = threeViews(window);
    window.show();
    QSignalSpy current(views, &SegmentedSwitch::currentChanged);
    sendKey(window, QEvent::KeyPress, 1'000);
    QCOMPARE(views->shown(), 1);
    QCOMPARE(views->current(), 0);
    sendKey(window, QEvent::KeyRelease, 1'400);
    QCOMPARE(views->shown(), 0);
    QCOMPARE(current.count(), 0);
    // Over the end of the clock of X11.
    sendKey(window, QEvent::KeyPress, 0xffff'ff00u);
    sendKey(window, QEvent::KeyRelease, 0x100);
    QCOMPARE(views->current(), 0);
}

// The picture of the other view took longer than a peek: the finger was up all the while.
void ControlsTest::aTapIsNoPeekHoweverSlowTheWindow()
{
    QWidget window;
    SegmentedSwitch *views = threeViews(window);
    window.show();
    connect(views, &SegmentedSwitch::shownChanged, views, [] { QTest::qSleep(400); });
    sendKey(window, QEvent::KeyPress, 1'000);
    sendKey(window, QEvent::KeyRelease, 1'080);
    QCOMPARE(views->shown(), 1);
    QCOMPARE(views->current(), 1);
}

void ControlsTest::keysAreLeftToFieldsAndOtherKeys()
{
    QWidget window;
    SegmentedSwitch *views = threeViews(window);
    auto *field = new QLineEdit(&window);
    window.show();
    window.activateWindow();
    field->setFocus();
    QTRY_VERIFY(QApplication::focusWidget() == field);
    QTest::keyClicks(field, "23");
    QCOMPARE(field->text(), QString("23"));
    QCOMPARE(views->current(), 0);
    field->clearFocus();
    QTest::keyClick(&window, Qt::Key_2, Qt::ControlModifier);
    QCOMPARE(views->current(), 0);
}

void ControlsTest::disabledViewsAreNotChosen()
{
    QWidget window;
    SegmentedSwitch *views = threeViews(window);
    window.show();
    views->setDisabledReason(2, "There is no surface yet.");
    QTest::keyClick(&window, Qt::Key_3);
    QCOMPARE(views->current(), 0);
    const auto *button = views->findChildren<QAbstractButton *>()[2];
    QVERIFY(!button->isEnabled() && button->toolTip().contains("no surface yet"));
    views->setDisabledReason(2, {});
    QTest::keyClick(&window, Qt::Key_3);
    QCOMPARE(views->current(), 2);
}

void ControlsTest::arrowsMoveTheSwitch()
{
    QWidget window;
    SegmentedSwitch *views = threeViews(window);
    window.show();
    views->setDisabledReason(1, "not now");
    QTest::keyClick(views->findChildren<QAbstractButton *>()[0], Qt::Key_Right);
    QCOMPARE(views->current(), 2); // over the disabled one
    QTest::keyClick(views->findChildren<QAbstractButton *>()[2], Qt::Key_Left);
    QCOMPARE(views->current(), 0);
}

void ControlsTest::sectionsFold()
{
    auto *content = new QLabel("content");
    FoldingSection section("&Shape", content);
    section.show();
    QSignalSpy folded(&section, &FoldingSection::foldedChanged);
    QVERIFY(content->isVisible());
    auto *heading = section.findChild<QWidget *>("foldingHeading");
    QTest::mouseClick(heading, Qt::LeftButton);
    QVERIFY(!content->isVisible() && section.isFolded());
    QTest::keyClick(heading, Qt::Key_Right);
    QVERIFY(content->isVisible());
    QTest::keyClick(heading, Qt::Key_Space);
    QVERIFY(section.isFolded());
    QCOMPARE(folded.count(), 3);
    QVERIFY(heading->accessibleName().startsWith("Shape"));
}

void ControlsTest::cardsWrap()
{
    QWidget page;
    auto *layout = new FlowLayout(10, &page);
    for (int i = 0; i < 5; ++i) {
        auto *card = new QWidget;
        card->setFixedSize(100, 40);
        layout->addWidget(card);
    }
    page.resize(330, 300);
    page.show();
    QCOMPARE(layout->itemAt(2)->geometry(), QRect(220, 0, 100, 40));
    QCOMPARE(layout->itemAt(3)->geometry(), QRect(0, 50, 100, 40));
    QCOMPARE(layout->heightForWidth(330), 90);
    QCOMPARE(layout->heightForWidth(10), 5 * 40 + 4 * 10);
}

void ControlsTest::decimalsFitTheSize()
{
    QCOMPARE(decimalsFor(0.262), 3);
    QCOMPARE(decimalsFor(0.00123), 5);
    QCOMPARE(decimalsFor(45), 1);
    QCOMPARE(decimalsFor(1e9), 0);
    QCOMPARE(decimalsFor(1e-30), 9);
    QCOMPARE(decimalsFor(0), 3);
    QCOMPARE(decimalsFor(std::numeric_limits<double>::quiet_NaN()), 3);
    NumberSlider size("Size", {0.00002, 0.05, 0.0001, 0.00123, decimalsFor(0.00123), {}, true});
    size.setValue(0.00123);
    QVERIFY(std::abs(size.value() - 0.00123) < 1e-9);
    QVERIFY(std::abs(size.findChild<QDoubleSpinBox *>()->value() - 0.00123) < 1e-9);
}

DUCTUS_WIDGET_TEST_MAIN(ControlsTest)
#include "controls_test.moc"
