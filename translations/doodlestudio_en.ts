<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>ductus::CanvasPanel</name>
    <message numerus="yes">
        <source>Pinned in %n frame(s); drag it where it drifts.</source>
        <translation>
            <numerusform>Pinned in %n frame; drag it where it drifts.</numerusform>
            <numerusform>Pinned in %n frames; drag it where it drifts.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ductus::ExportDialog</name>
    <message numerus="yes">
        <source>%1, about %n s left</source>
        <translation>
            <numerusform>%1, about %n s left</numerusform>
            <numerusform>%1, about %n s left</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Done: %1 (%2 x %3, %n frame(s))</source>
        <translation>
            <numerusform>Done: %1 (%2 x %3, %n frame)</numerusform>
            <numerusform>Done: %1 (%2 x %3, %n frames)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ductus::FrameStrip</name>
    <message numerus="yes">
        <source>Drawing %1, held for %n frame(s)</source>
        <translation>
            <numerusform>Drawing %1, held for %n frame</numerusform>
            <numerusform>Drawing %1, held for %n frames</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ductus::StudioWindow</name>
    <message numerus="yes">
        <source>%n act(s) written to %1.</source>
        <translation>
            <numerusform>%n act written to %1.</numerusform>
            <numerusform>%n acts written to %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lines copied.</source>
        <translation>
            <numerusform>%n line copied.</numerusform>
            <numerusform>%n lines copied.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lines pasted.</source>
        <translation>
            <numerusform>%n line pasted.</numerusform>
            <numerusform>%n lines pasted.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n paintings changed in LayerPainter.</source>
        <translation>
            <numerusform>%n painting changed in LayerPainter.</numerusform>
            <numerusform>%n paintings changed in LayerPainter.</numerusform>
        </translation>
    </message>
</context>
</TS>
