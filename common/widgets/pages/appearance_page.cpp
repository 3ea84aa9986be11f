#include "widgets/pages/appearance_page.h"

#include "document/settings/settings.h"
#include "widgets/controls/segmented_switch.h"
#include "widgets/language/language.h"
#include "widgets/theme/theme.h"

#include <QComboBox>
#include <QLabel>
#include <QVBoxLayout>

namespace ductus {

namespace {

QLabel *noteLabel(const QString &text)
{
    auto *note = new QLabel(text);
    note->setProperty("dim", true);
    note->setWordWrap(true);
    return note;
}

} // namespace

AppearancePage::AppearancePage(Settings &settings, QWidget *parent) : QWidget(parent)
{
    auto *heading = new QLabel(tr("Theme"));
    heading->setProperty("heading", true);
    auto *choice =
        new SegmentedSwitch(tr("Theme"),
                            {{tr("As the system"), tr("Dark or light, as the rest of your desktop.")},
                             {tr("Dark"), tr("Lets pictures and strokes stand out.")},
                             {tr("Light"), tr("Easier to read in bright rooms and on projectors.")}},
                            false);
    choice->setCurrent(int(themeChoice(settings)));
    connect(choice, &SegmentedSwitch::currentChanged, this,
            [&settings](int index) { setThemeChoice(settings, ThemeChoice(index)); });

    auto *languageHeading = new QLabel(tr("&Language"));
    languageHeading->setProperty("heading", true);
    auto *language = new QComboBox;
    language->setObjectName(QStringLiteral("language"));
    language->setAccessibleName(tr("Language"));
    languageHeading->setBuddy(language);
    language->addItem(tr("As the system"), QString());
    for (const Language &spoken : languages())
        language->addItem(spoken.name, spoken.code); // in itself, so that a wrong choice can be undone
    language->setCurrentIndex(std::max(0, language->findData(settings.value(chosenLanguage))));
    connect(language, &QComboBox::activated, this,
            [&settings, language] { settings.set(chosenLanguage, language->currentData().toString()); });

    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(12);
    layout->addWidget(heading);
    layout->addWidget(choice, 0, Qt::AlignLeft);
    layout->addWidget(noteLabel(tr("Pictures you export do not depend on it.")));
    layout->addSpacing(12);
    layout->addWidget(languageHeading);
    layout->addWidget(language, 0, Qt::AlignLeft);
    layout->addWidget(noteLabel(tr("Takes effect when the app is started again.")));
    layout->addStretch(1);
}

} // namespace ductus
