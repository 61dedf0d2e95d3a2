<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>ProgressTab</name>
    <message numerus="yes">
        <source>after %n trial(s)</source>
        <translation>
            <numerusform>after %n trial</numerusform>
            <numerusform>after %n trials</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s), %1 passed</source>
        <translation>
            <numerusform>%n trial, %1 passed</numerusform>
            <numerusform>%n trials, %1 passed</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>StatementsLine</name>
    <message numerus="yes">
        <source>Learning record store: %n trial(s) wait to be sent</source>
        <translation>
            <numerusform>Learning record store: %n trial waits to be sent</numerusform>
            <numerusform>Learning record store: %n trials wait to be sent</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) refused (%1)</source>
        <translation>
            <numerusform>%n trial refused (%1)</numerusform>
            <numerusform>%n trials refused (%1)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>vallecula::gui::AuthoringPage</name>
    <message numerus="yes">
        <source>%n thing(s) to mend; a click leads there:</source>
        <translation>
            <numerusform>%n thing to mend; a click leads there:</numerusform>
            <numerusform>%n things to mend; a click leads there:</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>vallecula::gui::BuildPage</name>
    <message numerus="yes">
        <source>The patient is built. %n thing(s) to be checked before it is saved.</source>
        <translation>
            <numerusform>The patient is built. One thing is to be checked before it is saved.</numerusform>
            <numerusform>The patient is built. %n things are to be checked before it is saved.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>vallecula::gui::HandOn</name>
    <message numerus="yes">
        <source>Written: %1, %n trial(s).</source>
        <translation>
            <numerusform>Written: %1, %n trial.</numerusform>
            <numerusform>Written: %1, %n trials.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>vallecula::gui::StatementDelivery</name>
    <message numerus="yes">
        <source>%n trial(s) sent to the learning record store</source>
        <translation>
            <numerusform>%n trial sent to the learning record store</numerusform>
            <numerusform>%n trials sent to the learning record store</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) refused by the learning record store: %1</source>
        <translation>
            <numerusform>%n trial refused by the learning record store: %1</numerusform>
            <numerusform>%n trials refused by the learning record store: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) not sent yet: %1</source>
        <translation>
            <numerusform>%n trial not sent yet: %1</numerusform>
            <numerusform>%n trials not sent yet: %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>vallecula::gui::StatementsLine</name>
    <message numerus="yes">
        <source>%n trial(s) sent</source>
        <translation>
            <numerusform>%n trial sent</numerusform>
            <numerusform>%n trials sent</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) refused</source>
        <translation>
            <numerusform>%n trial refused</numerusform>
            <numerusform>%n trials refused</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) not sent yet: %1</source>
        <translation>
            <numerusform>%n trial not sent yet: %1</numerusform>
            <numerusform>%n trials not sent yet: %1</numerusform>
        </translation>
    </message>
</context>
</TS>
