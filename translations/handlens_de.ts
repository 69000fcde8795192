<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE">
<context>
    <name>app::ActionTable</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Annotate</source>
        <translation>A&amp;nnotieren</translation>
    </message>
    <message>
        <source>&amp;Go</source>
        <translation>&amp;Gehe zu</translation>
    </message>
    <message>
        <source>F&amp;it</source>
        <translation>An&amp;passen</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Open a dataset...</source>
        <translation>Datensatz ö&amp;ffnen...</translation>
    </message>
    <message>
        <source>Open the &amp;demo</source>
        <translation>&amp;Demo öffnen</translation>
    </message>
    <message>
        <source>&amp;Import annotations...</source>
        <translation>Annotationen &amp;importieren...</translation>
    </message>
    <message>
        <source>&amp;Save the views as a picture...</source>
        <translation>Ansichten als Grafik &amp;speichern...</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>&amp;Note on this frame...</source>
        <translation>&amp;Notiz zu diesem Bild...</translation>
    </message>
    <message>
        <source>Your n&amp;ame...</source>
        <translation>Ihr N&amp;ame...</translation>
    </message>
    <message>
        <source>The name that your marks are kept under</source>
        <translation>Der Name, unter dem Ihre Marken gespeichert werden</translation>
    </message>
    <message>
        <source>&amp;Inspect</source>
        <translation>&amp;Untersuchen</translation>
    </message>
    <message>
        <source>&amp;Benchmark</source>
        <translation>&amp;Benchmark</translation>
    </message>
    <message>
        <source>&amp;Hide all overlays</source>
        <translation>Alle E&amp;inblendungen verbergen</translation>
    </message>
    <message>
        <source>While the key is held</source>
        <translation>Solange die Taste gedrückt ist</translation>
    </message>
    <message>
        <source>Error lines three times as &amp;long</source>
        <translation>Fehlerlinien &amp;3-mal so lang</translation>
    </message>
    <message>
        <source>Lou&amp;pe</source>
        <translation>Lu&amp;pe</translation>
    </message>
    <message>
        <source>Magnifies the pixels around the pointer</source>
        <translation>Vergrößert die Pixel um den Mauszeiger</translation>
    </message>
    <message>
        <source>S&amp;keleton</source>
        <translation>&amp;Skelett</translation>
    </message>
    <message>
        <source>&amp;Epipolar guides</source>
        <translation>&amp;Epipolarlinien</translation>
    </message>
    <message>
        <source>Lines on which the selected joint must lie, as the other views say</source>
        <translation>Linien, auf denen das gewählte Gelenk laut den anderen Ansichten liegen muss</translation>
    </message>
    <message>
        <source>P&amp;re-placed marks</source>
        <translation>&amp;Vorplatzierte Marken</translation>
    </message>
    <message>
        <source>Marks that wait to be accepted</source>
        <translation>Marken, die noch zu übernehmen sind</translation>
    </message>
    <message>
        <source>Joint &amp;names</source>
        <translation>Gelenkn&amp;amen</translation>
    </message>
    <message>
        <source>&amp;Follow the selected joint</source>
        <translation>Gewähltem Gelenk &amp;folgen</translation>
    </message>
    <message>
        <source>Keeps the selected joint in the middle of every zoomed view</source>
        <translation>Hält das gewählte Gelenk in der Mitte jeder gezoomten Ansicht</translation>
    </message>
    <message>
        <source>Mesh: sha&amp;ded</source>
        <translation>Netz: s&amp;chattiert</translation>
    </message>
    <message>
        <source>Mesh: &amp;wireframe</source>
        <translation>Netz: Draht&amp;gitter</translation>
    </message>
    <message>
        <source>Mesh: o&amp;ff</source>
        <translation>Net&amp;z: aus</translation>
    </message>
    <message>
        <source>Next mesh st&amp;yle</source>
        <translation>N&amp;ächster Netzstil</translation>
    </message>
    <message>
        <source>Mesh more &amp;opaque</source>
        <translation>Netz &amp;weniger transparent</translation>
    </message>
    <message>
        <source>Mesh more &amp;transparent</source>
        <translation>Netz &amp;transparenter</translation>
    </message>
    <message>
        <source>Mesh of the left hand</source>
        <translation>Netz der linken Hand</translation>
    </message>
    <message>
        <source>Mesh of the right hand</source>
        <translation>Netz der rechten Hand</translation>
    </message>
    <message>
        <source>Mesh of the recorded pose</source>
        <translation>Netz der aufgezeichneten Pose</translation>
    </message>
    <message>
        <source>Mesh of the fit&apos;s start pose</source>
        <translation>Netz der Startpose der Anpassung</translation>
    </message>
    <message>
        <source>&amp;Brightness, contrast, gamma...</source>
        <translation>&amp;Helligkeit, Kontrast, Gamma...</translation>
    </message>
    <message>
        <source>Of the current view or of all</source>
        <translation>Der aktuellen oder aller Ansichten</translation>
    </message>
    <message>
        <source>&amp;Cameras: hide, reorder...</source>
        <translation>Kameras: ausblenden, or&amp;dnen...</translation>
    </message>
    <message>
        <source>Sho&amp;w whole images</source>
        <translation>Ganze Kame&amp;rabilder zeigen</translation>
    </message>
    <message>
        <source>Ends zoom and pan in all views</source>
        <translation>Hebt Zoom und Verschiebung in allen Ansichten auf</translation>
    </message>
    <message>
        <source>&amp;Zoom all views to the joint</source>
        <translation>Alle Ansichten auf das Gelenk zoo&amp;men</translation>
    </message>
    <message>
        <source>Maximise view 1</source>
        <translation>Ansicht 1 maximieren</translation>
    </message>
    <message>
        <source>Maximise view 2</source>
        <translation>Ansicht 2 maximieren</translation>
    </message>
    <message>
        <source>Maximise view 3</source>
        <translation>Ansicht 3 maximieren</translation>
    </message>
    <message>
        <source>Maximise view 4</source>
        <translation>Ansicht 4 maximieren</translation>
    </message>
    <message>
        <source>Maximise view 5</source>
        <translation>Ansicht 5 maximieren</translation>
    </message>
    <message>
        <source>Maximise view 6</source>
        <translation>Ansicht 6 maximieren</translation>
    </message>
    <message>
        <source>Maximise view 7</source>
        <translation>Ansicht 7 maximieren</translation>
    </message>
    <message>
        <source>Maximise view 8</source>
        <translation>Ansicht 8 maximieren</translation>
    </message>
    <message>
        <source>All views again</source>
        <translation>Wieder alle Ansichten</translation>
    </message>
    <message>
        <source>Reset the 3D sc&amp;ene</source>
        <translation>3D-Szene zur&amp;ücksetzen</translation>
    </message>
    <message>
        <source>Look thro&amp;ugh the current camera</source>
        <translation>Durch die a&amp;ktuelle Kamera blicken</translation>
    </message>
    <message>
        <source>The 3D scene from the current camera</source>
        <translation>Die 3D-Szene aus Sicht der aktuellen Kamera</translation>
    </message>
    <message>
        <source>Li&amp;ght colours</source>
        <translation>He&amp;lle Farben</translation>
    </message>
    <message>
        <source>Full scree&amp;n</source>
        <translation>V&amp;ollbild</translation>
    </message>
    <message>
        <source>&amp;Accept the pre-placed mark</source>
        <translation>Vor&amp;platzierte Marke übernehmen</translation>
    </message>
    <message>
        <source>In the current view or, if that has a mark, in the next one without</source>
        <translation>In der aktuellen Ansicht oder, falls diese eine Marke hat, in der nächsten ohne</translation>
    </message>
    <message>
        <source>Accept in all &amp;views</source>
        <translation>In &amp;allen Ansichten übernehmen</translation>
    </message>
    <message>
        <source>Accept all joints of the &amp;frame</source>
        <translation>Alle Gelenke des &amp;Bildes übernehmen</translation>
    </message>
    <message>
        <source>&amp;Delete the mark</source>
        <translation>Marke &amp;löschen</translation>
    </message>
    <message>
        <source>Of the selected joint in the current view</source>
        <translation>Des gewählten Gelenks in der aktuellen Ansicht</translation>
    </message>
    <message>
        <source>Delete in all vie&amp;ws</source>
        <translation>In allen Ansichten lös&amp;chen</translation>
    </message>
    <message>
        <source>&amp;Occluded, estimated</source>
        <translation>&amp;Verdeckt, geschätzt</translation>
    </message>
    <message>
        <source>The joint is hidden here; its place is a guess</source>
        <translation>Das Gelenk ist hier verborgen; sein Ort ist geschätzt</translation>
    </message>
    <message>
        <source>&amp;Cannot be placed here</source>
        <translation>Hier &amp;nicht platzierbar</translation>
    </message>
    <message>
        <source>&amp;Previous joint</source>
        <translation>V&amp;origes Gelenk</translation>
    </message>
    <message>
        <source>&amp;Next joint</source>
        <translation>Nächstes &amp;Gelenk</translation>
    </message>
    <message>
        <source>Previous view</source>
        <translation>Vorige Ansicht</translation>
    </message>
    <message>
        <source>Next view</source>
        <translation>Nächste Ansicht</translation>
    </message>
    <message>
        <source>Nudge left</source>
        <translation>Nach links rücken</translation>
    </message>
    <message>
        <source>By a quarter of an image pixel</source>
        <translation>Um ein Viertel eines Bildpixels</translation>
    </message>
    <message>
        <source>Nudge right</source>
        <translation>Nach rechts rücken</translation>
    </message>
    <message>
        <source>Nudge up</source>
        <translation>Nach oben rücken</translation>
    </message>
    <message>
        <source>Nudge down</source>
        <translation>Nach unten rücken</translation>
    </message>
    <message>
        <source>Nudge left by a pixel</source>
        <translation>Ein Pixel nach links rücken</translation>
    </message>
    <message>
        <source>Nudge right by a pixel</source>
        <translation>Ein Pixel nach rechts rücken</translation>
    </message>
    <message>
        <source>Nudge up by a pixel</source>
        <translation>Ein Pixel nach oben rücken</translation>
    </message>
    <message>
        <source>Nudge down by a pixel</source>
        <translation>Ein Pixel nach unten rücken</translation>
    </message>
    <message>
        <source>Copy the pose of the previous annotated frame</source>
        <translation>Pose des vorigen annotierten Bildes kopieren</translation>
    </message>
    <message>
        <source>As marks that wait to be checked</source>
        <translation>Als Marken, die noch zu prüfen sind</translation>
    </message>
    <message>
        <source>&amp;Interpolate between annotated frames</source>
        <translation>Zwischen annotierten Bildern &amp;interpolieren</translation>
    </message>
    <message>
        <source>In 3D, along straight lines, over the gap around this frame</source>
        <translation>In 3D, geradlinig, über die Lücke um dieses Bild</translation>
    </message>
    <message>
        <source>Interpolate along a curve</source>
        <translation>Entlang einer Kurve interpolieren</translation>
    </message>
    <message>
        <source>In 3D, cubic, over the gap around this frame</source>
        <translation>In 3D, kubisch, über die Lücke um dieses Bild</translation>
    </message>
    <message>
        <source>&amp;Swap left and right from here on</source>
        <translation>Ab hier links und rechts &amp;tauschen</translation>
    </message>
    <message>
        <source>Delete all marks of this frame</source>
        <translation>Alle Marken dieses Bildes löschen</translation>
    </message>
    <message>
        <source>Delete a range of frames...</source>
        <translation>Marken mehrerer Bilder löschen...</translation>
    </message>
    <message>
        <source>Next joint when all views are done</source>
        <translation>Nächstes Gelenk, wenn alle Ansichten fertig sind</translation>
    </message>
    <message>
        <source>14 joints per hand</source>
        <translation>14 Gelenke je Hand</translation>
    </message>
    <message>
        <source>21 joints per hand</source>
        <translation>21 Gelenke je Hand</translation>
    </message>
    <message>
        <source>With wrist and finger tips</source>
        <translation>Mit Handgelenk und Fingerspitzen</translation>
    </message>
    <message>
        <source>All joints of the model</source>
        <translation>Alle Gelenke des Modells</translation>
    </message>
    <message>
        <source>Move the joint up in the list</source>
        <translation>Gelenk in der Liste nach oben</translation>
    </message>
    <message>
        <source>Move the joint down in the list</source>
        <translation>Gelenk in der Liste nach unten</translation>
    </message>
    <message>
        <source>&amp;Previous frame</source>
        <translation>&amp;Voriges Bild</translation>
    </message>
    <message>
        <source>&amp;Next frame</source>
        <translation>&amp;Nächstes Bild</translation>
    </message>
    <message>
        <source>Ten frames back</source>
        <translation>Zehn Bilder zurück</translation>
    </message>
    <message>
        <source>Ten frames forward</source>
        <translation>Zehn Bilder vor</translation>
    </message>
    <message>
        <source>&amp;First frame</source>
        <translation>&amp;Erstes Bild</translation>
    </message>
    <message>
        <source>&amp;Last frame</source>
        <translation>&amp;Letztes Bild</translation>
    </message>
    <message>
        <source>&amp;Go to frame...</source>
        <translation>&amp;Gehe zu Bild...</translation>
    </message>
    <message>
        <source>Pla&amp;y</source>
        <translation>&amp;Abspielen</translation>
    </message>
    <message>
        <source>Next &amp;bad joint</source>
        <translation>Nächstes &amp;schlechtes Gelenk</translation>
    </message>
    <message>
        <source>Error above the threshold, an outlier, or no 3D point</source>
        <translation>Fehler über der Schwelle, ein Ausreißer oder kein 3D-Punkt</translation>
    </message>
    <message>
        <source>Previous b&amp;ad joint</source>
        <translation>Voriges s&amp;chlechtes Gelenk</translation>
    </message>
    <message>
        <source>Next &amp;unlabelled frame</source>
        <translation>Nächstes &amp;unfertiges Bild</translation>
    </message>
    <message>
        <source>The next frame in which a joint is not done</source>
        <translation>Das nächste Bild, in dem ein Gelenk nicht fertig ist</translation>
    </message>
    <message>
        <source>Previous unlab&amp;elled frame</source>
        <translation>Voriges un&amp;fertiges Bild</translation>
    </message>
    <message>
        <source>Next annotated frame</source>
        <translation>Nächstes annotiertes Bild</translation>
    </message>
    <message>
        <source>Previous annotated frame</source>
        <translation>Voriges annotiertes Bild</translation>
    </message>
    <message>
        <source>Last e&amp;dited frame</source>
        <translation>Zuletzt &amp;bearbeitetes Bild</translation>
    </message>
    <message>
        <source>Error &amp;threshold...</source>
        <translation>Fehlersch&amp;welle...</translation>
    </message>
    <message>
        <source>Joints with a larger error count as bad</source>
        <translation>Gelenke mit größerem Fehler gelten als schlecht</translation>
    </message>
    <message>
        <source>&amp;Fit the current frame</source>
        <translation>Pose an aktuelles Bild &amp;anpassen</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Stopp</translation>
    </message>
    <message>
        <source>Show the fit &amp;panel</source>
        <translation>Bereich „Anpassung“ &amp;zeigen</translation>
    </message>
    <message>
        <source>&amp;Previous iteration</source>
        <translation>&amp;Vorige Iteration</translation>
    </message>
    <message>
        <source>Shows the poses as they were before</source>
        <translation>Zeigt die Posen, wie sie davor waren</translation>
    </message>
    <message>
        <source>&amp;Next iteration</source>
        <translation>&amp;Nächste Iteration</translation>
    </message>
    <message>
        <source>&amp;Result of the fit</source>
        <translation>&amp;Ergebnis der Anpassung</translation>
    </message>
    <message>
        <source>&amp;Shortcuts</source>
        <translation>&amp;Tastenkürzel</translation>
    </message>
    <message>
        <source>&amp;Four hints</source>
        <translation>&amp;Vier Hinweise</translation>
    </message>
    <message>
        <source>&amp;About Handlens</source>
        <translation>Ü&amp;ber Handlens</translation>
    </message>
    <message>
        <source>&amp;Export annotations...</source>
        <translation>Annotationen &amp;exportieren...</translation>
    </message>
    <message>
        <source>&amp;Report on the annotations...</source>
        <translation>Be&amp;richt über die Annotationen...</translation>
    </message>
    <message>
        <source>A page with progress, raters, worst joints and figures</source>
        <translation>Eine Seite mit Fortschritt, Bewertern, schlechtesten Gelenken und Diagrammen</translation>
    </message>
    <message>
        <source>Hand &amp;model of the marks</source>
        <translation>Handmodell der Marken</translation>
    </message>
    <message>
        <source>The hand model, fitted to the 3D joints of this frame</source>
        <translation>Das Handmodell, an die 3D-Gelenke dieses Bildes gebeugt</translation>
    </message>
    <message>
        <source>Propose the &amp;rest from the hand model</source>
        <translation>&amp;Rest aus dem Handmodell vorschlagen</translation>
    </message>
    <message>
        <source>Fits the hand model to the 3D joints of this frame and places the others, to be checked</source>
        <translation>Passt das Handmodell an die 3D-Gelenke dieses Bildes an und platziert die übrigen zur Prüfung</translation>
    </message>
    <message>
        <source>Joints from a &amp;file...</source>
        <translation>Gelenke aus &amp;Datei...</translation>
    </message>
    <message>
        <source>&amp;Start a repeat round</source>
        <translation>Wi&amp;ederholungsrunde beginnen</translation>
    </message>
    <message>
        <source>Next joint of the repeat round</source>
        <translation>Nächstes Gelenk der Wiederholungsrunde</translation>
    </message>
    <message>
        <source>Compare ra&amp;ters</source>
        <translation>Be&amp;werter vergleichen</translation>
    </message>
    <message>
        <source>Next &amp;test frame</source>
        <translation>Nächstes &amp;Testbild</translation>
    </message>
    <message>
        <source>The frames that the benchmark draws from this sequence</source>
        <translation>Die Bilder, die der Benchmark aus dieser Sequenz zieht</translation>
    </message>
    <message>
        <source>Previous test frame</source>
        <translation>Voriges Testbild</translation>
    </message>
    <message>
        <source>A random tenth of your finished joints, your first marks hidden; once more to end the round</source>
        <translation>Ein zufälliges Zehntel Ihrer fertigen Gelenke, ohne Ihre ersten Marken zu sehen; noch einmal beendet den Durchgang</translation>
    </message>
    <message>
        <source>With the chosen methods, from the pose of some frames before</source>
        <translation>Mit den gewählten Methoden, ausgehend von der Pose einige Bilder vorher</translation>
    </message>
    <message>
        <source>&amp;Raters</source>
        <translation>Be&amp;werter</translation>
    </message>
    <message>
        <source>One &amp;view</source>
        <translation>Eine An&amp;sicht</translation>
    </message>
    <message>
        <source>Mar&amp;ks</source>
        <translation>&amp;Marken</translation>
    </message>
    <message>
        <source>&amp;Mesh</source>
        <translation>&amp;Netz</translation>
    </message>
    <message>
        <source>3D s&amp;cene</source>
        <translation>3D-S&amp;zene</translation>
    </message>
    <message>
        <source>&amp;Joint and view</source>
        <translation>&amp;Gelenk und Ansicht</translation>
    </message>
    <message>
        <source>&amp;Nudge</source>
        <translation>&amp;Verschieben</translation>
    </message>
    <message>
        <source>Li&amp;st of joints</source>
        <translation>&amp;Liste der Gelenke</translation>
    </message>
    <message>
        <source>Make a &amp;new dataset...</source>
        <translation>&amp;Neuen Datensatz anlegen...</translation>
    </message>
    <message>
        <source>Of a calibration and videos or folders of images</source>
        <translation>Aus einer Kalibrierung und Videos oder Bilderordnern</translation>
    </message>
    <message>
        <source>&amp;Preferences...</source>
        <translation>&amp;Einstellungen...</translation>
    </message>
    <message>
        <source>Language, your name, keys, colours, memory</source>
        <translation>Sprache, Ihr Name, Tasten, Farben, Speicher</translation>
    </message>
    <message>
        <source>Change the &amp;shortcuts...</source>
        <translation>&amp;Tastenkürzel ändern...</translation>
    </message>
    <message>
        <source>Fra&amp;me the hands</source>
        <translation>&amp;Hände einpassen</translation>
    </message>
    <message>
        <source>Zooms every view to the hands, where they are known</source>
        <translation>Zoomt jede Ansicht auf die Hände, wo sie bekannt sind</translation>
    </message>
    <message>
        <source>Other people&apos;s marks</source>
        <translation>Marken anderer Personen</translation>
    </message>
    <message>
        <source>What others have marked in this sequence, muted; it cannot be changed here</source>
        <translation>Was andere in dieser Sequenz markiert haben, gedämpft; hier nicht änderbar</translation>
    </message>
    <message>
        <source>Which hand is &amp;left and which right</source>
        <translation>Welche Hand &amp;links und welche rechts ist</translation>
    </message>
    <message>
        <source>L and R beside the hands, where they are known</source>
        <translation>L und R neben den Händen, wo sie bekannt sind</translation>
    </message>
    <message>
        <source>L&amp;eft hand</source>
        <translation>L&amp;inke Hand</translation>
    </message>
    <message>
        <source>Marks and mesh of the left hand</source>
        <translation>Marken und Netz der linken Hand</translation>
    </message>
    <message>
        <source>Ri&amp;ght hand</source>
        <translation>Re&amp;chte Hand</translation>
    </message>
    <message>
        <source>Marks and mesh of the right hand</source>
        <translation>Marken und Netz der rechten Hand</translation>
    </message>
    <message>
        <source>&amp;Toolbar</source>
        <translation>&amp;Werkzeugleiste</translation>
    </message>
    <message>
        <source>&amp;Attach masks...</source>
        <translation>&amp;Masken zuordnen...</translation>
    </message>
    <message>
        <source>Gives this sequence the silhouettes of a folder</source>
        <translation>Gibt dieser Sequenz die Silhouetten eines Ordners</translation>
    </message>
    <message>
        <source>Next &amp;method in the 3D scene</source>
        <translation>Nächstes &amp;Verfahren in der 3D-Szene</translation>
    </message>
    <message>
        <source>&amp;Save the benchmark&apos;s results...</source>
        <translation>Ergebnisse des Benchmarks &amp;speichern...</translation>
    </message>
    <message>
        <source>Tables, pairs and a report, in a folder</source>
        <translation>Tabellen, Paare und ein Bericht, in einem Ordner</translation>
    </message>
    <message>
        <source>&amp;Open a benchmark&apos;s results...</source>
        <translation>Ergebnisse eines Benchmarks ö&amp;ffnen...</translation>
    </message>
    <message>
        <source>A folder that was saved here or written by handlens-batch benchmark</source>
        <translation>Ein Ordner, der hier gespeichert oder von handlens-batch benchmark geschrieben wurde</translation>
    </message>
    <message>
        <source>&amp;Layers of the methods</source>
        <translation>Ebenen &amp;der Verfahren</translation>
    </message>
    <message>
        <source>Writes the annotations of this sequence: of all raters where the format names them, else yours</source>
        <translation>Schreibt die Annotationen dieser Sequenz: die aller Bewerter, wo das Format sie nennt, sonst Ihre</translation>
    </message>
    <message>
        <source>Residual a&amp;rrows</source>
        <translation>&amp;Residuenpfeile</translation>
    </message>
    <message>
        <source>How far all clicks of each camera are off, place by place, ten times as long; green: refined</source>
        <translation>Wie weit alle Klicks jeder Kamera danebenliegen, Stelle für Stelle, 10-mal so lang; grün: verfeinert</translation>
    </message>
    <message>
        <source>How the &amp;cameras fit the clicks</source>
        <translation>Wie die &amp;Kameras zu den Klicks passen</translation>
    </message>
    <message>
        <source>What all clicks of the dataset say of its calibration</source>
        <translation>Was alle Klicks des Datensatzes über seine Kalibrierung sagen</translation>
    </message>
    <message>
        <source>Re&amp;fine the calibration...</source>
        <translation>Kalib&amp;rierung verfeinern...</translation>
    </message>
    <message>
        <source>Adjusts the cameras to all clicks and shows what changes; also to return to an earlier calibration</source>
        <translation>Passt die Kameras an alle Klicks an und zeigt, was sich ändert; auch zur Rückkehr zu einer früheren Kalibrierung</translation>
    </message>
    <message>
        <source>&amp;Use the refined calibration</source>
        <translation>Verfeinerte Kalibrierung ver&amp;wenden</translation>
    </message>
    <message>
        <source>As a new calibration file; the old one is kept</source>
        <translation>Als neue Kalibrierungsdatei; die alte bleibt erhalten</translation>
    </message>
    <message>
        <source>Measure this person&apos;s &amp;hands...</source>
        <translation>&amp;Hände dieser Person vermessen...</translation>
    </message>
    <message>
        <source>Bone lengths, scale and girth from annotated frames and masks, as a new dataset</source>
        <translation>Knochenlängen, Skalierung und Dicke aus annotierten Bildern und Masken, als neuer Datensatz</translation>
    </message>
    <message>
        <source>Measure the hands now</source>
        <translation>Hände jetzt vermessen</translation>
    </message>
    <message>
        <source>With what is chosen in the window for measuring hands</source>
        <translation>Mit der Auswahl im Fenster zum Vermessen der Hände</translation>
    </message>
    <message>
        <source>&amp;Contour</source>
        <translation>&amp;Kontur</translation>
    </message>
    <message>
        <source>The observed outline over the inspected views; its colour is its direction</source>
        <translation>Der beobachtete Umriss über den untersuchten Ansichten; seine Farbe ist seine Richtung</translation>
    </message>
    <message>
        <source>&amp;Rim</source>
        <translation>&amp;Rand</translation>
    </message>
    <message>
        <source>Rim points of the posed hands with their normals</source>
        <translation>Randpunkte der Hände in ihrer Pose, mit Normalen</translation>
    </message>
    <message>
        <source>&amp;Matches</source>
        <translation>&amp;Zuordnungen</translation>
    </message>
    <message>
        <source>&amp;Field</source>
        <translation>&amp;Feld</translation>
    </message>
    <message>
        <source>What a rim point of one direction costs at every pixel</source>
        <translation>Was ein Randpunkt einer Richtung an jedem Pixel kostet</translation>
    </message>
    <message>
        <source>&amp;Error</source>
        <translation>F&amp;ehler</translation>
    </message>
    <message>
        <source>The mesh by its distance to the recorded pose</source>
        <translation>Das Netz, gefärbt nach seinem Abstand zur aufgezeichneten Pose</translation>
    </message>
    <message>
        <source>Save this &amp;comparison...</source>
        <translation>Diesen Ver&amp;gleich speichern...</translation>
    </message>
    <message>
        <source>Pair, methods, cameras, layers and iteration, as a small file that opens again</source>
        <translation>Paar, Verfahren, Kameras, Ebenen und Iteration, als kleine Datei, die sich wieder öffnen lässt</translation>
    </message>
    <message>
        <source>Open a com&amp;parison...</source>
        <translation>Verglei&amp;ch öffnen...</translation>
    </message>
    <message>
        <source>R&amp;eview of proposals</source>
        <translation>&amp;Durchsicht der Vorschläge</translation>
    </message>
    <message>
        <source>First &amp;pass...</source>
        <translation>Erster D&amp;urchlauf...</translation>
    </message>
    <message>
        <source>Finds the joints of both hands in many frames without a click, as proposals to be checked</source>
        <translation>Findet die Gelenke beider Hände in vielen Bildern ohne einen Klick, als Vorschläge zur Prüfung</translation>
    </message>
    <message>
        <source>Start the first pass now</source>
        <translation>Ersten Durchlauf jetzt starten</translation>
    </message>
    <message>
        <source>With what is chosen for the first pass</source>
        <translation>Mit der Auswahl für den ersten Durchlauf</translation>
    </message>
    <message>
        <source>&amp;Accept the frame, go on to the next</source>
        <translation>&amp;Bild übernehmen, weiter zum nächsten</translation>
    </message>
    <message>
        <source>Accepts all proposed joints of the frame as they stand</source>
        <translation>Übernimmt alle vorgeschlagenen Gelenke des Bildes, wie sie sind</translation>
    </message>
    <message>
        <source>&amp;Correct the most doubtful joint</source>
        <translation>Zweifelhaftestes Gelenk &amp;korrigieren</translation>
    </message>
    <message>
        <source>Selects it: click it in two views, then accept the frame</source>
        <translation>Wählt es: in zwei Ansichten anklicken, dann das Bild übernehmen</translation>
    </message>
    <message>
        <source>&amp;Next frame to review</source>
        <translation>&amp;Nächstes Bild zur Durchsicht</translation>
    </message>
    <message>
        <source>Frames whose look teaches most come first</source>
        <translation>Bilder, deren Durchsicht am meisten lehrt, kommen zuerst</translation>
    </message>
    <message>
        <source>&amp;Show the review queue</source>
        <translation>&amp;Liste zur Durchsicht zeigen</translation>
    </message>
    <message>
        <source>Silhouettes...</source>
        <translation>Silhouetten...</translation>
    </message>
    <message>
        <source>Finds the hands&apos; silhouettes in the pictures, to be looked at, touched up and kept</source>
        <translation>Findet die Silhouetten der Hände in den Bildern, zum Ansehen, Ausbessern und Behalten</translation>
    </message>
    <message>
        <source>Make the silhouettes now</source>
        <translation>Silhouetten jetzt erzeugen</translation>
    </message>
    <message>
        <source>Of the frames that are chosen in the window for silhouettes</source>
        <translation>Der Bilder, die im Fenster für Silhouetten gewählt sind</translation>
    </message>
    <message>
        <source>Brush for silhouettes</source>
        <translation>Pinsel für Silhouetten</translation>
    </message>
    <message>
        <source>Left button adds, right button takes away, Ctrl and the wheel change its size</source>
        <translation>Linke Taste fügt hinzu, rechte nimmt weg, Strg und Rad ändern seine Größe</translation>
    </message>
    <message>
        <source>Larger brush</source>
        <translation>Größerer Pinsel</translation>
    </message>
    <message>
        <source>Of the brush for silhouettes</source>
        <translation>Des Pinsels für Silhouetten</translation>
    </message>
    <message>
        <source>Smaller brush</source>
        <translation>Kleinerer Pinsel</translation>
    </message>
    <message>
        <source>C&amp;omparison</source>
        <translation>Ver&amp;gleich</translation>
    </message>
    <message>
        <source>Col&amp;umns of the comparison</source>
        <translation>Spa&amp;lten des Vergleichs</translation>
    </message>
    <message>
        <source>&amp;Difference</source>
        <translation>&amp;Differenz</translation>
    </message>
    <message>
        <source>&amp;Uncertainty</source>
        <translation>&amp;Unsicherheit</translation>
    </message>
    <message>
        <source>Where the joints of a result lie with 95 % probability, as the fit judged it</source>
        <translation>Wo die Gelenke eines Ergebnisses mit 95 % Wahrscheinlichkeit liegen, laut der Anpassung</translation>
    </message>
    <message>
        <source>Add the &amp;start</source>
        <translation>&amp;Start hinzufügen</translation>
    </message>
    <message>
        <source>The pose that every method began with, as a column</source>
        <translation>Die Pose, mit der jedes Verfahren begann, als Spalte</translation>
    </message>
    <message>
        <source>Add the &amp;truth</source>
        <translation>&amp;Wahrheit hinzufügen</translation>
    </message>
    <message>
        <source>The recorded pose, as a column</source>
        <translation>Die aufgezeichnete Pose, als Spalte</translation>
    </message>
    <message>
        <source>Add a tracker&apos;s &amp;estimates...</source>
        <translation>Schätzungen eines &amp;Trackers hinzufügen...</translation>
    </message>
    <message>
        <source>A file of joints per frame pair, as handlens-batch benchmark takes it</source>
        <translation>Eine Datei mit Gelenken je Bildpaar, wie handlens-batch benchmark sie nimmt</translation>
    </message>
    <message>
        <source>&amp;Remove the column</source>
        <translation>Spalte &amp;entfernen</translation>
    </message>
    <message>
        <source>&amp;Previous column</source>
        <translation>&amp;Vorige Spalte</translation>
    </message>
    <message>
        <source>What the settings and the wipe are about</source>
        <translation>Auf die sich Einstellungen und Wischblende beziehen</translation>
    </message>
    <message>
        <source>&amp;Next column</source>
        <translation>&amp;Nächste Spalte</translation>
    </message>
    <message>
        <source>Move the column to the &amp;left</source>
        <translation>Spalte nach &amp;links</translation>
    </message>
    <message>
        <source>Move the column to the ri&amp;ght</source>
        <translation>Spalte nach &amp;rechts</translation>
    </message>
    <message>
        <source>&amp;Hide or show the hands in this view</source>
        <translation>&amp;Hände in dieser Ansicht aus- oder einblenden</translation>
    </message>
    <message>
        <source>The column in the current view</source>
        <translation>Die Spalte in der aktuellen Ansicht</translation>
    </message>
    <message>
        <source>&amp;Wipe to the next column</source>
        <translation>Wis&amp;chblende zur nächsten Spalte</translation>
    </message>
    <message>
        <source>The next column lies over this one, behind a line that can be dragged</source>
        <translation>Die nächste Spalte liegt über dieser, hinter einer Linie, die sich ziehen lässt</translation>
    </message>
    <message>
        <source>Line of the wipe to the left</source>
        <translation>Linie der Wischblende nach links</translation>
    </message>
    <message>
        <source>Line of the wipe to the right</source>
        <translation>Linie der Wischblende nach rechts</translation>
    </message>
    <message>
        <source>&amp;Blink with the next column</source>
        <translation>Mit der nächsten Spalte &amp;blinken</translation>
    </message>
    <message>
        <source>Shows this column and the next one by turns</source>
        <translation>Zeigt diese und die nächste Spalte im Wechsel</translation>
    </message>
    <message>
        <source>What &amp;if...</source>
        <translation>W&amp;as wäre, wenn...</translation>
    </message>
    <message>
        <source>Settings of the column&apos;s method, cameras and noise: drag one, and the methods run again</source>
        <translation>Einstellungen für Verfahren, Kameras und Rauschen der Spalte: Ziehen lässt die Verfahren neu rechnen</translation>
    </message>
    <message>
        <source>&amp;Use these settings</source>
        <translation>Diese Einstell&amp;ungen verwenden</translation>
    </message>
    <message>
        <source>Gives the column what was tried under What if</source>
        <translation>Gibt der Spalte, was unter „Was wäre, wenn“ probiert wurde</translation>
    </message>
    <message>
        <source>&amp;Add these settings as a column</source>
        <translation>Diese Einstellungen als S&amp;palte hinzufügen</translation>
    </message>
    <message>
        <source>What was tried under What if, beside the column</source>
        <translation>Was unter „Was wäre, wenn“ probiert wurde, neben der Spalte</translation>
    </message>
    <message>
        <source>Bac&amp;k to what was fitted</source>
        <translation>&amp;Zurück zum Angepassten</translation>
    </message>
    <message>
        <source>Ends what was tried under What if</source>
        <translation>Beendet, was unter „Was wäre, wenn“ probiert wurde</translation>
    </message>
    <message>
        <source>What does each &amp;camera add?</source>
        <translation>Was bringt jede &amp;Kamera?</translation>
    </message>
    <message>
        <source>Fits without each camera in turn</source>
        <translation>Passt reihum ohne je eine Kamera an</translation>
    </message>
    <message>
        <source>Save as a &amp;picture...</source>
        <translation>Als Gra&amp;fik speichern...</translation>
    </message>
    <message>
        <source>Views, titles and curves on white paper: PNG, or SVG or PDF with lines and marks as vectors</source>
        <translation>Ansichten, Titel und Kurven auf weißem Papier: PNG, oder SVG oder PDF mit Linien und Marken als Vektoren</translation>
    </message>
    <message>
        <source>Save the iterations as a &amp;film...</source>
        <translation>Iterationen als Fil&amp;m speichern...</translation>
    </message>
    <message>
        <source>The comparison from the start pose to the last iteration</source>
        <translation>Der Vergleich von der Startpose bis zur letzten Iteration</translation>
    </message>
    <message>
        <source>&amp;Report of this comparison...</source>
        <translation>&amp;Bericht zu diesem Vergleich...</translation>
    </message>
    <message>
        <source>One page with pictures, tables, settings and the command that makes it again</source>
        <translation>Eine Seite mit Grafiken, Tabellen, Einstellungen und dem Befehl, der sie wieder erzeugt</translation>
    </message>
    <message>
        <source>&amp;Run or stop the benchmark</source>
        <translation>Benchmark sta&amp;rten oder anhalten</translation>
    </message>
    <message>
        <source>Fil&amp;ter the benchmark&apos;s pairs</source>
        <translation>Paare des Benchmarks fil&amp;tern</translation>
    </message>
    <message>
        <source>By errors, differences of methods, sequences and frames, such as A-B&gt;1</source>
        <translation>Nach Fehlern, Differenzen von Verfahren, Sequenzen und Bildern, etwa A-B&gt;1</translation>
    </message>
    <message>
        <source>Run the selected &amp;pairs</source>
        <translation>Gewählte &amp;Paare berechnen</translation>
    </message>
    <message>
        <source>Adds what the ticked methods make of them to the results that are shown</source>
        <translation>Fügt den gezeigten Ergebnissen hinzu, was die angekreuzten Verfahren daraus machen</translation>
    </message>
    <message>
        <source>From rim points to their contour points, by distance or finger; a dash pattern for every reason to refuse one</source>
        <translation>Von Randpunkten zu ihren Konturpunkten, nach Abstand oder Finger; je Grund einer Verwerfung ein Strichmuster</translation>
    </message>
    <message>
        <source>Silhouettes: red is seen but not covered, blue is covered but not seen, a hatched forearm does not count</source>
        <translation>Silhouetten: Rot ist gesehen, aber nicht bedeckt; Blau ist bedeckt, aber nicht gesehen; ein schraffierter Unterarm zählt nicht</translation>
    </message>
    <message>
        <source>Matches of the next finger</source>
        <translation>Zuordnungen des nächsten Fingers</translation>
    </message>
    <message>
        <source>All matches by distance, all by finger, then those of one finger or the palm after the other</source>
        <translation>Alle Zuordnungen nach Abstand, alle nach Finger, dann die eines Fingers oder der Handfläche nach der anderen</translation>
    </message>
    <message>
        <source>Sweep the setting</source>
        <translation>Einstellung durchlaufen</translation>
    </message>
    <message>
        <source>Fits at a row of values of the setting that was changed last, and draws the error over it; once more stops</source>
        <translation>Passt mit einer Reihe von Werten der zuletzt geänderten Einstellung an und zeichnet den Fehler darüber; noch einmal hält an</translation>
    </message>
</context>
<context>
    <name>app::CalibrationPage</name>
    <message>
        <source>as usual for its kind</source>
        <translation>wie für die Art üblich</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>Zentimeter</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>The calibration</source>
        <translation>Die Kalibrierung</translation>
    </message>
    <message>
        <source>Unit of length</source>
        <translation>Längeneinheit</translation>
    </message>
    <message>
        <source>Anipose, OpenCV, EasyMocap, JARVIS, MATLAB and others: the kind is recognised.</source>
        <translation>Anipose, OpenCV, EasyMocap, JARVIS, MATLAB und andere: Die Art wird erkannt.</translation>
    </message>
    <message>
        <source>Sizes, rotations and lenses make sense, and every camera sees where the others look.</source>
        <translation>Größen, Rotationen und Linsen sind plausibel, und jede Kamera sieht, wohin die anderen blicken.</translation>
    </message>
    <message numerus="yes">
        <source>Recognised as %1: %n camera(s).</source>
        <translation>
            <numerusform>Erkannt als %1: %n Kamera.</numerusform>
            <numerusform>Erkannt als %1: %n Kameras.</numerusform>
        </translation>
    </message>
    <message>
        <source>They stand about %1 mm from where they look.</source>
        <translation>Sie stehen etwa %1 mm von dort entfernt, wohin sie blicken.</translation>
    </message>
    <message>
        <source>Choose the calibration of the cameras.</source>
        <translation>Wählen Sie die Kalibrierung der Kameras.</translation>
    </message>
    <message>
        <source>There is no such calibration file.</source>
        <translation>Diese Kalibrierungsdatei gibt es nicht.</translation>
    </message>
    <message>
        <source>The calibration cannot be read.</source>
        <translation>Die Kalibrierung kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>The calibration is being read...</source>
        <translation>Die Kalibrierung wird gelesen...</translation>
    </message>
</context>
<context>
    <name>app::ComparisonReport</name>
    <message>
        <source>Method</source>
        <translation>Methode</translation>
    </message>
    <message>
        <source>Start, mm</source>
        <translation>Start, mm</translation>
    </message>
    <message>
        <source>Shown, mm</source>
        <translation>Gezeigt, mm</translation>
    </message>
    <message>
        <source>Result, mm</source>
        <translation>Ergebnis, mm</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Iterationen</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>Error by iteration</source>
        <translation>Fehler je Iteration</translation>
    </message>
    <message>
        <source>Cost by iteration</source>
        <translation>Kosten je Iteration</translation>
    </message>
    <message>
        <source>Joint, error in mm</source>
        <translation>Gelenk, Fehler in mm</translation>
    </message>
    <message>
        <source>Option</source>
        <translation>Option</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>To make this page again</source>
        <translation>Diese Seite erneut erzeugen</translation>
    </message>
    <message>
        <source>The file %1 holds:</source>
        <translation>Die Datei %1 enthält:</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Ansichten</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>Error joint by joint</source>
        <translation>Fehler Gelenk für Gelenk</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
</context>
<context>
    <name>app::ExportWindow</name>
    <message>
        <source>Export annotations</source>
        <translation>Annotationen exportieren</translation>
    </message>
    <message>
        <source>&lt;b&gt;Holds&lt;/b&gt;</source>
        <translation>&lt;b&gt;Enthält&lt;/b&gt;</translation>
    </message>
    <message>
        <source>&lt;b&gt;Read by&lt;/b&gt;</source>
        <translation>&lt;b&gt;Gelesen von&lt;/b&gt;</translation>
    </message>
    <message>
        <source>&lt;b&gt;Not in it&lt;/b&gt;</source>
        <translation>&lt;b&gt;Nicht enthalten&lt;/b&gt;</translation>
    </message>
    <message>
        <source>&lt;b&gt;Written are&lt;/b&gt;</source>
        <translation>&lt;b&gt;Geschrieben werden&lt;/b&gt;</translation>
    </message>
    <message>
        <source>Choose where...</source>
        <translation>Ort wählen...</translation>
    </message>
    <message>
        <source>Your own annotations of this sequence</source>
        <translation>Ihre eigenen Annotationen dieser Sequenz</translation>
    </message>
    <message>
        <source>The annotations of all raters of this sequence, with their names</source>
        <translation>Die Annotationen aller Bewerter dieser Sequenz, mit Namen</translation>
    </message>
</context>
<context>
    <name>app::FileActions</name>
    <message>
        <source>Handlens ground truth</source>
        <translation>Handlens-Ground-Truth</translation>
    </message>
    <message>
        <source>Files of the method&apos;s authors</source>
        <translation>Dateien der Autoren der Methode</translation>
    </message>
    <message>
        <source>COCO keypoints</source>
        <translation>COCO-Keypoints</translation>
    </message>
    <message>
        <source>Anipose, 2D</source>
        <translation>Anipose, 2D</translation>
    </message>
    <message>
        <source>Anipose, 3D</source>
        <translation>Anipose, 3D</translation>
    </message>
    <message>
        <source>DeepLabCut, Lightning Pose</source>
        <translation>DeepLabCut, Lightning Pose</translation>
    </message>
    <message>
        <source>TRC, marker motion</source>
        <translation>TRC, Markerbewegung</translation>
    </message>
    <message>
        <source>InterHand2.6M</source>
        <translation>InterHand2.6M</translation>
    </message>
    <message>
        <source>FreiHAND, HanCo</source>
        <translation>FreiHAND, HanCo</translation>
    </message>
    <message>
        <source>Table of 3D joints</source>
        <translation>Tabelle der 3D-Gelenke</translation>
    </message>
    <message>
        <source>Table of marks</source>
        <translation>Tabelle der Marken</translation>
    </message>
    <message>
        <source>%1 – a new folder (*)</source>
        <translation>%1 – ein neuer Ordner (*)</translation>
    </message>
    <message>
        <source>Handlens and scripts of your own (JSON)</source>
        <translation>Handlens und eigene Skripte (JSON)</translation>
    </message>
    <message>
        <source>Marks in whole pixels, a folder per camera and a text file per frame.</source>
        <translation>Marken in ganzen Pixeln, ein Ordner je Kamera und eine Textdatei je Bild.</translation>
    </message>
    <message>
        <source>The programs of the method&apos;s authors</source>
        <translation>Die Programme der Autoren des Verfahrens</translation>
    </message>
    <message>
        <source>Fractions of pixels, 3D joints, joints beyond the 14 of a hand; occluded and missing are both 0 0</source>
        <translation>Bruchteile von Pixeln, 3D-Gelenke, Gelenke über die 14 einer Hand hinaus; verdeckt und fehlend sind beide 0 0</translation>
    </message>
    <message>
        <source>Marks per picture and hand, each visible, occluded or missing.</source>
        <translation>Marken je Bild und Hand, jeweils sichtbar, verdeckt oder fehlend.</translation>
    </message>
    <message>
        <source>MMPose, Detectron2, CVAT, FiftyOne and most trainers of networks (JSON)</source>
        <translation>MMPose, Detectron2, CVAT, FiftyOne und die meisten Trainingsprogramme (JSON)</translation>
    </message>
    <message>
        <source>3D joints, cameras, who clicked and who accepted</source>
        <translation>3D-Gelenke, Kameras, wer geklickt und wer übernommen hat</translation>
    </message>
    <message>
        <source>Marks as a table per camera with a row per frame.</source>
        <translation>Marken als Tabelle je Kamera mit einer Zeile je Bild.</translation>
    </message>
    <message>
        <source>Anipose and aniposelib (CSV)</source>
        <translation>Anipose und aniposelib (CSV)</translation>
    </message>
    <message>
        <source>3D joints and states: occluded marks look like visible ones</source>
        <translation>3D-Gelenke und Zustände: verdeckte Marken sehen wie sichtbare aus</translation>
    </message>
    <message>
        <source>3D joints with error and number of cameras, a row per frame.</source>
        <translation>3D-Gelenke mit Fehler und Zahl der Kameras, eine Zeile je Bild.</translation>
    </message>
    <message>
        <source>Anipose and what reads its results (CSV)</source>
        <translation>Anipose und Programme, die seine Ergebnisse lesen (CSV)</translation>
    </message>
    <message>
        <source>The marks themselves, uncertainties and cameras</source>
        <translation>Die Marken selbst, Unsicherheiten und Kameras</translation>
    </message>
    <message>
        <source>Marks as one CollectedData table per camera, a row per annotated frame.</source>
        <translation>Marken als eine CollectedData-Tabelle je Kamera, eine Zeile je annotiertem Bild.</translation>
    </message>
    <message>
        <source>DeepLabCut, Lightning Pose, napari-deeplabcut (CSV)</source>
        <translation>DeepLabCut, Lightning Pose, napari-deeplabcut (CSV)</translation>
    </message>
    <message>
        <source>3D joints as moving markers, a row per frame of the sequence.</source>
        <translation>3D-Gelenke als bewegte Marker, eine Zeile je Bild der Sequenz.</translation>
    </message>
    <message>
        <source>OpenSim, Mokka, Visual3D and other programs for motion</source>
        <translation>OpenSim, Mokka, Visual3D und andere Bewegungsprogramme</translation>
    </message>
    <message>
        <source>The marks themselves, uncertainties and cameras; it cannot be imported again</source>
        <translation>Die Marken selbst, Unsicherheiten und Kameras; kann nicht wieder importiert werden</translation>
    </message>
    <message>
        <source>3D joints of both hands in that dataset&apos;s order, and the cameras.</source>
        <translation>3D-Gelenke beider Hände in der Reihenfolge jenes Datensatzes, und die Kameras.</translation>
    </message>
    <message>
        <source>Loaders written for InterHand2.6M (JSON)</source>
        <translation>Lader für InterHand2.6M (JSON)</translation>
    </message>
    <message>
        <source>The marks themselves, uncertainties and lens distortion; it cannot be imported again</source>
        <translation>Die Marken selbst, Unsicherheiten und Verzeichnung; kann nicht wieder importiert werden</translation>
    </message>
    <message>
        <source>21 joints of a hand in metres and the cameras, a file per frame and hand.</source>
        <translation>21 Gelenke einer Hand in Metern und die Kameras, eine Datei je Bild und Hand.</translation>
    </message>
    <message>
        <source>Loaders written for FreiHAND or HanCo (JSON)</source>
        <translation>Lader für FreiHAND oder HanCo (JSON)</translation>
    </message>
    <message>
        <source>Spreadsheets, R, pandas (CSV)</source>
        <translation>Tabellenprogramme, R, pandas (CSV)</translation>
    </message>
    <message>
        <source>The marks themselves and the cameras; it cannot be imported again</source>
        <translation>Die Marken selbst und die Kameras; kann nicht wieder importiert werden</translation>
    </message>
    <message>
        <source>Spreadsheets, R, pandas, and Handlens (CSV)</source>
        <translation>Tabellenprogramme, R, pandas und Handlens (CSV)</translation>
    </message>
    <message>
        <source>3D joints and the cameras</source>
        <translation>3D-Gelenke und die Kameras</translation>
    </message>
    <message>
        <source>Only proposals and the list of undo steps</source>
        <translation>Nur Vorschläge und die Liste der rückgängig machbaren Schritte</translation>
    </message>
    <message>
        <source>SLEAP</source>
        <translation>SLEAP</translation>
    </message>
    <message>
        <source>Labels and guesses of a project (.slp) or of an analysis export (.h5).</source>
        <translation>Markierungen und Vorhersagen eines Projekts (.slp) oder eines Analyse-Exports (.h5).</translation>
    </message>
    <message>
        <source>SLEAP and sleap-io (HDF5)</source>
        <translation>SLEAP und sleap-io (HDF5)</translation>
    </message>
    <message>
        <source>Everything: it can be imported, not exported</source>
        <translation>Alles: kann eingelesen, aber nicht exportiert werden</translation>
    </message>
    <message>
        <source>Label3D, DANNCE</source>
        <translation>Label3D, DANNCE</translation>
    </message>
    <message>
        <source>Clicks and 3D points of a session, or the labels exported for DANNCE.</source>
        <translation>Klicks und 3D-Punkte einer Sitzung oder die für DANNCE exportierten Markierungen.</translation>
    </message>
    <message>
        <source>Label3D and DANNCE (MATLAB)</source>
        <translation>Label3D und DANNCE (MATLAB)</translation>
    </message>
    <message>
        <source>3D joints with their uncertainty, every mark of every rater with its state and error, and the cameras.</source>
        <translation>3D-Gelenke mit ihrer Unsicherheit, jede Marke jedes Bewerters mit Zustand und Fehler, und die Kameras.</translation>
    </message>
    <message>
        <source>A row per 3D joint of every rater: millimetres, uncertainty, error, state.</source>
        <translation>Eine Zeile je 3D-Gelenk jedes Bewerters: Millimeter, Unsicherheit, Fehler, Zustand.</translation>
    </message>
    <message>
        <source>A row per mark of every rater: pixel, state, how it was placed; proposals, too.</source>
        <translation>Eine Zeile je Marke jedes Bewerters: Pixel, Zustand, wie sie gesetzt wurde; auch Vorschläge.</translation>
    </message>
</context>
<context>
    <name>app::FootagePage</name>
    <message>
        <source>The videos of the cameras, or folders of numbered images. Drop them here, or a folder with all of them. Nothing is copied: the footage stays where it is.</source>
        <translation>Die Videos der Kameras oder Ordner mit nummerierten Bildern. Legen Sie sie hier ab, oder einen Ordner mit allen. Nichts wird kopiert: Die Aufnahmen bleiben, wo sie sind.</translation>
    </message>
    <message>
        <source>Video or image folder</source>
        <translation>Video oder Bilderordner</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Starts at frame</source>
        <translation>Beginnt bei Bild</translation>
    </message>
    <message>
        <source>The frame of this footage that was recorded when the sequence begins.</source>
        <translation>Das Bild dieser Aufnahme, das zu Beginn der Sequenz aufgenommen wurde.</translation>
    </message>
    <message>
        <source>Name of the sequence</source>
        <translation>Name der Sequenz</translation>
    </message>
    <message>
        <source>Add videos...</source>
        <translation>Videos hinzufügen...</translation>
    </message>
    <message>
        <source>Add a folder...</source>
        <translation>Ordner hinzufügen...</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>A folder of numbered images, or of videos</source>
        <translation>Ein Ordner mit nummerierten Bildern oder mit Videos</translation>
    </message>
    <message>
        <source>Videos of the cameras</source>
        <translation>Videos der Kameras</translation>
    </message>
    <message>
        <source>its first</source>
        <translation>ihr erstes</translation>
    </message>
    <message>
        <source>not used</source>
        <translation>nicht verwendet</translation>
    </message>
    <message>
        <source>Add the videos or image folders of the cameras.</source>
        <translation>Fügen Sie die Videos oder Bilderordner der Kameras hinzu.</translation>
    </message>
    <message>
        <source>Two pieces of footage are given to %1.</source>
        <translation>%1 sind zwei Aufnahmen zugeordnet.</translation>
    </message>
    <message>
        <source>Choose the camera of each piece of footage.</source>
        <translation>Wählen Sie zu jeder Aufnahme die Kamera.</translation>
    </message>
    <message>
        <source>Give the sequence a name.</source>
        <translation>Geben Sie der Sequenz einen Namen.</translation>
    </message>
</context>
<context>
    <name>app::HandsPage</name>
    <message>
        <source>The demo&apos;s hands</source>
        <translation>Die Hände der Demo</translation>
    </message>
    <message>
        <source>A left and a right hand of usual size. They can be measured to a person&apos;s own later, from clicked joints.</source>
        <translation>Eine linke und eine rechte Hand üblicher Größe. Später lassen sich aus angeklickten Gelenken die Hände einer Person vermessen.</translation>
    </message>
    <message>
        <source>The hands of another dataset</source>
        <translation>Die Hände eines anderen Datensatzes</translation>
    </message>
    <message>
        <source>Such as this person&apos;s, measured before, or imported ones.</source>
        <translation>Etwa die früher vermessenen dieser Person oder importierte.</translation>
    </message>
    <message>
        <source>The folder of a dataset</source>
        <translation>Der Ordner eines Datensatzes</translation>
    </message>
    <message>
        <source>No hand model</source>
        <translation>Kein Handmodell</translation>
    </message>
    <message>
        <source>Joints can be clicked, of hands or of anything else. Nothing is fitted to silhouettes.</source>
        <translation>Gelenke lassen sich anklicken, von Händen oder von anderem. An Silhouetten wird nichts angepasst.</translation>
    </message>
    <message>
        <source>Choose the dataset whose hands are taken.</source>
        <translation>Wählen Sie den Datensatz, dessen Hände genommen werden.</translation>
    </message>
    <message>
        <source>That folder is not a dataset: it has no dataset.json.</source>
        <translation>Dieser Ordner ist kein Datensatz: Er enthält keine dataset.json.</translation>
    </message>
</context>
<context>
    <name>app::MainWindow</name>
    <message>
        <source>No annotated frame before this one.</source>
        <translation>Kein annotiertes Bild vor diesem.</translation>
    </message>
    <message>
        <source>Frame %1 has no 3D joint that is missing here.</source>
        <translation>Bild %1 hat kein 3D-Gelenk, das hier fehlt.</translation>
    </message>
    <message>
        <source>Annotate a frame before and a frame after this one first.</source>
        <translation>Zuerst ein Bild vor und ein Bild nach diesem annotieren.</translation>
    </message>
    <message>
        <source>No joint has a 3D point in both frame %1 and frame %2.</source>
        <translation>Kein Gelenk hat sowohl in Bild %1 als auch in Bild %2 einen 3D-Punkt.</translation>
    </message>
    <message>
        <source>There are no marks of yours there.</source>
        <translation>Dort gibt es keine Marken von Ihnen.</translation>
    </message>
    <message>
        <source>Delete a range of frames</source>
        <translation>Marken mehrerer Bilder löschen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Open a dataset to begin.</source>
        <translation>Zum Beginnen einen Datensatz öffnen.</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
    <message>
        <source>This could not be opened. %1</source>
        <translation>Das konnte nicht geöffnet werden. %1</translation>
    </message>
    <message>
        <source>Not saved yet, but nothing is lost: it is tried again every few seconds. %1</source>
        <translation>Noch nicht gespeichert, aber nichts ist verloren: Es wird alle paar Sekunden erneut versucht. %1</translation>
    </message>
    <message>
        <source>Read-only: %1. You can look and export; edits are not possible.</source>
        <translation>Schreibgeschützt: %1. Ansehen und Exportieren sind möglich, Bearbeiten nicht.</translation>
    </message>
    <message>
        <source>Exported to %1</source>
        <translation>Exportiert nach %1</translation>
    </message>
    <message numerus="yes">
        <source>%n mark(s) imported from %1</source>
        <translation>
            <numerusform>%n Marke aus %1 importiert</numerusform>
            <numerusform>%n Marken aus %1 importiert</numerusform>
        </translation>
    </message>
    <message>
        <source>Fitting</source>
        <translation>Anpassung</translation>
    </message>
    <message>
        <source>Fitting: %1</source>
        <translation>Anpassung: %1</translation>
    </message>
    <message>
        <source>Benchmark</source>
        <translation>Benchmark</translation>
    </message>
    <message>
        <source>Benchmark: %1</source>
        <translation>Benchmark: %1</translation>
    </message>
    <message>
        <source>Open a dataset</source>
        <translation>Datensatz öffnen</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>Noch keine</translation>
    </message>
    <message>
        <source>Import annotations</source>
        <translation>Annotationen importieren</translation>
    </message>
    <message>
        <source>Save the views as a picture</source>
        <translation>Ansichten als Grafik speichern</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Grafiken (*.png)</translation>
    </message>
    <message>
        <source>%1 could not be written.</source>
        <translation>%1 konnte nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>Your name</source>
        <translation>Ihr Name</translation>
    </message>
    <message>
        <source>Your marks are kept under this name:</source>
        <translation>Ihre Marken werden unter diesem Namen gespeichert:</translation>
    </message>
    <message>
        <source>About Handlens</source>
        <translation>Über Handlens</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Handlens %1&lt;/h3&gt;&lt;p&gt;3D hand ground truth in calibrated multi-camera footage.&lt;/p&gt;&lt;p&gt;MIT licence. Built with Qt, VTK, Eigen, OpenCV, SQLite and others.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Handlens %1&lt;/h3&gt;&lt;p&gt;3D-Ground-Truth von Händen in kalibrierten Mehrkamera-Aufnahmen.&lt;/p&gt;&lt;p&gt;MIT-Lizenz. Erstellt mit Qt, VTK, Eigen, OpenCV, SQLite und anderen.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&amp;Undo %1</source>
        <translation>&amp;Rückgängig: %1</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo %1</source>
        <translation>&amp;Wiederherstellen: %1</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>No bad joint in that direction.</source>
        <translation>Kein schlechtes Gelenk in dieser Richtung.</translation>
    </message>
    <message>
        <source>Every frame in that direction is done.</source>
        <translation>Alle Bilder in dieser Richtung sind fertig.</translation>
    </message>
    <message>
        <source>No frame with marks in that direction.</source>
        <translation>Kein Bild mit Marken in dieser Richtung.</translation>
    </message>
    <message>
        <source>Nothing was edited yet.</source>
        <translation>Es wurde noch nichts bearbeitet.</translation>
    </message>
    <message>
        <source>The hand model has nothing to add: every joint of the list that it knows has a mark.</source>
        <translation>Das Handmodell hat nichts beizutragen: Jedes Gelenk der Liste, das es kennt, hat eine Marke.</translation>
    </message>
    <message>
        <source>Finish some joints first: there is nothing to mark again.</source>
        <translation>Zuerst einige Gelenke fertigstellen: Es gibt nichts erneut zu markieren.</translation>
    </message>
    <message>
        <source>Every joint of the round is marked: end it to see how you did.</source>
        <translation>Alle Gelenke des Durchgangs sind markiert: Durchgang beenden, um das Ergebnis zu sehen.</translation>
    </message>
    <message>
        <source>No repeat round is under way.</source>
        <translation>Es läuft keine Wiederholungsrunde.</translation>
    </message>
    <message>
        <source>Export annotations</source>
        <translation>Annotationen exportieren</translation>
    </message>
    <message>
        <source>Report on the annotations</source>
        <translation>Bericht über die Annotationen</translation>
    </message>
    <message>
        <source>Pages (*.html)</source>
        <translation>Seiten (*.html)</translation>
    </message>
    <message>
        <source>Joints from a file</source>
        <translation>Gelenke aus Datei</translation>
    </message>
    <message>
        <source>Lists of joints (*.json)</source>
        <translation>Gelenklisten (*.json)</translation>
    </message>
    <message>
        <source>Report written to %1</source>
        <translation>Bericht geschrieben nach %1</translation>
    </message>
    <message>
        <source>No test frame in that direction, as the benchmark is set.</source>
        <translation>Kein Testbild in dieser Richtung, so wie der Benchmark eingestellt ist.</translation>
    </message>
    <message>
        <source>Your last edits are not saved yet. Make room or give permission where they are kept, or export them elsewhere; closing once more gives them up.</source>
        <translation>Ihre letzten Änderungen sind noch nicht gespeichert. Schaffen Sie dort, wo sie liegen, Platz oder Schreibrechte, oder exportieren Sie sie anderswohin; nochmaliges Schließen gibt sie auf.</translation>
    </message>
    <message>
        <source>The hand model misses the marked joints by %1 mm: are units, joints and hands right? Nothing is proposed.</source>
        <translation>Das Handmodell verfehlt die markierten Gelenke um %1 mm: Stimmen Einheit, Gelenke und Hände? Es wird nichts vorgeschlagen.</translation>
    </message>
    <message numerus="yes">
        <source>The hand model meets %n marked joint(s) within %1 mm.</source>
        <translation>
            <numerusform>Das Handmodell trifft %n markiertes Gelenk auf %1 mm genau.</numerusform>
            <numerusform>Das Handmodell trifft %n markierte Gelenke auf %1 mm genau.</numerusform>
        </translation>
    </message>
    <message>
        <source>report</source>
        <translation>bericht</translation>
    </message>
    <message>
        <source>Where are the videos and images now? Folders below are looked through, too.</source>
        <translation>Wo sind die Videos und Bilder jetzt? Auch Unterordner werden durchsucht.</translation>
    </message>
    <message>
        <source>Nothing of the missing footage lies in that folder.</source>
        <translation>In diesem Ordner liegt nichts von den fehlenden Aufnahmen.</translation>
    </message>
    <message numerus="yes">
        <source>%n piece(s) of footage found; the dataset keeps the new places.</source>
        <translation>
            <numerusform>%n Aufnahme gefunden; der Datensatz merkt sich den neuen Ort.</numerusform>
            <numerusform>%n Aufnahmen gefunden; der Datensatz merkt sich die neuen Orte.</numerusform>
        </translation>
    </message>
    <message>
        <source>Looking for footage</source>
        <translation>Aufnahmen werden gesucht</translation>
    </message>
    <message>
        <source>Saved to %1</source>
        <translation>Gespeichert in %1</translation>
    </message>
    <message numerus="yes">
        <source>and %n more: see handlens-batch check</source>
        <translation>
            <numerusform>und %n weiterer: siehe handlens-batch check</numerusform>
            <numerusform>und %n weitere: siehe handlens-batch check</numerusform>
        </translation>
    </message>
    <message>
        <source>About the footage: %1</source>
        <translation>Zu den Aufnahmen: %1</translation>
    </message>
    <message>
        <source>Toolbar</source>
        <translation>Werkzeugleiste</translation>
    </message>
    <message>
        <source>Attach a folder of masks</source>
        <translation>Einen Ordner mit Masken zuordnen</translation>
    </message>
    <message>
        <source>The name that your marks are kept under (%1)</source>
        <translation>Der Name, unter dem Ihre Marken gespeichert werden (%1)</translation>
    </message>
    <message>
        <source>Your name: %1</source>
        <translation>Ihr Name: %1</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message numerus="yes">
        <source>%n mark(s) of %1</source>
        <translation>
            <numerusform>%n Marke von %1</numerusform>
            <numerusform>%n Marken von %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n note(s)</source>
        <translation>
            <numerusform>%n Notiz</numerusform>
            <numerusform>%n Notizen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 in %2</translation>
    </message>
    <message>
        <source> and </source>
        <translation> und </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s)</source>
        <translation>
            <numerusform>%n Bild</numerusform>
            <numerusform>%n Bildern</numerusform>
        </translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>%1 would replace %2.</source>
        <translation>%1 würde %2 ersetzen.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>Keep what is there</source>
        <translation>Vorhandenes behalten</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>%1 importieren</translation>
    </message>
    <message>
        <source>%1 has labels of %2, but none of this sequence. Import them all the same?</source>
        <translation>%1 hat Marken von %2, aber keine dieser Sequenz. Trotzdem importieren?</translation>
    </message>
    <message>
        <source>Nothing was imported.</source>
        <translation>Nichts wurde importiert.</translation>
    </message>
    <message>
        <source>Continue the repeat round? Your first marks are hidden until you end it.</source>
        <translation>Die Wiederholungsrunde fortsetzen? Ihre ersten Marken bleiben verborgen, bis Sie sie beenden.</translation>
    </message>
    <message>
        <source>Start a repeat round? A random tenth of your finished joints is asked for once more, to see how well you repeat yourself. Your first marks are kept, and hidden until you end the round.</source>
        <translation>Eine Wiederholungsrunde beginnen? Ein zufälliges Zehntel Ihrer fertigen Gelenke wird noch einmal abgefragt, um zu messen, wie genau Sie sich wiederholen. Ihre ersten Marken bleiben erhalten und sind verborgen, bis Sie die Runde beenden.</translation>
    </message>
    <message>
        <source>Start the repeat round</source>
        <translation>Wiederholungsrunde beginnen</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Nicht jetzt</translation>
    </message>
    <message>
        <source>Repeat round: your first marks are hidden. %1 of %2 joints.</source>
        <translation>Wiederholungsrunde: Ihre ersten Marken sind verborgen. %1 von %2 Gelenken.</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>There is no frame %1: sequence &quot;%2&quot; has frames 0-%3. The last one is shown.</source>
        <translation>Bild %1 gibt es nicht: Sequenz „%2“ hat die Bilder 0-%3. Das letzte wird gezeigt.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>No program opened %1.</source>
        <translation>Kein Programm hat %1 geöffnet.</translation>
    </message>
    <message>
        <source>Nothing was changed: %1 holds nothing that is not there already.</source>
        <translation>Nichts wurde geändert: %1 enthält nichts, was nicht schon da ist.</translation>
    </message>
    <message>
        <source>Results saved in %1</source>
        <translation>Ergebnisse gespeichert in %1</translation>
    </message>
    <message>
        <source>Comparisons (*.json)</source>
        <translation>Vergleiche (*.json)</translation>
    </message>
    <message>
        <source>Fit a pair first.</source>
        <translation>Zuerst ein Paar anpassen.</translation>
    </message>
    <message>
        <source>Save this comparison</source>
        <translation>Diesen Vergleich speichern</translation>
    </message>
    <message>
        <source>Open a comparison</source>
        <translation>Vergleich öffnen</translation>
    </message>
    <message>
        <source>No other person has marks in this sequence.</source>
        <translation>Keine andere Person hat Marken in dieser Sequenz.</translation>
    </message>
    <message>
        <source>Refine the calibration</source>
        <translation>Kalibrierung verfeinern</translation>
    </message>
    <message>
        <source>Measure this person&apos;s hands</source>
        <translation>Hände dieser Person vermessen</translation>
    </message>
    <message>
        <source>Refine the calibration first.</source>
        <translation>Zuerst die Kalibrierung verfeinern.</translation>
    </message>
    <message>
        <source>No joint is clicked in two cameras yet.</source>
        <translation>Noch ist kein Gelenk in zwei Kameras angeklickt.</translation>
    </message>
    <message>
        <source>The dataset uses %1 now; all joints were reconstructed anew.</source>
        <translation>Der Datensatz verwendet jetzt %1; alle Gelenke wurden neu rekonstruiert.</translation>
    </message>
    <message>
        <source>Refining the calibration</source>
        <translation>Kalibrierung wird verfeinert</translation>
    </message>
    <message>
        <source>Measuring hands</source>
        <translation>Hände werden vermessen</translation>
    </message>
    <message>
        <source>Measuring hands: %1</source>
        <translation>Hände vermessen: %1</translation>
    </message>
    <message>
        <source>It is not known yet where the hands are: mark some joints, then frame them.</source>
        <translation>Noch ist nicht bekannt, wo die Hände sind: erst einige Gelenke markieren, dann einpassen.</translation>
    </message>
    <message>
        <source>No frame waits for a look.</source>
        <translation>Kein Bild wartet auf Durchsicht.</translation>
    </message>
    <message>
        <source>This is the only frame that waits for a look.</source>
        <translation>Nur dieses Bild wartet auf Durchsicht.</translation>
    </message>
    <message>
        <source>Every frame of the first pass is reviewed.</source>
        <translation>Alle Bilder des ersten Durchlaufs sind durchgesehen.</translation>
    </message>
    <message>
        <source>Click or drag %1 in two views, then accept the frame.</source>
        <translation>%1 in zwei Ansichten anklicken oder ziehen, dann das Bild übernehmen.</translation>
    </message>
    <message numerus="yes">
        <source>Stopped: %n mark(s) in %1 frames are proposed; the next start goes on from there.</source>
        <translation>
            <numerusform>Gestoppt: %n Marke in %1 Bildern ist vorgeschlagen; der nächste Start macht dort weiter.</numerusform>
            <numerusform>Gestoppt: %n Marken in %1 Bildern sind vorgeschlagen; der nächste Start macht dort weiter.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>First pass: hands in %1 of %2 frames, %n mark(s) proposed.</source>
        <translation>
            <numerusform>Erster Durchlauf: Hände in %1 von %2 Bildern, %n Marke vorgeschlagen.</numerusform>
            <numerusform>Erster Durchlauf: Hände in %1 von %2 Bildern, %n Marken vorgeschlagen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Installing the hand detector</source>
        <translation>Handdetektor wird installiert</translation>
    </message>
    <message>
        <source>First pass</source>
        <translation>Erster Durchlauf</translation>
    </message>
    <message>
        <source>Following the hands from the corrected frame</source>
        <translation>Hände werden ab dem korrigierten Bild verfolgt</translation>
    </message>
    <message numerus="yes">
        <source>%n mark(s) around frame %1 are proposed anew.</source>
        <translation>
            <numerusform>%n Marke um Bild %1 ist neu vorgeschlagen.</numerusform>
            <numerusform>%n Marken um Bild %1 sind neu vorgeschlagen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Silhouettes</source>
        <translation>Silhouetten</translation>
    </message>
    <message>
        <source>Making silhouettes</source>
        <translation>Silhouetten werden erzeugt</translation>
    </message>
    <message>
        <source>A tracker&apos;s estimates</source>
        <translation>Schätzungen eines Trackers</translation>
    </message>
    <message>
        <source>Estimates (*.csv *.json)</source>
        <translation>Schätzungen (*.csv *.json)</translation>
    </message>
    <message>
        <source>This sequence has no recorded motion.</source>
        <translation>Diese Sequenz hat keine aufgezeichnete Bewegung.</translation>
    </message>
    <message>
        <source>Drawings (*.svg)</source>
        <translation>Zeichnungen (*.svg)</translation>
    </message>
    <message>
        <source>Pages (*.pdf)</source>
        <translation>Seiten (*.pdf)</translation>
    </message>
    <message>
        <source>Save the comparison as a picture</source>
        <translation>Vergleich als Grafik speichern</translation>
    </message>
    <message>
        <source>Report of this comparison</source>
        <translation>Bericht zu diesem Vergleich</translation>
    </message>
    <message>
        <source>Saving the film</source>
        <translation>Film wird gespeichert</translation>
    </message>
    <message>
        <source>Films (*.mp4)</source>
        <translation>Filme (*.mp4)</translation>
    </message>
    <message>
        <source>Films (*.avi)</source>
        <translation>Filme (*.avi)</translation>
    </message>
    <message>
        <source>Save the iterations as a film</source>
        <translation>Iterationen als Film speichern</translation>
    </message>
    <message>
        <source>Bringing the hands to the corrected joint</source>
        <translation>Hände werden zum korrigierten Gelenk gebracht</translation>
    </message>
    <message numerus="yes">
        <source>%n mark(s) of frame %1 follow the corrected joint.</source>
        <translation>
            <numerusform>%n Marke von Bild %1 folgt dem korrigierten Gelenk.</numerusform>
            <numerusform>%n Marken von Bild %1 folgen dem korrigierten Gelenk.</numerusform>
        </translation>
    </message>
    <message>
        <source>Silhouettes lie %1 px beside the hands: refine the calibration.</source>
        <translation>Silhouetten liegen %1 px neben den Händen: Kalibrierung verfeinern.</translation>
    </message>
</context>
<context>
    <name>app::MasksPage</name>
    <message>
        <source>None yet</source>
        <translation>Noch keine</translation>
    </message>
    <message>
        <source>They can be made from the pictures once the dataset is open, or attached later.</source>
        <translation>Sie lassen sich aus den Bildern erzeugen, sobald der Datensatz geöffnet ist, oder später zuordnen.</translation>
    </message>
    <message>
        <source>They are there</source>
        <translation>Sie sind vorhanden</translation>
    </message>
    <message>
        <source>A folder with a folder of numbered masks per camera, or a pattern with {camera} and {frame}. White is hand, black is not.</source>
        <translation>Ein Ordner mit einem Ordner nummerierter Masken je Kamera oder ein Muster mit {camera} und {frame}. Weiß ist Hand, Schwarz nicht.</translation>
    </message>
    <message>
        <source>The folder of the silhouettes</source>
        <translation>Der Ordner der Silhouetten</translation>
    </message>
    <message>
        <source>Choose the folder of the silhouettes.</source>
        <translation>Wählen Sie den Ordner der Silhouetten.</translation>
    </message>
    <message>
        <source>This must be a folder, or a pattern with {frame}.</source>
        <translation>Das muss ein Ordner sein oder ein Muster mit {frame}.</translation>
    </message>
</context>
<context>
    <name>app::NewDatasetWindow</name>
    <message>
        <source>Make a dataset</source>
        <translation>Einen Datensatz anlegen</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>Folder of the dataset</source>
        <translation>Ordner des Datensatzes</translation>
    </message>
    <message>
        <source>An empty folder for the dataset</source>
        <translation>Ein leerer Ordner für den Datensatz</translation>
    </message>
    <message>
        <source>Make the dataset</source>
        <translation>Datensatz anlegen</translation>
    </message>
    <message>
        <source>Footage</source>
        <translation>Aufnahmen</translation>
    </message>
    <message>
        <source>Choose a folder for the dataset.</source>
        <translation>Wählen Sie einen Ordner für den Datensatz.</translation>
    </message>
    <message>
        <source>The footage is looked at...</source>
        <translation>Die Aufnahmen werden angesehen...</translation>
    </message>
    <message>
        <source>Hands</source>
        <translation>Hände</translation>
    </message>
    <message>
        <source>Silhouettes</source>
        <translation>Silhouetten</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>There is neither a video, nor a folder of images, nor a calibration in what was dropped.</source>
        <translation>Im Abgelegten ist weder ein Video noch ein Bilderordner noch eine Kalibrierung.</translation>
    </message>
    <message>
        <source>The folder of the dataset is not empty: choose another.</source>
        <translation>Der Ordner des Datensatzes ist nicht leer: Wählen Sie einen anderen.</translation>
    </message>
    <message numerus="yes">
        <source>%n piece(s) of footage</source>
        <translation>
            <numerusform>%n Aufnahme</numerusform>
            <numerusform>%n Aufnahmen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n camera(s)</source>
        <translation>
            <numerusform>%n Kamera</numerusform>
            <numerusform>%n Kameras</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>app::PathField</name>
    <message>
        <source>Choose...</source>
        <translation>Wählen...</translation>
    </message>
</context>
<context>
    <name>app::PreferencesWindow</name>
    <message>
        <source>Preferences</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Allgemein</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Your name</source>
        <translation>Ihr Name</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Another language is used from the next start on.</source>
        <translation>Eine andere Sprache gilt ab dem nächsten Start.</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Memory for pictures</source>
        <translation>Speicher für Bilder</translation>
    </message>
    <message>
        <source>Hints</source>
        <translation>Hinweise</translation>
    </message>
    <message>
        <source>Your marks are kept under this name.</source>
        <translation>Ihre Marken werden unter diesem Namen gespeichert.</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> MB</translation>
    </message>
    <message>
        <source>Pictures of recent frames are kept in so much memory: stepping back then needs no reading.</source>
        <translation>So viel Speicher halten die letzten Bilder: Zurückblättern braucht dann kein Lesen.</translation>
    </message>
    <message>
        <source>Show the four hints at the next start</source>
        <translation>Die vier Hinweise beim nächsten Start zeigen</translation>
    </message>
</context>
<context>
    <name>app::RangeWindow</name>
    <message>
        <source>From frame</source>
        <translation>Von Bild</translation>
    </message>
    <message>
        <source>To frame</source>
        <translation>Bis Bild</translation>
    </message>
</context>
<context>
    <name>app::ShortcutModel</name>
    <message>
        <source>Menu</source>
        <translation>Menü</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Aktion</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>What it does</source>
        <translation>Wirkung</translation>
    </message>
    <message>
        <source>%1 belongs to “%2” already: change that one first.</source>
        <translation>%1 gehört bereits zu „%2“: zuerst dort ändern.</translation>
    </message>
</context>
<context>
    <name>app::ShortcutPage</name>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Alle zurücksetzen</translation>
    </message>
    <message>
        <source>Double-click a shortcut to change it.</source>
        <translation>Doppelklick auf ein Kürzel ändert es.</translation>
    </message>
</context>
<context>
    <name>app::ShortcutWindow</name>
    <message>
        <source>Shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
</context>
<context>
    <name>widgets::Advice</name>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Choose a joint on the left.</source>
        <translation>Links ein Gelenk wählen.</translation>
    </message>
    <message>
        <source>Click %1 in any view.</source>
        <translation>%1 in beliebiger Ansicht anklicken.</translation>
    </message>
    <message>
        <source>The click in %1 disagrees with the others: check it.</source>
        <translation>Der Klick in %1 passt nicht zu den anderen: bitte prüfen.</translation>
    </message>
    <message>
        <source>No 3D point: %1.</source>
        <translation>Kein 3D-Punkt: %1.</translation>
    </message>
    <message>
        <source>Click %1 in a second view.</source>
        <translation>%1 in zweiter Ansicht anklicken.</translation>
    </message>
    <message>
        <source>Click %1 in a second view, best in %2.</source>
        <translation>%1 in zweiter Ansicht anklicken, am besten in %2.</translation>
    </message>
    <message>
        <source>Done in every view: go on with the next joint.</source>
        <translation>In allen Ansichten fertig: weiter mit dem nächsten Gelenk.</translation>
    </message>
    <message>
        <source>Accept the remaining views with Space, or mark them as not placeable.</source>
        <translation>Übrige Ansichten mit Leertaste übernehmen oder als nicht platzierbar markieren.</translation>
    </message>
    <message>
        <source>fewer than two views</source>
        <translation>weniger als zwei Ansichten</translation>
    </message>
    <message>
        <source>a click lies where the lens model cannot be inverted</source>
        <translation>ein Klick liegt, wo das Linsenmodell nicht umkehrbar ist</translation>
    </message>
    <message>
        <source>rays are nearly parallel</source>
        <translation>Strahlen sind nahezu parallel</translation>
    </message>
    <message>
        <source>the rays meet behind a camera</source>
        <translation>die Strahlen treffen sich hinter einer Kamera</translation>
    </message>
    <message>
        <source>views disagree</source>
        <translation>Ansichten widersprechen sich</translation>
    </message>
    <message>
        <source>Click in %1 next (→ %2 mm), or accept with Space.</source>
        <translation>Als Nächstes in %1 klicken (→ %2 mm) oder mit Leertaste übernehmen.</translation>
    </message>
    <message>
        <source>No 3D point: the click in %1 is %2.</source>
        <translation>Kein 3D-Punkt: Der Klick in %1 liegt %2.</translation>
    </message>
    <message>
        <source>No 3D point: the click in %1 is %2, the one in %3 %4.</source>
        <translation>Kein 3D-Punkt: Der Klick in %1 liegt %2, der in %3 %4.</translation>
    </message>
    <message numerus="yes">
        <source>%1 clicked, %2 accepted, %3 proposed; %n view(s) have a picture</source>
        <translation>
            <numerusform>%1 geklickt, %2 übernommen, %3 vorgeschlagen; %n Ansicht hat ein Bild</numerusform>
            <numerusform>%1 geklickt, %2 übernommen, %3 vorgeschlagen; %n Ansichten haben ein Bild</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 px off %2&apos;s curve</source>
        <translation>%1 px neben der Kurve von %2</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n view(s)</source>
        <translation>
            <numerusform>%1 von %n Ansicht</numerusform>
            <numerusform>%1 von %n Ansichten</numerusform>
        </translation>
    </message>
    <message>
        <source>A joint needs at least two cameras with a picture.</source>
        <translation>Ein Gelenk braucht mindestens zwei Kameras mit einem Bild.</translation>
    </message>
    <message>
        <source>as proposed</source>
        <translation>wie vorgeschlagen</translation>
    </message>
    <message>
        <source>Accepted as proposed; click %1 in two views to correct it.</source>
        <translation>Übernommen wie vorgeschlagen; zum Korrigieren %1 in zwei Ansichten anklicken.</translation>
    </message>
    <message>
        <source>Proposed by a program: click %1 in two views if it is wrong.</source>
        <translation>Von einem Programm vorgeschlagen: wenn falsch, %1 in zwei Ansichten anklicken.</translation>
    </message>
</context>
<context>
    <name>widgets::AgreementModel</name>
    <message>
        <source>All joints</source>
        <translation>Alle Gelenke</translation>
    </message>
    <message>
        <source>Bias %1 mm, 95 % of the differences between %2 and %3 mm</source>
        <translation>Bias %1 mm, 95 % der Differenzen zwischen %2 und %3 mm</translation>
    </message>
    <message>
        <source>Mean difference along this axis of the world, mm (Bland and Altman)</source>
        <translation>Mittlere Differenz entlang dieser Weltachse, mm (Bland und Altman)</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>Gelenk</translation>
    </message>
    <message>
        <source>n</source>
        <translation>n</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>max</source>
        <translation>max</translation>
    </message>
</context>
<context>
    <name>widgets::AnnotationDocument</name>
    <message>
        <source>Nothing was changed: the annotations are open for reading only (%1).</source>
        <translation>Nichts wurde geändert: Die Annotationen sind nur zum Lesen geöffnet (%1).</translation>
    </message>
</context>
<context>
    <name>widgets::AnnotationFiles</name>
    <message>
        <source>Open a dataset first.</source>
        <translation>Zuerst einen Datensatz öffnen.</translation>
    </message>
    <message>
        <source>The import was stopped, because another sequence was opened.</source>
        <translation>Der Import wurde abgebrochen, weil eine andere Sequenz geöffnet wurde.</translation>
    </message>
    <message>
        <source>One moment: the last import, export or report is not finished.</source>
        <translation>Einen Moment: Der letzte Import, Export oder Bericht ist noch nicht fertig.</translation>
    </message>
    <message>
        <source>Exporting</source>
        <translation>Export</translation>
    </message>
    <message>
        <source>Importing</source>
        <translation>Import</translation>
    </message>
    <message>
        <source>Writing the report</source>
        <translation>Bericht wird geschrieben</translation>
    </message>
    <message>
        <source>Reading the joints</source>
        <translation>Gelenke werden gelesen</translation>
    </message>
</context>
<context>
    <name>widgets::Annotator</name>
    <message>
        <source>Nothing to accept: click %1 in two views first.</source>
        <translation>Nichts zu übernehmen: zuerst %1 in zwei Ansichten anklicken.</translation>
    </message>
    <message>
        <source>There is no mark of %1 in this view.</source>
        <translation>In dieser Ansicht gibt es keine Marke von %1.</translation>
    </message>
    <message>
        <source>Click the place where the joint is hidden, then mark it as occluded.</source>
        <translation>Die Stelle anklicken, an der das Gelenk verborgen ist, dann als verdeckt markieren.</translation>
    </message>
    <message>
        <source>Every view that sees %1 has a mark of it.</source>
        <translation>Jede Ansicht, die %1 sieht, hat schon eine Marke davon.</translation>
    </message>
    <message>
        <source>Nothing was placed: %1 has no picture of this frame.</source>
        <translation>Nichts wurde gesetzt: %1 hat kein Bild zu diesem Zeitpunkt.</translation>
    </message>
    <message>
        <source>Nothing was placed: this is outside the picture of %1.</source>
        <translation>Nichts wurde gesetzt: Das liegt außerhalb des Bildes von %1.</translation>
    </message>
    <message>
        <source>Nothing to accept in this frame: no joint with a 3D point has a view left that sees it.</source>
        <translation>In diesem Bild ist nichts zu übernehmen: Kein Gelenk mit 3D-Punkt hat noch eine Ansicht, die es sieht.</translation>
    </message>
    <message>
        <source>There is no mark of %1 in this frame.</source>
        <translation>In diesem Bild gibt es keine Marke von %1.</translation>
    </message>
    <message>
        <source>The mark is at the edge of the picture.</source>
        <translation>Die Marke ist am Rand des Bildes.</translation>
    </message>
    <message>
        <source>Nothing to accept: the clicks of %1 give no 3D point.</source>
        <translation>Nichts zu übernehmen: Die Klicks von %1 ergeben keinen 3D-Punkt.</translation>
    </message>
    <message>
        <source>Nothing waits to be accepted in this frame.</source>
        <translation>In diesem Bild wartet nichts auf Übernahme.</translation>
    </message>
</context>
<context>
    <name>widgets::BenchmarkPage</name>
    <message>
        <source>Methods</source>
        <translation>Methoden</translation>
    </message>
    <message>
        <source>Sequences</source>
        <translation>Sequenzen</translation>
    </message>
    <message>
        <source> % of frames</source>
        <translation> % der Bilder</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Test</translation>
    </message>
    <message>
        <source>Frames apart</source>
        <translation>Bildabstände</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Seed</translation>
    </message>
    <message>
        <source>Choose at least one method and one sequence.</source>
        <translation>Mindestens eine Methode und eine Sequenz wählen.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Starten</translation>
    </message>
    <message>
        <source>“%1” is not a number of frames.</source>
        <translation>„%1“ ist keine Anzahl von Bildern.</translation>
    </message>
    <message>
        <source>Synthetic</source>
        <translation>Synthetisch</translation>
    </message>
    <message>
        <source>Realistic</source>
        <translation>Realistisch</translation>
    </message>
    <message>
        <source>Setup</source>
        <translation>Aufbau</translation>
    </message>
    <message>
        <source>Save results...</source>
        <translation>Ergebnisse speichern...</translation>
    </message>
    <message>
        <source>Open results...</source>
        <translation>Ergebnisse öffnen...</translation>
    </message>
    <message>
        <source>Tables, pairs and a report, as handlens-batch benchmark writes them</source>
        <translation>Tabellen, Paare und ein Bericht, wie handlens-batch benchmark sie schreibt</translation>
    </message>
    <message>
        <source>A folder that was saved here or written by handlens-batch benchmark</source>
        <translation>Ein Ordner, der hier gespeichert oder von handlens-batch benchmark geschrieben wurde</translation>
    </message>
    <message>
        <source>Save the results in a folder</source>
        <translation>Die Ergebnisse in einem Ordner speichern</translation>
    </message>
    <message>
        <source>Open the results of a folder</source>
        <translation>Die Ergebnisse eines Ordners öffnen</translation>
    </message>
    <message>
        <source>Which setup the tables and curves below are of</source>
        <translation>Zu welchem Aufbau die Tabellen und Kurven unten gehören</translation>
    </message>
    <message>
        <source>Kendall&apos;s tau of the methods&apos; mean errors: 1 is the same order, 0 says nothing, -1 is the reverse; in brackets what 95 % of drawings of these pairs give</source>
        <translation>Kendalls Tau der mittleren Fehler der Verfahren: 1 ist dieselbe Reihenfolge, 0 sagt nichts aus, -1 ist die umgekehrte; in Klammern, was 95 % der Ziehungen dieser Paare ergeben</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Beide</translation>
    </message>
    <message>
        <source>Synthetic: silhouettes of the recorded poses, errors over all joints. Realistic: mask files, errors over the marked joints. Both: one after the other, side by side in one report.</source>
        <translation>Synthetisch: Silhouetten der aufgezeichneten Posen, Fehler über alle Gelenke. Realistisch: Maskendateien, Fehler über die markierten Gelenke. Beide: nacheinander berechnet, nebeneinander in einem Bericht.</translation>
    </message>
    <message>
        <source>Order of the methods in both setups: tau %1 (%2 to %3)</source>
        <translation>Reihenfolge der Verfahren in beiden Aufbauten: Tau %1 (%2 bis %3)</translation>
    </message>
    <message>
        <source>The results are saved in %1.</source>
        <translation>Die Ergebnisse sind in %1 gespeichert.</translation>
    </message>
    <message>
        <source>Show the report</source>
        <translation>Bericht zeigen</translation>
    </message>
    <message>
        <source>Stop the benchmark first.</source>
        <translation>Halten Sie zuerst den Benchmark an.</translation>
    </message>
    <message>
        <source>Choose at least one method.</source>
        <translation>Mindestens eine Methode wählen.</translation>
    </message>
    <message>
        <source>Select pairs in the table first.</source>
        <translation>Zuerst Paare in der Tabelle wählen.</translation>
    </message>
    <message>
        <source>Results of %1; the settings on the left are those of the next run.</source>
        <translation>Ergebnisse aus %1; die Einstellungen links gelten für den nächsten Lauf.</translation>
    </message>
</context>
<context>
    <name>widgets::BenchmarkPairPlots</name>
    <message>
        <source>No pair that is shown has results of both methods.</source>
        <translation>Kein gezeigtes Paar hat Ergebnisse beider Verfahren.</translation>
    </message>
    <message>
        <source>Every pair: click one to inspect it</source>
        <translation>Alle Paare: zum Untersuchen eines anklicken</translation>
    </message>
    <message>
        <source>A: %1, mm</source>
        <translation>A: %1, mm</translation>
    </message>
    <message>
        <source>B: %1, mm</source>
        <translation>B: %1, mm</translation>
    </message>
    <message>
        <source>%1, %2 to %3</source>
        <translation>%1, %2 bis %3</translation>
    </message>
    <message>
        <source>Where A and B differ</source>
        <translation>Wo A und B sich unterscheiden</translation>
    </message>
    <message>
        <source>A − B, mm</source>
        <translation>A − B, mm</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>Paare</translation>
    </message>
    <message>
        <source>A is better: %1</source>
        <translation>A ist besser: %1</translation>
    </message>
    <message>
        <source>B is better: %1</source>
        <translation>B ist besser: %1</translation>
    </message>
    <message>
        <source>No pair is shown.</source>
        <translation>Es wird kein Paar gezeigt.</translation>
    </message>
    <message>
        <source>By frames apart: quartiles, and 5 to 95 %</source>
        <translation>Nach Bildabstand: Quartile und 5 bis 95 %</translation>
    </message>
    <message>
        <source>Frames apart</source>
        <translation>Bildabstände</translation>
    </message>
    <message>
        <source>Error, mm</source>
        <translation>Fehler, mm</translation>
    </message>
    <message>
        <source>frames apart: %1</source>
        <translation>Bildabstand: %1</translation>
    </message>
</context>
<context>
    <name>widgets::BenchmarkPairsView</name>
    <message>
        <source>Double-click a pair to inspect it with every method; select several to run them</source>
        <translation>Doppelklick untersucht ein Paar mit jedem Verfahren; mehrere wählen, um sie zu berechnen</translation>
    </message>
    <message>
        <source>The column A − B and the plots compare these two methods</source>
        <translation>Die Spalte A − B und die Diagramme vergleichen diese beiden Verfahren</translation>
    </message>
    <message>
        <source>Method %1</source>
        <translation>Methode %1</translation>
    </message>
    <message>
        <source>Filter, such as A-B&gt;1 difference&gt;=10</source>
        <translation>Filter, etwa A-B&gt;1 difference&gt;=10</translation>
    </message>
    <message>
        <source>Filter of the pairs</source>
        <translation>Filter der Paare</translation>
    </message>
    <message>
        <source>Runs the methods that are ticked on the left on the selected pairs, and adds what they find</source>
        <translation>Wendet die links angekreuzten Verfahren auf die gewählten Paare an und fügt hinzu, was sie finden</translation>
    </message>
    <message>
        <source>%1 of %2 pairs</source>
        <translation>%1 von %2 Paaren</translation>
    </message>
    <message>
        <source>Run selected</source>
        <translation>Gewählte berechnen</translation>
    </message>
    <message>
        <source>Inspect this pair</source>
        <translation>Dieses Paar untersuchen</translation>
    </message>
    <message>
        <source>Select all that are shown</source>
        <translation>Alle gezeigten wählen</translation>
    </message>
    <message>
        <source>Copy the selected rows</source>
        <translation>Gewählte Zeilen kopieren</translation>
    </message>
    <message>
        <source>Run selected (%1)</source>
        <translation>Auswahl ausführen (%1)</translation>
    </message>
</context>
<context>
    <name>widgets::BenchmarkResultsView</name>
    <message>
        <source>Share of pairs below each error</source>
        <translation>Anteil der Paare unter jedem Fehler</translation>
    </message>
    <message>
        <source>Error, mm</source>
        <translation>Fehler, mm</translation>
    </message>
    <message>
        <source>Pairs, %</source>
        <translation>Paare, %</translation>
    </message>
    <message>
        <source>Run the benchmark to compare the methods.</source>
        <translation>Starten Sie den Benchmark, um die Verfahren zu vergleichen.</translation>
    </message>
    <message>
        <source>Error per joint</source>
        <translation>Fehler je Gelenk</translation>
    </message>
    <message>
        <source>start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>All methods</source>
        <translation>Alle Methoden</translation>
    </message>
    <message>
        <source>A against B</source>
        <translation>A gegen B</translation>
    </message>
</context>
<context>
    <name>widgets::BenchmarkRunner</name>
    <message>
        <source>Open a dataset first.</source>
        <translation>Zuerst einen Datensatz öffnen.</translation>
    </message>
    <message>
        <source>%1 of %2 fits</source>
        <translation>%1 von %2 Anpassungen</translation>
    </message>
    <message>
        <source>This folder holds the results of another benchmark. Choose another one.</source>
        <translation>Dieser Ordner enthält die Ergebnisse eines anderen Benchmarks. Wählen Sie einen anderen.</translation>
    </message>
    <message>
        <source>This folder already holds a file %1. Choose another one.</source>
        <translation>In diesem Ordner liegt schon eine Datei %1. Wählen Sie einen anderen.</translation>
    </message>
    <message>
        <source>There are no results to save yet.</source>
        <translation>Es gibt noch keine Ergebnisse zu speichern.</translation>
    </message>
    <message>
        <source>Stop the benchmark first.</source>
        <translation>Halten Sie zuerst den Benchmark an.</translation>
    </message>
    <message>
        <source>These results are not of the open dataset, or it has changed since: %1.</source>
        <translation>Diese Ergebnisse gehören nicht zum offenen Datensatz, oder er hat sich seither geändert: %1.</translation>
    </message>
    <message numerus="yes">
        <source>This benchmark is not finished: %n fit(s) are in.</source>
        <translation>
            <numerusform>Dieser Benchmark ist nicht fertig: %n Anpassung liegt vor.</numerusform>
            <numerusform>Dieser Benchmark ist nicht fertig: %n Anpassungen liegen vor.</numerusform>
        </translation>
    </message>
    <message>
        <source>These results are not of the open dataset, or it has changed since: pairs cannot be added to them.</source>
        <translation>Diese Ergebnisse gehören nicht zum offenen Datensatz, oder er hat sich seither geändert: Ihnen lassen sich keine Paare hinzufügen.</translation>
    </message>
</context>
<context>
    <name>widgets::BoxPlot</name>
    <message>
        <source>%1: median %2</source>
        <translation>%1: Median %2</translation>
    </message>
</context>
<context>
    <name>widgets::CalibrationChoice</name>
    <message>
        <source>Wait until the sequence is open.</source>
        <translation>Warten Sie, bis die Sequenz geöffnet ist.</translation>
    </message>
</context>
<context>
    <name>widgets::CameraChoice</name>
    <message>
        <source>Which cameras are the rows</source>
        <translation>Welche Kameras die Zeilen bilden</translation>
    </message>
    <message>
        <source>From the current one on</source>
        <translation>Ab der aktuellen</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>Wählen</translation>
    </message>
    <message numerus="yes">
        <source>%n chosen</source>
        <translation>
            <numerusform>%n gewählt</numerusform>
            <numerusform>%n gewählt</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>widgets::CameraFaultText</name>
    <message>
        <source>its rotation is a mirror: an axis points the wrong way</source>
        <translation>ihre Rotation ist eine Spiegelung: Eine Achse zeigt in die falsche Richtung</translation>
    </message>
    <message>
        <source>its rotation matrix is not a rotation</source>
        <translation>ihre Rotationsmatrix ist keine Rotation</translation>
    </message>
    <message>
        <source>its focal length is not positive</source>
        <translation>ihre Brennweite ist nicht positiv</translation>
    </message>
    <message>
        <source>its principal point lies outside the image: is the matrix transposed, or the image size wrong?</source>
        <translation>ihr Hauptpunkt liegt außerhalb des Bildes: Ist die Matrix transponiert oder die Bildgröße falsch?</translation>
    </message>
    <message>
        <source>its footage has %1 pixels, the calibration is for %2: another camera&apos;s footage?</source>
        <translation>ihre Aufnahme hat %1 Pixel, die Kalibrierung gilt für %2: Aufnahme einer anderen Kamera?</translation>
    </message>
    <message>
        <source>its footage is scaled by %1 (%2 pixels, the calibration is for %3)</source>
        <translation>ihre Aufnahme ist um den Faktor %1 skaliert (%2 Pixel, die Kalibrierung gilt für %3)</translation>
    </message>
    <message>
        <source>it stands where %1 stands</source>
        <translation>sie steht, wo %1 steht</translation>
    </message>
    <message>
        <source>where the cameras look lies behind it: is its rotation inverted?</source>
        <translation>wohin die Kameras blicken, liegt hinter ihr: Ist ihre Rotation invertiert?</translation>
    </message>
    <message>
        <source>it does not see where the other cameras look</source>
        <translation>sie sieht nicht, wohin die anderen Kameras blicken</translation>
    </message>
    <message>
        <source>its lens model holds in %1 % of the image only</source>
        <translation>ihr Linsenmodell gilt nur in %1 % des Bildes</translation>
    </message>
    <message>
        <source>The cameras are %1 mm from where they look: choose another unit.</source>
        <translation>Die Kameras sind %1 mm von dort entfernt, wohin sie blicken: Wählen Sie eine andere Einheit.</translation>
    </message>
</context>
<context>
    <name>widgets::ColumnBar</name>
    <message>
        <source>Add a column: a method, the start, the truth, a tracker</source>
        <translation>Spalte hinzufügen: ein Verfahren, den Start, die Wahrheit, einen Tracker</translation>
    </message>
    <message>
        <source>Add a column</source>
        <translation>Spalte hinzufügen</translation>
    </message>
    <message>
        <source>A tracker&apos;s estimates...</source>
        <translation>Schätzungen eines Trackers...</translation>
    </message>
</context>
<context>
    <name>widgets::ColumnHead</name>
    <message>
        <source>Settings of this method, and what if</source>
        <translation>Einstellungen dieses Verfahrens und „Was wäre, wenn“</translation>
    </message>
    <message>
        <source>Remove this column</source>
        <translation>Diese Spalte entfernen</translation>
    </message>
    <message>
        <source>Drag it to another place</source>
        <translation>An eine andere Stelle ziehen</translation>
    </message>
</context>
<context>
    <name>widgets::CurvePlot</name>
    <message>
        <source>Logarithmic axis</source>
        <translation>Logarithmische Achse</translation>
    </message>
</context>
<context>
    <name>widgets::DatasetSession</name>
    <message>
        <source>Your last edits are not saved yet, so they would be lost. Make room or give permission where they are kept, or export them first.</source>
        <translation>Ihre letzten Änderungen sind noch nicht gespeichert und gingen verloren. Schaffen Sie dort, wo sie liegen, Platz oder Schreibrechte, oder exportieren Sie sie zuerst.</translation>
    </message>
</context>
<context>
    <name>widgets::EditText</name>
    <message>
        <source>delete %1 in %2</source>
        <translation>%1 in %2 löschen</translation>
    </message>
    <message>
        <source>mark %1 as not placeable in %2</source>
        <translation>%1 in %2 als nicht platzierbar markieren</translation>
    </message>
    <message>
        <source>accept %1 in %2</source>
        <translation>%1 in %2 übernehmen</translation>
    </message>
    <message>
        <source>place %1 in %2</source>
        <translation>%1 in %2 platzieren</translation>
    </message>
    <message>
        <source>move %1 in %2</source>
        <translation>%1 in %2 verschieben</translation>
    </message>
    <message>
        <source>mark %1 as occluded in %2</source>
        <translation>%1 in %2 als verdeckt markieren</translation>
    </message>
    <message>
        <source>mark %1 as visible in %2</source>
        <translation>%1 in %2 als sichtbar markieren</translation>
    </message>
    <message numerus="yes">
        <source>accept %n mark(s)</source>
        <translation>
            <numerusform>%n Marke übernehmen</numerusform>
            <numerusform>%n Marken übernehmen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>copy a pose (%n mark(s))</source>
        <translation>
            <numerusform>Pose kopieren (%n Marke)</numerusform>
            <numerusform>Pose kopieren (%n Marken)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>interpolate (%n mark(s))</source>
        <translation>
            <numerusform>interpolieren (%n Marke)</numerusform>
            <numerusform>interpolieren (%n Marken)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>swap left and right (%n mark(s))</source>
        <translation>
            <numerusform>links und rechts tauschen (%n Marke)</numerusform>
            <numerusform>links und rechts tauschen (%n Marken)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>delete %n mark(s)</source>
        <translation>
            <numerusform>%n Marke löschen</numerusform>
            <numerusform>%n Marken löschen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>import %n mark(s)</source>
        <translation>
            <numerusform>%n Marke importieren</numerusform>
            <numerusform>%n Marken importieren</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>propose %n mark(s)</source>
        <translation>
            <numerusform>%n Marke vorschlagen</numerusform>
            <numerusform>%n Marken vorschlagen</numerusform>
        </translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>note on frame %1</source>
        <translation>Notiz zu Bild %1</translation>
    </message>
    <message numerus="yes">
        <source>change %n mark(s)</source>
        <translation>
            <numerusform>%n Marke ändern</numerusform>
            <numerusform>%n Marken ändern</numerusform>
        </translation>
    </message>
    <message>
        <source>L %1</source>
        <translation>L %1</translation>
    </message>
    <message>
        <source>R %1</source>
        <translation>R %1</translation>
    </message>
    <message>
        <source>propose %1 in %2</source>
        <translation>%1 in %2 vorschlagen</translation>
    </message>
    <message numerus="yes">
        <source>first pass (%n proposed mark(s))</source>
        <translation>
            <numerusform>erster Durchlauf (%n vorgeschlagene Marke)</numerusform>
            <numerusform>erster Durchlauf (%n vorgeschlagene Marken)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>widgets::EmptyState</name>
    <message>
        <source>Recent datasets</source>
        <translation>Zuletzt geöffnete Datensätze</translation>
    </message>
    <message>
        <source>Open a dataset...</source>
        <translation>Datensatz öffnen...</translation>
    </message>
    <message>
        <source>Try the demo</source>
        <translation>Demo ausprobieren</translation>
    </message>
    <message>
        <source>Open a dataset or make one of your videos: drop either here. Or try the demo.</source>
        <translation>Öffnen Sie einen Datensatz oder legen Sie einen aus Ihren Videos an: beides hier ablegen. Oder die Demo ansehen.</translation>
    </message>
    <message>
        <source>Make a dataset...</source>
        <translation>Datensatz anlegen...</translation>
    </message>
</context>
<context>
    <name>widgets::ErrorText</name>
    <message>
        <source>this is not possible with the data that is open</source>
        <translation>mit den geöffneten Daten nicht möglich</translation>
    </message>
    <message>
        <source>not found</source>
        <translation>nicht gefunden</translation>
    </message>
    <message>
        <source>the content is not valid</source>
        <translation>der Inhalt ist ungültig</translation>
    </message>
    <message>
        <source>written by a newer version of Handlens</source>
        <translation>von einer neueren Handlens-Version geschrieben</translation>
    </message>
    <message>
        <source>cannot be read or written: check permissions and space</source>
        <translation>kann nicht gelesen oder geschrieben werden: Rechte und Platz prüfen</translation>
    </message>
    <message>
        <source>this kind of content is not supported</source>
        <translation>diese Art von Inhalt wird nicht unterstützt</translation>
    </message>
    <message>
        <source>unexpected error</source>
        <translation>unerwarteter Fehler</translation>
    </message>
</context>
<context>
    <name>widgets::Finding</name>
    <message>
        <source>no 3D point: %1</source>
        <translation>kein 3D-Punkt: %1</translation>
    </message>
    <message>
        <source>error of %1 px</source>
        <translation>Fehler von %1 px</translation>
    </message>
    <message>
        <source>click in %1 is %2 px off</source>
        <translation>Klick in %1 liegt %2 px daneben</translation>
    </message>
    <message>
        <source>no 3D point from its clicks</source>
        <translation>kein 3D-Punkt aus den Klicks</translation>
    </message>
    <message>
        <source>bone %1 % longer than usual</source>
        <translation>Knochen %1 % länger als üblich</translation>
    </message>
    <message>
        <source>bone %1 % shorter than usual</source>
        <translation>Knochen %1 % kürzer als üblich</translation>
    </message>
    <message>
        <source>bent %1° beyond its limit</source>
        <translation>%1° über die Grenze gebeugt</translation>
    </message>
    <message>
        <source>fingers exchanged? %1 mm out of order</source>
        <translation>Finger vertauscht? %1 mm falsch gereiht</translation>
    </message>
    <message>
        <source>left and right exchanged?</source>
        <translation>links und rechts vertauscht?</translation>
    </message>
    <message>
        <source>on the same pixel as another joint in %1</source>
        <translation>in %1 auf demselben Pixel wie ein anderes Gelenk</translation>
    </message>
    <message>
        <source>no 3D point: click in %1 is %2</source>
        <translation>kein 3D-Punkt: Klick in %1 liegt %2</translation>
    </message>
    <message>
        <source>mark is %1 px outside the picture of %2</source>
        <translation>Marke ist %1 px außerhalb des Bildes von %2</translation>
    </message>
</context>
<context>
    <name>widgets::FindingModel</name>
    <message>
        <source>Finding</source>
        <translation>Befund</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>Gelenk</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Bild</translation>
    </message>
</context>
<context>
    <name>widgets::FirstPass</name>
    <message>
        <source>Open a dataset first.</source>
        <translation>Zuerst einen Datensatz öffnen.</translation>
    </message>
    <message>
        <source>These annotations are read-only: nothing can be proposed.</source>
        <translation>Diese Annotationen sind schreibgeschützt: Es kann nichts vorgeschlagen werden.</translation>
    </message>
    <message>
        <source>The first pass needs two cameras with pictures.</source>
        <translation>Der erste Durchlauf braucht zwei Kameras mit Bildern.</translation>
    </message>
</context>
<context>
    <name>widgets::FirstPassForm</name>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>all 21 of a hand</source>
        <translation>alle 21 einer Hand</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Verbergen</translation>
    </message>
    <message>
        <source>The hand detector of %1 is installed.</source>
        <translation>Der Handdetektor von %1 ist installiert.</translation>
    </message>
    <message>
        <source>The list of joints follows; otherwise only joints of the list are proposed</source>
        <translation>Die Gelenkliste passt sich an; sonst werden nur Gelenke der Liste vorgeschlagen</translation>
    </message>
    <message>
        <source>First frame</source>
        <translation>Erstes Bild</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>Letztes Bild</translation>
    </message>
    <message>
        <source>Every so many frames</source>
        <translation>Schrittweite in Bildern</translation>
    </message>
    <message>
        <source>Finds the joints in these frames, in the background; they wait for your look as proposals</source>
        <translation>Findet die Gelenke in diesen Bildern, im Hintergrund; als Vorschläge warten sie auf Ihre Durchsicht</translation>
    </message>
    <message>
        <source>Keeps the frames that are done; the next start goes on from there</source>
        <translation>Behält die fertigen Bilder; der nächste Start macht dort weiter</translation>
    </message>
    <message>
        <source>Sequence</source>
        <translation>Sequenz</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Hands</source>
        <translation>Hände</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Gelenke</translation>
    </message>
    <message>
        <source>every</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>Open a dataset first.</source>
        <translation>Zuerst einen Datensatz öffnen.</translation>
    </message>
    <message>
        <source>Choose a hand.</source>
        <translation>Wählen Sie eine Hand.</translation>
    </message>
    <message>
        <source>The last frame comes before the first one.</source>
        <translation>Das letzte Bild liegt vor dem ersten.</translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s). Marks that are there already stay.</source>
        <translation>
            <numerusform>%n Bild. Vorhandene Marken bleiben.</numerusform>
            <numerusform>%n Bilder. Vorhandene Marken bleiben.</numerusform>
        </translation>
    </message>
    <message>
        <source>The hand detector is not installed: get it with &quot;npm pack @mediapipe/hands&quot; (11 MB, Apache-2.0) and choose the file, or run &quot;handlens-batch detector install FILE&quot;.</source>
        <translation>Der Handdetektor ist nicht installiert: mit „npm pack @mediapipe/hands“ holen (11 MB, Apache-2.0) und die Datei wählen oder „handlens-batch detector install DATEI“ ausführen.</translation>
    </message>
    <message>
        <source>Choose the file...</source>
        <translation>Datei wählen...</translation>
    </message>
    <message>
        <source>The package @mediapipe/hands</source>
        <translation>Das Paket @mediapipe/hands</translation>
    </message>
    <message>
        <source>Packages (*.tgz)</source>
        <translation>Pakete (*.tgz)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>widgets::FitPair</name>
    <message>
        <source>This sequence has no recorded motion: mark some joints of every hand in the start frame, and the fit starts from the hand model fitted to them.</source>
        <translation>Diese Sequenz hat keine aufgezeichnete Bewegung: im Startbild einige Gelenke jeder Hand markieren, dann geht die Anpassung vom daran gebeugten Handmodell aus.</translation>
    </message>
    <message>
        <source>There is no mask file of the test frame.</source>
        <translation>Zum Testbild gibt es keine Maskendatei.</translation>
    </message>
</context>
<context>
    <name>widgets::FitRunner</name>
    <message>
        <source>The start and the test frame must be between 0 and %1.</source>
        <translation>Start- und Testbild müssen zwischen 0 und %1 liegen.</translation>
    </message>
    <message>
        <source>Choose at least one method.</source>
        <translation>Mindestens eine Methode wählen.</translation>
    </message>
    <message>
        <source>This dataset has no hand models to fit.</source>
        <translation>Dieser Datensatz hat keine Handmodelle zum Anpassen.</translation>
    </message>
    <message>
        <source>This sequence has no mask files.</source>
        <translation>Diese Sequenz hat keine Maskendateien.</translation>
    </message>
    <message>
        <source>This sequence has no recorded motion to draw silhouettes from.</source>
        <translation>Diese Sequenz hat keine aufgezeichnete Bewegung, aus der Silhouetten zu zeichnen wären.</translation>
    </message>
    <message>
        <source>This sequence needs silhouettes: attach a folder of masks, or make them.</source>
        <translation>Diese Sequenz braucht Silhouetten: Ordnen Sie einen Ordner mit Masken zu oder erzeugen Sie welche.</translation>
    </message>
</context>
<context>
    <name>widgets::FittingPanel</name>
    <message>
        <source>Iteration</source>
        <translation>Iteration</translation>
    </message>
    <message>
        <source>Error, mm</source>
        <translation>Fehler, mm</translation>
    </message>
    <message>
        <source>The error of every iteration appears here.</source>
        <translation>Hier erscheint der Fehler jeder Iteration.</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Test</translation>
    </message>
    <message>
        <source>Frame whose silhouettes are to be met</source>
        <translation>Bild, dessen Silhouetten zu treffen sind</translation>
    </message>
    <message>
        <source>Here</source>
        <translation>Hier</translation>
    </message>
    <message>
        <source>Test the current frame</source>
        <translation>Aktuelles Bild als Testbild</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Anpassen</translation>
    </message>
    <message>
        <source>Silhouettes of the recorded pose</source>
        <translation>Silhouetten der aufgezeichneten Pose</translation>
    </message>
    <message>
        <source>Silhouettes of the mask files</source>
        <translation>Silhouetten der Maskendateien</translation>
    </message>
    <message>
        <source>What the fit is to meet. Against mask files, errors are measured over the joints marked in the test frame.</source>
        <translation>Was die Anpassung treffen soll. Gegen Maskendateien werden Fehler über die im Testbild markierten Gelenke gemessen.</translation>
    </message>
    <message>
        <source>Frame whose pose the fit starts from: the recorded one or, without, the hand model of its marks</source>
        <translation>Bild, von dessen Pose die Anpassung ausgeht: die aufgezeichnete oder, wenn es keine gibt, das Handmodell seiner Marken</translation>
    </message>
    <message>
        <source>Attach masks...</source>
        <translation>Masken zuordnen...</translation>
    </message>
    <message>
        <source>A folder of masks, white where the hands are: CAMERA/000012.png, CAMERA_000012.png or the like</source>
        <translation>Ein Ordner mit Masken, weiß, wo die Hände sind: KAMERA/000012.png, KAMERA_000012.png oder ähnlich</translation>
    </message>
</context>
<context>
    <name>widgets::FootageFinder</name>
    <message>
        <source>not found: %1</source>
        <translation>nicht gefunden: %1</translation>
    </message>
</context>
<context>
    <name>widgets::FootageText</name>
    <message numerus="yes">
        <source>%1 and %n more place(s)</source>
        <translation>
            <numerusform>%1 und %n weitere Stelle</numerusform>
            <numerusform>%1 und %n weitere Stellen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %n frame(s) missing after frame %2.</source>
        <translation>
            <numerusform>%1: %n Bild fehlt nach Bild %2.</numerusform>
            <numerusform>%1: %n Bilder fehlen nach Bild %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 after frame %2</source>
        <translation>%1 nach Bild %2</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n frame(s) missing: %2.</source>
        <translation>
            <numerusform>%1: %n Bild fehlt: %2.</numerusform>
            <numerusform>%1: %n Bilder fehlen: %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %n picture(s) missing: %2.</source>
        <translation>
            <numerusform>%1: %n Bilddatei fehlt: %2.</numerusform>
            <numerusform>%1: %n Bilddateien fehlen: %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>The pictures start at different numbers (%1); the first ones are taken as the same instant.</source>
        <translation>Die Bilddateien beginnen mit verschiedenen Nummern (%1); die jeweils ersten gelten als derselbe Zeitpunkt.</translation>
    </message>
    <message>
        <source>%1: its time stamps are uneven or missing, so lost frames cannot be told; its frames are taken by number.</source>
        <translation>%1: Die Zeitstempel sind ungleichmäßig oder fehlen, verlorene Bilder sind daher nicht zu erkennen; die Bilder werden nach Nummer genommen.</translation>
    </message>
    <message>
        <source>%1: frame 0 is picture %2.</source>
        <translation>%1: Bild 0 ist Bilddatei %2.</translation>
    </message>
    <message numerus="yes">
        <source>%1 goes on for %n frame(s) after the last instant.</source>
        <translation>
            <numerusform>%1 geht nach dem letzten Zeitpunkt noch %n Bild weiter.</numerusform>
            <numerusform>%1 geht nach dem letzten Zeitpunkt noch %n Bilder weiter.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 has %n frame(s) more than the shortest footage: are they all of the same instants?</source>
        <translation>
            <numerusform>%1 hat %n Bild mehr als die kürzeste Aufnahme: Sind alle von denselben Zeitpunkten?</numerusform>
            <numerusform>%1 hat %n Bilder mehr als die kürzeste Aufnahme: Sind alle von denselben Zeitpunkten?</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 was recorded at another frame rate than the sequence&apos;s %2.</source>
        <translation>%1 wurde mit einer anderen Bildrate aufgenommen als die Sequenz (%2).</translation>
    </message>
    <message>
        <source>%1: its pictures have more than 8 bits; level %2 is shown black, %3 white.</source>
        <translation>%1: Die Bilder haben mehr als 8 Bit; Wert %2 wird schwarz gezeigt, %3 weiß.</translation>
    </message>
    <message>
        <source>%1: the orientation tag of its pictures says that they are mirrored; they are not mirrored here, but turned by %2°.</source>
        <translation>%1: Laut Orientierungsangabe sind die Bilder gespiegelt; hier werden sie nicht gespiegelt, sondern um %2° gedreht.</translation>
    </message>
    <message>
        <source>%1: turned clockwise by %2°, as its orientation tag says.</source>
        <translation>%1: um %2° im Uhrzeigersinn gedreht, laut Orientierungsangabe.</translation>
    </message>
    <message>
        <source>%1: its orientation tag says that it is to be turned clockwise by %2°, but it is turned by %3°.</source>
        <translation>%1: Laut Orientierungsangabe um %2° im Uhrzeigersinn zu drehen, gedreht wird aber um %3°.</translation>
    </message>
    <message>
        <source>Simulated. Masks are the difference of each picture to the empty room; only the annotated frames have pictures. The recorded motion is that of the person in the pictures, played by the model&apos;s hand. What it was drawn from is in the folder truth.</source>
        <translation>Simuliert. Masken sind die Differenz jedes Kamerabilds zum leeren Raum; nur die annotierten Bilder haben Kamerabilder. Die aufgezeichnete Bewegung ist die der Person in den Kamerabildern, ausgeführt von der Hand des Modells. Woraus gezeichnet wurde, liegt im Ordner truth.</translation>
    </message>
    <message>
        <source>Its frames are taken by number, so the later ones are not of the other cameras&apos; instants.</source>
        <translation>Die Bilder werden nach Nummer genommen, die späteren sind daher nicht von den Zeitpunkten der anderen Kameras.</translation>
    </message>
    <message>
        <source>%1: %2 of %3 frames have a mask.</source>
        <translation>%1: %2 von %3 Bildern haben eine Maske.</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n mask(s) of no frame of the sequence: its frames need the numbers %2 to %3, the masks have %4 to %5.</source>
        <translation>
            <numerusform>%1: %n Maske gehört zu keinem Bild der Sequenz: Deren Bilder brauchen die Nummern %2 bis %3, die Masken haben %4 bis %5.</numerusform>
            <numerusform>%1: %n Masken gehören zu keinem Bild der Sequenz: Deren Bilder brauchen die Nummern %2 bis %3, die Masken haben %4 bis %5.</numerusform>
        </translation>
    </message>
    <message>
        <source>it has %1 frames, but the sequence needs %2</source>
        <translation>hat %1 Bilder, aber die Sequenz braucht %2</translation>
    </message>
    <message>
        <source>it has %1 pictures, but the sequence needs %2</source>
        <translation>hat %1 Bilddateien, aber die Sequenz braucht %2</translation>
    </message>
    <message>
        <source>it is %1, but its camera is calibrated for %2</source>
        <translation>hat %1 Pixel, aber die Kamera ist für %2 kalibriert</translation>
    </message>
    <message>
        <source>it cannot be read (%1)</source>
        <translation>kann nicht gelesen werden (%1)</translation>
    </message>
    <message>
        <source>several fit: %1</source>
        <translation>mehrere passen: %1</translation>
    </message>
    <message>
        <source>%1 has that name, but is other footage of this dataset</source>
        <translation>%1 heißt so, ist aber eine andere Aufnahme dieses Datensatzes</translation>
    </message>
</context>
<context>
    <name>widgets::FramePictures</name>
    <message>
        <source>No picture at this instant.</source>
        <translation>Kein Bild zu diesem Zeitpunkt.</translation>
    </message>
    <message>
        <source>Find...</source>
        <translation>Suchen...</translation>
    </message>
</context>
<context>
    <name>widgets::FramesBar</name>
    <message>
        <source>Sequence</source>
        <translation>Sequenz</translation>
    </message>
    <message>
        <source>Frame: type a number and press Enter</source>
        <translation>Bild: Nummer eingeben und Eingabetaste drücken</translation>
    </message>
    <message>
        <source>Frame </source>
        <translation>Bild </translation>
    </message>
    <message>
        <source>What the colours of the timeline mean</source>
        <translation>Was die Farben der Zeitleiste bedeuten</translation>
    </message>
</context>
<context>
    <name>widgets::HandDiagram</name>
    <message>
        <source>Joints of both hands</source>
        <translation>Gelenke beider Hände</translation>
    </message>
</context>
<context>
    <name>widgets::HandFraming</name>
    <message>
        <source>L</source>
        <comment>left hand, one letter beside it</comment>
        <translation>L</translation>
    </message>
    <message>
        <source>R</source>
        <comment>right hand, one letter beside it</comment>
        <translation>R</translation>
    </message>
</context>
<context>
    <name>widgets::HandModelFit</name>
    <message>
        <source>This dataset has no hand models.</source>
        <translation>Dieser Datensatz hat keine Handmodelle.</translation>
    </message>
    <message>
        <source>The hand model needs three joints of a hand that have a 3D point and are not on a line.</source>
        <translation>Das Handmodell braucht drei Gelenke einer Hand, die einen 3D-Punkt haben und nicht auf einer Linie liegen.</translation>
    </message>
</context>
<context>
    <name>widgets::Hints</name>
    <message>
        <source>Choose a joint on the left, then click it in two views: its 3D place appears at once.</source>
        <translation>Links ein Gelenk wählen, dann in zwei Ansichten anklicken: Sein Ort in 3D erscheint sofort.</translation>
    </message>
    <message>
        <source>Space accepts a pre-placed mark, X deletes one, Ctrl+Z takes back anything.</source>
        <translation>Die Leertaste übernimmt eine vorplatzierte Marke, X löscht eine Marke, Strg+Z nimmt alles zurück.</translation>
    </message>
    <message>
        <source>A and D step through the frames, W and S through the joints; F1 shows every key.</source>
        <translation>A und D gehen durch die Bilder, W und S durch die Gelenke; F1 zeigt alle Tasten.</translation>
    </message>
    <message>
        <source>The wheel zooms, the middle button moves, a double click fills the window with one view; 9 frames the hands, 0 shows whole pictures.</source>
        <translation>Das Rad zoomt, die mittlere Taste verschiebt, ein Doppelklick füllt das Fenster mit einer Ansicht; 9 passt die Hände ein, 0 zeigt ganze Bilder.</translation>
    </message>
    <message>
        <source>Got it (Esc)</source>
        <translation>Verstanden (Esc)</translation>
    </message>
</context>
<context>
    <name>widgets::HistogramPlot</name>
    <message>
        <source>%1 to %2, pairs: %3</source>
        <translation>%1 bis %2, Paare: %3</translation>
    </message>
</context>
<context>
    <name>widgets::ImportText</name>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 und %n weitere</numerusform>
            <numerusform>%1 und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: its footage is shifted against the sequence; the numbers of its pictures are taken as frames of the sequence, not of the video.</source>
        <translation>%1: Die Aufnahme ist gegen die Sequenz verschoben; die Nummern ihrer Bilder gelten als Bilder der Sequenz, nicht des Videos.</translation>
    </message>
    <message>
        <source>The file names none of the dataset&apos;s cameras; they are taken in the dataset&apos;s order: %1.</source>
        <translation>Die Datei nennt keine Kamera des Datensatzes; sie werden in der Reihenfolge des Datensatzes genommen: %1.</translation>
    </message>
    <message>
        <source>The file holds reprojections of 3D points, not clicks (data_2d); they come as proposals.</source>
        <translation>Die Datei enthält Rückprojektionen von 3D-Punkten, keine Klicks (data_2d); sie kommen als Vorschläge.</translation>
    </message>
    <message>
        <source>The file holds 3D points without clicks; they come as proposals.</source>
        <translation>Die Datei enthält 3D-Punkte ohne Klicks; sie kommen als Vorschläge.</translation>
    </message>
    <message>
        <source>The file is of sequence %1, not of %2.</source>
        <translation>Die Datei gehört zu Sequenz %1, nicht zu %2.</translation>
    </message>
    <message>
        <source>Some marks are a program&apos;s guesses; they come as proposals, to be checked.</source>
        <translation>Einige Marken sind Vorhersagen eines Programms; sie kommen als Vorschläge, zur Prüfung.</translation>
    </message>
    <message>
        <source>The marks are a program&apos;s guesses; they come as proposals, to be checked.</source>
        <translation>Die Marken sind Vorhersagen eines Programms; sie kommen als Vorschläge, zur Prüfung.</translation>
    </message>
    <message numerus="yes">
        <source>Left out: %n item(s) of frames that sequence %1 does not have (it has 0 to %2).</source>
        <translation>
            <numerusform>Ausgelassen: %n Eintrag zu Bildern, die Sequenz %1 nicht hat (sie hat 0 bis %2).</numerusform>
            <numerusform>Ausgelassen: %n Einträge zu Bildern, die Sequenz %1 nicht hat (sie hat 0 bis %2).</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Left out: %n mark(s) in camera %1, which the dataset does not have.</source>
        <translation>
            <numerusform>Ausgelassen: %n Marke in Kamera %1, die der Datensatz nicht hat.</numerusform>
            <numerusform>Ausgelassen: %n Marken in Kamera %1, die der Datensatz nicht hat.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Left out: %n row(s) of the view of camera %1.</source>
        <translation>
            <numerusform>Ausgelassen: %n Zeile der Ansicht von Kamera %1.</numerusform>
            <numerusform>Ausgelassen: %n Zeilen der Ansicht von Kamera %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Left out: %n row(s) of other videos: %1.</source>
        <translation>
            <numerusform>Ausgelassen: %n Zeile anderer Videos: %1.</numerusform>
            <numerusform>Ausgelassen: %n Zeilen anderer Videos: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n mark(s) outside the picture of %1: kept, but not used for 3D points.</source>
        <translation>
            <numerusform>%n Marke außerhalb des Bildes von %1: behalten, aber nicht für 3D-Punkte verwendet.</numerusform>
            <numerusform>%n Marken außerhalb des Bildes von %1: behalten, aber nicht für 3D-Punkte verwendet.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Left out: %n mark(s) with a likelihood below %1.</source>
        <translation>
            <numerusform>Ausgelassen: %n Marke mit einer Wahrscheinlichkeit unter %1.</numerusform>
            <numerusform>Ausgelassen: %n Marken mit einer Wahrscheinlichkeit unter %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Left out: %n guess(es) of joints that are labelled or guessed in the same picture already.</source>
        <translation>
            <numerusform>Ausgelassen: %n Vorhersage eines Gelenks, das im selben Bild schon markiert oder vorhergesagt ist.</numerusform>
            <numerusform>Ausgelassen: %n Vorhersagen von Gelenken, die im selben Bild schon markiert oder vorhergesagt sind.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Left out: %n label(s) marked as not visible.</source>
        <translation>
            <numerusform>Ausgelassen: %n als nicht sichtbar gekennzeichnete Markierung.</numerusform>
            <numerusform>Ausgelassen: %n als nicht sichtbar gekennzeichnete Markierungen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Left out: %n mark(s) of %1, which is not in the joint map.</source>
        <translation>
            <numerusform>Ausgelassen: %n Marke von %1, das nicht in der Gelenkzuordnung steht.</numerusform>
            <numerusform>Ausgelassen: %n Marken von %1, das nicht in der Gelenkzuordnung steht.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Left out: %n annotation(s) of category %1, which says neither left nor right.</source>
        <translation>
            <numerusform>Ausgelassen: %n Annotation der Kategorie %1, die weder links noch rechts nennt.</numerusform>
            <numerusform>Ausgelassen: %n Annotationen der Kategorie %1, die weder links noch rechts nennt.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Left out: %n mark(s) of body parts that are not joints: %1. A name that fits is %2; the command line takes a map of names (annotations --map).</source>
        <translation>
            <numerusform>Ausgelassen: %n Marke von Körperteilen, die keine Gelenke sind: %1. Ein passender Name ist %2; die Befehlszeile nimmt eine Zuordnung der Namen (annotations --map).</numerusform>
            <numerusform>Ausgelassen: %n Marken von Körperteilen, die keine Gelenke sind: %1. Ein passender Name ist %2; die Befehlszeile nimmt eine Zuordnung der Namen (annotations --map).</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>widgets::InspectColumns</name>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Truth</source>
        <translation>Wahrheit</translation>
    </message>
    <message>
        <source>%1?</source>
        <comment>a method with settings that are tried</comment>
        <translation>%1?</translation>
    </message>
</context>
<context>
    <name>widgets::InspectCurves</name>
    <message>
        <source>rigid</source>
        <translation>starr</translation>
    </message>
    <message>
        <source>coarse mesh</source>
        <translation>grobes Netz</translation>
    </message>
    <message>
        <source>medium mesh</source>
        <translation>mittleres Netz</translation>
    </message>
    <message>
        <source>full mesh</source>
        <translation>volles Netz</translation>
    </message>
    <message>
        <source>Hands move as a whole, their fingers do not</source>
        <translation>Die Hände bewegen sich als Ganzes, ihre Finger nicht</translation>
    </message>
    <message>
        <source>All joints move, by a coarse mesh</source>
        <translation>Alle Gelenke bewegen sich, mit grobem Netz</translation>
    </message>
    <message>
        <source>All joints move, by a finer mesh</source>
        <translation>Alle Gelenke bewegen sich, mit feinerem Netz</translation>
    </message>
    <message>
        <source>All joints move, by the whole mesh</source>
        <translation>Alle Gelenke bewegen sich, mit dem ganzen Netz</translation>
    </message>
</context>
<context>
    <name>widgets::InspectGrid</name>
    <message>
        <source>No picture at this instant.</source>
        <translation>Kein Bild zu diesem Zeitpunkt.</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>gescheitert</translation>
    </message>
    <message>
        <source>IoU: intersection over union of both silhouettes in this view, without the forearm, which the fit leaves out</source>
        <translation>IoU: Schnitt durch Vereinigung beider Silhouetten in dieser Ansicht, ohne den Unterarm, den die Anpassung auslässt</translation>
    </message>
    <message>
        <source>IoU: intersection over union of both silhouettes in this view</source>
        <translation>IoU: Schnitt durch Vereinigung beider Silhouetten in dieser Ansicht</translation>
    </message>
    <message>
        <source>IoU %1</source>
        <translation>IoU %1</translation>
    </message>
    <message>
        <source>%1, left out</source>
        <translation>%1, aus</translation>
    </message>
</context>
<context>
    <name>widgets::InspectJointErrors</name>
    <message>
        <source>The column whose error is drawn, joint by joint, at the iteration that is shown</source>
        <translation>Die Spalte, deren Fehler Gelenk für Gelenk gezeichnet ist, bei der gezeigten Iteration</translation>
    </message>
</context>
<context>
    <name>widgets::InspectLayerBar</name>
    <message>
        <source>Direction of the rim point whose field is shown</source>
        <translation>Richtung des Randpunkts, dessen Feld gezeigt wird</translation>
    </message>
    <message>
        <source>(%1, %2), direction %3°</source>
        <translation>(%1; %2), Richtung %3°</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>%1, refused</source>
        <translation>%1, verworfen</translation>
    </message>
    <message>
        <source>95 % regions</source>
        <translation>95-%-Bereiche</translation>
    </message>
    <message>
        <source>Point at a view to see what each method would match there; click to pin it.</source>
        <translation>Zeigen Sie auf eine Ansicht, um zu sehen, was jede Methode dort zuordnen würde; ein Klick heftet es an.</translation>
    </message>
    <message>
        <source>refused: %1</source>
        <translation>verworfen: %1</translation>
    </message>
    <message>
        <source>Rim points and matches that are drawn</source>
        <translation>Gezeichnete Randpunkte und Zuordnungen</translation>
    </message>
    <message>
        <source>missed: seen, not covered</source>
        <translation>fehlt: gesehen, nicht bedeckt</translation>
    </message>
    <message>
        <source>extra: covered, not seen</source>
        <translation>zu viel: bedeckt, nicht gesehen</translation>
    </message>
    <message>
        <source>forearm: left out, as the fit does</source>
        <translation>Unterarm: ausgelassen, wie in der Anpassung</translation>
    </message>
    <message>
        <source>outline, by direction</source>
        <translation>Umriss, nach Richtung</translation>
    </message>
    <message>
        <source>direction %1°</source>
        <translation>Richtung %1°</translation>
    </message>
    <message>
        <source>rim, with normals</source>
        <translation>Rand, mit Normalen</translation>
    </message>
    <message>
        <source>observed silhouette</source>
        <translation>beobachtete Silhouette</translation>
    </message>
    <message>
        <source>error: there is no recorded pose</source>
        <translation>Fehler: keine aufgezeichnete Pose</translation>
    </message>
    <message>
        <source>observed silhouette, with noise</source>
        <translation>beobachtete Silhouette, mit Rauschen</translation>
    </message>
    <message>
        <source>matches 0–%1+ px</source>
        <translation>Zuordnungen 0–%1+ px</translation>
    </message>
    <message>
        <source>field 0–%1+ px; clear: no match</source>
        <translation>Feld 0–%1+ px; klar: keine Zuordnung</translation>
    </message>
    <message>
        <source>error 0–%1+ mm</source>
        <translation>Fehler 0–%1+ mm</translation>
    </message>
</context>
<context>
    <name>widgets::InspectPage</name>
    <message>
        <source>Cameras: </source>
        <translation>Kameras: </translation>
    </message>
    <message>
        <source>Rows of cameras, from the current one on</source>
        <translation>Kamerazeilen, ab der aktuellen Kamera</translation>
    </message>
    <message>
        <source>Iteration</source>
        <translation>Iteration</translation>
    </message>
    <message>
        <source>Error, mm</source>
        <translation>Fehler, mm</translation>
    </message>
    <message>
        <source>Cost, mm²</source>
        <translation>Kosten, mm²</translation>
    </message>
    <message>
        <source>Frame %1 from frame %2</source>
        <translation>Bild %1 aus Bild %2</translation>
    </message>
    <message>
        <source>Iteration %1 of %2</source>
        <translation>Iteration %1 von %2</translation>
    </message>
    <message>
        <source>Fit this frame</source>
        <translation>Dieses Bild anpassen</translation>
    </message>
    <message>
        <source>With the methods chosen under Fit, from the pose of some frames before</source>
        <translation>Mit den unter Anpassung gewählten Verfahren, von der Pose einige Bilder davor</translation>
    </message>
    <message>
        <source>Fitting...</source>
        <translation>Anpassung läuft...</translation>
    </message>
    <message>
        <source>Fit the current frame to see the methods side by side.</source>
        <translation>Passen Sie das aktuelle Bild an, um die Verfahren nebeneinander zu sehen.</translation>
    </message>
    <message>
        <source>There is no reference to measure the error against.</source>
        <translation>Es gibt keine Referenz, an der der Fehler zu messen wäre.</translation>
    </message>
    <message>
        <source>%1 (frame %2 from frame %3 is being fitted)</source>
        <translation>%1 (Bild %2 aus Bild %3 wird angepasst)</translation>
    </message>
    <message>
        <source>All as it was fitted</source>
        <translation>Alles wie bei der Anpassung</translation>
    </message>
    <message>
        <source>What if: %1</source>
        <translation>Was wäre, wenn: %1</translation>
    </message>
    <message>
        <source>other settings</source>
        <translation>andere Einstellungen</translation>
    </message>
    <message>
        <source>Iteration; %1</source>
        <translation>Iteration; %1</translation>
    </message>
</context>
<context>
    <name>widgets::InspectProbe</name>
    <message>
        <source>the directions differ</source>
        <translation>die Richtungen weichen ab</translation>
    </message>
    <message>
        <source>beyond the gate</source>
        <translation>jenseits der Schranke</translation>
    </message>
    <message>
        <source>too far to count</source>
        <translation>zu weit, um zu zählen</translation>
    </message>
    <message>
        <source>no outline in this bin</source>
        <translation>kein Umriss in dieser Klasse</translation>
    </message>
    <message>
        <source>beyond the end of the hand</source>
        <translation>jenseits des Handendes</translation>
    </message>
</context>
<context>
    <name>widgets::InspectProbeCard</name>
    <message>
        <source>Take the pin away (or click the point once more)</source>
        <translation>Nadel entfernen (oder den Punkt noch einmal anklicken)</translation>
    </message>
    <message>
        <source>Take the pin away</source>
        <translation>Nadel entfernen</translation>
    </message>
    <message>
        <source>%1 %2, direction %3</source>
        <translation>%1 %2, Richtung %3</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Methode</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Bin</source>
        <translation>Klasse</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>behalten</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Nearest, px</source>
        <translation>Nächster, px</translation>
    </message>
    <message>
        <source>Distance, px</source>
        <translation>Abstand, px</translation>
    </message>
    <message>
        <source>Cost, px</source>
        <translation>Kosten, px</translation>
    </message>
    <message>
        <source>Match</source>
        <translation>Zuordnung</translation>
    </message>
    <message>
        <source>(%1, %2)</source>
        <comment>x and y; told apart where the decimal point is a comma, too</comment>
        <translation>(%1; %2)</translation>
    </message>
    <message>
        <source>What each method would take for the rim point of the pinned view, which looks in the direction above. The arrows of other columns start at rim points of their own, which may look elsewhere.</source>
        <translation>Was jede Methode für den Randpunkt der angehefteten Ansicht nähme, der in die Richtung oben zeigt. Die Pfeile anderer Spalten beginnen an deren eigenen Randpunkten, die anderswohin zeigen können.</translation>
    </message>
</context>
<context>
    <name>widgets::JointErrorDiagram</name>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Mean error per joint</source>
        <translation>Mittlerer Fehler je Gelenk</translation>
    </message>
</context>
<context>
    <name>widgets::JointTableModel</name>
    <message>
        <source>done</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>partial</source>
        <translation>teilweise</translation>
    </message>
    <message>
        <source>none</source>
        <comment>state of a joint without marks</comment>
        <translation>offen</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>Gelenk</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Ans.</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Status</translation>
    </message>
    <message>
        <source>Joint, in the order in which you work</source>
        <translation>Gelenk, in der Reihenfolge der Bearbeitung</translation>
    </message>
    <message>
        <source>Root mean square distance from click to reprojection, over the views used</source>
        <translation>Quadratisches Mittel (RMS) des Abstands vom Klick zur Rückprojektion, über die verwendeten Ansichten</translation>
    </message>
    <message>
        <source>Uncertainty of the 3D joint (standard deviation)</source>
        <translation>Unsicherheit des 3D-Gelenks (Standardabweichung)</translation>
    </message>
    <message>
        <source>bad</source>
        <translation>schlecht</translation>
    </message>
    <message>
        <source>proposed</source>
        <translation>vorgeschlagen</translation>
    </message>
    <message>
        <source>Proposed marks with a likelihood of %1 to %2</source>
        <translation>Vorgeschlagene Marken mit einer Wahrscheinlichkeit von %1 bis %2</translation>
    </message>
    <message>
        <source>Views that you clicked + views that you accepted</source>
        <translation>Geklickte Ansichten + übernommene Ansichten</translation>
    </message>
    <message>
        <source>Done: every view with a picture is placed or cannot be placed; bad: error above the threshold, an outlier, or no 3D point</source>
        <translation>Fertig: Jede Ansicht mit Bild ist gesetzt oder nicht setzbar; schlecht: Fehler über der Schwelle, ein Ausreißer oder kein 3D-Punkt</translation>
    </message>
</context>
<context>
    <name>widgets::MarkLegend</name>
    <message>
        <source>clicked: the 3D joint follows from these</source>
        <translation>geklickt: Aus diesen folgt das 3D-Gelenk</translation>
    </message>
    <message>
        <source>accepted as it was placed for you</source>
        <translation>übernommen, wie es vorgesetzt war</translation>
    </message>
    <message>
        <source>occluded, estimated</source>
        <translation>verdeckt, geschätzt</translation>
    </message>
    <message>
        <source>contradicts the other views</source>
        <translation>widerspricht den anderen Ansichten</translation>
    </message>
    <message>
        <source>square: right hand; round: left hand</source>
        <translation>Quadrat: rechte Hand; Kreis: linke Hand</translation>
    </message>
    <message>
        <source>What the marks mean</source>
        <translation>Was die Marken bedeuten</translation>
    </message>
    <message>
        <source>proposed: not a label until it is accepted</source>
        <translation>vorgeschlagen: erst mit dem Übernehmen eine Marke</translation>
    </message>
</context>
<context>
    <name>widgets::MarkPresenter</name>
    <message>
        <source>%1%2 frames</source>
        <translation>%1%2 Bilder</translation>
    </message>
    <message>
        <source>cannot be placed</source>
        <translation>nicht platzierbar</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>no picture</source>
        <translation>kein Bild</translation>
    </message>
    <message>
        <source>off %1&apos;s curve</source>
        <translation>neben der Kurve von %1</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>übernommen</translation>
    </message>
    <message>
        <source>proposed</source>
        <translation>vorgeschlagen</translation>
    </message>
    <message>
        <source>click here next</source>
        <translation>hier als Nächstes klicken</translation>
    </message>
</context>
<context>
    <name>widgets::MaskAttacher</name>
    <message>
        <source>Open a dataset first.</source>
        <translation>Öffnen Sie zuerst einen Datensatz.</translation>
    </message>
</context>
<context>
    <name>widgets::MatchLook</name>
    <message>
        <source>thumb</source>
        <translation>Daumen</translation>
    </message>
    <message>
        <source>index</source>
        <translation>Zeigefinger</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>Mittelfinger</translation>
    </message>
    <message>
        <source>ring</source>
        <translation>Ringfinger</translation>
    </message>
    <message>
        <source>little</source>
        <translation>kleiner Finger</translation>
    </message>
    <message>
        <source>palm</source>
        <translation>Handfläche</translation>
    </message>
    <message>
        <source>All, by distance</source>
        <translation>Alle, nach Abstand</translation>
    </message>
    <message>
        <source>All, by finger</source>
        <translation>Alle, nach Finger</translation>
    </message>
    <message>
        <source>Only: %1</source>
        <translation>Nur: %1</translation>
    </message>
</context>
<context>
    <name>widgets::MessageBar</name>
    <message>
        <source>Dismiss</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>widgets::MethodForm</name>
    <message>
        <source>More options</source>
        <translation>Weitere Optionen</translation>
    </message>
    <message>
        <source>The options that are seldom changed</source>
        <translation>Die selten geänderten Optionen</translation>
    </message>
    <message>
        <source>usual</source>
        <translation>üblich</translation>
    </message>
</context>
<context>
    <name>widgets::MethodText</name>
    <message>
        <source>A match is kept if the directions differ by less, degrees</source>
        <translation>Eine Zuordnung bleibt, wenn die Richtungen um weniger abweichen, Grad</translation>
    </message>
    <message>
        <source>Directions over 360 degrees; off: lines over 180 degrees</source>
        <translation>Richtungen über 360 Grad; aus: Linien über 180 Grad</translation>
    </message>
    <message>
        <source>Weight of the direction, pixels per radian</source>
        <translation>Gewicht der Richtung, Pixel je Radiant</translation>
    </message>
    <message>
        <source>Bins of direction</source>
        <translation>Richtungsklassen</translation>
    </message>
    <message>
        <source>Where the bins are centred: 0 on the x axis, or that share of a bin beside it</source>
        <translation>Wo die Klassen zentriert sind: 0 auf der x-Achse oder um diesen Teil einer Klasse daneben</translation>
    </message>
    <message>
        <source>The two matches weigh by how near their bins are</source>
        <translation>Die beiden Zuordnungen wiegen je nach Nähe ihrer Klassen</translation>
    </message>
    <message>
        <source>How matches are searched: both find the same ones</source>
        <translation>Wie Zuordnungen gesucht werden: Beide finden dieselben</translation>
    </message>
    <message>
        <source>The real-time variant</source>
        <translation>Die Echtzeitvariante</translation>
    </message>
    <message>
        <source>The palm is placed before the fingers move</source>
        <translation>Die Handfläche wird platziert, bevor sich die Finger bewegen</translation>
    </message>
    <message>
        <source>Coarse levels of the mesh first</source>
        <translation>Grobe Stufen des Netzes zuerst</translation>
    </message>
    <message>
        <source>Tau narrows from 45 degrees to 22.5</source>
        <translation>Tau verengt sich von 45 Grad auf 22,5</translation>
    </message>
    <message>
        <source>The distance along the outline counts a tenth</source>
        <translation>Der Abstand entlang des Umrisses zählt ein Zehntel</translation>
    </message>
    <message>
        <source>A weak pull of the angles to those of the start</source>
        <translation>Ein schwacher Zug der Winkel zu denen des Starts</translation>
    </message>
    <message>
        <source>The pull knows how fingers move together</source>
        <translation>Der Zug weiß, wie Finger sich gemeinsam bewegen</translation>
    </message>
    <message>
        <source>Other starts where silhouettes are left unexplained</source>
        <translation>Andere Starts, wo Silhouetten unerklärt bleiben</translation>
    </message>
    <message>
        <source>The last iterations on the full mesh</source>
        <translation>Die letzten Iterationen auf dem vollen Netz</translation>
    </message>
    <message>
        <source>What counts as a difference follows the noise of the outlines</source>
        <translation>Was als Differenz zählt, richtet sich nach dem Rauschen der Umrisse</translation>
    </message>
    <message>
        <source>Contour points pull the model, too</source>
        <translation>Auch Konturpunkte ziehen am Modell</translation>
    </message>
    <message>
        <source>Only contour points within tau are searched</source>
        <translation>Nur Konturpunkte innerhalb von Tau werden durchsucht</translation>
    </message>
    <message>
        <source>Cauchy weights with that scale, mm; 0 for none</source>
        <translation>Cauchy-Gewichte mit dieser Skala, mm; 0 für keine</translation>
    </message>
    <message>
        <source>Longest distance of a match, pixels; 0 for the usual one</source>
        <translation>Größter Abstand einer Zuordnung, Pixel; 0 für den üblichen</translation>
    </message>
    <message>
        <source>K of the truncated penalty, square pixels; 0 for none</source>
        <translation>K der gekappten Strafe, Quadratpixel; 0 für keine</translation>
    </message>
    <message>
        <source>How far the outline&apos;s polygon may be off, pixels</source>
        <translation>Wie weit das Polygon des Umrisses danebenliegen darf, Pixel</translation>
    </message>
    <message>
        <source>The outline&apos;s direction from its polygon or from a chord</source>
        <translation>Die Richtung des Umrisses aus seinem Polygon oder aus einer Sehne</translation>
    </message>
    <message>
        <source>Contour beyond the end of a hand model: left out, or as any other</source>
        <translation>Kontur jenseits des Endes eines Handmodells: ausgelassen oder wie jede andere</translation>
    </message>
    <message>
        <source>Most iterations of a fit</source>
        <translation>Höchstzahl der Iterationen einer Anpassung</translation>
    </message>
    <message>
        <source>Damping relative to the diagonal of the normal matrix</source>
        <translation>Dämpfung relativ zur Diagonale der Normalmatrix</translation>
    </message>
    <message>
        <source>rigid: a first phase moves each hand as a whole; paper: all at once</source>
        <translation>rigid: Eine erste Phase bewegt jede Hand als Ganzes; paper: alles zugleich</translation>
    </message>
    <message>
        <source>%1 must be %2 or %3, not &quot;%4&quot;.</source>
        <translation>%1 muss %2 oder %3 sein, nicht „%4“.</translation>
    </message>
    <message>
        <source>%1 must be a whole number from %2 to %3, not &quot;%4&quot;.</source>
        <translation>%1 muss eine ganze Zahl von %2 bis %3 sein, nicht „%4“.</translation>
    </message>
    <message>
        <source>%1 must be a number from %2 to %3, not &quot;%4&quot;.</source>
        <translation>%1 muss eine Zahl von %2 bis %3 sein, nicht „%4“.</translation>
    </message>
    <message>
        <source>Write &quot;%1&quot; as name=value.</source>
        <translation>„%1“ als Name=Wert schreiben.</translation>
    </message>
    <message>
        <source>%1 has no option &quot;%2&quot;; it has %3.</source>
        <translation>%1 hat keine Option „%2“, sondern %3.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a method; the methods are %2.</source>
        <translation>„%1“ ist kein Verfahren; die Verfahren sind %2.</translation>
    </message>
    <message>
        <source>Fingers and hands do not penetrate each other on the way from other starts</source>
        <translation>Finger und Hände durchdringen einander nicht auf dem Weg von anderen Starts aus</translation>
    </message>
</context>
<context>
    <name>widgets::NameBar</name>
    <message>
        <source>Use this name</source>
        <translation>Diesen Namen verwenden</translation>
    </message>
    <message>
        <source>Your marks are kept under your &amp;name:</source>
        <translation>Ihre Marken werden gespeichert unter dem &amp;Namen:</translation>
    </message>
</context>
<context>
    <name>widgets::NoteEdit</name>
    <message>
        <source>Note on this frame</source>
        <translation>Notiz zu diesem Bild</translation>
    </message>
</context>
<context>
    <name>widgets::OtherMarks</name>
    <message>
        <source>%1 has %2 in %3 of this sequence.</source>
        <translation>%1 hat %2 in %3 dieser Sequenz.</translation>
    </message>
    <message numerus="yes">
        <source>%n mark(s)</source>
        <translation>
            <numerusform>%n Marke</numerusform>
            <numerusform>%n Marken</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s)</source>
        <translation>
            <numerusform>%n Bild</numerusform>
            <numerusform>%n Bildern</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>widgets::PairFilterText</name>
    <message>
        <source>“%1” is neither a method of these results nor sequence, start, test, difference or initial.</source>
        <translation>„%1“ ist weder ein Verfahren dieser Ergebnisse noch sequence, start, test, difference oder initial.</translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation>„%1“ ist keine Zahl.</translation>
    </message>
    <message>
        <source>“%1” is neither a comparison such as A-B&gt;1 nor a sequence.</source>
        <translation>„%1“ ist weder ein Vergleich wie A-B&gt;1 noch eine Sequenz.</translation>
    </message>
    <message>
        <source>Conditions with blanks between them, all of which must hold: A-B&gt;1 difference&gt;=10 sequence=01. A and B are the methods chosen on the left; a method&apos;s name is its error in mm, .seconds or .iterations behind it what it took; start, test and difference are frames, initial is the error of the start pose.</source>
        <translation>Bedingungen mit Leerzeichen dazwischen, die alle gelten müssen: A-B&gt;1 difference&gt;=10 sequence=01. A und B sind die links gewählten Verfahren; der Name eines Verfahrens ist sein Fehler in mm, mit .seconds oder .iterations dahinter sein Aufwand; start, test und difference sind Bilder, initial ist der Fehler der Startpose.</translation>
    </message>
</context>
<context>
    <name>widgets::PairTableModel</name>
    <message>
        <source>Sequence</source>
        <translation>Sequenz</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Test</translation>
    </message>
    <message>
        <source>Start mm</source>
        <translation>Start mm</translation>
    </message>
    <message>
        <source>Apart</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>A − B mm</source>
        <translation>A − B mm</translation>
    </message>
    <message>
        <source>%1 iterations</source>
        <translation>%1 Iterationen</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Frames between start and test</source>
        <translation>Bilder zwischen Start und Test</translation>
    </message>
    <message>
        <source>Mean joint error of the start pose</source>
        <translation>Mittlerer Gelenkfehler der Startpose</translation>
    </message>
    <message>
        <source>Mean joint error of %1; the smallest of a row is bold</source>
        <translation>Mittlerer Gelenkfehler von %1; der kleinste einer Zeile ist fett</translation>
    </message>
    <message>
        <source>Error of %1 minus error of %2: above 0 where %1 is worse</source>
        <translation>Fehler von %1 minus Fehler von %2: über 0, wo %1 schlechter ist</translation>
    </message>
</context>
<context>
    <name>widgets::PictureExport</name>
    <message>
        <source>PNG picture (*.png)</source>
        <translation>PNG-Grafik (*.png)</translation>
    </message>
    <message>
        <source>SVG drawing (*.svg)</source>
        <translation>SVG-Zeichnung (*.svg)</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>Grafik speichern</translation>
    </message>
    <message>
        <source>%1 could not be written. Choose a folder that you may write to.</source>
        <translation>%1 konnte nicht geschrieben werden. Bitte einen Ordner mit Schreibrechten wählen.</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Grafik kopieren</translation>
    </message>
    <message>
        <source>Save picture...</source>
        <translation>Grafik speichern...</translation>
    </message>
    <message>
        <source>Saved to %1</source>
        <translation>Gespeichert in %1</translation>
    </message>
    <message>
        <source>The picture is in the clipboard.</source>
        <translation>Das Bild ist in der Zwischenablage.</translation>
    </message>
    <message>
        <source>PDF page (*.pdf)</source>
        <translation>PDF-Seite (*.pdf)</translation>
    </message>
</context>
<context>
    <name>widgets::PlotCanvas</name>
    <message>
        <source>curves</source>
        <translation>Kurven</translation>
    </message>
</context>
<context>
    <name>widgets::QualityPanel</name>
    <message>
        <source>Nothing stands out in this frame.</source>
        <translation>In diesem Bild fällt nichts auf.</translation>
    </message>
    <message>
        <source>Bad above</source>
        <translation>Schlecht über</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>No frame of this sequence has marks yet.</source>
        <translation>Noch kein Bild dieser Sequenz hat Marken.</translation>
    </message>
    <message>
        <source>Joints: %1 done, %2 partial, %3 bad.</source>
        <translation>Gelenke: %1 fertig, %2 teilweise, %3 schlecht.</translation>
    </message>
    <message>
        <source>This frame</source>
        <translation>Dieses Bild</translation>
    </message>
    <message>
        <source>Whole sequence</source>
        <translation>Ganze Sequenz</translation>
    </message>
    <message>
        <source>Nothing stands out in this sequence.</source>
        <translation>In dieser Sequenz fällt nichts auf.</translation>
    </message>
    <message>
        <source>Your clicks scatter by %1 px per axis.</source>
        <translation>Ihre Klicks streuen um %1 px je Achse.</translation>
    </message>
    <message>
        <source>Where to look for findings</source>
        <translation>Wo nach Befunden gesucht wird</translation>
    </message>
    <message>
        <source>No frame has marks of yours (%1) yet.</source>
        <translation>Noch hat kein Bild Marken von Ihnen (%1).</translation>
    </message>
    <message numerus="yes">
        <source>%n proposed mark(s) wait to be checked.</source>
        <translation>
            <numerusform>%n vorgeschlagene Marke wartet auf Prüfung.</numerusform>
            <numerusform>%n vorgeschlagene Marken warten auf Prüfung.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) with marks of %1.</source>
        <translation>
            <numerusform>%n Bild mit Marken von %1.</numerusform>
            <numerusform>%n Bilder mit Marken von %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Kameras</translation>
    </message>
    <message>
        <source>Too few clicks to know how far yours scatter: 1 px is assumed.</source>
        <translation>Zu wenige Klicks, um Ihre Streuung zu kennen: 1 px wird angenommen.</translation>
    </message>
</context>
<context>
    <name>widgets::RatersPanel</name>
    <message>
        <source>No two raters have marked the same joint. Start a repeat round to see how far you agree with yourself.</source>
        <translation>Keine zwei Bewerter haben dasselbe Gelenk markiert. Beginnen Sie eine Wiederholungsrunde, um zu sehen, wie gut Sie mit sich selbst übereinstimmen.</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Compares all raters as they stand now</source>
        <translation>Vergleicht alle Bewerter nach jetzigem Stand</translation>
    </message>
    <message numerus="yes">
        <source>%n shared click(s), %1 px apart (RMS)</source>
        <translation>
            <numerusform>%n gemeinsamer Klick, Abstand %1 px (RMS)</numerusform>
            <numerusform>%n gemeinsame Klicks, Abstand %1 px (RMS)</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 scatters by %2 px per axis</source>
        <translation>%1 streut um %2 px je Achse</translation>
    </message>
    <message>
        <source>End the round</source>
        <translation>Durchgang beenden</translation>
    </message>
    <message>
        <source>Start a repeat round</source>
        <translation>Wiederholungsrunde beginnen</translation>
    </message>
    <message>
        <source>Back to your own marks; both rounds are compared</source>
        <translation>Zurück zu Ihren eigenen Marken; beide Durchgänge werden verglichen</translation>
    </message>
    <message>
        <source>Repeat round: %1 of %2 joints are left.</source>
        <translation>Wiederholungsrunde: noch %1 von %2 Gelenken offen.</translation>
    </message>
    <message numerus="yes">
        <source>All raters together: %1 ± %2 mm, from %n click(s).</source>
        <translation>
            <numerusform>Alle Bewerter zusammen: %1 ± %2 mm aus %n Klick.</numerusform>
            <numerusform>Alle Bewerter zusammen: %1 ± %2 mm aus %n Klicks.</numerusform>
        </translation>
    </message>
    <message>
        <source>Your 3D joint lies %1 mm from it.</source>
        <translation>Ihr 3D-Gelenk liegt %1 mm davon entfernt.</translation>
    </message>
    <message>
        <source>A random tenth of your finished joints, your first marks hidden: how well do you repeat yourself?</source>
        <translation>Ein zufälliges Zehntel Ihrer fertigen Gelenke, ohne Ihre ersten Marken zu sehen: Wie gut wiederholen Sie sich?</translation>
    </message>
    <message>
        <source>To the next joint of the round that is not marked yet</source>
        <translation>Zum nächsten Gelenk des Durchgangs, das noch nicht markiert ist</translation>
    </message>
    <message>
        <source>Your first marks are hidden until the round has ended.</source>
        <translation>Ihre ersten Marken sind verborgen, bis der Durchgang beendet ist.</translation>
    </message>
    <message>
        <source>%1 has too few clicks to know how far they scatter</source>
        <translation>%1 hat zu wenige Klicks, um ihre Streuung zu kennen</translation>
    </message>
</context>
<context>
    <name>widgets::RefinementModel</name>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Clicks</source>
        <translation>Klicks</translation>
    </message>
    <message>
        <source>px before</source>
        <translation>px vorher</translation>
    </message>
    <message>
        <source>px after</source>
        <translation>px nachher</translation>
    </message>
    <message>
        <source>turned, °</source>
        <translation>gedreht, °</translation>
    </message>
    <message>
        <source>moved, mm</source>
        <translation>verschoben, mm</translation>
    </message>
    <message>
        <source>focal, %</source>
        <translation>Brennw., %</translation>
    </message>
    <message>
        <source>RMS of its clicks with the calibration in use</source>
        <translation>RMS ihrer Klicks mit der verwendeten Kalibrierung</translation>
    </message>
    <message>
        <source>RMS of its clicks with the refined calibration</source>
        <translation>RMS ihrer Klicks mit der verfeinerten Kalibrierung</translation>
    </message>
    <message>
        <source>By how much the camera turns</source>
        <translation>Um wie viel sich die Kamera dreht</translation>
    </message>
    <message>
        <source>By how much the camera&apos;s centre moves</source>
        <translation>Um wie viel sich das Kamerazentrum verschiebt</translation>
    </message>
    <message>
        <source>By how much its focal length grows</source>
        <translation>Um wie viel ihre Brennweite wächst</translation>
    </message>
</context>
<context>
    <name>widgets::RefinementPage</name>
    <message>
        <source>Refine</source>
        <translation>Verfeinern</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Use the refined calibration</source>
        <translation>Verfeinerte Kalibrierung verwenden</translation>
    </message>
    <message>
        <source>Use the chosen one</source>
        <translation>Gewählte verwenden</translation>
    </message>
    <message>
        <source>Adjusts every camera&apos;s place, direction, focal length and first lens coefficients to all clicks of the dataset</source>
        <translation>Passt Ort, Richtung, Brennweite und erste Linsenkoeffizienten jeder Kamera an alle Klicks des Datensatzes an</translation>
    </message>
    <message>
        <source>Writes a new calibration file beside the one in use, which is kept; all joints are reconstructed anew</source>
        <translation>Schreibt eine neue Kalibrierungsdatei neben die verwendete, die erhalten bleibt; alle Gelenke werden neu rekonstruiert</translation>
    </message>
    <message>
        <source>The dataset uses that calibration from now on; marks stay as they are</source>
        <translation>Der Datensatz verwendet ab jetzt diese Kalibrierung; Marken bleiben, wie sie sind</translation>
    </message>
    <message>
        <source>Calibrations of this dataset</source>
        <translation>Kalibrierungen dieses Datensatzes</translation>
    </message>
    <message>
        <source>Refine the calibration first.</source>
        <translation>Zuerst die Kalibrierung verfeinern.</translation>
    </message>
    <message>
        <source>The clicks of all sequences are being looked at.</source>
        <translation>Die Klicks aller Sequenzen werden ausgewertet.</translation>
    </message>
    <message>
        <source>Refined from %1 joints in %2 frames. A click scatters by %3 px per axis about the refined cameras.</source>
        <translation>Verfeinert aus %1 Gelenken in %2 Bildern. Klicks streuen mit %3 px je Achse um die verfeinerten Kameras.</translation>
    </message>
    <message numerus="yes">
        <source>%n wrong click(s) took no part.</source>
        <translation>
            <numerusform>%n falscher Klick blieb außen vor.</numerusform>
            <numerusform>%n falsche Klicks blieben außen vor.</numerusform>
        </translation>
    </message>
    <message>
        <source>The adjustment stopped before it had settled.</source>
        <translation>Die Anpassung endete, bevor sie konvergiert war.</translation>
    </message>
    <message>
        <source>%1 (in use)</source>
        <translation>%1 (in Verwendung)</translation>
    </message>
    <message>
        <source>Distances and shapes will be as good as the clicks; the world as a whole stays where it was, known to %1 mm.</source>
        <translation>Abstände und Formen werden so gut wie die Klicks; die Welt als Ganzes bleibt, wo sie war, auf %1 mm genau bekannt.</translation>
    </message>
</context>
<context>
    <name>widgets::ResultTableModel</name>
    <message>
        <source>Converged</source>
        <translation>Konvergiert</translation>
    </message>
    <message>
        <source>Stopped at the iteration limit</source>
        <translation>Höchstzahl der Iterationen erreicht</translation>
    </message>
    <message>
        <source>No matches were left</source>
        <translation>Keine Zuordnungen übrig</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Gestoppt</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>gescheitert</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Methode</translation>
    </message>
    <message>
        <source>Start mm</source>
        <translation>Start mm</translation>
    </message>
    <message>
        <source>Error mm</source>
        <translation>Fehler mm</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Iterationen</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
</context>
<context>
    <name>widgets::ReviewModel</name>
    <message>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Doubt, %</source>
        <translation>Zweifel, %</translation>
    </message>
    <message>
        <source>Near</source>
        <translation>Nahe</translation>
    </message>
    <message>
        <source>Why the frame deserves a look</source>
        <translation>Warum das Bild eine Durchsicht verdient</translation>
    </message>
    <message>
        <source>0: sure, 100: lost; of the more doubtful hand</source>
        <translation>0: sicher, 100: verloren; für die zweifelhaftere Hand</translation>
    </message>
    <message>
        <source>Doubtful frames around that a corrected one helps</source>
        <translation>Zweifelhafte Bilder ringsum, denen eine Korrektur hilft</translation>
    </message>
</context>
<context>
    <name>widgets::ReviewPanel</name>
    <message>
        <source>Accept</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>Correct</source>
        <translation>Korrigieren</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>First pass...</source>
        <translation>Erster Durchlauf...</translation>
    </message>
    <message>
        <source>No frame waits for a look.</source>
        <translation>Kein Bild wartet auf Durchsicht.</translation>
    </message>
    <message>
        <source>Frames that the first pass has labelled wait here for a look, doubtful ones first.</source>
        <translation>Bilder, die der erste Durchlauf markiert hat, warten hier auf Durchsicht, zweifelhafte zuerst.</translation>
    </message>
</context>
<context>
    <name>widgets::ReviewText</name>
    <message>
        <source>quite sure; left hand first</source>
        <translation>recht sicher; linke Hand zuerst</translation>
    </message>
    <message>
        <source>quite sure; right hand first</source>
        <translation>recht sicher; rechte Hand zuerst</translation>
    </message>
    <message>
        <source>views do not agree on the left hand</source>
        <translation>Ansichten widersprechen sich bei der linken Hand</translation>
    </message>
    <message>
        <source>views do not agree on the right hand</source>
        <translation>Ansichten widersprechen sich bei der rechten Hand</translation>
    </message>
    <message>
        <source>%1: its bone is %2 % longer than usual</source>
        <translation>%1: Knochen %2 % länger als üblich</translation>
    </message>
    <message>
        <source>%1: its bone is %2 % shorter than usual</source>
        <translation>%1: Knochen %2 % kürzer als üblich</translation>
    </message>
    <message>
        <source>the left hand was not found</source>
        <translation>linke Hand nicht gefunden</translation>
    </message>
    <message>
        <source>the right hand was not found</source>
        <translation>rechte Hand nicht gefunden</translation>
    </message>
    <message numerus="yes">
        <source>%n joint(s) of the left hand missing</source>
        <translation>
            <numerusform>%n Gelenk der linken Hand fehlt</numerusform>
            <numerusform>%n Gelenke der linken Hand fehlen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n joint(s) of the right hand missing</source>
        <translation>
            <numerusform>%n Gelenk der rechten Hand fehlt</numerusform>
            <numerusform>%n Gelenke der rechten Hand fehlen</numerusform>
        </translation>
    </message>
    <message>
        <source>the left hand jumps by %1 mm</source>
        <translation>linke Hand springt um %1 mm</translation>
    </message>
    <message>
        <source>the right hand jumps by %1 mm</source>
        <translation>rechte Hand springt um %1 mm</translation>
    </message>
    <message>
        <source>First pass, detecting: %1 of %2</source>
        <translation>Erster Durchlauf, Erkennung: %1 von %2</translation>
    </message>
    <message>
        <source>First pass, measuring hands: %1 of %2</source>
        <translation>Erster Durchlauf, Vermessung der Hände: %1 von %2</translation>
    </message>
    <message>
        <source>First pass, fitting: %1 of %2</source>
        <translation>Erster Durchlauf, Anpassung: %1 von %2</translation>
    </message>
    <message>
        <source>First pass, tracking: %1 of %2</source>
        <translation>Erster Durchlauf, Verfolgung: %1 von %2</translation>
    </message>
    <message numerus="yes">
        <source>All %n frame(s) are reviewed.</source>
        <translation>
            <numerusform>%n Bild ist durchgesehen, keines ist offen.</numerusform>
            <numerusform>Alle %n Bilder sind durchgesehen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) left, </source>
        <translation>
            <numerusform>Noch %n Bild, </numerusform>
            <numerusform>Noch %n Bilder, </numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of them doubtful; %2 reviewed.</source>
        <translation>davon %1 zweifelhaft; %2 durchgesehen.</translation>
    </message>
    <message>
        <source>Error to be expected of those left: %1 mm a joint, as far as reviewed ones tell.</source>
        <translation>Zu erwartender Fehler der offenen: %1 mm je Gelenk, soweit die durchgesehenen es zeigen.</translation>
    </message>
    <message>
        <source>The error of those left is known once three frames are reviewed.</source>
        <translation>Der Fehler der offenen ist bekannt, sobald drei Bilder durchgesehen sind.</translation>
    </message>
    <message>
        <source>The error of those left is not known until a joint was corrected.</source>
        <translation>Der Fehler der übrigen ist erst bekannt, wenn ein Gelenk korrigiert wurde.</translation>
    </message>
</context>
<context>
    <name>widgets::RigDrawing</name>
    <message>
        <source>The cameras of the calibration, and where they look. Drag to turn, wheel to zoom.</source>
        <translation>Die Kameras der Kalibrierung und wohin sie blicken. Ziehen dreht, das Rad zoomt.</translation>
    </message>
    <message>
        <source>The cameras appear here once the calibration is read.</source>
        <translation>Die Kameras erscheinen hier, sobald die Kalibrierung gelesen ist.</translation>
    </message>
</context>
<context>
    <name>widgets::RigHealthModel</name>
    <message numerus="yes">
        <source>%1: %n click(s) that other cameras confirm are too few to judge it</source>
        <translation>
            <numerusform>%1: %n von anderen Kameras bestätigter Klick ist zu wenig zum Beurteilen</numerusform>
            <numerusform>%1: %n von anderen Kameras bestätigte Klicks sind zu wenig zum Beurteilen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: mean %2, %3 ± %4 px; clicks scatter by %5 px about it; %n wrong click(s)</source>
        <translation>
            <numerusform>%1: Mittel (%2; %3) ± %4 px; Klicks streuen mit %5 px darum; %n falscher Klick</numerusform>
            <numerusform>%1: Mittel (%2; %3) ± %4 px; Klicks streuen mit %5 px darum; %n falsche Klicks</numerusform>
        </translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Status</translation>
    </message>
    <message>
        <source>n</source>
        <translation>n</translation>
    </message>
    <message>
        <source>rms</source>
        <translation>rms</translation>
    </message>
    <message>
        <source>σ</source>
        <translation>σ</translation>
    </message>
    <message>
        <source>Clicks that other cameras confirm</source>
        <translation>Klicks, die andere Kameras bestätigen</translation>
    </message>
    <message>
        <source>RMS residual, px</source>
        <translation>Residuum (RMS), px</translation>
    </message>
    <message>
        <source>Mean residual to the right, px; the joint is made from the other cameras</source>
        <translation>Mittleres Residuum nach rechts, px; das Gelenk stammt aus den anderen Kameras</translation>
    </message>
    <message>
        <source>Mean residual downwards, px; the joint is made from the other cameras</source>
        <translation>Mittleres Residuum nach unten, px; das Gelenk stammt aus den anderen Kameras</translation>
    </message>
    <message>
        <source>Clicks and calibration error together, per axis, px: what a click is worth</source>
        <translation>Klick- und Kalibrierungsfehler zusammen, je Achse, px: so genau ist ein Klick</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>Two cameras cannot tell which of them is off.</source>
        <translation>Aus zwei Kameras ist nicht zu erkennen, welche von ihnen falsch steht.</translation>
    </message>
</context>
<context>
    <name>widgets::RigHealthView</name>
    <message>
        <source>Refine calibration...</source>
        <translation>Kalibrierung verfeinern...</translation>
    </message>
    <message>
        <source>Adjusts the cameras to the clicks; nothing changes before you use the result</source>
        <translation>Passt die Kameras an die Klicks an; nichts ändert sich, bevor Sie das Ergebnis verwenden</translation>
    </message>
    <message>
        <source>The clicks of all sequences are being looked at.</source>
        <translation>Die Klicks aller Sequenzen werden ausgewertet.</translation>
    </message>
    <message>
        <source>No joint is clicked in two cameras yet: the calibration cannot be judged.</source>
        <translation>Noch ist kein Gelenk in zwei Kameras angeklickt: Die Kalibrierung ist nicht zu beurteilen.</translation>
    </message>
    <message>
        <source>There are too few clicks to judge the calibration.</source>
        <translation>Es gibt zu wenige Klicks, um die Kalibrierung zu beurteilen.</translation>
    </message>
</context>
<context>
    <name>widgets::RigText</name>
    <message>
        <source>%1 of %2 cameras are %3 to %4 px off in every frame: the calibration as a whole does not fit the clicks.</source>
        <translation>%1 von %2 Kameras liegen in jedem Bild %3 bis %4 px daneben: Die Kalibrierung insgesamt passt nicht zu den Klicks.</translation>
    </message>
    <message numerus="yes">
        <source>%1 is %2 px off in the %n sequence(s) %3 only: it stood otherwise there.</source>
        <translation>
            <numerusform>%1 liegt nur in der Sequenz %3 um %2 px daneben: Sie stand dort anders.</numerusform>
            <numerusform>%1 liegt nur in den %n Sequenzen %3 um %2 px daneben: Sie stand dort anders.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is %2 frames behind the others: its residuals go with the joints&apos; motion.</source>
        <translation>%1 liegt %2 Bilder hinter den anderen: Ihre Residuen folgen der Bewegung der Gelenke.</translation>
    </message>
    <message>
        <source>%1 is %2 frames ahead of the others: its residuals go with the joints&apos; motion.</source>
        <translation>%1 liegt %2 Bilder vor den anderen: Ihre Residuen folgen der Bewegung der Gelenke.</translation>
    </message>
    <message>
        <source>%1 is %2 px off in every frame: its calibration moved.</source>
        <translation>%1 liegt in jedem Bild %2 px daneben: Ihre Kalibrierung hat sich verschoben.</translation>
    </message>
    <message>
        <source>%1 moved before frame %2 of sequence %3: its picture lies %4 px elsewhere from there on.</source>
        <translation>%1 hat sich vor Bild %2 der Sequenz %3 bewegt: Von dort an liegt ihr Bild um %4 px versetzt.</translation>
    </message>
    <message>
        <source>%1 drifts by %2 px in 100 frames of sequence %3.</source>
        <translation>%1 driftet um %2 px in 100 Bildern der Sequenz %3.</translation>
    </message>
    <message>
        <source>Clicks of %1: too few to know how far they scatter; 1 px is assumed.</source>
        <translation>Klicks von %1: zu wenige, um ihre Streuung zu kennen; 1 px wird angenommen.</translation>
    </message>
    <message>
        <source>Clicks of %1 scatter by %2 px per axis (%3 to %4 by camera).</source>
        <translation>Klicks von %1 streuen um %2 px je Achse (%3 bis %4 je nach Kamera).</translation>
    </message>
    <message>
        <source>Too few clicks that other cameras confirm: %1.</source>
        <translation>Zu wenige von anderen Kameras bestätigte Klicks: %1.</translation>
    </message>
    <message>
        <source>The calibration&apos;s own error adds %1 to %2 px.</source>
        <translation>Der Fehler der Kalibrierung selbst kommt mit %1 bis %2 px hinzu.</translation>
    </message>
    <message>
        <source>too few clicks</source>
        <translation>zu wenige Klicks</translation>
    </message>
    <message>
        <source>off</source>
        <translation>daneben</translation>
    </message>
    <message>
        <source>partly off</source>
        <translation>teils daneben</translation>
    </message>
    <message>
        <source>late</source>
        <translation>verspätet</translation>
    </message>
    <message>
        <source>early</source>
        <translation>verfrüht</translation>
    </message>
    <message>
        <source>moved</source>
        <translation>bewegt</translation>
    </message>
    <message>
        <source>drifts</source>
        <translation>driftet</translation>
    </message>
    <message>
        <source>fits</source>
        <translation>passt</translation>
    </message>
    <message>
        <source>Cameras can be refined from %1 joints on that three cameras or more have clicked (%2 so far).</source>
        <translation>Kameras lassen sich ab %1 Gelenken verfeinern, die in mindestens drei Kameras angeklickt sind (bisher %2).</translation>
    </message>
    <message>
        <source>The calibration fits the clicks.</source>
        <translation>Die Kalibrierung passt zu den Klicks.</translation>
    </message>
    <message>
        <source>Refining is worth it from %1 frames and %2 joints on (%3 and %4 so far).</source>
        <translation>Verfeinern lohnt sich ab %1 Bildern und %2 Gelenken (bisher %3 und %4).</translation>
    </message>
    <message>
        <source>There are enough clicks to refine the calibration.</source>
        <translation>Es gibt genug Klicks, um die Kalibrierung zu verfeinern.</translation>
    </message>
    <message>
        <source>Two cameras cannot tell which of them is off: a refinement needs three.</source>
        <translation>Zwei Kameras zeigen nicht, welche von beiden danebenliegt: Eine Verfeinerung braucht drei.</translation>
    </message>
</context>
<context>
    <name>widgets::ScatterPlot</name>
    <message>
        <source>Logarithmic axes</source>
        <translation>Logarithmische Achsen</translation>
    </message>
</context>
<context>
    <name>widgets::ScenePanel</name>
    <message>
        <source>Whose pose stands in the scene</source>
        <translation>Wessen Pose in der Szene steht</translation>
    </message>
    <message>
        <source>Recorded pose</source>
        <translation>Aufgezeichnete Pose</translation>
    </message>
</context>
<context>
    <name>widgets::SceneView</name>
    <message>
        <source>The 3D scene needs OpenGL, which this display does not have.</source>
        <translation>Die 3D-Szene braucht OpenGL, das auf dieser Anzeige fehlt.</translation>
    </message>
    <message>
        <source>Reset view</source>
        <translation>Ansicht zurücksetzen</translation>
    </message>
    <message>
        <source>Look through</source>
        <translation>Blick durch</translation>
    </message>
    <message>
        <source>scene</source>
        <translation>Szene</translation>
    </message>
</context>
<context>
    <name>widgets::SilhouettePage</name>
    <message>
        <source>Around the joints</source>
        <translation>Um die Gelenke</translation>
    </message>
    <message>
        <source>Around the posed hand model</source>
        <translation>Um das Handmodell in seiner Pose</translation>
    </message>
    <message>
        <source>What differs from the empty room</source>
        <translation>Was vom leeren Raum abweicht</translation>
    </message>
    <message>
        <source>What has not the backdrop&apos;s colour</source>
        <translation>Was nicht die Farbe des Hintergrunds hat</translation>
    </message>
    <message>
        <source>What has the colour of skin</source>
        <translation>Was Hautfarbe hat</translation>
    </message>
    <message>
        <source>Give them to this sequence</source>
        <translation>Dieser Sequenz zuordnen</translation>
    </message>
    <message>
        <source>Make silhouettes</source>
        <translation>Silhouetten erzeugen</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>By how much the pose may be wrong: that far from the model the picture decides</source>
        <translation>Um wie viel die Pose falsch sein darf: So weit um das Modell entscheidet das Bild</translation>
    </message>
    <message>
        <source>How much of the forearm is kept, in lengths of the palm from the wrist</source>
        <translation>Wie viel vom Unterarm bleibt, in Handflächenlängen ab dem Handgelenk</translation>
    </message>
    <message>
        <source>Poses are fitted to them then</source>
        <translation>Posen werden dann an sie angepasst</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Gefunden</translation>
    </message>
    <message>
        <source>Pose may be off by</source>
        <translation>Pose ungenau um</translation>
    </message>
    <message>
        <source>Forearm, in palms</source>
        <translation>Unterarm, in Handflächen</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>In the views: the left button adds to the silhouette, the right one (or Shift) takes away; Ctrl and the wheel change the size</source>
        <translation>In den Ansichten: Die linke Taste fügt zur Silhouette hinzu, die rechte (oder Umschalt) nimmt weg; Strg und Rad ändern die Größe</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Radius of the brush, pixels of the picture</source>
        <translation>Radius des Pinsels, in Bildpixeln</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>every</source>
        <translation>alle</translation>
    </message>
    <message numerus="yes">
        <source>%n silhouette(s) made, %1 were there already.</source>
        <translation>
            <numerusform>%n Silhouette erzeugt, %1 waren schon da.</numerusform>
            <numerusform>%n Silhouetten erzeugt, %1 waren schon da.</numerusform>
        </translation>
    </message>
    <message>
        <source>The sequence uses them now.</source>
        <translation>Die Sequenz verwendet sie jetzt.</translation>
    </message>
    <message numerus="yes">
        <source>This frame: a silhouette in %n view(s)</source>
        <translation>
            <numerusform>Dieses Bild: eine Silhouette in %n Ansicht</numerusform>
            <numerusform>Dieses Bild: eine Silhouette in %n Ansichten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %n of them kept on disk</source>
        <translation>
            <numerusform>, %n davon gespeichert</numerusform>
            <numerusform>, %n davon gespeichert</numerusform>
        </translation>
    </message>
    <message>
        <source>Looking for silhouettes. Nothing appears where no joints of the frame are known: annotate some, or choose another way.</source>
        <translation>Silhouetten werden gesucht. Wo keine Gelenke des Bildes bekannt sind, erscheint nichts: einige annotieren oder einen anderen Weg wählen.</translation>
    </message>
    <message>
        <source>Undo %1</source>
        <translation>Rückgängig: %1</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo %1</source>
        <translation>Wiederherstellen: %1</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>This sequence has masks already (%1). They stay on disk.</source>
        <translation>Diese Sequenz hat schon Masken (%1). Die Dateien bleiben erhalten.</translation>
    </message>
    <message>
        <source>Use the new ones instead</source>
        <translation>Die neuen verwenden</translation>
    </message>
    <message>
        <source>Make them only</source>
        <translation>Nur erzeugen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>The last frame lies before the first one.</source>
        <translation>Das letzte Bild liegt vor dem ersten.</translation>
    </message>
</context>
<context>
    <name>widgets::SilhouetteStudy</name>
    <message>
        <source>touch up %1</source>
        <translation>%1 ausbessern</translation>
    </message>
</context>
<context>
    <name>widgets::StatusLine</name>
    <message numerus="yes">
        <source>saved %n s ago</source>
        <translation>
            <numerusform>vor %n s gespeichert</numerusform>
            <numerusform>vor %n s gespeichert</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>saved %n min ago</source>
        <translation>
            <numerusform>vor %n min gespeichert</numerusform>
            <numerusform>vor %n min gespeichert</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>saved %n h ago</source>
        <translation>
            <numerusform>vor %n h gespeichert</numerusform>
            <numerusform>vor %n h gespeichert</numerusform>
        </translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>NOT SAVED</source>
        <translation>NICHT GESPEICHERT</translation>
    </message>
    <message>
        <source>read-only</source>
        <translation>schreibgeschützt</translation>
    </message>
    <message>
        <source>saved</source>
        <translation>gespeichert</translation>
    </message>
    <message numerus="yes">
        <source>, %n s left</source>
        <translation>
            <numerusform>, noch %n s</numerusform>
            <numerusform>, noch %n s</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %n min left</source>
        <translation>
            <numerusform>, noch %n min</numerusform>
            <numerusform>, noch %n min</numerusform>
        </translation>
    </message>
    <message>
        <source>saving, %1 %</source>
        <translation>wird gespeichert, %1 %</translation>
    </message>
</context>
<context>
    <name>widgets::StoreText</name>
    <message>
        <source>opened for reading only</source>
        <translation>nur zum Lesen geöffnet</translation>
    </message>
    <message>
        <source>opened by another window</source>
        <translation>in einem anderen Fenster geöffnet</translation>
    </message>
    <message>
        <source>opened by another window (%1)</source>
        <translation>in einem anderen Fenster geöffnet (%1)</translation>
    </message>
    <message>
        <source>the folder is read-only</source>
        <translation>der Ordner ist schreibgeschützt</translation>
    </message>
    <message>
        <source>the file is read-only</source>
        <translation>die Datei ist schreibgeschützt</translation>
    </message>
    <message>
        <source>This file system has no locks: make sure that no other window has %1 open.</source>
        <translation>Dieses Dateisystem kennt keine Sperren: achten Sie darauf, dass kein anderes Fenster %1 geöffnet hat.</translation>
    </message>
    <message>
        <source>No backup could be made: %1</source>
        <translation>Es konnte keine Sicherung angelegt werden: %1</translation>
    </message>
</context>
<context>
    <name>widgets::SubjectModel</name>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>Hand</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>Model, mm</source>
        <translation>Modell, mm</translation>
    </message>
    <message>
        <source>Measured, mm</source>
        <translation>Gemessen, mm</translation>
    </message>
    <message>
        <source>Change, %</source>
        <translation>Änderung, %</translation>
    </message>
    <message>
        <source>± mm</source>
        <translation>± mm</translation>
    </message>
    <message>
        <source>Standard deviation of the measured length</source>
        <translation>Standardabweichung der gemessenen Länge</translation>
    </message>
</context>
<context>
    <name>widgets::SubjectPage</name>
    <message>
        <source>Use masks</source>
        <translation>Masken verwenden</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Vermessen</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Save as a new dataset...</source>
        <translation>Als neuen Datensatz speichern...</translation>
    </message>
    <message>
        <source>Saved in %1.</source>
        <translation>Gespeichert in %1.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Evenly drawn from the annotated ones; more than 15 bring little and take long</source>
        <translation>Gleichmäßig aus den annotierten gewählt; mehr als 15 bringen wenig und dauern lange</translation>
    </message>
    <message>
        <source>Outlines tell the girth; joints alone leave it as the model has it</source>
        <translation>Umrisse bestimmen die Dicke; Gelenke allein belassen sie wie im Modell</translation>
    </message>
    <message>
        <source>A dataset with these hands; footage and masks stay where they are, annotations and motion are copied</source>
        <translation>Ein Datensatz mit diesen Händen; Aufnahmen und Masken bleiben, wo sie sind, Annotationen und Bewegung werden kopiert</translation>
    </message>
    <message>
        <source>Sequences</source>
        <translation>Sequenzen</translation>
    </message>
    <message>
        <source>Frames at most</source>
        <translation>Höchstzahl Bilder</translation>
    </message>
    <message>
        <source>Choose a sequence with annotated frames.</source>
        <translation>Wählen Sie eine Sequenz mit annotierten Bildern.</translation>
    </message>
    <message>
        <source>Bone lengths, scale and girth of this person&apos;s hands are found from annotated frames: at least %1, from 5 on every bone by itself.</source>
        <translation>Knochenlängen, Skalierung und Dicke der Hände dieser Person werden aus annotierten Bildern bestimmt: aus mindestens %1, ab 5 jeder Knochen für sich.</translation>
    </message>
    <message>
        <source>A new folder for the dataset</source>
        <translation>Ein neuer Ordner für den Datensatz</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
</context>
<context>
    <name>widgets::SubjectStudy</name>
    <message>
        <source>reading annotations</source>
        <translation>Annotationen werden gelesen</translation>
    </message>
    <message>
        <source>reading masks</source>
        <translation>Masken werden gelesen</translation>
    </message>
    <message>
        <source>measuring</source>
        <translation>Messung läuft</translation>
    </message>
</context>
<context>
    <name>widgets::SubjectText</name>
    <message>
        <source>The calibration is not in mm: its unit is %1 mm. The cameras of the new dataset are in mm.</source>
        <translation>Die Kalibrierung ist nicht in mm: Ihre Einheit ist %1 mm. Die Kameras des neuen Datensatzes sind in mm.</translation>
    </message>
    <message>
        <source>The calibration is not in mm: its unit is %1 mm if this hand is as large as the model, so that scale says nothing. The cameras of the new dataset are in mm.</source>
        <translation>Die Kalibrierung ist nicht in mm: Ihre Einheit ist %1 mm, falls diese Hand so groß wie das Modell ist; die Skalierung sagt daher nichts aus. Die Kameras des neuen Datensatzes sind in mm.</translation>
    </message>
    <message>
        <source>%1 of %2 annotated frames were used, evenly drawn.</source>
        <translation>%1 von %2 annotierten Bildern wurden verwendet, gleichmäßig gewählt.</translation>
    </message>
    <message numerus="yes">
        <source>%n annotated frame(s) were used.</source>
        <translation>
            <numerusform>%n annotiertes Bild wurde verwendet.</numerusform>
            <numerusform>%n annotierte Bilder wurden verwendet.</numerusform>
        </translation>
    </message>
    <message>
        <source>Fewer than 3 frames: only the scale is measured.</source>
        <translation>Weniger als 3 Bilder: Nur die Skalierung wird gemessen.</translation>
    </message>
    <message numerus="yes">
        <source>Outlines of %n frame(s) fit to %1 mm.</source>
        <translation>
            <numerusform>Umrisse aus %n Bild passen auf %1 mm genau.</numerusform>
            <numerusform>Umrisse aus %n Bildern passen auf %1 mm genau.</numerusform>
        </translation>
    </message>
    <message>
        <source>No masks of frames in which all hands are annotated: the girth stays the model&apos;s.</source>
        <translation>Keine Masken zu Bildern, in denen alle Hände annotiert sind: Die Dicke bleibt die des Modells.</translation>
    </message>
    <message>
        <source>Left hand: scale %1 ± %2, girth %3 ± %4 mm; joints fit to %5 mm.</source>
        <translation>Linke Hand: Skalierung %1 ± %2, Dicke %3 ± %4 mm; Gelenke passen auf %5 mm genau.</translation>
    </message>
    <message>
        <source>Right hand: scale %1 ± %2, girth %3 ± %4 mm; joints fit to %5 mm.</source>
        <translation>Rechte Hand: Skalierung %1 ± %2, Dicke %3 ± %4 mm; Gelenke passen auf %5 mm genau.</translation>
    </message>
    <message numerus="yes">
        <source>%n annotated frame(s)</source>
        <translation>
            <numerusform>%n annotiertes Bild</numerusform>
            <numerusform>%n annotierte Bilder</numerusform>
        </translation>
    </message>
    <message>
        <source>masks</source>
        <translation>Masken</translation>
    </message>
    <message>
        <source>no masks</source>
        <translation>keine Masken</translation>
    </message>
    <message>
        <source>Fewer than 5 frames: bones keep the model&apos;s proportions.</source>
        <translation>Weniger als 5 Bilder: Die Knochen behalten die Proportionen des Modells.</translation>
    </message>
    <message>
        <source>The calibration does not fit the clicks everywhere (Quality, Cameras): measure again after it is refined.</source>
        <translation>Die Kalibrierung passt nicht überall zu den Klicks (Qualität, Kameras): nach dem Verfeinern erneut vermessen.</translation>
    </message>
</context>
<context>
    <name>widgets::SummaryModel</name>
    <message>
        <source>start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Seconds per pair</source>
        <translation>Sekunden je Paar</translation>
    </message>
    <message>
        <source>Mean and standard deviation of the error, mm, by frames apart</source>
        <translation>Mittelwert und Standardabweichung des Fehlers, mm, je Bildabstand</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Methode</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>All, mm</source>
        <translation>Alle, mm</translation>
    </message>
    <message>
        <source>Pairs that are finished</source>
        <translation>Fertige Paare</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>Paare</translation>
    </message>
</context>
<context>
    <name>widgets::Timeline</name>
    <message>
        <source>Timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>Frame %1</source>
        <translation>Bild %1</translation>
    </message>
    <message>
        <source>%1: %2 done, %3 partial, %4 bad, %5 occluded</source>
        <translation>%1: %2 fertig, %3 teilweise, %4 schlecht, %5 verdeckt</translation>
    </message>
    <message>
        <source>Marks of %1</source>
        <translation>Marken von %1</translation>
    </message>
    <message>
        <source>%1: proposed, doubt %2 %</source>
        <translation>%1: vorgeschlagen, Zweifel %2 %</translation>
    </message>
</context>
<context>
    <name>widgets::TimelineLegend</name>
    <message>
        <source>Upper lane: left hand. Lower lane: right hand. The fuller a bar, the more joints have marks.</source>
        <translation>Obere Spur: linke Hand. Untere Spur: rechte Hand. Je voller ein Balken, desto mehr Gelenke haben Marken.</translation>
    </message>
    <message>
        <source>every joint is done</source>
        <translation>jedes Gelenk ist fertig</translation>
    </message>
    <message>
        <source>some joints have marks</source>
        <translation>einige Gelenke haben Marken</translation>
    </message>
    <message>
        <source>a joint is bad: large error, outlier, or no 3D point</source>
        <translation>ein Gelenk ist schlecht: großer Fehler, Ausreißer oder kein 3D-Punkt</translation>
    </message>
    <message>
        <source>at its foot: a joint is occluded, its place estimated</source>
        <translation>am Fuß: ein Gelenk ist verdeckt, sein Ort geschätzt</translation>
    </message>
    <message>
        <source>between the lanes: marks of other people</source>
        <translation>zwischen den Spuren: Marken anderer Personen</translation>
    </message>
    <message>
        <source>tick above: a note</source>
        <translation>Strich oben: eine Notiz</translation>
    </message>
    <message>
        <source>tick below: a test frame of the benchmark; the line: the current frame</source>
        <translation>Strich unten: ein Testbild des Benchmarks; die Linie: das aktuelle Bild</translation>
    </message>
    <message>
        <source>stripes: proposed by a program, waits for a look</source>
        <translation>Streifen: von einem Programm vorgeschlagen, wartet auf Durchsicht</translation>
    </message>
    <message>
        <source>stripes: the same, and doubtful</source>
        <translation>Streifen: ebenso, und zweifelhaft</translation>
    </message>
</context>
<context>
    <name>widgets::TrackerColumn</name>
    <message>
        <source>%1 has no estimate of frame %2 from frame %3</source>
        <translation>%1 hat keine Schätzung von Bild %2 aus Bild %3</translation>
    </message>
    <message>
        <source>%1 has fewer than three joints of a hand, or they lie on a line: that hand cannot be drawn.</source>
        <translation>%1 hat weniger als drei Gelenke einer Hand, oder sie liegen auf einer Geraden: diese Hand kann nicht gezeichnet werden.</translation>
    </message>
</context>
<context>
    <name>widgets::ViewPanel</name>
    <message>
        <source>Mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>Shaded</source>
        <translation>Schattiert</translation>
    </message>
    <message>
        <source>Wireframe</source>
        <translation>Drahtgitter</translation>
    </message>
    <message>
        <source>Style</source>
        <translation>Stil</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Kamerabild</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>Helligkeit</translation>
    </message>
    <message>
        <source>Contrast</source>
        <translation>Kontrast</translation>
    </message>
    <message>
        <source>Gamma</source>
        <translation>Gamma</translation>
    </message>
    <message>
        <source>All views</source>
        <translation>Alle Ansichten</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Kameras</translation>
    </message>
    <message>
        <source>Untick to hide a view; drag to change the order</source>
        <translation>Abwählen blendet eine Ansicht aus; Ziehen ändert die Reihenfolge</translation>
    </message>
</context>
<context>
    <name>widgets::WhatIfCase</name>
    <message>
        <source>only %1</source>
        <translation>nur %1</translation>
    </message>
    <message>
        <source>without %1</source>
        <translation>ohne %1</translation>
    </message>
    <message>
        <source>outlines with %1 px of noise (draw %2)</source>
        <translation>Umrisse mit %1 px Rauschen (Ziehung %2)</translation>
    </message>
    <message>
        <source>%1 in the place of %2</source>
        <translation>%1 an der Stelle von %2</translation>
    </message>
    <message>
        <source>being fitted</source>
        <translation>wird angepasst</translation>
    </message>
    <message>
        <source>%1 (being fitted)</source>
        <translation>%1 (wird angepasst)</translation>
    </message>
</context>
<context>
    <name>widgets::WhatIfPanel</name>
    <message>
        <source>Fit a pair: the settings of its methods can be changed here then.</source>
        <translation>Zuerst ein Paar anpassen: Dann lassen sich hier die Einstellungen der Verfahren ändern.</translation>
    </message>
    <message>
        <source>What does each camera add?</source>
        <translation>Was bringt jede Kamera?</translation>
    </message>
    <message>
        <source>Fits without each camera in turn: how much the error grows stands beside it</source>
        <translation>Passt reihum ohne je eine Kamera an: Daneben steht, wie sehr der Fehler wächst</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Verwenden</translation>
    </message>
    <message>
        <source>Gives the column these settings</source>
        <translation>Gibt der Spalte diese Einstellungen</translation>
    </message>
    <message>
        <source>Add as another column</source>
        <translation>Als weitere Spalte</translation>
    </message>
    <message>
        <source>Keeps the column, and shows these settings beside it</source>
        <translation>Behält die Spalte und zeigt diese Einstellungen daneben</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>All as it was fitted</source>
        <translation>Alles wie bei der Anpassung</translation>
    </message>
    <message>
        <source>The error grows most without %1.</source>
        <translation>Der Fehler wächst am meisten ohne %1.</translation>
    </message>
    <message>
        <source>The column whose settings are changed</source>
        <translation>Die Spalte, deren Einstellungen geändert werden</translation>
    </message>
    <message>
        <source>The method as on the command line; Enter takes it over</source>
        <translation>Das Verfahren wie auf der Befehlszeile; die Eingabetaste übernimmt es</translation>
    </message>
    <message>
        <source>Method with its settings</source>
        <translation>Verfahren mit Einstellungen</translation>
    </message>
    <message>
        <source>Noise of the outlines</source>
        <translation>Rauschen der Umrisse</translation>
    </message>
    <message>
        <source>What if the silhouettes were noisier? By how much their outlines move, pixels</source>
        <translation>Was wäre, wenn die Silhouetten stärker rauschten? Um wie viel ihre Umrisse sich verschieben, Pixel</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Cameras that take part</source>
        <translation>Beteiligte Kameras</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Whether this camera&apos;s silhouette takes part</source>
        <translation>Ob die Silhouette dieser Kamera beteiligt ist</translation>
    </message>
    <message>
        <source>Leave at least one camera on.</source>
        <translation>Mindestens eine Kamera eingeschaltet lassen.</translation>
    </message>
    <message>
        <source>Fitting...</source>
        <translation>Anpassung läuft...</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Kameras</translation>
    </message>
    <message>
        <source>Noise of the outlines, px</source>
        <translation>Rauschen der Umrisse, px</translation>
    </message>
    <message>
        <source>Error, mm</source>
        <translation>Fehler, mm</translation>
    </message>
    <message>
        <source>Drag a setting: the error over it appears here.</source>
        <translation>Eine Einstellung ziehen: Hier erscheint der Fehler in Abhängigkeit davon.</translation>
    </message>
    <message>
        <source>%1 instead of %2</source>
        <translation>%1 statt %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Fitting without each camera...</source>
        <translation>Anpassung ohne je eine Kamera...</translation>
    </message>
    <message>
        <source>Fits at a row of values of this parameter, for every column that has it, and fills the curve; once more stops</source>
        <translation>Passt mit einer Reihe von Werten dieser Größe an, für jede Spalte, die sie hat, und füllt die Kurve; noch einmal hält an</translation>
    </message>
    <message>
        <source>%1: least error %2 mm at %3</source>
        <translation>%1: kleinster Fehler %2 mm bei %3</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Sweep the noise</source>
        <translation>Rauschen durchlaufen</translation>
    </message>
    <message>
        <source>Sweep the cameras</source>
        <translation>Kameras durchlaufen</translation>
    </message>
    <message>
        <source>Sweep %1</source>
        <translation>%1 durchlaufen</translation>
    </message>
    <message>
        <source>%1 of %2 fits</source>
        <translation>%1 von %2 Anpassungen</translation>
    </message>
    <message>
        <source>Draw %1</source>
        <translation>Ziehung %1</translation>
    </message>
    <message>
        <source>Of all points: %1</source>
        <translation>Bei allen Punkten: %1</translation>
    </message>
    <message>
        <source>Draw of the noise</source>
        <translation>Ziehung des Rauschens</translation>
    </message>
    <message>
        <source>Which draw of the noise: other wiggles of the same size. One draw alone may be luck.</source>
        <translation>Welche Ziehung des Rauschens: andere Wellen derselben Größe. Eine einzige Ziehung kann Zufall sein.</translation>
    </message>
    <message>
        <source>As it was fitted: %1</source>
        <translation>Wie bei der Anpassung: %1</translation>
    </message>
</context>
<context>
    <name>widgets::WorkWords</name>
    <message>
        <source>%1 %2 mm</source>
        <translation>%1 %2 mm</translation>
    </message>
    <message>
        <source>Fit the current frame: F</source>
        <translation>Aktuelles Bild anpassen: F</translation>
    </message>
    <message>
        <source>start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>%1 failed</source>
        <translation>%1 fehlgeschlagen</translation>
    </message>
    <message>
        <source>Frame %1 from frame %2</source>
        <translation>Bild %1 aus Bild %2</translation>
    </message>
    <message>
        <source>There is nothing to measure the error against.</source>
        <translation>Es gibt nichts, woran der Fehler zu messen wäre.</translation>
    </message>
    <message>
        <source>Choose methods and sequences, then Run</source>
        <translation>Verfahren und Sequenzen wählen, dann Starten</translation>
    </message>
    <message>
        <source>%1 pairs</source>
        <translation>%1 Paare</translation>
    </message>
</context>
<context>
    <name>widgets::Workspaces</name>
    <message>
        <source>Quality</source>
        <translation>Qualität</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Anpassung</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>All views are hidden: tick one under View, Cameras.</source>
        <translation>Alle Ansichten sind ausgeblendet: unter „Ansicht“, „Kameras“ eine ankreuzen.</translation>
    </message>
    <message>
        <source>Raters</source>
        <translation>Bewerter</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Durchsicht</translation>
    </message>
    <message>
        <source>What if</source>
        <translation>Was wäre, wenn</translation>
    </message>
</context>
</TS>
