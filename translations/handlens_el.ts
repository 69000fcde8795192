<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="el">
<context>
    <name>app::ActionTable</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Αρχείο</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Επεξεργασία</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Προβολή</translation>
    </message>
    <message>
        <source>&amp;Annotate</source>
        <translation>Επι&amp;σημείωση</translation>
    </message>
    <message>
        <source>&amp;Go</source>
        <translation>&amp;Μετάβαση</translation>
    </message>
    <message>
        <source>F&amp;it</source>
        <translation>Π&amp;ροσαρμογή</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Βοήθεια</translation>
    </message>
    <message>
        <source>&amp;Open a dataset...</source>
        <translation>Ά&amp;νοιγμα συνόλου δεδομένων...</translation>
    </message>
    <message>
        <source>Open the &amp;demo</source>
        <translation>Άνοιγμα επί&amp;δειξης</translation>
    </message>
    <message>
        <source>&amp;Import annotations...</source>
        <translation>&amp;Εισαγωγή επισημειώσεων...</translation>
    </message>
    <message>
        <source>&amp;Export annotations...</source>
        <translation>Ε&amp;ξαγωγή επισημειώσεων...</translation>
    </message>
    <message>
        <source>&amp;Report on the annotations...</source>
        <translation>&amp;Αναφορά για τις επισημειώσεις...</translation>
    </message>
    <message>
        <source>A page with progress, raters, worst joints and figures</source>
        <translation>Σελίδα με πρόοδο, αξιολογητές, χειρότερες αρθρώσεις και διαγράμματα</translation>
    </message>
    <message>
        <source>&amp;Save the views as a picture...</source>
        <translation>Απο&amp;θήκευση προβολών ως εικόνα...</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>Έξ&amp;οδος</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Αναίρεση</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>Α&amp;κύρωση αναίρεσης</translation>
    </message>
    <message>
        <source>&amp;Note on this frame...</source>
        <translation>&amp;Σημείωση για αυτό το καρέ...</translation>
    </message>
    <message>
        <source>Your n&amp;ame...</source>
        <translation>Το ό&amp;νομά σας...</translation>
    </message>
    <message>
        <source>The name that your marks are kept under</source>
        <translation>Το όνομα με το οποίο φυλάσσονται τα σημάδια σας</translation>
    </message>
    <message>
        <source>&amp;Inspect</source>
        <translation>Ε&amp;ξέταση</translation>
    </message>
    <message>
        <source>&amp;Benchmark</source>
        <translation>Συγκριτική &amp;δοκιμή</translation>
    </message>
    <message>
        <source>&amp;Hide all overlays</source>
        <translation>&amp;Απόκρυψη όλων των επικαλύψεων</translation>
    </message>
    <message>
        <source>While the key is held</source>
        <translation>Όσο κρατάτε πατημένο το πλήκτρο</translation>
    </message>
    <message>
        <source>Error lines three times as &amp;long</source>
        <translation>Γραμμές σφάλματος με &amp;τριπλό μήκος</translation>
    </message>
    <message>
        <source>Lou&amp;pe</source>
        <translation>&amp;Φακός</translation>
    </message>
    <message>
        <source>Magnifies the pixels around the pointer</source>
        <translation>Μεγεθύνει τα πίξελ γύρω από τον δείκτη του ποντικιού</translation>
    </message>
    <message>
        <source>S&amp;keleton</source>
        <translation>Σ&amp;κελετός</translation>
    </message>
    <message>
        <source>&amp;Epipolar guides</source>
        <translation>&amp;Επιπολικές γραμμές</translation>
    </message>
    <message>
        <source>Lines on which the selected joint must lie, as the other views say</source>
        <translation>Γραμμές πάνω στις οποίες πρέπει να βρίσκεται η επιλεγμένη άρθρωση σύμφωνα με τις άλλες προβολές</translation>
    </message>
    <message>
        <source>P&amp;re-placed marks</source>
        <translation>&amp;Προτεινόμενα σημάδια</translation>
    </message>
    <message>
        <source>Marks that wait to be accepted</source>
        <translation>Σημάδια που περιμένουν αποδοχή</translation>
    </message>
    <message>
        <source>Joint &amp;names</source>
        <translation>&amp;Ονόματα αρθρώσεων</translation>
    </message>
    <message>
        <source>&amp;Follow the selected joint</source>
        <translation>Παρακολούθ&amp;ηση επιλεγμένης άρθρωσης</translation>
    </message>
    <message>
        <source>Keeps the selected joint in the middle of every zoomed view</source>
        <translation>Κρατά την επιλεγμένη άρθρωση στο κέντρο κάθε μεγεθυμένης προβολής</translation>
    </message>
    <message>
        <source>Mesh: sha&amp;ded</source>
        <translation>Πλέγμα: σκ&amp;ιασμένο</translation>
    </message>
    <message>
        <source>Mesh: &amp;wireframe</source>
        <translation>Πλέγμα: συ&amp;ρμάτινο</translation>
    </message>
    <message>
        <source>Mesh: o&amp;ff</source>
        <translation>Π&amp;λέγμα: ανενεργό</translation>
    </message>
    <message>
        <source>Next mesh st&amp;yle</source>
        <translation>Επόμενο στ&amp;υλ πλέγματος</translation>
    </message>
    <message>
        <source>Mesh more &amp;opaque</source>
        <translation>Πλέγμα πιο αδιαφα&amp;νές</translation>
    </message>
    <message>
        <source>Mesh more &amp;transparent</source>
        <translation>Πλέ&amp;γμα πιο διαφανές</translation>
    </message>
    <message>
        <source>Mesh of the left hand</source>
        <translation>Πλέγμα αριστερού χεριού</translation>
    </message>
    <message>
        <source>Mesh of the right hand</source>
        <translation>Πλέγμα δεξιού χεριού</translation>
    </message>
    <message>
        <source>Mesh of the recorded pose</source>
        <translation>Πλέγμα καταγεγραμμένης πόζας</translation>
    </message>
    <message>
        <source>Mesh of the fit&apos;s start pose</source>
        <translation>Πλέγμα αρχικής πόζας της προσαρμογής</translation>
    </message>
    <message>
        <source>Hand &amp;model of the marks</source>
        <translation>&amp;Μοντέλο χεριού από τα σημάδια</translation>
    </message>
    <message>
        <source>The hand model, fitted to the 3D joints of this frame</source>
        <translation>Το μοντέλο χεριού, προσαρμοσμένο στις αρθρώσεις 3D αυτού του καρέ</translation>
    </message>
    <message>
        <source>&amp;Brightness, contrast, gamma...</source>
        <translation>Φωτεινότητα, αντί&amp;θεση, γάμα...</translation>
    </message>
    <message>
        <source>Of the current view or of all</source>
        <translation>Της τρέχουσας προβολής ή όλων</translation>
    </message>
    <message>
        <source>&amp;Cameras: hide, reorder...</source>
        <translation>Κάμερες: απόκρυ&amp;ψη, σειρά...</translation>
    </message>
    <message>
        <source>Sho&amp;w whole images</source>
        <translation>Προ&amp;βολή ολόκληρων εικόνων</translation>
    </message>
    <message>
        <source>Ends zoom and pan in all views</source>
        <translation>Αναιρεί ζουμ και μετατόπιση σε όλες τις προβολές</translation>
    </message>
    <message>
        <source>&amp;Zoom all views to the joint</source>
        <translation>&amp;Ζουμ όλων των προβολών στην άρθρωση</translation>
    </message>
    <message>
        <source>Maximise view 1</source>
        <translation>Μεγιστοποίηση προβολής 1</translation>
    </message>
    <message>
        <source>Maximise view 2</source>
        <translation>Μεγιστοποίηση προβολής 2</translation>
    </message>
    <message>
        <source>Maximise view 3</source>
        <translation>Μεγιστοποίηση προβολής 3</translation>
    </message>
    <message>
        <source>Maximise view 4</source>
        <translation>Μεγιστοποίηση προβολής 4</translation>
    </message>
    <message>
        <source>Maximise view 5</source>
        <translation>Μεγιστοποίηση προβολής 5</translation>
    </message>
    <message>
        <source>Maximise view 6</source>
        <translation>Μεγιστοποίηση προβολής 6</translation>
    </message>
    <message>
        <source>Maximise view 7</source>
        <translation>Μεγιστοποίηση προβολής 7</translation>
    </message>
    <message>
        <source>Maximise view 8</source>
        <translation>Μεγιστοποίηση προβολής 8</translation>
    </message>
    <message>
        <source>All views again</source>
        <translation>Ξανά όλες οι προβολές</translation>
    </message>
    <message>
        <source>Reset the 3D sc&amp;ene</source>
        <translation>Επαναφορά σκηνής &amp;3D</translation>
    </message>
    <message>
        <source>Look thro&amp;ugh the current camera</source>
        <translation>Θέαση από την τρέ&amp;χουσα κάμερα</translation>
    </message>
    <message>
        <source>The 3D scene from the current camera</source>
        <translation>Η σκηνή 3D από την τρέχουσα κάμερα</translation>
    </message>
    <message>
        <source>Li&amp;ght colours</source>
        <translation>Ανοιχτόχρ&amp;ωμο θέμα</translation>
    </message>
    <message>
        <source>Full scree&amp;n</source>
        <translation>Π&amp;λήρης οθόνη</translation>
    </message>
    <message>
        <source>&amp;Accept the pre-placed mark</source>
        <translation>&amp;Αποδοχή προτεινόμενου σημαδιού</translation>
    </message>
    <message>
        <source>In the current view or, if that has a mark, in the next one without</source>
        <translation>Στην τρέχουσα προβολή ή, αν αυτή έχει σημάδι, στην επόμενη χωρίς</translation>
    </message>
    <message>
        <source>Accept in all &amp;views</source>
        <translation>Αποδοχή σε όλες τις προ&amp;βολές</translation>
    </message>
    <message>
        <source>Accept all joints of the &amp;frame</source>
        <translation>Αποδοχή όλων των αρθρώσεων του &amp;καρέ</translation>
    </message>
    <message>
        <source>Propose the &amp;rest from the hand model</source>
        <translation>Πρόταση των &amp;υπολοίπων από το μοντέλο χεριού</translation>
    </message>
    <message>
        <source>Fits the hand model to the 3D joints of this frame and places the others, to be checked</source>
        <translation>Προσαρμόζει το μοντέλο χεριού στις αρθρώσεις 3D αυτού του καρέ και τοποθετεί τις υπόλοιπες, για έλεγχο</translation>
    </message>
    <message>
        <source>&amp;Delete the mark</source>
        <translation>&amp;Διαγραφή σημαδιού</translation>
    </message>
    <message>
        <source>Of the selected joint in the current view</source>
        <translation>Της επιλεγμένης άρθρωσης στην τρέχουσα προβολή</translation>
    </message>
    <message>
        <source>Delete in all vie&amp;ws</source>
        <translation>Δια&amp;γραφή σε όλες τις προβολές</translation>
    </message>
    <message>
        <source>&amp;Occluded, estimated</source>
        <translation>Κρυ&amp;μμένο, κατ’ εκτίμηση</translation>
    </message>
    <message>
        <source>The joint is hidden here; its place is a guess</source>
        <translation>Η άρθρωση δεν φαίνεται εδώ· η θέση της είναι εκτίμηση</translation>
    </message>
    <message>
        <source>&amp;Cannot be placed here</source>
        <translation>Δεν &amp;τοποθετείται εδώ</translation>
    </message>
    <message>
        <source>&amp;Previous joint</source>
        <translation>&amp;Προηγούμενη άρθρωση</translation>
    </message>
    <message>
        <source>&amp;Next joint</source>
        <translation>&amp;Επόμενη άρθρωση</translation>
    </message>
    <message>
        <source>Previous view</source>
        <translation>Προηγούμενη προβολή</translation>
    </message>
    <message>
        <source>Next view</source>
        <translation>Επόμενη προβολή</translation>
    </message>
    <message>
        <source>Nudge left</source>
        <translation>Μετακίνηση αριστερά</translation>
    </message>
    <message>
        <source>By a quarter of an image pixel</source>
        <translation>Κατά ένα τέταρτο του πίξελ της εικόνας</translation>
    </message>
    <message>
        <source>Nudge right</source>
        <translation>Μετακίνηση δεξιά</translation>
    </message>
    <message>
        <source>Nudge up</source>
        <translation>Μετακίνηση πάνω</translation>
    </message>
    <message>
        <source>Nudge down</source>
        <translation>Μετακίνηση κάτω</translation>
    </message>
    <message>
        <source>Nudge left by a pixel</source>
        <translation>Μετακίνηση αριστερά κατά ένα πίξελ</translation>
    </message>
    <message>
        <source>Nudge right by a pixel</source>
        <translation>Μετακίνηση δεξιά κατά ένα πίξελ</translation>
    </message>
    <message>
        <source>Nudge up by a pixel</source>
        <translation>Μετακίνηση πάνω κατά ένα πίξελ</translation>
    </message>
    <message>
        <source>Nudge down by a pixel</source>
        <translation>Μετακίνηση κάτω κατά ένα πίξελ</translation>
    </message>
    <message>
        <source>Copy the pose of the previous annotated frame</source>
        <translation>Αντιγραφή πόζας του προηγούμενου επισημειωμένου καρέ</translation>
    </message>
    <message>
        <source>As marks that wait to be checked</source>
        <translation>Ως σημάδια που περιμένουν έλεγχο</translation>
    </message>
    <message>
        <source>&amp;Interpolate between annotated frames</source>
        <translation>Παρεμβο&amp;λή μεταξύ επισημειωμένων καρέ</translation>
    </message>
    <message>
        <source>In 3D, along straight lines, over the gap around this frame</source>
        <translation>Σε 3D, σε ευθείες γραμμές, στο κενό γύρω από αυτό το καρέ</translation>
    </message>
    <message>
        <source>Interpolate along a curve</source>
        <translation>Παρεμβολή κατά μήκος καμπύλης</translation>
    </message>
    <message>
        <source>In 3D, cubic, over the gap around this frame</source>
        <translation>Σε 3D, κυβική, στο κενό γύρω από αυτό το καρέ</translation>
    </message>
    <message>
        <source>&amp;Swap left and right from here on</source>
        <translation>Ε&amp;ναλλαγή αριστερού και δεξιού από εδώ και πέρα</translation>
    </message>
    <message>
        <source>Delete all marks of this frame</source>
        <translation>Διαγραφή όλων των σημαδιών του καρέ</translation>
    </message>
    <message>
        <source>Delete a range of frames...</source>
        <translation>Διαγραφή σε εύρος καρέ...</translation>
    </message>
    <message>
        <source>Next joint when all views are done</source>
        <translation>Επόμενη άρθρωση όταν όλες οι προβολές είναι έτοιμες</translation>
    </message>
    <message>
        <source>14 joints per hand</source>
        <translation>14 αρθρώσεις ανά χέρι</translation>
    </message>
    <message>
        <source>21 joints per hand</source>
        <translation>21 αρθρώσεις ανά χέρι</translation>
    </message>
    <message>
        <source>With wrist and finger tips</source>
        <translation>Με καρπό και ακροδάχτυλα</translation>
    </message>
    <message>
        <source>All joints of the model</source>
        <translation>Όλες οι αρθρώσεις του μοντέλου</translation>
    </message>
    <message>
        <source>Joints from a &amp;file...</source>
        <translation>Αρθρώσεις από αρ&amp;χείο...</translation>
    </message>
    <message>
        <source>Move the joint up in the list</source>
        <translation>Άρθρωση προς τα πάνω στη λίστα</translation>
    </message>
    <message>
        <source>Move the joint down in the list</source>
        <translation>Άρθρωση προς τα κάτω στη λίστα</translation>
    </message>
    <message>
        <source>&amp;Start a repeat round</source>
        <translation>Έναρξη &amp;γύρου επανάληψης</translation>
    </message>
    <message>
        <source>Next joint of the repeat round</source>
        <translation>Επόμενη άρθρωση του γύρου επανάληψης</translation>
    </message>
    <message>
        <source>Compare ra&amp;ters</source>
        <translation>Σύγκριση α&amp;ξιολογητών</translation>
    </message>
    <message>
        <source>&amp;Previous frame</source>
        <translation>&amp;Προηγούμενο καρέ</translation>
    </message>
    <message>
        <source>&amp;Next frame</source>
        <translation>&amp;Επόμενο καρέ</translation>
    </message>
    <message>
        <source>Ten frames back</source>
        <translation>Δέκα καρέ πίσω</translation>
    </message>
    <message>
        <source>Ten frames forward</source>
        <translation>Δέκα καρέ μπροστά</translation>
    </message>
    <message>
        <source>&amp;First frame</source>
        <translation>Π&amp;ρώτο καρέ</translation>
    </message>
    <message>
        <source>&amp;Last frame</source>
        <translation>&amp;Τελευταίο καρέ</translation>
    </message>
    <message>
        <source>&amp;Go to frame...</source>
        <translation>&amp;Μετάβαση σε καρέ...</translation>
    </message>
    <message>
        <source>Pla&amp;y</source>
        <translation>&amp;Αναπαραγωγή</translation>
    </message>
    <message>
        <source>Next &amp;bad joint</source>
        <translation>Επόμενη προ&amp;βληματική άρθρωση</translation>
    </message>
    <message>
        <source>Error above the threshold, an outlier, or no 3D point</source>
        <translation>Σφάλμα πάνω από το όριο, ακραία τιμή ή χωρίς σημείο 3D</translation>
    </message>
    <message>
        <source>Previous b&amp;ad joint</source>
        <translation>Προηγούμενη προβ&amp;ληματική άρθρωση</translation>
    </message>
    <message>
        <source>Next &amp;unlabelled frame</source>
        <translation>Επόμενο &amp;ημιτελές καρέ</translation>
    </message>
    <message>
        <source>The next frame in which a joint is not done</source>
        <translation>Το επόμενο καρέ στο οποίο κάποια άρθρωση δεν είναι έτοιμη</translation>
    </message>
    <message>
        <source>Previous unlab&amp;elled frame</source>
        <translation>Προηγούμενο ημ&amp;ιτελές καρέ</translation>
    </message>
    <message>
        <source>Next annotated frame</source>
        <translation>Επόμενο επισημειωμένο καρέ</translation>
    </message>
    <message>
        <source>Previous annotated frame</source>
        <translation>Προηγούμενο επισημειωμένο καρέ</translation>
    </message>
    <message>
        <source>Next &amp;test frame</source>
        <translation>Επόμενο καρέ &amp;δοκιμής</translation>
    </message>
    <message>
        <source>The frames that the benchmark draws from this sequence</source>
        <translation>Τα καρέ που επιλέγει η συγκριτική δοκιμή από αυτή την ακολουθία</translation>
    </message>
    <message>
        <source>Previous test frame</source>
        <translation>Προηγούμενο καρέ δοκιμής</translation>
    </message>
    <message>
        <source>Last e&amp;dited frame</source>
        <translation>Τελευταίο επε&amp;ξεργασμένο καρέ</translation>
    </message>
    <message>
        <source>Error &amp;threshold...</source>
        <translation>Όριο &amp;σφάλματος...</translation>
    </message>
    <message>
        <source>Joints with a larger error count as bad</source>
        <translation>Αρθρώσεις με μεγαλύτερο σφάλμα θεωρούνται προβληματικές</translation>
    </message>
    <message>
        <source>&amp;Fit the current frame</source>
        <translation>&amp;Προσαρμογή στο τρέχον καρέ</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Διακοπή</translation>
    </message>
    <message>
        <source>Show the fit &amp;panel</source>
        <translation>&amp;Εμφάνιση πίνακα προσαρμογής</translation>
    </message>
    <message>
        <source>&amp;Previous iteration</source>
        <translation>&amp;Προηγούμενη επανάληψη</translation>
    </message>
    <message>
        <source>Shows the poses as they were before</source>
        <translation>Δείχνει τις πόζες όπως ήταν πριν</translation>
    </message>
    <message>
        <source>&amp;Next iteration</source>
        <translation>&amp;Επόμενη επανάληψη</translation>
    </message>
    <message>
        <source>&amp;Result of the fit</source>
        <translation>&amp;Αποτέλεσμα της προσαρμογής</translation>
    </message>
    <message>
        <source>&amp;Shortcuts</source>
        <translation>&amp;Συντομεύσεις</translation>
    </message>
    <message>
        <source>&amp;Four hints</source>
        <translation>&amp;Τέσσερις συμβουλές</translation>
    </message>
    <message>
        <source>&amp;About Handlens</source>
        <translation>Σ&amp;χετικά με το Handlens</translation>
    </message>
    <message>
        <source>A random tenth of your finished joints, your first marks hidden; once more to end the round</source>
        <translation>Ένα τυχαίο δέκατο των έτοιμων αρθρώσεών σας, με τα πρώτα σημάδια κρυμμένα· ξανά για να τελειώσει ο γύρος</translation>
    </message>
    <message>
        <source>With the chosen methods, from the pose of some frames before</source>
        <translation>Με τις επιλεγμένες μεθόδους, από την πόζα μερικών καρέ πριν</translation>
    </message>
    <message>
        <source>&amp;Raters</source>
        <translation>Α&amp;ξιολογητές</translation>
    </message>
    <message>
        <source>One &amp;view</source>
        <translation>Μία ό&amp;ψη</translation>
    </message>
    <message>
        <source>Mar&amp;ks</source>
        <translation>Σ&amp;ημάδια</translation>
    </message>
    <message>
        <source>&amp;Mesh</source>
        <translation>&amp;Πλέγμα</translation>
    </message>
    <message>
        <source>3D s&amp;cene</source>
        <translation>Τρισδιάστατη σ&amp;κηνή</translation>
    </message>
    <message>
        <source>&amp;Joint and view</source>
        <translation>&amp;Άρθρωση και όψη</translation>
    </message>
    <message>
        <source>&amp;Nudge</source>
        <translation>&amp;Μικρομετακίνηση</translation>
    </message>
    <message>
        <source>Li&amp;st of joints</source>
        <translation>&amp;Λίστα αρθρώσεων</translation>
    </message>
    <message>
        <source>Make a &amp;new dataset...</source>
        <translation>&amp;Νέο σύνολο δεδομένων...</translation>
    </message>
    <message>
        <source>Of a calibration and videos or folders of images</source>
        <translation>Από βαθμονόμηση και βίντεο ή φακέλους εικόνων</translation>
    </message>
    <message>
        <source>&amp;Preferences...</source>
        <translation>&amp;Προτιμήσεις...</translation>
    </message>
    <message>
        <source>Language, your name, keys, colours, memory</source>
        <translation>Γλώσσα, όνομα, πλήκτρα, χρώματα, μνήμη</translation>
    </message>
    <message>
        <source>Change the &amp;shortcuts...</source>
        <translation>Αλλαγή &amp;συντομεύσεων...</translation>
    </message>
    <message>
        <source>Fra&amp;me the hands</source>
        <translation>&amp;Εστίαση στα χέρια</translation>
    </message>
    <message>
        <source>Zooms every view to the hands, where they are known</source>
        <translation>Μεγεθύνει κάθε όψη στα χέρια, όπου είναι γνωστά</translation>
    </message>
    <message>
        <source>Other people&apos;s marks</source>
        <translation>Σημάδια άλλων</translation>
    </message>
    <message>
        <source>What others have marked in this sequence, muted; it cannot be changed here</source>
        <translation>Ό,τι σημείωσαν άλλοι σε αυτή την ακολουθία, αχνά· δεν αλλάζει εδώ</translation>
    </message>
    <message>
        <source>Which hand is &amp;left and which right</source>
        <translation>Ποιο χέρι είναι &amp;αριστερό και ποιο δεξί</translation>
    </message>
    <message>
        <source>L and R beside the hands, where they are known</source>
        <translation>L και R δίπλα στα χέρια, όπου είναι γνωστά</translation>
    </message>
    <message>
        <source>L&amp;eft hand</source>
        <translation>Αρι&amp;στερό χέρι</translation>
    </message>
    <message>
        <source>Marks and mesh of the left hand</source>
        <translation>Σημάδια και πλέγμα του αριστερού χεριού</translation>
    </message>
    <message>
        <source>Ri&amp;ght hand</source>
        <translation>&amp;Δεξί χέρι</translation>
    </message>
    <message>
        <source>Marks and mesh of the right hand</source>
        <translation>Σημάδια και πλέγμα του δεξιού χεριού</translation>
    </message>
    <message>
        <source>&amp;Toolbar</source>
        <translation>&amp;Γραμμή εργαλείων</translation>
    </message>
    <message>
        <source>&amp;Attach masks...</source>
        <translation>Σύνδεση &amp;μασκών...</translation>
    </message>
    <message>
        <source>Gives this sequence the silhouettes of a folder</source>
        <translation>Δίνει στην ακολουθία τις σιλουέτες ενός φακέλου</translation>
    </message>
    <message>
        <source>Next &amp;method in the 3D scene</source>
        <translation>Επόμενη &amp;μέθοδος στη σκηνή</translation>
    </message>
    <message>
        <source>&amp;Save the benchmark&apos;s results...</source>
        <translation>&amp;Αποθήκευση αποτελεσμάτων δοκιμής...</translation>
    </message>
    <message>
        <source>Tables, pairs and a report, in a folder</source>
        <translation>Πίνακες, ζεύγη και αναφορά, σε φάκελο</translation>
    </message>
    <message>
        <source>&amp;Open a benchmark&apos;s results...</source>
        <translation>Άν&amp;οιγμα αποτελεσμάτων δοκιμής...</translation>
    </message>
    <message>
        <source>A folder that was saved here or written by handlens-batch benchmark</source>
        <translation>Φάκελος που αποθηκεύτηκε εδώ ή γράφτηκε από το handlens-batch benchmark</translation>
    </message>
    <message>
        <source>&amp;Layers of the methods</source>
        <translation>&amp;Στρώσεις των μεθόδων</translation>
    </message>
    <message>
        <source>Writes the annotations of this sequence: of all raters where the format names them, else yours</source>
        <translation>Γράφει τις επισημειώσεις αυτής της ακολουθίας: όλων των αξιολογητών όπου η μορφή τους ονομάζει, αλλιώς τις δικές σας</translation>
    </message>
    <message>
        <source>Residual a&amp;rrows</source>
        <translation>&amp;Βέλη καταλοίπων</translation>
    </message>
    <message>
        <source>How far all clicks of each camera are off, place by place, ten times as long; green: refined</source>
        <translation>Πόσο αποκλίνουν όλα τα κλικ κάθε κάμερας, θέση προς θέση, με δεκαπλό μήκος· πράσινο: βελτιωμένη</translation>
    </message>
    <message>
        <source>How the &amp;cameras fit the clicks</source>
        <translation>Πώς ταιριάζουν οι &amp;κάμερες με τα κλικ</translation>
    </message>
    <message>
        <source>What all clicks of the dataset say of its calibration</source>
        <translation>Τι λένε όλα τα κλικ του συνόλου για τη βαθμονόμησή του</translation>
    </message>
    <message>
        <source>Re&amp;fine the calibration...</source>
        <translation>&amp;Βελτίωση της βαθμονόμησης...</translation>
    </message>
    <message>
        <source>Adjusts the cameras to all clicks and shows what changes; also to return to an earlier calibration</source>
        <translation>Προσαρμόζει τις κάμερες σε όλα τα κλικ και δείχνει τι αλλάζει· επίσης για επιστροφή σε παλαιότερη βαθμονόμηση</translation>
    </message>
    <message>
        <source>&amp;Use the refined calibration</source>
        <translation>&amp;Χρήση της βελτιωμένης βαθμονόμησης</translation>
    </message>
    <message>
        <source>As a new calibration file; the old one is kept</source>
        <translation>Ως νέο αρχείο βαθμονόμησης· το παλιό διατηρείται</translation>
    </message>
    <message>
        <source>Measure this person&apos;s &amp;hands...</source>
        <translation>Μέ&amp;τρηση των χεριών αυτού του ατόμου...</translation>
    </message>
    <message>
        <source>Bone lengths, scale and girth from annotated frames and masks, as a new dataset</source>
        <translation>Μήκη οστών, κλίμακα και πάχος από επισημειωμένα καρέ και μάσκες, ως νέο σύνολο δεδομένων</translation>
    </message>
    <message>
        <source>Measure the hands now</source>
        <translation>Μέτρηση των χεριών τώρα</translation>
    </message>
    <message>
        <source>With what is chosen in the window for measuring hands</source>
        <translation>Με ό,τι είναι επιλεγμένο στο παράθυρο μέτρησης χεριών</translation>
    </message>
    <message>
        <source>&amp;Contour</source>
        <translation>&amp;Περίγραμμα</translation>
    </message>
    <message>
        <source>The observed outline over the inspected views; its colour is its direction</source>
        <translation>Το παρατηρούμενο περίγραμμα πάνω στις όψεις της εξέτασης· το χρώμα δείχνει την κατεύθυνσή του</translation>
    </message>
    <message>
        <source>&amp;Rim</source>
        <translation>&amp;Χείλος</translation>
    </message>
    <message>
        <source>Rim points of the posed hands with their normals</source>
        <translation>Σημεία χείλους των χεριών στην πόζα τους, με τις καθέτους τους</translation>
    </message>
    <message>
        <source>&amp;Matches</source>
        <translation>&amp;Αντιστοιχίες</translation>
    </message>
    <message>
        <source>&amp;Field</source>
        <translation>Π&amp;εδίο</translation>
    </message>
    <message>
        <source>What a rim point of one direction costs at every pixel</source>
        <translation>Πόσο κοστίζει ένα σημείο χείλους μίας κατεύθυνσης σε κάθε πίξελ</translation>
    </message>
    <message>
        <source>&amp;Error</source>
        <translation>&amp;Σφάλμα</translation>
    </message>
    <message>
        <source>The mesh by its distance to the recorded pose</source>
        <translation>Το πλέγμα ανάλογα με την απόστασή του από την καταγεγραμμένη πόζα</translation>
    </message>
    <message>
        <source>Save this &amp;comparison...</source>
        <translation>Απο&amp;θήκευση αυτής της σύγκρισης...</translation>
    </message>
    <message>
        <source>Pair, methods, cameras, layers and iteration, as a small file that opens again</source>
        <translation>Ζεύγος, μέθοδοι, κάμερες, στρώσεις και επανάληψη, ως μικρό αρχείο που ανοίγει ξανά</translation>
    </message>
    <message>
        <source>Open a com&amp;parison...</source>
        <translation>Άνοιγμα σύ&amp;γκρισης...</translation>
    </message>
    <message>
        <source>R&amp;eview of proposals</source>
        <translation>Έλ&amp;εγχος προτάσεων</translation>
    </message>
    <message>
        <source>First &amp;pass...</source>
        <translation>Πρώτο &amp;πέρασμα...</translation>
    </message>
    <message>
        <source>Finds the joints of both hands in many frames without a click, as proposals to be checked</source>
        <translation>Βρίσκει τις αρθρώσεις και των δύο χεριών σε πολλά καρέ χωρίς κλικ, ως προτάσεις για έλεγχο</translation>
    </message>
    <message>
        <source>Start the first pass now</source>
        <translation>Έναρξη του πρώτου περάσματος τώρα</translation>
    </message>
    <message>
        <source>With what is chosen for the first pass</source>
        <translation>Με ό,τι είναι επιλεγμένο για το πρώτο πέρασμα</translation>
    </message>
    <message>
        <source>&amp;Accept the frame, go on to the next</source>
        <translation>&amp;Αποδοχή του καρέ, μετάβαση στο επόμενο</translation>
    </message>
    <message>
        <source>Accepts all proposed joints of the frame as they stand</source>
        <translation>Αποδέχεται όλες τις προτεινόμενες αρθρώσεις του καρέ ως έχουν</translation>
    </message>
    <message>
        <source>&amp;Correct the most doubtful joint</source>
        <translation>&amp;Διόρθωση της πιο αμφίβολης άρθρωσης</translation>
    </message>
    <message>
        <source>Selects it: click it in two views, then accept the frame</source>
        <translation>Την επιλέγει: κάντε κλικ σε αυτήν σε δύο προβολές και μετά αποδεχτείτε το καρέ</translation>
    </message>
    <message>
        <source>&amp;Next frame to review</source>
        <translation>&amp;Επόμενο καρέ για έλεγχο</translation>
    </message>
    <message>
        <source>Frames whose look teaches most come first</source>
        <translation>Πρώτα έρχονται τα καρέ με τον πιο χρήσιμο έλεγχο</translation>
    </message>
    <message>
        <source>&amp;Show the review queue</source>
        <translation>Ε&amp;μφάνιση της ουράς ελέγχου</translation>
    </message>
    <message>
        <source>Silhouettes...</source>
        <translation>Σιλουέτες...</translation>
    </message>
    <message>
        <source>Finds the hands&apos; silhouettes in the pictures, to be looked at, touched up and kept</source>
        <translation>Βρίσκει τις σιλουέτες των χεριών στις εικόνες, για έλεγχο, διόρθωση και φύλαξη</translation>
    </message>
    <message>
        <source>Make the silhouettes now</source>
        <translation>Δημιουργία των σιλουετών τώρα</translation>
    </message>
    <message>
        <source>Of the frames that are chosen in the window for silhouettes</source>
        <translation>Των καρέ που είναι επιλεγμένα στο παράθυρο για σιλουέτες</translation>
    </message>
    <message>
        <source>Brush for silhouettes</source>
        <translation>Πινέλο για σιλουέτες</translation>
    </message>
    <message>
        <source>Left button adds, right button takes away, Ctrl and the wheel change its size</source>
        <translation>Το αριστερό πλήκτρο προσθέτει, το δεξί αφαιρεί, το Ctrl και ο τροχός αλλάζουν το μέγεθός του</translation>
    </message>
    <message>
        <source>Larger brush</source>
        <translation>Μεγαλύτερο πινέλο</translation>
    </message>
    <message>
        <source>Of the brush for silhouettes</source>
        <translation>Του πινέλου για σιλουέτες</translation>
    </message>
    <message>
        <source>Smaller brush</source>
        <translation>Μικρότερο πινέλο</translation>
    </message>
    <message>
        <source>C&amp;omparison</source>
        <translation>Σύ&amp;γκριση</translation>
    </message>
    <message>
        <source>Col&amp;umns of the comparison</source>
        <translation>Στή&amp;λες της σύγκρισης</translation>
    </message>
    <message>
        <source>&amp;Difference</source>
        <translation>&amp;Διαφορά</translation>
    </message>
    <message>
        <source>&amp;Uncertainty</source>
        <translation>Α&amp;βεβαιότητα</translation>
    </message>
    <message>
        <source>Where the joints of a result lie with 95 % probability, as the fit judged it</source>
        <translation>Πού βρίσκονται οι αρθρώσεις ενός αποτελέσματος με πιθανότητα 95 %, όπως το έκρινε η προσαρμογή</translation>
    </message>
    <message>
        <source>Add the &amp;start</source>
        <translation>Προσθήκη &amp;αρχικής πόζας</translation>
    </message>
    <message>
        <source>The pose that every method began with, as a column</source>
        <translation>Η πόζα από την οποία ξεκίνησε κάθε μέθοδος, ως στήλη</translation>
    </message>
    <message>
        <source>Add the &amp;truth</source>
        <translation>Προσθήκη &amp;πραγματικής πόζας</translation>
    </message>
    <message>
        <source>The recorded pose, as a column</source>
        <translation>Η καταγεγραμμένη πόζα, ως στήλη</translation>
    </message>
    <message>
        <source>Add a tracker&apos;s &amp;estimates...</source>
        <translation>Προσθήκη &amp;εκτιμήσεων ιχνηλάτη...</translation>
    </message>
    <message>
        <source>A file of joints per frame pair, as handlens-batch benchmark takes it</source>
        <translation>Αρχείο αρθρώσεων ανά ζεύγος καρέ, όπως το δέχεται το handlens-batch benchmark</translation>
    </message>
    <message>
        <source>&amp;Remove the column</source>
        <translation>Αφαί&amp;ρεση στήλης</translation>
    </message>
    <message>
        <source>&amp;Previous column</source>
        <translation>Προηγούμενη στή&amp;λη</translation>
    </message>
    <message>
        <source>What the settings and the wipe are about</source>
        <translation>Αυτή που αφορούν οι ρυθμίσεις και η σάρωση</translation>
    </message>
    <message>
        <source>&amp;Next column</source>
        <translation>Επόμενη &amp;στήλη</translation>
    </message>
    <message>
        <source>Move the column to the &amp;left</source>
        <translation>&amp;Μετακίνηση στήλης αριστερά</translation>
    </message>
    <message>
        <source>Move the column to the ri&amp;ght</source>
        <translation>Μετακίνηση στήλης &amp;δεξιά</translation>
    </message>
    <message>
        <source>&amp;Hide or show the hands in this view</source>
        <translation>Απόκρυ&amp;ψη ή εμφάνιση χεριών στην προβολή</translation>
    </message>
    <message>
        <source>The column in the current view</source>
        <translation>Η στήλη στην τρέχουσα προβολή</translation>
    </message>
    <message>
        <source>&amp;Wipe to the next column</source>
        <translation>Σάρ&amp;ωση προς την επόμενη στήλη</translation>
    </message>
    <message>
        <source>The next column lies over this one, behind a line that can be dragged</source>
        <translation>Η επόμενη στήλη βρίσκεται πάνω από αυτήν, πίσω από μια γραμμή που σύρεται</translation>
    </message>
    <message>
        <source>Line of the wipe to the left</source>
        <translation>Γραμμή σάρωσης αριστερά</translation>
    </message>
    <message>
        <source>Line of the wipe to the right</source>
        <translation>Γραμμή σάρωσης δεξιά</translation>
    </message>
    <message>
        <source>&amp;Blink with the next column</source>
        <translation>Εναλλα&amp;γή με την επόμενη στήλη</translation>
    </message>
    <message>
        <source>Shows this column and the next one by turns</source>
        <translation>Δείχνει εναλλάξ αυτή τη στήλη και την επόμενη</translation>
    </message>
    <message>
        <source>What &amp;if...</source>
        <translation>&amp;Τι αν...</translation>
    </message>
    <message>
        <source>Settings of the column&apos;s method, cameras and noise: drag one, and the methods run again</source>
        <translation>Ρυθμίσεις της μεθόδου της στήλης, κάμερες και θόρυβος: σύρετε μία και οι μέθοδοι εκτελούνται ξανά</translation>
    </message>
    <message>
        <source>&amp;Use these settings</source>
        <translation>&amp;Χρήση αυτών των ρυθμίσεων</translation>
    </message>
    <message>
        <source>Gives the column what was tried under What if</source>
        <translation>Δίνει στη στήλη ό,τι δοκιμάστηκε στο «Τι αν»</translation>
    </message>
    <message>
        <source>&amp;Add these settings as a column</source>
        <translation>Προσθή&amp;κη των ρυθμίσεων ως στήλη</translation>
    </message>
    <message>
        <source>What was tried under What if, beside the column</source>
        <translation>Ό,τι δοκιμάστηκε στο «Τι αν», δίπλα στη στήλη</translation>
    </message>
    <message>
        <source>Bac&amp;k to what was fitted</source>
        <translation>Επιστρο&amp;φή σε ό,τι προσαρμόστηκε</translation>
    </message>
    <message>
        <source>Ends what was tried under What if</source>
        <translation>Τερματίζει ό,τι δοκιμάστηκε στο «Τι αν»</translation>
    </message>
    <message>
        <source>What does each &amp;camera add?</source>
        <translation>Τι προσφέρει κά&amp;θε κάμερα;</translation>
    </message>
    <message>
        <source>Fits without each camera in turn</source>
        <translation>Προσαρμογή χωρίς κάθε κάμερα με τη σειρά</translation>
    </message>
    <message>
        <source>Save as a &amp;picture...</source>
        <translation>Αποθήκευση ως &amp;εικόνα...</translation>
    </message>
    <message>
        <source>Views, titles and curves on white paper: PNG, or SVG or PDF with lines and marks as vectors</source>
        <translation>Προβολές, τίτλοι και καμπύλες σε λευκό χαρτί: PNG, ή SVG ή PDF με γραμμές και σημάδια ως διανύσματα</translation>
    </message>
    <message>
        <source>Save the iterations as a &amp;film...</source>
        <translation>Αποθήκευση επαναλήψεων ως &amp;βίντεο...</translation>
    </message>
    <message>
        <source>The comparison from the start pose to the last iteration</source>
        <translation>Η σύγκριση από την αρχική πόζα ως την τελευταία επανάληψη</translation>
    </message>
    <message>
        <source>&amp;Report of this comparison...</source>
        <translation>&amp;Αναφορά αυτής της σύγκρισης...</translation>
    </message>
    <message>
        <source>One page with pictures, tables, settings and the command that makes it again</source>
        <translation>Μία σελίδα με εικόνες, πίνακες, ρυθμίσεις και την εντολή που την ξαναφτιάχνει</translation>
    </message>
    <message>
        <source>&amp;Run or stop the benchmark</source>
        <translation>&amp;Εκτέλεση ή διακοπή της δοκιμής</translation>
    </message>
    <message>
        <source>Fil&amp;ter the benchmark&apos;s pairs</source>
        <translation>&amp;Φίλτρο ζευγών της δοκιμής</translation>
    </message>
    <message>
        <source>By errors, differences of methods, sequences and frames, such as A-B&gt;1</source>
        <translation>Κατά σφάλματα, διαφορές μεθόδων, ακολουθίες και καρέ, όπως A-B&gt;1</translation>
    </message>
    <message>
        <source>Run the selected &amp;pairs</source>
        <translation>Εκτέλεση επιλεγμένων &amp;ζευγών</translation>
    </message>
    <message>
        <source>Adds what the ticked methods make of them to the results that are shown</source>
        <translation>Προσθέτει στα εμφανιζόμενα αποτελέσματα ό,τι βρίσκουν για αυτά οι επιλεγμένες μέθοδοι</translation>
    </message>
    <message>
        <source>From rim points to their contour points, by distance or finger; a dash pattern for every reason to refuse one</source>
        <translation>Από τα σημεία του χείλους στα σημεία του περιγράμματος, κατά απόσταση ή δάχτυλο· ένα μοτίβο γραμμής για κάθε λόγο απόρριψης</translation>
    </message>
    <message>
        <source>Silhouettes: red is seen but not covered, blue is covered but not seen, a hatched forearm does not count</source>
        <translation>Σιλουέτες: κόκκινο φαίνεται αλλά δεν καλύπτεται, μπλε καλύπτεται αλλά δεν φαίνεται, διαγραμμισμένος πήχης δεν μετρά</translation>
    </message>
    <message>
        <source>Matches of the next finger</source>
        <translation>Αντιστοιχίες του επόμενου δαχτύλου</translation>
    </message>
    <message>
        <source>All matches by distance, all by finger, then those of one finger or the palm after the other</source>
        <translation>Όλες οι αντιστοιχίες κατά απόσταση, όλες κατά δάχτυλο, και μετά διαδοχικά ενός δαχτύλου ή της παλάμης</translation>
    </message>
    <message>
        <source>Sweep the setting</source>
        <translation>Σάρωση της ρύθμισης</translation>
    </message>
    <message>
        <source>Fits at a row of values of the setting that was changed last, and draws the error over it; once more stops</source>
        <translation>Προσαρμόζει για μια σειρά τιμών της ρύθμισης που άλλαξε τελευταία και σχεδιάζει το σφάλμα· ξανά για διακοπή</translation>
    </message>
</context>
<context>
    <name>app::CalibrationPage</name>
    <message>
        <source>as usual for its kind</source>
        <translation>η συνηθισμένη του είδους της</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>χιλιοστά</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>εκατοστά</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>μέτρα</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Βαθμονόμηση</translation>
    </message>
    <message>
        <source>The calibration</source>
        <translation>Η βαθμονόμηση</translation>
    </message>
    <message>
        <source>Unit of length</source>
        <translation>Μονάδα μήκους</translation>
    </message>
    <message>
        <source>Anipose, OpenCV, EasyMocap, JARVIS, MATLAB and others: the kind is recognised.</source>
        <translation>Anipose, OpenCV, EasyMocap, JARVIS, MATLAB και άλλα: το είδος αναγνωρίζεται.</translation>
    </message>
    <message>
        <source>Sizes, rotations and lenses make sense, and every camera sees where the others look.</source>
        <translation>Μεγέθη, στροφές και φακοί είναι λογικά και κάθε κάμερα βλέπει εκεί όπου κοιτούν οι άλλες.</translation>
    </message>
    <message numerus="yes">
        <source>Recognised as %1: %n camera(s).</source>
        <translation>
            <numerusform>Αναγνωρίστηκε ως %1: %n κάμερα.</numerusform>
            <numerusform>Αναγνωρίστηκε ως %1: %n κάμερες.</numerusform>
        </translation>
    </message>
    <message>
        <source>They stand about %1 mm from where they look.</source>
        <translation>Απέχουν περίπου %1 mm από εκεί όπου κοιτούν.</translation>
    </message>
    <message>
        <source>Choose the calibration of the cameras.</source>
        <translation>Επιλέξτε τη βαθμονόμηση των καμερών.</translation>
    </message>
    <message>
        <source>There is no such calibration file.</source>
        <translation>Δεν υπάρχει τέτοιο αρχείο βαθμονόμησης.</translation>
    </message>
    <message>
        <source>The calibration cannot be read.</source>
        <translation>Η βαθμονόμηση δεν μπορεί να διαβαστεί.</translation>
    </message>
    <message>
        <source>The calibration is being read...</source>
        <translation>Ανάγνωση της βαθμονόμησης...</translation>
    </message>
</context>
<context>
    <name>app::ComparisonReport</name>
    <message>
        <source>Method</source>
        <translation>Μέθοδος</translation>
    </message>
    <message>
        <source>Start, mm</source>
        <translation>Αρχή, mm</translation>
    </message>
    <message>
        <source>Shown, mm</source>
        <translation>Εμφαν., mm</translation>
    </message>
    <message>
        <source>Result, mm</source>
        <translation>Αποτέλεσμα, mm</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Επαναλ.</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Τέλος</translation>
    </message>
    <message>
        <source>Error by iteration</source>
        <translation>Σφάλμα ανά επανάληψη</translation>
    </message>
    <message>
        <source>Cost by iteration</source>
        <translation>Κόστος ανά επανάληψη</translation>
    </message>
    <message>
        <source>Joint, error in mm</source>
        <translation>Άρθρωση, σφάλμα σε mm</translation>
    </message>
    <message>
        <source>Option</source>
        <translation>Επιλογή</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Τιμή</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Προεπιλογή</translation>
    </message>
    <message>
        <source>To make this page again</source>
        <translation>Για να ξαναφτιαχτεί αυτή η σελίδα</translation>
    </message>
    <message>
        <source>The file %1 holds:</source>
        <translation>Το αρχείο %1 περιέχει:</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Πρβ.</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Καμπύλες</translation>
    </message>
    <message>
        <source>Error joint by joint</source>
        <translation>Σφάλμα ανά άρθρωση</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Ρυθμίσεις</translation>
    </message>
</context>
<context>
    <name>app::ExportWindow</name>
    <message>
        <source>Export annotations</source>
        <translation>Εξαγωγή σχολιασμών</translation>
    </message>
    <message>
        <source>&lt;b&gt;Holds&lt;/b&gt;</source>
        <translation>&lt;b&gt;Περιέχει&lt;/b&gt;</translation>
    </message>
    <message>
        <source>&lt;b&gt;Read by&lt;/b&gt;</source>
        <translation>&lt;b&gt;Διαβάζεται από&lt;/b&gt;</translation>
    </message>
    <message>
        <source>&lt;b&gt;Not in it&lt;/b&gt;</source>
        <translation>&lt;b&gt;Δεν περιέχει&lt;/b&gt;</translation>
    </message>
    <message>
        <source>&lt;b&gt;Written are&lt;/b&gt;</source>
        <translation>&lt;b&gt;Γράφονται&lt;/b&gt;</translation>
    </message>
    <message>
        <source>Choose where...</source>
        <translation>Επιλογή θέσης...</translation>
    </message>
    <message>
        <source>Your own annotations of this sequence</source>
        <translation>Οι δικοί σας σχολιασμοί αυτής της ακολουθίας</translation>
    </message>
    <message>
        <source>The annotations of all raters of this sequence, with their names</source>
        <translation>Οι σχολιασμοί όλων των αξιολογητών αυτής της ακολουθίας, με τα ονόματά τους</translation>
    </message>
</context>
<context>
    <name>app::FileActions</name>
    <message>
        <source>Handlens ground truth</source>
        <translation>Δεδομένα αναφοράς Handlens</translation>
    </message>
    <message>
        <source>Files of the method&apos;s authors</source>
        <translation>Αρχεία των δημιουργών της μεθόδου</translation>
    </message>
    <message>
        <source>COCO keypoints</source>
        <translation>Σημεία-κλειδιά COCO</translation>
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
        <translation>TRC, κίνηση δεικτών</translation>
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
        <translation>Πίνακας αρθρώσεων 3D</translation>
    </message>
    <message>
        <source>Table of marks</source>
        <translation>Πίνακας σημαδιών</translation>
    </message>
    <message>
        <source>%1 – a new folder (*)</source>
        <translation>%1 – νέος φάκελος (*)</translation>
    </message>
    <message>
        <source>Handlens and scripts of your own (JSON)</source>
        <translation>Handlens και δικά σας σενάρια (JSON)</translation>
    </message>
    <message>
        <source>Marks in whole pixels, a folder per camera and a text file per frame.</source>
        <translation>Σημάδια σε ακέραια εικονοστοιχεία, ένας φάκελος ανά κάμερα, ένα αρχείο κειμένου ανά καρέ.</translation>
    </message>
    <message>
        <source>The programs of the method&apos;s authors</source>
        <translation>Τα προγράμματα των δημιουργών της μεθόδου</translation>
    </message>
    <message>
        <source>Fractions of pixels, 3D joints, joints beyond the 14 of a hand; occluded and missing are both 0 0</source>
        <translation>Κλάσματα εικονοστοιχείων, αρθρώσεις 3D, αρθρώσεις πέρα από τις 14· καλυμμένα και απόντα είναι 0 0</translation>
    </message>
    <message>
        <source>Marks per picture and hand, each visible, occluded or missing.</source>
        <translation>Σημάδια ανά εικόνα και χέρι: ορατά, καλυμμένα ή απόντα.</translation>
    </message>
    <message>
        <source>MMPose, Detectron2, CVAT, FiftyOne and most trainers of networks (JSON)</source>
        <translation>MMPose, Detectron2, CVAT, FiftyOne και τα περισσότερα εργαλεία εκπαίδευσης (JSON)</translation>
    </message>
    <message>
        <source>3D joints, cameras, who clicked and who accepted</source>
        <translation>Αρθρώσεις 3D, κάμερες, ποιος έκανε κλικ και ποιος αποδέχτηκε</translation>
    </message>
    <message>
        <source>Marks as a table per camera with a row per frame.</source>
        <translation>Σημάδια ως πίνακας ανά κάμερα, μία γραμμή ανά καρέ.</translation>
    </message>
    <message>
        <source>Anipose and aniposelib (CSV)</source>
        <translation>Anipose και aniposelib (CSV)</translation>
    </message>
    <message>
        <source>3D joints and states: occluded marks look like visible ones</source>
        <translation>Αρθρώσεις 3D και καταστάσεις: τα καλυμμένα μοιάζουν ορατά</translation>
    </message>
    <message>
        <source>3D joints with error and number of cameras, a row per frame.</source>
        <translation>Αρθρώσεις 3D με σφάλμα και αριθμό καμερών, μία γραμμή ανά καρέ.</translation>
    </message>
    <message>
        <source>Anipose and what reads its results (CSV)</source>
        <translation>Anipose και όσα διαβάζουν τα αποτελέσματά του (CSV)</translation>
    </message>
    <message>
        <source>The marks themselves, uncertainties and cameras</source>
        <translation>Τα ίδια τα σημάδια, οι αβεβαιότητες και οι κάμερες</translation>
    </message>
    <message>
        <source>Marks as one CollectedData table per camera, a row per annotated frame.</source>
        <translation>Ένας πίνακας CollectedData ανά κάμερα, μία γραμμή ανά σχολιασμένο καρέ.</translation>
    </message>
    <message>
        <source>DeepLabCut, Lightning Pose, napari-deeplabcut (CSV)</source>
        <translation>DeepLabCut, Lightning Pose, napari-deeplabcut (CSV)</translation>
    </message>
    <message>
        <source>3D joints as moving markers, a row per frame of the sequence.</source>
        <translation>Αρθρώσεις 3D ως κινούμενοι δείκτες, μία γραμμή ανά καρέ.</translation>
    </message>
    <message>
        <source>OpenSim, Mokka, Visual3D and other programs for motion</source>
        <translation>OpenSim, Mokka, Visual3D και άλλα προγράμματα κίνησης</translation>
    </message>
    <message>
        <source>The marks themselves, uncertainties and cameras; it cannot be imported again</source>
        <translation>Τα ίδια τα σημάδια, οι αβεβαιότητες και οι κάμερες· δεν εισάγεται ξανά</translation>
    </message>
    <message>
        <source>3D joints of both hands in that dataset&apos;s order, and the cameras.</source>
        <translation>Αρθρώσεις 3D και των δύο χεριών στη σειρά εκείνου του συνόλου, και οι κάμερες.</translation>
    </message>
    <message>
        <source>Loaders written for InterHand2.6M (JSON)</source>
        <translation>Φορτωτές για το InterHand2.6M (JSON)</translation>
    </message>
    <message>
        <source>The marks themselves, uncertainties and lens distortion; it cannot be imported again</source>
        <translation>Τα ίδια τα σημάδια, οι αβεβαιότητες και η παραμόρφωση φακού· δεν εισάγεται ξανά</translation>
    </message>
    <message>
        <source>21 joints of a hand in metres and the cameras, a file per frame and hand.</source>
        <translation>21 αρθρώσεις χεριού σε μέτρα και οι κάμερες, ένα αρχείο ανά καρέ και χέρι.</translation>
    </message>
    <message>
        <source>Loaders written for FreiHAND or HanCo (JSON)</source>
        <translation>Φορτωτές για το FreiHAND ή το HanCo (JSON)</translation>
    </message>
    <message>
        <source>Spreadsheets, R, pandas (CSV)</source>
        <translation>Λογιστικά φύλλα, R, pandas (CSV)</translation>
    </message>
    <message>
        <source>The marks themselves and the cameras; it cannot be imported again</source>
        <translation>Τα ίδια τα σημάδια και οι κάμερες· δεν εισάγεται ξανά</translation>
    </message>
    <message>
        <source>Spreadsheets, R, pandas, and Handlens (CSV)</source>
        <translation>Λογιστικά φύλλα, R, pandas και Handlens (CSV)</translation>
    </message>
    <message>
        <source>3D joints and the cameras</source>
        <translation>Αρθρώσεις 3D και οι κάμερες</translation>
    </message>
    <message>
        <source>Only proposals and the list of undo steps</source>
        <translation>Μόνο οι προτάσεις και η λίστα των βημάτων αναίρεσης</translation>
    </message>
    <message>
        <source>SLEAP</source>
        <translation>SLEAP</translation>
    </message>
    <message>
        <source>Labels and guesses of a project (.slp) or of an analysis export (.h5).</source>
        <translation>Σημάνσεις και προβλέψεις ενός έργου (.slp) ή μιας εξαγωγής ανάλυσης (.h5).</translation>
    </message>
    <message>
        <source>SLEAP and sleap-io (HDF5)</source>
        <translation>SLEAP και sleap-io (HDF5)</translation>
    </message>
    <message>
        <source>Everything: it can be imported, not exported</source>
        <translation>Όλα: εισάγεται, αλλά δεν εξάγεται</translation>
    </message>
    <message>
        <source>Label3D, DANNCE</source>
        <translation>Label3D, DANNCE</translation>
    </message>
    <message>
        <source>Clicks and 3D points of a session, or the labels exported for DANNCE.</source>
        <translation>Κλικ και σημεία 3D μιας συνεδρίας, ή οι σημάνσεις που εξήχθησαν για το DANNCE.</translation>
    </message>
    <message>
        <source>Label3D and DANNCE (MATLAB)</source>
        <translation>Label3D και DANNCE (MATLAB)</translation>
    </message>
    <message>
        <source>3D joints with their uncertainty, every mark of every rater with its state and error, and the cameras.</source>
        <translation>Αρθρώσεις 3D με αβεβαιότητα, κάθε σημάδι κάθε αξιολογητή με κατάσταση και σφάλμα, και οι κάμερες.</translation>
    </message>
    <message>
        <source>A row per 3D joint of every rater: millimetres, uncertainty, error, state.</source>
        <translation>Μία γραμμή ανά άρθρωση 3D κάθε αξιολογητή: χιλιοστά, αβεβαιότητα, σφάλμα, κατάσταση.</translation>
    </message>
    <message>
        <source>A row per mark of every rater: pixel, state, how it was placed; proposals, too.</source>
        <translation>Μία γραμμή ανά σημάδι κάθε αξιολογητή: εικονοστοιχείο, κατάσταση, τρόπος τοποθέτησης· και προτάσεις.</translation>
    </message>
</context>
<context>
    <name>app::FootagePage</name>
    <message>
        <source>The videos of the cameras, or folders of numbered images. Drop them here, or a folder with all of them. Nothing is copied: the footage stays where it is.</source>
        <translation>Τα βίντεο των καμερών ή φάκελοι αριθμημένων εικόνων. Σύρετέ τα εδώ, ή έναν φάκελο με όλα. Δεν αντιγράφεται τίποτα: το υλικό μένει στη θέση του.</translation>
    </message>
    <message>
        <source>Video or image folder</source>
        <translation>Βίντεο ή φάκελος εικόνων</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Κάμερα</translation>
    </message>
    <message>
        <source>Starts at frame</source>
        <translation>Αρχικό καρέ</translation>
    </message>
    <message>
        <source>The frame of this footage that was recorded when the sequence begins.</source>
        <translation>Το καρέ αυτού του υλικού που καταγράφηκε όταν αρχίζει η ακολουθία.</translation>
    </message>
    <message>
        <source>Name of the sequence</source>
        <translation>Όνομα της ακολουθίας</translation>
    </message>
    <message>
        <source>Add videos...</source>
        <translation>Προσθήκη βίντεο...</translation>
    </message>
    <message>
        <source>Add a folder...</source>
        <translation>Προσθήκη φακέλου...</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Αφαίρεση</translation>
    </message>
    <message>
        <source>A folder of numbered images, or of videos</source>
        <translation>Φάκελος αριθμημένων εικόνων ή βίντεο</translation>
    </message>
    <message>
        <source>Videos of the cameras</source>
        <translation>Βίντεο των καμερών</translation>
    </message>
    <message>
        <source>its first</source>
        <translation>το πρώτο του</translation>
    </message>
    <message>
        <source>not used</source>
        <translation>δεν χρησιμοποιείται</translation>
    </message>
    <message>
        <source>Add the videos or image folders of the cameras.</source>
        <translation>Προσθέστε τα βίντεο ή τους φακέλους εικόνων των καμερών.</translation>
    </message>
    <message>
        <source>Two pieces of footage are given to %1.</source>
        <translation>Στην %1 δόθηκαν δύο υλικά.</translation>
    </message>
    <message>
        <source>Choose the camera of each piece of footage.</source>
        <translation>Επιλέξτε την κάμερα κάθε υλικού.</translation>
    </message>
    <message>
        <source>Give the sequence a name.</source>
        <translation>Δώστε όνομα στην ακολουθία.</translation>
    </message>
</context>
<context>
    <name>app::HandsPage</name>
    <message>
        <source>The demo&apos;s hands</source>
        <translation>Τα χέρια της επίδειξης</translation>
    </message>
    <message>
        <source>A left and a right hand of usual size. They can be measured to a person&apos;s own later, from clicked joints.</source>
        <translation>Ένα αριστερό και ένα δεξί χέρι συνηθισμένου μεγέθους. Αργότερα μπορούν να μετρηθούν τα χέρια ενός ατόμου, από αρθρώσεις με κλικ.</translation>
    </message>
    <message>
        <source>The hands of another dataset</source>
        <translation>Τα χέρια άλλου συνόλου δεδομένων</translation>
    </message>
    <message>
        <source>Such as this person&apos;s, measured before, or imported ones.</source>
        <translation>Όπως του ίδιου ατόμου, από παλαιότερη μέτρηση, ή εισαγμένα.</translation>
    </message>
    <message>
        <source>The folder of a dataset</source>
        <translation>Ο φάκελος ενός συνόλου δεδομένων</translation>
    </message>
    <message>
        <source>No hand model</source>
        <translation>Χωρίς μοντέλο χεριού</translation>
    </message>
    <message>
        <source>Joints can be clicked, of hands or of anything else. Nothing is fitted to silhouettes.</source>
        <translation>Μπορείτε να κάνετε κλικ σε αρθρώσεις, χεριών ή οτιδήποτε άλλου. Τίποτα δεν προσαρμόζεται σε σιλουέτες.</translation>
    </message>
    <message>
        <source>Choose the dataset whose hands are taken.</source>
        <translation>Επιλέξτε το σύνολο δεδομένων με τα χέρια.</translation>
    </message>
    <message>
        <source>That folder is not a dataset: it has no dataset.json.</source>
        <translation>Αυτός ο φάκελος δεν είναι σύνολο δεδομένων: δεν έχει dataset.json.</translation>
    </message>
</context>
<context>
    <name>app::MainWindow</name>
    <message>
        <source>No annotated frame before this one.</source>
        <translation>Κανένα επισημειωμένο καρέ πριν από αυτό.</translation>
    </message>
    <message>
        <source>Frame %1 has no 3D joint that is missing here.</source>
        <translation>Το καρέ %1 δεν έχει άρθρωση 3D που να λείπει εδώ.</translation>
    </message>
    <message>
        <source>Annotate a frame before and a frame after this one first.</source>
        <translation>Επισημειώστε πρώτα ένα καρέ πριν και ένα μετά από αυτό.</translation>
    </message>
    <message>
        <source>No joint has a 3D point in both frame %1 and frame %2.</source>
        <translation>Καμία άρθρωση δεν έχει σημείο 3D και στο καρέ %1 και στο καρέ %2.</translation>
    </message>
    <message>
        <source>There are no marks of yours there.</source>
        <translation>Δεν υπάρχουν δικά σας σημάδια εκεί.</translation>
    </message>
    <message>
        <source>Delete a range of frames</source>
        <translation>Διαγραφή σε εύρος καρέ</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Διαγραφή</translation>
    </message>
    <message>
        <source>The hand model has nothing to add: every joint of the list that it knows has a mark.</source>
        <translation>Το μοντέλο χεριού δεν έχει κάτι να προσθέσει: κάθε άρθρωση της λίστας που γνωρίζει έχει ήδη σημάδι.</translation>
    </message>
    <message>
        <source>Finish some joints first: there is nothing to mark again.</source>
        <translation>Ολοκληρώστε πρώτα μερικές αρθρώσεις: δεν υπάρχει κάτι για νέα σήμανση.</translation>
    </message>
    <message>
        <source>Every joint of the round is marked: end it to see how you did.</source>
        <translation>Όλες οι αρθρώσεις του γύρου σημάνθηκαν: τερματίστε τον για να δείτε το αποτέλεσμα.</translation>
    </message>
    <message>
        <source>No repeat round is under way.</source>
        <translation>Δεν βρίσκεται σε εξέλιξη γύρος επανάληψης.</translation>
    </message>
    <message>
        <source>Export annotations</source>
        <translation>Εξαγωγή επισημειώσεων</translation>
    </message>
    <message>
        <source>Import annotations</source>
        <translation>Εισαγωγή επισημειώσεων</translation>
    </message>
    <message>
        <source>Report on the annotations</source>
        <translation>Αναφορά για τις επισημειώσεις</translation>
    </message>
    <message>
        <source>Pages (*.html)</source>
        <translation>Σελίδες (*.html)</translation>
    </message>
    <message>
        <source>Save the views as a picture</source>
        <translation>Αποθήκευση προβολών ως εικόνα</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Εικόνες (*.png)</translation>
    </message>
    <message>
        <source>%1 could not be written.</source>
        <translation>Δεν ήταν δυνατή η εγγραφή του %1.</translation>
    </message>
    <message>
        <source>Joints from a file</source>
        <translation>Αρθρώσεις από αρχείο</translation>
    </message>
    <message>
        <source>Lists of joints (*.json)</source>
        <translation>Λίστες αρθρώσεων (*.json)</translation>
    </message>
    <message>
        <source>Open a dataset to begin.</source>
        <translation>Ανοίξτε ένα σύνολο δεδομένων για να ξεκινήσετε.</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>Άνοιγμα: %1</translation>
    </message>
    <message>
        <source>This could not be opened. %1</source>
        <translation>Δεν ήταν δυνατό το άνοιγμα. %1</translation>
    </message>
    <message>
        <source>Not saved yet, but nothing is lost: it is tried again every few seconds. %1</source>
        <translation>Δεν έχει αποθηκευτεί ακόμα, αλλά τίποτα δεν χάθηκε: γίνεται νέα προσπάθεια κάθε λίγα δευτερόλεπτα. %1</translation>
    </message>
    <message>
        <source>Read-only: %1. You can look and export; edits are not possible.</source>
        <translation>Μόνο για ανάγνωση: %1. Μπορείτε να βλέπετε και να εξάγετε, όχι να επεξεργάζεστε.</translation>
    </message>
    <message>
        <source>Exported to %1</source>
        <translation>Έγινε εξαγωγή στο %1</translation>
    </message>
    <message>
        <source>Report written to %1</source>
        <translation>Η αναφορά γράφτηκε στο %1</translation>
    </message>
    <message numerus="yes">
        <source>%n mark(s) imported from %1</source>
        <translation>
            <numerusform>Έγινε εισαγωγή %n σημαδιού από το %1</numerusform>
            <numerusform>Έγινε εισαγωγή %n σημαδιών από το %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Fitting</source>
        <translation>Προσαρμογή</translation>
    </message>
    <message>
        <source>Fitting: %1</source>
        <translation>Προσαρμογή: %1</translation>
    </message>
    <message>
        <source>Benchmark</source>
        <translation>Συγκριτική δοκιμή</translation>
    </message>
    <message>
        <source>Benchmark: %1</source>
        <translation>Συγκριτική δοκιμή: %1</translation>
    </message>
    <message>
        <source>Open a dataset</source>
        <translation>Άνοιγμα συνόλου δεδομένων</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Πρόσ&amp;φατα</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>Κανένα ακόμα</translation>
    </message>
    <message>
        <source>Your name</source>
        <translation>Το όνομά σας</translation>
    </message>
    <message>
        <source>Your marks are kept under this name:</source>
        <translation>Τα σημάδια σας φυλάσσονται με αυτό το όνομα:</translation>
    </message>
    <message>
        <source>About Handlens</source>
        <translation>Σχετικά με το Handlens</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Handlens %1&lt;/h3&gt;&lt;p&gt;3D hand ground truth in calibrated multi-camera footage.&lt;/p&gt;&lt;p&gt;MIT licence. Built with Qt, VTK, Eigen, OpenCV, SQLite and others.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Handlens %1&lt;/h3&gt;&lt;p&gt;Δεδομένα αναφοράς 3D για χέρια σε βαθμονομημένα βίντεο πολλών καμερών.&lt;/p&gt;&lt;p&gt;Άδεια MIT. Βασίζεται σε Qt, VTK, Eigen, OpenCV, SQLite και άλλα.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&amp;Undo %1</source>
        <translation>&amp;Αναίρεση: %1</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Αναίρεση</translation>
    </message>
    <message>
        <source>&amp;Redo %1</source>
        <translation>Α&amp;κύρωση αναίρεσης: %1</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>Α&amp;κύρωση αναίρεσης</translation>
    </message>
    <message>
        <source>No bad joint in that direction.</source>
        <translation>Καμία προβληματική άρθρωση προς αυτή την κατεύθυνση.</translation>
    </message>
    <message>
        <source>Every frame in that direction is done.</source>
        <translation>Όλα τα καρέ προς αυτή την κατεύθυνση είναι έτοιμα.</translation>
    </message>
    <message>
        <source>No frame with marks in that direction.</source>
        <translation>Κανένα καρέ με σημάδια προς αυτή την κατεύθυνση.</translation>
    </message>
    <message>
        <source>No test frame in that direction, as the benchmark is set.</source>
        <translation>Κανένα καρέ δοκιμής προς αυτή την κατεύθυνση, με τις τρέχουσες ρυθμίσεις της συγκριτικής δοκιμής.</translation>
    </message>
    <message>
        <source>Nothing was edited yet.</source>
        <translation>Δεν έχει γίνει ακόμα καμία επεξεργασία.</translation>
    </message>
    <message>
        <source>Your last edits are not saved yet. Make room or give permission where they are kept, or export them elsewhere; closing once more gives them up.</source>
        <translation>Οι τελευταίες αλλαγές σας δεν έχουν αποθηκευτεί ακόμη. Ελευθερώστε χώρο ή δώστε δικαιώματα εκεί όπου φυλάσσονται ή εξαγάγετέ τες αλλού· δεύτερο κλείσιμο τις εγκαταλείπει.</translation>
    </message>
    <message>
        <source>The hand model misses the marked joints by %1 mm: are units, joints and hands right? Nothing is proposed.</source>
        <translation>Το μοντέλο χεριού αστοχεί τις σημειωμένες αρθρώσεις κατά %1 mm: είναι σωστά οι μονάδες, οι αρθρώσεις και τα χέρια; Δεν προτείνεται τίποτα.</translation>
    </message>
    <message numerus="yes">
        <source>The hand model meets %n marked joint(s) within %1 mm.</source>
        <translation>
            <numerusform>Το μοντέλο χεριού συμφωνεί με %n σημειωμένη άρθρωση έως %1 mm.</numerusform>
            <numerusform>Το μοντέλο χεριού συμφωνεί με %n σημειωμένες αρθρώσεις έως %1 mm.</numerusform>
        </translation>
    </message>
    <message>
        <source>report</source>
        <translation>αναφορά</translation>
    </message>
    <message>
        <source>Where are the videos and images now? Folders below are looked through, too.</source>
        <translation>Πού βρίσκονται τώρα τα βίντεο και οι εικόνες; Ελέγχονται και οι υποφάκελοι.</translation>
    </message>
    <message>
        <source>Nothing of the missing footage lies in that folder.</source>
        <translation>Σε αυτόν τον φάκελο δεν υπάρχει τίποτα από το υλικό που λείπει.</translation>
    </message>
    <message numerus="yes">
        <source>%n piece(s) of footage found; the dataset keeps the new places.</source>
        <translation>
            <numerusform>Βρέθηκε %n υλικό· το σύνολο θυμάται τη νέα θέση.</numerusform>
            <numerusform>Βρέθηκαν %n υλικά· το σύνολο θυμάται τις νέες θέσεις.</numerusform>
        </translation>
    </message>
    <message>
        <source>Looking for footage</source>
        <translation>Αναζήτηση υλικού</translation>
    </message>
    <message>
        <source>Saved to %1</source>
        <translation>Αποθηκεύτηκε στο %1</translation>
    </message>
    <message numerus="yes">
        <source>and %n more: see handlens-batch check</source>
        <translation>
            <numerusform>και %n ακόμη: δείτε handlens-batch check</numerusform>
            <numerusform>και %n ακόμη: δείτε handlens-batch check</numerusform>
        </translation>
    </message>
    <message>
        <source>About the footage: %1</source>
        <translation>Για το υλικό: %1</translation>
    </message>
    <message>
        <source>Toolbar</source>
        <translation>Γραμμή εργαλείων</translation>
    </message>
    <message>
        <source>Attach a folder of masks</source>
        <translation>Σύνδεση φακέλου μασκών</translation>
    </message>
    <message>
        <source>The name that your marks are kept under (%1)</source>
        <translation>Το όνομα με το οποίο φυλάσσονται τα σημάδια σας (%1)</translation>
    </message>
    <message>
        <source>Your name: %1</source>
        <translation>Το όνομά σας: %1</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Εμφάνιση</translation>
    </message>
    <message numerus="yes">
        <source>%n mark(s) of %1</source>
        <translation>
            <numerusform>%n σημάδι του %1</numerusform>
            <numerusform>%n σημάδια του %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n note(s)</source>
        <translation>
            <numerusform>%n σημείωση</numerusform>
            <numerusform>%n σημειώσεις</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 σε %2</translation>
    </message>
    <message>
        <source> and </source>
        <translation> και </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s)</source>
        <translation>
            <numerusform>%n καρέ</numerusform>
            <numerusform>%n καρέ</numerusform>
        </translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Ακύρωση</translation>
    </message>
    <message>
        <source>%1 would replace %2.</source>
        <translation>Το %1 θα αντικαθιστούσε %2.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Αντικατάσταση</translation>
    </message>
    <message>
        <source>Keep what is there</source>
        <translation>Διατήρηση των υπαρχόντων</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>Εισαγωγή %1</translation>
    </message>
    <message>
        <source>%1 has labels of %2, but none of this sequence. Import them all the same?</source>
        <translation>Το %1 έχει σημάδια του %2, αλλά κανένα αυτής της ακολουθίας. Να εισαχθούν ούτως ή άλλως;</translation>
    </message>
    <message>
        <source>Nothing was imported.</source>
        <translation>Δεν εισήχθη τίποτα.</translation>
    </message>
    <message>
        <source>Continue the repeat round? Your first marks are hidden until you end it.</source>
        <translation>Συνέχεια του γύρου επανάληψης; Τα πρώτα σας σημάδια μένουν κρυμμένα ώσπου να τον τελειώσετε.</translation>
    </message>
    <message>
        <source>Start a repeat round? A random tenth of your finished joints is asked for once more, to see how well you repeat yourself. Your first marks are kept, and hidden until you end the round.</source>
        <translation>Έναρξη γύρου επανάληψης; Ζητείται ξανά ένα τυχαίο δέκατο των έτοιμων αρθρώσεών σας, για να φανεί πόσο καλά επαναλαμβάνετε. Τα πρώτα σας σημάδια διατηρούνται, κρυμμένα ως το τέλος του γύρου.</translation>
    </message>
    <message>
        <source>Start the repeat round</source>
        <translation>Έναρξη γύρου επανάληψης</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Όχι τώρα</translation>
    </message>
    <message>
        <source>Repeat round: your first marks are hidden. %1 of %2 joints.</source>
        <translation>Γύρος επανάληψης: τα πρώτα σας σημάδια είναι κρυμμένα. %1 από %2 αρθρώσεις.</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Επόμενη</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Τέλος</translation>
    </message>
    <message>
        <source>There is no frame %1: sequence &quot;%2&quot; has frames 0-%3. The last one is shown.</source>
        <translation>Δεν υπάρχει καρέ %1: η ακολουθία «%2» έχει τα καρέ 0-%3. Εμφανίζεται το τελευταίο.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Άνοιγμα</translation>
    </message>
    <message>
        <source>No program opened %1.</source>
        <translation>Κανένα πρόγραμμα δεν άνοιξε το %1.</translation>
    </message>
    <message>
        <source>Nothing was changed: %1 holds nothing that is not there already.</source>
        <translation>Δεν άλλαξε τίποτα: το %1 δεν έχει τίποτα καινούργιο.</translation>
    </message>
    <message>
        <source>Results saved in %1</source>
        <translation>Τα αποτελέσματα αποθηκεύτηκαν στο %1</translation>
    </message>
    <message>
        <source>Comparisons (*.json)</source>
        <translation>Συγκρίσεις (*.json)</translation>
    </message>
    <message>
        <source>Fit a pair first.</source>
        <translation>Προσαρμόστε πρώτα ένα ζεύγος.</translation>
    </message>
    <message>
        <source>Save this comparison</source>
        <translation>Αποθήκευση αυτής της σύγκρισης</translation>
    </message>
    <message>
        <source>Open a comparison</source>
        <translation>Άνοιγμα σύγκρισης</translation>
    </message>
    <message>
        <source>No other person has marks in this sequence.</source>
        <translation>Κανένα άλλο άτομο δεν έχει σημάδια σε αυτή την ακολουθία.</translation>
    </message>
    <message>
        <source>Refine the calibration</source>
        <translation>Βελτίωση της βαθμονόμησης</translation>
    </message>
    <message>
        <source>Measure this person&apos;s hands</source>
        <translation>Μέτρηση των χεριών αυτού του ατόμου</translation>
    </message>
    <message>
        <source>Refine the calibration first.</source>
        <translation>Βελτιώστε πρώτα τη βαθμονόμηση.</translation>
    </message>
    <message>
        <source>No joint is clicked in two cameras yet.</source>
        <translation>Καμία άρθρωση δεν έχει ακόμη κλικ σε δύο κάμερες.</translation>
    </message>
    <message>
        <source>The dataset uses %1 now; all joints were reconstructed anew.</source>
        <translation>Το σύνολο χρησιμοποιεί τώρα το %1· όλες οι αρθρώσεις ανακατασκευάστηκαν.</translation>
    </message>
    <message>
        <source>Refining the calibration</source>
        <translation>Βελτιώνεται η βαθμονόμηση</translation>
    </message>
    <message>
        <source>Measuring hands</source>
        <translation>Μέτρηση χεριών</translation>
    </message>
    <message>
        <source>Measuring hands: %1</source>
        <translation>Μέτρηση χεριών: %1</translation>
    </message>
    <message>
        <source>It is not known yet where the hands are: mark some joints, then frame them.</source>
        <translation>Δεν είναι ακόμη γνωστό πού είναι τα χέρια: σημειώστε μερικές αρθρώσεις και εστιάστε μετά.</translation>
    </message>
    <message>
        <source>No frame waits for a look.</source>
        <translation>Κανένα καρέ δεν περιμένει έλεγχο.</translation>
    </message>
    <message>
        <source>This is the only frame that waits for a look.</source>
        <translation>Αυτό είναι το μόνο καρέ που περιμένει έλεγχο.</translation>
    </message>
    <message>
        <source>Every frame of the first pass is reviewed.</source>
        <translation>Όλα τα καρέ του πρώτου περάσματος ελέγχθηκαν.</translation>
    </message>
    <message>
        <source>Click or drag %1 in two views, then accept the frame.</source>
        <translation>Κάντε κλικ στο %1 ή σύρετέ το σε δύο προβολές και μετά αποδεχτείτε το καρέ.</translation>
    </message>
    <message numerus="yes">
        <source>Stopped: %n mark(s) in %1 frames are proposed; the next start goes on from there.</source>
        <translation>
            <numerusform>Διακοπή: προτείνεται %n σημάδι σε %1 καρέ· η επόμενη έναρξη συνεχίζει από εκεί.</numerusform>
            <numerusform>Διακοπή: προτείνονται %n σημάδια σε %1 καρέ· η επόμενη έναρξη συνεχίζει από εκεί.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>First pass: hands in %1 of %2 frames, %n mark(s) proposed.</source>
        <translation>
            <numerusform>Πρώτο πέρασμα: χέρια σε %1 από %2 καρέ, προτείνεται %n σημάδι.</numerusform>
            <numerusform>Πρώτο πέρασμα: χέρια σε %1 από %2 καρέ, προτείνονται %n σημάδια.</numerusform>
        </translation>
    </message>
    <message>
        <source>Installing the hand detector</source>
        <translation>Εγκατάσταση του ανιχνευτή χεριών</translation>
    </message>
    <message>
        <source>First pass</source>
        <translation>Πρώτο πέρασμα</translation>
    </message>
    <message>
        <source>Following the hands from the corrected frame</source>
        <translation>Παρακολούθηση των χεριών από το διορθωμένο καρέ</translation>
    </message>
    <message numerus="yes">
        <source>%n mark(s) around frame %1 are proposed anew.</source>
        <translation>
            <numerusform>%n σημάδι γύρω από το καρέ %1 προτείνεται εκ νέου.</numerusform>
            <numerusform>%n σημάδια γύρω από το καρέ %1 προτείνονται εκ νέου.</numerusform>
        </translation>
    </message>
    <message>
        <source>Silhouettes</source>
        <translation>Σιλουέτες</translation>
    </message>
    <message>
        <source>Making silhouettes</source>
        <translation>Δημιουργία σιλουετών</translation>
    </message>
    <message>
        <source>A tracker&apos;s estimates</source>
        <translation>Εκτιμήσεις ιχνηλάτη</translation>
    </message>
    <message>
        <source>Estimates (*.csv *.json)</source>
        <translation>Εκτιμήσεις (*.csv *.json)</translation>
    </message>
    <message>
        <source>This sequence has no recorded motion.</source>
        <translation>Αυτή η ακολουθία δεν έχει καταγεγραμμένη κίνηση.</translation>
    </message>
    <message>
        <source>Drawings (*.svg)</source>
        <translation>Σχέδια (*.svg)</translation>
    </message>
    <message>
        <source>Pages (*.pdf)</source>
        <translation>Σελίδες (*.pdf)</translation>
    </message>
    <message>
        <source>Save the comparison as a picture</source>
        <translation>Αποθήκευση σύγκρισης ως εικόνα</translation>
    </message>
    <message>
        <source>Report of this comparison</source>
        <translation>Αναφορά αυτής της σύγκρισης</translation>
    </message>
    <message>
        <source>Saving the film</source>
        <translation>Αποθήκευση του βίντεο</translation>
    </message>
    <message>
        <source>Films (*.mp4)</source>
        <translation>Βίντεο (*.mp4)</translation>
    </message>
    <message>
        <source>Films (*.avi)</source>
        <translation>Βίντεο (*.avi)</translation>
    </message>
    <message>
        <source>Save the iterations as a film</source>
        <translation>Αποθήκευση επαναλήψεων ως βίντεο</translation>
    </message>
    <message>
        <source>Bringing the hands to the corrected joint</source>
        <translation>Προσαρμογή των χεριών στη διορθωμένη άρθρωση</translation>
    </message>
    <message numerus="yes">
        <source>%n mark(s) of frame %1 follow the corrected joint.</source>
        <translation>
            <numerusform>%n σημάδι του καρέ %1 ακολουθεί τη διορθωμένη άρθρωση.</numerusform>
            <numerusform>%n σημάδια του καρέ %1 ακολουθούν τη διορθωμένη άρθρωση.</numerusform>
        </translation>
    </message>
    <message>
        <source>Silhouettes lie %1 px beside the hands: refine the calibration.</source>
        <translation>Οι σιλουέτες απέχουν %1 px από τα χέρια: βελτιώστε τη βαθμονόμηση.</translation>
    </message>
</context>
<context>
    <name>app::MasksPage</name>
    <message>
        <source>None yet</source>
        <translation>Καμία ακόμα</translation>
    </message>
    <message>
        <source>They can be made from the pictures once the dataset is open, or attached later.</source>
        <translation>Μπορούν να δημιουργηθούν από τις εικόνες όταν ανοίξει το σύνολο ή να συνδεθούν αργότερα.</translation>
    </message>
    <message>
        <source>They are there</source>
        <translation>Υπάρχουν ήδη</translation>
    </message>
    <message>
        <source>A folder with a folder of numbered masks per camera, or a pattern with {camera} and {frame}. White is hand, black is not.</source>
        <translation>Φάκελος με έναν φάκελο αριθμημένων μασκών ανά κάμερα ή μοτίβο με {camera} και {frame}. Λευκό είναι το χέρι, μαύρο όλα τα άλλα.</translation>
    </message>
    <message>
        <source>The folder of the silhouettes</source>
        <translation>Ο φάκελος των σιλουετών</translation>
    </message>
    <message>
        <source>Choose the folder of the silhouettes.</source>
        <translation>Επιλέξτε τον φάκελο των σιλουετών.</translation>
    </message>
    <message>
        <source>This must be a folder, or a pattern with {frame}.</source>
        <translation>Πρέπει να είναι φάκελος ή μοτίβο με {frame}.</translation>
    </message>
</context>
<context>
    <name>app::NewDatasetWindow</name>
    <message>
        <source>Make a dataset</source>
        <translation>Δημιουργία συνόλου δεδομένων</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Βαθμονόμηση</translation>
    </message>
    <message>
        <source>Folder of the dataset</source>
        <translation>Φάκελος του συνόλου</translation>
    </message>
    <message>
        <source>An empty folder for the dataset</source>
        <translation>Ένας κενός φάκελος για το σύνολο</translation>
    </message>
    <message>
        <source>Make the dataset</source>
        <translation>Δημιουργία</translation>
    </message>
    <message>
        <source>Footage</source>
        <translation>Υλικό</translation>
    </message>
    <message>
        <source>Choose a folder for the dataset.</source>
        <translation>Επιλέξτε φάκελο για το σύνολο.</translation>
    </message>
    <message>
        <source>The footage is looked at...</source>
        <translation>Εξέταση του υλικού...</translation>
    </message>
    <message>
        <source>Hands</source>
        <translation>Χέρια</translation>
    </message>
    <message>
        <source>Silhouettes</source>
        <translation>Σιλουέτες</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Φάκελος</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Πίσω</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Επόμενο</translation>
    </message>
    <message>
        <source>There is neither a video, nor a folder of images, nor a calibration in what was dropped.</source>
        <translation>Σε ό,τι σύρατε δεν υπάρχει ούτε βίντεο ούτε φάκελος εικόνων ούτε βαθμονόμηση.</translation>
    </message>
    <message>
        <source>The folder of the dataset is not empty: choose another.</source>
        <translation>Ο φάκελος του συνόλου δεν είναι κενός: επιλέξτε άλλον.</translation>
    </message>
    <message numerus="yes">
        <source>%n piece(s) of footage</source>
        <translation>
            <numerusform>%n υλικό</numerusform>
            <numerusform>%n υλικά</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n camera(s)</source>
        <translation>
            <numerusform>%n κάμερα</numerusform>
            <numerusform>%n κάμερες</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>app::PathField</name>
    <message>
        <source>Choose...</source>
        <translation>Επιλογή...</translation>
    </message>
</context>
<context>
    <name>app::PreferencesWindow</name>
    <message>
        <source>Preferences</source>
        <translation>Προτιμήσεις</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Γενικά</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Πλήκτρα</translation>
    </message>
    <message>
        <source>Your name</source>
        <translation>Το όνομά σας</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Γλώσσα</translation>
    </message>
    <message>
        <source>Another language is used from the next start on.</source>
        <translation>Άλλη γλώσσα ισχύει από την επόμενη εκκίνηση.</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Χρώματα</translation>
    </message>
    <message>
        <source>Memory for pictures</source>
        <translation>Μνήμη για εικόνες</translation>
    </message>
    <message>
        <source>Hints</source>
        <translation>Υποδείξεις</translation>
    </message>
    <message>
        <source>Your marks are kept under this name.</source>
        <translation>Τα σημάδια σας φυλάσσονται με αυτό το όνομα.</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Όπως το σύστημα</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Σκούρα</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Ανοιχτά</translation>
    </message>
    <message>
        <source> MB</source>
        <translation> MB</translation>
    </message>
    <message>
        <source>Pictures of recent frames are kept in so much memory: stepping back then needs no reading.</source>
        <translation>Οι εικόνες των πρόσφατων καρέ κρατιούνται σε τόση μνήμη: η επιστροφή δεν χρειάζεται ανάγνωση.</translation>
    </message>
    <message>
        <source>Show the four hints at the next start</source>
        <translation>Εμφάνιση των τεσσάρων υποδείξεων στην επόμενη εκκίνηση</translation>
    </message>
</context>
<context>
    <name>app::RangeWindow</name>
    <message>
        <source>From frame</source>
        <translation>Από το καρέ</translation>
    </message>
    <message>
        <source>To frame</source>
        <translation>Έως το καρέ</translation>
    </message>
</context>
<context>
    <name>app::ShortcutModel</name>
    <message>
        <source>Menu</source>
        <translation>Μενού</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Ενέργεια</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>Συντόμευση</translation>
    </message>
    <message>
        <source>What it does</source>
        <translation>Τι κάνει</translation>
    </message>
    <message>
        <source>%1 belongs to “%2” already: change that one first.</source>
        <translation>Το %1 ανήκει ήδη στο «%2»: αλλάξτε πρώτα εκείνο.</translation>
    </message>
</context>
<context>
    <name>app::ShortcutPage</name>
    <message>
        <source>Search</source>
        <translation>Αναζήτηση</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Επαναφορά όλων</translation>
    </message>
    <message>
        <source>Double-click a shortcut to change it.</source>
        <translation>Διπλό κλικ σε μια συντόμευση για αλλαγή.</translation>
    </message>
</context>
<context>
    <name>app::ShortcutWindow</name>
    <message>
        <source>Shortcuts</source>
        <translation>Συντομεύσεις</translation>
    </message>
</context>
<context>
    <name>widgets::Advice</name>
    <message>
        <source>fewer than two views</source>
        <translation>λιγότερες από δύο προβολές</translation>
    </message>
    <message>
        <source>a click lies where the lens model cannot be inverted</source>
        <translation>ένα κλικ βρίσκεται εκεί όπου το μοντέλο του φακού δεν αντιστρέφεται</translation>
    </message>
    <message>
        <source>rays are nearly parallel</source>
        <translation>οι ακτίνες είναι σχεδόν παράλληλες</translation>
    </message>
    <message>
        <source>the rays meet behind a camera</source>
        <translation>οι ακτίνες τέμνονται πίσω από μια κάμερα</translation>
    </message>
    <message>
        <source>views disagree</source>
        <translation>οι προβολές δεν συμφωνούν</translation>
    </message>
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
        <translation>Επιλέξτε μια άρθρωση στα αριστερά.</translation>
    </message>
    <message>
        <source>Click %1 in any view.</source>
        <translation>Κάντε κλικ στο %1 σε οποιαδήποτε προβολή.</translation>
    </message>
    <message>
        <source>The click in %1 disagrees with the others: check it.</source>
        <translation>Το κλικ στην κάμερα %1 δεν συμφωνεί με τα άλλα: ελέγξτε το.</translation>
    </message>
    <message>
        <source>No 3D point: %1.</source>
        <translation>Χωρίς σημείο 3D: %1.</translation>
    </message>
    <message>
        <source>Click %1 in a second view.</source>
        <translation>Κάντε κλικ στο %1 σε δεύτερη προβολή.</translation>
    </message>
    <message>
        <source>Click %1 in a second view, best in %2.</source>
        <translation>Κάντε κλικ στο %1 σε δεύτερη προβολή, κατά προτίμηση στην %2.</translation>
    </message>
    <message>
        <source>Done in every view: go on with the next joint.</source>
        <translation>Έτοιμη σε κάθε προβολή: συνεχίστε με την επόμενη άρθρωση.</translation>
    </message>
    <message>
        <source>Accept the remaining views with Space, or mark them as not placeable.</source>
        <translation>Αποδεχτείτε τις υπόλοιπες προβολές με το Space ή δηλώστε ότι δεν τοποθετείται εκεί.</translation>
    </message>
    <message>
        <source>Click in %1 next (→ %2 mm), or accept with Space.</source>
        <translation>Επόμενο κλικ στην %1 (→ %2 mm) ή αποδοχή με το Space.</translation>
    </message>
    <message>
        <source>No 3D point: the click in %1 is %2.</source>
        <translation>Χωρίς σημείο 3D: το κλικ στην %1 είναι %2.</translation>
    </message>
    <message>
        <source>No 3D point: the click in %1 is %2, the one in %3 %4.</source>
        <translation>Χωρίς σημείο 3D: το κλικ στην %1 είναι %2, στην %3 %4.</translation>
    </message>
    <message numerus="yes">
        <source>%1 clicked, %2 accepted, %3 proposed; %n view(s) have a picture</source>
        <translation>
            <numerusform>%1 με κλικ, %2 αποδεκτά, %3 προτεινόμενα· %n όψη έχει εικόνα</numerusform>
            <numerusform>%1 με κλικ, %2 αποδεκτά, %3 προτεινόμενα· %n όψεις έχουν εικόνα</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 px off %2&apos;s curve</source>
        <translation>%1 px μακριά από την καμπύλη της %2</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n view(s)</source>
        <translation>
            <numerusform>%1 από %n όψη</numerusform>
            <numerusform>%1 από %n όψεις</numerusform>
        </translation>
    </message>
    <message>
        <source>A joint needs at least two cameras with a picture.</source>
        <translation>Μια άρθρωση χρειάζεται τουλάχιστον δύο κάμερες με εικόνα.</translation>
    </message>
    <message>
        <source>as proposed</source>
        <translation>όπως προτάθηκε</translation>
    </message>
    <message>
        <source>Accepted as proposed; click %1 in two views to correct it.</source>
        <translation>Αποδεκτή όπως προτάθηκε· για διόρθωση κάντε κλικ στο %1 σε δύο προβολές.</translation>
    </message>
    <message>
        <source>Proposed by a program: click %1 in two views if it is wrong.</source>
        <translation>Πρόταση προγράμματος: αν είναι λάθος, κάντε κλικ στο %1 σε δύο προβολές.</translation>
    </message>
</context>
<context>
    <name>widgets::AgreementModel</name>
    <message>
        <source>All joints</source>
        <translation>Όλες οι αρθρώσεις</translation>
    </message>
    <message>
        <source>Bias %1 mm, 95 % of the differences between %2 and %3 mm</source>
        <translation>Μεροληψία %1 mm, 95 % των διαφορών μεταξύ %2 και %3 mm</translation>
    </message>
    <message>
        <source>Mean difference along this axis of the world, mm (Bland and Altman)</source>
        <translation>Μέση διαφορά κατά μήκος αυτού του άξονα του κόσμου, mm (Bland και Altman)</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>Άρθρωση</translation>
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
        <translation>μέγ.</translation>
    </message>
</context>
<context>
    <name>widgets::AnnotationDocument</name>
    <message>
        <source>Nothing was changed: the annotations are open for reading only (%1).</source>
        <translation>Δεν άλλαξε τίποτα: οι επισημειώσεις είναι ανοιχτές μόνο για ανάγνωση (%1).</translation>
    </message>
</context>
<context>
    <name>widgets::AnnotationFiles</name>
    <message>
        <source>Open a dataset first.</source>
        <translation>Ανοίξτε πρώτα ένα σύνολο δεδομένων.</translation>
    </message>
    <message>
        <source>The import was stopped, because another sequence was opened.</source>
        <translation>Η εισαγωγή σταμάτησε, επειδή άνοιξε άλλη ακολουθία.</translation>
    </message>
    <message>
        <source>One moment: the last import, export or report is not finished.</source>
        <translation>Μια στιγμή: η τελευταία εισαγωγή, εξαγωγή ή αναφορά δεν έχει τελειώσει.</translation>
    </message>
    <message>
        <source>Exporting</source>
        <translation>Εξαγωγή</translation>
    </message>
    <message>
        <source>Importing</source>
        <translation>Εισαγωγή</translation>
    </message>
    <message>
        <source>Writing the report</source>
        <translation>Γράφεται η αναφορά</translation>
    </message>
    <message>
        <source>Reading the joints</source>
        <translation>Διαβάζονται οι αρθρώσεις</translation>
    </message>
</context>
<context>
    <name>widgets::Annotator</name>
    <message>
        <source>Nothing to accept: click %1 in two views first.</source>
        <translation>Τίποτα προς αποδοχή: κάντε πρώτα κλικ στο %1 σε δύο προβολές.</translation>
    </message>
    <message>
        <source>There is no mark of %1 in this view.</source>
        <translation>Δεν υπάρχει σημάδι για το %1 σε αυτή την προβολή.</translation>
    </message>
    <message>
        <source>Click the place where the joint is hidden, then mark it as occluded.</source>
        <translation>Κάντε κλικ εκεί όπου κρύβεται η άρθρωση και μετά δηλώστε την ως κρυμμένη.</translation>
    </message>
    <message>
        <source>Every view that sees %1 has a mark of it.</source>
        <translation>Κάθε όψη που βλέπει το %1 έχει ήδη σημάδι του.</translation>
    </message>
    <message>
        <source>Nothing was placed: %1 has no picture of this frame.</source>
        <translation>Δεν τοποθετήθηκε τίποτα: η %1 δεν έχει εικόνα σε αυτό το καρέ.</translation>
    </message>
    <message>
        <source>Nothing was placed: this is outside the picture of %1.</source>
        <translation>Δεν τοποθετήθηκε τίποτα: το σημείο είναι έξω από την εικόνα της %1.</translation>
    </message>
    <message>
        <source>Nothing to accept in this frame: no joint with a 3D point has a view left that sees it.</source>
        <translation>Τίποτα προς αποδοχή σε αυτό το καρέ: καμία άρθρωση με σημείο 3D δεν έχει άλλη όψη που τη βλέπει.</translation>
    </message>
    <message>
        <source>There is no mark of %1 in this frame.</source>
        <translation>Δεν υπάρχει σημάδι για %1 σε αυτό το καρέ.</translation>
    </message>
    <message>
        <source>The mark is at the edge of the picture.</source>
        <translation>Το σημάδι είναι στην άκρη της εικόνας.</translation>
    </message>
    <message>
        <source>Nothing to accept: the clicks of %1 give no 3D point.</source>
        <translation>Τίποτα προς αποδοχή: τα κλικ του %1 δεν δίνουν σημείο 3D.</translation>
    </message>
    <message>
        <source>Nothing waits to be accepted in this frame.</source>
        <translation>Τίποτα δεν περιμένει αποδοχή σε αυτό το καρέ.</translation>
    </message>
</context>
<context>
    <name>widgets::BenchmarkPage</name>
    <message>
        <source>Methods</source>
        <translation>Μέθοδοι</translation>
    </message>
    <message>
        <source>Sequences</source>
        <translation>Ακολουθίες</translation>
    </message>
    <message>
        <source> % of frames</source>
        <translation> % των καρέ</translation>
    </message>
    <message>
        <source>Synthetic</source>
        <translation>Συνθετική</translation>
    </message>
    <message>
        <source>Realistic</source>
        <translation>Ρεαλιστική</translation>
    </message>
    <message>
        <source>Setup</source>
        <translation>Διάταξη</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Δοκιμή</translation>
    </message>
    <message>
        <source>Frames apart</source>
        <translation>Απόσταση καρέ</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Σπόρος</translation>
    </message>
    <message>
        <source>“%1” is not a number of frames.</source>
        <translation>Το «%1» δεν είναι πλήθος καρέ.</translation>
    </message>
    <message>
        <source>Choose at least one method and one sequence.</source>
        <translation>Επιλέξτε τουλάχιστον μία μέθοδο και μία ακολουθία.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Διακοπή</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Εκτέλεση</translation>
    </message>
    <message>
        <source>Save results...</source>
        <translation>Αποθήκευση αποτελεσμάτων...</translation>
    </message>
    <message>
        <source>Open results...</source>
        <translation>Άνοιγμα αποτελεσμάτων...</translation>
    </message>
    <message>
        <source>Tables, pairs and a report, as handlens-batch benchmark writes them</source>
        <translation>Πίνακες, ζεύγη και αναφορά, όπως τα γράφει το handlens-batch benchmark</translation>
    </message>
    <message>
        <source>A folder that was saved here or written by handlens-batch benchmark</source>
        <translation>Φάκελος που αποθηκεύτηκε εδώ ή γράφτηκε από το handlens-batch benchmark</translation>
    </message>
    <message>
        <source>Save the results in a folder</source>
        <translation>Αποθήκευση των αποτελεσμάτων σε φάκελο</translation>
    </message>
    <message>
        <source>Open the results of a folder</source>
        <translation>Άνοιγμα των αποτελεσμάτων ενός φακέλου</translation>
    </message>
    <message>
        <source>Which setup the tables and curves below are of</source>
        <translation>Ποιας διάταξης είναι οι πίνακες και οι καμπύλες παρακάτω</translation>
    </message>
    <message>
        <source>Kendall&apos;s tau of the methods&apos; mean errors: 1 is the same order, 0 says nothing, -1 is the reverse; in brackets what 95 % of drawings of these pairs give</source>
        <translation>Ταυ του Kendall των μέσων σφαλμάτων των μεθόδων: 1 είναι η ίδια σειρά, 0 δεν λέει τίποτα, -1 είναι η αντίστροφη· σε παρένθεση ό,τι δίνει το 95 % των κληρώσεων αυτών των ζευγών</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Και οι δύο</translation>
    </message>
    <message>
        <source>Synthetic: silhouettes of the recorded poses, errors over all joints. Realistic: mask files, errors over the marked joints. Both: one after the other, side by side in one report.</source>
        <translation>Συνθετική: σιλουέτες των καταγεγραμμένων ποζών, σφάλματα σε όλες τις αρθρώσεις. Ρεαλιστική: αρχεία μάσκας, σφάλματα στις σημειωμένες αρθρώσεις. Και οι δύο: η μία μετά την άλλη, δίπλα δίπλα σε μία αναφορά.</translation>
    </message>
    <message>
        <source>Order of the methods in both setups: tau %1 (%2 to %3)</source>
        <translation>Σειρά των μεθόδων και στις δύο διατάξεις: ταυ %1 (%2 έως %3)</translation>
    </message>
    <message>
        <source>The results are saved in %1.</source>
        <translation>Τα αποτελέσματα αποθηκεύτηκαν στο %1.</translation>
    </message>
    <message>
        <source>Show the report</source>
        <translation>Εμφάνιση αναφοράς</translation>
    </message>
    <message>
        <source>Stop the benchmark first.</source>
        <translation>Σταματήστε πρώτα τη δοκιμή.</translation>
    </message>
    <message>
        <source>Choose at least one method.</source>
        <translation>Επιλέξτε τουλάχιστον μία μέθοδο.</translation>
    </message>
    <message>
        <source>Select pairs in the table first.</source>
        <translation>Επιλέξτε πρώτα ζεύγη στον πίνακα.</translation>
    </message>
    <message>
        <source>Results of %1; the settings on the left are those of the next run.</source>
        <translation>Αποτελέσματα από %1· οι ρυθμίσεις αριστερά αφορούν την επόμενη εκτέλεση.</translation>
    </message>
</context>
<context>
    <name>widgets::BenchmarkPairPlots</name>
    <message>
        <source>No pair that is shown has results of both methods.</source>
        <translation>Κανένα εμφανιζόμενο ζεύγος δεν έχει αποτελέσματα και των δύο μεθόδων.</translation>
    </message>
    <message>
        <source>Every pair: click one to inspect it</source>
        <translation>Όλα τα ζεύγη: κάντε κλικ σε ένα για εξέταση</translation>
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
        <translation>%1, %2 έως %3</translation>
    </message>
    <message>
        <source>Where A and B differ</source>
        <translation>Πού διαφέρουν A και B</translation>
    </message>
    <message>
        <source>A − B, mm</source>
        <translation>A − B, mm</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>Ζεύγη</translation>
    </message>
    <message>
        <source>A is better: %1</source>
        <translation>Καλύτερη η A: %1</translation>
    </message>
    <message>
        <source>B is better: %1</source>
        <translation>Καλύτερη η B: %1</translation>
    </message>
    <message>
        <source>No pair is shown.</source>
        <translation>Δεν εμφανίζεται κανένα ζεύγος.</translation>
    </message>
    <message>
        <source>By frames apart: quartiles, and 5 to 95 %</source>
        <translation>Ανά απόσταση: τεταρτημόρια, 5 έως 95 %</translation>
    </message>
    <message>
        <source>Frames apart</source>
        <translation>Απόσταση καρέ</translation>
    </message>
    <message>
        <source>Error, mm</source>
        <translation>Σφάλμα, mm</translation>
    </message>
    <message>
        <source>frames apart: %1</source>
        <translation>απόσταση καρέ: %1</translation>
    </message>
</context>
<context>
    <name>widgets::BenchmarkPairsView</name>
    <message>
        <source>Double-click a pair to inspect it with every method; select several to run them</source>
        <translation>Διπλό κλικ σε ένα ζεύγος για εξέταση με κάθε μέθοδο· επιλέξτε πολλά για να τα εκτελέσετε</translation>
    </message>
    <message>
        <source>The column A − B and the plots compare these two methods</source>
        <translation>Η στήλη A − B και τα διαγράμματα συγκρίνουν αυτές τις δύο μεθόδους</translation>
    </message>
    <message>
        <source>Method %1</source>
        <translation>Μέθοδος %1</translation>
    </message>
    <message>
        <source>Filter, such as A-B&gt;1 difference&gt;=10</source>
        <translation>Φίλτρο, όπως A-B&gt;1 difference&gt;=10</translation>
    </message>
    <message>
        <source>Filter of the pairs</source>
        <translation>Φίλτρο των ζευγών</translation>
    </message>
    <message>
        <source>Runs the methods that are ticked on the left on the selected pairs, and adds what they find</source>
        <translation>Εκτελεί τις μεθόδους που είναι επιλεγμένες αριστερά στα επιλεγμένα ζεύγη και προσθέτει ό,τι βρίσκουν</translation>
    </message>
    <message>
        <source>%1 of %2 pairs</source>
        <translation>%1 από %2 ζεύγη</translation>
    </message>
    <message>
        <source>Run selected</source>
        <translation>Εκτέλεση επιλεγμένων</translation>
    </message>
    <message>
        <source>Inspect this pair</source>
        <translation>Εξέταση αυτού του ζεύγους</translation>
    </message>
    <message>
        <source>Select all that are shown</source>
        <translation>Επιλογή όλων των εμφανιζόμενων</translation>
    </message>
    <message>
        <source>Copy the selected rows</source>
        <translation>Αντιγραφή επιλεγμένων γραμμών</translation>
    </message>
    <message>
        <source>Run selected (%1)</source>
        <translation>Εκτέλεση επιλεγμένων (%1)</translation>
    </message>
</context>
<context>
    <name>widgets::BenchmarkResultsView</name>
    <message>
        <source>Share of pairs below each error</source>
        <translation>Ποσοστό ζευγών κάτω από κάθε σφάλμα</translation>
    </message>
    <message>
        <source>Error, mm</source>
        <translation>Σφάλμα, mm</translation>
    </message>
    <message>
        <source>Pairs, %</source>
        <translation>Ζεύγη, %</translation>
    </message>
    <message>
        <source>Run the benchmark to compare the methods.</source>
        <translation>Εκτελέστε τη δοκιμή για να συγκρίνετε τις μεθόδους.</translation>
    </message>
    <message>
        <source>Error per joint</source>
        <translation>Σφάλμα ανά άρθρωση</translation>
    </message>
    <message>
        <source>start</source>
        <translation>αρχή</translation>
    </message>
    <message>
        <source>All methods</source>
        <translation>Όλες οι μέθοδοι</translation>
    </message>
    <message>
        <source>A against B</source>
        <translation>A έναντι B</translation>
    </message>
</context>
<context>
    <name>widgets::BenchmarkRunner</name>
    <message>
        <source>Open a dataset first.</source>
        <translation>Ανοίξτε πρώτα ένα σύνολο δεδομένων.</translation>
    </message>
    <message>
        <source>%1 of %2 fits</source>
        <translation>%1 από %2 προσαρμογές</translation>
    </message>
    <message>
        <source>This folder holds the results of another benchmark. Choose another one.</source>
        <translation>Ο φάκελος έχει αποτελέσματα άλλης δοκιμής. Επιλέξτε άλλον.</translation>
    </message>
    <message>
        <source>This folder already holds a file %1. Choose another one.</source>
        <translation>Ο φάκελος έχει ήδη αρχείο %1. Επιλέξτε άλλον.</translation>
    </message>
    <message>
        <source>There are no results to save yet.</source>
        <translation>Δεν υπάρχουν ακόμη αποτελέσματα.</translation>
    </message>
    <message>
        <source>Stop the benchmark first.</source>
        <translation>Σταματήστε πρώτα τη δοκιμή.</translation>
    </message>
    <message>
        <source>These results are not of the open dataset, or it has changed since: %1.</source>
        <translation>Τα αποτελέσματα δεν είναι του ανοιχτού συνόλου, ή αυτό άλλαξε από τότε: %1.</translation>
    </message>
    <message numerus="yes">
        <source>This benchmark is not finished: %n fit(s) are in.</source>
        <translation>
            <numerusform>Η δοκιμή δεν τελείωσε: υπάρχει %n προσαρμογή.</numerusform>
            <numerusform>Η δοκιμή δεν τελείωσε: υπάρχουν %n προσαρμογές.</numerusform>
        </translation>
    </message>
    <message>
        <source>These results are not of the open dataset, or it has changed since: pairs cannot be added to them.</source>
        <translation>Τα αποτελέσματα δεν είναι του ανοιχτού συνόλου, ή αυτό άλλαξε από τότε: δεν μπορούν να προστεθούν ζεύγη.</translation>
    </message>
</context>
<context>
    <name>widgets::BoxPlot</name>
    <message>
        <source>%1: median %2</source>
        <translation>%1: διάμεσος %2</translation>
    </message>
</context>
<context>
    <name>widgets::CalibrationChoice</name>
    <message>
        <source>Wait until the sequence is open.</source>
        <translation>Περιμένετε να ανοίξει η ακολουθία.</translation>
    </message>
</context>
<context>
    <name>widgets::CameraChoice</name>
    <message>
        <source>Which cameras are the rows</source>
        <translation>Ποιες κάμερες είναι οι σειρές</translation>
    </message>
    <message>
        <source>From the current one on</source>
        <translation>Από την τρέχουσα και μετά</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>Επιλογή</translation>
    </message>
    <message numerus="yes">
        <source>%n chosen</source>
        <translation>
            <numerusform>%n επιλεγμένη</numerusform>
            <numerusform>%n επιλεγμένες</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>widgets::CameraFaultText</name>
    <message>
        <source>its rotation is a mirror: an axis points the wrong way</source>
        <translation>η στροφή της είναι κατοπτρισμός: ένας άξονας δείχνει ανάποδα</translation>
    </message>
    <message>
        <source>its rotation matrix is not a rotation</source>
        <translation>ο πίνακας στροφής της δεν είναι στροφή</translation>
    </message>
    <message>
        <source>its focal length is not positive</source>
        <translation>η εστιακή της απόσταση δεν είναι θετική</translation>
    </message>
    <message>
        <source>its principal point lies outside the image: is the matrix transposed, or the image size wrong?</source>
        <translation>το πρωτεύον σημείο της είναι έξω από την εικόνα: μήπως ο πίνακας είναι ανάστροφος ή το μέγεθος εικόνας λάθος;</translation>
    </message>
    <message>
        <source>its footage has %1 pixels, the calibration is for %2: another camera&apos;s footage?</source>
        <translation>το υλικό της έχει %1 πίξελ, η βαθμονόμηση είναι για %2: μήπως είναι υλικό άλλης κάμερας;</translation>
    </message>
    <message>
        <source>its footage is scaled by %1 (%2 pixels, the calibration is for %3)</source>
        <translation>το υλικό της έχει κλίμακα %1 (%2 πίξελ, η βαθμονόμηση είναι για %3)</translation>
    </message>
    <message>
        <source>it stands where %1 stands</source>
        <translation>βρίσκεται εκεί όπου και η %1</translation>
    </message>
    <message>
        <source>where the cameras look lies behind it: is its rotation inverted?</source>
        <translation>εκεί όπου κοιτούν οι κάμερες είναι πίσω της: μήπως η στροφή της είναι αντίστροφη;</translation>
    </message>
    <message>
        <source>it does not see where the other cameras look</source>
        <translation>δεν βλέπει εκεί όπου κοιτούν οι άλλες κάμερες</translation>
    </message>
    <message>
        <source>its lens model holds in %1 % of the image only</source>
        <translation>το μοντέλο του φακού της ισχύει μόνο στο %1 % της εικόνας</translation>
    </message>
    <message>
        <source>The cameras are %1 mm from where they look: choose another unit.</source>
        <translation>Οι κάμερες απέχουν %1 mm από εκεί όπου κοιτούν: επιλέξτε άλλη μονάδα.</translation>
    </message>
</context>
<context>
    <name>widgets::ColumnBar</name>
    <message>
        <source>Add a column: a method, the start, the truth, a tracker</source>
        <translation>Προσθήκη στήλης: μέθοδος, αρχική πόζα, πραγματική πόζα, ιχνηλάτης</translation>
    </message>
    <message>
        <source>Add a column</source>
        <translation>Προσθήκη στήλης</translation>
    </message>
    <message>
        <source>A tracker&apos;s estimates...</source>
        <translation>Εκτιμήσεις ιχνηλάτη...</translation>
    </message>
</context>
<context>
    <name>widgets::ColumnHead</name>
    <message>
        <source>Settings of this method, and what if</source>
        <translation>Ρυθμίσεις αυτής της μεθόδου και «Τι αν»</translation>
    </message>
    <message>
        <source>Remove this column</source>
        <translation>Αφαίρεση αυτής της στήλης</translation>
    </message>
    <message>
        <source>Drag it to another place</source>
        <translation>Σύρετέ τη σε άλλη θέση</translation>
    </message>
</context>
<context>
    <name>widgets::CurvePlot</name>
    <message>
        <source>Logarithmic axis</source>
        <translation>Λογαριθμικός άξονας</translation>
    </message>
</context>
<context>
    <name>widgets::DatasetSession</name>
    <message>
        <source>Your last edits are not saved yet, so they would be lost. Make room or give permission where they are kept, or export them first.</source>
        <translation>Οι τελευταίες αλλαγές σας δεν έχουν αποθηκευτεί ακόμη και θα χάνονταν. Ελευθερώστε χώρο ή δώστε δικαιώματα εκεί όπου φυλάσσονται ή εξαγάγετέ τες πρώτα.</translation>
    </message>
</context>
<context>
    <name>widgets::EditText</name>
    <message>
        <source>delete %1 in %2</source>
        <translation>διαγραφή (%1, %2)</translation>
    </message>
    <message>
        <source>mark %1 as not placeable in %2</source>
        <translation>δεν τοποθετείται (%1, %2)</translation>
    </message>
    <message>
        <source>accept %1 in %2</source>
        <translation>αποδοχή (%1, %2)</translation>
    </message>
    <message>
        <source>place %1 in %2</source>
        <translation>τοποθέτηση (%1, %2)</translation>
    </message>
    <message>
        <source>move %1 in %2</source>
        <translation>μετακίνηση (%1, %2)</translation>
    </message>
    <message>
        <source>mark %1 as occluded in %2</source>
        <translation>σήμανση ως κρυμμένο (%1, %2)</translation>
    </message>
    <message>
        <source>mark %1 as visible in %2</source>
        <translation>σήμανση ως ορατό (%1, %2)</translation>
    </message>
    <message numerus="yes">
        <source>accept %n mark(s)</source>
        <translation>
            <numerusform>αποδοχή %n σημαδιού</numerusform>
            <numerusform>αποδοχή %n σημαδιών</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>copy a pose (%n mark(s))</source>
        <translation>
            <numerusform>αντιγραφή πόζας (%n σημάδι)</numerusform>
            <numerusform>αντιγραφή πόζας (%n σημάδια)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>interpolate (%n mark(s))</source>
        <translation>
            <numerusform>παρεμβολή (%n σημάδι)</numerusform>
            <numerusform>παρεμβολή (%n σημάδια)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>swap left and right (%n mark(s))</source>
        <translation>
            <numerusform>εναλλαγή αριστερού και δεξιού (%n σημάδι)</numerusform>
            <numerusform>εναλλαγή αριστερού και δεξιού (%n σημάδια)</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>delete %n mark(s)</source>
        <translation>
            <numerusform>διαγραφή %n σημαδιού</numerusform>
            <numerusform>διαγραφή %n σημαδιών</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>import %n mark(s)</source>
        <translation>
            <numerusform>εισαγωγή %n σημαδιού</numerusform>
            <numerusform>εισαγωγή %n σημαδιών</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>propose %n mark(s)</source>
        <translation>
            <numerusform>πρόταση %n σημαδιού</numerusform>
            <numerusform>πρόταση %n σημαδιών</numerusform>
        </translation>
    </message>
    <message>
        <source>left</source>
        <translation>αριστερό</translation>
    </message>
    <message>
        <source>right</source>
        <translation>δεξί</translation>
    </message>
    <message>
        <source>L %1</source>
        <translation>Α %1</translation>
    </message>
    <message>
        <source>R %1</source>
        <translation>Δ %1</translation>
    </message>
    <message>
        <source>note on frame %1</source>
        <translation>σημείωση για το καρέ %1</translation>
    </message>
    <message numerus="yes">
        <source>change %n mark(s)</source>
        <translation>
            <numerusform>αλλαγή %n σημαδιού</numerusform>
            <numerusform>αλλαγή %n σημαδιών</numerusform>
        </translation>
    </message>
    <message>
        <source>propose %1 in %2</source>
        <translation>πρόταση %1 στην %2</translation>
    </message>
    <message numerus="yes">
        <source>first pass (%n proposed mark(s))</source>
        <translation>
            <numerusform>πρώτο πέρασμα (%n προτεινόμενο σημάδι)</numerusform>
            <numerusform>πρώτο πέρασμα (%n προτεινόμενα σημάδια)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>widgets::EmptyState</name>
    <message>
        <source>Recent datasets</source>
        <translation>Πρόσφατα σύνολα δεδομένων</translation>
    </message>
    <message>
        <source>Open a dataset...</source>
        <translation>Άνοιγμα συνόλου δεδομένων...</translation>
    </message>
    <message>
        <source>Try the demo</source>
        <translation>Δοκιμή της επίδειξης</translation>
    </message>
    <message>
        <source>Open a dataset or make one of your videos: drop either here. Or try the demo.</source>
        <translation>Ανοίξτε ένα σύνολο ή φτιάξτε ένα από τα βίντεό σας: αφήστε τα εδώ. Ή δοκιμάστε την επίδειξη.</translation>
    </message>
    <message>
        <source>Make a dataset...</source>
        <translation>Δημιουργία συνόλου...</translation>
    </message>
</context>
<context>
    <name>widgets::ErrorText</name>
    <message>
        <source>this is not possible with the data that is open</source>
        <translation>δεν είναι δυνατό με τα δεδομένα που είναι ανοιχτά</translation>
    </message>
    <message>
        <source>not found</source>
        <translation>δεν βρέθηκε</translation>
    </message>
    <message>
        <source>the content is not valid</source>
        <translation>το περιεχόμενο δεν είναι έγκυρο</translation>
    </message>
    <message>
        <source>written by a newer version of Handlens</source>
        <translation>γράφτηκε από νεότερη έκδοση του Handlens</translation>
    </message>
    <message>
        <source>cannot be read or written: check permissions and space</source>
        <translation>δεν διαβάζεται ή δεν γράφεται: ελέγξτε δικαιώματα και χώρο</translation>
    </message>
    <message>
        <source>this kind of content is not supported</source>
        <translation>αυτό το είδος περιεχομένου δεν υποστηρίζεται</translation>
    </message>
    <message>
        <source>unexpected error</source>
        <translation>απρόσμενο σφάλμα</translation>
    </message>
</context>
<context>
    <name>widgets::Finding</name>
    <message>
        <source>click in %1 is %2 px off</source>
        <translation>το κλικ στην %1 αποκλίνει %2 px</translation>
    </message>
    <message>
        <source>no 3D point from its clicks</source>
        <translation>χωρίς σημείο 3D από τα κλικ της</translation>
    </message>
    <message>
        <source>bone %1 % longer than usual</source>
        <translation>οστό %1 % μακρύτερο από το σύνηθες</translation>
    </message>
    <message>
        <source>bone %1 % shorter than usual</source>
        <translation>οστό %1 % κοντύτερο από το σύνηθες</translation>
    </message>
    <message>
        <source>bent %1° beyond its limit</source>
        <translation>κάμψη %1° πέρα από το όριο</translation>
    </message>
    <message>
        <source>fingers exchanged? %1 mm out of order</source>
        <translation>μπερδεμένα δάχτυλα; %1 mm εκτός σειράς</translation>
    </message>
    <message>
        <source>left and right exchanged?</source>
        <translation>μπερδεμένα αριστερό και δεξί;</translation>
    </message>
    <message>
        <source>on the same pixel as another joint in %1</source>
        <translation>στο ίδιο πίξελ με άλλη άρθρωση στην %1</translation>
    </message>
    <message>
        <source>no 3D point: %1</source>
        <translation>χωρίς σημείο 3D: %1</translation>
    </message>
    <message>
        <source>error of %1 px</source>
        <translation>σφάλμα %1 px</translation>
    </message>
    <message>
        <source>no 3D point: click in %1 is %2</source>
        <translation>χωρίς σημείο 3D: το κλικ στην %1 είναι %2</translation>
    </message>
    <message>
        <source>mark is %1 px outside the picture of %2</source>
        <translation>το σημάδι είναι %1 px έξω από την εικόνα της %2</translation>
    </message>
</context>
<context>
    <name>widgets::FindingModel</name>
    <message>
        <source>Finding</source>
        <translation>Εύρημα</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>Άρθρωση</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Καρέ</translation>
    </message>
</context>
<context>
    <name>widgets::FirstPass</name>
    <message>
        <source>Open a dataset first.</source>
        <translation>Ανοίξτε πρώτα ένα σύνολο δεδομένων.</translation>
    </message>
    <message>
        <source>These annotations are read-only: nothing can be proposed.</source>
        <translation>Αυτές οι επισημειώσεις είναι μόνο για ανάγνωση: δεν μπορεί να προταθεί τίποτα.</translation>
    </message>
    <message>
        <source>The first pass needs two cameras with pictures.</source>
        <translation>Το πρώτο πέρασμα χρειάζεται δύο κάμερες με εικόνες.</translation>
    </message>
</context>
<context>
    <name>widgets::FirstPassForm</name>
    <message>
        <source>left</source>
        <translation>αριστερό</translation>
    </message>
    <message>
        <source>right</source>
        <translation>δεξί</translation>
    </message>
    <message>
        <source>all 21 of a hand</source>
        <translation>και οι 21 κάθε χεριού</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Έναρξη</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Διακοπή</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Απόκρυψη</translation>
    </message>
    <message>
        <source>The hand detector of %1 is installed.</source>
        <translation>Ο ανιχνευτής χεριών του %1 εγκαταστάθηκε.</translation>
    </message>
    <message>
        <source>The list of joints follows; otherwise only joints of the list are proposed</source>
        <translation>Η λίστα αρθρώσεων ακολουθεί· αλλιώς προτείνονται μόνο αρθρώσεις της λίστας</translation>
    </message>
    <message>
        <source>First frame</source>
        <translation>Πρώτο καρέ</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>Τελευταίο καρέ</translation>
    </message>
    <message>
        <source>Every so many frames</source>
        <translation>Ανά πόσα καρέ</translation>
    </message>
    <message>
        <source>Finds the joints in these frames, in the background; they wait for your look as proposals</source>
        <translation>Βρίσκει τις αρθρώσεις σε αυτά τα καρέ, στο παρασκήνιο· περιμένουν τον έλεγχό σας ως προτάσεις</translation>
    </message>
    <message>
        <source>Keeps the frames that are done; the next start goes on from there</source>
        <translation>Διατηρεί τα έτοιμα καρέ· η επόμενη έναρξη συνεχίζει από εκεί</translation>
    </message>
    <message>
        <source>Sequence</source>
        <translation>Ακολουθία</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Καρέ</translation>
    </message>
    <message>
        <source>Hands</source>
        <translation>Χέρια</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Αρθρώσεις</translation>
    </message>
    <message>
        <source>every</source>
        <translation>ανά</translation>
    </message>
    <message>
        <source>Open a dataset first.</source>
        <translation>Ανοίξτε πρώτα ένα σύνολο δεδομένων.</translation>
    </message>
    <message>
        <source>Choose a hand.</source>
        <translation>Επιλέξτε ένα χέρι.</translation>
    </message>
    <message>
        <source>The last frame comes before the first one.</source>
        <translation>Το τελευταίο καρέ είναι πριν από το πρώτο.</translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s). Marks that are there already stay.</source>
        <translation>
            <numerusform>%n καρέ. Τα σημάδια που υπάρχουν ήδη μένουν.</numerusform>
            <numerusform>%n καρέ. Τα σημάδια που υπάρχουν ήδη μένουν.</numerusform>
        </translation>
    </message>
    <message>
        <source>The hand detector is not installed: get it with &quot;npm pack @mediapipe/hands&quot; (11 MB, Apache-2.0) and choose the file, or run &quot;handlens-batch detector install FILE&quot;.</source>
        <translation>Ο ανιχνευτής χεριών δεν είναι εγκατεστημένος: κατεβάστε τον με «npm pack @mediapipe/hands» (11 MB, Apache-2.0) και επιλέξτε το αρχείο ή εκτελέστε «handlens-batch detector install FILE».</translation>
    </message>
    <message>
        <source>Choose the file...</source>
        <translation>Επιλογή αρχείου...</translation>
    </message>
    <message>
        <source>The package @mediapipe/hands</source>
        <translation>Το πακέτο @mediapipe/hands</translation>
    </message>
    <message>
        <source>Packages (*.tgz)</source>
        <translation>Πακέτα (*.tgz)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Όλα τα αρχεία (*)</translation>
    </message>
</context>
<context>
    <name>widgets::FitPair</name>
    <message>
        <source>This sequence has no recorded motion: mark some joints of every hand in the start frame, and the fit starts from the hand model fitted to them.</source>
        <translation>Αυτή η ακολουθία δεν έχει καταγεγραμμένη κίνηση: σημειώστε μερικές αρθρώσεις κάθε χεριού στο αρχικό καρέ και η προσαρμογή θα ξεκινήσει από το μοντέλο χεριού προσαρμοσμένο σε αυτές.</translation>
    </message>
    <message>
        <source>There is no mask file of the test frame.</source>
        <translation>Δεν υπάρχει αρχείο μάσκας για το καρέ δοκιμής.</translation>
    </message>
</context>
<context>
    <name>widgets::FitRunner</name>
    <message>
        <source>This dataset has no hand models to fit.</source>
        <translation>Αυτό το σύνολο δεδομένων δεν έχει μοντέλα χεριών για προσαρμογή.</translation>
    </message>
    <message>
        <source>This sequence has no mask files.</source>
        <translation>Αυτή η ακολουθία δεν έχει αρχεία μάσκας.</translation>
    </message>
    <message>
        <source>This sequence has no recorded motion to draw silhouettes from.</source>
        <translation>Αυτή η ακολουθία δεν έχει καταγεγραμμένη κίνηση από την οποία να σχεδιαστούν σιλουέτες.</translation>
    </message>
    <message>
        <source>The start and the test frame must be between 0 and %1.</source>
        <translation>Το αρχικό καρέ και το καρέ δοκιμής πρέπει να είναι μεταξύ 0 και %1.</translation>
    </message>
    <message>
        <source>Choose at least one method.</source>
        <translation>Επιλέξτε τουλάχιστον μία μέθοδο.</translation>
    </message>
    <message>
        <source>This sequence needs silhouettes: attach a folder of masks, or make them.</source>
        <translation>Η ακολουθία χρειάζεται σιλουέτες: συνδέστε φάκελο μασκών ή φτιάξτε τις.</translation>
    </message>
</context>
<context>
    <name>widgets::FittingPanel</name>
    <message>
        <source>Silhouettes of the recorded pose</source>
        <translation>Σιλουέτες καταγεγραμμένης πόζας</translation>
    </message>
    <message>
        <source>Silhouettes of the mask files</source>
        <translation>Σιλουέτες αρχείων μάσκας</translation>
    </message>
    <message>
        <source>What the fit is to meet. Against mask files, errors are measured over the joints marked in the test frame.</source>
        <translation>Τι πρέπει να πετύχει η προσαρμογή. Με αρχεία μάσκας, τα σφάλματα μετρώνται στις αρθρώσεις που έχουν σημάδια στο καρέ δοκιμής.</translation>
    </message>
    <message>
        <source>Iteration</source>
        <translation>Επανάληψη</translation>
    </message>
    <message>
        <source>Error, mm</source>
        <translation>Σφάλμα, mm</translation>
    </message>
    <message>
        <source>The error of every iteration appears here.</source>
        <translation>Εδώ εμφανίζεται το σφάλμα κάθε επανάληψης.</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Αρχή</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Δοκιμή</translation>
    </message>
    <message>
        <source>Frame whose silhouettes are to be met</source>
        <translation>Καρέ του οποίου οι σιλουέτες είναι ο στόχος</translation>
    </message>
    <message>
        <source>Here</source>
        <translation>Εδώ</translation>
    </message>
    <message>
        <source>Test the current frame</source>
        <translation>Δοκιμή στο τρέχον καρέ</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Διακοπή</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Προσαρμογή</translation>
    </message>
    <message>
        <source>Frame whose pose the fit starts from: the recorded one or, without, the hand model of its marks</source>
        <translation>Καρέ από του οποίου την πόζα ξεκινά η προσαρμογή: η καταγεγραμμένη ή, χωρίς αυτήν, το μοντέλο χεριού των σημαδιών του</translation>
    </message>
    <message>
        <source>Attach masks...</source>
        <translation>Σύνδεση μασκών...</translation>
    </message>
    <message>
        <source>A folder of masks, white where the hands are: CAMERA/000012.png, CAMERA_000012.png or the like</source>
        <translation>Φάκελος μασκών, λευκές όπου είναι τα χέρια: CAMERA/000012.png, CAMERA_000012.png ή παρόμοια</translation>
    </message>
</context>
<context>
    <name>widgets::FootageFinder</name>
    <message>
        <source>not found: %1</source>
        <translation>δεν βρέθηκε: %1</translation>
    </message>
</context>
<context>
    <name>widgets::FootageText</name>
    <message numerus="yes">
        <source>%1 and %n more place(s)</source>
        <translation>
            <numerusform>%1 και %n ακόμη θέση</numerusform>
            <numerusform>%1 και %n ακόμη θέσεις</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %n frame(s) missing after frame %2.</source>
        <translation>
            <numerusform>%1: λείπει %n καρέ μετά το καρέ %2.</numerusform>
            <numerusform>%1: λείπουν %n καρέ μετά το καρέ %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 after frame %2</source>
        <translation>%1 μετά το καρέ %2</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n frame(s) missing: %2.</source>
        <translation>
            <numerusform>%1: λείπει %n καρέ: %2.</numerusform>
            <numerusform>%1: λείπουν %n καρέ: %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %n picture(s) missing: %2.</source>
        <translation>
            <numerusform>%1: λείπει %n εικόνα: %2.</numerusform>
            <numerusform>%1: λείπουν %n εικόνες: %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>The pictures start at different numbers (%1); the first ones are taken as the same instant.</source>
        <translation>Οι εικόνες αρχίζουν από διαφορετικούς αριθμούς (%1)· οι πρώτες θεωρούνται της ίδιας στιγμής.</translation>
    </message>
    <message>
        <source>%1: its time stamps are uneven or missing, so lost frames cannot be told; its frames are taken by number.</source>
        <translation>%1: οι χρονοσημάνσεις της είναι άνισες ή λείπουν, οπότε χαμένα καρέ δεν διακρίνονται· τα καρέ της λαμβάνονται κατά αριθμό.</translation>
    </message>
    <message>
        <source>%1: frame 0 is picture %2.</source>
        <translation>%1: το καρέ 0 είναι η εικόνα %2.</translation>
    </message>
    <message numerus="yes">
        <source>%1 goes on for %n frame(s) after the last instant.</source>
        <translation>
            <numerusform>Η %1 συνεχίζει για %n καρέ μετά την τελευταία στιγμή.</numerusform>
            <numerusform>Η %1 συνεχίζει για %n καρέ μετά την τελευταία στιγμή.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 has %n frame(s) more than the shortest footage: are they all of the same instants?</source>
        <translation>
            <numerusform>Η %1 έχει %n καρέ περισσότερο από το συντομότερο υλικό: είναι όλα των ίδιων στιγμών;</numerusform>
            <numerusform>Η %1 έχει %n καρέ περισσότερα από το συντομότερο υλικό: είναι όλα των ίδιων στιγμών;</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 was recorded at another frame rate than the sequence&apos;s %2.</source>
        <translation>Η %1 καταγράφηκε με άλλον ρυθμό καρέ από τον %2 της ακολουθίας.</translation>
    </message>
    <message>
        <source>%1: its pictures have more than 8 bits; level %2 is shown black, %3 white.</source>
        <translation>%1: οι εικόνες της έχουν πάνω από 8 bit· η στάθμη %2 εμφανίζεται μαύρη, η %3 λευκή.</translation>
    </message>
    <message>
        <source>%1: the orientation tag of its pictures says that they are mirrored; they are not mirrored here, but turned by %2°.</source>
        <translation>%1: η ετικέτα προσανατολισμού των εικόνων της λέει ότι είναι κατοπτρισμένες· εδώ δεν κατοπτρίζονται, αλλά στρέφονται κατά %2°.</translation>
    </message>
    <message>
        <source>%1: turned clockwise by %2°, as its orientation tag says.</source>
        <translation>%1: στροφή δεξιόστροφα κατά %2°, όπως λέει η ετικέτα προσανατολισμού της.</translation>
    </message>
    <message>
        <source>%1: its orientation tag says that it is to be turned clockwise by %2°, but it is turned by %3°.</source>
        <translation>%1: η ετικέτα προσανατολισμού της ζητά στροφή δεξιόστροφα κατά %2°, αλλά στρέφεται κατά %3°.</translation>
    </message>
    <message>
        <source>Simulated. Masks are the difference of each picture to the empty room; only the annotated frames have pictures. The recorded motion is that of the person in the pictures, played by the model&apos;s hand. What it was drawn from is in the folder truth.</source>
        <translation>Προσομοίωση. Οι μάσκες είναι η διαφορά κάθε εικόνας από το άδειο δωμάτιο· μόνο τα επισημειωμένα καρέ έχουν εικόνες. Η καταγεγραμμένη κίνηση είναι του ατόμου στις εικόνες, εκτελεσμένη από το χέρι του μοντέλου. Ό,τι χρησίμευσε για τη σχεδίαση είναι στον φάκελο truth.</translation>
    </message>
    <message>
        <source>Its frames are taken by number, so the later ones are not of the other cameras&apos; instants.</source>
        <translation>Τα καρέ της λαμβάνονται κατά αριθμό, οπότε τα επόμενα δεν είναι των στιγμών των άλλων καμερών.</translation>
    </message>
    <message>
        <source>%1: %2 of %3 frames have a mask.</source>
        <translation>%1: %2 από %3 καρέ έχουν μάσκα.</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n mask(s) of no frame of the sequence: its frames need the numbers %2 to %3, the masks have %4 to %5.</source>
        <translation>
            <numerusform>%1: %n μάσκα δεν ανήκει σε καρέ της ακολουθίας: τα καρέ της χρειάζονται τους αριθμούς %2 έως %3, οι μάσκες έχουν %4 έως %5.</numerusform>
            <numerusform>%1: %n μάσκες δεν ανήκουν σε καρέ της ακολουθίας: τα καρέ της χρειάζονται τους αριθμούς %2 έως %3, οι μάσκες έχουν %4 έως %5.</numerusform>
        </translation>
    </message>
    <message>
        <source>it has %1 frames, but the sequence needs %2</source>
        <translation>έχει %1 καρέ, αλλά η ακολουθία χρειάζεται %2</translation>
    </message>
    <message>
        <source>it has %1 pictures, but the sequence needs %2</source>
        <translation>έχει %1 εικόνες, αλλά η ακολουθία χρειάζεται %2</translation>
    </message>
    <message>
        <source>it is %1, but its camera is calibrated for %2</source>
        <translation>είναι %1, αλλά η κάμερά του είναι βαθμονομημένη για %2</translation>
    </message>
    <message>
        <source>it cannot be read (%1)</source>
        <translation>δεν μπορεί να διαβαστεί (%1)</translation>
    </message>
    <message>
        <source>several fit: %1</source>
        <translation>ταιριάζουν πολλά: %1</translation>
    </message>
    <message>
        <source>%1 has that name, but is other footage of this dataset</source>
        <translation>το %1 έχει αυτό το όνομα, αλλά είναι άλλο υλικό αυτού του συνόλου</translation>
    </message>
</context>
<context>
    <name>widgets::FramePictures</name>
    <message>
        <source>No picture at this instant.</source>
        <translation>Καμία εικόνα αυτή τη στιγμή.</translation>
    </message>
    <message>
        <source>Find...</source>
        <translation>Εύρεση...</translation>
    </message>
</context>
<context>
    <name>widgets::FramesBar</name>
    <message>
        <source>Sequence</source>
        <translation>Ακολουθία</translation>
    </message>
    <message>
        <source>Frame: type a number and press Enter</source>
        <translation>Καρέ: πληκτρολογήστε έναν αριθμό και πατήστε Enter</translation>
    </message>
    <message>
        <source>Frame </source>
        <translation>Καρέ </translation>
    </message>
    <message>
        <source>What the colours of the timeline mean</source>
        <translation>Τι σημαίνουν τα χρώματα του χρονολογίου</translation>
    </message>
</context>
<context>
    <name>widgets::HandDiagram</name>
    <message>
        <source>Joints of both hands</source>
        <translation>Αρθρώσεις και των δύο χεριών</translation>
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
        <translation>Αυτό το σύνολο δεδομένων δεν έχει μοντέλα χεριών.</translation>
    </message>
    <message>
        <source>The hand model needs three joints of a hand that have a 3D point and are not on a line.</source>
        <translation>Το μοντέλο χεριού χρειάζεται τρεις αρθρώσεις ενός χεριού που έχουν σημείο 3D και δεν είναι στην ίδια ευθεία.</translation>
    </message>
</context>
<context>
    <name>widgets::Hints</name>
    <message>
        <source>Choose a joint on the left, then click it in two views: its 3D place appears at once.</source>
        <translation>Επιλέξτε μια άρθρωση στα αριστερά και κάντε κλικ πάνω της σε δύο προβολές: η θέση της σε 3D εμφανίζεται αμέσως.</translation>
    </message>
    <message>
        <source>Space accepts a pre-placed mark, X deletes one, Ctrl+Z takes back anything.</source>
        <translation>Το Space αποδέχεται ένα προτεινόμενο σημάδι, το X διαγράφει ένα σημάδι, το Ctrl+Z αναιρεί οτιδήποτε.</translation>
    </message>
    <message>
        <source>A and D step through the frames, W and S through the joints; F1 shows every key.</source>
        <translation>Τα A και D αλλάζουν καρέ, τα W και S άρθρωση· το F1 δείχνει όλα τα πλήκτρα.</translation>
    </message>
    <message>
        <source>The wheel zooms, the middle button moves, a double click fills the window with one view; 9 frames the hands, 0 shows whole pictures.</source>
        <translation>Ο τροχός μεγεθύνει, το μεσαίο πλήκτρο μετακινεί, το διπλό κλικ γεμίζει το παράθυρο με μία όψη· 9 εστιάζει στα χέρια, 0 δείχνει όλη την εικόνα.</translation>
    </message>
    <message>
        <source>Got it (Esc)</source>
        <translation>Εντάξει (Esc)</translation>
    </message>
</context>
<context>
    <name>widgets::HistogramPlot</name>
    <message>
        <source>%1 to %2, pairs: %3</source>
        <translation>%1 έως %2, ζεύγη: %3</translation>
    </message>
</context>
<context>
    <name>widgets::ImportText</name>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 και %n ακόμη</numerusform>
            <numerusform>%1 και %n ακόμη</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: its footage is shifted against the sequence; the numbers of its pictures are taken as frames of the sequence, not of the video.</source>
        <translation>%1: το υλικό της είναι μετατοπισμένο ως προς την ακολουθία· οι αριθμοί των εικόνων της θεωρούνται καρέ της ακολουθίας, όχι του βίντεο.</translation>
    </message>
    <message>
        <source>The file names none of the dataset&apos;s cameras; they are taken in the dataset&apos;s order: %1.</source>
        <translation>Το αρχείο δεν ονομάζει καμία κάμερα του συνόλου· λαμβάνονται με τη σειρά του συνόλου: %1.</translation>
    </message>
    <message>
        <source>The file holds reprojections of 3D points, not clicks (data_2d); they come as proposals.</source>
        <translation>Το αρχείο περιέχει επαναπροβολές σημείων 3D, όχι κλικ (data_2d)· έρχονται ως προτάσεις.</translation>
    </message>
    <message>
        <source>The file holds 3D points without clicks; they come as proposals.</source>
        <translation>Το αρχείο περιέχει σημεία 3D χωρίς κλικ· έρχονται ως προτάσεις.</translation>
    </message>
    <message>
        <source>The file is of sequence %1, not of %2.</source>
        <translation>Το αρχείο είναι της ακολουθίας %1, όχι της %2.</translation>
    </message>
    <message>
        <source>Some marks are a program&apos;s guesses; they come as proposals, to be checked.</source>
        <translation>Μερικά σημάδια είναι προβλέψεις προγράμματος· έρχονται ως προτάσεις, για έλεγχο.</translation>
    </message>
    <message>
        <source>The marks are a program&apos;s guesses; they come as proposals, to be checked.</source>
        <translation>Τα σημάδια είναι προβλέψεις προγράμματος· έρχονται ως προτάσεις, για έλεγχο.</translation>
    </message>
    <message numerus="yes">
        <source>Left out: %n item(s) of frames that sequence %1 does not have (it has 0 to %2).</source>
        <translation>
            <numerusform>Παραλείφθηκε %n στοιχείο καρέ που η ακολουθία %1 δεν έχει (έχει 0 έως %2).</numerusform>
            <numerusform>Παραλείφθηκαν %n στοιχεία καρέ που η ακολουθία %1 δεν έχει (έχει 0 έως %2).</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Left out: %n mark(s) in camera %1, which the dataset does not have.</source>
        <translation>
            <numerusform>Παραλείφθηκε %n σημάδι στην κάμερα %1, που το σύνολο δεν έχει.</numerusform>
            <numerusform>Παραλείφθηκαν %n σημάδια στην κάμερα %1, που το σύνολο δεν έχει.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Left out: %n row(s) of the view of camera %1.</source>
        <translation>
            <numerusform>Παραλείφθηκε %n γραμμή της προβολής της κάμερας %1.</numerusform>
            <numerusform>Παραλείφθηκαν %n γραμμές της προβολής της κάμερας %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Left out: %n row(s) of other videos: %1.</source>
        <translation>
            <numerusform>Παραλείφθηκε %n γραμμή άλλων βίντεο: %1.</numerusform>
            <numerusform>Παραλείφθηκαν %n γραμμές άλλων βίντεο: %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n mark(s) outside the picture of %1: kept, but not used for 3D points.</source>
        <translation>
            <numerusform>%n σημάδι έξω από την εικόνα της %1: διατηρείται, αλλά δεν χρησιμοποιείται για σημεία 3D.</numerusform>
            <numerusform>%n σημάδια έξω από την εικόνα της %1: διατηρούνται, αλλά δεν χρησιμοποιούνται για σημεία 3D.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Left out: %n mark(s) with a likelihood below %1.</source>
        <translation>
            <numerusform>Παραλείφθηκε %n σημάδι με πιθανότητα κάτω από %1.</numerusform>
            <numerusform>Παραλείφθηκαν %n σημάδια με πιθανότητα κάτω από %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Left out: %n guess(es) of joints that are labelled or guessed in the same picture already.</source>
        <translation>
            <numerusform>Παραλείφθηκε %n πρόβλεψη άρθρωσης που έχει ήδη σήμανση ή πρόβλεψη στην ίδια εικόνα.</numerusform>
            <numerusform>Παραλείφθηκαν %n προβλέψεις αρθρώσεων που έχουν ήδη σήμανση ή πρόβλεψη στην ίδια εικόνα.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Left out: %n label(s) marked as not visible.</source>
        <translation>
            <numerusform>Παραλείφθηκε %n σήμανση που δηλώθηκε ως μη ορατή.</numerusform>
            <numerusform>Παραλείφθηκαν %n σημάνσεις που δηλώθηκαν ως μη ορατές.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Left out: %n mark(s) of %1, which is not in the joint map.</source>
        <translation>
            <numerusform>Παραλείφθηκε %n σημάδι του %1, που δεν υπάρχει στην αντιστοίχιση αρθρώσεων.</numerusform>
            <numerusform>Παραλείφθηκαν %n σημάδια του %1, που δεν υπάρχει στην αντιστοίχιση αρθρώσεων.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Left out: %n annotation(s) of category %1, which says neither left nor right.</source>
        <translation>
            <numerusform>Παραλείφθηκε %n επισημείωση της κατηγορίας %1, που δεν λέει ούτε αριστερό ούτε δεξί.</numerusform>
            <numerusform>Παραλείφθηκαν %n επισημειώσεις της κατηγορίας %1, που δεν λέει ούτε αριστερό ούτε δεξί.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Left out: %n mark(s) of body parts that are not joints: %1. A name that fits is %2; the command line takes a map of names (annotations --map).</source>
        <translation>
            <numerusform>Παραλείφθηκε %n σημάδι μερών του σώματος που δεν είναι αρθρώσεις: %1. Ένα όνομα που ταιριάζει είναι %2· η γραμμή εντολών δέχεται αντιστοίχιση ονομάτων (annotations --map).</numerusform>
            <numerusform>Παραλείφθηκαν %n σημάδια μερών του σώματος που δεν είναι αρθρώσεις: %1. Ένα όνομα που ταιριάζει είναι %2· η γραμμή εντολών δέχεται αντιστοίχιση ονομάτων (annotations --map).</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>widgets::InspectColumns</name>
    <message>
        <source>Start</source>
        <translation>Αρχή</translation>
    </message>
    <message>
        <source>Truth</source>
        <translation>Πραγματική</translation>
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
        <translation>άκαμπτα</translation>
    </message>
    <message>
        <source>coarse mesh</source>
        <translation>αδρό πλέγμα</translation>
    </message>
    <message>
        <source>medium mesh</source>
        <translation>μεσαίο πλέγμα</translation>
    </message>
    <message>
        <source>full mesh</source>
        <translation>πλήρες πλέγμα</translation>
    </message>
    <message>
        <source>Hands move as a whole, their fingers do not</source>
        <translation>Τα χέρια κινούνται ως σύνολο, τα δάχτυλά τους όχι</translation>
    </message>
    <message>
        <source>All joints move, by a coarse mesh</source>
        <translation>Κινούνται όλες οι αρθρώσεις, με αδρό πλέγμα</translation>
    </message>
    <message>
        <source>All joints move, by a finer mesh</source>
        <translation>Κινούνται όλες οι αρθρώσεις, με λεπτότερο πλέγμα</translation>
    </message>
    <message>
        <source>All joints move, by the whole mesh</source>
        <translation>Κινούνται όλες οι αρθρώσεις, με ολόκληρο το πλέγμα</translation>
    </message>
</context>
<context>
    <name>widgets::InspectGrid</name>
    <message>
        <source>No picture at this instant.</source>
        <translation>Καμία εικόνα αυτή τη στιγμή.</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>απέτυχε</translation>
    </message>
    <message>
        <source>IoU: intersection over union of both silhouettes in this view, without the forearm, which the fit leaves out</source>
        <translation>IoU: τομή προς ένωση των δύο σιλουετών σε αυτή την όψη, χωρίς τον πήχη, τον οποίο παραλείπει η προσαρμογή</translation>
    </message>
    <message>
        <source>IoU: intersection over union of both silhouettes in this view</source>
        <translation>IoU: τομή προς ένωση των δύο σιλουετών σε αυτή την όψη</translation>
    </message>
    <message>
        <source>IoU %1</source>
        <translation>IoU %1</translation>
    </message>
    <message>
        <source>%1, left out</source>
        <translation>%1, εκτός</translation>
    </message>
</context>
<context>
    <name>widgets::InspectJointErrors</name>
    <message>
        <source>The column whose error is drawn, joint by joint, at the iteration that is shown</source>
        <translation>Η στήλη της οποίας το σφάλμα σχεδιάζεται, ανά άρθρωση, στην εμφανιζόμενη επανάληψη</translation>
    </message>
</context>
<context>
    <name>widgets::InspectLayerBar</name>
    <message>
        <source>Direction of the rim point whose field is shown</source>
        <translation>Κατεύθυνση του σημείου χείλους του οποίου εμφανίζεται το πεδίο</translation>
    </message>
    <message>
        <source>(%1, %2), direction %3°</source>
        <translation>(%1· %2), κατεύθυνση %3°</translation>
    </message>
    <message>
        <source>none</source>
        <translation>καμία</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>%1, refused</source>
        <translation>%1, απορρίφθηκε</translation>
    </message>
    <message>
        <source>95 % regions</source>
        <translation>Περιοχές 95 %</translation>
    </message>
    <message>
        <source>Point at a view to see what each method would match there; click to pin it.</source>
        <translation>Δείξτε σε μια προβολή για να δείτε τι θα αντιστοίχιζε κάθε μέθοδος εκεί· κάντε κλικ για να καρφιτσωθεί.</translation>
    </message>
    <message>
        <source>refused: %1</source>
        <translation>απορρίφθηκε: %1</translation>
    </message>
    <message>
        <source>Rim points and matches that are drawn</source>
        <translation>Σημεία χείλους και αντιστοιχίες που σχεδιάζονται</translation>
    </message>
    <message>
        <source>missed: seen, not covered</source>
        <translation>λείπει: φαίνεται, δεν καλύπτεται</translation>
    </message>
    <message>
        <source>extra: covered, not seen</source>
        <translation>επιπλέον: καλύπτεται, δεν φαίνεται</translation>
    </message>
    <message>
        <source>forearm: left out, as the fit does</source>
        <translation>πήχης: παραλείπεται, όπως στην προσαρμογή</translation>
    </message>
    <message>
        <source>outline, by direction</source>
        <translation>περίγραμμα, κατά κατεύθυνση</translation>
    </message>
    <message>
        <source>direction %1°</source>
        <translation>κατεύθυνση %1°</translation>
    </message>
    <message>
        <source>rim, with normals</source>
        <translation>χείλος, με καθέτους</translation>
    </message>
    <message>
        <source>observed silhouette</source>
        <translation>σιλουέτα-στόχος</translation>
    </message>
    <message>
        <source>error: there is no recorded pose</source>
        <translation>σφάλμα: δεν υπάρχει καταγεγραμμένη στάση</translation>
    </message>
    <message>
        <source>observed silhouette, with noise</source>
        <translation>σιλουέτα-στόχος, με θόρυβο</translation>
    </message>
    <message>
        <source>matches 0–%1+ px</source>
        <translation>αντιστοιχίες 0–%1+ px</translation>
    </message>
    <message>
        <source>field 0–%1+ px; clear: no match</source>
        <translation>πεδίο 0–%1+ px· διαφανές: καμία αντιστοιχία</translation>
    </message>
    <message>
        <source>error 0–%1+ mm</source>
        <translation>σφάλμα 0–%1+ mm</translation>
    </message>
</context>
<context>
    <name>widgets::InspectPage</name>
    <message>
        <source>Cameras: </source>
        <translation>Κάμερες: </translation>
    </message>
    <message>
        <source>Rows of cameras, from the current one on</source>
        <translation>Σειρές καμερών, από την τρέχουσα και μετά</translation>
    </message>
    <message>
        <source>Iteration</source>
        <translation>Επανάληψη</translation>
    </message>
    <message>
        <source>Error, mm</source>
        <translation>Σφάλμα, mm</translation>
    </message>
    <message>
        <source>Cost, mm²</source>
        <translation>Κόστος, mm²</translation>
    </message>
    <message>
        <source>Frame %1 from frame %2</source>
        <translation>Καρέ %1 από το καρέ %2</translation>
    </message>
    <message>
        <source>Iteration %1 of %2</source>
        <translation>Επανάληψη %1 από %2</translation>
    </message>
    <message>
        <source>Fit this frame</source>
        <translation>Προσαρμογή αυτού του καρέ</translation>
    </message>
    <message>
        <source>With the methods chosen under Fit, from the pose of some frames before</source>
        <translation>Με τις μεθόδους που επιλέχθηκαν στην Προσαρμογή, από την πόζα μερικών καρέ πριν</translation>
    </message>
    <message>
        <source>Fitting...</source>
        <translation>Προσαρμογή...</translation>
    </message>
    <message>
        <source>Fit the current frame to see the methods side by side.</source>
        <translation>Προσαρμόστε το τρέχον καρέ για να δείτε τις μεθόδους δίπλα δίπλα.</translation>
    </message>
    <message>
        <source>There is no reference to measure the error against.</source>
        <translation>Δεν υπάρχει αναφορά για να μετρηθεί το σφάλμα.</translation>
    </message>
    <message>
        <source>%1 (frame %2 from frame %3 is being fitted)</source>
        <translation>%1 (προσαρμόζεται το καρέ %2 από το καρέ %3)</translation>
    </message>
    <message>
        <source>All as it was fitted</source>
        <translation>Όλα όπως προσαρμόστηκαν</translation>
    </message>
    <message>
        <source>What if: %1</source>
        <translation>Τι αν: %1</translation>
    </message>
    <message>
        <source>other settings</source>
        <translation>άλλες ρυθμίσεις</translation>
    </message>
    <message>
        <source>Iteration; %1</source>
        <translation>Επανάληψη· %1</translation>
    </message>
</context>
<context>
    <name>widgets::InspectProbe</name>
    <message>
        <source>the directions differ</source>
        <translation>οι κατευθύνσεις διαφέρουν</translation>
    </message>
    <message>
        <source>beyond the gate</source>
        <translation>πέρα από το όριο</translation>
    </message>
    <message>
        <source>too far to count</source>
        <translation>πολύ μακριά για να μετρήσει</translation>
    </message>
    <message>
        <source>no outline in this bin</source>
        <translation>κανένα περίγραμμα σε αυτή την κλάση</translation>
    </message>
    <message>
        <source>beyond the end of the hand</source>
        <translation>πέρα από το τέλος του χεριού</translation>
    </message>
</context>
<context>
    <name>widgets::InspectProbeCard</name>
    <message>
        <source>Take the pin away (or click the point once more)</source>
        <translation>Αφαίρεση της καρφίτσας (ή κάντε ξανά κλικ στο σημείο)</translation>
    </message>
    <message>
        <source>Take the pin away</source>
        <translation>Αφαίρεση της καρφίτσας</translation>
    </message>
    <message>
        <source>%1 %2, direction %3</source>
        <translation>%1 %2, κατεύθυνση %3</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Μέθοδος</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Κατεύθυνση</translation>
    </message>
    <message>
        <source>Bin</source>
        <translation>Κλάση</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>κρατήθηκε</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Nearest, px</source>
        <translation>Πλησιέστερο, px</translation>
    </message>
    <message>
        <source>Distance, px</source>
        <translation>Απόσταση, px</translation>
    </message>
    <message>
        <source>Cost, px</source>
        <translation>Κόστος, px</translation>
    </message>
    <message>
        <source>Match</source>
        <translation>Αντιστοιχία</translation>
    </message>
    <message>
        <source>(%1, %2)</source>
        <comment>x and y; told apart where the decimal point is a comma, too</comment>
        <translation>(%1· %2)</translation>
    </message>
    <message>
        <source>What each method would take for the rim point of the pinned view, which looks in the direction above. The arrows of other columns start at rim points of their own, which may look elsewhere.</source>
        <translation>Τι θα έπαιρνε κάθε μέθοδος για το σημείο περιγράμματος της καρφιτσωμένης προβολής, που κοιτά προς την παραπάνω κατεύθυνση. Τα βέλη άλλων στηλών ξεκινούν από δικά τους σημεία, που μπορεί να κοιτούν αλλού.</translation>
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
        <translation>Μέσο σφάλμα ανά άρθρωση</translation>
    </message>
</context>
<context>
    <name>widgets::JointTableModel</name>
    <message>
        <source>done</source>
        <translation>έτοιμη</translation>
    </message>
    <message>
        <source>partial</source>
        <translation>μερική</translation>
    </message>
    <message>
        <source>none</source>
        <comment>state of a joint without marks</comment>
        <translation>κενή</translation>
    </message>
    <message>
        <source>Joint</source>
        <translation>Άρθρωση</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Πρβ.</translation>
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
        <translation>Στάδιο</translation>
    </message>
    <message>
        <source>Joint, in the order in which you work</source>
        <translation>Άρθρωση, με τη σειρά που εργάζεστε</translation>
    </message>
    <message>
        <source>Root mean square distance from click to reprojection, over the views used</source>
        <translation>Μέση τετραγωνική απόσταση (RMS) του κλικ από την επαναπροβολή, στις προβολές που χρησιμοποιούνται</translation>
    </message>
    <message>
        <source>Uncertainty of the 3D joint (standard deviation)</source>
        <translation>Αβεβαιότητα της άρθρωσης 3D (τυπική απόκλιση)</translation>
    </message>
    <message>
        <source>bad</source>
        <translation>κακή</translation>
    </message>
    <message>
        <source>proposed</source>
        <translation>πρόταση</translation>
    </message>
    <message>
        <source>Proposed marks with a likelihood of %1 to %2</source>
        <translation>Προτεινόμενα σημάδια με πιθανότητα %1 έως %2</translation>
    </message>
    <message>
        <source>Views that you clicked + views that you accepted</source>
        <translation>Όψεις με κλικ + όψεις με αποδοχή</translation>
    </message>
    <message>
        <source>Done: every view with a picture is placed or cannot be placed; bad: error above the threshold, an outlier, or no 3D point</source>
        <translation>Έτοιμη: κάθε όψη με εικόνα τοποθετήθηκε ή δεν τοποθετείται· κακή: σφάλμα πάνω από το όριο, ακραία τιμή ή χωρίς σημείο 3D</translation>
    </message>
</context>
<context>
    <name>widgets::MarkLegend</name>
    <message>
        <source>clicked: the 3D joint follows from these</source>
        <translation>με κλικ: από αυτά προκύπτει η άρθρωση 3D</translation>
    </message>
    <message>
        <source>accepted as it was placed for you</source>
        <translation>αποδεκτό όπως προτοποθετήθηκε</translation>
    </message>
    <message>
        <source>occluded, estimated</source>
        <translation>καλυμμένο, εκτίμηση</translation>
    </message>
    <message>
        <source>contradicts the other views</source>
        <translation>αντιφάσκει με τις άλλες όψεις</translation>
    </message>
    <message>
        <source>square: right hand; round: left hand</source>
        <translation>τετράγωνο: δεξί χέρι· κύκλος: αριστερό</translation>
    </message>
    <message>
        <source>What the marks mean</source>
        <translation>Τι σημαίνουν τα σημάδια</translation>
    </message>
    <message>
        <source>proposed: not a label until it is accepted</source>
        <translation>πρόταση: δεν μετρά ως σημάδι πριν από την αποδοχή</translation>
    </message>
</context>
<context>
    <name>widgets::MarkPresenter</name>
    <message>
        <source>%1%2 frames</source>
        <translation>%1%2 καρέ</translation>
    </message>
    <message>
        <source>cannot be placed</source>
        <translation>δεν τοποθετείται</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>no picture</source>
        <translation>χωρίς εικόνα</translation>
    </message>
    <message>
        <source>off %1&apos;s curve</source>
        <translation>έξω από την καμπύλη της %1</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>αποδεκτό</translation>
    </message>
    <message>
        <source>proposed</source>
        <translation>πρόταση</translation>
    </message>
    <message>
        <source>click here next</source>
        <translation>κλικ εδώ μετά</translation>
    </message>
</context>
<context>
    <name>widgets::MaskAttacher</name>
    <message>
        <source>Open a dataset first.</source>
        <translation>Ανοίξτε πρώτα ένα σύνολο δεδομένων.</translation>
    </message>
</context>
<context>
    <name>widgets::MatchLook</name>
    <message>
        <source>thumb</source>
        <translation>αντίχειρας</translation>
    </message>
    <message>
        <source>index</source>
        <translation>δείκτης</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>μέσος</translation>
    </message>
    <message>
        <source>ring</source>
        <translation>παράμεσος</translation>
    </message>
    <message>
        <source>little</source>
        <translation>μικρός</translation>
    </message>
    <message>
        <source>palm</source>
        <translation>παλάμη</translation>
    </message>
    <message>
        <source>All, by distance</source>
        <translation>Όλες, κατά απόσταση</translation>
    </message>
    <message>
        <source>All, by finger</source>
        <translation>Όλες, κατά δάχτυλο</translation>
    </message>
    <message>
        <source>Only: %1</source>
        <translation>Μόνο: %1</translation>
    </message>
</context>
<context>
    <name>widgets::MessageBar</name>
    <message>
        <source>Dismiss</source>
        <translation>Απόρριψη</translation>
    </message>
</context>
<context>
    <name>widgets::MethodForm</name>
    <message>
        <source>More options</source>
        <translation>Άλλες επιλογές</translation>
    </message>
    <message>
        <source>The options that are seldom changed</source>
        <translation>Οι επιλογές που αλλάζουν σπάνια</translation>
    </message>
    <message>
        <source>usual</source>
        <translation>συνήθης</translation>
    </message>
</context>
<context>
    <name>widgets::MethodText</name>
    <message>
        <source>A match is kept if the directions differ by less, degrees</source>
        <translation>Μια αντιστοιχία διατηρείται αν οι κατευθύνσεις διαφέρουν λιγότερο, μοίρες</translation>
    </message>
    <message>
        <source>Directions over 360 degrees; off: lines over 180 degrees</source>
        <translation>Κατευθύνσεις σε 360 μοίρες· ανενεργό: ευθείες σε 180 μοίρες</translation>
    </message>
    <message>
        <source>Weight of the direction, pixels per radian</source>
        <translation>Βάρος της κατεύθυνσης, πίξελ ανά ακτίνιο</translation>
    </message>
    <message>
        <source>Bins of direction</source>
        <translation>Κλάσεις κατεύθυνσης</translation>
    </message>
    <message>
        <source>Where the bins are centred: 0 on the x axis, or that share of a bin beside it</source>
        <translation>Πού έχουν κέντρο οι κλάσεις: 0 στον άξονα x, ή τόσο μέρος μιας κλάσης δίπλα του</translation>
    </message>
    <message>
        <source>The two matches weigh by how near their bins are</source>
        <translation>Οι δύο αντιστοιχίες ζυγίζουν ανάλογα με το πόσο κοντά είναι οι κλάσεις τους</translation>
    </message>
    <message>
        <source>How matches are searched: both find the same ones</source>
        <translation>Πώς αναζητούνται οι αντιστοιχίες: και οι δύο τρόποι βρίσκουν τις ίδιες</translation>
    </message>
    <message>
        <source>The real-time variant</source>
        <translation>Η παραλλαγή πραγματικού χρόνου</translation>
    </message>
    <message>
        <source>The palm is placed before the fingers move</source>
        <translation>Η παλάμη τοποθετείται πριν κινηθούν τα δάχτυλα</translation>
    </message>
    <message>
        <source>Coarse levels of the mesh first</source>
        <translation>Πρώτα τα αδρά επίπεδα του πλέγματος</translation>
    </message>
    <message>
        <source>Tau narrows from 45 degrees to 22.5</source>
        <translation>Το ταυ στενεύει από 45 σε 22,5 μοίρες</translation>
    </message>
    <message>
        <source>The distance along the outline counts a tenth</source>
        <translation>Η απόσταση κατά μήκος του περιγράμματος μετρά κατά ένα δέκατο</translation>
    </message>
    <message>
        <source>A weak pull of the angles to those of the start</source>
        <translation>Ασθενής έλξη των γωνιών προς εκείνες της αρχής</translation>
    </message>
    <message>
        <source>The pull knows how fingers move together</source>
        <translation>Η έλξη γνωρίζει πώς κινούνται μαζί τα δάχτυλα</translation>
    </message>
    <message>
        <source>Other starts where silhouettes are left unexplained</source>
        <translation>Άλλες αρχές όπου οι σιλουέτες μένουν ανεξήγητες</translation>
    </message>
    <message>
        <source>The last iterations on the full mesh</source>
        <translation>Οι τελευταίες επαναλήψεις στο πλήρες πλέγμα</translation>
    </message>
    <message>
        <source>What counts as a difference follows the noise of the outlines</source>
        <translation>Το τι θεωρείται διαφορά ακολουθεί τον θόρυβο των περιγραμμάτων</translation>
    </message>
    <message>
        <source>Contour points pull the model, too</source>
        <translation>Και τα σημεία περιγράμματος έλκουν το μοντέλο</translation>
    </message>
    <message>
        <source>Only contour points within tau are searched</source>
        <translation>Αναζητούνται μόνο σημεία περιγράμματος εντός του ταυ</translation>
    </message>
    <message>
        <source>Cauchy weights with that scale, mm; 0 for none</source>
        <translation>Βάρη Cauchy με αυτή την κλίμακα, mm· 0 για κανένα</translation>
    </message>
    <message>
        <source>Longest distance of a match, pixels; 0 for the usual one</source>
        <translation>Μέγιστη απόσταση αντιστοιχίας, πίξελ· 0 για τη συνήθη</translation>
    </message>
    <message>
        <source>K of the truncated penalty, square pixels; 0 for none</source>
        <translation>K της περικομμένης ποινής, τετραγωνικά πίξελ· 0 για καμία</translation>
    </message>
    <message>
        <source>How far the outline&apos;s polygon may be off, pixels</source>
        <translation>Πόσο μπορεί να αποκλίνει το πολύγωνο του περιγράμματος, πίξελ</translation>
    </message>
    <message>
        <source>The outline&apos;s direction from its polygon or from a chord</source>
        <translation>Η κατεύθυνση του περιγράμματος από το πολύγωνό του ή από μια χορδή</translation>
    </message>
    <message>
        <source>Contour beyond the end of a hand model: left out, or as any other</source>
        <translation>Περίγραμμα πέρα από το τέλος ενός μοντέλου χεριού: παραλείπεται ή όπως κάθε άλλο</translation>
    </message>
    <message>
        <source>Most iterations of a fit</source>
        <translation>Μέγιστες επαναλήψεις μιας προσαρμογής</translation>
    </message>
    <message>
        <source>Damping relative to the diagonal of the normal matrix</source>
        <translation>Απόσβεση σε σχέση με τη διαγώνιο του κανονικού πίνακα</translation>
    </message>
    <message>
        <source>rigid: a first phase moves each hand as a whole; paper: all at once</source>
        <translation>rigid: μια πρώτη φάση κινεί κάθε χέρι ως σύνολο· paper: όλα μαζί</translation>
    </message>
    <message>
        <source>%1 must be %2 or %3, not &quot;%4&quot;.</source>
        <translation>Το %1 πρέπει να είναι %2 ή %3, όχι «%4».</translation>
    </message>
    <message>
        <source>%1 must be a whole number from %2 to %3, not &quot;%4&quot;.</source>
        <translation>Το %1 πρέπει να είναι ακέραιος από %2 έως %3, όχι «%4».</translation>
    </message>
    <message>
        <source>%1 must be a number from %2 to %3, not &quot;%4&quot;.</source>
        <translation>Το %1 πρέπει να είναι αριθμός από %2 έως %3, όχι «%4».</translation>
    </message>
    <message>
        <source>Write &quot;%1&quot; as name=value.</source>
        <translation>Γράψτε το «%1» ως όνομα=τιμή.</translation>
    </message>
    <message>
        <source>%1 has no option &quot;%2&quot;; it has %3.</source>
        <translation>Η %1 δεν έχει επιλογή «%2»· έχει %3.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a method; the methods are %2.</source>
        <translation>Το «%1» δεν είναι μέθοδος· οι μέθοδοι είναι %2.</translation>
    </message>
    <message>
        <source>Fingers and hands do not penetrate each other on the way from other starts</source>
        <translation>Δάχτυλα και χέρια δεν διαπερνούν το ένα το άλλο στην πορεία από άλλες αρχές</translation>
    </message>
</context>
<context>
    <name>widgets::NameBar</name>
    <message>
        <source>Use this name</source>
        <translation>Χρήση αυτού του ονόματος</translation>
    </message>
    <message>
        <source>Your marks are kept under your &amp;name:</source>
        <translation>Τα σημάδια σας φυλάσσονται με το &amp;όνομα:</translation>
    </message>
</context>
<context>
    <name>widgets::NoteEdit</name>
    <message>
        <source>Note on this frame</source>
        <translation>Σημείωση για αυτό το καρέ</translation>
    </message>
</context>
<context>
    <name>widgets::OtherMarks</name>
    <message>
        <source>%1 has %2 in %3 of this sequence.</source>
        <translation>Ο χρήστης %1 έχει %2 σε %3 αυτής της ακολουθίας.</translation>
    </message>
    <message numerus="yes">
        <source>%n mark(s)</source>
        <translation>
            <numerusform>%n σημάδι</numerusform>
            <numerusform>%n σημάδια</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s)</source>
        <translation>
            <numerusform>%n καρέ</numerusform>
            <numerusform>%n καρέ</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>widgets::PairFilterText</name>
    <message>
        <source>“%1” is neither a method of these results nor sequence, start, test, difference or initial.</source>
        <translation>Το «%1» δεν είναι ούτε μέθοδος αυτών των αποτελεσμάτων ούτε sequence, start, test, difference ή initial.</translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation>Το «%1» δεν είναι αριθμός.</translation>
    </message>
    <message>
        <source>“%1” is neither a comparison such as A-B&gt;1 nor a sequence.</source>
        <translation>Το «%1» δεν είναι ούτε σύγκριση όπως A-B&gt;1 ούτε ακολουθία.</translation>
    </message>
    <message>
        <source>Conditions with blanks between them, all of which must hold: A-B&gt;1 difference&gt;=10 sequence=01. A and B are the methods chosen on the left; a method&apos;s name is its error in mm, .seconds or .iterations behind it what it took; start, test and difference are frames, initial is the error of the start pose.</source>
        <translation>Συνθήκες χωρισμένες με κενά, που πρέπει να ισχύουν όλες: A-B&gt;1 difference&gt;=10 sequence=01. A και B είναι οι μέθοδοι που επιλέχθηκαν αριστερά· το όνομα μιας μεθόδου είναι το σφάλμα της σε mm, με .seconds ή .iterations πίσω του όσα χρειάστηκε· start, test και difference είναι καρέ, initial είναι το σφάλμα της αρχικής πόζας.</translation>
    </message>
</context>
<context>
    <name>widgets::PairTableModel</name>
    <message>
        <source>Sequence</source>
        <translation>Ακολουθία</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Αρχή</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>Δοκιμή</translation>
    </message>
    <message>
        <source>Start mm</source>
        <translation>Αρχή mm</translation>
    </message>
    <message>
        <source>Apart</source>
        <translation>Απόσταση</translation>
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
        <translation>%1 επαναλήψεις</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Frames between start and test</source>
        <translation>Καρέ ανάμεσα στην αρχή και τη δοκιμή</translation>
    </message>
    <message>
        <source>Mean joint error of the start pose</source>
        <translation>Μέσο σφάλμα αρθρώσεων της αρχικής πόζας</translation>
    </message>
    <message>
        <source>Mean joint error of %1; the smallest of a row is bold</source>
        <translation>Μέσο σφάλμα αρθρώσεων της %1· το μικρότερο μιας γραμμής είναι έντονο</translation>
    </message>
    <message>
        <source>Error of %1 minus error of %2: above 0 where %1 is worse</source>
        <translation>Σφάλμα της %1 μείον σφάλμα της %2: πάνω από 0 όπου η %1 είναι χειρότερη</translation>
    </message>
</context>
<context>
    <name>widgets::PictureExport</name>
    <message>
        <source>PNG picture (*.png)</source>
        <translation>Εικόνα PNG (*.png)</translation>
    </message>
    <message>
        <source>SVG drawing (*.svg)</source>
        <translation>Σχέδιο SVG (*.svg)</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>Αποθήκευση εικόνας</translation>
    </message>
    <message>
        <source>%1 could not be written. Choose a folder that you may write to.</source>
        <translation>Δεν ήταν δυνατή η εγγραφή του %1. Επιλέξτε έναν φάκελο με δικαίωμα εγγραφής.</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Αντιγραφή εικόνας</translation>
    </message>
    <message>
        <source>Save picture...</source>
        <translation>Αποθήκευση εικόνας...</translation>
    </message>
    <message>
        <source>Saved to %1</source>
        <translation>Αποθηκεύτηκε στο %1</translation>
    </message>
    <message>
        <source>The picture is in the clipboard.</source>
        <translation>Η εικόνα είναι στο πρόχειρο.</translation>
    </message>
    <message>
        <source>PDF page (*.pdf)</source>
        <translation>Σελίδα PDF (*.pdf)</translation>
    </message>
</context>
<context>
    <name>widgets::PlotCanvas</name>
    <message>
        <source>curves</source>
        <translation>καμπύλες</translation>
    </message>
</context>
<context>
    <name>widgets::QualityPanel</name>
    <message>
        <source>Bad above</source>
        <translation>Όριο σφάλματος</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>This frame</source>
        <translation>Αυτό το καρέ</translation>
    </message>
    <message>
        <source>Whole sequence</source>
        <translation>Όλη η ακολουθία</translation>
    </message>
    <message>
        <source>Nothing stands out in this sequence.</source>
        <translation>Τίποτα δεν ξεχωρίζει σε αυτή την ακολουθία.</translation>
    </message>
    <message>
        <source>Nothing stands out in this frame.</source>
        <translation>Τίποτα δεν ξεχωρίζει σε αυτό το καρέ.</translation>
    </message>
    <message>
        <source>No frame of this sequence has marks yet.</source>
        <translation>Κανένα καρέ αυτής της ακολουθίας δεν έχει ακόμα σημάδια.</translation>
    </message>
    <message>
        <source>Joints: %1 done, %2 partial, %3 bad.</source>
        <translation>Αρθρώσεις: %1 έτοιμες, %2 μερικές, %3 προβληματικές.</translation>
    </message>
    <message>
        <source>Your clicks scatter by %1 px per axis.</source>
        <translation>Διασπορά των κλικ σας: %1 px ανά άξονα.</translation>
    </message>
    <message>
        <source>Where to look for findings</source>
        <translation>Πού αναζητούνται ευρήματα</translation>
    </message>
    <message>
        <source>No frame has marks of yours (%1) yet.</source>
        <translation>Κανένα καρέ δεν έχει ακόμη δικά σας σημάδια (%1).</translation>
    </message>
    <message numerus="yes">
        <source>%n proposed mark(s) wait to be checked.</source>
        <translation>
            <numerusform>%n προτεινόμενο σημάδι περιμένει έλεγχο.</numerusform>
            <numerusform>%n προτεινόμενα σημάδια περιμένουν έλεγχο.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) with marks of %1.</source>
        <translation>
            <numerusform>%n καρέ με σημάδια του %1.</numerusform>
            <numerusform>%n καρέ με σημάδια του %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Κάμερες</translation>
    </message>
    <message>
        <source>Too few clicks to know how far yours scatter: 1 px is assumed.</source>
        <translation>Πολύ λίγα κλικ για να είναι γνωστή η διασπορά των δικών σας: θεωρείται 1 px.</translation>
    </message>
</context>
<context>
    <name>widgets::RatersPanel</name>
    <message>
        <source>No two raters have marked the same joint. Start a repeat round to see how far you agree with yourself.</source>
        <translation>Δεν υπάρχουν δύο αξιολογητές με σημάδια στην ίδια άρθρωση. Ξεκινήστε έναν γύρο επανάληψης για να δείτε πόσο συμφωνείτε με τον εαυτό σας.</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Επόμενη</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Σύγκριση</translation>
    </message>
    <message>
        <source>Compares all raters as they stand now</source>
        <translation>Συγκρίνει όλους τους αξιολογητές με τα τωρινά δεδομένα</translation>
    </message>
    <message numerus="yes">
        <source>%n shared click(s), %1 px apart (RMS)</source>
        <translation>
            <numerusform>%n κοινό κλικ, απόσταση %1 px (RMS)</numerusform>
            <numerusform>%n κοινά κλικ, απόσταση %1 px (RMS)</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 scatters by %2 px per axis</source>
        <translation>%1: διασπορά %2 px ανά άξονα</translation>
    </message>
    <message>
        <source>End the round</source>
        <translation>Τέλος του γύρου</translation>
    </message>
    <message>
        <source>Start a repeat round</source>
        <translation>Έναρξη γύρου επανάληψης</translation>
    </message>
    <message>
        <source>Back to your own marks; both rounds are compared</source>
        <translation>Επιστροφή στα δικά σας σημάδια· συγκρίνονται και οι δύο γύροι</translation>
    </message>
    <message>
        <source>Repeat round: %1 of %2 joints are left.</source>
        <translation>Γύρος επανάληψης: απομένουν %1 από %2 αρθρώσεις.</translation>
    </message>
    <message numerus="yes">
        <source>All raters together: %1 ± %2 mm, from %n click(s).</source>
        <translation>
            <numerusform>Όλοι οι αξιολογητές μαζί: %1 ± %2 mm, από %n κλικ.</numerusform>
            <numerusform>Όλοι οι αξιολογητές μαζί: %1 ± %2 mm, από %n κλικ.</numerusform>
        </translation>
    </message>
    <message>
        <source>Your 3D joint lies %1 mm from it.</source>
        <translation>Η δική σας 3D άρθρωση απέχει %1 mm.</translation>
    </message>
    <message>
        <source>A random tenth of your finished joints, your first marks hidden: how well do you repeat yourself?</source>
        <translation>Ένα τυχαίο δέκατο των έτοιμων αρθρώσεών σας, με τα πρώτα σημάδια κρυμμένα: πόσο καλά επαναλαμβάνετε τον εαυτό σας;</translation>
    </message>
    <message>
        <source>To the next joint of the round that is not marked yet</source>
        <translation>Στην επόμενη άρθρωση του γύρου που δεν έχει σημειωθεί ακόμη</translation>
    </message>
    <message>
        <source>Your first marks are hidden until the round has ended.</source>
        <translation>Τα πρώτα σημάδια σας είναι κρυμμένα μέχρι να τελειώσει ο γύρος.</translation>
    </message>
    <message>
        <source>%1 has too few clicks to know how far they scatter</source>
        <translation>%1: πολύ λίγα κλικ για να είναι γνωστή η διασπορά τους</translation>
    </message>
</context>
<context>
    <name>widgets::RefinementModel</name>
    <message>
        <source>Camera</source>
        <translation>Κάμερα</translation>
    </message>
    <message>
        <source>Clicks</source>
        <translation>Κλικ</translation>
    </message>
    <message>
        <source>px before</source>
        <translation>px πριν</translation>
    </message>
    <message>
        <source>px after</source>
        <translation>px μετά</translation>
    </message>
    <message>
        <source>turned, °</source>
        <translation>στροφή, °</translation>
    </message>
    <message>
        <source>moved, mm</source>
        <translation>μετατόπιση, mm</translation>
    </message>
    <message>
        <source>focal, %</source>
        <translation>εστιακή, %</translation>
    </message>
    <message>
        <source>RMS of its clicks with the calibration in use</source>
        <translation>RMS των κλικ της με τη βαθμονόμηση σε χρήση</translation>
    </message>
    <message>
        <source>RMS of its clicks with the refined calibration</source>
        <translation>RMS των κλικ της με τη βελτιωμένη βαθμονόμηση</translation>
    </message>
    <message>
        <source>By how much the camera turns</source>
        <translation>Πόσο στρέφεται η κάμερα</translation>
    </message>
    <message>
        <source>By how much the camera&apos;s centre moves</source>
        <translation>Πόσο μετατοπίζεται το κέντρο της κάμερας</translation>
    </message>
    <message>
        <source>By how much its focal length grows</source>
        <translation>Πόσο αυξάνεται η εστιακή της απόσταση</translation>
    </message>
</context>
<context>
    <name>widgets::RefinementPage</name>
    <message>
        <source>Refine</source>
        <translation>Βελτίωση</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Διακοπή</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Απόρριψη</translation>
    </message>
    <message>
        <source>Use the refined calibration</source>
        <translation>Χρήση της βελτιωμένης βαθμονόμησης</translation>
    </message>
    <message>
        <source>Use the chosen one</source>
        <translation>Χρήση της επιλεγμένης</translation>
    </message>
    <message>
        <source>Adjusts every camera&apos;s place, direction, focal length and first lens coefficients to all clicks of the dataset</source>
        <translation>Προσαρμόζει θέση, κατεύθυνση, εστιακή απόσταση και πρώτους συντελεστές φακού κάθε κάμερας σε όλα τα κλικ του συνόλου</translation>
    </message>
    <message>
        <source>Writes a new calibration file beside the one in use, which is kept; all joints are reconstructed anew</source>
        <translation>Γράφει νέο αρχείο βαθμονόμησης δίπλα στο τρέχον, που διατηρείται· όλες οι αρθρώσεις ανακατασκευάζονται</translation>
    </message>
    <message>
        <source>The dataset uses that calibration from now on; marks stay as they are</source>
        <translation>Το σύνολο χρησιμοποιεί στο εξής αυτή τη βαθμονόμηση· τα σημάδια μένουν ως έχουν</translation>
    </message>
    <message>
        <source>Calibrations of this dataset</source>
        <translation>Βαθμονομήσεις αυτού του συνόλου</translation>
    </message>
    <message>
        <source>Refine the calibration first.</source>
        <translation>Βελτιώστε πρώτα τη βαθμονόμηση.</translation>
    </message>
    <message>
        <source>The clicks of all sequences are being looked at.</source>
        <translation>Εξετάζονται τα κλικ όλων των ακολουθιών.</translation>
    </message>
    <message>
        <source>Refined from %1 joints in %2 frames. A click scatters by %3 px per axis about the refined cameras.</source>
        <translation>Βελτίωση από %1 αρθρώσεις σε %2 καρέ. Διασπορά κλικ γύρω από τις βελτιωμένες κάμερες: %3 px ανά άξονα.</translation>
    </message>
    <message numerus="yes">
        <source>%n wrong click(s) took no part.</source>
        <translation>
            <numerusform>%n λανθασμένο κλικ δεν λήφθηκε υπόψη.</numerusform>
            <numerusform>%n λανθασμένα κλικ δεν λήφθηκαν υπόψη.</numerusform>
        </translation>
    </message>
    <message>
        <source>The adjustment stopped before it had settled.</source>
        <translation>Η προσαρμογή σταμάτησε πριν συγκλίνει.</translation>
    </message>
    <message>
        <source>%1 (in use)</source>
        <translation>%1 (σε χρήση)</translation>
    </message>
    <message>
        <source>Distances and shapes will be as good as the clicks; the world as a whole stays where it was, known to %1 mm.</source>
        <translation>Αποστάσεις και σχήματα θα είναι όσο καλά είναι τα κλικ· ο κόσμος ως σύνολο μένει όπου ήταν, γνωστός με ακρίβεια %1 mm.</translation>
    </message>
</context>
<context>
    <name>widgets::ResultTableModel</name>
    <message>
        <source>Converged</source>
        <translation>Συνέκλινε</translation>
    </message>
    <message>
        <source>Stopped at the iteration limit</source>
        <translation>Σταμάτησε στο μέγιστο πλήθος επαναλήψεων</translation>
    </message>
    <message>
        <source>No matches were left</source>
        <translation>Δεν έμειναν αντιστοιχίες</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Διακόπηκε</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>απέτυχε</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Μέθοδος</translation>
    </message>
    <message>
        <source>Start mm</source>
        <translation>Αρχή mm</translation>
    </message>
    <message>
        <source>Error mm</source>
        <translation>Σφάλμα mm</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Επαναλ.</translation>
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
        <translation>Λόγος</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Καρέ</translation>
    </message>
    <message>
        <source>Doubt, %</source>
        <translation>Αμφιβολία, %</translation>
    </message>
    <message>
        <source>Near</source>
        <translation>Κοντά</translation>
    </message>
    <message>
        <source>Why the frame deserves a look</source>
        <translation>Γιατί το καρέ αξίζει έλεγχο</translation>
    </message>
    <message>
        <source>0: sure, 100: lost; of the more doubtful hand</source>
        <translation>0: βέβαιο, 100: χαμένο· του πιο αμφίβολου χεριού</translation>
    </message>
    <message>
        <source>Doubtful frames around that a corrected one helps</source>
        <translation>Αμφίβολα καρέ γύρω που ωφελεί η διόρθωσή του</translation>
    </message>
</context>
<context>
    <name>widgets::ReviewPanel</name>
    <message>
        <source>Accept</source>
        <translation>Αποδοχή</translation>
    </message>
    <message>
        <source>Correct</source>
        <translation>Διόρθωση</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Επόμενο</translation>
    </message>
    <message>
        <source>First pass...</source>
        <translation>Πρώτο πέρασμα...</translation>
    </message>
    <message>
        <source>No frame waits for a look.</source>
        <translation>Κανένα καρέ δεν περιμένει έλεγχο.</translation>
    </message>
    <message>
        <source>Frames that the first pass has labelled wait here for a look, doubtful ones first.</source>
        <translation>Τα καρέ που σημείωσε το πρώτο πέρασμα περιμένουν εδώ έλεγχο, πρώτα τα αμφίβολα.</translation>
    </message>
</context>
<context>
    <name>widgets::ReviewText</name>
    <message>
        <source>quite sure; left hand first</source>
        <translation>αρκετά βέβαιο· πρώτα το αριστερό χέρι</translation>
    </message>
    <message>
        <source>quite sure; right hand first</source>
        <translation>αρκετά βέβαιο· πρώτα το δεξί χέρι</translation>
    </message>
    <message>
        <source>views do not agree on the left hand</source>
        <translation>οι προβολές δεν συμφωνούν για το αριστερό χέρι</translation>
    </message>
    <message>
        <source>views do not agree on the right hand</source>
        <translation>οι προβολές δεν συμφωνούν για το δεξί χέρι</translation>
    </message>
    <message>
        <source>%1: its bone is %2 % longer than usual</source>
        <translation>%1: το οστό είναι %2 % μακρύτερο από το συνηθισμένο</translation>
    </message>
    <message>
        <source>%1: its bone is %2 % shorter than usual</source>
        <translation>%1: το οστό είναι %2 % κοντύτερο από το συνηθισμένο</translation>
    </message>
    <message>
        <source>the left hand was not found</source>
        <translation>το αριστερό χέρι δεν βρέθηκε</translation>
    </message>
    <message>
        <source>the right hand was not found</source>
        <translation>το δεξί χέρι δεν βρέθηκε</translation>
    </message>
    <message numerus="yes">
        <source>%n joint(s) of the left hand missing</source>
        <translation>
            <numerusform>λείπει %n άρθρωση του αριστερού χεριού</numerusform>
            <numerusform>λείπουν %n αρθρώσεις του αριστερού χεριού</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n joint(s) of the right hand missing</source>
        <translation>
            <numerusform>λείπει %n άρθρωση του δεξιού χεριού</numerusform>
            <numerusform>λείπουν %n αρθρώσεις του δεξιού χεριού</numerusform>
        </translation>
    </message>
    <message>
        <source>the left hand jumps by %1 mm</source>
        <translation>το αριστερό χέρι κάνει άλμα %1 mm</translation>
    </message>
    <message>
        <source>the right hand jumps by %1 mm</source>
        <translation>το δεξί χέρι κάνει άλμα %1 mm</translation>
    </message>
    <message>
        <source>First pass, detecting: %1 of %2</source>
        <translation>Πρώτο πέρασμα, ανίχνευση: %1 από %2</translation>
    </message>
    <message>
        <source>First pass, measuring hands: %1 of %2</source>
        <translation>Πρώτο πέρασμα, μέτρηση χεριών: %1 από %2</translation>
    </message>
    <message>
        <source>First pass, fitting: %1 of %2</source>
        <translation>Πρώτο πέρασμα, προσαρμογή: %1 από %2</translation>
    </message>
    <message>
        <source>First pass, tracking: %1 of %2</source>
        <translation>Πρώτο πέρασμα, παρακολούθηση: %1 από %2</translation>
    </message>
    <message numerus="yes">
        <source>All %n frame(s) are reviewed.</source>
        <translation>
            <numerusform>Το %n καρέ ελέγχθηκε.</numerusform>
            <numerusform>Και τα %n καρέ ελέγχθηκαν.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n frame(s) left, </source>
        <translation>
            <numerusform>Απομένει %n καρέ, </numerusform>
            <numerusform>Απομένουν %n καρέ, </numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of them doubtful; %2 reviewed.</source>
        <translation>από αυτά %1 αμφίβολα· %2 ελεγμένα.</translation>
    </message>
    <message>
        <source>Error to be expected of those left: %1 mm a joint, as far as reviewed ones tell.</source>
        <translation>Αναμενόμενο σφάλμα όσων απομένουν: %1 mm ανά άρθρωση, όπως δείχνουν τα ελεγμένα.</translation>
    </message>
    <message>
        <source>The error of those left is known once three frames are reviewed.</source>
        <translation>Το σφάλμα όσων απομένουν γίνεται γνωστό μετά τον έλεγχο τριών καρέ.</translation>
    </message>
    <message>
        <source>The error of those left is not known until a joint was corrected.</source>
        <translation>Το σφάλμα των υπολοίπων δεν είναι γνωστό μέχρι να διορθωθεί μια άρθρωση.</translation>
    </message>
</context>
<context>
    <name>widgets::RigDrawing</name>
    <message>
        <source>The cameras of the calibration, and where they look. Drag to turn, wheel to zoom.</source>
        <translation>Οι κάμερες της βαθμονόμησης και πού κοιτούν. Σύρετε για περιστροφή, τροχός για ζουμ.</translation>
    </message>
    <message>
        <source>The cameras appear here once the calibration is read.</source>
        <translation>Οι κάμερες εμφανίζονται εδώ μόλις διαβαστεί η βαθμονόμηση.</translation>
    </message>
</context>
<context>
    <name>widgets::RigHealthModel</name>
    <message numerus="yes">
        <source>%1: %n click(s) that other cameras confirm are too few to judge it</source>
        <translation>
            <numerusform>%1: %n κλικ που επιβεβαιώνουν άλλες κάμερες δεν αρκεί για να κριθεί</numerusform>
            <numerusform>%1: %n κλικ που επιβεβαιώνουν άλλες κάμερες δεν αρκούν για να κριθεί</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: mean %2, %3 ± %4 px; clicks scatter by %5 px about it; %n wrong click(s)</source>
        <translation>
            <numerusform>%1: μέση τιμή (%2· %3) ± %4 px· διασπορά κλικ γύρω της %5 px· %n λανθασμένο κλικ</numerusform>
            <numerusform>%1: μέση τιμή (%2· %3) ± %4 px· διασπορά κλικ γύρω της %5 px· %n λανθασμένα κλικ</numerusform>
        </translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Κάμερα</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Κατάσταση</translation>
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
        <translation>Κλικ που επιβεβαιώνουν άλλες κάμερες</translation>
    </message>
    <message>
        <source>RMS residual, px</source>
        <translation>Κατάλοιπο (RMS), px</translation>
    </message>
    <message>
        <source>Mean residual to the right, px; the joint is made from the other cameras</source>
        <translation>Μέσο κατάλοιπο προς τα δεξιά, px· η άρθρωση προκύπτει από τις άλλες κάμερες</translation>
    </message>
    <message>
        <source>Mean residual downwards, px; the joint is made from the other cameras</source>
        <translation>Μέσο κατάλοιπο προς τα κάτω, px· η άρθρωση προκύπτει από τις άλλες κάμερες</translation>
    </message>
    <message>
        <source>Clicks and calibration error together, per axis, px: what a click is worth</source>
        <translation>Κλικ και σφάλμα βαθμονόμησης μαζί, ανά άξονα, px: πόσο αξίζει ένα κλικ</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>άγνωστο</translation>
    </message>
    <message>
        <source>Two cameras cannot tell which of them is off.</source>
        <translation>Δύο κάμερες δεν δείχνουν ποια από τις δύο είναι λάθος.</translation>
    </message>
</context>
<context>
    <name>widgets::RigHealthView</name>
    <message>
        <source>Refine calibration...</source>
        <translation>Βελτίωση βαθμονόμησης...</translation>
    </message>
    <message>
        <source>Adjusts the cameras to the clicks; nothing changes before you use the result</source>
        <translation>Προσαρμόζει τις κάμερες στα κλικ· τίποτα δεν αλλάζει πριν χρησιμοποιήσετε το αποτέλεσμα</translation>
    </message>
    <message>
        <source>The clicks of all sequences are being looked at.</source>
        <translation>Εξετάζονται τα κλικ όλων των ακολουθιών.</translation>
    </message>
    <message>
        <source>No joint is clicked in two cameras yet: the calibration cannot be judged.</source>
        <translation>Καμία άρθρωση δεν έχει ακόμη κλικ σε δύο κάμερες: η βαθμονόμηση δεν μπορεί να κριθεί.</translation>
    </message>
    <message>
        <source>There are too few clicks to judge the calibration.</source>
        <translation>Τα κλικ είναι πολύ λίγα για να κριθεί η βαθμονόμηση.</translation>
    </message>
</context>
<context>
    <name>widgets::RigText</name>
    <message>
        <source>%1 of %2 cameras are %3 to %4 px off in every frame: the calibration as a whole does not fit the clicks.</source>
        <translation>%1 από %2 κάμερες αποκλίνουν %3 έως %4 px σε κάθε καρέ: η βαθμονόμηση συνολικά δεν ταιριάζει με τα κλικ.</translation>
    </message>
    <message numerus="yes">
        <source>%1 is %2 px off in the %n sequence(s) %3 only: it stood otherwise there.</source>
        <translation>
            <numerusform>Η %1 αποκλίνει %2 px μόνο στην ακολουθία %3: εκεί ήταν στημένη αλλιώς.</numerusform>
            <numerusform>Η %1 αποκλίνει %2 px μόνο στις %n ακολουθίες %3: εκεί ήταν στημένη αλλιώς.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is %2 frames behind the others: its residuals go with the joints&apos; motion.</source>
        <translation>Η %1 είναι %2 καρέ πίσω από τις άλλες: τα κατάλοιπά της ακολουθούν την κίνηση των αρθρώσεων.</translation>
    </message>
    <message>
        <source>%1 is %2 frames ahead of the others: its residuals go with the joints&apos; motion.</source>
        <translation>Η %1 είναι %2 καρέ μπροστά από τις άλλες: τα κατάλοιπά της ακολουθούν την κίνηση των αρθρώσεων.</translation>
    </message>
    <message>
        <source>%1 is %2 px off in every frame: its calibration moved.</source>
        <translation>Η %1 αποκλίνει %2 px σε κάθε καρέ: η βαθμονόμησή της μετατοπίστηκε.</translation>
    </message>
    <message>
        <source>%1 moved before frame %2 of sequence %3: its picture lies %4 px elsewhere from there on.</source>
        <translation>Η %1 μετακινήθηκε πριν από το καρέ %2 της ακολουθίας %3: από εκεί και πέρα η εικόνα της απέχει %4 px.</translation>
    </message>
    <message>
        <source>%1 drifts by %2 px in 100 frames of sequence %3.</source>
        <translation>Η %1 ολισθαίνει κατά %2 px σε 100 καρέ της ακολουθίας %3.</translation>
    </message>
    <message>
        <source>Clicks of %1: too few to know how far they scatter; 1 px is assumed.</source>
        <translation>Κλικ του %1: πολύ λίγα για να είναι γνωστή η διασπορά τους· θεωρείται 1 px.</translation>
    </message>
    <message>
        <source>Clicks of %1 scatter by %2 px per axis (%3 to %4 by camera).</source>
        <translation>Διασπορά των κλικ του %1: %2 px ανά άξονα (%3 έως %4 ανά κάμερα).</translation>
    </message>
    <message>
        <source>Too few clicks that other cameras confirm: %1.</source>
        <translation>Πολύ λίγα κλικ που επιβεβαιώνουν άλλες κάμερες: %1.</translation>
    </message>
    <message>
        <source>The calibration&apos;s own error adds %1 to %2 px.</source>
        <translation>Το σφάλμα της ίδιας της βαθμονόμησης προσθέτει %1 έως %2 px.</translation>
    </message>
    <message>
        <source>too few clicks</source>
        <translation>πολύ λίγα κλικ</translation>
    </message>
    <message>
        <source>off</source>
        <translation>αποκλίνει</translation>
    </message>
    <message>
        <source>partly off</source>
        <translation>αποκλίνει εν μέρει</translation>
    </message>
    <message>
        <source>late</source>
        <translation>καθυστερεί</translation>
    </message>
    <message>
        <source>early</source>
        <translation>προηγείται</translation>
    </message>
    <message>
        <source>moved</source>
        <translation>μετακινήθηκε</translation>
    </message>
    <message>
        <source>drifts</source>
        <translation>ολισθαίνει</translation>
    </message>
    <message>
        <source>fits</source>
        <translation>ταιριάζει</translation>
    </message>
    <message>
        <source>Cameras can be refined from %1 joints on that three cameras or more have clicked (%2 so far).</source>
        <translation>Οι κάμερες βελτιώνονται από %1 αρθρώσεις και πάνω με κλικ σε τουλάχιστον τρεις κάμερες (ως τώρα %2).</translation>
    </message>
    <message>
        <source>The calibration fits the clicks.</source>
        <translation>Η βαθμονόμηση ταιριάζει με τα κλικ.</translation>
    </message>
    <message>
        <source>Refining is worth it from %1 frames and %2 joints on (%3 and %4 so far).</source>
        <translation>Η βελτίωση αξίζει από %1 καρέ και %2 αρθρώσεις και πάνω (ως τώρα %3 και %4).</translation>
    </message>
    <message>
        <source>There are enough clicks to refine the calibration.</source>
        <translation>Τα κλικ αρκούν για βελτίωση της βαθμονόμησης.</translation>
    </message>
    <message>
        <source>Two cameras cannot tell which of them is off: a refinement needs three.</source>
        <translation>Με δύο κάμερες δεν φαίνεται ποια αποκλίνει: μια βελτίωση χρειάζεται τρεις.</translation>
    </message>
</context>
<context>
    <name>widgets::ScatterPlot</name>
    <message>
        <source>Logarithmic axes</source>
        <translation>Λογαριθμικοί άξονες</translation>
    </message>
</context>
<context>
    <name>widgets::ScenePanel</name>
    <message>
        <source>Whose pose stands in the scene</source>
        <translation>Τίνος η πόζα βρίσκεται στη σκηνή</translation>
    </message>
    <message>
        <source>Recorded pose</source>
        <translation>Καταγεγραμμένη πόζα</translation>
    </message>
</context>
<context>
    <name>widgets::SceneView</name>
    <message>
        <source>The 3D scene needs OpenGL, which this display does not have.</source>
        <translation>Η σκηνή 3D χρειάζεται OpenGL, που δεν διαθέτει αυτή η οθόνη.</translation>
    </message>
    <message>
        <source>Reset view</source>
        <translation>Επαναφορά προβολής</translation>
    </message>
    <message>
        <source>Look through</source>
        <translation>Θέαση από</translation>
    </message>
    <message>
        <source>scene</source>
        <translation>σκηνή</translation>
    </message>
</context>
<context>
    <name>widgets::SilhouettePage</name>
    <message>
        <source>Around the joints</source>
        <translation>Γύρω από τις αρθρώσεις</translation>
    </message>
    <message>
        <source>Around the posed hand model</source>
        <translation>Γύρω από το μοντέλο χεριού στην πόζα του</translation>
    </message>
    <message>
        <source>What differs from the empty room</source>
        <translation>Ό,τι διαφέρει από το άδειο δωμάτιο</translation>
    </message>
    <message>
        <source>What has not the backdrop&apos;s colour</source>
        <translation>Ό,τι δεν έχει το χρώμα του φόντου</translation>
    </message>
    <message>
        <source>What has the colour of skin</source>
        <translation>Ό,τι έχει το χρώμα του δέρματος</translation>
    </message>
    <message>
        <source>Give them to this sequence</source>
        <translation>Σύνδεση με αυτή την ακολουθία</translation>
    </message>
    <message>
        <source>Make silhouettes</source>
        <translation>Δημιουργία σιλουετών</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Διακοπή</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>By how much the pose may be wrong: that far from the model the picture decides</source>
        <translation>Πόσο λάθος μπορεί να είναι η πόζα: ως αυτή την απόσταση από το μοντέλο αποφασίζει η εικόνα</translation>
    </message>
    <message>
        <source>How much of the forearm is kept, in lengths of the palm from the wrist</source>
        <translation>Πόσο από τον πήχη κρατιέται, σε μήκη παλάμης από τον καρπό</translation>
    </message>
    <message>
        <source>Poses are fitted to them then</source>
        <translation>Οι πόζες προσαρμόζονται τότε σε αυτές</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Εύρεση</translation>
    </message>
    <message>
        <source>Pose may be off by</source>
        <translation>Ανοχή πόζας</translation>
    </message>
    <message>
        <source>Forearm, in palms</source>
        <translation>Πήχης, σε παλάμες</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Πινέλο</translation>
    </message>
    <message>
        <source>In the views: the left button adds to the silhouette, the right one (or Shift) takes away; Ctrl and the wheel change the size</source>
        <translation>Στις προβολές: το αριστερό πλήκτρο προσθέτει στη σιλουέτα, το δεξί (ή το Shift) αφαιρεί· το Ctrl και ο τροχός αλλάζουν το μέγεθος</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Radius of the brush, pixels of the picture</source>
        <translation>Ακτίνα του πινέλου, σε πίξελ της εικόνας</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Καρέ</translation>
    </message>
    <message>
        <source>to</source>
        <translation>έως</translation>
    </message>
    <message>
        <source>every</source>
        <translation>ανά</translation>
    </message>
    <message numerus="yes">
        <source>%n silhouette(s) made, %1 were there already.</source>
        <translation>
            <numerusform>Έγινε %n σιλουέτα, %1 υπήρχαν ήδη.</numerusform>
            <numerusform>Έγιναν %n σιλουέτες, %1 υπήρχαν ήδη.</numerusform>
        </translation>
    </message>
    <message>
        <source>The sequence uses them now.</source>
        <translation>Η ακολουθία τις χρησιμοποιεί τώρα.</translation>
    </message>
    <message numerus="yes">
        <source>This frame: a silhouette in %n view(s)</source>
        <translation>
            <numerusform>Αυτό το καρέ: σιλουέτα σε %n προβολή</numerusform>
            <numerusform>Αυτό το καρέ: σιλουέτα σε %n προβολές</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %n of them kept on disk</source>
        <translation>
            <numerusform>, %n από αυτές φυλάσσεται στον δίσκο</numerusform>
            <numerusform>, %n από αυτές φυλάσσονται στον δίσκο</numerusform>
        </translation>
    </message>
    <message>
        <source>Looking for silhouettes. Nothing appears where no joints of the frame are known: annotate some, or choose another way.</source>
        <translation>Αναζήτηση σιλουετών. Τίποτα δεν εμφανίζεται όπου δεν είναι γνωστές αρθρώσεις του καρέ: επισημειώστε μερικές ή επιλέξτε άλλον τρόπο.</translation>
    </message>
    <message>
        <source>Undo %1</source>
        <translation>Αναίρεση: %1</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Αναίρεση</translation>
    </message>
    <message>
        <source>Redo %1</source>
        <translation>Ακύρωση αναίρεσης: %1</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Ακύρωση αναίρεσης</translation>
    </message>
    <message>
        <source>This sequence has masks already (%1). They stay on disk.</source>
        <translation>Αυτή η ακολουθία έχει ήδη μάσκες (%1). Μένουν στον δίσκο.</translation>
    </message>
    <message>
        <source>Use the new ones instead</source>
        <translation>Χρήση των νέων</translation>
    </message>
    <message>
        <source>Make them only</source>
        <translation>Μόνο δημιουργία</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Ακύρωση</translation>
    </message>
    <message>
        <source>The last frame lies before the first one.</source>
        <translation>Το τελευταίο καρέ είναι πριν από το πρώτο.</translation>
    </message>
</context>
<context>
    <name>widgets::SilhouetteStudy</name>
    <message>
        <source>touch up %1</source>
        <translation>διόρθωση σιλουέτας (%1)</translation>
    </message>
</context>
<context>
    <name>widgets::StatusLine</name>
    <message numerus="yes">
        <source>saved %n s ago</source>
        <translation>
            <numerusform>αποθηκεύτηκε πριν από %n δευτ.</numerusform>
            <numerusform>αποθηκεύτηκε πριν από %n δευτ.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>saved %n min ago</source>
        <translation>
            <numerusform>αποθηκεύτηκε πριν από %n λεπτό</numerusform>
            <numerusform>αποθηκεύτηκε πριν από %n λεπτά</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>saved %n h ago</source>
        <translation>
            <numerusform>αποθηκεύτηκε πριν από %n ώρα</numerusform>
            <numerusform>αποθηκεύτηκε πριν από %n ώρες</numerusform>
        </translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Διακοπή</translation>
    </message>
    <message>
        <source>NOT SAVED</source>
        <translation>ΔΕΝ ΑΠΟΘΗΚΕΥΤΗΚΕ</translation>
    </message>
    <message>
        <source>read-only</source>
        <translation>μόνο ανάγνωση</translation>
    </message>
    <message>
        <source>saved</source>
        <translation>αποθηκεύτηκε</translation>
    </message>
    <message numerus="yes">
        <source>, %n s left</source>
        <translation>
            <numerusform>, απομένει %n δευτ.</numerusform>
            <numerusform>, απομένουν %n δευτ.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %n min left</source>
        <translation>
            <numerusform>, απομένει %n λεπτό</numerusform>
            <numerusform>, απομένουν %n λεπτά</numerusform>
        </translation>
    </message>
    <message>
        <source>saving, %1 %</source>
        <translation>αποθήκευση, %1 %</translation>
    </message>
</context>
<context>
    <name>widgets::StoreText</name>
    <message>
        <source>opened for reading only</source>
        <translation>ανοιχτό μόνο για ανάγνωση</translation>
    </message>
    <message>
        <source>opened by another window</source>
        <translation>ανοιχτό σε άλλο παράθυρο</translation>
    </message>
    <message>
        <source>opened by another window (%1)</source>
        <translation>ανοιχτό σε άλλο παράθυρο (%1)</translation>
    </message>
    <message>
        <source>the folder is read-only</source>
        <translation>ο φάκελος είναι μόνο για ανάγνωση</translation>
    </message>
    <message>
        <source>the file is read-only</source>
        <translation>το αρχείο είναι μόνο για ανάγνωση</translation>
    </message>
    <message>
        <source>This file system has no locks: make sure that no other window has %1 open.</source>
        <translation>Αυτό το σύστημα αρχείων δεν έχει κλειδώματα: βεβαιωθείτε ότι κανένα άλλο παράθυρο δεν έχει ανοιχτό το %1.</translation>
    </message>
    <message>
        <source>No backup could be made: %1</source>
        <translation>Δεν ήταν δυνατή η δημιουργία αντιγράφου ασφαλείας: %1</translation>
    </message>
</context>
<context>
    <name>widgets::SubjectModel</name>
    <message>
        <source>left</source>
        <translation>αριστερό</translation>
    </message>
    <message>
        <source>right</source>
        <translation>δεξί</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>Χέρι</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Οστό</translation>
    </message>
    <message>
        <source>Model, mm</source>
        <translation>Μοντέλο, mm</translation>
    </message>
    <message>
        <source>Measured, mm</source>
        <translation>Μέτρηση, mm</translation>
    </message>
    <message>
        <source>Change, %</source>
        <translation>Μεταβολή, %</translation>
    </message>
    <message>
        <source>± mm</source>
        <translation>± mm</translation>
    </message>
    <message>
        <source>Standard deviation of the measured length</source>
        <translation>Τυπική απόκλιση του μετρημένου μήκους</translation>
    </message>
</context>
<context>
    <name>widgets::SubjectPage</name>
    <message>
        <source>Use masks</source>
        <translation>Χρήση μασκών</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Μέτρηση</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Διακοπή</translation>
    </message>
    <message>
        <source>Save as a new dataset...</source>
        <translation>Αποθήκευση ως νέο σύνολο...</translation>
    </message>
    <message>
        <source>Saved in %1.</source>
        <translation>Αποθηκεύτηκε στο %1.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Άνοιγμα</translation>
    </message>
    <message>
        <source>Evenly drawn from the annotated ones; more than 15 bring little and take long</source>
        <translation>Ομοιόμορφα επιλεγμένα από τα επισημειωμένα· πάνω από 15 προσφέρουν λίγα και αργούν πολύ</translation>
    </message>
    <message>
        <source>Outlines tell the girth; joints alone leave it as the model has it</source>
        <translation>Τα περιγράμματα δίνουν το πάχος· μόνο με αρθρώσεις μένει όπως στο μοντέλο</translation>
    </message>
    <message>
        <source>A dataset with these hands; footage and masks stay where they are, annotations and motion are copied</source>
        <translation>Σύνολο με αυτά τα χέρια· υλικό και μάσκες μένουν στη θέση τους, επισημειώσεις και κίνηση αντιγράφονται</translation>
    </message>
    <message>
        <source>Sequences</source>
        <translation>Ακολουθίες</translation>
    </message>
    <message>
        <source>Frames at most</source>
        <translation>Μέγιστα καρέ</translation>
    </message>
    <message>
        <source>Choose a sequence with annotated frames.</source>
        <translation>Επιλέξτε ακολουθία με επισημειωμένα καρέ.</translation>
    </message>
    <message>
        <source>Bone lengths, scale and girth of this person&apos;s hands are found from annotated frames: at least %1, from 5 on every bone by itself.</source>
        <translation>Μήκη οστών, κλίμακα και πάχος των χεριών αυτού του ατόμου βρίσκονται από επισημειωμένα καρέ: τουλάχιστον %1, από 5 και πάνω κάθε οστό χωριστά.</translation>
    </message>
    <message>
        <source>A new folder for the dataset</source>
        <translation>Νέος φάκελος για το σύνολο</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Αποθήκευση</translation>
    </message>
</context>
<context>
    <name>widgets::SubjectStudy</name>
    <message>
        <source>reading annotations</source>
        <translation>ανάγνωση επισημειώσεων</translation>
    </message>
    <message>
        <source>reading masks</source>
        <translation>ανάγνωση μασκών</translation>
    </message>
    <message>
        <source>measuring</source>
        <translation>μέτρηση</translation>
    </message>
</context>
<context>
    <name>widgets::SubjectText</name>
    <message>
        <source>The calibration is not in mm: its unit is %1 mm. The cameras of the new dataset are in mm.</source>
        <translation>Η βαθμονόμηση δεν είναι σε mm: η μονάδα της είναι %1 mm. Οι κάμερες του νέου συνόλου είναι σε mm.</translation>
    </message>
    <message>
        <source>The calibration is not in mm: its unit is %1 mm if this hand is as large as the model, so that scale says nothing. The cameras of the new dataset are in mm.</source>
        <translation>Η βαθμονόμηση δεν είναι σε mm: η μονάδα της είναι %1 mm αν αυτό το χέρι είναι όσο το μοντέλο, οπότε η κλίμακα δεν λέει τίποτα. Οι κάμερες του νέου συνόλου είναι σε mm.</translation>
    </message>
    <message>
        <source>%1 of %2 annotated frames were used, evenly drawn.</source>
        <translation>Χρησιμοποιήθηκαν %1 από %2 επισημειωμένα καρέ, ομοιόμορφα επιλεγμένα.</translation>
    </message>
    <message numerus="yes">
        <source>%n annotated frame(s) were used.</source>
        <translation>
            <numerusform>Χρησιμοποιήθηκε %n επισημειωμένο καρέ.</numerusform>
            <numerusform>Χρησιμοποιήθηκαν %n επισημειωμένα καρέ.</numerusform>
        </translation>
    </message>
    <message>
        <source>Fewer than 3 frames: only the scale is measured.</source>
        <translation>Λιγότερα από 3 καρέ: μετριέται μόνο η κλίμακα.</translation>
    </message>
    <message numerus="yes">
        <source>Outlines of %n frame(s) fit to %1 mm.</source>
        <translation>
            <numerusform>Τα περιγράμματα %n καρέ ταιριάζουν με ακρίβεια %1 mm.</numerusform>
            <numerusform>Τα περιγράμματα %n καρέ ταιριάζουν με ακρίβεια %1 mm.</numerusform>
        </translation>
    </message>
    <message>
        <source>No masks of frames in which all hands are annotated: the girth stays the model&apos;s.</source>
        <translation>Δεν υπάρχουν μάσκες για καρέ με όλα τα χέρια επισημειωμένα: το πάχος μένει του μοντέλου.</translation>
    </message>
    <message>
        <source>Left hand: scale %1 ± %2, girth %3 ± %4 mm; joints fit to %5 mm.</source>
        <translation>Αριστερό χέρι: κλίμακα %1 ± %2, πάχος %3 ± %4 mm· οι αρθρώσεις ταιριάζουν με ακρίβεια %5 mm.</translation>
    </message>
    <message>
        <source>Right hand: scale %1 ± %2, girth %3 ± %4 mm; joints fit to %5 mm.</source>
        <translation>Δεξί χέρι: κλίμακα %1 ± %2, πάχος %3 ± %4 mm· οι αρθρώσεις ταιριάζουν με ακρίβεια %5 mm.</translation>
    </message>
    <message numerus="yes">
        <source>%n annotated frame(s)</source>
        <translation>
            <numerusform>%n επισημειωμένο καρέ</numerusform>
            <numerusform>%n επισημειωμένα καρέ</numerusform>
        </translation>
    </message>
    <message>
        <source>masks</source>
        <translation>μάσκες</translation>
    </message>
    <message>
        <source>no masks</source>
        <translation>χωρίς μάσκες</translation>
    </message>
    <message>
        <source>Fewer than 5 frames: bones keep the model&apos;s proportions.</source>
        <translation>Λιγότερα από 5 καρέ: τα οστά κρατούν τις αναλογίες του μοντέλου.</translation>
    </message>
    <message>
        <source>The calibration does not fit the clicks everywhere (Quality, Cameras): measure again after it is refined.</source>
        <translation>Η βαθμονόμηση δεν ταιριάζει παντού με τα κλικ (Ποιότητα, Κάμερες): μετρήστε ξανά μετά τη βελτίωσή της.</translation>
    </message>
</context>
<context>
    <name>widgets::SummaryModel</name>
    <message>
        <source>start</source>
        <translation>αρχή</translation>
    </message>
    <message>
        <source>Seconds per pair</source>
        <translation>Δευτερόλεπτα ανά ζεύγος</translation>
    </message>
    <message>
        <source>Mean and standard deviation of the error, mm, by frames apart</source>
        <translation>Μέση τιμή και τυπική απόκλιση του σφάλματος, mm, ανά απόσταση καρέ</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Μέθοδος</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>All, mm</source>
        <translation>Όλα, mm</translation>
    </message>
    <message>
        <source>Pairs that are finished</source>
        <translation>Ζεύγη που τελείωσαν</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>Ζεύγη</translation>
    </message>
</context>
<context>
    <name>widgets::Timeline</name>
    <message>
        <source>Timeline</source>
        <translation>Γραμμή χρόνου</translation>
    </message>
    <message>
        <source>Frame %1</source>
        <translation>Καρέ %1</translation>
    </message>
    <message>
        <source>%1: %2 done, %3 partial, %4 bad, %5 occluded</source>
        <translation>%1: %2 έτοιμες, %3 μερικές, %4 προβληματικές, %5 κρυμμένες</translation>
    </message>
    <message>
        <source>Marks of %1</source>
        <translation>Σημάδια του %1</translation>
    </message>
    <message>
        <source>%1: proposed, doubt %2 %</source>
        <translation>%1: πρόταση, αμφιβολία %2 %</translation>
    </message>
</context>
<context>
    <name>widgets::TimelineLegend</name>
    <message>
        <source>Upper lane: left hand. Lower lane: right hand. The fuller a bar, the more joints have marks.</source>
        <translation>Πάνω λωρίδα: αριστερό χέρι. Κάτω: δεξί. Όσο πιο γεμάτη η μπάρα, τόσο περισσότερες αρθρώσεις έχουν σημάδια.</translation>
    </message>
    <message>
        <source>every joint is done</source>
        <translation>όλες οι αρθρώσεις είναι έτοιμες</translation>
    </message>
    <message>
        <source>some joints have marks</source>
        <translation>μερικές αρθρώσεις έχουν σημάδια</translation>
    </message>
    <message>
        <source>a joint is bad: large error, outlier, or no 3D point</source>
        <translation>μια άρθρωση είναι κακή: μεγάλο σφάλμα, ακραία τιμή ή χωρίς σημείο 3D</translation>
    </message>
    <message>
        <source>at its foot: a joint is occluded, its place estimated</source>
        <translation>στη βάση: μια άρθρωση καλύπτεται, η θέση της εκτιμάται</translation>
    </message>
    <message>
        <source>between the lanes: marks of other people</source>
        <translation>ανάμεσα στις λωρίδες: σημάδια άλλων</translation>
    </message>
    <message>
        <source>tick above: a note</source>
        <translation>γραμμή πάνω: σημείωση</translation>
    </message>
    <message>
        <source>tick below: a test frame of the benchmark; the line: the current frame</source>
        <translation>γραμμή κάτω: καρέ δοκιμής· η μεγάλη γραμμή: το τρέχον καρέ</translation>
    </message>
    <message>
        <source>stripes: proposed by a program, waits for a look</source>
        <translation>ρίγες: πρόταση προγράμματος, περιμένει έλεγχο</translation>
    </message>
    <message>
        <source>stripes: the same, and doubtful</source>
        <translation>ρίγες: το ίδιο, και αμφίβολο</translation>
    </message>
</context>
<context>
    <name>widgets::TrackerColumn</name>
    <message>
        <source>%1 has no estimate of frame %2 from frame %3</source>
        <translation>Το %1 δεν έχει εκτίμηση του καρέ %2 από το καρέ %3</translation>
    </message>
    <message>
        <source>%1 has fewer than three joints of a hand, or they lie on a line: that hand cannot be drawn.</source>
        <translation>Το %1 έχει λιγότερες από τρεις αρθρώσεις ενός χεριού ή βρίσκονται σε μία ευθεία: αυτό το χέρι δεν μπορεί να σχεδιαστεί.</translation>
    </message>
</context>
<context>
    <name>widgets::ViewPanel</name>
    <message>
        <source>Mesh</source>
        <translation>Πλέγμα</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Ανενεργό</translation>
    </message>
    <message>
        <source>Shaded</source>
        <translation>Σκιασμένο</translation>
    </message>
    <message>
        <source>Wireframe</source>
        <translation>Συρμάτινο</translation>
    </message>
    <message>
        <source>Style</source>
        <translation>Στυλ</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Αδιαφάνεια</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Εικόνα</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>Φωτεινότητα</translation>
    </message>
    <message>
        <source>Contrast</source>
        <translation>Αντίθεση</translation>
    </message>
    <message>
        <source>Gamma</source>
        <translation>Γάμα</translation>
    </message>
    <message>
        <source>All views</source>
        <translation>Όλες οι προβολές</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Επαναφορά</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Κάμερες</translation>
    </message>
    <message>
        <source>Untick to hide a view; drag to change the order</source>
        <translation>Αποεπιλέξτε για απόκρυψη μιας προβολής· σύρετε για αλλαγή σειράς</translation>
    </message>
</context>
<context>
    <name>widgets::WhatIfCase</name>
    <message>
        <source>only %1</source>
        <translation>μόνο %1</translation>
    </message>
    <message>
        <source>without %1</source>
        <translation>χωρίς %1</translation>
    </message>
    <message>
        <source>outlines with %1 px of noise (draw %2)</source>
        <translation>περιγράμματα με θόρυβο %1 px (δείγμα %2)</translation>
    </message>
    <message>
        <source>%1 in the place of %2</source>
        <translation>%1 στη θέση του %2</translation>
    </message>
    <message>
        <source>being fitted</source>
        <translation>προσαρμόζεται</translation>
    </message>
    <message>
        <source>%1 (being fitted)</source>
        <translation>%1 (προσαρμόζεται)</translation>
    </message>
</context>
<context>
    <name>widgets::WhatIfPanel</name>
    <message>
        <source>Fit a pair: the settings of its methods can be changed here then.</source>
        <translation>Προσαρμόστε ένα ζεύγος: μετά οι ρυθμίσεις των μεθόδων του αλλάζουν εδώ.</translation>
    </message>
    <message>
        <source>What does each camera add?</source>
        <translation>Τι προσφέρει κάθε κάμερα;</translation>
    </message>
    <message>
        <source>Fits without each camera in turn: how much the error grows stands beside it</source>
        <translation>Προσαρμογή χωρίς κάθε κάμερα με τη σειρά: δίπλα της φαίνεται πόσο αυξάνεται το σφάλμα</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Χρήση</translation>
    </message>
    <message>
        <source>Gives the column these settings</source>
        <translation>Δίνει στη στήλη αυτές τις ρυθμίσεις</translation>
    </message>
    <message>
        <source>Add as another column</source>
        <translation>Προσθήκη ως νέα στήλη</translation>
    </message>
    <message>
        <source>Keeps the column, and shows these settings beside it</source>
        <translation>Διατηρεί τη στήλη και δείχνει αυτές τις ρυθμίσεις δίπλα της</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Επαναφορά</translation>
    </message>
    <message>
        <source>All as it was fitted</source>
        <translation>Όλα όπως προσαρμόστηκαν</translation>
    </message>
    <message>
        <source>The error grows most without %1.</source>
        <translation>Το σφάλμα αυξάνεται περισσότερο χωρίς την %1.</translation>
    </message>
    <message>
        <source>The column whose settings are changed</source>
        <translation>Η στήλη της οποίας αλλάζουν οι ρυθμίσεις</translation>
    </message>
    <message>
        <source>The method as on the command line; Enter takes it over</source>
        <translation>Η μέθοδος όπως στη γραμμή εντολών· το Enter την εφαρμόζει</translation>
    </message>
    <message>
        <source>Method with its settings</source>
        <translation>Μέθοδος με τις ρυθμίσεις της</translation>
    </message>
    <message>
        <source>Noise of the outlines</source>
        <translation>Θόρυβος περιγραμμάτων</translation>
    </message>
    <message>
        <source>What if the silhouettes were noisier? By how much their outlines move, pixels</source>
        <translation>Τι αν οι σιλουέτες είχαν περισσότερο θόρυβο; Πόσο μετακινούνται τα περιγράμματά τους, πίξελ</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Cameras that take part</source>
        <translation>Κάμερες που συμμετέχουν</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Whether this camera&apos;s silhouette takes part</source>
        <translation>Αν συμμετέχει η σιλουέτα αυτής της κάμερας</translation>
    </message>
    <message>
        <source>Leave at least one camera on.</source>
        <translation>Αφήστε ενεργή τουλάχιστον μία κάμερα.</translation>
    </message>
    <message>
        <source>Fitting...</source>
        <translation>Προσαρμογή...</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Κάμερες</translation>
    </message>
    <message>
        <source>Noise of the outlines, px</source>
        <translation>Θόρυβος περιγραμμάτων, px</translation>
    </message>
    <message>
        <source>Error, mm</source>
        <translation>Σφάλμα, mm</translation>
    </message>
    <message>
        <source>Drag a setting: the error over it appears here.</source>
        <translation>Σύρετε μια ρύθμιση: εδώ εμφανίζεται το αντίστοιχο σφάλμα.</translation>
    </message>
    <message>
        <source>%1 instead of %2</source>
        <translation>%1 αντί για %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Fitting without each camera...</source>
        <translation>Προσαρμογή χωρίς κάθε κάμερα...</translation>
    </message>
    <message>
        <source>Fits at a row of values of this parameter, for every column that has it, and fills the curve; once more stops</source>
        <translation>Προσαρμόζει για μια σειρά τιμών αυτής της παραμέτρου, για κάθε στήλη που την έχει, και γεμίζει την καμπύλη· ξανά για διακοπή</translation>
    </message>
    <message>
        <source>%1: least error %2 mm at %3</source>
        <translation>%1: ελάχιστο σφάλμα %2 mm στο %3</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Διακοπή</translation>
    </message>
    <message>
        <source>Sweep the noise</source>
        <translation>Σάρωση του θορύβου</translation>
    </message>
    <message>
        <source>Sweep the cameras</source>
        <translation>Σάρωση των καμερών</translation>
    </message>
    <message>
        <source>Sweep %1</source>
        <translation>Σάρωση: %1</translation>
    </message>
    <message>
        <source>%1 of %2 fits</source>
        <translation>%1 από %2 προσαρμογές</translation>
    </message>
    <message>
        <source>Draw %1</source>
        <translation>Δείγμα %1</translation>
    </message>
    <message>
        <source>Of all points: %1</source>
        <translation>Σε όλα τα σημεία: %1</translation>
    </message>
    <message>
        <source>Draw of the noise</source>
        <translation>Δείγμα του θορύβου</translation>
    </message>
    <message>
        <source>Which draw of the noise: other wiggles of the same size. One draw alone may be luck.</source>
        <translation>Ποιο δείγμα του θορύβου: άλλες διακυμάνσεις ίδιου μεγέθους. Ένα μόνο δείγμα μπορεί να είναι τυχαίο.</translation>
    </message>
    <message>
        <source>As it was fitted: %1</source>
        <translation>Όπως προσαρμόστηκε: %1</translation>
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
        <translation>Προσαρμογή του τρέχοντος καρέ: F</translation>
    </message>
    <message>
        <source>start</source>
        <translation>αρχή</translation>
    </message>
    <message>
        <source>%1 failed</source>
        <translation>Το %1 απέτυχε</translation>
    </message>
    <message>
        <source>Frame %1 from frame %2</source>
        <translation>Καρέ %1 από το καρέ %2</translation>
    </message>
    <message>
        <source>There is nothing to measure the error against.</source>
        <translation>Δεν υπάρχει τίποτα για να μετρηθεί το σφάλμα.</translation>
    </message>
    <message>
        <source>Choose methods and sequences, then Run</source>
        <translation>Επιλέξτε μεθόδους και ακολουθίες, μετά Εκτέλεση</translation>
    </message>
    <message>
        <source>%1 pairs</source>
        <translation>%1 ζεύγη</translation>
    </message>
</context>
<context>
    <name>widgets::Workspaces</name>
    <message>
        <source>Quality</source>
        <translation>Ποιότητα</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Προσαρμογή</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Όψη</translation>
    </message>
    <message>
        <source>Raters</source>
        <translation>Αξιολογητές</translation>
    </message>
    <message>
        <source>All views are hidden: tick one under View, Cameras.</source>
        <translation>Όλες οι προβολές είναι κρυμμένες: επιλέξτε μία στην καρτέλα «Όψη», «Κάμερες».</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Έλεγχος</translation>
    </message>
    <message>
        <source>What if</source>
        <translation>Τι αν</translation>
    </message>
</context>
</TS>
