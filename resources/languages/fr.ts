<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
<name>EdgeScan</name>
<message><source>CONNECTING</source><translation>CONNEXION</translation></message>
<message><source>LIVE</source><translation>EN DIRECT</translation></message>
<message><source>STALE</source><translation>PÉRIMÉ</translation></message>
<message><source>STALE %1</source><translation>PÉRIMÉ %1</translation></message>
<message><source>NOT CONNECTED</source><translation>NON CONNECTÉ</translation></message>
<message><source>LOST %1</source><translation>PERDU %1</translation></message>
<message><source>STOPPED</source><translation>ARRÊTÉ</translation></message>
<message><source>STOPPED %1</source><translation>ARRÊTÉ %1</translation></message>
<message><source>%1, COUNTERS IN DOUBT</source><translation>%1, COMPTEURS DOUTEUX</translation></message>
<message><source>INCOMPLETE %1 lines</source><translation>INCOMPLET %1 lignes</translation></message>
<message><source>%1 lost: %2</source><translation>%1 perdues : %2</translation></message>
<message><source>%1 lines</source><translation>%1 lignes</translation></message>
<message><source>no return %1 %</source><translation>sans retour %1 %</translation></message>
<message><source>COUNTERS IN DOUBT</source><translation>COMPTEURS DOUTEUX</translation></message>
<message><source>MOUNTING ASSUMED</source><translation>MONTAGE SUPPOSÉ</translation></message>
<message><source>MOUNTING FROM RANGES</source><translation>MONTAGE D'APRÈS DISTANCES</translation></message>
<message><source>FIRST ANGLE ASSUMED</source><translation>PREMIER ANGLE SUPPOSÉ</translation></message>
<message><source>STEP ASSUMED %1°</source><translation>PAS SUPPOSÉ %1°</translation></message>
<message><source>START ASSUMED</source><translation>DÉBUT SUPPOSÉ</translation></message>
<message><source>1 remark</source><translation>1 remarque</translation></message>
<message><source>%1 remarks</source><translation>%1 remarques</translation></message>
<message><source>%1 earlier in this sweep</source><translation>%1 plus tôt dans ce balayage</translation></message>
<message><source>WINDOW TOO DIRTY</source><translation>FENÊTRE TROP SALE</translation></message>
<message><source>WINDOW DIRTY</source><translation>FENÊTRE SALE</translation></message>
<message><source>DEVICE ERROR</source><translation>ERREUR DE L'APPAREIL</translation></message>
<message><source>pose %1 old</source><translation>pose vieille de %1</translation></message>
<message><source>%1 left</source><translation>encore %1</translation></message>
<message><source>%1, %2 ago</source><translation>%1, il y a %2</translation></message>
<message><source>recording %1 MB, %2</source><translation>enregistrement %1 Mo, %2</translation></message>
<message><source>recording %1 MB</source><translation>enregistrement %1 Mo</translation></message>
<message><source>RECORDING ENDED: %1</source><translation>ENREGISTREMENT TERMINÉ : %1</translation></message>
<message><source>RECORDING HAS GAPS: %1</source><translation>L'ENREGISTREMENT A DES TROUS : %1</translation></message>
<message><source>%1; other cells: points of one moved to the grid of the other</source><translation>%1; autres cellules : points de l'un déplacés sur la grille de l'autre</translation></message>
<message><source>one scan with two settings</source><translation>un scan avec deux réglages</translation></message>
<message><source>lined up by their poses</source><translation>alignés par leurs poses</translation></message>
<message><source>lined up by given positions of the scanner, not in the mine grid</source><translation>alignés par des positions données du scanner, pas dans la grille de la mine</translation></message>
<message><source>no pose: lined up by their surfaces</source><translation>pas de pose : alignés par leurs surfaces</translation></message>
<message><source>not resolved</source><translation>non résolu</translation></message>
<message><source>sweep %1</source><translation>balayage %1</translation></message>
<message><source>demo draw-bell after the blast</source><translation>cloche de démonstration après le tir</translation></message>
<message><source>demo draw-bell</source><translation>cloche de démonstration</translation></message>
<message><source>there is not enough memory for this scan</source><translation>il n'y a pas assez de mémoire pour ce scan</translation></message>
<message><source>close other programs or open a smaller scan</source><translation>fermez d'autres programmes ou ouvrez un scan plus petit</translation></message>
<message><source>there is not enough memory to show the scan in its place</source><translation>il n'y a pas assez de mémoire pour montrer le scan à sa place</translation></message>
<message><source>there is not enough memory for this layer</source><translation>il n'y a pas assez de mémoire pour cette couche</translation></message>
<message><source>there is not enough memory for a second picture</source><translation>il n'y a pas assez de mémoire pour une deuxième image</translation></message>
<message><source>there is not enough memory for a second scan</source><translation>il n'y a pas assez de mémoire pour un deuxième scan</translation></message>
<message><source>there is not enough memory for these scans</source><translation>il n'y a pas assez de mémoire pour ces scans</translation></message>
<message><source>there is not enough memory to play this recording</source><translation>il n'y a pas assez de mémoire pour lire cet enregistrement</translation></message>
<message><source>hide or remove other layers, or choose a smaller scan</source><translation>masquez ou retirez d'autres couches, ou choisissez un scan plus petit</translation></message>
<message><source>close other programs or choose a smaller scan</source><translation>fermez d'autres programmes ou choisissez un scan plus petit</translation></message>
<message><source>close other programs or choose a smaller one</source><translation>fermez d'autres programmes ou choisissez-en un plus petit</translation></message>
<message><source>close other programs or use fewer scans</source><translation>fermez d'autres programmes ou utilisez moins de scans</translation></message>
<message><source>close other programs or use a smaller scan</source><translation>fermez d'autres programmes ou utilisez un scan plus petit</translation></message>
<message><source>another program has changed this file, so it was not removed</source><translation>un autre programme a modifié ce fichier, il n'a donc pas été supprimé</translation></message>
<message><source>open the scan again to see its edits</source><translation>ouvrez le scan de nouveau pour voir ses modifications</translation></message>
<message><source>it could not be opened (%1)</source><translation>il n'a pas pu être ouvert (%1)</translation></message>
<message><source>auto is not a number</source><translation>auto n'est pas un nombre</translation></message>
<message><source>tick auto next to the box</source><translation>cochez auto à côté du champ</translation></message>
<message><source>the layer has another content than when it was placed</source><translation>la couche a un autre contenu que lorsqu'elle a été placée</translation></message>
<message><source>remove it and add it again</source><translation>retirez-la et ajoutez-la de nouveau</translation></message>
<message><source>it is not a regular file, so settings are not read and nothing of this window is stored</source><translation>ce n'est pas un fichier ordinaire : les réglages ne sont pas lus et rien de cette fenêtre n'est enregistré</translation></message>
<message><source>remove it and start again</source><translation>supprimez-le et redémarrez</translation></message>
<message><source>not all settings in this file can be read</source><translation>tous les réglages de ce fichier ne peuvent pas être lus</translation></message>
<message><source>what it held is in </source><translation>ce qu'il contenait est dans </translation></message>
<message><source>choose another scan</source><translation>choisissez un autre scan</translation></message>
<message><source> (line </source><translation> (ligne </translation></message>
<message><source>Both are one scan: the files are the same.</source><translation>Les deux sont un seul scan : les fichiers sont identiques.</translation></message>
<message><source>Near and far leave no depth between them: the gray image is blank and has no edge.</source><translation>Près et loin ne laissent aucune profondeur entre eux : l'image grise est vide et sans arête.</translation></message>
<message><source> edge cells lie on filled ranges and are not in this file; %1 writes them.</source><translation> cellules d'arête sont sur des distances comblées et ne sont pas dans ce fichier ; %1 les écrit.</translation></message>
<message><source>OUT OF SPEC: whether the surfaces of "%1" fit cannot be seen.</source><translation>HORS TOLÉRANCE : on ne peut pas voir si les surfaces de « %1 » concordent.</translation></message>
<message><source>OUT OF SPEC: the surfaces of "%1" are %2 mm from those of the first scan at best.</source><translation>HORS TOLÉRANCE : les surfaces de « %1 » sont au mieux à %2 mm de celles du premier scan.</translation></message>
<message><source>OUT OF SPEC: the base moved while "%1" was taken: one place fits it badly.</source><translation>HORS TOLÉRANCE : la base a bougé pendant la prise de « %1 » : une seule place lui convient mal.</translation></message>
<message><source>OUT OF SPEC: without a pose of both, the two scans are lined up by their surfaces alone.</source><translation>HORS TOLÉRANCE : sans pose des deux, les deux scans sont alignés par leurs seules surfaces.</translation></message>
<message><source>OUT OF SPEC: the surfaces of the two scans do not lie where their poses put them: %1 apart, and %2 if one is moved by </source><translation>HORS TOLÉRANCE : les surfaces des deux scans ne sont pas là où leurs poses les placent : %1 d'écart, et %2 si l'un est déplacé de </translation></message>
<message><source>OUT OF SPEC: the surfaces of the two scans lie %1 apart at best, so most of the place changed or they are not scans of one place. No areas of change are given.</source><translation>HORS TOLÉRANCE : les surfaces des deux scans sont au mieux à %1 l'une de l'autre : presque tout a changé, ou ce ne sont pas des scans d'un même lieu. Aucune surface de changement n'est donnée.</translation></message>
<message><source>OUT OF SPEC: whether the poses fit cannot be seen, </source><translation>HORS TOLÉRANCE : on ne peut pas voir si les poses concordent, </translation></message>
<message><source>OUT OF SPEC: the poses do not fit the surfaces, so the earlier scan was moved by its surfaces, by </source><translation>HORS TOLÉRANCE : les poses ne concordent pas avec les surfaces ; le scan antérieur a donc été déplacé d'après ses surfaces, de </translation></message>
<message><source>Scan &gt; Straighten Beams</source><translation>Scan &gt; Redresser les faisceaux</translation></message>
<message><source>Scan &gt; Keep Repeated Values</source><translation>Scan &gt; Garder les valeurs répétées</translation></message>
<message><source>the coordinates in the export dialog</source><translation>les coordonnées dans le dialogue d'exportation</translation></message>
<message><source>the points behind others in the export dialog</source><translation>les points derrière d'autres dans le dialogue d'exportation</translation></message>
<message><source>the filled cells in the export dialog</source><translation>les cellules comblées dans le dialogue d'exportation</translation></message>
<message><source>the comments in the export dialog</source><translation>les commentaires dans le dialogue d'exportation</translation></message>
<message><source>the filling of gaps in the Edges panel</source><translation>le comblement des trous dans le panneau des arêtes</translation></message>
<message><source>the outlines in the picture</source><translation>les contours dans l'image</translation></message>
<message><source>“%1” in Scan &gt; How the Scan Is Read</source><translation>« %1 » dans Scan &gt; Comment le scan est lu</translation></message>
<message><source>the angles of beams and lines and the axis in Scan &gt; How the Scan Is Read</source><translation>les angles des faisceaux et des lignes et l'axe dans Scan &gt; Comment le scan est lu</translation></message>
<message><source>%1 to %2</source><translation>%1 à %2</translation></message>
<message><source>valid</source><translation>valide</translation></message>
<message><source>no return</source><translation>sans retour</translation></message>
<message><source>device status</source><translation>état de l'appareil</translation></message>
<message><source>out of window</source><translation>hors de la fenêtre</translation></message>
<message><source>masked</source><translation>masquées</translation></message>
<message><source>lost</source><translation>perdues</translation></message>
<message><source>Scan &gt; Sweep… takes what is right.</source><translation>Scan &gt; Balayage… prend ce qui est juste.</translation></message>
<message><source>▲ mounting from the ranges</source><translation>▲ montage d'après les distances</translation></message>
<message><source>▲ step assumed</source><translation>▲ pas supposé</translation></message>
<message><source>▲ mounting assumed</source><translation>▲ montage supposé</translation></message>
<message><source>1 target</source><translation>1 cible</translation></message>
<message><source>%1 targets</source><translation>%1 cibles</translation></message>
<message><source>1 rock</source><translation>1 bloc</translation></message>
<message><source>%1 rocks</source><translation>%1 blocs</translation></message>
<message><source>Fold this panel to the edge of the window</source><translation>Replier ce panneau au bord de la fenêtre</translation></message>
<message><source>Folded panels</source><translation>Panneaux repliés</translation></message>
<message><source>Open %1</source><translation>Ouvrir %1</translation></message>
<message><source>Open folder</source><translation>Ouvrir le dossier</translation></message>
<message><source>Details</source><translation>Détails</translation></message>
<message><source>Copy</source><translation>Copier</translation></message>
<message><source>Close</source><translation>Fermer</translation></message>
<message><source>Shows the next of the notes that were not closed</source><translation>Montre la suivante des notes qui n'ont pas été fermées</translation></message>
<message><source>Error</source><translation>Erreur</translation></message>
<message><source>Note</source><translation>Remarque</translation></message>
<message><source>Done</source><translation>Terminé</translation></message>
<message><source>%1 of %2</source><translation>%1 sur %2</translation></message>
<message><source>%1 MB</source><translation>%1 Mo</translation></message>
<message><source>%1 kB</source><translation>%1 ko</translation></message>
<message><source>Saved %1%2, %3.</source><translation>Enregistré %1%2, %3.</translation></message>
<message><source>Open</source><translation>Ouvrir</translation></message>
<message><source>No program of this computer opened %1.</source><translation>Aucun programme de cet ordinateur n'a ouvert %1.</translation></message>
<message><source>Undo</source><translation>Annuler</translation></message>
<message><source>Removed: %1.</source><translation>Retiré : %1.</translation></message>
<message><source>Done again: %1.</source><translation>Refait : %1.</translation></message>
<message><source>Undone: %1.</source><translation>Annulé : %1.</translation></message>
<message><source>It is back.</source><translation>C'est de retour.</translation></message>
<message><source>Redo</source><translation>Rétablir</translation></message>
<message><source>Double-click: in exchange for the cloud, and back</source><translation>Double-clic : à la place du nuage, et retour</translation></message>
<message><source>All views again</source><translation>Toutes les vues à nouveau</translation></message>
<message><source>This view alone</source><translation>Cette vue seule</translation></message>
<message><source>Replace the file?</source><translation>Remplacer le fichier ?</translation></message>
<message><source>There is a file of this name already:</source><translation>Il existe déjà un fichier de ce nom :</translation></message>
<message><source>There are files of these names already:</source><translation>Il existe déjà des fichiers de ces noms :</translation></message>
<message><source>Replace</source><translation>Remplacer</translation></message>
<message><source>... and %1 lines more</source><translation>... et %1 lignes de plus</translation></message>
<message><source>&amp;Night</source><translation>&amp;Nuit</translation></message>
<message><source>&amp;Day</source><translation>&amp;Jour</translation></message>
<message><source>&amp;Control-Room Gray</source><translation>&amp;Gris de salle de contrôle</translation></message>
<message><source>right-click &gt; hold a finger on | clicked &gt; tapped | clicks &gt; taps | click &gt; tap</source><translation>clic droit sur &gt; doigt posé sur | ce clic &gt; cet appui | clics &gt; appuis | clic &gt; appui | cliquez sur &gt; touchez | cliquez &gt; touchez | cliquer sur &gt; toucher | cliquée &gt; touchée | cliqué &gt; touché</translation></message>
<message><source>OK</source><translation>OK</translation></message>
<message><source>Save</source><translation>Enregistrer</translation></message>
<message><source>&amp;Yes</source><translation>&amp;Oui</translation></message>
<message><source>&amp;No</source><translation>&amp;Non</translation></message>
<message><source>Apply</source><translation>Appliquer</translation></message>
<message><source>Cu&amp;t</source><translation>Coupe&amp;r</translation></message>
<message><source>&amp;Copy</source><translation>&amp;Copier</translation></message>
<message><source>&amp;Paste</source><translation>C&amp;oller</translation></message>
<message><source>Select All</source><translation>Tout sélectionner</translation></message>
<message><source>Discard</source><translation>Ne pas enregistrer</translation></message>
<message><source>Delete</source><translation>Supprimer</translation></message>
<message><source>&amp;Step up</source><translation>&amp;Augmenter</translation></message>
<message><source>Step &amp;down</source><translation>&amp;Diminuer</translation></message>
<message><source>Copy &amp;Link Location</source><translation>Copier l'adresse du &amp;lien</translation></message>
<message><source>Float</source><translation>Détacher</translation></message>
<message><source>Shift</source><translation>Maj</translation></message>
<message><source>Del</source><translation>Suppr</translation></message>
<message><source>PgUp</source><translation>PgPréc</translation></message>
<message><source>PgDown</source><translation>PgSuiv</translation></message>
<message><source>Cancel</source><translation>Annuler</translation></message>
<message><source>Look in:</source><translation>Chercher dans :</translation></message>
<message><source>Back</source><translation>Arrière</translation></message>
<message><source>Forward</source><translation>Suivant</translation></message>
<message><source>Go back</source><translation>Revenir</translation></message>
<message><source>Go forward</source><translation>Avancer</translation></message>
<message><source>Parent Directory</source><translation>Dossier parent</translation></message>
<message><source>Go to the parent directory</source><translation>Aller au dossier parent</translation></message>
<message><source>Create New Folder</source><translation>Créer un dossier</translation></message>
<message><source>Create a New Folder</source><translation>Créer un nouveau dossier</translation></message>
<message><source>List View</source><translation>Vue en liste</translation></message>
<message><source>Change to list view mode</source><translation>Passer à la vue en liste</translation></message>
<message><source>Detail View</source><translation>Vue détaillée</translation></message>
<message><source>Change to detail view mode</source><translation>Passer à la vue détaillée</translation></message>
<message><source>Sidebar</source><translation>Barre latérale</translation></message>
<message><source>List of places and bookmarks</source><translation>Liste des lieux et des signets</translation></message>
<message><source>Files</source><translation>Fichiers</translation></message>
<message><source>File &amp;name:</source><translation>&amp;Nom du fichier :</translation></message>
<message><source>Files of type:</source><translation>Type de fichiers :</translation></message>
<message><source>Directory:</source><translation>Dossier :</translation></message>
<message><source>&amp;Open</source><translation>&amp;Ouvrir</translation></message>
<message><source>&amp;Save</source><translation>&amp;Enregistrer</translation></message>
<message><source>&amp;Choose</source><translation>&amp;Choisir</translation></message>
<message><source>&amp;Rename</source><translation>&amp;Renommer</translation></message>
<message><source>&amp;Delete</source><translation>&amp;Supprimer</translation></message>
<message><source>Show &amp;hidden files</source><translation>Montrer les fichiers &amp;cachés</translation></message>
<message><source>&amp;New Folder</source><translation>&amp;Nouveau dossier</translation></message>
<message><source>Name</source><translation>Nom</translation></message>
<message><source>Size</source><translation>Taille</translation></message>
<message><source>Type</source><translation>Type</translation></message>
<message><source>Date Modified</source><translation>Modifié le</translation></message>
<message><source>Computer</source><translation>Ordinateur</translation></message>
<message><source>Drive</source><translation>Lecteur</translation></message>
<message><source>All Files (*)</source><translation>Tous les fichiers (*)</translation></message>
<message><source>Show </source><translation>Afficher </translation></message>
<message><source>Scroll Left</source><translation>Défiler à gauche</translation></message>
<message><source>Scroll Right</source><translation>Défiler à droite</translation></message>
<message><source>▲ AUDIT LOG: %1</source><translation>▲ JOURNAL D'AUDIT : %1</translation></message>
<message><source>The audit log is written again; no line is missing.</source><translation>Le journal d'audit s'écrit à nouveau ; aucune ligne ne manque.</translation></message>
<message><source>▲ AUDIT LOG: what is done is not noted (%1)</source><translation>▲ JOURNAL D'AUDIT : ce qui est fait n'est pas noté (%1)</translation></message>
<message><source>The two pictures could not be compared (%1); keep a smaller scan.</source><translation>Les deux images n'ont pas pu être comparées (%1) ; gardez un scan plus petit.</translation></message>
<message><source>There is no picture to keep yet: open a scan first.</source><translation>Il n'y a pas encore d'image à garder : ouvrez d'abord un scan.</translation></message>
<message><source>Keep as A</source><translation>Garder comme A</translation></message>
<message><source>Forget A</source><translation>Oublier A</translation></message>
<message><source>The comparison ended: B, %1, is on the screen.</source><translation>La comparaison est terminée : B, %1, est à l'écran.</translation></message>
<message><source>Open A</source><translation>Ouvrir A</translation></message>
<message><source>The comparison ended: A was forgotten.</source><translation>La comparaison est terminée : A est oublié.</translation></message>
<message><source>A was forgotten: the demo and %1 are not of one place.</source><translation>A a été oublié : la démo et %1 ne sont pas d'un même lieu.</translation></message>
<message><source>The comparison ended, because another scan was opened.</source><translation>La comparaison est terminée, car un autre scan a été ouvert.</translation></message>
<message><source>There is nothing to compare with it yet: open the later scan first.</source><translation>Il n'y a encore rien à quoi la comparer : ouvrez d'abord le scan plus récent.</translation></message>
<message><source>Reading %1 as A</source><translation>Lecture de %1 comme A</translation></message>
<message><source>the demo</source><translation>la démo</translation></message>
<message><source>Cancelled; what was on the screen stays.</source><translation>Annulé ; ce qui était à l'écran reste.</translation></message>
<message><source>Choose the earlier scan, A; the scan on the screen is the later one, B</source><translation>Choisissez le scan antérieur, A ; celui de l'écran est le plus récent, B</translation></message>
<message><source>A and B are exchanged when both are files: keep a scan as A and open another one.</source><translation>A et B s'échangent si les deux sont des fichiers : gardez un scan comme A et ouvrez-en un autre.</translation></message>
<message><source>A was not restored: %1 has changed since.</source><translation>A n'a pas été repris : le contenu de %1 a changé depuis.</translation></message>
<message><source>Compare with Earlier Scan</source><translation>Comparer avec un scan antérieur</translation></message>
<message><source>Comparing with A</source><translation>Comparaison avec A</translation></message>
<message><source>Line Up by Surfaces</source><translation>Aligner sur les surfaces</translation></message>
<message><source>gained, lost and kept</source><translation>gagnées, perdues et gardées</translation></message>
<message><source>A and what is on the screen are the same, or are still being compared.</source><translation>A et l'écran sont identiques, ou la comparaison n'est pas finie.</translation></message>
<message><source>Nothing is kept as A yet: Edges &gt; Compare A/B &gt; Keep This as A.</source><translation>Rien n'est encore gardé comme A : Arêtes &gt; Comparer A/B &gt; Garder ceci comme A.</translation></message>
<message><source>The surfaces of the two scans do not fit, so no areas of change are given.</source><translation>Les surfaces des deux scans ne concordent pas : aucune surface de changement n'est donnée.</translation></message>
<message><source>No surface came nearer or went farther: keep a scan as A and open another one.</source><translation>Aucune surface ne s'est approchée ni éloignée : gardez un scan comme A et ouvrez-en un autre.</translation></message>
<message><source>region %1 of %2, the largest by area: %3 by %4 m ± %5 m,
now at %7 m; %6 m² at the nearer surface, without its border of one cell</source><translation>région %1 sur %2, la plus grande en surface : %3 de %4 m ± %5 m,
maintenant à %7 m ; %6 m² à la surface la plus proche, sans son bord d'une cellule</translation></message>
<message><source>region %1 of %2: %3 by %4 m ± %5 m,
now at %7 m; %6 m² at the nearer surface, without its border of one cell</source><translation>région %1 sur %2 : %3 de %4 m ± %5 m,
maintenant à %7 m ; %6 m² à la surface la plus proche, sans son bord d'une cellule</translation></message>
<message><source>farther</source><translation>plus loin</translation></message>
<message><source>nearer</source><translation>plus près</translation></message>
<message><source>when the sweep has ended</source><translation>quand le balayage sera terminé</translation></message>
<message><source>could not be computed:
%1</source><translation>n'a pas pu être calculée :
%1</translation></message>
<message><source>by confidence</source><translation>par confiance</translation></message>
<message><source>Its strength is %1. An edge reaches the Edge strength %2 at one place, and %3 along the rest.</source><translation>Sa force est %1. Une arête atteint la Force de l'arête %2 à un endroit, et %3 sur le reste.</translation></message>
<message><source>Its strength %1 is above the Edge strength %2.</source><translation>Sa force %1 dépasse la Force de l'arête %2.</translation></message>
<message><source>Its strength %1 is below the Edge strength %2, but it continues an edge that reaches %3 at line %4, beam %5. Such a cell needs only %6.</source><translation>Sa force %1 est sous la Force de l'arête %2, mais elle continue une arête qui atteint %3 à la ligne %4, faisceau %5. À une telle cellule, %6 suffit.</translation></message>
<message><source>This is an edge, but it is left out: only borders of rocks are shown.</source><translation>C'est une arête, mais elle est omise : seuls les contours de roches sont affichés.</translation></message>
<message><source>The surface changes here, but as much or more in the cell next to it, line %1, beam %2: an edge is one cell wide.</source><translation>La surface change ici, mais autant ou plus dans la cellule voisine, ligne %1, faisceau %2 : une arête a une cellule de large.</translation></message>
<message><source>In the direction of that cell their strengths are %1 and %2.</source><translation>Dans la direction de cette cellule, leurs forces sont %1 et %2.</translation></message>
<message><source>The surface changes too little here to be an edge.</source><translation>La surface change trop peu ici pour être une arête.</translation></message>
<message><source>The surface changes here, but no place of this change is strong enough for an edge.</source><translation>La surface change ici, mais aucun endroit de ce changement ne suffit pour une arête.</translation></message>
<message><source>The surface changes here, but this edge is shorter than the minimum length.</source><translation>La surface change ici, mais cette arête est plus courte que la longueur minimale.</translation></message>
<message><source>The surface changes here, but another cell of it is the edge.</source><translation>La surface change ici, mais une autre cellule de ce changement est l'arête.</translation></message>
<message><source>Nothing was measured here.</source><translation>Rien n'a été mesuré ici.</translation></message>
<message><source>One surface ends here in front of another.</source><translation>Une surface se termine ici devant une autre.</translation></message>
<message><source>The surface bends outwards here, as at the corner of a rock.</source><translation>La surface se plie vers l'extérieur ici, comme au coin d'un bloc.</translation></message>
<message><source>The surface bends inwards here, as where two rocks meet.</source><translation>La surface se plie vers l'intérieur ici, comme là où deux blocs se touchent.</translation></message>
<message><source>The measured surface ends here.</source><translation>La surface mesurée se termine ici.</translation></message>
<message><source>Edges of this class do not depend on Edge strength.</source><translation>Les arêtes de cette classe ne dépendent pas de la Force de l'arête.</translation></message>
<message><source>The surface changes strongly here.</source><translation>La surface change fortement ici.</translation></message>
<message><source>The reason could not be found (%1).</source><translation>La raison n'a pas pu être établie (%1).</translation></message>
<message><source>&amp;Why is this cell an edge or not?</source><translation>Pour&amp;quoi cette cellule est-elle une arête, ou non ?</translation></message>
<message><source>Finding the reason …</source><translation>Recherche de la raison …</translation></message>
<message><source>under the pointer</source><translation>sous le pointeur</translation></message>
<message><source>the pinned target, under the pointer</source><translation>la cible épinglée, sous le pointeur</translation></message>
<message><source>under the pointer, not the pinned target</source><translation>sous le pointeur, pas la cible épinglée</translation></message>
<message><source>the pinned target</source><translation>la cible épinglée</translation></message>
<message><source>the nearest edge</source><translation>l'arête la plus proche</translation></message>
<message><source>the near side of your click at %1</source><translation>le côté proche de votre clic à %1</translation></message>
<message><source>the target that you clicked</source><translation>la cible que vous avez cliquée</translation></message>
<message><source>the cell that you clicked</source><translation>la cellule que vous avez cliquée</translation></message>
<message><source>Cell: %1 (%2)</source><translation>Cellule : %1 (%2)</translation></message>
<message><source>Why: click a cell</source><translation>Pourquoi : cliquez sur une cellule</translation></message>
<message><source>
The strongest cell of its chain is marked in all views; zoomed in, the chain is framed.</source><translation>
La cellule la plus forte de sa chaîne est marquée dans toutes les vues ; en zoomant, la chaîne est encadrée.</translation></message>
<message><source>Clicked</source><translation>Cliqué</translation></message>
<message><source>Why</source><translation>Pourquoi</translation></message>
<message><source>strongest</source><translation>la plus forte</translation></message>
<message><source>the demo after the blast</source><translation>la démo après le tir</translation></message>
<message><source>%1, scan %2</source><translation>%1, scan %2</translation></message>
<message><source>the first: the others are placed against it</source><translation>le premier : les autres sont placés par rapport à lui</translation></message>
<message><source>OUT OF SPEC, residual %1 mm</source><translation>HORS TOLÉRANCE, résidu %1 mm</translation></message>
<message><source>registered, residual %1 mm</source><translation>recalé, résidu %1 mm</translation></message>
<message><source>placed by targets, %1 mm apart</source><translation>placé par cibles, écart %1 mm</translation></message>
<message><source>placed by pose</source><translation>placé par la pose</translation></message>
<message><source>The layer could not be read (%1).</source><translation>La couche n'a pas pu être lue (%1).</translation></message>
<message><source>Where is the layer now?</source><translation>Où est la couche maintenant ?</translation></message>
<message><source>This point is of the layer %1: make it active to measure in it.</source><translation>Ce point est de la couche %1 : activez-la pour y mesurer.</translation></message>
<message><source>Make Active</source><translation>Activer</translation></message>
<message><source>Add scans as layers</source><translation>Ajouter des scans comme couches</translation></message>
<message><source>Layers are scans of files: open the first one, or record the sweep and open its recording.</source><translation>Les couches sont des scans de fichiers : ouvrez le premier, ou enregistrez le balayage et ouvrez l'enregistrement.</translation></message>
<message><source>A cloud has at most %1 layers: remove some first.</source><translation>Un nuage a au plus %1 couches : retirez-en d'abord.</translation></message>
<message><source>Add a Layer</source><translation>Ajouter une couche</translation></message>
<message><source>Remove the Layer</source><translation>Retirer la couche</translation></message>
<message><source>Show the Layer</source><translation>Afficher la couche</translation></message>
<message><source>Hide the Layer</source><translation>Masquer la couche</translation></message>
<message><source>Locate the Layer</source><translation>Localiser la couche</translation></message>
<message><source>Three places are needed that both scans show: pin them here as targets 1, 2 and 3, make %1 active, pin the same places there in the same order, and come back.</source><translation>Il faut trois endroits visibles dans les deux scans : marquez-les ici comme cibles 1, 2 et 3, activez %1, marquez-y les mêmes endroits dans le même ordre, puis revenez.</translation></message>
<message><source>Reading the layer %1</source><translation>Lecture de la couche %1</translation></message>
<message><source>Cancelled</source><translation>Annulé</translation></message>
<message><source>The same scan is a layer already: remove one of the two.</source><translation>Le même scan est déjà une couche : retirez l'une des deux.</translation></message>
<message><source>Layer %1: %2</source><translation>Couche %1 : %2</translation></message>
<message><source>%1 points · %2 of memory</source><translation>%1 points · %2 de mémoire</translation></message>
<message><source>active</source><translation>active</translation></message>
<message><source>▲ active, not placed</source><translation>▲ active, non placée</translation></message>
<message><source>▲ not placed</source><translation>▲ non placée</translation></message>
<message><source>▲ not read</source><translation>▲ non lue</translation></message>
<message><source>being read</source><translation>en cours de lecture</translation></message>
<message><source>▲ not placed against the active one</source><translation>▲ non placée par rapport à l'active</translation></message>
<message><source>Target %1: %2 mm apart</source><translation>Cible %1 : à %2 mm</translation></message>
<message><source>sweep %1: %2 lines</source><translation>balayage %1 : %2 lignes</translation></message>
<message><source>sweep %1: %2/%3 lines, complete</source><translation>balayage %1 : %2/%3 lignes, complet</translation></message>
<message><source>sweep %1: %2/%3 lines, partial</source><translation>balayage %1 : %2/%3 lignes, partiel</translation></message>
<message><source>How the stepper turns the scanner is not known.</source><translation>La rotation du scanner par le moteur n'est pas connue.</translation></message>
<message><source>How the stepper turns the scanner is not known. Edges are found all the same, but the shape of the cloud is assumed until you give it.</source><translation>La rotation du scanner par le moteur n'est pas connue. Les arêtes sont trouvées quand même, mais la forme du nuage est supposée tant que vous ne l'indiquez pas.</translation></message>
<message><source>There is no host to connect to: type the scanner's name or address.</source><translation>Il n'y a pas d'hôte auquel se connecter : tapez le nom ou l'adresse du scanner.</translation></message>
<message><source>%1 cannot be connected to: type the scanner's name or address, or ws://ROBOT for a robot with ROS.</source><translation>Impossible de se connecter à %1 : tapez le nom ou l'adresse du scanner, ou ws://ROBOT pour un robot avec ROS.</translation></message>
<message><source>It begins with the sweep under way: %1 lines of it came before Record.</source><translation>Il commence par le balayage en cours : %1 lignes de celui-ci sont arrivées avant Enregistrer.</translation></message>
<message><source>Give it…</source><translation>L'indiquer…</translation></message>
<message><source>The first %1 lines of this sweep are too old to be moved to their new places.</source><translation>Les %1 premières lignes de ce balayage sont trop anciennes pour être déplacées.</translation></message>
<message><source>The recording in progress has the old mounting and steps. Correct them with Scan &gt; How the Scan Is Read after you open it, or start another recording.</source><translation>L'enregistrement en cours indique l'ancien montage et les anciens pas : corrigez-le par Scan &gt; Comment le scan est lu à son ouverture, ou commencez-en un autre.</translation></message>
<message><source>last line %1</source><translation>dernière ligne %1</translation></message>
<message><source>last line %1 at %2 UTC</source><translation>dernière ligne %1 à %2 UTC</translation></message>
<message><source>trying to connect again</source><translation>nouvel essai de connexion</translation></message>
<message><source>Waiting for the first line</source><translation>En attente de la première ligne</translation></message>
<message><source>▲ The shape is assumed: give the step in Scan &gt; Sweep…</source><translation>▲ La forme est supposée : indiquez le pas dans Scan &gt; Balayage…</translation></message>
<message><source>▲ The direction of the cloud is assumed: give the first line in Scan &gt; Sweep…</source><translation>▲ La direction du nuage est supposée : indiquez la première ligne dans Scan &gt; Balayage…</translation></message>
<message><source>▲ The ranges show the mounting: confirm it in Scan &gt; Sweep…</source><translation>▲ Les distances montrent le montage : confirmez-le dans Scan &gt; Balayage…</translation></message>
<message><source>▲ The shape is assumed: give mounting and step in Scan &gt; Sweep…</source><translation>▲ La forme est supposée : indiquez montage et pas dans Scan &gt; Balayage…</translation></message>
<message><source>Sweep %1 is held on the screen. Follow shows its newest lines.</source><translation>Le balayage %1 est figé à l'écran. Suivre montre ses lignes les plus récentes.</translation></message>
<message><source>Sweep %1 is held on the screen. Follow shows sweep %2, which grows now.</source><translation>Le balayage %1 est figé à l'écran. Suivre montre le balayage %2, qui croît maintenant.</translation></message>
<message><source>Sweep %1 is a part: %2 of %3 lines.</source><translation>Le balayage %1 est partiel : %2 lignes sur %3.</translation></message>
<message><source>On the screen: %1</source><translation>À l'écran : %1</translation></message>
<message><source>%1 was held with %2 lines when the connection ended.</source><translation>%1 était figé avec %2 lignes quand la connexion s'est terminée.</translation></message>
<message><source>%1 is a part: %2 of %3 lines. The scanner was in the middle of it when EdgeScan connected.</source><translation>%1 est partiel : %2 lignes sur %3. Le scanner était au milieu de ce balayage quand EdgeScan s'est connecté.</translation></message>
<message><source>The next sweep replaces it.</source><translation>Le balayage suivant le remplace.</translation></message>
<message><source>%1 has ended: %2 lines. How many lines a sweep has is not known.</source><translation>%1 est terminé : %2 lignes. Le nombre de lignes d'un balayage n'est pas connu.</translation></message>
<message><source>%1 is complete: %2 lines.</source><translation>%1 est complet : %2 lignes.</translation></message>
<message><source>%1 has ended.</source><translation>%1 s'est terminé.</translation></message>
<message><source>Held. Follow shows the next ones, until Hold.</source><translation>Figé. Suivre montre la suite jusqu'à Figer.</translation></message>
<message><source>Folder for recordings</source><translation>Dossier des enregistrements</translation></message>
<message><source>Scan %1</source><translation>Scan %1</translation></message>
<message><source>Edges and rocks are candidates: geometry only, one viewpoint. What is hidden behind a surface was not measured.</source><translation>Les arêtes et les blocs sont des candidats : géométrie seule, un point de vue. Ce qui est caché derrière une surface n'a pas été mesuré.</translation></message>
<message><source>Warnings</source><translation>Avertissements</translation></message>
<message><source>None was raised when this file was read.</source><translation>Aucun à la lecture de ce fichier.</translation></message>
<message><source>and %1 more in the record.</source><translation>et %1 de plus dans l'enregistrement.</translation></message>
<message><source>Remark</source><translation>Remarque</translation></message>
<message><source>What, when, by whom</source><translation>Quoi, quand, par qui</translation></message>
<message><source>Site</source><translation>Site</translation></message>
<message><source>File</source><translation>Fichier</translation></message>
<message><source>Format</source><translation>Format</translation></message>
<message><source>Grid</source><translation>Grille</translation></message>
<message><source>Distances</source><translation>Distances</translation></message>
<message><source>%1 to %2 measured; gray levels from %3 to %4</source><translation>mesurées de %1 à %2 ; niveaux de gris de %3 à %4</translation></message>
<message><source>none was measured</source><translation>aucune mesurée</translation></message>
<message><source>Scanned</source><translation>Scanné</translation></message>
<message><source>the file does not say</source><translation>le fichier ne le dit pas</translation></message>
<message><source>%1 (as the pose says)</source><translation>%1 (selon la pose)</translation></message>
<message><source>Scanner</source><translation>Scanner</translation></message>
<message><source>serial %1</source><translation>numéro de série %1</translation></message>
<message><source>Uncertainty</source><translation>Incertitude</translation></message>
<message><source>ranges ± %1 m at %2 m, ± %3 m at %4 m (two standard deviations)</source><translation>distances ± %1 m à %2 m, ± %3 m à %4 m (deux écarts-types)</translation></message>
<message><source>%1; the pose does not say its own</source><translation>%1 ; la pose n'indique pas la sienne</translation></message>
<message><source>Edges</source><translation>Arêtes</translation></message>
<message><source>%1 cells, %2 % of those measured</source><translation>%1 cellules, %2 % des cellules mesurées</translation></message>
<message><source>Method</source><translation>Méthode</translation></message>
<message><source>Report by</source><translation>Rapport de</translation></message>
<message><source>not said</source><translation>non indiqué</translation></message>
<message><source>Made</source><translation>Fait</translation></message>
<message><source>Where</source><translation>Où</translation></message>
<message><source>Position</source><translation>Position</translation></message>
<message><source>not known: no pose</source><translation>inconnue : pas de pose</translation></message>
<message><source>E %1, N %2, RL %3 m (scanner)</source><translation>E %1, N %2, RL %3 m (scanner)</translation></message>
<message><source>Frame</source><translation>Repère</translation></message>
<message><source>scanner's own frame; no pose was given</source><translation>celui du scanner ; aucune pose n'a été donnée</translation></message>
<message><source>mine grid%1</source><translation>grille de la mine%1</translation></message>
<message><source>Robot</source><translation>Robot</translation></message>
<message><source>the pose does not say</source><translation>la pose ne le dit pas</translation></message>
<message><source>Pose</source><translation>Pose</translation></message>
<message><source>at a time that it does not say</source><translation>à une heure qu'elle n'indique pas</translation></message>
<message><source>%1, the start of the scan is not known</source><translation>%1, le début du scan n'est pas connu</translation></message>
<message><source>%1 s before the start of the scan</source><translation>%1 s avant le début du scan</translation></message>
<message><source>%1 s after the start of the scan</source><translation>%1 s après le début du scan</translation></message>
<message><source>Turning view</source><translation>Vue tournante</translation></message>
<message><source>Drag to turn, wheel or two fingers to come nearer, click a point for its numbers. Keys: arrows turn, + and - come nearer, Shift and arrows shift, Enter picks what is in the middle, Home goes back. Shown, evenly chosen: %1 and %2.</source><translation>Glissez pour tourner, molette ou deux doigts pour approcher, cliquez sur un point pour ses nombres. Touches : les flèches tournent, + et - approchent, Maj et flèches déplacent, Entrée choisit ce qui est au milieu, Début revient. Montrés, choisis régulièrement : %1 et %2.</translation></message>
<message><source>Turn</source><translation>Tourner</translation></message>
<message><source>Edges only</source><translation>Arêtes seules</translation></message>
<message><source>Nearer</source><translation>Plus près</translation></message>
<message><source>Farther</source><translation>Plus loin</translation></message>
<message><source>Larger points</source><translation>Points plus gros</translation></message>
<message><source>From the start</source><translation>Vue de départ</translation></message>
<message><source>No point there.</source><translation>Il n'y a pas de point à cet endroit.</translation></message>
<message><source>Line %1, beam %2: range %3 mm, %4; %5 m.</source><translation>Ligne %1, faisceau %2 : distance %3 mm, %4 ; %5 m.</translation></message>
<message><source>Beam at %1 degrees, line at %2 degrees.</source><translation>Faisceau à %1 degrés, ligne à %2 degrés.</translation></message>
<message><source>Rock %1: visible %2 x %3 m, ± %4 m, at %5 m; candidate - geometry only, one viewpoint.</source><translation>Bloc %1 : visible %2 x %3 m, ± %4 m, à %5 m ; candidat : géométrie seule, un seul point de vue.</translation></message>
<message><source>This browser has no WebGL; the pictures below show the same.</source><translation>Ce navigateur n'a pas WebGL ; les images ci-dessous montrent la même chose.</translation></message>
<message><source>no edge</source><translation>pas d'arête</translation></message>
<message><source>edge</source><translation>arête</translation></message>
<message><source>jump</source><translation>saut</translation></message>
<message><source>convex fold</source><translation>pli convexe</translation></message>
<message><source>concave fold</source><translation>pli concave</translation></message>
<message><source>data border</source><translation>bord des données</translation></message>
<message><source>outline before a void</source><translation>contour devant un vide</translation></message>
<message><source>void rim</source><translation>bord d'un vide</translation></message>
<message><source>Logo</source><translation>Logo</translation></message>
<message><source>Size curve of the visible rocks: share of the rocks over their visible width b</source><translation>Courbe des tailles des blocs visibles : part des blocs selon leur largeur visible b</translation></message>
<message><source>Ranges as gray levels, line by line</source><translation>Distances en niveaux de gris, ligne par ligne</translation></message>
<message><source>Edges on darkened gray levels</source><translation>Arêtes sur niveaux de gris assombris</translation></message>
<message><source>The points in perspective, seen from behind the scanner</source><translation>Les points en perspective, vus de derrière le scanner</translation></message>
<message><source>The rocks in perspective, seen from behind the scanner</source><translation>Les blocs en perspective, vues de derrière le scanner</translation></message>
<message><source>Rocks as coloured faces on gray levels</source><translation>Blocs en faces colorées sur niveaux de gris</translation></message>
<message><source>Targets and measures on gray levels</source><translation>Cibles et mesures sur niveaux de gris</translation></message>
<message><source>What changed, on the grid of this scan</source><translation>Ce qui a changé, sur la grille de ce scan</translation></message>
<message><source>Points of the scan in three dimensions; arrow keys turn, plus and minus come nearer, Enter picks</source><translation>Points du scan en trois dimensions ; les flèches tournent, plus et moins rapprochent et éloignent, Entrée choisit</translation></message>
<message><source>%1 of %2 points</source><translation>%1 points sur %2</translation></message>
<message><source>%1 points</source><translation>%1 points</translation></message>
<message><source>%1 of %2 edge cells</source><translation>%1 cellules d'arête sur %2</translation></message>
<message><source>%1 edge cells</source><translation>%1 cellules d'arête</translation></message>
<message><source>Pictures</source><translation>Images</translation></message>
<message><source>equal ratios</source><translation>rapports égaux</translation></message>
<message><source>Gray levels: black is %1 and nearer, or nothing came back; white is %2 and farther. Across: %3; down: %4.</source><translation>Niveaux de gris : noir est %1 et plus près, ou rien n'est revenu ; blanc est %2 et plus loin. En largeur : %3 ; vers le bas : %4.</translation></message>
<message><source>Edges. Across: %1; down: %2.</source><translation>Arêtes. En largeur : %1 ; vers le bas : %2.</translation></message>
<message><source>%1 beams, %2 to %3 degrees</source><translation>%1 faisceaux, %2 à %3 degrés</translation></message>
<message><source>%1 lines, %2 to %3 degrees</source><translation>%1 lignes, %2 à %3 degrés</translation></message>
<message><source>%1 beams</source><translation>%1 faisceaux</translation></message>
<message><source>edge (%1)</source><translation>arête (%1)</translation></message>
<message><source>jump (%1)</source><translation>saut (%1)</translation></message>
<message><source>convex fold (%1)</source><translation>pli convexe (%1)</translation></message>
<message><source>concave fold (%1)</source><translation>pli concave (%1)</translation></message>
<message><source>data border (%1)</source><translation>limite des données (%1)</translation></message>
<message><source>outline before a void (%1)</source><translation>contour devant un vide (%1)</translation></message>
<message><source>void rim (%1)</source><translation>bord de vide (%1)</translation></message>
<message><source>%1 of the edge cells are likely the border of a rock (30 % likely and more), %2 are folds within a rock, %3 are unknown.</source><translation>%1 des cellules d'arête sont probablement le contour d'un bloc (30 % et plus), %2 sont des plis dans un bloc, %3 sont inconnues.</translation></message>
<message><source>%1 m at the middle of the cloud</source><translation>%1 m au milieu du nuage</translation></message>
<message><source>The points, edges in their colours.</source><translation>Les points, les arêtes dans leurs couleurs.</translation></message>
<message><source>Rocks</source><translation>Blocs</translation></message>
<message><source>%1 rocks, each a candidate - geometry only, one viewpoint.</source><translation>%1 blocs, chacun candidat : géométrie seule, un point de vue.</translation></message>
<message><source>Sizes of the visible rocks</source><translation>Tailles des blocs visibles</translation></message>
<message><source>visible width b [m]</source><translation>largeur visible b [m]</translation></message>
<message><source>rocks that are not wider</source><translation>blocs qui ne sont pas plus larges</translation></message>
<message><source>largest %1</source><translation>plus grande %1</translation></message>
<message><source>%1 % over %2</source><translation>%1 % au-dessus de %2</translation></message>
<message><source>The rocks with the largest visible width b</source><translation>Les blocs de plus grande largeur visible b</translation></message>
<message><source>On a narrow screen only the rocks of the table have their numbers.</source><translation>Sur un écran étroit seuls les blocs du tableau ont leurs numéros.</translation></message>
<message><source>Completeness</source><translation>Complétude</translation></message>
<message><source>INCOMPLETE</source><translation>INCOMPLET</translation></message>
<message><source>%1 of %2 lines, %3 cells.</source><translation>%1 lignes sur %2, %3 cellules.</translation></message>
<message><source>measured</source><translation>mesurées</translation></message>
<message><source>status of the scanner</source><translation>état du scanner</translation></message>
<message><source>outside the range window</source><translation>hors de la fenêtre de distances</translation></message>
<message><source>lost line</source><translation>ligne perdue</translation></message>
<message><source>Settings</source><translation>Réglages</translation></message>
<message><source>File and program</source><translation>Fichier et programme</translation></message>
<message><source>auto: %1</source><translation>auto : %1</translation></message>
<message><source>%1 cells</source><translation>%1 cellules</translation></message>
<message><source>%1 steps</source><translation>%1 pas</translation></message>
<message><source>%1 % of range</source><translation>%1 % de la distance</translation></message>
<message><source>%1 % of high</source><translation>%1 % du haut</translation></message>
<message><source>changed from the default</source><translation>différent de la valeur usuelle</translation></message>
<message><source>The command that makes this report as a page for browsers</source><translation>La commande qui fait ce rapport comme page pour navigateurs</translation></message>
<message><source>SHA-256 of the file</source><translation>SHA-256 du fichier</translation></message>
<message><source>SHA-256 of the grid</source><translation>SHA-256 de la grille</translation></message>
<message><source>SHA-256 of the edge mask</source><translation>SHA-256 du masque d'arêtes</translation></message>
<message><source>none</source><translation>aucune</translation></message>
<message><source>Program</source><translation>Programme</translation></message>
<message><source>EdgeScan %1, commit %2</source><translation>EdgeScan %1, commit %2</translation></message>
<message><source>The whole record</source><translation>L'enregistrement complet</translation></message>
<message><source>Targets and measures</source><translation>Cibles et mesures</translation></message>
<message><source>Target</source><translation>Cible</translation></message>
<message><source>Name and note</source><translation>Nom et note</translation></message>
<message><source>Cell</source><translation>Cellule</translation></message>
<message><source>Where, and its edge now</source><translation>Où, et son arête maintenant</translation></message>
<message><source>Also on its card when it was pinned</source><translation>Aussi sur sa fiche quand elle fut épinglée</translation></message>
<message><source>Pinned</source><translation>Épinglée</translation></message>
<message><source>Measured</source><translation>Mesures</translation></message>
<message><source>Result, ± two standard deviations</source><translation>Résultat, ± deux écarts-types</translation></message>
<message><source>From</source><translation>De</translation></message>
<message><source>no cell of this scan</source><translation>pas une cellule de ce scan</translation></message>
<message><source>its cells hold no points now</source><translation>ses cellules n'ont pas de points maintenant</translation></message>
<message><source>M%1 %2</source><translation>M%1 %2</translation></message>
<message><source>E, N, RL: %1</source><translation>E, N, RL : %1</translation></message>
<message><source>Distance: %1</source><translation>Distance : %1</translation></message>
<message><source>Dip / direction: %1</source><translation>Pendage / direction : %1</translation></message>
<message><source>Edge: %1</source><translation>Arête : %1</translation></message>
<message><source>Resolves: %1</source><translation>Résolution : %1</translation></message>
<message><source>Surface: %1</source><translation>Surface : %1</translation></message>
<message><source>From the boom: %1</source><translation>Au bras : %1</translation></message>
<message><source>Confidence: %1</source><translation>Confiance : %1</translation></message>
<message><source>%1° ± %2° off the beam</source><translation>à %1° ± %2° du faisceau</translation></message>
<message><source>%1 · surface %2° off square</source><translation>%1 · surface à %2° de la perpendiculaire</translation></message>
<message><source>%1 % of %2 settings</source><translation>%1 % de %2 réglages</translation></message>
<message><source>raw grid</source><translation>grille brute</translation></message>
<message><source>%1, strength %2</source><translation>%1, force %2</translation></message>
<message><source>no plane fits</source><translation>aucun plan ne convient</translation></message>
<message><source>▲ no pose</source><translation>▲ sans pose</translation></message>
<message><source>nothing was measured in this cell</source><translation>rien n'a été mesuré dans cette cellule</translation></message>
<message><source>Before and after</source><translation>Avant et après</translation></message>
<message><source>▲ OUT OF SPEC: the warnings below say why.</source><translation>▲ HORS TOLÉRANCE : les avertissements ci-dessous disent pourquoi.</translation></message>
<message><source>Before: %1. Surfaces and edges that this scan shows otherwise; what is hidden in one of the two is not a change.</source><translation>Avant : %1. Surfaces et arêtes que ce scan montre autrement ; ce qui est caché dans l'un des deux n'est pas un changement.</translation></message>
<message><source>+ edge gained, or surface nearer</source><translation>+ arête gagnée, ou surface plus proche</translation></message>
<message><source>− edge lost, or surface farther</source><translation>− arête perdue, ou surface plus loin</translation></message>
<message><source>= edge kept</source><translation>= arête conservée</translation></message>
<message><source>%1 has an uncertain outline (hatched); %2 pieces are too small to be shown as rocks</source><translation>%1 a un contour incertain (hachuré) ; %2 morceaux sont trop petits pour être montrés comme blocs</translation></message>
<message><source>%1 have an uncertain outline (hatched); %2 pieces are too small to be shown as rocks</source><translation>%1 ont un contour incertain (hachuré) ; %2 morceaux sont trop petits pour être montrés comme blocs</translation></message>
<message><source>, %1 are outside the region of interest</source><translation>, %1 sont hors de la région d'intérêt</translation></message>
<message><source>; %1 change was made by hand</source><translation> ; %1 changement fut fait à la main</translation></message>
<message><source>; %1 changes were made by hand</source><translation> ; %1 changements furent faits à la main</translation></message>
<message><source>Level %1 of -4 (fine) to 4 (coarse).</source><translation>Niveau %1 de -4 (fin) à 4 (grossier).</translation></message>
<message><source>Visible width b: P20 %1 m, P50 %2 m, P80 %3 m (20, 50 and 80 % of the rocks are not wider), largest %4 m</source><translation>Largeur visible b : P20 %1 m, P50 %2 m, P80 %3 m (20, 50 et 80 % des blocs ne sont pas plus larges), la plus grande %4 m</translation></message>
<message><source>; %1 % over the site's %2 m</source><translation> ; %1 % au-dessus des %2 m du site</translation></message>
<message><source>by number of visible rocks; hidden parts make it finer than the pile is, by 40 % and more</source><translation>par nombre de blocs visibles ; à cause des parties cachées elle est plus fine que le tas, de 40 % et plus</translation></message>
<message><source>Rocks as faces, uncertain ones hatched. Colours only separate neighbours. The numbers are those of the table, the drawing and the files.</source><translation>Blocs en faces, les incertains hachurés. Les couleurs séparent seulement les voisins. Les numéros sont ceux du tableau, du dessin et des fichiers.</translation></message>
<message><source>The rocks on the points.</source><translation>Les blocs sur les points.</translation></message>
<message><source>%1 numbers of smaller rocks have no room and are left out.</source><translation>%1 numéros de blocs plus petits manquent, faute de place.</translation></message>
<message><source>The %1 largest (visible width b) of %2 rocks; the export of rocks as a table lists all.</source><translation>Les %1 plus grands (largeur visible b) de %2 blocs ; l'export des blocs en tableau les a tous.</translation></message>
<message><source>The %1 largest (visible width b) of %2 rocks; %3 more are over the site's %4; the export of rocks as a table lists all.</source><translation>Les %1 plus grands (largeur visible b) de %2 blocs ; %3 autres dépassent les %4 du site ; l'export des blocs en tableau les a tous.</translation></message>
<message><source>E, N, RL: mean of the visible points, in the mine grid</source><translation>E, N, RL : moyenne des points visibles, dans la grille de la mine</translation></message>
<message><source>x, y, z: mean of the visible points, in the scanner's frame.</source><translation>x, y, z : moyenne des points visibles, dans le repère du scanner.</translation></message>
<message><source>a and b: visible spans across the line of sight; hidden parts are not counted. Distance: median of its ranges. Area: visible, across the beams. In front: share of the outline where the rock is the nearer side. Contacts and free height: at least. Arch: largest angle at the rock between two that it touches; ↓ it hangs below the line between them. p: chance that the outline is right; ▲ below 0.85, hatched.</source><translation>a et b : étendues visibles en travers de la ligne de visée ; les parties cachées ne comptent pas. Distance : médiane de ses distances. Aire : visible, en travers des faisceaux. Devant : part du contour où le bloc est le côté le plus proche. Contacts et hauteur libre : au moins. Arc : plus grand angle au bloc entre deux qu'il touche ; ↓ il pend sous la ligne entre eux. p : chance que le contour soit juste ; ▲ inférieure à 0.85, hachuré.</translation></message>
<message><source>Without a pose, up is the scanner's z axis, which is assumed: free height and ↓ are measured along it.</source><translation>Sans pose, le haut est l'axe z du scanner, ce qui est supposé : la hauteur libre et ↓ se mesurent le long de cet axe.</translation></message>
<message><source>Number with ▲: merged by hand of parts that do not touch.</source><translation>Numéro avec ▲ : réunie à la main de parties qui ne se touchent pas.</translation></message>
<message><source>The targets by their numbers, and what was measured. Black is near, or nothing came back.</source><translation>Les cibles par leurs numéros, et ce qui a été mesuré. Noir est proche, ou rien n'est revenu.</translation></message>
<message><source>%1 value has no room in the picture; the table has all.</source><translation>%1 valeur n'a pas de place dans l'image ; le tableau les a toutes.</translation></message>
<message><source>%1 values have no room in the picture; the table has all.</source><translation>%1 valeurs n'ont pas de place dans l'image ; le tableau les a toutes.</translation></message>
<message><source>; other cells: points of one moved to the grid of the other</source><translation> ; autres cellules : points de l'un portés sur la grille de l'autre</translation></message>
<message><source>edges: %1 + gained, %2 - lost, %3 kept, %4 not seen by the other</source><translation>arêtes : %1 + gagnées, %2 - perdues, %3 conservées, %4 non vues par l'autre</translation></message>
<message><source>cells: %1 nearer, %2 farther, %3 same, %4 no range now, %5 no range before</source><translation>cellules : %1 plus proches, %2 plus loin, %3 égales, %4 sans distance maintenant, %5 sans distance avant</translation></message>
<message><source>median difference</source><translation>différence médiane</translation></message>
<message><source>a change is more than %1 standard deviations: %2 mm at 5 m, %3 mm at 10 m</source><translation>un changement dépasse %1 écarts-types : %2 mm à 5 m, %3 mm à 10 m</translation></message>
<message><source>%1 regions of %2 cells and more, visible surface from one viewpoint</source><translation>%1 régions de %2 cellules et plus, surface visible d'un point de vue</translation></message>
<message><source>View %1 is stored.</source><translation>La vue %1 est enregistrée.</translation></message>
<message><source>There is no view %1 yet: Ctrl+%1 stores the present one.</source><translation>Il n'y a pas encore de vue %1 : Ctrl+%1 enregistre l'actuelle.</translation></message>
<message><source>There is nothing to report yet: open a scan first.</source><translation>Il n'y a encore rien à rapporter : ouvrez d'abord un scan.</translation></message>
<message><source>Report</source><translation>Rapport</translation></message>
<message><source>Page for any browser (*.html)</source><translation>Page pour tout navigateur (*.html)</translation></message>
<message><source>PDF (*.pdf)</source><translation>PDF (*.pdf)</translation></message>
<message><source>Making the report %1</source><translation>Création du rapport %1</translation></message>
<message><source>pages to print</source><translation>des pages à imprimer</translation></message>
<message><source>a page for any browser</source><translation>une page pour tout navigateur</translation></message>
<message><source>The report could not be made (%1).</source><translation>Le rapport n'a pas pu être établi (%1).</translation></message>
<message><source>RL [m]</source><translation>RL [m]</translation></message>
<message><source>above the scanner [m]</source><translation>au-dessus du scanner [m]</translation></message>
<message><source>The section could not be computed (%1).</source><translation>La coupe n'a pas pu être calculée (%1).</translation></message>
<message><source>Se&amp;ction</source><translation>&amp;Coupe</translation></message>
<message><source>Measure a distance first: a section goes through its two ends.</source><translation>Mesurez d'abord une distance : la coupe passe par ses deux extrémités.</translation></message>
<message><source>Select a rock first: show the rocks and click on the face of one.</source><translation>Sélectionnez d'abord un bloc : affichez les blocs et cliquez sur la face de l'un d'eux.</translation></message>
<message><source>The plane of the section meets no surface: choose two other cells.</source><translation>Le plan de la coupe ne rencontre aucune surface : choisissez deux autres cellules.</translation></message>
<message><source>Vertical plane, true scale; dash-dotted in the views.</source><translation>Plan vertical, échelle vraie ; trait mixte dans les vues.</translation></message>
<message><source>Rocks have their colours.</source><translation>Les blocs ont leurs couleurs.</translation></message>
<message><source>▲ no pose: up is the scanner's z</source><translation>▲ pas de pose : le haut est le z du scanner</translation></message>
<message><source>The rocks are still being computed: export the section again in a moment.</source><translation>Les blocs sont encore en cours de calcul : exportez de nouveau la coupe dans un instant.</translation></message>
<message><source>Export Section</source><translation>Exporter la coupe</translation></message>
<message><source>Drawing (*.dxf)</source><translation>Dessin (*.dxf)</translation></message>
<message><source>Table (*.csv)</source><translation>Tableau (*.csv)</translation></message>
<message><source>Picture (*.png)</source><translation>Image (*.png)</translation></message>
<message><source>class %1 on</source><translation>classe %1 activée</translation></message>
<message><source>class %1 off</source><translation>classe %1 désactivée</translation></message>
<message><source>%1 %2 to %3</source><translation>%1 de %2 à %3</translation></message>
<message><source>settings</source><translation>réglages</translation></message>
<message><source>This scan is flat and quiet: with the preset Smooth walls low steps far away are edges too.</source><translation>Ce scan est plat et peu bruité : avec le préréglage Parois lisses, les faibles marches lointaines sont aussi des arêtes.</translation></message>
<message><source>Use It</source><translation>L'utiliser</translation></message>
<message><source>Open preset</source><translation>Ouvrir un préréglage</translation></message>
<message><source>EdgeScan presets (*.json)</source><translation>Préréglages EdgeScan (*.json)</translation></message>
<message><source>Save preset</source><translation>Enregistrer le préréglage</translation></message>
<message><source>%1 is not a preset and stays as it is: choose another name.</source><translation>%1 n'est pas un préréglage et reste tel quel : choisissez un autre nom.</translation></message>
<message><source>a section</source><translation>une coupe</translation></message>
<message><source>a section of %1</source><translation>une coupe de %1</translation></message>
<message><source>%1 edge points</source><translation>%1 points d'arête</translation></message>
<message><source>Nothing is selected yet: drag a box (B) or a lasso (L) over a view first.</source><translation>Rien n'est encore sélectionné : tracez d'abord une boîte (B) ou un lasso (L) sur une vue.</translation></message>
<message><source>There is nothing to export yet: open a scan first.</source><translation>Il n'y a encore rien à exporter : ouvrez d'abord un scan.</translation></message>
<message><source>Export %1 points</source><translation>Exporter %1 points</translation></message>
<message><source>Export targets: %1</source><translation>Exporter les cibles : %1</translation></message>
<message><source>Export</source><translation>Exporter</translation></message>
<message><source>Save screenshot</source><translation>Enregistrer la capture d'écran</translation></message>
<message><source>PNG picture (*.png)</source><translation>Image PNG (*.png)</translation></message>
<message><source>a picture of the window</source><translation>une image de la fenêtre</translation></message>
<message><source>There is no file on the screen that could be read in another way: open one first.</source><translation>Il n'y a à l'écran aucun fichier qui pourrait être lu autrement : ouvrez-en d'abord un.</translation></message>
<message><source>All supported (%1)</source><translation>Tous les formats pris en charge (%1)</translation></message>
<message><source>All files (*)</source><translation>Tous les fichiers (*)</translation></message>
<message><source>Open scan</source><translation>Ouvrir un scan</translation></message>
<message><source>This is the last scan of the series or folder.</source><translation>C'est le dernier scan de la série ou du dossier.</translation></message>
<message><source>This is the first scan of the series or folder.</source><translation>C'est le premier scan de la série ou du dossier.</translation></message>
<message><source>Straighten Beams</source><translation>Redresser les faisceaux</translation></message>
<message><source>Beams as Recorded</source><translation>Faisceaux tels qu'enregistrés</translation></message>
<message><source>Keep Repeated Values</source><translation>Garder les valeurs répétées</translation></message>
<message><source>Repeated Values as No Return</source><translation>Valeurs répétées comme sans retour</translation></message>
<message><source>Read it in another way…</source><translation>Lire autrement…</translation></message>
<message><source>How the Scan Is Read</source><translation>Comment le scan est lu</translation></message>
<message><source>%1 was moved or removed. Its picture stays on the screen.</source><translation>%1 a été déplacé ou supprimé. Son image reste à l'écran.</translation></message>
<message><source>%1 was written again. The picture shows what was in it before.</source><translation>%1 a été réécrit. L'image montre ce qu'il contenait avant.</translation></message>
<message><source>Read again</source><translation>Relire</translation></message>
<message><source>%1, a pose of 3DTK, is not read with the scan: type the place of the scanner at Scan &gt; Pose and Mounting.</source><translation>%1, une pose de 3DTK, n'est pas lue avec le scan : saisissez la place du scanner dans Scan &gt; Pose et montage.</translation></message>
<message><source>Straighten beams</source><translation>Redresser les faisceaux</translation></message>
<message><source>Keep as measured</source><translation>Garder comme mesuré</translation></message>
<message><source>No file yet; demos are not listed</source><translation>Aucun fichier pour l'instant ; les démos ne figurent pas ici</translation></message>
<message><source>Clear</source><translation>Effacer</translation></message>
<message><source> (%1 of %2)</source><translation> (%1 sur %2)</translation></message>
<message><source>Does this look right?</source><translation>Est-ce que cela paraît juste ?</translation></message>
<message><source>On the screen, not yet adopted: %1</source><translation>À l'écran, pas encore adopté : %1</translation></message>
<message><source>The scanner looks forward: what is above it without a pose is now in front of it. If it looks up into a bell, choose “up” on the page Mounting.</source><translation>Le scanner regarde vers l'avant : ce qui est au-dessus de lui sans pose est maintenant devant lui. S'il regarde vers le haut dans une cloche, choisissez « vers le haut » sur la page Montage.</translation></message>
<message><source>The mounting looks up, but pitch and roll turn it to the side: type 0 and 0 for a level boom, or choose “forward” on the page Mounting.</source><translation>Le montage regarde vers le haut, mais tangage et roulis le tournent sur le côté : tapez 0 et 0 pour un bras de niveau, ou choisissez « vers l'avant » sur la page Montage.</translation></message>
<message><source>The mounting looks up, but %1 % of the points are lower than the scanner: correct pitch and roll, or choose another direction on the page Mounting.</source><translation>Le montage regarde vers le haut, mais %1 % des points sont plus bas que le scanner : corrigez tangage et roulis, ou choisissez une autre direction sur la page Montage.</translation></message>
<message><source>Scanner at E %1, N %2, RL %3 m. </source><translation>Scanner à E %1, N %2, RL %3 m. </translation></message>
<message><source>It looks %1° below the horizon. </source><translation>Il regarde à %1° sous l'horizon. </translation></message>
<message><source>It looks %1° above the horizon. </source><translation>Il regarde à %1° au-dessus de l'horizon. </translation></message>
<message><source>Its points: </source><translation>Ses points : </translation></message>
<message><source>It failed (%1); close other programs or use a smaller scan.</source><translation>Échec (%1) ; fermez d'autres programmes ou prenez un scan plus petit.</translation></message>
<message><source>Store Pose</source><translation>Enregistrer la pose</translation></message>
<message><source>Remove Pose</source><translation>Enlever la pose</translation></message>
<message><source>Open a scan first.</source><translation>Ouvrez d'abord un scan.</translation></message>
<message><source>The picture does not come from a file, so its pose cannot be stored: open a scan or a recording.</source><translation>L'image ne vient pas d'un fichier, sa pose ne peut donc pas être enregistrée : ouvrez un scan ou un enregistrement.</translation></message>
<message><source>Store the mounting</source><translation>Enregistrer le montage</translation></message>
<message><source>Name of the scanner</source><translation>Nom du scanner</translation></message>
<message><source>The robot's calibration</source><translation>L'étalonnage du robot</translation></message>
<message><source>Calibration (*.json)</source><translation>Étalonnage (*.json)</translation></message>
<message><source>The pose that was stored with the scan is removed.</source><translation>La pose enregistrée avec le scan est supprimée.</translation></message>
<message><source>The pose is stored with the scan, in %1; it replaced the one that was there.</source><translation>La pose est enregistrée avec le scan, dans %1 ; elle remplace celle qui y était.</translation></message>
<message><source>The pose is stored with the scan, in %1.</source><translation>La pose est enregistrée avec le scan, dans %1.</translation></message>
<message><source>The pose could not be stored (%1).</source><translation>La pose n'a pas pu être enregistrée (%1).</translation></message>
<message><source>, %1 min ago</source><translation>, il y a %1 min</translation></message>
<message><source>, %1 h ago</source><translation>, il y a %1 h</translation></message>
<message><source>, %1 days ago</source><translation>, il y a %1 jours</translation></message>
<message><source>Placed by %1</source><translation>Placé par %1</translation></message>
<message><source>HELD, %1 of %2 lines</source><translation>FIGÉ, %1 lignes sur %2</translation></message>
<message><source>HELD, whole sweep</source><translation>FIGÉ, balayage entier</translation></message>
<message><source>HELD, sweep %1 grows</source><translation>FIGÉ, le balayage %1 grandit</translation></message>
<message><source>HELD</source><translation>FIGÉ</translation></message>
<message><source>HELD, 1 line behind</source><translation>FIGÉ, 1 ligne de retard</translation></message>
<message><source>HELD, %1 lines behind</source><translation>FIGÉ, %1 lignes de retard</translation></message>
<message><source> · no time</source><translation> · sans heure</translation></message>
<message><source>What the scanner sends now, with the time of its newest line. %1</source><translation>Ce que le scanner envoie maintenant, avec l'heure de sa ligne la plus récente. %1</translation></message>
<message><source>The connection to the scanner has ended: the time is that of the newest line</source><translation>Le scanner n'est plus connecté : l'heure est celle de la ligne la plus récente</translation></message>
<message><source>The scanner goes on, this picture does not: the time is that of its newest line</source><translation>Le scanner continue, cette image non : l'heure est celle de sa ligne la plus récente</translation></message>
<message><source>NO PICTURE</source><translation>PAS D'IMAGE</translation></message>
<message><source>RECORDED</source><translation>ENREGISTRÉ</translation></message>
<message><source>Last line, by %1</source><translation>Dernière ligne, selon %1</translation></message>
<message><source>FILE</source><translation>FICHIER</translation></message>
<message><source>no time</source><translation>sans heure</translation></message>
<message><source>The file does not say when it was measured</source><translation>Le fichier ne dit pas quand il a été mesuré</translation></message>
<message><source>First line, by %1</source><translation>Première ligne, selon %1</translation></message>
<message><source>COARSE PICTURE</source><translation>IMAGE GROSSIÈRE</translation></message>
<message><source>Some points of the scan that is being opened.</source><translation>Quelques points du scan en cours d'ouverture.</translation></message>
<message><source>OLD PICTURE</source><translation>ANCIENNE IMAGE</translation></message>
<message><source>Another scan is being opened. This is the picture before it.</source><translation>Un autre scan s'ouvre. Ceci est l'image d'avant.</translation></message>
<message><source>%1 Edits of rocks are not stored until then.</source><translation>%1 Les modifications des blocs ne sont pas enregistrées jusque-là.</translation></message>
<message><source>Edits of rocks are not stored: %1</source><translation>Les modifications des blocs ne sont pas enregistrées : %1</translation></message>
<message><source>Split: click the part that is a rock of its own (wheel: smaller or larger)</source><translation>Scinder : cliquez sur la partie qui est un autre bloc (molette : plus petite ou plus grande)</translation></message>
<message><source>Merge: drag a line across the rocks, or click the one that belongs to the selected rock</source><translation>Fusionner : tracez une ligne à travers les blocs, ou cliquez celui qui va avec le bloc sélectionné</translation></message>
<message><source>Cut: drag a line through the rock, or click both its ends</source><translation>Couper : tracez une ligne à travers le bloc, ou cliquez ses deux bouts</translation></message>
<message><source>Region: drag a line around it</source><translation>Région : tracez une ligne autour</translation></message>
<message><source>the whole piece as it is</source><translation>le morceau entier tel quel</translation></message>
<message><source>a click splits it off</source><translation>un clic le sépare</translation></message>
<message><source>larger than the rock: a click merges it</source><translation>plus grand que le bloc : un clic le fusionne</translation></message>
<message><source>no smaller and no larger part</source><translation>aucune partie plus petite ni plus grande</translation></message>
<message><source>wheel: larger (this is the smallest part)</source><translation>molette : plus grand (c'est la plus petite partie)</translation></message>
<message><source>wheel: smaller (this is the largest piece)</source><translation>molette : plus petit (c'est la plus grande pièce)</translation></message>
<message><source>wheel: smaller or larger</source><translation>molette : plus petit ou plus grand</translation></message>
<message><source>%1 cells, %2</source><translation>%1 cellules, %2</translation></message>
<message><source>Nothing was split: click on a rock, on the part that is a rock of its own.</source><translation>Rien n'a été scindé : cliquez sur un bloc, sur la partie qui est un bloc à part.</translation></message>
<message><source>The rocks are still being computed: split again when they are here.</source><translation>Les blocs sont encore en cours de calcul : scindez à nouveau quand ils seront là.</translation></message>
<message><source>split of a rock</source><translation>scission d'un bloc</translation></message>
<message><source>Nothing was split: this rock is one piece without a line that separates parts. Cut along a Line splits it where you draw.</source><translation>Rien n'a été scindé : ce bloc est d'un seul morceau, rien n'y distingue des parties. Couper le long d'une ligne le scinde là où vous dessinez.</translation></message>
<message><source>merge of rocks</source><translation>fusion de blocs</translation></message>
<message><source>Click the other end of the line, past the other side of the rock.</source><translation>Cliquez l'autre bout de la ligne, au-delà de l'autre côté du bloc.</translation></message>
<message><source>cut of a rock</source><translation>coupe d'un bloc</translation></message>
<message><source>Nothing was cut: draw the line through a rock, from one side to the other. Each part needs %1 cells.</source><translation>Rien n'a été coupé : tracez la ligne à travers un bloc, d'un côté à l'autre. Chaque partie doit avoir %1 cellules.</translation></message>
<message><source>Nothing was merged: draw the line from one rock over the crack into the next.</source><translation>Rien n'a été fusionné : tracez la ligne d'un bloc au suivant, par-dessus la fissure.</translation></message>
<message><source>There is no region yet: draw the line round what counts, in one of the images.</source><translation>Il n'y a pas encore de région : tracez la ligne autour de ce qui compte, dans l'une des images.</translation></message>
<message><source>region of interest</source><translation>région d'intérêt</translation></message>
<message><source>Open Session</source><translation>Ouvrir la session</translation></message>
<message><source>The session's edits of rocks replaced those that were stored next to the scan; Ctrl+Z brings them back.</source><translation>Les corrections de blocs de la session ont remplacé celles qui étaient gardées à côté du scan ; Ctrl+Z les ramène.</translation></message>
<message><source>No rock changed, so nothing is to be undone. Click on another part of the rock, or draw across the whole of it, past its outline.</source><translation>Aucun bloc n'a changé, il n'y a donc rien à annuler. Cliquez sur une autre partie du bloc, ou dessinez à travers tout le bloc, au-delà de son contour.</translation></message>
<message><source>Nothing was merged: this is one rock already.</source><translation>Rien n'a été réuni : c'est déjà un seul bloc.</translation></message>
<message><source>mark as a rock</source><translation>marque de bloc</translation></message>
<message><source>mark as not a rock</source><translation>marque de non-bloc</translation></message>
<message><source>There is nothing to export yet: show the rocks of a scan first.</source><translation>Il n'y a encore rien à exporter : affichez d'abord les blocs d'un scan.</translation></message>
<message><source>Export %1 of %2</source><translation>Exporter %1 sur %2</translation></message>
<message><source>Export %1</source><translation>Exporter %1</translation></message>
<message><source>%1 was not written: give it one of the endings %2.</source><translation>%1 n'a pas été écrit : donnez-lui l'une des extensions %2.</translation></message>
<message><source>%1 waits for the rocks</source><translation>%1 attend les blocs</translation></message>
<message><source>%1 was not written: its rocks are not known.</source><translation>%1 n'a pas été écrit : ses blocs ne sont pas connus.</translation></message>
<message><source>the rock could not be cut (%1); close other programs.</source><translation>le bloc n'a pas pu être coupé (%1) ; fermez d'autres programmes.</translation></message>
<message><source>the rocks could not be computed (%1); close other programs or open a smaller scan.</source><translation>les blocs n'ont pas pu être calculés (%1) ; fermez d'autres programmes ou ouvrez un scan plus petit.</translation></message>
<message><source>Another window changed the rocks of this scan. The changes of both windows are kept.</source><translation>Une autre fenêtre a modifié les blocs de ce scan. Les modifications des deux fenêtres sont gardées.</translation></message>
<message><source>▲ of the first %1 lines</source><translation>▲ des %1 premières lignes</translation></message>
<message><source>▲ of the picture before; being computed again</source><translation>▲ de l'image précédente ; nouveau calcul en cours</translation></message>
<message><source>being computed …</source><translation>calcul en cours …</translation></message>
<message><source>No rock was found here: choose Pin to set a target.</source><translation>Il n'y a pas de bloc ici : choisissez Épingler pour poser une cible.</translation></message>
<message><source>This Is a Roc&amp;k</source><translation>C’est un &amp;bloc</translation></message>
<message><source>&amp;Rock %1</source><translation>&amp;Bloc %1</translation></message>
<message><source>Se&amp;lect</source><translation>Sé&amp;lectionner</translation></message>
<message><source>&amp;Merge with Selected Rocks</source><translation>&amp;Fusionner avec les blocs sélectionnés</translation></message>
<message><source>&amp;Split Here</source><translation>&amp;Diviser ici</translation></message>
<message><source>&amp;Cut along a Line</source><translation>&amp;Couper le long d'une ligne</translation></message>
<message><source>&amp;Wall, Not a Rock</source><translation>&amp;Paroi, pas un bloc</translation></message>
<message><source>&amp;Export Rocks…</source><translation>&amp;Exporter les blocs…</translation></message>
<message><source>Rock %1 has the largest visible width b, %2 m. Rock 1 has the largest visible area.</source><translation>Le bloc %1 a la plus grande largeur visible b, %2 m. Le bloc 1 a la plus grande surface visible.</translation></message>
<message><source>No rock has a smaller visible width b.</source><translation>Aucun bloc n'a une largeur visible b plus petite.</translation></message>
<message><source>EdgeScan sessions (*%1)</source><translation>Sessions EdgeScan (*%1)</translation></message>
<message><source>JSON files (*.json)</source><translation>Fichiers JSON (*.json)</translation></message>
<message><source>The session is not saved (%1).</source><translation>La session n'est pas enregistrée (%1).</translation></message>
<message><source>The session is not saved: %1</source><translation>La session n'est pas enregistrée : %1</translation></message>
<message><source>from now on saved as it changes</source><translation>enregistrée désormais à chaque changement</translation></message>
<message><source>There is nothing to save yet: open a scan first. To store a live sweep, record it.</source><translation>Il n'y a encore rien à enregistrer : ouvrez d'abord un scan. Un balayage en direct se garde en l'enregistrant.</translation></message>
<message><source>Save session</source><translation>Enregistrer la session</translation></message>
<message><source>%1 is not a session and stays as it is: choose another name.</source><translation>%1 n'est pas une session et reste tel quel : choisissez un autre nom.</translation></message>
<message><source>Open session</source><translation>Ouvrir une session</translation></message>
<message><source>Screenshots (*.png)</source><translation>Captures d'écran (*.png)</translation></message>
<message><source>%1: this is not a session; choose a session, or a screenshot that carries one.</source><translation>%1 : ce n'est pas une session ; choisissez une session, ou une capture d'écran qui en contient une.</translation></message>
<message><source>%1: the scan of this session was not found. It was moved, or its disk is missing. Settings and view are restored. The rest needs the scan.</source><translation>%1 : le scan de cette session est introuvable. Il a été déplacé, ou son disque manque. Réglages et vue sont repris. Le reste demande le scan.</translation></message>
<message><source>Locate…</source><translation>Localiser…</translation></message>
<message><source>Where is the scan now?</source><translation>Où est le scan maintenant ?</translation></message>
<message><source>The session %1 is not changed: this is another scan.</source><translation>La session %1 n'est pas modifiée : ceci est un autre scan.</translation></message>
<message><source>%1 is not the scan of this session: its content differs. Settings and view are restored; targets, selection, marks, rocks, A and the camera are not.</source><translation>%1 n'est pas le scan de cette session : son contenu diffère. Réglages et vue sont repris ; cibles, sélection, marques, blocs, A et caméra ne le sont pas.</translation></message>
<message><source>measurements: %1</source><translation>mesures : %1</translation></message>
<message><source>edits of rocks: %1</source><translation>corrections de blocs : %1</translation></message>
<message><source>settings, view</source><translation>réglages, vue</translation></message>
<message><source>Restored: %1. Undo begins here.</source><translation>Rétabli : %1. Annuler commence ici.</translation></message>
<message><source>There is no session to go on with yet: open a scan first.</source><translation>Il n'y a pas encore de session à reprendre : ouvrez d'abord un scan.</translation></message>
<message><source>EdgeScan ended without being closed. What was on the screen at %1 is stored.</source><translation>EdgeScan s'est arrêté sans être fermé. Ce qui était à l'écran le %1 est gardé.</translation></message>
<message><source>Go on where I was</source><translation>Reprendre où j'en étais</translation></message>
<message><source>Nothing could be proposed (%1).</source><translation>Rien n'a pu être proposé (%1).</translation></message>
<message><source>This &amp;is an edge</source><translation>Ceci &amp;est une arête</translation></message>
<message><source>This is &amp;not an edge</source><translation>Ceci &amp;n'est pas une arête</translation></message>
<message><source>Point at a cell or click one first; then say whether an edge is there.</source><translation>Pointez une cellule ou cliquez-la d'abord ; dites ensuite s'il y a une arête.</translation></message>
<message><source>This cell was not marked: there are %1 marks, clear some first.</source><translation>Cette cellule n'a pas été marquée : il y a déjà %1 marques, effacez-en d'abord.</translation></message>
<message><source>Mark as an Edge</source><translation>Marque d’arête</translation></message>
<message><source>Mark as Not an Edge</source><translation>Marque de non-arête</translation></message>
<message><source>the mark “edge” at line %1, beam %2</source><translation>la marque « arête » à la ligne %1, faisceau %2</translation></message>
<message><source>the mark “not an edge” at line %1, beam %2</source><translation>la marque « pas d'arête » à la ligne %1, faisceau %2</translation></message>
<message><source>Clear the Marks</source><translation>Effacer les marques</translation></message>
<message><source>all marks, %1 “edge” and %2 “not an edge”</source><translation>toutes les marques, %1 « arête » et %2 « pas d'arête »</translation></message>
<message><source>✓ edge</source><translation>✓ arête</translation></message>
<message><source>✕ not an edge</source><translation>✕ pas d'arête</translation></message>
<message><source>Nothing is marked yet: right-click a cell and mark it as an edge, or as not an edge.</source><translation>Rien n'est encore marqué : clic droit sur une cellule, puis marquez-la comme arête ou comme non-arête.</translation></message>
<message><source>The sweep is still growing: wait for its end, or hold it.</source><translation>Le balayage grandit encore : attendez sa fin, ou figez-le.</translation></message>
<message><source>Finding settings for these marks: method %1 of %2 …</source><translation>Recherche de réglages pour ces marques : méthode %1 sur %2 …</translation></message>
<message><source>Settings for These Marks</source><translation>Réglages pour ces marques</translation></message>
<message><source>%1 of %2 methods agree with all marks.</source><translation>%1 méthodes sur %2 s'accordent avec toutes les marques.</translation></message>
<message><source>No setting separates these marks. Those that get most of them right come first.</source><translation>Aucun réglage ne sépare ces marques. Ceux qui en respectent le plus viennent d'abord.</translation></message>
<message><source>click one end</source><translation>cliquez sur une extrémité</translation></message>
<message><source>click the other end</source><translation>cliquez sur l'autre extrémité</translation></message>
<message><source>click the lower cell</source><translation>cliquez sur la cellule du bas</translation></message>
<message><source>click the higher cell</source><translation>cliquez sur la cellule du haut</translation></message>
<message><source>click the end of one side</source><translation>cliquez sur l'extrémité d'un côté</translation></message>
<message><source>click where the sides meet</source><translation>cliquez là où les côtés se rejoignent</translation></message>
<message><source>click the end of the other side</source><translation>cliquez sur l'extrémité de l'autre côté</translation></message>
<message><source>click one end of a</source><translation>cliquez sur une extrémité de a</translation></message>
<message><source>click the other end of a</source><translation>cliquez sur l'autre extrémité de a</translation></message>
<message><source>click one end of b</source><translation>cliquez sur une extrémité de b</translation></message>
<message><source>click the other end of b</source><translation>cliquez sur l'autre extrémité de b</translation></message>
<message><source>click into the opening, or the near rock at one side</source><translation>cliquez dans l'ouverture, ou la roche proche d'un côté</translation></message>
<message><source>click the rock at the other side</source><translation>cliquez la roche de l'autre côté</translation></message>
<message><source>the throat could not be measured (%1); close other programs.</source><translation>l'étranglement n'a pas pu être mesuré (%1) ; fermez d'autres programmes.</translation></message>
<message><source>Nothing was measured within %1 cells of this click, so no length ends there: click nearer to a surface.</source><translation>Rien n'a été mesuré à moins de %1 cellules de ce clic, donc aucune longueur n'y finit : cliquez plus près d'une surface.</translation></message>
<message><source>Clicks next to this one find a throat of %1 to %2 m: zoom in, or click on the rock at both sides.</source><translation>Des clics à côté de celui-ci trouvent une gorge de %1 à %2 m : zoomez, ou cliquez sur la roche des deux côtés.</translation></message>
<message><source>Clicks next to these find a throat of %1 to %2 m: zoom in and click on the rock at both sides, or once into the middle of the opening.</source><translation>Des clics à côté de ceux-ci trouvent une gorge de %1 à %2 m : zoomez et cliquez sur la roche des deux côtés, ou une fois au milieu de l'ouverture.</translation></message>
<message><source>The last click is in an opening and measures all of it: the click before does not count.</source><translation>Le dernier clic est dans une ouverture et la mesure en entier : le clic précédent ne compte pas.</translation></message>
<message><source>No opening between these two clicks: click the rock at both sides of one. Distance measures over a rock.</source><translation>Pas d'ouverture entre ces deux clics : cliquez la roche des deux côtés d'une ouverture. Distance mesure sur une roche.</translation></message>
<message><source>A click went through the opening, so the rim in front of it was taken: check both ends of the line.</source><translation>Un clic est passé par l'ouverture, donc le bord devant a été pris : vérifiez les deux extrémités de la ligne.</translation></message>
<message><source>An end of this measurement is %1 m behind the surface under its line: check where its ends are, and click again on the near side if that was meant.</source><translation>Une extrémité de cette mesure est à %1 m derrière la surface sous sa ligne : vérifiez où sont ses extrémités, et cliquez de nouveau du côté proche si c'est lui que vous vouliez.</translation></message>
<message><source> · the last click took target %1, at %2 m</source><translation> · le dernier clic a pris la cible %1, à %2 m</translation></message>
<message><source> · the last click took the near side, at %1 m</source><translation> · le dernier clic a pris le côté proche, à %1 m</translation></message>
<message><source> · the last click is at %1 m</source><translation> · le dernier clic est à %1 m</translation></message>
<message><source>Throat width: the narrowest way is being searched …</source><translation>Largeur de l'étranglement : le passage le plus étroit est recherché …</translation></message>
<message><source>Nothing was selected (%1).</source><translation>Rien n'a été sélectionné (%1).</translation></message>
<message><source>Select Nothing</source><translation>Ne rien sélectionner</translation></message>
<message><source>Select</source><translation>Sélectionner</translation></message>
<message><source>This cell is not an edge, so it is on no chain of edges: choose one that is.</source><translation>Cette cellule n'est pas une arête, elle n'est donc sur aucune chaîne d'arêtes : choisissez-en une qui l'est.</translation></message>
<message><source>This cell is not on a rock: choose a cell on a coloured face.</source><translation>Cette cellule n'est pas sur un bloc : choisissez une cellule sur une face colorée.</translation></message>
<message><source>Rocks are not shown, so none can be selected: show them first.</source><translation>Les blocs ne sont pas affichés : affichez-les d'abord pour en sélectionner un.</translation></message>
<message><source>Hide</source><translation>Masquer</translation></message>
<message><source>Isolate</source><translation>Isoler</translation></message>
<message><source>Show All</source><translation>Tout afficher</translation></message>
<message><source>%1 cells selected, %2 points, %3 edge cells</source><translation>%1 cellules sélectionnées, %2 points, %3 cellules d'arête</translation></message>
<message><source>▲ %1 cells hidden</source><translation>▲ %1 cellules masquées</translation></message>
<message><source>&amp;Isolate</source><translation>&amp;Isoler</translation></message>
<message><source>&amp;Select</source><translation>Sé&amp;lectionner</translation></message>
<message><source>Edge &amp;Chain Here</source><translation>&amp;Chaîne d'arêtes ici</translation></message>
<message><source>&amp;Rock Here</source><translation>&amp;Bloc ici</translation></message>
<message><source>&amp;Hide Selected</source><translation>&amp;Masquer la sélection</translation></message>
<message><source>&amp;Isolate Selected</source><translation>&amp;Isoler la sélection</translation></message>
<message><source>Show &amp;All</source><translation>Tout a&amp;fficher</translation></message>
<message><source>&amp;Export Selected…</source><translation>E&amp;xporter la sélection…</translation></message>
<message><source>There is no cell here: nothing more is hidden.</source><translation>Aucune cellule n'est là : rien de plus n'est masqué.</translation></message>
<message><source>▲ The sweep grows. The cells that are there now are hidden. New lines are shown at every range.</source><translation>▲ Le balayage continue. Les cellules qui s'y trouvent maintenant sont masquées. Les nouvelles lignes sont montrées à toute distance.</translation></message>
<message><source>Range Gate</source><translation>Fenêtre de distance</translation></message>
<message><source>No range is known there: click a cell, or point at one that has a range, first.</source><translation>Aucune distance n'est connue là : cliquez ou pointez d'abord une cellule qui en a une.</translation></message>
<message><source>Clip to Box</source><translation>Couper à une boîte</translation></message>
<message><source>The targets could not be stored (%1).</source><translation>Les cibles n'ont pas pu être enregistrées (%1).</translation></message>
<message><source>Your targets are not stored: %1</source><translation>Vos cibles ne sont pas enregistrées : %1</translation></message>
<message><source>The targets could not be computed (%1).</source><translation>Les cibles n'ont pas pu être calculées (%1).</translation></message>
<message><source>Targets and measurements of the previous scan: %1. They are stored with it, as its edits of rocks are: open it again to see them.</source><translation>Cibles et mesures du scan précédent : %1. Elles sont enregistrées avec lui, comme ses corrections de blocs : rouvrez-le pour les voir.</translation></message>
<message><source>Not stored: EdgeScan was started without its settings.</source><translation>Non enregistré : EdgeScan a été lancé sans ses réglages.</translation></message>
<message><source>Not stored yet. Targets of a live sweep are stored when you open its recording, those of a part of a recording when its whole sweep is shown.</source><translation>Pas encore enregistrées. Les cibles d'un balayage en direct sont enregistrées quand vous ouvrez son enregistrement, celles d'une partie d'un enregistrement quand son balayage entier est affiché.</translation></message>
<message><source>▲ Not stored: the targets of this scan were refused.</source><translation>▲ Non enregistré : les cibles de ce scan ont été refusées.</translation></message>
<message><source>Another window has this scan open, too. Targets and edits of rocks of both are stored together.</source><translation>Une autre fenêtre a aussi ouvert ce scan. Les cibles et les modifications de roches des deux sont enregistrées ensemble.</translation></message>
<message><source>This cell was not pinned: there are %1 targets, remove some first.</source><translation>Cette cellule n'a pas été épinglée : il y a %1 cibles, supprimez-en d'abord quelques-unes.</translation></message>
<message><source>new target %1</source><translation>nouvelle cible %1</translation></message>
<message><source>Target %1 is locked and stays: unlock it to remove it.</source><translation>La cible %1 est verrouillée et reste : déverrouillez-la pour la retirer.</translation></message>
<message><source>removal of target %1</source><translation>suppression de la cible %1</translation></message>
<message><source>Target %1</source><translation>Cible %1</translation></message>
<message><source>removal of all targets</source><translation>suppression de toutes les cibles</translation></message>
<message><source>Targets %1</source><translation>Cibles %1</translation></message>
<message><source>1 locked target stays.</source><translation>1 cible verrouillée reste.</translation></message>
<message><source>%1 locked targets stay.</source><translation>%1 cibles verrouillées restent.</translation></message>
<message><source>lock of target %1</source><translation>verrouillage de la cible %1</translation></message>
<message><source>unlocking of target %1</source><translation>déverrouillage de la cible %1</translation></message>
<message><source>This was not stored: there are %1 measurements, remove some first.</source><translation>Ceci n'a pas été enregistré : il y a %1 mesures, supprimez-en d'abord quelques-unes.</translation></message>
<message><source>new measurement</source><translation>nouvelle mesure</translation></message>
<message><source>removal of measurement M%1</source><translation>suppression de la mesure M%1</translation></message>
<message><source>Another window changed the targets or measurements of this scan. Both are kept; of two with one number, yours has the next free one.</source><translation>Une autre fenêtre a modifié les cibles ou les mesures de ce scan. Les deux sont gardées ; de deux du même numéro, la vôtre a le prochain numéro libre.</translation></message>
<message><source>rock %1</source><translation>bloc %1</translation></message>
<message><source>end %1 is target %2</source><translation>l'extrémité %1 est la cible %2</translation></message>
<message><source>moved here from line %1, beam %2</source><translation>déplacée ici depuis ligne %1, faisceau %2</translation></message>
<message><source>up is assumed</source><translation>le haut est supposé</translation></message>
<message><source>a cell of it has no range</source><translation>une de ses cellules n'a pas de distance</translation></message>
<message><source>locked</source><translation>verrouillée</translation></message>
<message><source>Pinned %1</source><translation>Épinglée %1</translation></message>
<message><source>%1 warnings</source><translation>%1 avertissements</translation></message>
<message><source>Target %1 is on the clipboard, as text.</source><translation>La cible %1 est dans le presse-papiers, sous forme de texte.</translation></message>
<message><source>On the clipboard, as a table for a spreadsheet: %1.</source><translation>Dans le presse-papiers, sous forme de tableau pour un tableur : %1.</translation></message>
<message><source>Na&amp;me…</source><translation>N&amp;om…</translation></message>
<message><source>Meas&amp;ure from Here</source><translation>Mes&amp;urer depuis ici</translation></message>
<message><source>Na&amp;me of Target %1…</source><translation>No&amp;m de la cible %1…</translation></message>
<message><source>No&amp;te on Target %1…</source><translation>Rema&amp;rque sur la cible %1…</translation></message>
<message><source>Unloc&amp;k Target %1</source><translation>&amp;Déverrouiller la cible %1</translation></message>
<message><source>Loc&amp;k Target %1</source><translation>&amp;Verrouiller la cible %1</translation></message>
<message><source>Remo&amp;ve Target %1</source><translation>&amp;Supprimer la cible %1</translation></message>
<message><source>Name of a rock</source><translation>Nom d'un bloc</translation></message>
<message><source>Name of target %1, which is on this rock:</source><translation>Nom de la cible %1, qui est sur ce bloc :</translation></message>
<message><source>Name of this rock. A new target on it, number %1, holds the name:</source><translation>Nom de ce bloc. Une nouvelle cible posée sur lui, numéro %1, porte le nom :</translation></message>
<message><source>Name of a target</source><translation>Nom d'une cible</translation></message>
<message><source>Name of target %1:</source><translation>Nom de la cible %1 :</translation></message>
<message><source>Nothing to name yet: pin a cell, or choose a target.</source><translation>Il n'y a pas de cible à nommer : épinglez une cellule, ou choisissez une cible.</translation></message>
<message><source>Note on a target</source><translation>Remarque sur une cible</translation></message>
<message><source>Note on target %1:</source><translation>Remarque sur la cible %1 :</translation></message>
<message><source>name of target %1</source><translation>nom de la cible %1</translation></message>
<message><source>note of target %1</source><translation>note de la cible %1</translation></message>
<message><source>Open a scan: Ctrl+O, or drop a file here</source><translation>Ouvrir un scan : Ctrl+O, ou déposez un fichier ici</translation></message>
<message><source>Coarse picture of %1 million cells, the rest is coming</source><translation>Image grossière de %1 millions de cellules, le reste arrive</translation></message>
<message><source>The edges come with the rest of the scan</source><translation>Les arêtes arrivent avec le reste du scan</translation></message>
<message><source>The scanner did not measure this place, or its point is hidden. Click the rock next to it.</source><translation>Le scanner n'a pas mesuré cet endroit, ou son point est caché. Cliquez sur la roche voisine.</translation></message>
<message><source>A is shown; go back to B to pin or to measure.</source><translation>A est affiché ; revenez à B pour épingler ou mesurer.</translation></message>
<message><source>Cells can be clicked when the whole scan is here: this is a coarse picture of it.</source><translation>On peut cliquer sur les cellules quand le scan est là en entier : ceci en est une image grossière.</translation></message>
<message><source>&amp;Pin this cell</source><translation>É&amp;pingler cette cellule</translation></message>
<message><source>&amp;Fly to this point</source><translation>&amp;Voler vers ce point</translation></message>
<message><source>View from &amp;scanner</source><translation>Vue depuis le &amp;scanner</translation></message>
<message><source>F&amp;it the cloud</source><translation>A&amp;juster le nuage</translation></message>
<message><source>Fit the &amp;images</source><translation>Ajuster les &amp;images</translation></message>
<message><source>box of %1 × %2 cells: %3 points, %4 edge cells</source><translation>boîte de %1 × %2 cellules : %3 points, %4 cellules d'arête</translation></message>
<message><source>, ranges %1 to %2 m</source><translation>, distances de %1 à %2 m</translation></message>
<message><source>%1: it failed (%2); close other programs or use a smaller scan.</source><translation>%1 : échec (%2) ; fermez d'autres programmes ou utilisez un scan plus petit.</translation></message>
<message><source>the edges could not be computed (%1); close other programs or open a smaller scan.</source><translation>les arêtes n'ont pas pu être calculées (%1) ; fermez d'autres programmes ou ouvrez un scan plus petit.</translation></message>
<message><source>Opening %1</source><translation>Ouverture de %1</translation></message>
<message><source>Making the demo draw-bell</source><translation>Création de la cloche de démonstration</translation></message>
<message><source>Saving %1</source><translation>Enregistrement de %1</translation></message>
<message><source>writing</source><translation>écriture</translation></message>
<message><source>being cancelled</source><translation>annulation en cours</translation></message>
<message><source>opened</source><translation>ouvert</translation></message>
<message><source>reading</source><translation>lecture</translation></message>
<message><source>unpacking</source><translation>décompression</translation></message>
<message><source>grid</source><translation>grille</translation></message>
<message><source>placing the points</source><translation>placement des points</translation></message>
<message><source>finding edges</source><translation>recherche des arêtes</translation></message>
<message><source>drawing</source><translation>dessin</translation></message>
<message><source>Menu</source><translation>Menu</translation></message>
<message><source>Connect</source><translation>Connecter</translation></message>
<message><source>Hold to leave</source><translation>Tenir : quitter</translation></message>
<message><source>Hold for one second to leave cab mode</source><translation>Maintenir une seconde pour quitter le mode cabine</translation></message>
<message><source>End of the menu</source><translation>Fin du menu</translation></message>
<message><source>Delete the last letter</source><translation>Effacer la dernière lettre</translation></message>
<message><source>Enter</source><translation>Entrée</translation></message>
<message><source>Close the keys</source><translation>Fermer les touches</translation></message>
<message><source>Capital letter</source><translation>Majuscule</translation></message>
<message><source>Space</source><translation>Espace</translation></message>
<message><source>+ edges gained</source><translation>+ arêtes gagnées</translation></message>
<message><source>− edges lost</source><translation>− arêtes perdues</translation></message>
<message><source>edges kept</source><translation>arêtes gardées</translation></message>
<message><source>? edges not seen</source><translation>? arêtes non vues</translation></message>
<message><source>surface nearer</source><translation>surface plus proche</translation></message>
<message><source>surface farther</source><translation>surface plus loin</translation></message>
<message><source>A has %1 edge cells: %2 lost, %3 next to edges of B, %4 without a point of B</source><translation>A a %1 cellules d'arête : %2 perdues, %3 près d'arêtes de B, %4 sans point de B</translation></message>
<message><source>B has %1 edge cells: %2 gained, %3 kept, %4 without a point of A</source><translation>B a %1 cellules d'arête : %2 gagnées, %3 gardées, %4 sans point de A</translation></message>
<message><source>▲ OUT OF SPEC</source><translation>▲ HORS TOLÉRANCE</translation></message>
<message><source>colour by distance from A</source><translation>couleur selon la distance à A</translation></message>
<message><source>cells</source><translation>cellules</translation></message>
<message><source>Other points have the colours of rocks</source><translation>Les autres points ont les couleurs des blocs</translation></message>
<message><source>Previous changed region</source><translation>Région modifiée précédente</translation></message>
<message><source>Next changed region</source><translation>Région modifiée suivante</translation></message>
<message><source>End</source><translation>Terminer</translation></message>
<message><source>Ends the comparison: A is forgotten</source><translation>Termine la comparaison : A est oublié</translation></message>
<message><source>Shows A; hold \ for a short look</source><translation>Montre A ; maintenez \ pour la voir un instant</translation></message>
<message><source>Difference</source><translation>Différence</translation></message>
<message><source>Shows B with what changed since A</source><translation>Montre B avec ce qui a changé depuis A</translation></message>
<message><source>Shows B alone</source><translation>Montre B seule</translation></message>
<message><source>comparing …</source><translation>comparaison …</translation></message>
<message><source>comparing …
Gray counts are older.</source><translation>comparaison …
Les nombres gris sont anciens.</translation></message>
<message><source>not compared with the scan on the screen</source><translation>pas comparé au scan affiché</translation></message>
<message><source>nothing to compare with yet:
change a setting, or open another scan</source><translation>rien encore à comparer :
changez un réglage, ou ouvrez un autre scan</translation></message>
<message><source>median difference along the beams %1 mm
a change is more than %2 mm at 5 m</source><translation>différence médiane le long des faisceaux %1 mm
un changement dépasse %2 mm à 5 m</translation></message>
<message><source>median distance to the points of A %1
%2 are farther than %3</source><translation>distance médiane aux points de A %1
%2 sont à plus de %3</translation></message>
<message><source>Next</source><translation>Suivant</translation></message>
<message><source>Folds the legend</source><translation>Replie la légende</translation></message>
<message><source>Unfolds the legend</source><translation>Déplie la légende</translation></message>
<message><source>Changes: %1</source><translation>Changements : %1</translation></message>
<message><source>A, after: %1</source><translation>A, après : %1</translation></message>
<message><source>A, before: %1</source><translation>A, avant : %1</translation></message>
<message><source>B, before: %1</source><translation>B, avant : %1</translation></message>
<message><source>B, after: %1</source><translation>B, après : %1</translation></message>
<message><source>A: %1</source><translation>A : %1</translation></message>
<message><source>at all of them</source><translation>avec tous</translation></message>
<message><source>below %1 %</source><translation>moins de %1 %</translation></message>
<message><source>%1 % and more</source><translation>%1 % et plus</translation></message>
<message><source>Confidence of edges</source><translation>Confiance des arêtes</translation></message>
<message><source>Edges that fewer of the nearby settings find are left out of the views. Exports have all of them.</source><translation>Les arêtes que moins de réglages voisins trouvent sont omises des vues ; les exports les contiennent toutes.</translation></message>
<message><source>Least confidence shown</source><translation>Confiance minimale affichée</translation></message>
<message><source>Shown: %1 % and more</source><translation>Affiché : %1 % et plus</translation></message>
<message><source>Shown: all</source><translation>Affiché : tout</translation></message>
<message><source>computing: %1 %</source><translation>calcul en cours : %1 %</translation></message>
<message><source>share of %1 nearby settings that find the edge</source><translation>part des %1 réglages proches qui trouvent l'arête</translation></message>
<message><source>No command has these words, or it cannot be used now.</source><translation>Aucune commande n'a ces mots, ou elle n'est pas utilisable maintenant.</translation></message>
<message><source>Commands</source><translation>Commandes</translation></message>
<message><source>A few letters of a command</source><translation>Quelques lettres d'une commande</translation></message>
<message><source>For the program that will read it</source><translation>Pour le programme qui le lira</translation></message>
<message><source>Only what is selected (%1 cells)</source><translation>Seulement ce qui est sélectionné (%1 cellules)</translation></message>
<message><source>Also the points that lie behind the nearest of their cell (%1 in the scan)</source><translation>Aussi les points situés derrière le plus proche de leur cellule (%1 dans le scan)</translation></message>
<message><source>Choose File…</source><translation>Choisir un fichier…</translation></message>
<message><source>What</source><translation>Contenu</translation></message>
<message><source>It draws edge lines: choose the edge points above.</source><translation>Il dessine des lignes d'arêtes : choisissez les points d'arête ci-dessus.</translation></message>
<message><source>Targets are written as a table or a drawing.</source><translation>Les cibles s'écrivent comme tableau ou dessin.</translation></message>
<message><source>The file holds x, y and z in metres from the scanner.</source><translation>Le fichier contient x, y et z en mètres depuis le scanner.</translation></message>
<message><source>The file holds metres from E %1, N %2, RL %3: a program that does not add these shows small numbers.</source><translation>Le fichier contient des mètres depuis E %1, N %2, RL %3 : un programme qui ne les ajoute pas affiche de petits nombres.</translation></message>
<message><source>The file holds Easting, Northing and RL in metres.</source><translation>Le fichier contient les coordonnées est et nord et le RL en mètres.</translation></message>
<message><source>Choose local metres for %1: numbers of 4 bytes would round them to steps of %2 mm.</source><translation>Choisissez les mètres locaux pour %1 : des nombres de 4 octets les arrondiraient à des pas de %2 mm.</translation></message>
<message><source>Numbers count from the scanner, along its own axes.</source><translation>Les nombres partent du scanner, le long de ses propres axes.</translation></message>
<message><source>Small numbers: metres east, north and up from an origin near the scan. To get mine coordinates, add the origin, which is in the header or in the record of the file.</source><translation>Petits nombres : mètres vers l'est, le nord et le haut depuis une origine proche du scan. Pour des coordonnées de mine, ajoutez l'origine, qui est dans l'en-tête ou dans l'enregistrement du fichier.</translation></message>
<message><source>Each point has its whole Easting, Northing and RL, as on the plans of the mine.</source><translation>Chaque point a ses Est, Nord et RL entiers, comme sur les plans de la mine.</translation></message>
<message><source>The column elevation_m is the RL.</source><translation>La colonne elevation_m est la RL.</translation></message>
<message><source>The file holds metres from an origin near the scan, because %1 programs round mine coordinates. EdgeScan adds the origin of the header when it opens the file; other programs show the small numbers.</source><translation>Le fichier contient des mètres depuis une origine proche du scan, car les programmes de %1 arrondissent les coordonnées de la mine. EdgeScan ajoute l'origine de l'en-tête à l'ouverture du fichier ; les autres programmes montrent les petits nombres.</translation></message>
<message><source>Coordinates</source><translation>Coordonnées</translation></message>
<message><source>Mine grid: Easting, Northing, RL</source><translation>Coordonnées de la mine : E, N, RL</translation></message>
<message><source>Local metres from an origin in the mine grid</source><translation>Mètres locaux depuis une origine en coordonnées de la mine</translation></message>
<message><source>Scanner frame, as measured</source><translation>Repère du scanner, tel que mesuré</translation></message>
<message><source>No mine grid: %1. Scan &gt; Pose and Mounting takes a pose and a calibration.</source><translation>Pas de coordonnées de la mine : %1. Scan &gt; Pose et montage accepte une pose et un étalonnage.</translation></message>
<message><source>%1 × %2 pixels</source><translation>%1 × %2 pixels</translation></message>
<message><source>Lines through %1 edge points will be saved.</source><translation>Des lignes passant par %1 points d'arête seront enregistrées.</translation></message>
<message><source>%1 points will be saved.</source><translation>%1 points seront enregistrés.</translation></message>
<message><source>%1 will be saved.</source><translation>À enregistrer : %1.</translation></message>
<message><source>%1 cells will be saved.</source><translation>%1 cellules seront enregistrées.</translation></message>
<message><source>doubtful</source><translation>douteux</translation></message>
<message><source>detected</source><translation>déduit</translation></message>
<message><source>assumed</source><translation>supposé</translation></message>
<message><source>given by you</source><translation>comme indiqué</translation></message>
<message><source>from the file</source><translation>d'après le fichier</translation></message>
<message><source>Does This Look Right?</source><translation>Est-ce que cela paraît juste ?</translation></message>
<message><source>&amp;Close</source><translation>&amp;Fermer</translation></message>
<message><source>&amp;Adopt</source><translation>&amp;Adopter</translation></message>
<message><source>or</source><translation>ou</translation></message>
<message><source>%1: there is no other way to read it.</source><translation>%1 : il n'y a pas d'autre façon de le lire.</translation></message>
<message><source>%1: something contradicts how it was read.</source><translation>%1 : quelque chose contredit sa lecture.</translation></message>
<message><source>%1: assumed (%2), and the scan itself does not contradict it.</source><translation>%1 : supposé (%2), et le scan lui-même ne le contredit pas.</translation></message>
<message><source>%1: nothing contradicts how it was read.</source><translation>%1 : rien ne contredit sa lecture.</translation></message>
<message><source>Click another reading to see the scan read that way. Adopt takes it, and Ctrl+Z undoes that. Close restores the former reading.</source><translation>Cliquez une autre lecture pour voir le scan lu ainsi. Adopter la prend, et Ctrl+Z l'annule. Fermer rétablit la lecture d'avant.</translation></message>
<message><source>grid north</source><translation>nord de la grille</translation></message>
<message><source>true north</source><translation>nord géographique</translation></message>
<message><source>the vertical</source><translation>la verticale</translation></message>
<message><source>the robot's z axis</source><translation>l'axe z du robot</translation></message>
<message><source>forward</source><translation>vers l'avant</translation></message>
<message><source>up</source><translation>vers le haut</translation></message>
<message><source>down</source><translation>vers le bas</translation></message>
<message><source>by three angles</source><translation>selon trois angles</translation></message>
<message><source>by nine numbers</source><translation>selon neuf nombres</translation></message>
<message><source>two elevations</source><translation>deux élévations</translation></message>
<message><source>pitch and roll</source><translation>tangage et roulis</translation></message>
<message><source>Pose and Mounting</source><translation>Pose et montage</translation></message>
<message><source>Mounting</source><translation>Montage</translation></message>
<message><source>&amp;Store with the Scan</source><translation>&amp;Enregistrer avec le scan</translation></message>
<message><source>&amp;Remove Pose</source><translation>En&amp;lever la pose</translation></message>
<message><source>&amp;Fill In</source><translation>&amp;Remplir</translation></message>
<message><source>A line of the survey: point, E, N, RL, and heading, pitch and roll if it has them. E is easting, N northing, RL the height above the mine's zero: a higher place has a larger RL.</source><translation>Une ligne du levé : point, E, N, RL, puis cap, tangage et roulis si elle les contient. E est la coordonnée est, N la coordonnée nord, RL la hauteur au-dessus du zéro de la mine : un lieu plus haut a un RL plus grand.</translation></message>
<message><source>How the scanner is mounted, under a name for the next scan. An empty field has the value shown in it.</source><translation>Comment le scanner est monté, sous un nom pour le prochain scan. Un champ vide a la valeur affichée dedans.</translation></message>
<message><source>Store &amp;As…</source><translation>Enregistrer &amp;sous…</translation></message>
<message><source>For&amp;get</source><translation>&amp;Oublier</translation></message>
<message><source>From Fi&amp;le…</source><translation>D'un &amp;fichier…</translation></message>
<message><source>✕ missing</source><translation>✕ manque</translation></message>
<message><source>Nominal mounting</source><translation>Montage nominal</translation></message>
<message><source>Settings for these marks</source><translation>Réglages pour ces marques</translation></message>
<message><source>Click a row to see it. Adopt takes it. Close restores the former settings.</source><translation>Cliquez une ligne pour la voir. Adopter la prend. Fermer rétablit les réglages d'avant.</translation></message>
<message><source>Range gate</source><translation>Fenêtre de distance</translation></message>
<message><source>Draw cells from</source><translation>Dessiner les cellules de</translation></message>
<message><source>to</source><translation>à</translation></message>
<message><source>All others are hidden in all views. Edges, counts and exports stay as they are.</source><translation>Toutes les autres sont masquées dans toutes les vues. Arêtes, nombres et exports restent tels quels.</translation></message>
<message><source>An empty field: from the file, or detected. The file itself is not changed.</source><translation>Un champ vide : d'après le fichier, ou détecté. Le fichier lui-même n'est pas modifié.</translation></message>
<message><source>Read Again</source><translation>Relire</translation></message>
<message><source>as in the file</source><translation>comme dans le fichier</translation></message>
<message><source>Choose…</source><translation>Choisir…</translation></message>
<message><source>in the report</source><translation>dans le rapport</translation></message>
<message><source>HTML: a page for any browser</source><translation>HTML : une page pour tout navigateur</translation></message>
<message><source>PDF: pages to print and to file</source><translation>PDF : des pages à imprimer et à classer</translation></message>
<message><source>Author</source><translation>Auteur</translation></message>
<message><source>Logo (PNG)</source><translation>Logo (PNG)</translation></message>
<message><source>SHA-256</source><translation>SHA-256</translation></message>
<message><source>Scan lines</source><translation>Lignes de scan</translation></message>
<message><source>Beams</source><translation>Faisceaux</translation></message>
<message><source>Cells</source><translation>Cellules</translation></message>
<message><source>with a range</source><translation>avec une distance</translation></message>
<message><source>Ranges [m]</source><translation>Distances [m]</translation></message>
<message><source>smallest</source><translation>la plus petite</translation></message>
<message><source>largest</source><translation>la plus grande</translation></message>
<message><source>Unit of the file [mm]</source><translation>Unité du fichier [mm]</translation></message>
<message><source>Geometry</source><translation>Géométrie</translation></message>
<message><source>Mounting of the stepper</source><translation>Montage du moteur pas à pas</translation></message>
<message><source>Beam angles [°]</source><translation>Angles des faisceaux [°]</translation></message>
<message><source>Line angles [°]</source><translation>Angles des lignes [°]</translation></message>
<message><source>Intensity</source><translation>Intensité</translation></message>
<message><source>Maker</source><translation>Fabricant</translation></message>
<message><source>Model</source><translation>Modèle</translation></message>
<message><source>Serial number</source><translation>Numéro de série</translation></message>
<message><source>Firmware</source><translation>Micrologiciel</translation></message>
<message><source>Begin (UTC)</source><translation>Début (UTC)</translation></message>
<message><source>End (UTC)</source><translation>Fin (UTC)</translation></message>
<message><source>Clock</source><translation>Horloge</translation></message>
<message><source>Window of the scanner</source><translation>Vitre du scanner</translation></message>
<message><source>Echo filter</source><translation>Filtre d'échos</translation></message>
<message><source>Lines of the sweep</source><translation>Lignes du balayage</translation></message>
<message><source>first</source><translation>première</translation></message>
<message><source>last</source><translation>dernière</translation></message>
<message><source>number</source><translation>nombre</translation></message>
<message><source>step</source><translation>pas</translation></message>
<message><source>uneven</source><translation>inégal</translation></message>
<message><source>Direction of the stepper</source><translation>Sens du moteur</translation></message>
<message><source>Points behind others</source><translation>Points derrière d'autres</translation></message>
<message><source>Points of the list</source><translation>Points de la liste</translation></message>
<message><source>in the file</source><translation>dans le fichier</translation></message>
<message><source>without a cell</source><translation>sans cellule</translation></message>
<message><source>Scanner at [m]</source><translation>Scanner à [m]</translation></message>
<message><source>Origin E, N, RL [m]</source><translation>Origine E, N, RL [m]</translation></message>
<message><source>Source</source><translation>Source</translation></message>
<message><source>Begin of the scan</source><translation>Début du scan</translation></message>
<message><source>End of the scan</source><translation>Fin du scan</translation></message>
<message><source>Time of the pose</source><translation>Heure de la pose</translation></message>
<message><source>Age of the pose [s]</source><translation>Âge de la pose [s]</translation></message>
<message><source>Out of spec</source><translation>Hors tolérances</translation></message>
<message><source>Poses</source><translation>Poses</translation></message>
<message><source>Boom</source><translation>Flèche</translation></message>
<message><source>Pivot [m]</source><translation>Pivot [m]</translation></message>
<message><source>Head [m]</source><translation>Tête [m]</translation></message>
<message><source>scanner</source><translation>scanner</translation></message>
<message><source>beam x line angles</source><translation>angles des faisceaux x lignes</translation></message>
<message><source>organised points</source><translation>points organisés</translation></message>
<message><source>spin</source><translation>spin</translation></message>
<message><source>sweep</source><translation>sweep</translation></message>
<message><source>yes</source><translation>oui</translation></message>
<message><source>no</source><translation>non</translation></message>
<message><source>and %1 more</source><translation>et %1 de plus</translation></message>
<message><source>&lt;h3&gt;Mouse in the cloud&lt;/h3&gt;Left drag turns, middle drag or Shift+left drag pans, right drag or wheel zooms, Ctrl+left drag rolls; double-click or middle click sets the centre of rotation; Alt+wheel point size, Ctrl+wheel near clip, Ctrl+Shift+wheel far clip.&lt;h3&gt;Mouse in the images&lt;/h3&gt;Left or middle drag pans, wheel zooms, right drag changes the display levels, double-click fits; Shift+drag looks closer.&lt;h3&gt;Mouse in all views&lt;/h3&gt;A click pins a target; while rocks are shown, it selects the rock there, and Shift+click pins. Ctrl+click selects one more rock. A right click opens the menu of the cell.</source><translation>&lt;h3&gt;Souris dans le nuage de points&lt;/h3&gt;Glisser à gauche tourne, glisser au milieu ou Maj+glisser à gauche déplace, glisser à droite ou la molette zoome, Ctrl+glisser à gauche incline ; un double-clic ou un clic du milieu fixe le centre de rotation ; Alt+molette taille des points, Ctrl+molette plan de coupe proche, Ctrl+Maj+molette plan de coupe lointain.&lt;h3&gt;Souris dans les images&lt;/h3&gt;Glisser à gauche ou au milieu déplace, la molette zoome, glisser à droite change les niveaux affichés, un double-clic ajuste ; Maj+glisser regarde de près.&lt;h3&gt;Souris dans toutes les vues&lt;/h3&gt;Un clic épingle une cible ; tant que les blocs sont affichés, il sélectionne le bloc à cet endroit, et Maj+clic épingle. Ctrl+clic sélectionne un bloc de plus. Un clic droit ouvre le menu de la cellule.</translation></message>
<message><source>Keys</source><translation>Touches</translation></message>
<message><source>Keys and mouse</source><translation>Clavier et souris</translation></message>
<message><source>Scan</source><translation>Scan</translation></message>
<message><source>About EdgeScan</source><translation>À propos d'EdgeScan</translation></message>
<message><source>&lt;h3&gt;EdgeScan %1&lt;/h3&gt;Finds the edges of rocks in a laser range scan and shows them in the cloud.&lt;br&gt;It shows geometry from one viewpoint. It does not judge any rock.&lt;br&gt;&lt;br&gt;Licence: BSD-3-Clause&lt;br&gt;Drawn by %2</source><translation>&lt;h3&gt;EdgeScan %1&lt;/h3&gt;Trouve les arêtes des blocs dans un scan laser de distances et les montre dans le nuage de points.&lt;br&gt;Ce qu'il montre est la géométrie vue d'un seul point ; ce n'est un jugement sur aucun bloc.&lt;br&gt;&lt;br&gt;Licence : BSD-3-Clause&lt;br&gt;Dessiné par %2</translation></message>
<message><source>along the line</source><translation>le long de la ligne</translation></message>
<message><source>across the lines</source><translation>en travers des lignes</translation></message>
<message><source>%1: %2 m wide, %3 m deep (drawn × %4), near is below</source><translation>%1 : %2 m de large, %3 m de profondeur (dessinée × %4), le proche est en bas</translation></message>
<message><source>; ▲ ▼: points beyond it</source><translation> ; ▲ ▼ : points au-delà</translation></message>
<message><source>Numbers</source><translation>Nombres</translation></message>
<message><source>Why the edge %1 cells away?</source><translation>Pourquoi l'arête à %1 cellules ?</translation></message>
<message><source>More</source><translation>Plus</translation></message>
<message><source>Why is this cell an edge or not?</source><translation>Pourquoi cette cellule est-elle une arête, ou non ?</translation></message>
<message><source>The points across the cell, and a line through the nearest of either side.</source><translation>Les points en travers de la cellule, et une droite par les plus proches de chaque côté.</translation></message>
<message><source>The verdict in the method's terms, the points across the cell, and the numbers</source><translation>Le verdict dans les termes de la méthode, les points en travers de la cellule et les nombres</translation></message>
<message><source>Less</source><translation>Moins</translation></message>
<message><source>Why the edge next to it?</source><translation>Pourquoi l'arête voisine ?</translation></message>
<message><source>stones boulders fragments sizes</source><translation>pierres blocs fragments tailles</translation></message>
<message><source>export csv table list of rocks dxf outlines</source><translation>exporter csv tableau liste des roches dxf contours</translation></message>
<message><source>wider widest biggest boulder oversize</source><translation>plus large plus grosse bloc hors gabarit</translation></message>
<message><source>export csv table edge list points</source><translation>exporter csv tableau liste des arêtes points</translation></message>
<message><source>export csv table all points las</source><translation>exporter csv tableau tous les points las</translation></message>
<message><source>export csv table pins measurements</source><translation>exporter csv tableau repères mesures</translation></message>
<message><source>print pdf paper page</source><translation>imprimer pdf papier page</translation></message>
<message><source>picture image of the window</source><translation>image capture de la fenêtre</translation></message>
<message><source>refresh read again</source><translation>actualiser relire</translation></message>
<message><source>compare before after change difference</source><translation>comparer avant après changement différence</translation></message>
<message><source>off</source><translation>désactivé</translation></message>
<message><source>on</source><translation>activé</translation></message>
<message><source>Add a Scan as a Layer…</source><translation>Ajouter un scan comme couche…</translation></message>
<message><source>Remove</source><translation>Supprimer</translation></message>
<message><source>Place by Targets</source><translation>Placer par cibles</translation></message>
<message><source>Shows the image and the edges of this scan; the others stay in the cloud</source><translation>Affiche l'image et les arêtes de ce scan ; les autres restent dans le nuage</translation></message>
<message><source>Pin the same three places in both scans as targets with the same numbers: they bring the layer to its place</source><translation>Marquez les trois mêmes endroits dans les deux scans comme cibles de mêmes numéros : elles mettent la couche à sa place</translation></message>
<message><source>ANOTHER PICTURE</source><translation>AUTRE IMAGE</translation></message>
<message><source>CONNECTED, another picture is shown</source><translation>CONNECTÉ, une autre image est affichée</translation></message>
<message><source>now sweep %1: %2</source><translation>maintenant balayage %1 : %2</translation></message>
<message><source>sweep %1: %2</source><translation>balayage %1 : %2</translation></message>
<message><source>Lines whose telegrams did not arrive: dashes in the images</source><translation>Lignes dont les télégrammes ne sont pas arrivés : des tirets dans les images</translation></message>
<message><source>Port</source><translation>Port</translation></message>
<message><source>EdgeScan sends only read requests and one subscription to the scanner</source><translation>Seuls des lectures et un abonnement sont envoyés au scanner</translation></message>
<message><source>Record</source><translation>Enregistrer</translation></message>
<message><source>Write every telegram to a new file, unchanged, as it arrives</source><translation>Écrire chaque télégramme dans un nouveau fichier, tel quel, dès son arrivée</translation></message>
<message><source>Keep last minute</source><translation>Conserver la dernière minute</translation></message>
<message><source>Write what arrived during the last minute to a new file</source><translation>Écrire dans un nouveau fichier ce qui est arrivé pendant la dernière minute</translation></message>
<message><source>Hold</source><translation>Figer</translation></message>
<message><source>The picture stays as it is while the scanner goes on.</source><translation>L'image reste telle quelle pendant que le scanner continue.</translation></message>
<message><source>Follow</source><translation>Suivre</translation></message>
<message><source>The picture grows with the scanner.</source><translation>L'image grandit avec le scanner.</translation></message>
<message><source>scanner, or ws://ROBOT</source><translation>scanner, ou ws://ROBOT</translation></message>
<message><source>Name or address of the scanner; ws://ROBOT is a robot with ROS on which foxglove_bridge runs</source><translation>Nom ou adresse du scanner ; ws://ROBOT est un robot avec ROS sur lequel tourne foxglove_bridge</translation></message>
<message><source>Name or address of the scanner</source><translation>Nom ou adresse du scanner</translation></message>
<message><source>Port of the scanner</source><translation>Port du scanner</translation></message>
<message><source>Sweep…</source><translation>Balayage…</translation></message>
<message><source>Lines of a sweep, step per line, mounting</source><translation>Lignes d'un balayage, pas par ligne, montage</translation></message>
<message><source>Stop</source><translation>Arrêter</translation></message>
<message><source>Stop recording</source><translation>Arrêter l'enregistrement</translation></message>
<message><source>Show another sweep…</source><translation>Montrer un autre balayage…</translation></message>
<message><source>Show %1</source><translation>Montrer : %1</translation></message>
<message><source>%1 is written, but the disk has not confirmed the last %2 kB: keep the power on until it is idle.</source><translation>%1 est écrit, mais le disque n'a pas confirmé les derniers %2 kB : ne coupez pas l'alimentation avant qu'il soit au repos.</translation></message>
<message><source>Lines of the sweep. A red mark is a line that did not arrive.</source><translation>Lignes du balayage ; une marque rouge est une ligne qui n'est jamais venue</translation></message>
<message><source>not known</source><translation>inconnu</translation></message>
<message><source>not known (%1° assumed)</source><translation>non connu (%1° supposé)</translation></message>
<message><source>Does not turn while a line is measured</source><translation>S'arrête pendant la mesure d'une ligne</translation></message>
<message><source>Where the stepper begins. The cloud turns with it, its shape is the same.</source><translation>Où le moteur commence. Le nuage tourne avec lui, sa forme reste la même.</translation></message>
<message><source>0: no encoder; the lines are placed by the stepper's step</source><translation>0 : pas de codeur ; les lignes sont placées selon le pas du moteur</translation></message>
<message><source>spin: like a wheel, about its viewing direction</source><translation>spin : comme une roue, autour de sa direction de visée</translation></message>
<message><source>sweep: nodding, about the line from beam 0° to 180°</source><translation>sweep : en hochant, autour de la ligne du faisceau 0° au 180°</translation></message>
<message><source>The numbers are in the stepper's program or data sheet. Leave out what you do not know.</source><translation>Les nombres sont dans le programme ou la fiche technique du moteur pas à pas. Laissez ce que vous ne savez pas.</translation></message>
<message><source>The scanner turns</source><translation>Le scanner tourne</translation></message>
<message><source>Lines of a whole sweep</source><translation>Lignes d'un balayage entier</translation></message>
<message><source>Turn of a whole sweep</source><translation>Rotation d'un balayage entier</translation></message>
<message><source>Step per line</source><translation>Pas par ligne</translation></message>
<message><source>Angle of the first line</source><translation>Angle de la première ligne</translation></message>
<message><source>Encoder counts per degree</source><translation>Impulsions du codeur par degré</translation></message>
<message><source>not known (spin assumed until the ranges show it)</source><translation>non connu (spin supposé jusqu'à ce que les distances le montrent)</translation></message>
<message><source>not known (the ranges show spin)</source><translation>non connu (les distances montrent spin)</translation></message>
<message><source>not known (the ranges show sweep)</source><translation>non connu (les distances montrent sweep)</translation></message>
<message><source>needs the number of lines</source><translation>demande le nombre de lignes</translation></message>
<message><source>Play</source><translation>Lire</translation></message>
<message><source>Space plays and pauses; Left and Right step by a line, with Shift by ten</source><translation>Espace lit et met en pause ; Gauche et Droite avancent d'une ligne, avec Maj de dix</translation></message>
<message><source>RECORDED · line %2/%3 at %1</source><translation>ENREGISTRÉ · ligne %2/%3 à %1</translation></message>
<message><source> · recorded sweep %1 of %2</source><translation> · balayage enregistré %1 sur %2</translation></message>
<message><source>Pause</source><translation>Pause</translation></message>
<message><source>%1; messages: %2, per second: %3</source><translation>%1 ; messages : %2, par seconde : %3</translation></message>
<message><source>Topics…</source><translation>Topics…</translation></message>
<message><source>What the robot offers, and which laser the scan comes from</source><translation>Ce que le robot propose, et de quel laser vient le scan</translation></message>
<message><source>The robot has not offered a topic yet.</source><translation>Le robot n'a encore proposé aucun topic.</translation></message>
<message><source>clouds of %1 points</source><translation>nuages de %1 points</translation></message>
<message><source>clouds of a scanner</source><translation>nuages d'un scanner</translation></message>
<message><source>lines of %1 beams</source><translation>lignes de %1 faisceaux</translation></message>
<message><source>lines of a laser</source><translation>lignes d'un laser</translation></message>
<message><source>Angle of each line</source><translation>Angle de chaque ligne</translation></message>
<message><source>from the transforms, or from the joint that turned furthest</source><translation>d'après les transformations, ou l'articulation qui a le plus tourné</translation></message>
<message><source>from the joint %1</source><translation>d'après l'articulation %1</translation></message>
<message><source>Topics that are not used: %1</source><translation>Topics qui ne sont pas utilisés : %1</translation></message>
<message><source>A part of rock %1 (%2 cells) is not shown as a rock: </source><translation>Une partie du bloc %1 (%2 cellules) n'est pas montrée comme bloc : </translation></message>
<message><source>it is smaller than “Smallest rock” (%1 cells). Lower that number to see it.</source><translation>elle est plus petite que « Plus petit bloc » (%1 cellules). Baissez ce nombre pour la voir.</translation></message>
<message><source>it is outside the region of interest. Clear the region to see it.</source><translation>elle est hors de la zone d'intérêt. Effacez la zone pour la voir.</translation></message>
<message><source>its confidence is %1, and a rock needs %2. Click it and choose “Not a Rock, or a Rock Again” to show it.</source><translation>sa confiance est %1, et il faut %2 pour un bloc. Cliquez-la et choisissez « Pas un bloc, ou un bloc tout de même » pour la montrer.</translation></message>
<message><source>it is behind “Farthest rock” (%1 m). Raise that number to see it.</source><translation>elle est au-delà de « Bloc le plus éloigné » (%1 m). Augmentez ce nombre pour la voir.</translation></message>
<message><source>it looks like a wall. Click it and choose “Not a Rock, or a Rock Again” to show it.</source><translation>elle ressemble à une paroi. Cliquez-la et choisissez « Pas un bloc, ou un bloc tout de même » pour la montrer.</translation></message>
<message><source>Merged: rocks %1 are rock %2 now.</source><translation>Fusionnés : les blocs %1 sont maintenant le bloc %2.</translation></message>
<message><source>Cut: rock %1 is now rocks %2.</source><translation>Coupé : le bloc %1 est maintenant les blocs %2.</translation></message>
<message><source>Split: rock %1 is now rocks %2.</source><translation>Divisé : le bloc %1 est maintenant les blocs %2.</translation></message>
<message><source>Rocks %1 and %2 do not touch: their nearest cells are %3 m apart.</source><translation>Les blocs %1 et %2 ne se touchent pas : leurs cellules les plus proches sont à %3 m l'une de l'autre.</translation></message>
<message><source>Rock %1 and a part that was not a rock do not touch: their nearest cells are %2 m apart.</source><translation>Le bloc %1 et une partie qui n'était pas un bloc ne se touchent pas : leurs cellules les plus proches sont à %2 m l'une de l'autre.</translation></message>
<message><source>They are merged as rock %1.</source><translation>Ils sont fusionnés comme bloc %1.</translation></message>
<message><source>at least %1</source><translation>au moins %1</translation></message>
<message><source>something that is not a rock</source><translation>quelque chose qui n'est pas un bloc</translation></message>
<message><source>none seen</source><translation>rien de visible</translation></message>
<message><source>at least 1: rock %1</source><translation>au moins 1 : roche %1</translation></message>
<message><source>at least %1: rocks %2</source><translation>au moins %1 : roches %2</translation></message>
<message><source>, between rocks %1 and %2</source><translation>, entre les blocs %1 et %2</translation></message>
<message><source>, hangs below</source><translation>, pend en dessous</translation></message>
<message><source>nothing was measured here, or no piece fits</source><translation>rien n'a été mesuré ici, ou aucun morceau ne convient</translation></message>
<message><source>fines: too few cells to be shown as a rock</source><translation>fines : trop peu de cellules pour être montrées comme un bloc</translation></message>
<message><source>outside the region of interest</source><translation>hors de la région d'intérêt</translation></message>
<message><source>marked by hand as not a rock</source><translation>marqué à la main comme non-bloc</translation></message>
<message><source>too uncertain to be shown as a rock</source><translation>trop incertain pour être montré comme un bloc</translation></message>
<message><source>wall, floor, or too far away</source><translation>paroi, sol, ou trop loin</translation></message>
<message><source>Name…</source><translation>Nom…</translation></message>
<message><source>Section</source><translation>Coupe</translation></message>
<message><source>Split</source><translation>Scinder</translation></message>
<message><source>Cut</source><translation>Couper</translation></message>
<message><source>Merge</source><translation>Fusionner</translation></message>
<message><source>Not a Rock</source><translation>Pas un bloc</translation></message>
<message><source>Deselect this rock</source><translation>Désélectionner ce bloc</translation></message>
<message><source>Hidden parts are not counted.</source><translation>Les parties cachées ne sont pas comptées.</translation></message>
<message><source>Then click the part of the rock that is a rock of its own; the wheel takes a smaller or a larger part (S)</source><translation>Cliquez ensuite sur la partie du bloc qui est un bloc à part ; la molette prend une partie plus petite ou plus grande (S)</translation></message>
<message><source>Then draw a line through the rock, from one side to the other (X)</source><translation>Puis tracez une ligne à travers le bloc, d'un côté à l'autre (X)</translation></message>
<message><source>A target on this rock holds its name (F2)</source><translation>Une cible sur ce bloc porte son nom (F2)</translation></message>
<message><source>The vertical plane through the rock, along its longest visible width</source><translation>Le plan vertical par le bloc, le long de sa plus grande largeur visible</translation></message>
<message><source>The selected rocks are one; Ctrl+click selects several (M)</source><translation>Les blocs sélectionnés n'en font qu'un ; Ctrl+clic en sélectionne plusieurs (M)</translation></message>
<message><source>%1, and %2 more selected</source><translation>%1, et %2 de plus sélectionnés</translation></message>
<message><source>▲ uncertain outline: hatched</source><translation>▲ contour incertain : hachuré</translation></message>
<message><source>may be one with %1: Merge joins them</source><translation>peut ne faire qu'un avec %1 : Fusionner les joint</translation></message>
<message><source>a rock by hand: marked or cut</source><translation>un bloc à la main : marqué ou coupé</translation></message>
<message><source>A Rock</source><translation>Un bloc</translation></message>
<message><source>This is a wall, a floor or something else (N)</source><translation>C'est une paroi, un sol ou autre chose (N)</translation></message>
<message><source>This is a rock (N)</source><translation>C'est un bloc tout de même (N)</translation></message>
<message><source>Rock %1</source><translation>Bloc %1</translation></message>
<message><source>visible spans a × b</source><translation>étendues visibles a × b</translation></message>
<message><source>distance, median</source><translation>distance, médiane</translation></message>
<message><source>visible area</source><translation>surface visible</translation></message>
<message><source>%1 m²</source><translation>%1 m²</translation></message>
<message><source>in front</source><translation>devant</translation></message>
<message><source>%1 % of its outline</source><translation>%1 % de son contour</translation></message>
<message><source>behind rocks</source><translation>derrière les blocs</translation></message>
<message><source>visible contacts</source><translation>contacts visibles</translation></message>
<message><source>free height below</source><translation>hauteur libre en dessous</translation></message>
<message><source>arch angle</source><translation>angle de voûte</translation></message>
<message><source>the scanner's z axis, assumed</source><translation>l'axe z du scanner, supposé</translation></message>
<message><source>confidence p</source><translation>confiance p</translation></message>
<message><source>pinned target</source><translation>cible épinglée</translation></message>
<message><source>Not a rock</source><translation>Pas un bloc</translation></message>
<message><source>because</source><translation>parce que</translation></message>
<message><source>▲ %1 parts that do not touch, %2 m apart</source><translation>▲ %1 parties qui ne se touchent pas, à %2 m</translation></message>
<message><source>%1 and %2</source><translation>%1 et %2</translation></message>
<message><source>≈ may be one with %1</source><translation>≈ ne fait peut-être qu'un avec %1</translation></message>
<message><source>%1 · visible a × b: %2 × %3 m ± %4 m · at %5 m</source><translation>%1 · a × b visible : %2 × %3 m ± %4 m · à %5 m</translation></message>
<message><source> · ▲ uncertain outline</source><translation> · ▲ contour incertain</translation></message>
<message><source>hide uncertain</source><translation>masquer incertains</translation></message>
<message><source>Export…</source><translation>Exporter…</translation></message>
<message><source>Rocks with a smaller visible width b are left out of the table, and in the views only their outline is drawn</source><translation>Les roches de plus petite largeur visible b ne sont pas dans le tableau, et les vues n'en dessinent que le contour</translation></message>
<message><source>b at least</source><translation>b au moins</translation></message>
<message><source>Rocks with a confidence p below 0.85, which are hatched, are left out of the table, and in the views only their outline is drawn</source><translation>Les roches de confiance p inférieure à 0.85, hachurées, ne sont pas dans le tableau, et les vues n'en dessinent que le contour</translation></message>
<message><source>%1 of %2 rocks</source><translation>%1 blocs sur %2</translation></message>
<message><source>, %1 of them uncertain (hatched)</source><translation>, dont %1 incertains (hachurés)</translation></message>
<message><source>&amp;Shown Rocks (%1)…</source><translation>&amp;Blocs affichés (%1)…</translation></message>
<message><source>&amp;All Rocks (%1)…</source><translation>&amp;Tous les blocs (%1)…</translation></message>
<message><source>fine</source><translation>fin</translation></message>
<message><source>coarse</source><translation>grossier</translation></message>
<message><source>%1, %2 of them uncertain (hatched); %3 pieces too small to be a rock</source><translation>%1, dont %2 incertains (hachurés) ; %3 morceaux trop petits pour être un bloc</translation></message>
<message><source>; %1 changed by hand</source><translation>; %1 modifiés à la main</translation></message>
<message><source>; %1 pieces outside the region of interest are left out</source><translation>; %1 morceaux hors de la région d'intérêt sont omis</translation></message>
<message><source>A click selects a rock (Ctrl+click one more); the tool Pin (P) sets a target (Shift+click).</source><translation>Un clic choisit un bloc (Ctrl+clic un de plus) ; l'outil Épingler (P) place une cible (Maj+clic).</translation></message>
<message><source>▲ %1 % over %2 m</source><translation>▲ %1 % au-dessus de %2 m</translation></message>
<message><source>Visible width b by count: P20 %1, P50 %2, P80 %3 (20, 50, 80 % of the rocks are not wider), largest %4 m%5. Hidden parts make this finer than the pile is, by 40 % and more.</source><translation>Largeur visible b, en nombre : P20 %1, P50 %2, P80 %3 (20, 50, 80 % des blocs ne sont pas plus larges), le plus grand %4 m%5. Les parties cachées rendent ceci plus fin que le tas ne l'est, de 40 % et plus.</translation></message>
<message><source>Size curve</source><translation>Courbe granulométrique</translation></message>
<message><source>Visible width b by count: 50 % of the rocks are not wider than P50. Hidden parts make this finer than the pile is, by 40 % and more.</source><translation>Largeur visible b, en nombre : 50 % des blocs ne sont pas plus larges que P50. Les parties cachées rendent ceci plus fin que le tas, de 40 % et plus.</translation></message>
<message><source>%1 % of the rocks have a visible width of %2 m at most</source><translation>%1 % des blocs ont une largeur visible de %2 m au plus</translation></message>
<message><source>no rocks to count</source><translation>aucun bloc à compter</translation></message>
<message><source>Export Section…</source><translation>Exporter la coupe…</translation></message>
<message><source>Wheel: zoom; drag: move; two clicks: a length</source><translation>Molette : zoom ; glisser : déplacer ; deux clics : une longueur</translation></message>
<message><source>Zoom in</source><translation>Zoom avant</translation></message>
<message><source>Zoom out</source><translation>Zoom arrière</translation></message>
<message><source>Fit</source><translation>Ajuster</translation></message>
<message><source>Zoom to what the section is about</source><translation>Cadrer ce que la coupe doit montrer</translation></message>
<message><source>All</source><translation>Tout</translation></message>
<message><source>Zoom to all points of the section</source><translation>Cadrer tous les points de la coupe</translation></message>
<message><source>▲ This click is not on a line: click nearer to one.</source><translation>▲ Ce clic n'est pas sur une ligne : cliquez plus près d'une ligne.</translation></message>
<message><source>Click on the other end of the length.</source><translation>Cliquez sur l'autre extrémité de la longueur.</translation></message>
<message><source>This length is stored with the measurements. Two more clicks measure another.</source><translation>Cette longueur est enregistrée avec les mesures. Deux autres clics en mesurent une autre.</translation></message>
<message><source>Two clicks on the lines measure a length.</source><translation>Deux clics sur les lignes mesurent une longueur.</translation></message>
<message><source>▲ %1 points are outside: All shows them.</source><translation>▲ %1 points sont en dehors : Tout les montre.</translation></message>
<message><source>Edge points, green: %1.</source><translation>Points d'arête, en vert : %1.</translation></message>
<message><source>along the section [m]</source><translation>le long de la coupe [m]</translation></message>
<message><source>✕ INCOMPLETE</source><translation>✕ INCOMPLET</translation></message>
<message><source>Open a scan…</source><translation>Ouvrir un scan…</translation></message>
<message><source>Connect to the scanner…</source><translation>Se connecter au scanner…</translation></message>
<message><source>Go on with the last session</source><translation>Continuer la dernière session</translation></message>
<message><source>Demo draw-bell</source><translation>Cloche de démonstration</translation></message>
<message><source>no scanner, no files needed</source><translation>sans scanner, sans fichiers</translation></message>
<message><source>Demo before and after a blast</source><translation>Démo avant et après un tir</translation></message>
<message><source>both, and what changed between them</source><translation>les deux, et ce qui a changé de l'un à l'autre</translation></message>
<message><source>Recent</source><translation>Récents</translation></message>
<message><source>Scans that were open are listed here.</source><translation>Les scans déjà ouverts sont listés ici.</translation></message>
<message><source>The edges of rocks in a laser range scan</source><translation>Les arêtes des blocs dans un scan laser de distances</translation></message>
<message><source>Reads raw grids, recordings (.mcap), ROS bags, PCD, PLY, E57, LAS, PTX, CSV, XYZ and others.</source><translation>Lit les grilles brutes, les enregistrements (.mcap), les bags ROS, PCD, PLY, E57, LAS, PTX, CSV, XYZ et d'autres.</translation></message>
<message><source>EdgeScan sends only read requests and one subscription to the scanner.</source><translation>N'envoie au scanner que des lectures et un abonnement.</translation></message>
<message><source>Cab mode</source><translation>Mode cabine</translation></message>
<message><source>a file on this computer or on a stick</source><translation>un fichier de cet ordinateur ou d'une clé USB</translation></message>
<message><source>Ctrl+O, or drop files anywhere in this window</source><translation>Ctrl+O, ou déposez des fichiers dans cette fenêtre</translation></message>
<message><source>a SICK LMS, or a robot with ROS as ws://ROBOT</source><translation>un SICK LMS, ou un robot avec ROS : ws://ROBOT</translation></message>
<message><source>Ctrl+L; a SICK LMS, or a robot with ROS as ws://ROBOT</source><translation>Ctrl+L ; un SICK LMS, ou un robot avec ROS par ws://ROBOT</translation></message>
<message><source>✕ not found: it was moved, or its disk is missing. Locate…</source><translation>✕ introuvable : déplacé, ou son disque manque. Localiser…</translation></message>
<message><source>there is none yet</source><translation>il n'y en a pas encore</translation></message>
<message><source>%1, %2, %3 UTC</source><translation>%1, %2, %3 UTC</translation></message>
<message><source>Open a scan or connect the scanner. The demo needs neither: it is a hung-up draw-bell.</source><translation>Ouvrez un scan ou connectez le scanner. La démo n'a besoin ni de l'un ni de l'autre : c'est un soutirage bloqué.</translation></message>
<message><source>Open the demo</source><translation>Ouvrir la démo</translation></message>
<message><source>Drag turns the cloud, the middle button moves it, the wheel zooms. A click marks a cell in cloud, range image and edge map; its card has distance and coordinates.</source><translation>Glisser tourne le nuage, le bouton du milieu le déplace, la molette zoome. Un clic marque une cellule dans le nuage, l'image de distances et la carte des arêtes ; sa fiche donne distance et coordonnées.</translation></message>
<message><source>View from the scanner</source><translation>Voir depuis le scanner</translation></message>
<message><source>Change Edge strength first. The curve under it shows the number of edge cells for every value. Where it is flat, the edges depend little on it.</source><translation>Réglez d'abord la force des arêtes. La courbe en dessous montre le nombre d'arêtes pour chaque valeur ; là où elle est plate, les arêtes dépendent peu du réglage.</translation></message>
<message><source>Show the edges panel</source><translation>Afficher le panneau des arêtes</translation></message>
<message><source>EdgeScan finds rocks from the edges, with visible sizes and a confidence. The table lists them. A click selects a rock in all views.</source><translation>EdgeScan trouve les blocs à partir des arêtes, avec leur taille visible et une confiance. Le tableau les énumère. Un clic choisit un bloc dans toutes les vues.</translation></message>
<message><source>Show the rocks</source><translation>Afficher les blocs</translation></message>
<message><source>The tools above measure and compare scans. File exports edges, clouds and a report. Help shows all keys, and this tour again.</source><translation>Les outils en haut mesurent et comparent des scans. Fichier exporte arêtes, nuages et un rapport. Aide montre toutes les touches, et cette visite aussi.</translation></message>
<message><source>Show the keys</source><translation>Afficher les touches</translation></message>
<message><source>End the tour</source><translation>Terminer la visite</translation></message>
<message><source>was %1</source><translation>avant : %1</translation></message>
<message><source>Measure</source><translation>Mesurer</translation></message>
<message><source>Its name: keystone, left shoulder …</source><translation>Son nom : clef de voûte, appui gauche …</translation></message>
<message><source>Your note on it, stored with its name</source><translation>Votre remarque sur elle, enregistrée avec son nom</translation></message>
<message><source>Lock</source><translation>Verrouiller</translation></message>
<message><source>Locked: Del and Remove All do not remove it</source><translation>Verrouillée : Suppr et Tout supprimer ne la suppriment pas</translation></message>
<message><source>Remove this target</source><translation>Supprimer cette cible</translation></message>
<message><source>Locked</source><translation>Verrouillée</translation></message>
<message><source>Target %1: %2</source><translation>Cible %1 : %2</translation></message>
<message><source>X, Y, Z</source><translation>X, Y, Z</translation></message>
<message><source>Metres in the frame of the scan</source><translation>Mètres dans le repère du scan</translation></message>
<message><source>E, N, RL</source><translation>E, N, RL</translation></message>
<message><source>Easting, Northing and RL (height) in the mine grid, in metres</source><translation>Est, nord et RL (altitude) en coordonnées de la mine, mètres</translation></message>
<message><source>Rock, visible</source><translation>Bloc, visible</translation></message>
<message><source>none here</source><translation>aucun ici</translation></message>
<message><source>Length a and width b of its visible part. Hidden parts are not included.</source><translation>Longueur a et largeur b de sa partie visible. Les parties cachées ne sont pas comprises.</translation></message>
<message><source>Resolves</source><translation>Résolution</translation></message>
<message><source>The smallest thing seen reliably here: %1 to the next beam, and a beam of %2 as an LMS511 has it in high resolution</source><translation>La plus petite chose vue de façon fiable ici : %1 jusqu'au faisceau voisin, et un faisceau de %2 comme l'a un LMS511 en haute résolution</translation></message>
<message><source>Surface</source><translation>Surface</translation></message>
<message><source>Between its normal and the beam: 0° faces the scanner. A plane through %1 cells, relief %2</source><translation>Entre sa normale et le faisceau : 0° fait face au scanner. Un plan par %1 cellules, relief %2</translation></message>
<message><source>Dip / direction</source><translation>Pendage / direction</translation></message>
<message><source>Of the plane to the horizon, and clockwise from grid north the way it falls</source><translation>Du plan par rapport à l'horizon, et dans le sens horaire depuis le nord de la grille, le sens où il descend</translation></message>
<message><source>From the boom</source><translation>Au bras</translation></message>
<message><source>To the straight line from the boom's pivot to the head, where they were when this was measured; 0° off square: the boom points straight at the surface</source><translation>Jusqu'à la droite du pivot du bras à la tête, là où ils étaient lors de la mesure ; 0° : le bras pointe droit sur la surface</translation></message>
<message><source>line %1 · beam %2</source><translation>ligne %1 · faisceau %2</translation></message>
<message><source>Line angle %1°, beam angle %2°</source><translation>Angle de la ligne %1°, angle du faisceau %2°</translation></message>
<message><source>, strength %1</source><translation>, force %1</translation></message>
<message><source>Edge</source><translation>Arête</translation></message>
<message><source>Strength 1 is at the threshold; Why says more</source><translation>La force 1 est au seuil ; Pourquoi en dit plus</translation></message>
<message><source>Share of nearby settings that find this edge too, computed after each change. It shows how much the edge depends on the settings, not whether a rock is there.</source><translation>Part des réglages proches qui trouvent aussi cette arête, calculée après chaque changement. Cela montre combien l'arête dépend des réglages, non si un bloc est là.</translation></message>
<message><source>large scan: show Edge Confidence</source><translation>grand scan : affichez la confiance des arêtes</translation></message>
<message><source>%1 m behind a jump where no edge is drawn (a slip of the stepper looks the same); measured on its near side</source><translation>%1 m derrière un saut où aucune arête n'est tracée (un glissement du moteur pas à pas a le même aspect) ; mesuré de son côté proche</translation></message>
<message><source>%1 m behind an edge; measured on its near side</source><translation>%1 m derrière une arête ; mesuré de son côté proche</translation></message>
<message><source>a beam between two surfaces; measured on the nearer one</source><translation>un faisceau entre deux surfaces ; mesuré sur la plus proche</translation></message>
<message><source>one echo in front of all around it, as from dust; measured at the nearest cell behind it</source><translation>un seul écho devant tout ce qui l'entoure, comme de la poussière ; mesuré à la cellule la plus proche derrière lui</translation></message>
<message><source>nothing was measured there; measured at the nearest cell</source><translation>rien n'y a été mesuré ; mesuré à la cellule la plus proche</translation></message>
<message><source>nothing was measured within %1 cells</source><translation>rien n'a été mesuré à moins de %1 cellules</translation></message>
<message><source>▲ a nearer surface is also within %1 cells: zoom in if that was meant</source><translation>▲ une surface plus proche est aussi à moins de %1 cellules : zoomez si c’est elle que vous visiez</translation></message>
<message><source>± not known</source><translation>± inconnu</translation></message>
<message><source>E %1  N %2
RL %3 m</source><translation>E %1  N %2
RL %3 m</translation></message>
<message><source>x %1  y %2  z %3 m</source><translation>x %1  y %2  z %3 m</translation></message>
<message><source>E %1 N %2 RL %3</source><translation>E %1 N %2 RL %3</translation></message>
<message><source>Distance [m]</source><translation>Distance [m]</translation></message>
<message><source>Line</source><translation>Ligne</translation></message>
<message><source>Beam</source><translation>Faisceau</translation></message>
<message><source>Distance</source><translation>Distance</translation></message>
<message><source>Two standard deviations of the noise of this scan along the beam. Errors that the scanner makes everywhere are not included.</source><translation>Deux écarts-types du bruit de ce scan le long du faisceau. Les erreurs que le scanner fait partout n'y sont pas comprises.</translation></message>
<message><source>A click near an edge means its near side; with Shift it means the very cell</source><translation>Un clic près d'une arête vise son côté proche ; avec Maj il vise la cellule même</translation></message>
<message><source>from</source><translation>depuis</translation></message>
<message><source>scanner, line of sight</source><translation>scanner, ligne de visée</translation></message>
<message><source>Picture</source><translation>Image</translation></message>
<message><source>Confidence</source><translation>Confiance</translation></message>
<message><source>Copy All</source><translation>Tout copier</translation></message>
<message><source>Remove All</source><translation>Tout supprimer</translation></message>
<message><source>The positions of all targets as a table with units, for a spreadsheet</source><translation>Les positions de toutes les cibles en tableau avec unités, pour un tableur</translation></message>
<message><source>All but those that are locked</source><translation>Toutes sauf celles qui sont verrouillées</translation></message>
<message><source>A vertical section through the selected measurement, or through the last one</source><translation>Une coupe verticale par la mesure sélectionnée, ou par la dernière</translation></message>
<message><source>The selected measurement</source><translation>La mesure choisie</translation></message>
<message><source>Click a cell in any view to pin it.</source><translation>Cliquez sur une cellule dans n'importe quelle vue pour l'épingler.</translation></message>
<message><source>Number of edge cells at every threshold, from the least to the most on a logarithmic scale. Hatched: the widest range over which at most a fifth of them disappears. The vertical line is the threshold in use.</source><translation>Nombre de cellules d'arête à chaque seuil, du plus petit au plus grand sur une échelle logarithmique. Hachuré : le plus large intervalle sur lequel un cinquième d'entre elles au plus disparaît. Le trait vertical est le seuil utilisé.</translation></message>
<message><source>counting the edge cells …</source><translation>comptage des cellules d'arête …</translation></message>
<message><source> · steady from %1 to %2</source><translation> · varie peu de %1 à %2</translation></message>
<message><source>Without %1:</source><translation>Sans %1 :</translation></message>
<message><source>Without %1 classes:</source><translation>Sans %1 classes :</translation></message>
<message><source>other classes take some of its cells, and chains get shorter: fewer edges, here and in files</source><translation>d'autres classes prennent une partie de ses cellules et les chaînes raccourcissent : moins d'arêtes, ici et dans les fichiers</translation></message>
<message><source>Classes</source><translation>Classes</translation></message>
<message><source>How likely an edge is the border of a rock; where that is unknown, it is drawn like one.</source><translation>La probabilité qu'une arête soit le contour d'une roche ; où elle est inconnue, l'arête est dessinée comme un contour.</translation></message>
<message><source>Without one class the other numbers change too: a cell has one class, and a weak cell counts where it continues a strong one of any class.</source><translation>Sans une classe, les autres nombres changent aussi : une cellule a une seule classe, et une cellule faible compte là où elle prolonge une forte de n'importe quelle classe.</translation></message>
<message><source>With a higher edge strength this number can rise: cells that were jumps or folds before count here.</source><translation>Avec une force de l'arête plus élevée, ce nombre peut monter : les cellules qui ne sont plus des sauts ni des plis comptent ici.</translation></message>
<message><source>Colours by class</source><translation>Couleurs par classe</translation></message>
<message><source>Each class in its own colour, or all edges in one: C</source><translation>Chaque classe dans sa couleur, ou toutes les arêtes d'une seule : C</translation></message>
<message><source>Rocks cover them in the cloud</source><translation>Les blocs les couvrent dans le nuage</translation></message>
<message><source>Rocks &gt; Edges over Rocks draws them over the rocks; the images show them.</source><translation>Blocs &gt; Arêtes sur les blocs les dessine dessus ; les images les montrent.</translation></message>
<message><source>Striped green in the images; no beam measured these cells, and the cloud does not show them.</source><translation>Rayé de vert dans les images ; personne n'a mesuré ces cellules, et le nuage ne les montre pas.</translation></message>
<message><source>Rock border, %1 % and more: %2</source><translation>Contour de roche, %1 % et plus : %2</translation></message>
<message><source>Perhaps, %1 to 69 %: %2</source><translation>Peut-être, %1 à 69 % : %2</translation></message>
<message><source>Fold in a rock, %1 to 29 %: %2</source><translation>Pli dans une roche, %1 à 29 % : %2</translation></message>
<message><source>Fold in a rock, below 30 %: %1</source><translation>Pli dans une roche, moins de 30 % : %1</translation></message>
<message><source>Violet stripes in the images: no return, outside of the range window, or masked. The status bar counts each.</source><translation>Rayures violettes dans les images : sans retour, hors de la fenêtre de distance, ou masqué. La barre d'état compte chaque cas.</translation></message>
<message><source>Dark red stripes in the images: the scanner sent a status code in place of a range.</source><translation>Rayures rouge foncé dans les images : le scanner a envoyé un code d'état à la place d'une distance.</translation></message>
<message><source>Laser ray to the marked cell</source><translation>Rayon laser vers la cellule marquée</translation></message>
<message><source>No return: %1</source><translation>Sans retour : %1</translation></message>
<message><source>No range: %1</source><translation>Sans distance : %1</translation></message>
<message><source>Status code: %1</source><translation>Code d'état : %1</translation></message>
<message><source>▥ Filled, not measured: %1</source><translation>▥ Remplies, non mesurées : %1</translation></message>
<message><source>Edges, under rocks</source><translation>Arêtes, sous les blocs</translation></message>
<message><source>Draws the edge points over the rocks</source><translation>Dessine les points d'arête par-dessus les blocs</translation></message>
<message><source>Edge points on and off: E</source><translation>Points d'arête affichés ou non : E</translation></message>
<message><source>%1 mm at %2 m</source><translation>%1 mm à %2 m</translation></message>
<message><source>neighbours err alike, as in a depth camera</source><translation>les voisins se trompent ensemble, comme dans une caméra de profondeur</translation></message>
<message><source>each cell errs for itself, in steps of the file</source><translation>chaque cellule se trompe seule, par pas du fichier</translation></message>
<message><source>each cell errs for itself</source><translation>chaque cellule se trompe seule</translation></message>
<message><source>Noise in use: %1; sigma %2, %3, %4.</source><translation>Bruit retenu : %1 ; sigma %2, %3, %4.</translation></message>
<message><source>Folds have to exceed %1.</source><translation>Les plis doivent dépasser %1.</translation></message>
<message><source>Rough scan: around half of the folds %1 % of the cells fold, so a fold must exceed its surroundings.</source><translation>Scan rugueux : autour de la moitié des plis, %1 % des cellules sont plissées ; un pli doit donc dépasser son entourage.</translation></message>
<message><source>Advanced</source><translation>Avancé</translation></message>
<message><source>Default</source><translation>Défaut</translation></message>
<message><source>For most scans of rock</source><translation>Pour la plupart des scans</translation></message>
<message><source>Percent of range</source><translation>Pourcentage de la distance</translation></message>
<message><source>Steps in percent of the range</source><translation>Sauts en % de la distance</translation></message>
<message><source>Thesis</source><translation>Thèse</translation></message>
<message><source>To compare with the thesis</source><translation>Pour comparer à la thèse</translation></message>
<message><source>Thesis, contrast</source><translation>Thèse, contraste</translation></message>
<message><source>The thesis, with more contrast</source><translation>La thèse, plus contrastée</translation></message>
<message><source>Smooth walls</source><translation>Parois lisses</translation></message>
<message><source>For flat walls with low steps</source><translation>Parois planes, petits sauts</translation></message>
<message><source>Version 4</source><translation>Version 4</translation></message>
<message><source>To compare with version 4</source><translation>Pour comparer à la version 4</translation></message>
<message><source>Version 3</source><translation>Version 3</translation></message>
<message><source>To compare with version 3</source><translation>Pour comparer à la version 3</translation></message>
<message><source>Open…</source><translation>Ouvrir…</translation></message>
<message><source>Open a preset file</source><translation>Ouvrir un fichier de préréglage</translation></message>
<message><source>Save…</source><translation>Enregistrer…</translation></message>
<message><source>Save these settings as a preset file</source><translation>Enregistrer ces réglages dans un fichier de préréglage</translation></message>
<message><source>Preset</source><translation>Préréglage</translation></message>
<message><source>The steps in depth that reach the thresholds, computed from the kernels: the smaller number for a step that runs diagonally, the larger one along lines or beams. A depth such as 0.5 m can be typed into the box above; with logarithmic gray levels it is taken at the range given here, and a share such as 5 % holds at every range.</source><translation>Les marches en profondeur qui atteignent les seuils, calculées à partir des noyaux : le plus petit nombre pour une marche en diagonale, le plus grand pour une marche le long des lignes ou des faisceaux. Une profondeur telle que 0.5 m peut être tapée dans le champ ci-dessus ; avec des niveaux de gris logarithmiques, elle est prise à la distance donnée ici, et une part telle que 5 % vaut à toute distance.</translation></message>
<message><source>Locked: the upper threshold is 3 times the lower one, as in the thesis. Click to open the lock.</source><translation>Verrouillé : le seuil haut est 3 fois le seuil bas, comme dans la thèse. Cliquez pour ouvrir le verrou.</translation></message>
<message><source>Locked 1 : 3</source><translation>Verrouillé 1 : 3</translation></message>
<message><source>Unlocked</source><translation>Déverrouillé</translation></message>
<message><source>Strong from  %1 % of range</source><translation>Forte dès  %1 % de la distance</translation></message>
<message><source>Upper threshold  %1</source><translation>Seuil haut  %1</translation></message>
<message><source>  (no gradient reaches it)</source><translation>  (aucun gradient ne l'atteint)</translation></message>
<message><source>• modified</source><translation>• modifié</translation></message>
<message><source>In files and on the command line its name is %1</source><translation>Dans les fichiers et dans la ligne de commande, son nom est %1</translation></message>
<message><source>From a file</source><translation>D'un fichier</translation></message>
<message><source>computing …</source><translation>calcul en cours …</translation></message>
<message><source>
%1 to %2 %3</source><translation>
%1 à %2 %3</translation></message>
<message><source>
Double-click: back to the preset</source><translation>
Double-clic : retour au préréglage</translation></message>
<message><source>less: %1</source><translation>moins : %1</translation></message>
<message><source>more: %1</source><translation>plus : %1</translation></message>
<message><source>More edges</source><translation>Plus d'arêtes</translation></message>
<message><source>Fewer edges</source><translation>Moins d'arêtes</translation></message>
<message><source>%1: %2; %3. The value stays as it was.</source><translation>%1 : %2 ; %3. La valeur reste telle qu'elle était.</translation></message>
<message><source>auto</source><translation>auto</translation></message>
<message><source>Back to %1, the value of the preset</source><translation>Revenir à %1, la valeur du préréglage</translation></message>
<message><source>Ends of the range window</source><translation>Bornes de la fenêtre de distances</translation></message>
<message><source>Drag an end, or Left and Right for the far one, with Shift for the near one; a double-click makes it automatic</source><translation>Faites glisser une borne, ou Gauche et Droite pour la borne lointaine, avec Maj pour la proche ; un double-clic la rend automatique</translation></message>
<message><source>Gray</source><translation>Gris</translation></message>
<message><source>Auto</source><translation>Auto</translation></message>
<message><source>Black and white as the method scales the ranges</source><translation>Noir et blanc selon l'échelle de distances de la méthode</translation></message>
<message><source>The window stays as it is when another scan is opened</source><translation>La fenêtre reste telle quelle quand un autre scan est ouvert</translation></message>
<message><source>%1 to %2 m</source><translation>de %1 à %2 m</translation></message>
<message><source>automatic: %1</source><translation>automatique : %1</translation></message>
<message><source>filled, not measured: %1 m ± %2 m</source><translation>remplie, non mesurée : %1 m ± %2 m</translation></message>
<message><source>range %1 m</source><translation>distance %1 m</translation></message>
<message><source>device status %1</source><translation>état de l'appareil %1</translation></message>
<message><source>E %1  N %2  RL %3</source><translation>E %1  N %2  RL %3</translation></message>
<message><source>EDGE</source><translation>ARÊTE</translation></message>
<message><source>not an edge</source><translation>pas une arête</translation></message>
<message><source>line %1  beam %2</source><translation>ligne %1  faisceau %2</translation></message>
<message><source>  at %1° / %2°</source><translation>  à %1° / %2°</translation></message>
<message><source>  gray %1</source><translation>  gris %1</translation></message>
<message><source>Without a pose, coordinates count from the scanner, not from the mine grid. Scan &gt; Pose and Mounting… takes one.</source><translation>Sans pose, les coordonnées comptent à partir du scanner, non de la grille de la mine. Scan &gt; Pose et montage… en prend une.</translation></message>
<message><source>Pinned:</source><translation>Épinglée :</translation></message>
<message><source>Pinned nearby:</source><translation>Épinglée à côté :</translation></message>
<message><source>OUT OF SPEC</source><translation>HORS TOLÉRANCE</translation></message>
<message><source> · origin E %1 N %2 RL %3</source><translation> · origine E %1 N %2 RL %3</translation></message>
<message><source>A click opens the pose, to change or remove it.</source><translation>Un clic ouvre la pose, pour la changer ou la retirer.</translation></message>
<message><source>first line %1</source><translation>première ligne %1</translation></message>
<message><source>%1 no return</source><translation>%1 sans retour</translation></message>
<message><source> · %1 status</source><translation> · %1 état de l'appareil</translation></message>
<message><source> · %1 filled</source><translation> · %1 comblées</translation></message>
<message><source>Edges found in %1 ms</source><translation>Arêtes trouvées en %1 ms</translation></message>
<message><source>%1 cells · edges pending</source><translation>%1 cellules · arêtes en attente</translation></message>
<message><source>edges pending</source><translation>arêtes en attente</translation></message>
<message><source>%1: %2 instead of %3</source><translation>%1 : %2 au lieu de %3</translation></message>
<message><source>default settings</source><translation>réglages par défaut</translation></message>
<message><source>settings: %1 changed</source><translation>réglages : %1 modifié(s)</translation></message>
<message><source>%1 changed</source><translation>%1 modifié(s)</translation></message>
<message><source>Set of default settings: %1</source><translation>Jeu de réglages par défaut : %1</translation></message>
<message><source>Reset %1</source><translation>Rétablir %1</translation></message>
<message><source>Reset all</source><translation>Tout rétablir</translation></message>
<message><source>All settings are those of the default set.</source><translation>Tous les réglages sont ceux du jeu par défaut.</translation></message>
<message><source>Ctrl+D restores the default settings.</source><translation>Ctrl+D rétablit les réglages par défaut.</translation></message>
<message><source>1 warning</source><translation>1 avertissement</translation></message>
<message><source>Acknowledged.</source><translation>Vus.</translation></message>
<message><source>Shows the warnings of this scan and acknowledges them. They remain in records and screenshots.</source><translation>Montre les avertissements de ce scan et les marque comme vus. Ils restent dans les comptes rendus et les captures d'écran.</translation></message>
<message><source>no scan open</source><translation>aucun scan ouvert</translation></message>
<message><source>no point to show: all %1 points are hidden; Measure &gt; Show All shows them</source><translation>aucun point à afficher : les %1 points sont tous masqués ; Mesurer &gt; Tout afficher les montre</translation></message>
<message><source>no point to show: no cell of this scan has a valid range</source><translation>aucun point à afficher : aucune cellule de ce scan n'a de distance valide</translation></message>
<message><source>There is no OpenGL on this display, so the 3D view cannot draw.</source><translation>Il n'y a pas d'OpenGL sur cet affichage : la vue 3D ne peut pas dessiner.</translation></message>
<message><source>OpenGL is installed but does not start on this display, so the 3D view cannot draw.</source><translation>OpenGL est installé mais ne démarre pas sur cet affichage : la vue 3D ne peut pas dessiner.</translation></message>
<message><source>The 3D view needs OpenGL 3.2; this display offers %1.%2 (%3).</source><translation>La vue 3D a besoin d'OpenGL 3.2 ; cet affichage offre %1.%2 (%3).</translation></message>
<message><source>The bar has this length at the median distance of the points in view. The distance counts from the scanner.</source><translation>La barre a cette longueur à la distance médiane des points en vue. La distance se compte depuis le scanner.</translation></message>
<message><source>grid %1</source><translation>grille %1</translation></message>
<message><source>%1 at %2 m</source><translation>%1 à %2 m</translation></message>
<message><source>Range [m]</source><translation>Distance [m]</translation></message>
<message><source>Height above the scanner [m]</source><translation>Hauteur sur le scanner [m]</translation></message>
<message><source>Front</source><translation>Avant</translation></message>
<message><source>Left</source><translation>Gauche</translation></message>
<message><source>Right</source><translation>Droite</translation></message>
<message><source>Top</source><translation>Haut</translation></message>
<message><source>Bottom</source><translation>Bas</translation></message>
<message><source>Click a face: look at the cloud from there</source><translation>Cliquez sur une face : regarder le nuage de là</translation></message>
<message><source>Without a pose, up is the scanner's z</source><translation>Sans pose, le haut est l'axe z du scanner</translation></message>
<message><source>Show the whole images</source><translation>Montrer les images entières</translation></message>
<message><source>Zoomed %1 × · Fit</source><translation>Agrandi %1 × · Ajuster</translation></message>
<message><source>Tune</source><translation>Régler</translation></message>
<message><source>Back to the cloud</source><translation>Retour au nuage</translation></message>
<message><source>Hold it for one second to leave.</source><translation>Tenez 1 s pour quitter.</translation></message>
<message><source>No scan</source><translation>Aucun scan</translation></message>
<message><source>Open one, or connect to a scanner</source><translation>Ouvrez-en un, ou connectez un scanner</translation></message>
<message><source>%1 of %2 lines</source><translation>%1 lignes sur %2</translation></message>
<message><source> · %1 % no return</source><translation> · %1 % sans retour</translation></message>
<message><source>Range image</source><translation>Image de distances</translation></message>
<message><source>Edge map</source><translation>Carte des arêtes</translation></message>
<message><source>Cloud</source><translation>Nuage de points</translation></message>
<message><source>Small picture</source><translation>Petite image</translation></message>
<message><source>Rock…</source><translation>Bloc…</translation></message>
<message><source>What can be done with rocks</source><translation>Ce qu'on peut faire avec les blocs</translation></message>
<message><source>Views</source><translation>Vues</translation></message>
<message><source>Take the last point back</source><translation>Annuler le dernier point</translation></message>
<message><source>Targets</source><translation>Cibles</translation></message>
<message><source>Layers</source><translation>Couches</translation></message>
<message><source>Rock Table</source><translation>Tableau des blocs</translation></message>
<message><source>Hide panel</source><translation>Masquer le panneau</translation></message>
<message><source>turned by %1°</source><translation>tournées de %1°</translation></message>
<message><source>mirrored</source><translation>en miroir</translation></message>
<message><source>gray %1 to %2 m</source><translation>gris %1 à %2 m</translation></message>
<message><source>up to line %1</source><translation>jusqu'à la ligne %1</translation></message>
<message><source>by class</source><translation>par classe</translation></message>
<message><source>growing</source><translation>en cours</translation></message>
<message><source>%1 % of the points drawn</source><translation>%1 % des points dessinés</translation></message>
<message><source>turntable</source><translation>plateau tournant</translation></message>
<message><source>free rotation</source><translation>rotation libre</translation></message>
<message><source>orthographic</source><translation>orthographique</translation></message>
<message><source>perspective</source><translation>perspective</translation></message>
<message><source>coarse picture</source><translation>image grossière</translation></message>
<message><source>Warnings of this scan:
</source><translation>Avertissements de ce scan :
</translation></message>
<message><source>&amp;Legends at the Side</source><translation>&amp;Légendes sur le côté</translation></message>
<message><source>view of the cloud</source><translation>vue du nuage</translation></message>
<message><source>Letters outside a field are keys; these changed: %1.</source><translation>Les lettres hors d'un champ sont des touches ; celles-ci ont changé : %1.</translation></message>
<message><source>Opening another scan · still shown: </source><translation>Ouverture d'un autre scan · encore à l'écran : </translation></message>
<message><source>The manual is not installed. Its texts are in the folder docs of the source, page %1.</source><translation>Le manuel n'est pas installé. Ses textes sont dans le dossier docs des sources, page %1.</translation></message>
<message><source>No browser opened the manual. It is the file %1.</source><translation>Aucun navigateur n'a ouvert le manuel. C'est le fichier %1.</translation></message>
<message><source>Compare &amp;A/B</source><translation>Comparer &amp;A/B</translation></message>
<message><source>&amp;Keep This as A</source><translation>&amp;Garder ceci comme A</translation></message>
<message><source>&amp;Compare with Earlier Scan…</source><translation>&amp;Comparer avec un scan antérieur…</translation></message>
<message><source>Exchange A and &amp;B</source><translation>Échanger A et &amp;B</translation></message>
<message><source>&amp;Demo before and after a Blast</source><translation>&amp;Démo avant et après un tir</translation></message>
<message><source>Show &amp;A</source><translation>Afficher &amp;A</translation></message>
<message><source>Show What &amp;Changed</source><translation>Afficher ce qui a &amp;changé</translation></message>
<message><source>&amp;Colour by Distance from A</source><translation>&amp;Couleur selon la distance à A</translation></message>
<message><source>&amp;Next Changed Region</source><translation>Région modifiée &amp;suivante</translation></message>
<message><source>&amp;Previous Changed Region</source><translation>Région modifiée &amp;précédente</translation></message>
<message><source>&amp;Forget A</source><translation>&amp;Oublier A</translation></message>
<message><source>Edge Con&amp;fidence</source><translation>Con&amp;fiance des arêtes</translation></message>
<message><source>Colours and sizes of edges by how many settings near these find them too</source><translation>Couleurs et tailles des arêtes selon le nombre de réglages voisins qui les trouvent aussi</translation></message>
<message><source>“%1” has ended; a click selects a rock again.</source><translation>« %1 » est terminé ; un clic choisit à nouveau un bloc.</translation></message>
<message><source>“%1” has ended; a click pins again.</source><translation>« %1 » est terminé ; un clic épingle à nouveau.</translation></message>
<message><source>&amp;Edges over Rocks</source><translation>A&amp;rêtes sur les blocs</translation></message>
<message><source>&amp;Rocks</source><translation>&amp;Blocs</translation></message>
<message><source>&amp;Show Rocks</source><translation>&amp;Afficher les blocs</translation></message>
<message><source>&amp;Largest Rock by Width b</source><translation>&amp;Bloc de plus grande largeur b</translation></message>
<message><source>Next Sm&amp;aller Rock by Width b</source><translation>Bloc suivant, &amp;largeur b plus petite</translation></message>
<message><source>&amp;Merge Rocks</source><translation>F&amp;usionner des blocs</translation></message>
<message><source>S&amp;plit a Rock</source><translation>&amp;Scinder un bloc</translation></message>
<message><source>Merge al&amp;ong a Line</source><translation>Fus&amp;ionner le long d'une ligne</translation></message>
<message><source>C&amp;ut along a Line</source><translation>&amp;Couper le long d'une ligne</translation></message>
<message><source>&amp;Not a Rock, or a Rock Again</source><translation>&amp;Pas un bloc, ou un bloc tout de même</translation></message>
<message><source>Na&amp;me This Rock…</source><translation>No&amp;mmer ce bloc…</translation></message>
<message><source>&amp;Finer</source><translation>Plus &amp;fin</translation></message>
<message><source>&amp;Coarser</source><translation>Plus &amp;grossier</translation></message>
<message><source>Draw Region of &amp;Interest</source><translation>&amp;Dessiner la région d'intérêt</translation></message>
<message><source>Clear Re&amp;gion of Interest</source><translation>&amp;Effacer la région d'intérêt</translation></message>
<message><source>E&amp;xport Rocks…</source><translation>E&amp;xporter les blocs…</translation></message>
<message><source>slope, grade and length of a straight line</source><translation>inclinaison, pente et longueur d’une droite</translation></message>
<message><source>&amp;Measure</source><translation>&amp;Mesurer</translation></message>
<message><source>&amp;Pin</source><translation>É&amp;pingler</translation></message>
<message><source>&amp;Distance</source><translation>&amp;Distance</translation></message>
<message><source>&amp;Vertical</source><translation>&amp;Verticale</translation></message>
<message><source>&amp;Angle</source><translation>&amp;Angle</translation></message>
<message><source>&amp;Spans a × b</source><translation>É&amp;tendues a × b</translation></message>
<message><source>Along S&amp;urface</source><translation>Le long de la &amp;surface</translation></message>
<message><source>Thr&amp;oat Width</source><translation>Largeur du &amp;goulot</translation></message>
<message><source>Se&amp;ction through the Measurement</source><translation>&amp;Coupe par la mesure</translation></message>
<message><source>Section th&amp;rough the Rock</source><translation>Coupe par le &amp;bloc</translation></message>
<message><source>&amp;Box</source><translation>&amp;Boîte</translation></message>
<message><source>&amp;Lasso</source><translation>&amp;Lasso</translation></message>
<message><source>Na&amp;me This Target</source><translation>Nomme&amp;r cette cible</translation></message>
<message><source>Remove This Tar&amp;get</source><translation>Supprimer &amp;cette cible</translation></message>
<message><source>Remove All &amp;Targets</source><translation>Supprimer t&amp;outes les cibles</translation></message>
<message><source>&amp;Copy This Target</source><translation>Copi&amp;er cette cible</translation></message>
<message><source>Sho&amp;w All</source><translation>Tout a&amp;fficher</translation></message>
<message><source>Clip to Bo&amp;x round Selected</source><translation>Couper à une &amp;boîte autour de la sélection</translation></message>
<message><source>&amp;Range Gate…</source><translation>Fenêtre de &amp;distance…</translation></message>
<message><source>Hide &amp;Farther than This Cell</source><translation>Masquer ce qui est plus &amp;loin que cette cellule</translation></message>
<message><source>Hide Nearer than This Cell</source><translation>Masquer ce qui est plus proche que cette cellule</translation></message>
<message><source>&amp;Zoom to Selected</source><translation>&amp;Zoomer sur la sélection</translation></message>
<message><source>Select &amp;Nothing</source><translation>&amp;Ne rien sélectionner</translation></message>
<message><source>There are no targets yet: pin a cell first.</source><translation>Il n'y a pas encore de cible : épinglez d'abord une cellule.</translation></message>
<message><source>Edge &amp;Drawing (DXF)…</source><translation>&amp;Dessin des arêtes (DXF)…</translation></message>
<message><source>&amp;Selected Cells…</source><translation>Cellules &amp;sélectionnées…</translation></message>
<message><source>Open &amp;Recent</source><translation>Ouvrir un fichier &amp;récent</translation></message>
<message><source>&amp;File</source><translation>&amp;Fichier</translation></message>
<message><source>&amp;Open…</source><translation>&amp;Ouvrir…</translation></message>
<message><source>Open &amp;Demo Draw-Bell</source><translation>Ouvrir la cloche de &amp;démonstration</translation></message>
<message><source>Demo before and after a &amp;Blast</source><translation>Démo avant et après un &amp;tir</translation></message>
<message><source>&amp;Connect to Scanner…</source><translation>&amp;Connecter au scanner…</translation></message>
<message><source>Re&amp;load</source><translation>Rechar&amp;ger</translation></message>
<message><source>&amp;Export</source><translation>&amp;Exporter</translation></message>
<message><source>Re&amp;port…</source><translation>Ra&amp;pport…</translation></message>
<message><source>&amp;Screenshot…</source><translation>Capture d'écra&amp;n…</translation></message>
<message><source>&amp;Copy as Command</source><translation>Copier comme co&amp;mmande</translation></message>
<message><source>&amp;Quit</source><translation>&amp;Quitter</translation></message>
<message><source>&amp;Undo</source><translation>&amp;Annuler</translation></message>
<message><source>&amp;Redo</source><translation>&amp;Rétablir</translation></message>
<message><source>&amp;Edit</source><translation>É&amp;dition</translation></message>
<message><source>&amp;Copy Probe Values</source><translation>&amp;Copier les valeurs sous le curseur</translation></message>
<message><source>&amp;Edge Points</source><translation>&amp;Points d'arête</translation></message>
<message><source>Edges &amp;by Class</source><translation>Arêtes par &amp;classe</translation></message>
<message><source>Edges &amp;over Range Image</source><translation>A&amp;rêtes sur l'image de distances</translation></message>
<message><source>&amp;Colour-Blind Edge Colours</source><translation>Couleurs des arêtes pour dalton&amp;iens</translation></message>
<message><source>I&amp;mages</source><translation>I&amp;mages</translation></message>
<message><source>True &amp;Angle Aspect</source><translation>Proportions angulaires r&amp;éelles</translation></message>
<message><source>Turn by a &amp;Quarter</source><translation>Tourner d’un &amp;quart à droite</translation></message>
<message><source>Turn by a &amp;Half</source><translation>Tourner d’un &amp;demi-tour</translation></message>
<message><source>&amp;Mirror</source><translation>&amp;Miroir</translation></message>
<message><source>Loo&amp;k from</source><translation>&amp;Regarder depuis</translation></message>
<message><source>From &amp;Scanner</source><translation>Depuis le &amp;scanner</translation></message>
<message><source>&amp;Front</source><translation>De &amp;face</translation></message>
<message><source>&amp;Back</source><translation>De l'&amp;arrière</translation></message>
<message><source>&amp;Right</source><translation>De &amp;droite</translation></message>
<message><source>&amp;Left</source><translation>De &amp;gauche</translation></message>
<message><source>&amp;Top (from Above)</source><translation>De dess&amp;us</translation></message>
<message><source>Botto&amp;m (from Below)</source><translation>De dess&amp;ous</translation></message>
<message><source>&amp;Isometric</source><translation>&amp;Isométrique</translation></message>
<message><source>Sto&amp;red Views</source><translation>&amp;Vues enregistrées</translation></message>
<message><source>View &amp;%1</source><translation>Vue &amp;%1</translation></message>
<message><source>Store as View &amp;%1</source><translation>Enregistrer comme vue &amp;%1</translation></message>
<message><source>Clou&amp;d</source><translation>&amp;Nuage de points</translation></message>
<message><source>&amp;Orthographic</source><translation>&amp;Orthographique</translation></message>
<message><source>T&amp;urntable</source><translation>Plateau &amp;tournant</translation></message>
<message><source>&amp;Dim Cloud under Edges</source><translation>Atté&amp;nuer le nuage sous les arêtes</translation></message>
<message><source>Depth S&amp;hading</source><translation>Om&amp;brage de profondeur</translation></message>
<message><source>&amp;Ground Grid</source><translation>&amp;Grille au sol</translation></message>
<message><source>Vie&amp;w Cube</source><translation>&amp;Cube des vues</translation></message>
<message><source>Point Size &amp;+</source><translation>Taille des points &amp;+</translation></message>
<message><source>Point Size &amp;-</source><translation>Taille des points &amp;-</translation></message>
<message><source>Point Size by &amp;Spacing</source><translation>Taille des points selon l'espa&amp;cement</translation></message>
<message><source>&amp;Panels</source><translation>&amp;Panneaux</translation></message>
<message><source>&amp;View</source><translation>&amp;Affichage</translation></message>
<message><source>Fit All Vi&amp;ews</source><translation>&amp;Ajuster toutes les vues</translation></message>
<message><source>&amp;Zoom In</source><translation>&amp;Zoom avant</translation></message>
<message><source>Zoom O&amp;ut</source><translation>Zoom a&amp;rrière</translation></message>
<message><source>Fl&amp;y to Point under Cursor</source><translation>&amp;Voler vers le point sous le curseur</translation></message>
<message><source>Reset &amp;Layout</source><translation>Réinitia&amp;liser la disposition</translation></message>
<message><source>Full Scree&amp;n</source><translation>&amp;Plein écran</translation></message>
<message><source>P&amp;ose and Mounting…</source><translation>Pose et monta&amp;ge…</translation></message>
<message><source>&amp;Scan</source><translation>&amp;Scan</translation></message>
<message><source>&amp;Next Scan</source><translation>Scan &amp;suivant</translation></message>
<message><source>Pre&amp;vious Scan</source><translation>Scan &amp;précédent</translation></message>
<message><source>&amp;Add a Scan as a Layer…</source><translation>&amp;Ajouter un scan comme couche…</translation></message>
<message><source>&amp;Record</source><translation>&amp;Enregistrer</translation></message>
<message><source>&amp;Keep Last Minute</source><translation>&amp;Conserver la dernière minute</translation></message>
<message><source>S&amp;weep…</source><translation>&amp;Balayage…</translation></message>
<message><source>&amp;Hold First Sweep of a Connection at Its End</source><translation>&amp;Figer le premier balayage d'une connexion à sa fin</translation></message>
<message><source>Recordings &amp;Folder…</source><translation>&amp;Dossier des enregistrements…</translation></message>
<message><source>P&amp;lay or Pause</source><translation>&amp;Lire ou mettre en pause</translation></message>
<message><source>Next Line</source><translation>Ligne suivante</translation></message>
<message><source>Previous Line</source><translation>Ligne précédente</translation></message>
<message><source>Ten Lines Forward</source><translation>Dix lignes en avant</translation></message>
<message><source>Ten Lines Back</source><translation>Dix lignes en arrière</translation></message>
<message><source>&amp;Straighten Beams</source><translation>&amp;Redresser les faisceaux</translation></message>
<message><source>Keep Repeate&amp;d Values</source><translation>Gar&amp;der les valeurs répétées</translation></message>
<message><source>&amp;How the Scan Is Read…</source><translation>Co&amp;mment le scan est lu…</translation></message>
<message><source>Does This Look &amp;Right?</source><translation>Est-ce que cela paraît &amp;juste ?</translation></message>
<message><source>&amp;Properties…</source><translation>Pr&amp;opriétés…</translation></message>
<message><source>&amp;Presets</source><translation>&amp;Préréglages</translation></message>
<message><source>&amp;Save…</source><translation>&amp;Enregistrer…</translation></message>
<message><source>&amp;Edges</source><translation>A&amp;rêtes</translation></message>
<message><source>&amp;Lock upper = 3 × lower</source><translation>&amp;Verrouiller haut = 3 × bas</translation></message>
<message><source>&amp;Only Rock Borders</source><translation>Contours de roche seulemen&amp;t</translation></message>
<message><source>This &amp;Is an Edge</source><translation>Ceci &amp;est une arête</translation></message>
<message><source>This Is &amp;Not an Edge</source><translation>Ceci &amp;n'est pas une arête</translation></message>
<message><source>Settings for These &amp;Marks…</source><translation>Réglages pour ces &amp;marques…</translation></message>
<message><source>Clear the Mar&amp;ks</source><translation>Effacer les mar&amp;ques</translation></message>
<message><source>&amp;Why Is This Cell an Edge or Not?</source><translation>Pour&amp;quoi cette cellule est-elle une arête, ou non ?</translation></message>
<message><source>&amp;Reset to Preset</source><translation>&amp;Revenir au préréglage</translation></message>
<message><source>Restore the &amp;Default Settings</source><translation>Rétablir les réglages par &amp;défaut</translation></message>
<message><source>&amp;Help</source><translation>A&amp;ide</translation></message>
<message><source>&amp;Find a Command…</source><translation>&amp;Trouver une commande…</translation></message>
<message><source>&amp;Manual</source><translation>&amp;Manuel</translation></message>
<message><source>&amp;Keys and Mouse</source><translation>&amp;Clavier et souris</translation></message>
<message><source>&amp;Tour</source><translation>&amp;Visite</translation></message>
<message><source>&amp;About EdgeScan</source><translation>À &amp;propos d'EdgeScan</translation></message>
<message><source>Open Sess&amp;ion…</source><translation>Ouvrir une sess&amp;ion…</translation></message>
<message><source>&amp;Save Session As…</source><translation>Enregi&amp;strer la session sous…</translation></message>
<message><source>Go on with the &amp;Last Session</source><translation>Reprendre la &amp;dernière session</translation></message>
<message><source>Tools</source><translation>Outils</translation></message>
<message><source>Pin</source><translation>Épingler</translation></message>
<message><source>Scanner view</source><translation>Vue scanner</translation></message>
<message><source>Cab</source><translation>Cabine</translation></message>
<message><source>A/B</source><translation>A/B</translation></message>
<message><source>&amp;Theme</source><translation>&amp;Thème</translation></message>
<message><source>Lan&amp;guage</source><translation>Lan&amp;gue</translation></message>
<message><source>The window uses this language from the next start on.</source><translation>La fenêtre parle cette langue à partir de son prochain démarrage.</translation></message>
<message><source>Restart Now</source><translation>Redémarrer maintenant</translation></message>
<message><source>&amp;Mouse</source><translation>S&amp;ouris</translation></message>
<message><source>&amp;Default: middle pans, right zooms</source><translation>&amp;Par défaut : milieu déplace, droite zoome</translation></message>
<message><source>&amp;CloudCompare: right pans, middle zooms</source><translation>&amp;CloudCompare : droite déplace, milieu zoome</translation></message>
<message><source>&amp;Wheel the other way</source><translation>&amp;Molette en sens inverse</translation></message>
<message><source>By &amp;Intensity</source><translation>Par &amp;intensité</translation></message>
<message><source>By &amp;Intensity (this scan has none)</source><translation>Par &amp;intensité (ce scan n'en a pas)</translation></message>
<message><source>Cloud C&amp;olour</source><translation>C&amp;ouleur du nuage</translation></message>
<message><source>G&amp;ray</source><translation>&amp;Gris</translation></message>
<message><source>By &amp;Range</source><translation>Par &amp;distance</translation></message>
<message><source>By &amp;Height</source><translation>Par &amp;hauteur</translation></message>
<message><source>By &amp;Line</source><translation>Par &amp;ligne</translation></message>
<message><source>&amp;Sizes of Views</source><translation>&amp;Tailles des vues</translation></message>
<message><source>&amp;Next Sizes of Views</source><translation>Tailles &amp;suivantes des vues</translation></message>
<message><source>&amp;Balanced</source><translation>É&amp;quilibrée</translation></message>
<message><source>&amp;Images Large</source><translation>&amp;Grandes images</translation></message>
<message><source>&amp;Cloud Large</source><translation>&amp;Nuage en grand</translation></message>
<message><source>C&amp;ab Mode</source><translation>Mode c&amp;abine</translation></message>
<message><source>Next Sweep</source><translation>Balayage suivant</translation></message>
<message><source>Undo brings %1 back with its targets and measurements: the next sweep replaced it.</source><translation>Annuler ramène %1 avec ses cibles et ses mesures : le balayage suivant l'a remplacé.</translation></message>
<message><source>%1 is no longer compared as A, because it may be of another place. Undo (Ctrl+Z) brings it back.</source><translation>%1 n'est plus comparé comme A, car il peut venir d'un autre endroit. Annuler (Ctrl+Z) le ramène.</translation></message>
<message><source>The window has no room for the images next to this panel: they come back when you fold it.</source><translation>La fenêtre n'a pas de place pour les images à côté de ce panneau : elles reviennent quand vous le repliez.</translation></message>
<message><source>Close EdgeScan?</source><translation>Fermer EdgeScan ?</translation></message>
<message><source>A recording is being written.</source><translation>Un enregistrement est en cours d'écriture.</translation></message>
<message><source>A file is still being written.</source><translation>Un fichier est encore en cours d'écriture.</translation></message>
<message><source>Your targets and your edits of rocks are not stored.</source><translation>Vos cibles et vos modifications de roches ne sont pas enregistrées.</translation></message>
<message><source>Your targets are not stored.</source><translation>Vos cibles ne sont pas enregistrées.</translation></message>
<message><source>Your edits of rocks are not stored.</source><translation>Vos modifications de roches ne sont pas enregistrées.</translation></message>
<message><source>This ends the program.</source><translation>Ceci termine le programme.</translation></message>
<message><source>Closing ends the recording. What was recorded so far remains in its file.</source><translation>Fermer met fin à l'enregistrement. Ce qui a été enregistré jusqu'ici reste dans son fichier.</translation></message>
<message><source>Closing waits until it is complete.</source><translation>La fermeture attend qu'il soit complet.</translation></message>
<message><source>The disk refused them. EdgeScan tries again as it closes; what it cannot write then is lost.</source><translation>Le disque les a refusées. EdgeScan réessaie en se fermant ; ce qu'il ne peut pas écrire alors est perdu.</translation></message>
<message><source>To leave cab mode only, cancel, then hold the button “Hold to leave” for one second.</source><translation>Pour quitter seulement le mode cabine, annulez, puis maintenez une seconde le bouton « Tenir : quitter ».</translation></message>
<message><source>End the Recording and Close</source><translation>Terminer l'enregistrement et fermer</translation></message>
<message><source>Close EdgeScan</source><translation>Fermer EdgeScan</translation></message>
<message><source>The tour has ended; Help &gt; Tour begins it again.</source><translation>La visite est terminée ; Aide &gt; Visite la recommence.</translation></message>
<message><source>Drawing with edge lines</source><translation>Dessin avec les lignes des arêtes</translation></message>
<message><source>E57</source><translation>E57</translation></message>
<message><source>Range picture</source><translation>Image de distances</translation></message>
<message><source>LAS point cloud</source><translation>Nuage de points LAS</translation></message>
<message><source>numpy array</source><translation>Tableau numpy</translation></message>
<message><source>Wavefront OBJ</source><translation>OBJ de Wavefront</translation></message>
<message><source>Point Cloud Library</source><translation>Point Cloud Library (PCL)</translation></message>
<message><source>Polygon file</source><translation>Fichier de polygones</translation></message>
<message><source>Point list</source><translation>Liste de points</translation></message>
<message><source>Point table</source><translation>Tableau de points</translation></message>
<message><source>3DTK scan</source><translation>Scan 3DTK</translation></message>
<message><source>Leica PTX</source><translation>Leica PTX</translation></message>
<message><source>Range or point table</source><translation>Tableau de distances ou de points</translation></message>
<message><source>Raw grid</source><translation>Grille brute</translation></message>
<message><source>Recording</source><translation>Enregistrement</translation></message>
<message><source>How edges are found: jumps and folds of the surface, parts of these, or Canny on gray levels as in the thesis, or one of the other detectors the thesis compares.</source><translation>Comment les arêtes sont trouvées : sauts et plis de la surface, parties de ceux-ci, ou Canny sur niveaux de gris comme dans la thèse, ou un des autres détecteurs que la thèse compare.</translation></message>
<message><source>Edges shown</source><translation>Arêtes affichées</translation></message>
<message><source>Only edges that are likely the border of a rock are shown and exported; folds within a rock are left out.</source><translation>Seules les arêtes qui sont probablement le contour d'une roche sont affichées et exportées ; les plis dans une roche sont omis.</translation></message>
<message><source>Border from</source><translation>Contour dès</translation></message>
<message><source>How likely an edge must be the border of a rock to be shown among the rock borders.</source><translation>La probabilité qu'une arête soit le contour d'une roche, à partir de laquelle elle est affichée parmi les contours de roches.</translation></message>
<message><source>Edge strength</source><translation>Force de l'arête</translation></message>
<message><source>How strong an edge must be, so higher finds fewer: 1 is the jump and the crease angle below, 2 is twice that.</source><translation>Quelle force une arête doit avoir : 1 est le saut et l'angle de pli ci-dessous, 2 en est le double.</translation></message>
<message><source>Jump</source><translation>Saut</translation></message>
<message><source>Smallest step in depth that is an edge, near the scanner; auto takes 30 mm and more where the ranges are noisy.</source><translation>Plus petite marche en profondeur qui est une arête, près du scanner ; auto prend 30 mm, et plus là où les distances sont bruitées.</translation></message>
<message><source>Jump growth</source><translation>Croissance du saut</translation></message>
<message><source>% of range</source><translation>% dist.</translation></message>
<message><source>What the smallest step grows by with the distance.</source><translation>De combien la plus petite marche croît avec la distance.</translation></message>
<message><source>Crease angle</source><translation>Angle de pli</translation></message>
<message><source>Smallest fold of the surface that is an edge.</source><translation>Plus petit pli de la surface qui est une arête.</translation></message>
<message><source>Minimum length</source><translation>Longueur minimale</translation></message>
<message><source>Shorter chains of edge cells are dropped. At a void each class is chained by itself: a rim in two classes is two chains.</source><translation>Les chaînes plus courtes de cellules d'arête sont écartées. Au bord d'un vide, chaque classe forme ses propres chaînes : un bord en deux classes est deux chaînes.</translation></message>
<message><source>Which edges count: jumps in depth, convex folds (ridges), concave folds (contacts between rocks), the near side of a void with something farther behind it, and the rim of an open void; and where the data end, which is not an edge.</source><translation>Quelles arêtes comptent : sauts de profondeur, plis convexes (crêtes), plis concaves (contacts entre blocs), le côté proche d'un vide derrière lequel il y a quelque chose de plus loin, et le bord d'un vide ouvert ; et, ce qui n'est pas une arête, là où finissent les données.</translation></message>
<message><source>Hysteresis low</source><translation>Hystérésis, seuil bas</translation></message>
<message><source>% of high</source><translation>% du haut</translation></message>
<message><source>Weaker cells of this strength are edges where they continue a strong one.</source><translation>Les cellules plus faibles, de cette force, sont des arêtes là où elles en prolongent une forte.</translation></message>
<message><source>Grazing tolerance</source><translation>Tolérance rasante</translation></message>
<message><source>steps</source><translation>pas</translation></message>
<message><source>How far out of place a beam may be before a grazing surface shows a jump: 0.1 for a motor sweep, 1 for interlaced beams.</source><translation>De combien un faisceau peut être mal placé avant qu'une surface rasante montre un saut : 0.1 pour un balayage motorisé, 1 pour des faisceaux entrelacés.</translation></message>
<message><source>Allow for slips</source><translation>Tenir compte des glissements</translation></message>
<message><source>Beams interlaced from two passes and lines at which the stepper slipped are recognised and taken into account.</source><translation>Les faisceaux entrelacés de deux passages et les lignes où le moteur pas à pas a glissé sont reconnus et pris en compte.</translation></message>
<message><source>Allow for turns</source><translation>Tenir compte des retours</translation></message>
<message><source>At the first and last lines of a sweep a stepper may still swing back, so that every surface seems to fold there; such folds are left out.</source><translation>Aux premières et dernières lignes d'un balayage, un moteur peut encore revenir en arrière, et toute surface y semble plissée ; ces plis sont écartés.</translation></message>
<message><source>Range noise at 5 m</source><translation>Bruit de distance à 5 m</translation></message>
<message><source>Sigma of the ranges at 5 m; auto measures it in the scan.</source><translation>Sigma des distances à 5 m ; auto le mesure dans le scan.</translation></message>
<message><source>Noise from cell to cell</source><translation>Bruit de cellule à cellule</translation></message>
<message><source>Whether each cell errs for itself, as with a laser, or neighbours err alike, as with a depth camera whose depth comes in steps: folds then have to exceed what such steps look like.</source><translation>Si chaque cellule se trompe pour elle-même, comme avec un laser, ou si les voisines se trompent ensemble, comme avec une caméra de profondeur dont la profondeur vient par paliers : les plis doivent alors dépasser ce à quoi ressemblent ces paliers.</translation></message>
<message><source>Rules</source><translation>Règles</translation></message>
<message><source>How noise is measured and where the rim of a void ends: as today, or as in default set 4, which also has a rule for rough scans.</source><translation>Comment le bruit est mesuré et où finit le bord d'un vide : comme aujourd'hui, ou comme dans le jeu par défaut 4, qui a aussi une règle pour les scans rugueux.</translation></message>
<message><source>Rough scans</source><translation>Scans rugueux</translation></message>
<message><source>Only by the rules of default set 4. Where half of the folds are on surfaces that fold everywhere, such as heaps of small boulders, a fold counts only if it exceeds its surroundings.</source><translation>Seulement selon les règles du jeu par défaut 4. Où la moitié des plis sont sur des surfaces plissées partout, comme des tas de petits blocs, un pli ne compte que s'il dépasse son entourage.</translation></message>
<message><source>Fill gaps</source><translation>Combler les vides</translation></message>
<message><source>Gaps up to this width are filled from their surroundings, never across a jump. Filled cells are marked and never count as measured. 0 switches filling off.</source><translation>Les vides jusqu'à cette largeur sont comblés d'après ce qui les entoure, jamais par-dessus un saut ; les cellules remplies sont marquées, et ne servent à aucune mesure. 0 n'en comble aucun.</translation></message>
<message><source>Edges in gaps</source><translation>Arêtes dans les vides</translation></message>
<message><source>Filled cells take part in finding edges, and may be edges that no beam measured.</source><translation>Les cellules comblées participent à la recherche des arêtes, et peuvent être des arêtes que personne n'a mesurées.</translation></message>
<message><source>Lower threshold</source><translation>Seuil bas</translation></message>
<message><source>levels</source><translation>niveaux</translation></message>
<message><source>A cell with a gradient above this is an edge: with Canny if a chain of such cells leads to a strong one, with detectors of one threshold always.</source><translation>Une cellule dont le gradient est supérieur à ceci est une arête : avec Canny si une chaîne de telles cellules mène à une cellule forte, avec les détecteurs à un seuil toujours.</translation></message>
<message><source>Step</source><translation>Marche</translation></message>
<message><source>A straight step of this share of the range is a weak edge, one of about ratio times that a strong one.</source><translation>Une marche droite de cette part de la distance est une arête faible, une d'environ le rapport multiplié par cela en est une forte.</translation></message>
<message><source>Ratio upper : lower</source><translation>Rapport haut : bas</translation></message>
<message><source>Upper threshold as a multiple of the lower one; the thesis keeps 3.</source><translation>Seuil haut comme multiple du seuil bas ; la thèse garde 3.</translation></message>
<message><source>Gaussian kernel</source><translation>Noyau gaussien</translation></message>
<message><source>Size of the smoothing kernel; 1 switches smoothing off.</source><translation>Taille du noyau de lissage ; 1 désactive le lissage.</translation></message>
<message><source>Gaussian sigma</source><translation>Sigma gaussien</translation></message>
<message><source>Width of the smoothing; auto takes it from the kernel size.</source><translation>Largeur du lissage ; auto la déduit de la taille du noyau.</translation></message>
<message><source>Gray scaling</source><translation>Échelle de gris</translation></message>
<message><source>How ranges become gray levels: as the thesis prints it, evenly from near to far, or by equal ratios from near to far.</source><translation>Comment les distances deviennent des niveaux de gris : comme la thèse l'imprime, régulièrement du proche au lointain, ou par rapports égaux du proche au lointain.</translation></message>
<message><source>Near</source><translation>Proche</translation></message>
<message><source>Range drawn as gray 0; auto takes it from the scan. Not used by thesis scaling.</source><translation>Distance dessinée en gris 0 ; auto la prend du scan. Non utilisé par l'échelle de la thèse.</translation></message>
<message><source>Far</source><translation>Lointain</translation></message>
<message><source>Range drawn as gray 255; auto takes it from the scan. Not used by thesis scaling.</source><translation>Distance dessinée en gris 255 ; auto la prend du scan. Non utilisé par l'échelle de la thèse.</translation></message>
<message><source>Mask missing data</source><translation>Masquer les données manquantes</translation></message>
<message><source>Keeps cells without a range out of smoothing and gradient, so that the border of a hole is not an edge.</source><translation>Tient les cellules sans distance hors du lissage et du gradient, pour que le bord d'un trou ne soit pas une arête.</translation></message>
<message><source>Mask isolated cells</source><translation>Masquer les cellules isolées</translation></message>
<message><source>With missing data masked: a cell that fewer than 2 of its 8 neighbours agree with (dust) counts as missing.</source><translation>Avec les données manquantes masquées : une cellule avec laquelle moins de 2 de ses 8 voisines concordent (poussière) compte comme manquante.</translation></message>
<message><source>Sobel aperture</source><translation>Ouverture de Sobel</translation></message>
<message><source>Size of the gradient operator; larger ones need thresholds many times higher.</source><translation>Taille de l'opérateur de gradient ; les plus grands demandent des seuils bien plus élevés.</translation></message>
<message><source>Gradient norm</source><translation>Norme du gradient</translation></message>
<message><source>How the two gradient components become one magnitude.</source><translation>Comment les deux composantes du gradient deviennent une grandeur.</translation></message>
<message><source>Laplacian mask</source><translation>Masque du laplacien</translation></message>
<message><source>Which mask approximates the Laplacian of Gaussian.</source><translation>Quel masque représente le laplacien de gaussienne.</translation></message>
<message><source>All edges</source><translation>Toutes</translation></message>
<message><source>Rock borders</source><translation>De roches</translation></message>
<message><source>Even</source><translation>Régulière</translation></message>
<message><source>Logarithmic</source><translation>Logarithmique</translation></message>
<message><source>1 (off)</source><translation>1 (désactivé)</translation></message>
<message><source>L1  |gx| + |gy|</source><translation>L1  |gx| + |gy|</translation></message>
<message><source>L2  sqrt(gx² + gy²)</source><translation>L2 √(gx² + gy²)</translation></message>
<message><source>4 neighbours</source><translation>4 voisines</translation></message>
<message><source>8 neighbours</source><translation>8 voisines</translation></message>
<message><source>of default set 4</source><translation>du jeu 4</translation></message>
<message><source>of today</source><translation>d'aujourd'hui</translation></message>
<message><source>as measured</source><translation>tel que mesuré</translation></message>
<message><source>laser</source><translation>laser</translation></message>
<message><source>depth camera</source><translation>caméra 3D</translation></message>
<message><source>EdgeScan+</source><translation>EdgeScan+</translation></message>
<message><source>Rock outlines</source><translation>Contours blocs</translation></message>
<message><source>Jumps</source><translation>Sauts</translation></message>
<message><source>Canny (thesis)</source><translation>Canny (thèse)</translation></message>
<message><source>Canny on log range</source><translation>Canny, log</translation></message>
<message><source>Roberts</source><translation>Roberts</translation></message>
<message><source>Sobel</source><translation>Sobel</translation></message>
<message><source>Prewitt</source><translation>Prewitt</translation></message>
<message><source>Kirsch</source><translation>Kirsch</translation></message>
<message><source>Robinson</source><translation>Robinson</translation></message>
<message><source>Marr-Hildreth</source><translation>Marr-Hildreth</translation></message>
<message><source>Laplacian (LoG)</source><translation>Laplacien (LoG)</translation></message>
<message><source>EdgeScan+: jumps in depth and folds of the surface, with thresholds that follow the noise of the scan.</source><translation>EdgeScan+ : sauts en profondeur et plis de la surface, avec des seuils qui suivent le bruit du scan.</translation></message>
<message><source>Canny on logarithmic gray levels, so that a step counts in percent of its range; missing data masked, so that a hole has no edge.</source><translation>Canny sur des niveaux de gris logarithmiques : une marche compte en pour cent de sa distance ; les données manquantes sont masquées, un trou n'a donc pas d'arête.</translation></message>
<message><source>The thesis to the letter: 255 / (Smax - Smin), 3x3 Gaussian, 1:3, holes are black.</source><translation>La thèse à la lettre : 255 / (Smax - Smin), gaussienne 3x3, 1:3, les trous sont noirs.</translation></message>
<message><source>As the thesis, but the gray levels run from the nearest to the farthest range.</source><translation>Comme la thèse, mais les niveaux de gris vont de la distance la plus proche à la plus lointaine.</translation></message>
<message><source>As default, for flat and quiet surfaces: low steps are edges far away too.</source><translation>Comme default, pour des surfaces planes et peu bruitées : les marches basses sont des arêtes même au loin.</translation></message>
<message><source>The default settings of version 4: the noise includes relief, rims end where a surface slants by 70 degrees, and on a scan of rough surfaces folds must exceed their surroundings.</source><translation>Les réglages par défaut de la version 4 : le bruit comprend le relief, les bords de vides finissent où une surface est inclinée de 70 degrés, et sur un scan rugueux les plis doivent dépasser leur entourage.</translation></message>
<message><source>The default settings of version 3: no rims of open voids, chains of five cells and more, rough scans and turns of the stepper as any other.</source><translation>Les réglages par défaut de la version 3 : sans bords de vides ouverts, chaînes de cinq cellules et plus, sans égard aux scans rugueux ni aux retours du moteur.</translation></message>
<message><source>Fine to coarse</source><translation>Fin à grossier</translation></message>
<message><source>How easily pieces are joined into one rock. Lower: more and smaller rocks. Higher: fewer and larger rocks.</source><translation>Avec quelle facilité les morceaux sont joints en un bloc. Plus bas : des blocs plus nombreux et plus petits. Plus haut : des blocs moins nombreux et plus grands.</translation></message>
<message><source>Smallest rock</source><translation>Plus petit bloc</translation></message>
<message><source>Pieces with fewer measured cells are fines, not rocks.</source><translation>Les morceaux de moins de cellules mesurées sont des fines et non des blocs.</translation></message>
<message><source>Farthest rock</source><translation>Bloc le plus éloigné</translation></message>
<message><source>A region farther away is not a rock.</source><translation>Ce qui est plus loin n'est pas un bloc.</translation></message>
<message><source>Rarely longer than</source><translation>Rarement plus long que</translation></message>
<message><source>Longer pieces need better evidence that they are rocks and not walls. The length is about the visible length a.</source><translation>Les morceaux plus longs demandent de meilleurs signes d'être un bloc et non une paroi. La longueur est à peu près la longueur visible a.</translation></message>
<message><source>Oversize</source><translation>Hors gabarit</translation></message>
<message><source>The share of rocks whose visible width is larger is reported; 0 reports none.</source><translation>La part des blocs dont la largeur visible est plus grande est indiquée ; 0 n'en indique aucune.</translation></message>
<message><source>Easting E [m]</source><translation>Est E [m]</translation></message>
<message><source>Northing N [m]</source><translation>Nord N [m]</translation></message>
<message><source>Datum</source><translation>Datum</translation></message>
<message><source>XYZ and CSV with all columns, and the grid and the record in comment lines: GIS and spreadsheet programs may refuse them</source><translation>XYZ et CSV avec toutes les colonnes, et la grille et le compte rendu en lignes de commentaire : SIG et tableurs peuvent les refuser</translation></message>
<message><source>PCD in mine coordinates with numbers of 8 bytes, which PCL and Open3D do not read; else metres from an origin in a comment</source><translation>PCD en coordonnées de la mine avec des nombres de 8 octets, que PCL et Open3D ne lisent pas ; sinon en mètres depuis une origine dans un commentaire</translation></message>
<message><source>DXF of release 2000 instead of release 12</source><translation>DXF de version 2000 au lieu de version 12</translation></message>
<message><source>DXF: also the edge lines of two points only</source><translation>DXF : aussi les lignes d'arête de deux points seulement</translation></message>
<message><source>PCD, PLY and CSV: also the cells that were filled and not measured, which the field filled_sd_mm marks</source><translation>PCD, PLY et CSV : aussi les cellules comblées et non mesurées, que le champ filled_sd_mm marque</translation></message>
<message><source>PCD, PLY and CSV: the field confidence, how many percent of nearby settings find the edge too; 0 where there is none</source><translation>PCD, PLY et CSV : le champ confidence, le pourcentage de réglages voisins qui trouvent aussi l'arête ; 0 où il n'y en a pas</translation></message>
<message><source>PCD, PLY and CSV: the field border, how likely each edge is the border of a rock, in percent; NaN where unknown and where no edge is</source><translation>PCD, PLY et CSV : le champ border, la probabilité que chaque arête soit le contour d'une roche, en pour cent ; NaN où elle est inconnue et où il n'y a pas d'arête</translation></message>
<message><source>&amp;Edge Cloud…</source><translation>Nuage des &amp;arêtes…</translation></message>
<message><source>Edge points (%1)</source><translation>Points d'arête (%1)</translation></message>
<message><source>&amp;Full Cloud…</source><translation>Nuage &amp;complet…</translation></message>
<message><source>All points, with a field for edges (%1)</source><translation>Tous les points, avec un champ pour les arêtes (%1)</translation></message>
<message><source>Edge &amp;Image…</source><translation>&amp;Image des arêtes…</translation></message>
<message><source>Edge map as a picture, %1</source><translation>Carte des arêtes en image, %1</translation></message>
<message><source>&amp;Gray Image…</source><translation>Image en niveaux de &amp;gris…</translation></message>
<message><source>Gray image, %1</source><translation>Image en niveaux de gris, %1</translation></message>
<message><source>&amp;Range Image…</source><translation>Image de &amp;distances…</translation></message>
<message><source>Ranges in millimetres as a picture of 16 bits, %1</source><translation>Distances en millimètres en image de 16 bits, %1</translation></message>
<message><source>&amp;Targets…</source><translation>&amp;Cibles…</translation></message>
<message><source>Targets (%1)</source><translation>Cibles (%1)</translation></message>
<message><source>Report with settings and edits</source><translation>Rapport avec réglages et modifications</translation></message>
<message><source>Table, one row per rock</source><translation>Tableau, une ligne par bloc</translation></message>
<message><source>Labels as a 16-bit picture</source><translation>Étiquettes en image de 16 bits</translation></message>
<message><source>Outlines in space</source><translation>Contours dans l'espace</translation></message>
<message><source>Outlines in the mine grid</source><translation>Contours en coordonnées de la mine</translation></message>
<message><source>Convex hulls of the visible points</source><translation>Enveloppes convexes des points visibles</translation></message>
<message><source>Rock</source><translation>Bloc</translation></message>
<message><source>The number: without edits, 1 is the largest visible area</source><translation>Le numéro : sans modifications, 1 est la plus grande surface visible</translation></message>
<message><source>visible length a [m]</source><translation>longueur visible a [m]</translation></message>
<message><source>Largest visible span across the line of sight; hidden parts are not counted</source><translation>Plus grande étendue visible en travers de la ligne de visée ; les parties cachées ne comptent pas</translation></message>
<message><source>size: visible width b [m]</source><translation>taille : largeur visible b [m]</translation></message>
<message><source>Size of the rock: smallest visible span across the line of sight; hidden parts are not counted</source><translation>Taille du bloc : plus petite étendue visible en travers de la ligne de visée ; les parties cachées ne comptent pas</translation></message>
<message><source>± of a and b [m]</source><translation>± de a et b [m]</translation></message>
<message><source>Of a and b: spacing of the points and width of the beam, twice</source><translation>De a et b : espacement des points et largeur du faisceau, deux fois</translation></message>
<message><source>distance [m]</source><translation>distance [m]</translation></message>
<message><source>From the scanner: median of its ranges</source><translation>Depuis le scanner : médiane de ses distances</translation></message>
<message><source>area [m²]</source><translation>surface [m²]</translation></message>
<message><source>Visible area across the beams</source><translation>Surface visible en travers des faisceaux</translation></message>
<message><source>in front [%]</source><translation>devant [%]</translation></message>
<message><source>Share of its outline where it is the nearer side</source><translation>Part de son contour où il est le côté le plus proche</translation></message>
<message><source>contacts (≥)</source><translation>contacts (≥)</translation></message>
<message><source>Rocks that it is seen to touch: at least these</source><translation>Blocs qu'on le voit toucher : au moins ceux-ci</translation></message>
<message><source>free below [m]</source><translation>libre dessous [m]</translation></message>
<message><source>Free height under its lowest visible point: at least this; what sent nothing back is never free; without a pose, up is the scanner's z axis</source><translation>Hauteur libre sous son point visible le plus bas : au moins celle-ci ; ce qui n'a rien renvoyé n'est jamais libre ; sans pose, le haut est l'axe z du scanner</translation></message>
<message><source>arch [°] ± 25</source><translation>voûte [°] ± 25</translation></message>
<message><source>Largest angle at it between two rocks that it touches; ↓: it hangs below the line between them; without a pose, up is the scanner's z axis</source><translation>Plus grand angle, en ce bloc, entre deux blocs qu'il touche ; ↓ : il pend sous la ligne qui les relie ; sans pose, le haut est l'axe z du scanner</translation></message>
<message><source>Chance that its outline is right; ▲ and hatched: below 0.85</source><translation>Chance que son contour soit juste ; ▲ et hachuré : moins de 0.85</translation></message>
<message><source>candidate - geometry only, one viewpoint</source><translation>candidat - géométrie seule, un seul point de vue</translation></message>
<message><source>Unit</source><translation>Unité</translation></message>
<message><source>Line angles</source><translation>Angles des lignes</translation></message>
<message><source>Order of the lines</source><translation>Ordre des lignes</translation></message>
<message><source>straightened</source><translation>redressés</translation></message>
<message><source>where their angles say</source><translation>là où le disent leurs angles</translation></message>
<message><source>as they were recorded</source><translation>tels qu'ils ont été enregistrés</translation></message>
<message><source>straightened by the scan's own surfaces</source><translation>redressés d'après les surfaces mêmes du scan</translation></message>
<message><source>millimetres, so that half of the ranges are below %1 m</source><translation>millimètres, de sorte que la moitié des distances est inférieure à %1 m</translation></message>
<message><source>millimetres: half of the ranges are below %1 m</source><translation>millimètres : la moitié des distances est inférieure à %1 m</translation></message>
<message><source>centimetres, so that half of the ranges are below %1 m</source><translation>centimètres, de sorte que la moitié des distances est inférieure à %1 m</translation></message>
<message><source>centimetres: half of the ranges are below %1 m</source><translation>centimètres : la moitié des distances est inférieure à %1 m</translation></message>
<message><source>metres, so that half of the ranges are below %1 m</source><translation>mètres, de sorte que la moitié des distances est inférieure à %1 m</translation></message>
<message><source>metres: half of the ranges are below %1 m</source><translation>mètres : la moitié des distances est inférieure à %1 m</translation></message>
<message><source>%2 mm, so that half of the ranges are below %1 m</source><translation>%2 mm, de sorte que la moitié des distances est inférieure à %1 m</translation></message>
<message><source>In the unit that was taken half of the ranges are below %1 m, which is unusual for a scan of rocks.</source><translation>Dans l'unité retenue, la moitié des distances est inférieure à %1 m, ce qui est inhabituel pour un scan de roches.</translation></message>
<message><source>spin: the stepper turns about the viewing direction; %1 of %2 flat pieces lie on three planes</source><translation>spin : le moteur pas à pas tourne autour de la direction de visée ; %1 morceaux plats sur %2 sont sur trois plans</translation></message>
<message><source>spin, about the viewing direction: %1 of %2 flat pieces lie on three planes</source><translation>spin, autour de la direction de visée : %1 morceaux plats sur %2 sont sur trois plans</translation></message>
<message><source>Walls bend with mounting spin: %1 of %2 flat pieces lie on three planes, with sweep %3 do.</source><translation>Les parois se courbent avec le montage spin : %1 morceaux plats sur %2 sont sur trois plans, contre %3 avec sweep.</translation></message>
<message><source>The ranges do not fit mounting spin: from line to line they stay the same at beams 0 and 180 degrees, as with sweep.</source><translation>Les distances ne vont pas avec le montage spin : d'une ligne à l'autre, elles restent les mêmes aux faisceaux 0 et 180 degrés, comme avec sweep.</translation></message>
<message><source>sweep: the stepper turns about the 0/180 degree line; %1 of %2 flat pieces lie on three planes</source><translation>sweep : le moteur pas à pas tourne autour de la ligne 0/180 degrés ; %1 morceaux plats sur %2 sont sur trois plans</translation></message>
<message><source>sweep, about the 0/180 degree line: %1 of %2 flat pieces lie on three planes</source><translation>sweep, autour de la ligne 0/180 degrés : %1 morceaux plats sur %2 sont sur trois plans</translation></message>
<message><source>Walls bend with mounting sweep: %1 of %2 flat pieces lie on three planes, with spin %3 do.</source><translation>Les parois se courbent avec le montage sweep : %1 morceaux plats sur %2 sont sur trois plans, contre %3 avec spin.</translation></message>
<message><source>The ranges do not fit mounting sweep: from line to line they stay the same at beam 90 degrees, as with spin.</source><translation>Les distances ne vont pas avec le montage sweep : d'une ligne à l'autre, elles restent les mêmes au faisceau 90 degrés, comme avec spin.</translation></message>
<message><source>a step of %3 degrees, %4 in all: %1 of %2 flat pieces lie on three planes</source><translation>un pas de %3 degrés, %4 en tout : %1 morceaux plats sur %2 sont sur trois plans</translation></message>
<message><source>Walls bend at the line angles that were taken: %1 of %2 flat pieces lie on three planes, other steps give more.</source><translation>Les parois se courbent avec les angles de ligne retenus : %1 morceaux plats sur %2 sont sur trois plans, d'autres pas en donnent plus.</translation></message>
<message><source>a step of %3 degrees, %4 in all; %1 of %2 flat pieces lie on three planes</source><translation>un pas de %3 degrés, %4 en tout ; %1 morceaux plats sur %2 sont sur trois plans</translation></message>
<message><source>a step of %3 degrees, %4 in all; rough rock cannot show it: choose how far the motor turned in all</source><translation>un pas de %3 degrés, %4 en tout ; une roche rugueuse ne peut pas le montrer : choisissez de combien le moteur a tourné en tout</translation></message>
<message><source>line angles from %1 to %2 degrees; ranges cannot show whether left and right are exchanged</source><translation>angles des lignes de %1 à %2 degrés ; aucune distance ne dit si la gauche et la droite sont échangées</translation></message>
<message><source>the other way round: left and right exchanged</source><translation>dans l'autre sens : gauche et droite échangées</translation></message>
<message><source>%1 lines of %2 beams, found from the directions of the points</source><translation>%1 lignes de %2 faisceaux, trouvées d'après les directions des points</translation></message>
<message><source>projected onto cells of %1 degrees; %2 % of the points are behind others of their cell</source><translation>projeté sur des cellules de %1 degrés ; %2 % des points sont derrière d'autres de leur cellule</translation></message>
<message><source>%1 % of the points are behind others of their cell: the cells are coarse, or the sensor was at another place.</source><translation>%1 % des points sont derrière d'autres de leur cellule : les cellules sont grossières, ou le capteur se trouvait ailleurs.</translation></message>
<message><source>cells of %1 degrees</source><translation>cellules de %1 degrés</translation></message>
<message><source>Topic</source><translation>Topic</translation></message>
<message><source>Sweep</source><translation>Balayage</translation></message>
<message><source>%1: lines of %2 beams; messages: %3, per second: %4</source><translation>%1 : lignes de %2 faisceaux ; messages : %3, par seconde : %4</translation></message>
<message><source>%1: clouds of %2 points; messages: %3, per second: %4</source><translation>%1 : nuages de %2 points ; messages : %3, par seconde : %4</translation></message>
<message><source>from %1</source><translation>d'après %1</translation></message>
<message><source>sweep %1 of the topic, counted from 0; the topic holds %2</source><translation>balayage %1 du topic, compté à partir de 0 ; le topic en contient %2</translation></message>
<message><source>sweep %1, counted from 0</source><translation>balayage %1, compté à partir de 0</translation></message>
<message><source>Beams and lines</source><translation>Faisceaux et lignes</translation></message>
<message><source>the threshold %1</source><translation>le seuil %1</translation></message>
<message><source>the lower threshold %1</source><translation>le seuil bas %1</translation></message>
<message><source>the upper threshold %1</source><translation>le seuil haut %1</translation></message>
<message><source>it is an edge, but only %1 % likely the border of a rock, and only those from %2 % on are shown (%3)</source><translation>c'est une arête, mais le contour d'une roche à %1 % seulement, et seuls ceux à partir de %2 % sont affichés (%3)</translation></message>
<message><source>%1 the fold at %2 next to it is stronger (%3 against %4), and an edge is one cell wide</source><translation>%1 le pli en %2, à côté, est plus fort (%3 contre %4), et une arête est large d'une cellule</translation></message>
<message><source>%1 the fold at %2 next to it is as strong (%3 against %4), and an edge is one cell wide</source><translation>%1 le pli en %2, à côté, est aussi fort (%3 contre %4), et une arête est large d'une cellule</translation></message>
<message><source>%1 next to it is stronger (%2), and an edge is one cell wide</source><translation>%1 à côté est plus forte (%2), et une arête est large d'une cellule</translation></message>
<message><source>%1 next to it is as strong (%2), and an edge is one cell wide</source><translation>%1 à côté est aussi forte (%2), et une arête est large d'une cellule</translation></message>
<message><source>the step of %1 m belongs to %2, which is the nearer cell</source><translation>la marche de %1 m appartient à %2, qui est la cellule la plus proche</translation></message>
<message><source>%1 is below %2</source><translation>%1 est au-dessous de %2</translation></message>
<message><source>%1 does not exceed %2</source><translation>%1 ne dépasse pas %2</translation></message>
<message><source>%1, and %2 next to it is stronger</source><translation>%1, et %2 à côté est plus forte</translation></message>
<message><source>%1 is above %2, but no chain of such cells leads to one above %3</source><translation>%1 est au-dessus de %2, mais aucune chaîne de telles cellules ne mène à une cellule au-dessus de %3</translation></message>
<message><source>its chain has 1 cell, fewer than the minimum length %1</source><translation>sa chaîne a 1 cellule, moins que la longueur minimale %1</translation></message>
<message><source>its chain has %1 cells, fewer than the minimum length %2</source><translation>sa chaîne a %1 cellules, moins que la longueur minimale %2</translation></message>
<message><source>%1 is enough where it continues its chain</source><translation>%1 suffit là où elle prolonge sa chaîne</translation></message>
<message><source>%1 is above %2, and 1 cell on, at %3, its chain reaches %4</source><translation>%1 est au-dessus de %2, et 1 cellule plus loin, à %3, sa chaîne atteint %4</translation></message>
<message><source>%1 is above %2, and %3 cells on, at %4, its chain reaches %5</source><translation>%1 est au-dessus de %2, et %3 cellules plus loin, à %4, sa chaîne atteint %5</translation></message>
<message><source>it is a single cell and takes no part</source><translation>c'est une cellule isolée, qui ne compte pas</translation></message>
<message><source>it has no range</source><translation>elle n'a pas de distance</translation></message>
<message><source>the strength %1 of its %2</source><translation>la force %1 de son type « %2 »</translation></message>
<message><source>its strength %1</source><translation>sa force %1</translation></message>
<message><source>%1 is above %2</source><translation>%1 est au-dessus de %2</translation></message>
<message><source>it is next to missing data, and such borders are a class that was chosen</source><translation>elle est à côté de données manquantes, et de tels bords sont une classe choisie</translation></message>
<message><source>the surface ends here before missing data, and what is behind them is farther away</source><translation>la surface finit ici devant des données manquantes, et ce qui est derrière elles est plus loin</translation></message>
<message><source>the surface ends here at an open void, from which nothing came back</source><translation>la surface finit ici au bord d'un vide ouvert, d'où rien n'est revenu</translation></message>
<message><source> (raised: beams are interlaced)</source><translation> (augmentée : les faisceaux sont entrelacés)</translation></message>
<message><source>relief %1</source><translation>relief %1</translation></message>
<message><source>Step in depth: %1 m to %2 (%3; this cell is the nearer one), limit %4: strength %5.</source><translation>Marche en profondeur : %1 m jusqu'à %2 (%3 ; cette cellule est la plus proche), limite %4 : force %5.</translation></message>
<message><source>Step in depth: %1 m to %2 (%3; that cell is the nearer one), limit %4: strength %5.</source><translation>Marche en profondeur : %1 m jusqu'à %2 (%3 ; l'autre cellule est la plus proche), limite %4 : force %5.</translation></message>
<message><source>%1 degrees, which noise alone may look like (%2 %3)</source><translation>%1 degrés, ce à quoi le bruit seul peut ressembler (%2 %3)</translation></message>
<message><source>%1 degrees = %2</source><translation>%1 degrés = %2</translation></message>
<message><source>; %1 % of it counts, for the two sides do not meet at the cell</source><translation> ; il en compte %1 %, car les deux côtés ne se rejoignent pas à la cellule</translation></message>
<message><source>Fold: %1 degrees convex, outwards (%2), limit %3: strength %4.</source><translation>Pli : %1 degrés, convexe, vers l'extérieur (%2), limite %3 : force %4.</translation></message>
<message><source>Fold: %1 degrees concave, inwards (%2), limit %3: strength %4.</source><translation>Pli : %1 degrés, concave, vers l'intérieur (%2), limite %3 : force %4.</translation></message>
<message><source>Rough scan: %1 % of what is within 15 degrees folds, so a fold must be %2 times as strong here.</source><translation>Scan rugueux : %1 % de ce qui est à moins de 15 degrés est plissé ; un pli doit donc être %2 fois plus fort ici.</translation></message>
<message><source>Rough scan: %1 % of what is within 15 degrees folds; a fold counts as elsewhere.</source><translation>Scan rugueux : %1 % de ce qui est à moins de 15 degrés est plissé ; un pli compte comme ailleurs.</translation></message>
<message><source>No range of its own: the gap is filled from both sides, and edges go round it by the cells next to it.</source><translation>Pas de distance propre : le vide est comblé des deux côtés, et les arêtes le contournent par les cellules voisines.</translation></message>
<message><source>No range of its own: the gap was filled on request, and its cells take part like measured ones.</source><translation>Pas de distance propre : le vide a été comblé à votre demande, et ses cellules comptent comme des cellules mesurées.</translation></message>
<message><source>The edge of a cell without a range next to it goes round by this one.</source><translation>L'arête d'une cellule voisine sans distance passe par celle-ci.</translation></message>
<message><source>Nothing is known here: no step and no fold is measured next to missing data.</source><translation>Rien n'est connu ici : ni marche ni pli ne se mesurent à côté de données manquantes.</translation></message>
<message><source>Mixed pixel: its range is between two surfaces. For edges it counts as %1 m, the one nearer to its range.</source><translation>Pixel mixte : sa distance est entre deux surfaces. Pour les arêtes elle compte pour %1 m, la plus proche de sa distance.</translation></message>
<message><source>Together with the other way %1.</source><translation>Avec l'autre direction : %1.</translation></message>
<message><source>Range noise used: sigma %1 m here, %2 m at 5 m.</source><translation>Bruit de distance retenu : sigma %1 m ici, %2 m à 5 m.</translation></message>
<message><source>Neighbours err alike, so for folds it counts as %1 m here.</source><translation>Les voisins se trompent ensemble ; pour les plis, il compte donc pour %1 m ici.</translation></message>
<message><source>Noisy ranges are smoothed, so for folds it counts as %1 m here.</source><translation>Les distances bruitées sont lissées ; pour les plis, il compte donc pour %1 m ici.</translation></message>
<message><source>%1: strength %2 as %3</source><translation>%1 : force %2, type « %3 »</translation></message>
<message><source>%1: strength %2</source><translation>%1 : force %2</translation></message>
<message><source> (along the line %1, across the lines %2, direction %3 degrees)</source><translation> (le long de la ligne %1, en travers des lignes %2, direction %3 degrés)</translation></message>
<message><source> (direction %1 degrees)</source><translation> (direction %1 degrés)</translation></message>
<message><source>; %1 %2, %3 %4 % of it: weak from %5, strong from %6</source><translation> ; %1 %2, %3 %4 % de celle-ci : faible à partir de %5, forte à partir de %6</translation></message>
<message><source>, threshold %1</source><translation>, seuil %1</translation></message>
<message><source>, thresholds %1 and %2</source><translation>, seuils %1 et %2</translation></message>
<message><source>Chain: 1 cell, strongest at %1 (%2).</source><translation>Chaîne : 1 cellule, la plus forte à %1 (%2).</translation></message>
<message><source>Chain: %1 cells, strongest at %2 (%3).</source><translation>Chaîne : %1 cellules, la plus forte à %2 (%3).</translation></message>
<message><source>It is unknown if it is the border of a rock: the grid ends nearby, ranges are missing, or neighbours err alike.</source><translation>On ne sait pas si c'est le contour d'une roche : la grille finit à côté, des distances manquent, ou les voisins se trompent ensemble.</translation></message>
<message><source>It is %1 % likely the border of a rock, and not a fold within one.</source><translation>C'est à %1 % le contour d'une roche, et non un pli dans une roche.</translation></message>
<message><source>%1 (for it)</source><translation>%1 (pour)</translation></message>
<message><source>%1 (against it)</source><translation>%1 (contre)</translation></message>
<message><source>What decided that: %1.</source><translation>Ce qui en décide : %1.</translation></message>
<message><source>Left out: %1.</source><translation>Omise : %1.</translation></message>
<message><source>Edge: %1; no value of %2 makes it one.</source><translation>Arête : %1 ; aucune valeur de « %2 » n'en fait une.</translation></message>
<message><source>No edge: %1; no value of %2 makes it one.</source><translation>Pas d'arête : %1 ; aucune valeur de « %2 » n'en fait une.</translation></message>
<message><source>Edge: %1; as part of its chain it remains an edge at each %2, up to the largest: %3.</source><translation>Arête : %1 ; comme partie de sa chaîne elle reste une arête pour chaque %2, jusqu'à la plus grande valeur : %3.</translation></message>
<message><source>Edge: %1; this remains an edge at each %2, up to the largest: %3.</source><translation>Arête : %1 ; elle reste une arête pour chaque %2, jusqu'à la plus grande valeur : %3.</translation></message>
<message><source>Edge: %1; as part of its chain it disappears only if you set %2 above %3.</source><translation>Arête : %1 ; comme partie de sa chaîne, elle ne disparaît que si vous mettez %2 au-dessus de %3.</translation></message>
<message><source>Edge: %1; it disappears if you set %2 above %3, because its chain is then shorter than the minimum length %4.</source><translation>Arête : %1 ; elle disparaît si vous mettez %2 au-dessus de %3, car sa chaîne est alors plus courte que la longueur minimale %4.</translation></message>
<message><source>Edge: %1; it disappears if you set %2 above %3.</source><translation>Arête : %1 ; elle disparaît si vous mettez %2 au-dessus de %3.</translation></message>
<message><source>No edge: %1; this becomes an edge when %2 is %3 or less.</source><translation>Pas d'arête : %1 ; cela devient une arête quand %2 vaut %3 ou moins.</translation></message>
<message><source>%1: range %2 m</source><translation>%1 : distance %2 m</translation></message>
<message><source>, gray %1</source><translation>, gris %1</translation></message>
<message><source>, smoothed %1</source><translation>, lissé %1</translation></message>
<message><source>, class %1</source><translation>, type %1</translation></message>
<message><source>steps in depth around it</source><translation>les sauts de profondeur autour d'elle</translation></message>
<message><source>its own fold</source><translation>son propre pli</translation></message>
<message><source>the surface across the edge</source><translation>la surface en travers de l'arête</translation></message>
<message><source>the surface along the edge</source><translation>la surface le long de l'arête</translation></message>
<message><source>its height over the surroundings</source><translation>sa hauteur au-dessus de l'entourage</translation></message>
<message><source>folds around it</source><translation>les plis autour d'elle</translation></message>
<message><source>distance and noise</source><translation>la distance et le bruit</translation></message>
<message><source>end %1 not on an edge</source><translation>extrémité %1 hors d'une arête</translation></message>
<message><source>%1 ends not on an edge</source><translation>%1 extrémités hors d'une arête</translation></message>
<message><source>1 end was moved to the near side</source><translation>1 extrémité a été déplacée du côté proche</translation></message>
<message><source>%1 ends were moved to the near side</source><translation>%1 extrémités ont été déplacées du côté proche</translation></message>
<message><source>▲ a nearer surface is within %1 cells of a click</source><translation>▲ une surface plus proche est à moins de %1 cellules d’un clic</translation></message>
<message><source>▲ longer than the %1 m between the clicks: the sides of the throat are up to %2 m from them</source><translation>▲ plus long que les %1 m entre les clics : les côtés du goulot en sont jusqu'à %2 m</translation></message>
<message><source>▲ its ends are up to %1 m from the clicks: check that it is the opening that was meant</source><translation>▲ ses extrémités sont à %1 m des clics au plus : vérifiez que c'est bien l'ouverture voulue</translation></message>
<message><source>its ends are up to %1 m from the clicks</source><translation>ses extrémités sont à %1 m des clics au plus</translation></message>
<message><source>▲ a click went through this throat, %1 m behind it: the rim in front was taken</source><translation>▲ un clic est passé par cette gorge, %1 m derrière elle : le bord devant a été pris</translation></message>
<message><source>▲ no beam came back between its ends: this may be an opening, or dark or wet rock</source><translation>▲ aucun faisceau n'est revenu entre ses extrémités : ce peut être une ouverture, ou de la roche sombre ou mouillée</translation></message>
<message><source>▲ one end is %1 m farther away than the other</source><translation>▲ une extrémité est %1 m plus loin que l'autre</translation></message>
<message><source>across the middle of the opening</source><translation>par le milieu de l'ouverture</translation></message>
<message><source>across the opening between the clicks, turned by %1° from their line</source><translation>à travers l'ouverture entre les clics, tourné de %1° par rapport à leur ligne</translation></message>
<message><source>between the two sides that were clicked</source><translation>entre les deux côtés qui ont été cliqués</translation></message>
<message><source>▲ clicks %1 away find %2 to %3 m: zoom in and click again</source><translation>▲ des clics à %1 trouvent %2 à %3 m : zoomez et cliquez à nouveau</translation></message>
<message><source>clicks %1 away find %2 to %3 m</source><translation>des clics à %1 de là trouvent %2 à %3 m</translation></message>
<message><source>ranges %1 m</source><translation>distances %1 m</translation></message>
<message><source>slope %1° ± %2°, grade %3 %</source><translation>inclinaison %1° ± %2°, pente %3 %</translation></message>
<message><source>slope %1° ± %2°</source><translation>inclinaison %1° ± %2°</translation></message>
<message><source>a side is below what is resolved there</source><translation>un côté est plus petit que ce qui y est résolu</translation></message>
<message><source>jumps that are part of it: %1</source><translation>sauts compris : %1</translation></message>
<message><source>▲ an end is %1 m behind the surface next to it</source><translation>▲ une extrémité est %1 m derrière la surface voisine</translation></message>
<message><source>between its ends the surface is up to %1 m farther away</source><translation>entre ses extrémités la surface est jusqu'à %1 m plus loin</translation></message>
<message><source>between its ends the surface is up to %1 m nearer</source><translation>entre ses extrémités la surface est jusqu'à %1 m plus près</translation></message>
<message><source>no pose: up is the scanner's z</source><translation>pas de pose : le haut est l'axe z du scanner</translation></message>
<message><source>Vertical Difference</source><translation>Différence verticale</translation></message>
<message><source>Angle</source><translation>Angle</translation></message>
<message><source>Spans a × b</source><translation>Étendues a × b</translation></message>
<message><source>Along the Surface</source><translation>Le long de la surface</translation></message>
<message><source>Throat Width</source><translation>Largeur du goulot</translation></message>
<message><source>Length in a Section</source><translation>Longueur dans une coupe</translation></message>
</context>
<context>
<name>core</name>
<message><source>the JSON holds too many keys</source><translation>le JSON contient trop de clés</translation></message>
<message><source>the key "%1" appears twice in the same object of the JSON</source><translation>la clé « %1 » apparaît deux fois dans le même objet du JSON</translation></message>
<message><source>the JSON holds a number that no computer can store</source><translation>le JSON contient un nombre qu'aucun ordinateur ne peut stocker</translation></message>
<message><source>the JSON is damaged or cut off here</source><translation>le JSON est endommagé ou coupé ici</translation></message>
<message><source>correct the file or choose another</source><translation>corrigez le fichier ou choisissez-en un autre</translation></message>
<message><source>%1: byte %2</source><translation>%1 : octet %2</translation></message>
<message><source>check line %1, column %2; write 217.4 for 217,4</source><translation>vérifiez la ligne %1, colonne %2 ; écrivez 217.4 au lieu de 217,4</translation></message>
<message><source>check line %1, column %2</source><translation>vérifiez la ligne %1, colonne %2</translation></message>
<message><source>this JSON is nested too deep</source><translation>ce JSON est imbriqué trop profondément</translation></message>
<message><source>this JSON is too large: %1, and %2 are read</source><translation>ce JSON est trop grand : %1, et %2 sont lus</translation></message>
<message><source>choose another file</source><translation>choisissez un autre fichier</translation></message>
<message><source>the file is empty</source><translation>le fichier est vide</translation></message>
<message><source>copy it again or choose another</source><translation>copiez-le à nouveau ou choisissez-en un autre</translation></message>
<message><source>%n byte behind %1 was not read.</source><translation>%n octet derrière %1 n'a pas été lu.</translation></message>
<message><source>%n bytes behind %1 were not read.</source><translation>%n octets derrière %1 n'ont pas été lus.</translation></message>
<message><source>this is the address of a file on another computer, %1</source><translation>c'est l'adresse d'un fichier sur un autre ordinateur, %1</translation></message>
<message><source>copy the file to this one, or give its path in a folder that is shared</source><translation>copiez le fichier sur celui-ci, ou donnez son chemin dans un dossier partagé</translation></message>
<message><source>this is the address of a robot's bridge and not a file</source><translation>c'est l'adresse du pont d'un robot et non un fichier</translation></message>
<message><source>use it with record, or in the window with Connect to Scanner</source><translation>utilisez-la avec record, ou dans la fenêtre avec Connecter au scanner</translation></message>
<message><source>this address has a % without the two digits of a byte</source><translation>cette adresse a un % sans les deux chiffres d'un octet</translation></message>
<message><source>write % as %25, or give the path</source><translation>écrivez % sous la forme %25, ou donnez le chemin</translation></message>
<message><source>this address names no file</source><translation>cette adresse ne nomme aucun fichier</translation></message>
<message><source>give its path</source><translation>donnez son chemin</translation></message>
<message><source>this file was read as an input</source><translation>ce fichier a été lu comme entrée</translation></message>
<message><source>this is the file that was read as an input under the name %1</source><translation>c'est le fichier qui a été lu comme entrée sous le nom %1</translation></message>
<message><source>choose another name</source><translation>choisissez un autre nom</translation></message>
<message><source>nothing (null)</source><translation>rien (null)</translation></message>
<message><source>a list [...]</source><translation>une liste [...]</translation></message>
<message><source>an object {...}</source><translation>un objet {...}</translation></message>
<message><source>holds %1 where a number is needed</source><translation>contient %1 là où il faut un nombre</translation></message>
<message><source>holds a number out of all reason</source><translation>contient un nombre hors de toute raison</translation></message>
<message><source>%1 or more</source><translation>%1 ou plus</translation></message>
<message><source>%1 or less</source><translation>%1 ou moins</translation></message>
<message><source>from %1 to %2</source><translation>de %1 à %2</translation></message>
<message><source>is %1 and must be %2</source><translation>est %1 et doit être %2</translation></message>
<message><source>is missing</source><translation>manque</translation></message>
<message><source>must be a whole number from %1 to %2</source><translation>doit être un nombre entier de %1 à %2</translation></message>
<message><source>must be true or false</source><translation>doit être true ou false</translation></message>
<message><source>must be text</source><translation>doit être du texte</translation></message>
<message><source>must be %1</source><translation>doit être %1</translation></message>
<message><source>must be a list of numbers</source><translation>doit être une liste de nombres</translation></message>
<message><source>must hold %1 numbers</source><translation>doit contenir %1 nombres</translation></message>
<message><source>must hold three numbers</source><translation>doit contenir trois nombres</translation></message>
<message><source>must hold three rows of three numbers</source><translation>doit contenir trois lignes de trois nombres</translation></message>
<message><source>is not a rotation: its rows are not perpendicular and of length 1</source><translation>n'est pas une rotation : ses lignes ne sont pas perpendiculaires et de longueur 1</translation></message>
<message><source>mirrors instead of turning: its determinant is -1</source><translation>reflète au lieu de tourner : son déterminant est -1</translation></message>
<message><source>must be a time in UTC like "2026-11-20T10:15:30.250Z"</source><translation>doit être une heure UTC comme "2026-11-20T10:15:30.250Z"</translation></message>
<message><source>must be a list of texts</source><translation>doit être une liste de textes</translation></message>
<message><source>must be an object {...}</source><translation>doit être un objet {...}</translation></message>
<message><source>must be a list of objects {...}</source><translation>doit être une liste d'objets {...}</translation></message>
<message><source>is not a key here, but "%1" is: units belong to the name</source><translation>n'est pas une clé ici, mais « %1 » en est une : les unités font partie du nom</translation></message>
<message><source>is not a key here; known are %1</source><translation>n'est pas une clé ici ; sont connues %1</translation></message>
<message><source>"format": "%1"</source><translation>"format": "%1"</translation></message>
<message><source>the JSON holds no object</source><translation>le JSON ne contient pas d'objet</translation></message>
<message><source>choose a file with %1</source><translation>choisissez un fichier avec %1</translation></message>
<message><source>"format" is missing</source><translation>"format" manque</translation></message>
<message><source>"format" is "%1", not "%2"</source><translation>"format" est « %1 », pas « %2 »</translation></message>
<message><source>%n byte</source><translation>%n octet</translation></message>
<message><source>%n bytes</source><translation>%n octets</translation></message>
<message><source>needs %1 of memory, %2 are free</source><translation>demande %1 de mémoire, %2 sont libres</translation></message>
<message><source>close other programs or open a smaller file</source><translation>fermez d'autres programmes ou ouvrez un fichier plus petit</translation></message>
<message><source>this is not a file of the kind %1, so it was not replaced</source><translation>ce n'est pas un fichier du genre %1, il n'a donc pas été remplacé</translation></message>
<message><source>this is a file of the kind %1, so it was not replaced</source><translation>c'est un fichier du genre %1, il n'a donc pas été remplacé</translation></message>
<message><source>no scanner reaches farther than 1,000 km</source><translation>aucun scanner ne porte à plus de 1,000 km</translation></message>
<message><source>unit of counts and numbers</source><translation>unité des comptes et des nombres</translation></message>
<message><source>from a nanometre to a kilometre</source><translation>d'un nanomètre à un kilomètre</translation></message>
<message><source>angle of a beam, a heading or a mounting</source><translation>angle d'un faisceau, d'un cap ou d'un montage</translation></message>
<message><source>degrees</source><translation>degrés</translation></message>
<message><source>one turn</source><translation>un tour</translation></message>
<message><source>angle of a line</source><translation>angle d'une ligne</translation></message>
<message><source>a stepper that turns on for days</source><translation>un moteur pas à pas qui tourne des jours durant</translation></message>
<message><source>step from beam to beam or line to line</source><translation>pas de faisceau à faisceau ou de ligne à ligne</translation></message>
<message><source>not 0: two beams never look the same way</source><translation>pas 0 : deux faisceaux ne regardent jamais dans la même direction</translation></message>
<message><source>cell of a projected cloud</source><translation>cellule d'un nuage projeté</translation></message>
<message><source>finer than any scanner, coarser than any use</source><translation>plus fine que celle de tout scanner, plus grossière que pour tout usage</translation></message>
<message><source>tilt, pitch</source><translation>inclinaison, tangage</translation></message>
<message><source>beyond it, it is the other way round</source><translation>au-delà, c'est à l'envers</translation></message>
<message><source>roll, convergence</source><translation>roulis, convergence</translation></message>
<message><source>half a turn</source><translation>un demi-tour</translation></message>
<message><source>easting, northing, place of a sensor</source><translation>est, nord, place d'un capteur</translation></message>
<message><source>more than the way round the earth</source><translation>plus que le tour de la Terre</translation></message>
<message><source>deeper than any mine, higher than any mountain</source><translation>plus profond que toute mine, plus haut que toute montagne</translation></message>
<message><source>lever arm on a robot</source><translation>bras de levier sur un robot</translation></message>
<message><source>nothing on a robot is farther away</source><translation>rien sur un robot n'est plus loin</translation></message>
<message><source>coordinate, in the file's own unit</source><translation>coordonnée, dans l'unité propre du fichier</translation></message>
<message><source>the way round the earth in tenths of a millimetre</source><translation>le tour de la Terre en dixièmes de millimètre</translation></message>
<message><source>scale of a mine grid</source><translation>échelle d'une grille de mine</translation></message>
<message><source>map projections stay within a hundredth</source><translation>les projections cartographiques restent à un centième près</translation></message>
<message><source>lines, beams</source><translation>lignes, faisceaux</translation></message>
<message><source>more than a day of scanning</source><translation>plus d'une journée de scan</translation></message>
<message><source>this pipe cannot be read: </source><translation>ce tube ne peut pas être lu : </translation></message>
<message><source>save what it gives to a file and open that</source><translation>enregistrez ce qu'il donne dans un fichier et ouvrez celui-ci</translation></message>
<message><source>this is a keyboard, not a scan</source><translation>ceci est un clavier, pas un scan</translation></message>
<message><source>give a file, or pipe one in</source><translation>donnez un fichier, ou passez-le par un tube</translation></message>
<message><source>cancelled</source><translation>annulé</translation></message>
<message><source>no program writes into this pipe</source><translation>aucun programme n'écrit dans ce tube</translation></message>
<message><source>start the program that fills it, then open it again</source><translation>démarrez le programme qui le remplit, puis ouvrez-le à nouveau</translation></message>
<message><source>this is a device, not a scan</source><translation>ceci est un périphérique, pas un scan</translation></message>
<message><source>choose a file</source><translation>choisissez un fichier</translation></message>
<message><source>the file cannot be opened: </source><translation>le fichier ne peut pas être ouvert : </translation></message>
<message><source>check the path</source><translation>vérifiez le chemin</translation></message>
<message><source>this is not a regular file</source><translation>ceci n'est pas un fichier ordinaire</translation></message>
<message><source>the file cannot be read: </source><translation>le fichier ne peut pas être lu : </translation></message>
<message><source>check the disk and the path</source><translation>vérifiez le disque et le chemin</translation></message>
<message><source>the folder to write into does not exist</source><translation>le dossier de destination n'existe pas</translation></message>
<message><source>make the folder or choose another</source><translation>créez le dossier ou choisissez-en un autre</translation></message>
<message><source>the folder to write into is not a folder</source><translation>le dossier de destination n'est pas un dossier</translation></message>
<message><source>choose another folder</source><translation>choisissez un autre dossier</translation></message>
<message><source>writing here is not allowed</source><translation>il n'est pas permis d'écrire ici</translation></message>
<message><source>choose another folder or ask for the right to write</source><translation>choisissez un autre dossier ou demandez le droit d'écrire</translation></message>
<message><source>the disk can only be read</source><translation>le disque est en lecture seule</translation></message>
<message><source>the disk is full, so this file was not written</source><translation>le disque est plein, ce fichier n'a donc pas été écrit</translation></message>
<message><source>free some space or choose another disk</source><translation>libérez de la place ou choisissez un autre disque</translation></message>
<message><source>the file would be larger than the limit set for it</source><translation>le fichier dépasserait la limite qui lui est fixée</translation></message>
<message><source>choose another disk or raise the limit</source><translation>choisissez un autre disque ou relevez la limite</translation></message>
<message><source>this is a folder, not a file</source><translation>c'est un dossier, pas un fichier</translation></message>
<message><source>give a file name</source><translation>donnez un nom de fichier</translation></message>
<message><source>this link leads in a circle</source><translation>ce lien tourne en rond</translation></message>
<message><source>give the file itself</source><translation>donnez le fichier lui-même</translation></message>
<message><source>the file name is too long</source><translation>le nom du fichier est trop long</translation></message>
<message><source>choose a shorter name</source><translation>choisissez un nom plus court</translation></message>
<message><source>the file cannot be written: </source><translation>le fichier ne peut pas être écrit : </translation></message>
<message><source>choose another folder or disk</source><translation>choisissez un autre dossier ou disque</translation></message>
<message><source>what was read back is not what was written, so this file was not written</source><translation>ce qui a été relu n'est pas ce qui a été écrit, ce fichier n'a donc pas été écrit</translation></message>
<message><source>check the disk and try again</source><translation>vérifiez le disque et réessayez</translation></message>
<message><source>there is no such file; a name with other bytes than UTF-8 does not come through a file dialog</source><translation>ce fichier n'existe pas ; un nom avec d'autres octets que de l'UTF-8 ne passe pas par un dialogue de fichiers</translation></message>
<message><source>give the name on the command line, drag the file into the window, or rename it</source><translation>donnez le nom en ligne de commande, glissez le fichier dans la fenêtre ou renommez-le</translation></message>
<message><source>there is no such file</source><translation>ce fichier n'existe pas</translation></message>
<message><source>check the spelling and the folder</source><translation>vérifiez le nom et le dossier</translation></message>
<message><source>reading this file is not allowed</source><translation>la lecture de ce fichier n'est pas autorisée</translation></message>
<message><source>ask its owner for the right to read it</source><translation>demandez à son propriétaire le droit de le lire</translation></message>
<message><source>choose a file inside it</source><translation>choisissez un fichier à l'intérieur</translation></message>
<message><source>the file cannot be read: %1</source><translation>le fichier ne peut pas être lu : %1</translation></message>
<message><source>this file is read-only, so it was not replaced</source><translation>ce fichier est en lecture seule, il n'a donc pas été remplacé</translation></message>
<message><source>allow writing with chmod u+w, or choose another name</source><translation>permettez l'écriture avec chmod u+w, ou choisissez un autre nom</translation></message>
<message><source>this file belongs to another user, who does not allow writing, so it was not replaced</source><translation>ce fichier appartient à un autre utilisateur, qui ne permet pas d'y écrire ; il n'a donc pas été remplacé</translation></message>
<message><source>choose another name, or ask its owner</source><translation>choisissez un autre nom, ou demandez à son propriétaire</translation></message>
<message><source>; already in place: </source><translation> ; déjà en place : </translation></message>
<message><source>no program reads from this pipe</source><translation>aucun programme ne lit de ce tube</translation></message>
<message><source>start what reads from it first, or choose a file</source><translation>démarrez d'abord ce qui lit de lui, ou choisissez un fichier</translation></message>
<message><source>what reads from this pipe takes nothing</source><translation>ce qui lit de ce tube n'accepte rien</translation></message>
<message><source>start it again, or choose a file</source><translation>redémarrez-le, ou choisissez un fichier</translation></message>
<message><source>what reads from this pipe has ended</source><translation>ce qui lit de ce tube a fini</translation></message>
<message><source>there is no file name to write to</source><translation>il n'y a pas de nom de fichier où écrire</translation></message>
<message><source>this is a link that belongs to another user</source><translation>c'est un lien qui appartient à un autre utilisateur</translation></message>
<message><source>give the file it leads to, or another name</source><translation>donnez le fichier auquel il mène, ou un autre nom</translation></message>
<message><source>two results cannot have one file</source><translation>deux résultats ne peuvent pas avoir un même fichier</translation></message>
<message><source>give each a name of its own</source><translation>donnez à chacun un nom à lui</translation></message>
<message><source>it was cancelled, so nothing was written</source><translation>c'était annulé, donc rien n'a été écrit</translation></message>
<message><source>save it again</source><translation>enregistrez-le de nouveau</translation></message>
<message><source>the file cannot be removed (%1)</source><translation>le fichier ne peut pas être supprimé (%1)</translation></message>
<message><source>check the rights of its folder</source><translation>vérifiez les droits de son dossier</translation></message>
<message><source>this is a file and not a folder</source><translation>c'est un fichier et non un dossier</translation></message>
<message><source>give the name of a folder</source><translation>indiquez le nom d'un dossier</translation></message>
<message><source>the folder cannot be made (%1)</source><translation>le dossier ne peut pas être créé (%1)</translation></message>
<message><source>this is a device or a pipe, not a file</source><translation>ceci est un périphérique ou un tube, pas un fichier</translation></message>
<message><source>the file is too large for what it should be: %1, and at most %2 are read</source><translation>le fichier est trop grand pour ce qu'il devrait être : %1, et au plus %2 sont lus</translation></message>
<message><source>choose one that can be written to</source><translation>choisissez-en un où l'on puisse écrire</translation></message>
<message><source>it is compressed with %1 and damaged or cut off</source><translation>il est compressé avec %1 et endommagé ou coupé</translation></message>
<message><source>copy the file again</source><translation>copiez à nouveau le fichier</translation></message>
<message><source>this program was built without %1, which this recording is compressed with</source><translation>ce programme a été compilé sans %1, avec quoi cet enregistrement est compressé</translation></message>
<message><source>unpack it with "mcap compress --compression none" or "rosbag decompress", or install lib%1 and build again</source><translation>décompressez-le avec "mcap compress --compression none" ou "rosbag decompress", ou installez lib%1 et compilez à nouveau</translation></message>
<message><source>it is compressed with "%1", which is not known here</source><translation>il est compressé avec « %1 », qui n'est pas connu ici</translation></message>
<message><source>unpack it with the program that wrote it</source><translation>décompressez-le avec le programme qui l'a écrit</translation></message>
<message><source>other bytes follow the packed data</source><translation>d'autres octets suivent les données compressées</translation></message>
<message><source>unpacked this is more than %1, far more than a scan of its size can be</source><translation>décompressé, ceci fait plus de %1, bien plus qu'un scan de sa taille ne peut être</translation></message>
<message><source>unpack it by hand and look at it</source><translation>décompressez-la à la main et regardez-la</translation></message>
<message><source>there is not enough memory for this file</source><translation>la mémoire ne suffit pas pour ce fichier</translation></message>
<message><source>the packed data are damaged%1</source><translation>les données compressées sont endommagées%1</translation></message>
<message><source>the packed data end too early</source><translation>les données compressées finissent trop tôt</translation></message>
<message><source>copy the file again, it may be cut off</source><translation>copiez à nouveau le fichier, il est peut-être coupé</translation></message>
<message><source>this ZIP archive has no directory at its end</source><translation>cette archive ZIP n'a pas de répertoire à sa fin</translation></message>
<message><source>the directory of this ZIP archive is damaged</source><translation>le répertoire de cette archive ZIP est endommagé</translation></message>
<message><source>this ZIP archive does not begin where its directory says: other bytes are before it or in it</source><translation>cette archive ZIP ne commence pas là où son répertoire l'indique : d'autres octets la précèdent ou s'y trouvent</translation></message>
<message><source>this part of the archive is encrypted</source><translation>cette partie de l'archive est chiffrée</translation></message>
<message><source>save it without a password</source><translation>enregistrez-la sans mot de passe</translation></message>
<message><source>this part of the archive is packed by method %1</source><translation>cette partie de l'archive est compressée par la méthode %1</translation></message>
<message><source>pack it with DEFLATE, as usual</source><translation>compressez-la avec DEFLATE, comme d'habitude</translation></message>
<message><source>this part of the archive is not where its directory says</source><translation>cette partie de l'archive n'est pas là où son répertoire l'indique</translation></message>
<message><source>unpacked this is %1, far more than a scan of its size can be</source><translation>décompressé, cela fait %1, bien plus qu'un scan de cette taille</translation></message>
<message><source>this part of the archive is damaged: its length or its checksum does not fit</source><translation>cette partie de l'archive est endommagée : sa longueur ou sa somme de contrôle est fausse</translation></message>
<message><source>the points are said to begin at byte %1, which is not in the file</source><translation>les points commenceraient à l'octet %1, qui n'est pas dans le fichier</translation></message>
<message><source>no list of points begins where the E57 file says</source><translation>aucune liste de points ne commence là où le fichier E57 l'indique</translation></message>
<message><source>export the file again</source><translation>exportez à nouveau le fichier</translation></message>
<message><source>the header of the points does not fit the file</source><translation>l'en-tête des points ne correspond pas au fichier</translation></message>
<message><source>a packet of points %1</source><translation>un paquet de points %1</translation></message>
<message><source>is too short</source><translation>est trop court</translation></message>
<message><source>holds %1 and the file describes %2</source><translation>contient %1 et le fichier décrit %2</translation></message>
<message><source>%n column</source><translation>%n colonne</translation></message>
<message><source>%n columns</source><translation>%n colonnes</translation></message>
<message><source>ends within its header</source><translation>finit dans son en-tête</translation></message>
<message><source>promises more bytes than it has</source><translation>annonce plus d'octets qu'il n'en a</translation></message>
<message><source>a packet of points is of kind %1, which E57 does not have</source><translation>un paquet de points est du genre %1, que E57 n'a pas</translation></message>
<message><source>a packet of points says that it has %1 bytes, which are not there</source><translation>un paquet de points dit qu'il a %1 octets, qui n'y sont pas</translation></message>
<message><source>the file promises %1 and has %2 bytes for them</source><translation>le fichier annonce %1 et a %2 octets pour eux</translation></message>
<message><source>%n point</source><translation>%n point</translation></message>
<message><source>%n points</source><translation>%n points</translation></message>
<message><source>the file promises %1 and the column %2 ends after %3</source><translation>le fichier annonce %1 et la colonne %2 finit après %3</translation></message>
<message><source>the file ends within its E57 header</source><translation>le fichier finit dans son en-tête E57</translation></message>
<message><source>this is E57 version %1.%2, and version 1 is known</source><translation>ceci est du E57 version %1.%2, et la version 1 est connue</translation></message>
<message><source>export it as E57 version 1.0</source><translation>exportez-le en E57 version 1.0</translation></message>
<message><source>the E57 header says that pages have %1 bytes</source><translation>l'en-tête E57 donne des pages de %1 octets</translation></message>
<message><source>%1: byte 40</source><translation>%1 : octet 40</translation></message>
<message><source>the E57 header promises %1 bytes and the file holds %2</source><translation>l'en-tête E57 annonce %1 octets et le fichier en contient %2</translation></message>
<message><source>the columns of points in this E57 file are nested too deep</source><translation>les colonnes de points de ce fichier E57 sont trop imbriquées</translation></message>
<message><source>the limits of the column %1 in this E57 file are not possible</source><translation>les limites de la colonne %1 de ce fichier E57 sont impossibles</translation></message>
<message><source>scan %1 of this E57 file does not say where its points are and how many</source><translation>le scan %1 de ce fichier E57 n'indique ni où sont ses points ni combien il y en a</translation></message>
<message><source>the E57 header says that the XML part is at byte %1 and has %2 bytes, which are not in the file</source><translation>l'en-tête E57 dit que la partie XML est à l'octet %1 et a %2 octets, qui ne sont pas dans le fichier</translation></message>
<message><source>%1: byte 24</source><translation>%1 : octet 24</translation></message>
<message><source>the XML part of this E57 file cannot be read: </source><translation>la partie XML de ce fichier E57 est illisible : </translation></message>
<message><source>the XML part of this E57 file has no e57Root</source><translation>la partie XML de ce fichier E57 n'a pas d'e57Root</translation></message>
<message><source>page %1 of %2 of this E57 file is damaged: its checksum does not fit</source><translation>la page %1 sur %2 de ce fichier E57 est endommagée : sa somme de contrôle est fausse</translation></message>
<message><source>this E57 file ends before something that it names</source><translation>ce fichier E57 finit avant ce qu'il annonce</translation></message>
<message><source>a file of this name exists already and a recording overwrites nothing</source><translation>un fichier de ce nom existe déjà et un enregistrement n'écrase rien</translation></message>
<message><source>the folder to record into does not exist</source><translation>le dossier où enregistrer n'existe pas</translation></message>
<message><source>recording here is not allowed</source><translation>enregistrer ici n'est pas permis</translation></message>
<message><source>the disk is full, nothing is recorded</source><translation>le disque est plein, rien n'est enregistré</translation></message>
<message><source>the recording cannot be started: </source><translation>l'enregistrement ne peut pas commencer : </translation></message>
<message><source>the disk is full, the recording ends here</source><translation>le disque est plein, l'enregistrement finit ici</translation></message>
<message><source>free some space and start a new recording</source><translation>libérez de la place et commencez un nouvel enregistrement</translation></message>
<message><source>the file has reached the limit set for its size, the recording ends here</source><translation>le fichier a atteint la limite fixée à sa taille, l'enregistrement finit ici</translation></message>
<message><source>start a new recording</source><translation>commencez un nouvel enregistrement</translation></message>
<message><source>the recording ends here: </source><translation>l'enregistrement finit ici : </translation></message>
<message><source>check the disk and start a new recording</source><translation>vérifiez le disque et commencez un nouvel enregistrement</translation></message>
<message><source>the disk reports that it lost some of what was recorded: </source><translation>le disque signale qu'il a perdu une partie de ce qui a été enregistré : </translation></message>
<message><source>check the disk, and start a new recording on another one</source><translation>vérifiez le disque, et commencez un nouvel enregistrement sur un autre</translation></message>
<message><source>bytes %1 to %2 are damaged and were left out</source><translation>les octets %1 à %2 sont endommagés et ont été laissés de côté</translation></message>
<message><source>%1 more places are damaged or were left out</source><translation>%1 autres endroits sont endommagés ou ont été laissés de côté</translation></message>
<message><source>it is not a whole chunk</source><translation>ce n'est pas un bloc complet</translation></message>
<message><source>its checksum does not fit</source><translation>sa somme de contrôle ne correspond pas</translation></message>
<message><source>it promises to unpack to %1, more than a file of this size holds</source><translation>il annonce qu'il se décompresse en %1, plus qu'un fichier de cette taille ne contient</translation></message>
<message><source>the chunk at byte %1 was left out: %2</source><translation>le bloc à l'octet %1 a été laissé de côté : %2</translation></message>
<message><source>the end of the recording</source><translation>la fin de l'enregistrement</translation></message>
<message><source>the file says that it holds %1 and %2 could be read</source><translation>le fichier dit qu'il contient %1 et %2 ont pu être lus</translation></message>
<message><source>%n message</source><translation>%n message</translation></message>
<message><source>%n messages</source><translation>%n messages</translation></message>
<message><source>this is not an MCAP recording of a known version</source><translation>ce n'est pas un enregistrement MCAP d'une version connue</translation></message>
<message><source>choose a recording</source><translation>choisissez un enregistrement</translation></message>
<message><source>unknown reason</source><translation>raison inconnue</translation></message>
<message><source>out of memory</source><translation>mémoire insuffisante</translation></message>
<message><source>the file ends too early</source><translation>le fichier finit trop tôt</translation></message>
<message><source>there are no cells to make a picture of</source><translation>il n'y a pas de cellules dont faire une image</translation></message>
<message><source>open a scan first</source><translation>ouvrez d'abord un scan</translation></message>
<message><source>the picture cannot be made: </source><translation>l'image ne peut pas être faite : </translation></message>
<message><source>free some memory</source><translation>libérez de la mémoire</translation></message>
<message><source>the picture cannot be read: </source><translation>l'image ne peut pas être lue : </translation></message>
<message><source>save it again as PNG</source><translation>enregistrez-la à nouveau en PNG</translation></message>
<message><source>the picture has %1 x %2 pixels; at most %3 are taken</source><translation>l'image a %1 x %2 pixels ; au plus %3 sont acceptés</translation></message>
<message><source>make the picture smaller</source><translation>rendez l'image plus petite</translation></message>
<message><source>this is not a readable PNG picture: </source><translation>ceci n'est pas une image PNG lisible : </translation></message>
<message><source>save the mask again as PNG</source><translation>enregistrez à nouveau le masque en PNG</translation></message>
<message><source>this picture has 16 bits per pixel where 8 are needed</source><translation>cette image a 16 bits par pixel là où il en faut 8</translation></message>
<message><source>save the mask as 8-bit gray</source><translation>enregistrez le masque en gris de 8 bits</translation></message>
<message><source>the picture promises more pixels than the file can hold</source><translation>l'image annonce plus de pixels que le fichier ne peut contenir</translation></message>
<message><source>export it again</source><translation>exportez-le à nouveau</translation></message>
<message><source>this build has no robots: it reads no ROS bags, no VLP-16, no Ouster and no Foxglove bridge</source><translation>cette version est sans robots : elle ne lit ni bags ROS, ni VLP-16, ni Ouster, ni pont Foxglove</translation></message>
<message><source>use a build with robots (EDGESCAN_ROBOTS)</source><translation>utilisez une version avec robots (EDGESCAN_ROBOTS)</translation></message>
<message><source>this is not a whole DXF group</source><translation>ceci n'est pas un groupe DXF complet</translation></message>
<message><source>this coordinate is not a number</source><translation>cette coordonnée n'est pas un nombre</translation></message>
<message><source>reading points</source><translation>lecture des points</translation></message>
<message><source>%n point shares its row and column with a nearer one, which was taken (several returns of one beam).</source><translation>%n point partage sa rangée et sa colonne avec un plus proche, qui a été pris (plusieurs retours d'un faisceau).</translation></message>
<message><source>%n points share their row and column with a nearer one, which was taken (several returns of one beam).</source><translation>%n points partagent leur rangée et leur colonne avec un plus proche, qui a été pris (plusieurs retours d'un faisceau).</translation></message>
<message><source>this E57 file holds no scan, only %1</source><translation>ce fichier E57 ne contient aucun scan, seulement %1</translation></message>
<message><source>%n picture</source><translation>%n image</translation></message>
<message><source>%n pictures</source><translation>%n images</translation></message>
<message><source>this E57 file holds no scan</source><translation>ce fichier E57 ne contient aucun scan</translation></message>
<message><source>The file holds %1 scans; this is number %2, --scan chooses another.</source><translation>Le fichier contient %1 scans ; celui-ci est le numéro %2, --scan en choisit un autre.</translation></message>
<message><source>The first %1 of these scans hold no point with a return.</source><translation>Les %1 premiers de ces scans n'ont aucun point avec un retour.</translation></message>
<message><source>The rows and columns that the file gives its points make no grid and were not used.</source><translation>Les rangées et colonnes que le fichier donne à ses points ne forment pas de grille et n'ont pas été utilisées.</translation></message>
<message><source>The file does not say which way the scan lines run: its columns were taken as lines, its rows as beams.</source><translation>Le fichier ne dit pas dans quel sens vont les lignes : ses colonnes ont été prises comme lignes, ses rangées comme faisceaux.</translation></message>
<message><source>scan %1 of this E57 file</source><translation>le scan %1 de ce fichier E57</translation></message>
<message><source>%1 holds no points</source><translation>%1 ne contient aucun point</translation></message>
<message><source>choose another scan or file</source><translation>choisissez un autre scan ou fichier</translation></message>
<message><source>%1 has neither cartesian nor spherical coordinates, only %2</source><translation>%1 n'a de coordonnées ni cartésiennes ni sphériques, seulement %2</translation></message>
<message><source>export it with coordinates</source><translation>exportez-le avec des coordonnées</translation></message>
<message><source>The angles of the points were taken as degrees, because no elevation in radians is so large.</source><translation>Les angles des points ont été pris comme des degrés, car aucune élévation en radians n'est aussi grande.</translation></message>
<message><source>%n point has a range below 0 and counts as no return.</source><translation>%n point a une distance inférieure à 0 et compte comme sans retour.</translation></message>
<message><source>%n points have a range below 0 and count as no return.</source><translation>%n points ont une distance inférieure à 0 et comptent comme sans retour.</translation></message>
<message><source>%n point is marked as invalid in the file and counts as no return.</source><translation>%n point est marqué comme non valide dans le fichier et compte comme sans retour.</translation></message>
<message><source>%n points are marked as invalid in the file and count as no return.</source><translation>%n points sont marqués comme non valides dans le fichier et comptent comme sans retour.</translation></message>
<message><source>What else a point of this file has is not read: %1.</source><translation>Ce qu'un point de ce fichier a d'autre n'est pas lu : %1.</translation></message>
<message><source>The pictures of this file (%1) are not read.</source><translation>Les images de ce fichier (%1) ne sont pas lues.</translation></message>
<message><source>the end that the header gives</source><translation>la fin que donne l'en-tête</translation></message>
<message><source>The pose in the file is not a rotation and shift, so the scan stays in the scanner's frame.</source><translation>La pose du fichier n'est pas une rotation et une translation ; le scan reste donc dans le repère du scanner.</translation></message>
<message><source>choose a scan file</source><translation>choisissez un fichier de scan</translation></message>
<message><source>it may be what a site sent instead of the file: download the file again, or choose a scan file</source><translation>un site l'a peut-être envoyée à la place du fichier : téléchargez à nouveau le fichier, ou choisissez un fichier de scan</translation></message>
<message><source>unpack it and open the scan in it</source><translation>décompressez-la et ouvrez le scan qu'elle contient</translation></message>
<message><source>save its points as PLY in MeshLab</source><translation>enregistrez ses points en PLY dans MeshLab</translation></message>
<message><source>choose the scan that it was made from</source><translation>choisissez le scan dont il vient</translation></message>
<message><source>save the ranges as .npy or .csv</source><translation>enregistrez les distances en .npy ou .csv</translation></message>
<message><source>this is a JPEG picture, not a scan</source><translation>c'est une image JPEG, pas un scan</translation></message>
<message><source>this is a GIF picture, not a scan</source><translation>c'est une image GIF, pas un scan</translation></message>
<message><source>this is a picture, sound or film (RIFF), not a scan</source><translation>c'est une image, un son ou un film (RIFF), pas un scan</translation></message>
<message><source>this is a picture or film, not a scan</source><translation>c'est une image ou un film, pas un scan</translation></message>
<message><source>this is a Photoshop picture, not a scan</source><translation>c'est une image Photoshop, pas un scan</translation></message>
<message><source>this is a program, not a scan</source><translation>c'est un programme, pas un scan</translation></message>
<message><source>this is a PDF document, not a scan</source><translation>c'est un document PDF, pas un scan</translation></message>
<message><source>this is a ZIP archive, not a scan</source><translation>c'est une archive ZIP, pas un scan</translation></message>
<message><source>this is a gzip archive in another one, not a scan</source><translation>c'est une archive gzip dans une autre, pas un scan</translation></message>
<message><source>this is an xz archive, not a scan</source><translation>c'est une archive xz, pas un scan</translation></message>
<message><source>unpack it (xz -d) and open the scan in it</source><translation>décompressez-le (xz -d) et ouvrez le scan qu'il contient</translation></message>
<message><source>this is a bzip2 archive, not a scan</source><translation>c'est une archive bzip2, pas un scan</translation></message>
<message><source>unpack it (bzip2 -d) and open the scan in it</source><translation>décompressez-le (bzip2 -d) et ouvrez le scan qu'il contient</translation></message>
<message><source>this is a zstd archive, not a scan</source><translation>c'est une archive zstd, pas un scan</translation></message>
<message><source>unpack it (zstd -d) and open the scan in it</source><translation>décompressez-le (zstd -d) et ouvrez le scan qu'il contient</translation></message>
<message><source>this is a 7-Zip archive, not a scan</source><translation>c'est une archive 7-Zip, pas un scan</translation></message>
<message><source>this is a RAR archive, not a scan</source><translation>c'est une archive RAR, pas un scan</translation></message>
<message><source>this is an HDF5 file, which is not read</source><translation>c'est un fichier HDF5, qui n'est pas lu</translation></message>
<message><source>this is a MATLAB file, which is not read</source><translation>c'est un fichier MATLAB, qui n'est pas lu</translation></message>
<message><source>save the ranges with writematrix(ranges, 'scan.csv')</source><translation>enregistrez les distances avec writematrix(ranges, 'scan.csv')</translation></message>
<message><source>this is an old Office document, not a scan</source><translation>c'est un ancien document Office, pas un scan</translation></message>
<message><source>save the table as .csv</source><translation>enregistrez le tableau en .csv</translation></message>
<message><source>this is a Parquet table, which is not read</source><translation>c'est un tableau Parquet, qui n'est pas lu</translation></message>
<message><source>this is an Arrow table, which is not read</source><translation>c'est un tableau Arrow, qui n'est pas lu</translation></message>
<message><source>this is a glTF model, which is not read</source><translation>c'est un modèle glTF, qui n'est pas lu</translation></message>
<message><source>save it as PLY in Blender or MeshLab</source><translation>enregistrez-le en PLY dans Blender ou MeshLab</translation></message>
<message><source>this is a STEP model, not a scan</source><translation>c'est un modèle STEP, pas un scan</translation></message>
<message><source>this is an FBX model, which is not read</source><translation>c'est un modèle FBX, qui n'est pas lu</translation></message>
<message><source>save it as PLY in Blender</source><translation>enregistrez-le en PLY dans Blender</translation></message>
<message><source>this is a web page (HTML), not a scan</source><translation>c'est une page web (HTML), pas un scan</translation></message>
<message><source>this is an SVG picture, not a scan</source><translation>c'est une image SVG, pas un scan</translation></message>
<message><source>this is an XML document, not a scan</source><translation>c'est un document XML, pas un scan</translation></message>
<message><source>this is a text document (RTF), not a scan</source><translation>c'est un document texte (RTF), pas un scan</translation></message>
<message><source>this is a PostScript document, not a scan</source><translation>c'est un document PostScript, pas un scan</translation></message>
<message><source>this is a file of VTK, which is not read</source><translation>c'est un fichier de VTK, qui n'est pas lu</translation></message>
<message><source>save its points as PLY, or as CSV from ParaView's table</source><translation>enregistrez ses points en PLY, ou en CSV depuis le tableau de ParaView</translation></message>
<message><source>this is an OFF mesh, which is not read</source><translation>c'est un maillage OFF, qui n'est pas lu</translation></message>
<message><source>this is a VRML scene, which is not read</source><translation>c'est une scène VRML, qui n'est pas lue</translation></message>
<message><source>this is a table of rocks, not a scan</source><translation>c'est un tableau de roches, pas un scan</translation></message>
<message><source>this is a raster of heights (Esri ASCII grid), not a scan</source><translation>c'est un raster de hauteurs (grille ASCII Esri), pas un scan</translation></message>
<message><source>this is a raster of heights (Surfer grid), not a scan</source><translation>c'est un raster de hauteurs (grille Surfer), pas un scan</translation></message>
<message><source>export it as E57 with FARO SCENE</source><translation>exportez-le en E57 avec FARO SCENE</translation></message>
<message><source>export it as E57 or LAS with RiSCAN PRO, or with RIEGL's rdbconvert</source><translation>exportez-le en E57 ou LAS avec RiSCAN PRO, ou avec rdbconvert de RIEGL</translation></message>
<message><source>export it as E57 with Z+F LaserControl</source><translation>exportez-le en E57 avec Z+F LaserControl</translation></message>
<message><source>export it as E57 or PTX with Leica Cyclone</source><translation>exportez-le en E57 ou PTX avec Leica Cyclone</translation></message>
<message><source>export it as E57 with Autodesk ReCap</source><translation>exportez-le en E57 avec Autodesk ReCap</translation></message>
<message><source>this is a FARO scan (FLS), which is not read</source><translation>c'est un scan FARO (FLS), qui n'est pas lu</translation></message>
<message><source>this is a FARO workspace, which is not read</source><translation>c'est un espace de travail FARO, qui n'est pas lu</translation></message>
<message><source>this is a FARO project, which is not read</source><translation>c'est un projet FARO, qui n'est pas lu</translation></message>
<message><source>this is a RIEGL stream (RXP), which is not read</source><translation>c'est un flux RIEGL (RXP), qui n'est pas lu</translation></message>
<message><source>this is a RIEGL database, which is not read</source><translation>c'est une base de données RIEGL, qui n'est pas lue</translation></message>
<message><source>this is a RIEGL database (RDBX), which is not read</source><translation>c'est une base de données RIEGL (RDBX), qui n'est pas lue</translation></message>
<message><source>this is a RIEGL scan (3DD), which is not read</source><translation>c'est un scan RIEGL (3DD), qui n'est pas lu</translation></message>
<message><source>this is a Z+F scan (ZFS), which is not read</source><translation>c'est un scan Z+F (ZFS), qui n'est pas lu</translation></message>
<message><source>this is a Z+F project (ZFPRJ), which is not read</source><translation>c'est un projet Z+F (ZFPRJ), qui n'est pas lu</translation></message>
<message><source>this is a Z+F scan (ZFC), which is not read</source><translation>c'est un scan Z+F (ZFC), qui n'est pas lu</translation></message>
<message><source>this is a Leica LGS project, which is not read</source><translation>c'est un projet Leica LGS, qui n'est pas lu</translation></message>
<message><source>this is a Leica LGSx project, which is not read</source><translation>c'est un projet Leica LGSx, qui n'est pas lu</translation></message>
<message><source>this is a Leica Cyclone database, which is not read</source><translation>c'est une base de données Leica Cyclone, qui n'est pas lue</translation></message>
<message><source>this is an Autodesk ReCap project, which is not read</source><translation>c'est un projet Autodesk ReCap, qui n'est pas lu</translation></message>
<message><source>this is an Autodesk ReCap scan, which is not read</source><translation>c'est un scan Autodesk ReCap, qui n'est pas lu</translation></message>
<message><source>this is a Trimble scan (TZF), which is not read</source><translation>c'est un scan Trimble (TZF), qui n'est pas lu</translation></message>
<message><source>export it as E57 with Trimble RealWorks</source><translation>exportez-le en E57 avec Trimble RealWorks</translation></message>
<message><source>this is a Topcon scan (CL3), which is not read</source><translation>c'est un scan Topcon (CL3), qui n'est pas lu</translation></message>
<message><source>export it as E57 or PTX with Topcon's program</source><translation>exportez-le en E57 ou PTX avec le programme de Topcon</translation></message>
<message><source>this is a Topcon scan (CLR), which is not read</source><translation>c'est un scan Topcon (CLR), qui n'est pas lu</translation></message>
<message><source>this is a Pointools cloud (POD), which is not read</source><translation>c'est un nuage Pointools (POD), qui n'est pas lu</translation></message>
<message><source>export it as LAS with Bentley's program</source><translation>exportez-le en LAS avec le programme de Bentley</translation></message>
<message><source>this is a Python pickle, which only Python can open</source><translation>c'est un pickle Python, que seul Python peut ouvrir</translation></message>
<message><source>this is a ROS bag that does not begin like one</source><translation>c'est un bag ROS qui n'en a pas le début</translation></message>
<message><source>copy it again</source><translation>copiez-la à nouveau</translation></message>
<message><source>this is a ROS 2 bag that does not begin like one</source><translation>c'est un bag ROS 2 qui n'en a pas le début</translation></message>
<message><source>this is a binary file without a telegram of a SICK scanner in it</source><translation>c'est un fichier binaire sans télégramme d'un scanner SICK</translation></message>
<message><source>save points as PCD or PLY; a capture of telegrams holds the bytes as they came from the scanner</source><translation>enregistrez les points en PCD ou PLY ; une capture de télégrammes contient les octets tels que reçus du scanner</translation></message>
<message><source>this is a BMP picture, not a scan</source><translation>c'est une image BMP, pas un scan</translation></message>
<message><source>this is a drawing (DXF), which is not read</source><translation>c'est un dessin (DXF), qui n'est pas lu</translation></message>
<message><source>choose the scan, or save the points of the drawing as CSV, LAS or PLY</source><translation>choisissez le scan, ou enregistrez les points du dessin en CSV, LAS ou PLY</translation></message>
<message><source>this is an Excel workbook, not a table of text</source><translation>c'est un classeur Excel, pas un tableau de texte</translation></message>
<message><source>save the sheet as .csv</source><translation>enregistrez la feuille en .csv</translation></message>
<message><source>this is an OpenDocument spreadsheet, not a table of text</source><translation>c'est une feuille de calcul OpenDocument, pas un tableau de texte</translation></message>
<message><source>this is a numpy archive, which is not read</source><translation>c'est une archive numpy, qui n'est pas lue</translation></message>
<message><source>save the array of ranges or points as .npy</source><translation>enregistrez le tableau de distances ou de points en .npy</translation></message>
<message><source>this is a ROS bag, and %1</source><translation>ceci est un bag ROS, et %1</translation></message>
<message><source>Network capture</source><translation>Capture réseau</translation></message>
<message><source>The picture asks to be turned or mirrored when it is shown (orientation %1): its rows were taken as scan lines as they are stored.</source><translation>L'image demande à être tournée ou retournée à l'affichage (orientation %1) : ses rangées ont été prises comme lignes telles qu'elles sont stockées.</translation></message>
<message><source>the picture promises more pixels than a file of %1 holds of a scan</source><translation>l'image annonce plus de pixels qu'un fichier de %1 n'en contient d'un scan</translation></message>
<message><source>a pixel</source><translation>un pixel</translation></message>
<message><source>%n pixel holds no range (negative, not a number, or too far) and was taken as no return.</source><translation>%n pixel ne contient pas de distance (négatif, pas un nombre, ou trop loin) et a été pris comme sans retour.</translation></message>
<message><source>%n pixels hold no range (negative, not a number, or too far) and were taken as no return.</source><translation>%n pixels ne contiennent pas de distance (négatifs, pas un nombre, ou trop loin) et ont été pris comme sans retour.</translation></message>
<message><source>Unit taken as millimetres, as range pictures have it.</source><translation>Unité prise en millimètres, comme dans les images de distances.</translation></message>
<message><source>this TIFF picture has %1 of %2 bits, and ranges need one of 16 bits or of 4-byte floats</source><translation>cette image TIFF a %1 de %2 bits, et les distances en demandent un de 16 bits ou de nombres de 4 octets</translation></message>
<message><source>%n channel</source><translation>%n canal</translation></message>
<message><source>%n channels</source><translation>%n canaux</translation></message>
<message><source>choose a scan, or a range picture of 16 bits per pixel</source><translation>choisissez un scan, ou une image de distances de 16 bits par pixel</translation></message>
<message><source>this TIFF picture is stored in tiles</source><translation>cette image TIFF est enregistrée en tuiles</translation></message>
<message><source>save it in strips</source><translation>enregistrez-la en bandes</translation></message>
<message><source>the picture has no pixels</source><translation>l'image n'a pas de pixels</translation></message>
<message><source>the TIFF picture is damaged or of a kind that cannot be read</source><translation>l'image TIFF est endommagée ou d'un type illisible</translation></message>
<message><source>reading the picture</source><translation>lecture de l'image</translation></message>
<message><source>The file holds %1 (pages); the first was read.</source><translation>Le fichier contient %1 (pages) ; la première a été lue.</translation></message>
<message><source>the picture</source><translation>l'image</translation></message>
<message><source>this is a TIFF picture, and this build of the program cannot read TIFF</source><translation>ceci est une image TIFF, et cette version du programme ne peut pas lire TIFF</translation></message>
<message><source>save the ranges as PNG of 16 bits</source><translation>enregistrez les distances en PNG de 16 bits</translation></message>
<message><source>this is a PNG picture of %1 bit gray, and ranges need 16 bit gray</source><translation>c'est une image PNG de %1 bits gris, et les distances demandent 16 bits gris</translation></message>
<message><source>this is a PNG picture of %1 bit colour, and ranges need 16 bit gray</source><translation>c'est une image PNG de %1 bits en couleurs, et les distances demandent 16 bits gris</translation></message>
<message><source>The picture is animated; the first frame was read.</source><translation>L'image est animée ; la première vue a été lue.</translation></message>
<message><source>The picture does not end with IEND: the file was cut off behind its pixels.</source><translation>L'image ne finit pas par IEND : le fichier a été coupé après ses pixels.</translation></message>
<message><source>this is a PNG picture that cannot be read: </source><translation>c'est une image PNG illisible : </translation></message>
<message><source>close other programs</source><translation>fermez d'autres programmes</translation></message>
<message><source>the file ends within its LAS header</source><translation>le fichier finit dans son en-tête LAS</translation></message>
<message><source>this is LAS version %1.%2, and versions up to 1.4 are known</source><translation>ceci est du LAS version %1.%2, et les versions jusqu'à 1.4 sont connues</translation></message>
<message><source>save it as LAS 1.2 or 1.4</source><translation>enregistrez-le en LAS 1.2 ou 1.4</translation></message>
<message><source>the LAS header says it is %1 bytes long</source><translation>l'en-tête LAS dit qu'il a %1 octets</translation></message>
<message><source>the scale or offset in the LAS header is not a number that coordinates can have</source><translation>l'échelle ou le décalage de l'en-tête LAS n'est pas un nombre que des coordonnées peuvent avoir</translation></message>
<message><source>points of format %1 with %2 bytes are none that LAS knows</source><translation>LAS ne connaît pas de points du format %1 avec %2 octets</translation></message>
<message><source>the file holds no points</source><translation>le fichier ne contient pas de points</translation></message>
<message><source>the points begin at byte %1, which is not in the file</source><translation>les points commencent à l'octet %1, qui n'est pas dans le fichier</translation></message>
<message><source>the header promises %1 of %2 bytes and the file holds %3 bytes of them</source><translation>l'en-tête annonce %1 de %2 octets et le fichier en contient %3 octets</translation></message>
<message><source>The end of the file is damaged or missing: %1 of %2 records behind the points cannot be read. A grid, cell states or a place in the mine that they held are lost; copy the file again.</source><translation>La fin du fichier est endommagée ou manque : %1 enregistrements sur %2 derrière les points sont illisibles. Une grille, des états de cellules ou une place dans la mine qu'ils contenaient sont perdus ; copiez à nouveau le fichier.</translation></message>
<message><source>the %1 that the header promises</source><translation>les %1 que l'en-tête annonce</translation></message>
<message><source>the last record</source><translation>le dernier enregistrement</translation></message>
<message><source>The waveforms of this file were not read.</source><translation>Les formes d'onde de ce fichier n'ont pas été lues.</translation></message>
<message><source>describes a scan of %1 valid cells and holds %2</source><translation>décrit un scan de %1 cellules valides et contient %2</translation></message>
<message><source>save the scan again</source><translation>enregistrez à nouveau le scan</translation></message>
<message><source>x and y of this file are degrees of longitude and latitude, as its coordinate system says, and points need metres</source><translation>x et y de ce fichier sont des degrés de longitude et de latitude, selon son système de coordonnées, et il faut des mètres</translation></message>
<message><source>export it in a projected coordinate system such as UTM</source><translation>exportez-le dans un système de coordonnées projeté comme UTM</translation></message>
<message><source>The coordinate system of the file is %1, without its unit: metres were taken. --unit says another one.</source><translation>Le système de coordonnées du fichier est %1, sans son unité : des mètres ont été supposés. --unit en indique une autre.</translation></message>
<message><source>The coordinate system of the file gives lengths in %1 of %2 mm: they were converted.</source><translation>Le système de coordonnées du fichier donne les longueurs en %1 de %2 mm : elles ont été converties.</translation></message>
<message><source>Heights of the file have another unit than x and y, %1 mm: they were converted.</source><translation>Les hauteurs du fichier ont une autre unité que x et y, %1 mm : elles ont été converties.</translation></message>
<message><source>%n point is marked as withheld in the file and counts as no return.</source><translation>%n point est marqué comme exclu dans le fichier et compte comme sans retour.</translation></message>
<message><source>%n points are marked as withheld in the file and count as no return.</source><translation>%n points sont marqués comme exclus dans le fichier et comptent comme sans retour.</translation></message>
<message><source>there are no points to save</source><translation>il n'y a pas de points à enregistrer</translation></message>
<message><source>choose other cells or settings</source><translation>choisissez d'autres cellules ou d'autres réglages</translation></message>
<message><source>LAS holds 2147 km in whole millimetres, and these points lie farther apart</source><translation>LAS couvre 2147 km en millimètres entiers, et ces points sont plus éloignés les uns des autres</translation></message>
<message><source>save them as .pcd or .ply</source><translation>enregistrez-les en .pcd ou .ply</translation></message>
<message><source>LASzip gives no reason</source><translation>LASzip ne donne pas de raison</translation></message>
<message><source>this LAZ file cannot be unpacked: %1</source><translation>ce fichier LAZ ne peut pas être décompressé : %1</translation></message>
<message><source>the header promises %1, more than a file of %2 holds of a scan</source><translation>l'en-tête annonce %1, plus qu'un fichier de %2 ne contient d'un scan</translation></message>
<message><source>copy it again, or save it as .las</source><translation>copiez-le à nouveau, ou enregistrez-le en .las</translation></message>
<message><source>the header promises %1 and the file ends after %2 (%3)</source><translation>l'en-tête annonce %1 et le fichier finit après %2 (%3)</translation></message>
<message><source>this LAZ file is damaged or cut off</source><translation>ce fichier LAZ est endommagé ou coupé</translation></message>
<message><source>this LAZ file cannot be unpacked: </source><translation>ce fichier LAZ ne peut pas être décompressé : </translation></message>
<message><source>this LAZ file cannot be unpacked: it ends too early</source><translation>ce fichier LAZ ne peut pas être décompressé : il finit trop tôt</translation></message>
<message><source>this LAS file is compressed (LAZ), and this build of the program was made without LASzip</source><translation>ce fichier LAS est compressé (LAZ), et cette version du programme a été compilée sans LASzip</translation></message>
<message><source>save it uncompressed as .las, with CloudCompare or "laszip -i IN.laz -o OUT.las"</source><translation>enregistrez-le sans compression en .las, avec CloudCompare ou "laszip -i IN.laz -o OUT.las"</translation></message>
<message><source>reading ranges</source><translation>lecture des distances</translation></message>
<message><source>the array at [%1, %2]</source><translation>le tableau en [%1, %2]</translation></message>
<message><source>The first three of %1 columns were taken as x, y and z; the others are not read.</source><translation>Les trois premières de %1 colonnes ont été prises comme x, y et z ; les autres ne sont pas lues.</translation></message>
<message><source>the records of this numpy array have no x, y and z, only %1</source><translation>les enregistrements de ce tableau numpy n'ont pas x, y et z, seulement %1</translation></message>
<message><source>save points with fields x, y and z</source><translation>enregistrez les points avec des champs x, y et z</translation></message>
<message><source>the fields of this numpy array have different byte orders</source><translation>les champs de ce tableau numpy ont des ordres d'octets différents</translation></message>
<message><source>save it again with one</source><translation>enregistrez-le à nouveau avec un seul</translation></message>
<message><source>a numpy array of shape %1 is larger than any scan</source><translation>un tableau numpy de forme %1 est plus grand que tout scan</translation></message>
<message><source>split it</source><translation>divisez-le</translation></message>
<message><source>a numpy array of shape %1 may be points the wrong way round, or three lines of ranges</source><translation>un tableau numpy de forme %1 peut être des points aux axes échangés, ou trois lignes de distances</translation></message>
<message><source>save points as (n, 3), which is points.T, or give --beam-start --beam-step --line-start --line-step --axis</source><translation>enregistrez les points en (n, 3), c'est-à-dire points.T, ou indiquez --beam-start --beam-step --line-start --line-step --axis</translation></message>
<message><source>a numpy array of shape %1 is neither ranges (lines, beams) nor points (n, 3) or (lines, beams, 3)</source><translation>un tableau numpy de forme %1 n'est ni des distances (lignes, faisceaux) ni des points (n, 3) ou (lignes, faisceaux, 3)</translation></message>
<message><source>save it in one of these shapes</source><translation>enregistrez-le dans une de ces formes</translation></message>
<message><source>The file holds more than one array (numpy.save more than once); the first was read.</source><translation>Le fichier contient plus d'un tableau (numpy.save plus d'une fois) ; le premier a été lu.</translation></message>
<message><source>the array</source><translation>le tableau</translation></message>
<message><source>Python objects, which only Python can open</source><translation>des objets Python, que seul Python peut ouvrir</translation></message>
<message><source>true and false</source><translation>vrai et faux</translation></message>
<message><source>complex numbers</source><translation>des nombres complexes</translation></message>
<message><source>dates or times</source><translation>des dates ou des heures</translation></message>
<message><source>values of type %1</source><translation>des valeurs du type %1</translation></message>
<message><source>save the array again with numpy.save</source><translation>enregistrez à nouveau le tableau avec numpy.save</translation></message>
<message><source>the file ends within its numpy header</source><translation>le fichier finit dans son en-tête numpy</translation></message>
<message><source>this is version %1 of numpy's format</source><translation>c'est la version %1 du format de numpy</translation></message>
<message><source>the numpy header does not say type, order and shape</source><translation>l'en-tête numpy ne dit pas le type, l'ordre et la forme</translation></message>
<message><source>the numpy header promises an array of shape %1</source><translation>l'en-tête numpy annonce un tableau de forme %1</translation></message>
<message><source>this numpy array holds %1</source><translation>ce tableau numpy contient %1</translation></message>
<message><source>save it as an array of numbers (ranges.astype(numpy.float32))</source><translation>enregistrez-le comme tableau de nombres (ranges.astype(numpy.float32))</translation></message>
<message><source>this numpy array of shape %1 is empty</source><translation>ce tableau numpy de forme %1 est vide</translation></message>
<message><source>the numpy header promises an array of shape %1, %2 of %3 bytes, and the file holds %4 bytes of them</source><translation>l'en-tête numpy annonce un tableau de forme %1, %2 de %3 octets, et le fichier en contient %4 octets</translation></message>
<message><source>%n item</source><translation>%n élément</translation></message>
<message><source>%n items</source><translation>%n éléments</translation></message>
<message><source>this vertex does not hold three numbers</source><translation>ce sommet ne contient pas trois nombres</translation></message>
<message><source>copy the file again, it may be cut off here</source><translation>copiez à nouveau le fichier, il est peut-être coupé ici</translation></message>
<message><source>this OBJ file has no vertices</source><translation>ce fichier OBJ n'a pas de sommets</translation></message>
<message><source>%n line holds no words of OBJ and was not read, the first is line %1.</source><translation>%n ligne n'a pas de mots d'OBJ et n'a pas été lue, la première est la ligne %1.</translation></message>
<message><source>%n lines hold no words of OBJ and were not read, the first is line %1.</source><translation>%n lignes n'ont pas de mots d'OBJ et n'ont pas été lues, la première est la ligne %1.</translation></message>
<message><source>this header line of the PCD file is not understood</source><translation>cette ligne de l'en-tête du fichier PCD n'est pas comprise</translation></message>
<message><source>compare it with a PCD file of version 0.7</source><translation>comparez-le avec un fichier PCD de version 0.7</translation></message>
<message><source>the PCD header has no DATA line</source><translation>l'en-tête PCD n'a pas de ligne DATA</translation></message>
<message><source>the PCD header names %1 and gives %2, %3 and %4</source><translation>l'en-tête PCD nomme %1 et donne %2, %3 et %4</translation></message>
<message><source>%n field</source><translation>%n champ</translation></message>
<message><source>%n fields</source><translation>%n champs</translation></message>
<message><source>%n size</source><translation>%n taille</translation></message>
<message><source>%n sizes</source><translation>%n tailles</translation></message>
<message><source>%n type</source><translation>%n type</translation></message>
<message><source>%n types</source><translation>%n types</translation></message>
<message><source>%n count</source><translation>%n compte</translation></message>
<message><source>%n counts</source><translation>%n comptes</translation></message>
<message><source>the header promises more points than any file holds</source><translation>l'en-tête annonce plus de points qu'aucun fichier n'en contient</translation></message>
<message><source>the header promises %1 and %2 x %3 of them</source><translation>l'en-tête annonce %1 et %2 x %3 d'entre eux</translation></message>
<message><source>the field %1 has a type or size that PCD does not know</source><translation>le champ %1 a un type ou une taille que PCD ne connaît pas</translation></message>
<message><source>one point would take more than a megabyte</source><translation>un point prendrait plus d'un mégaoctet</translation></message>
<message><source>the PCD file has no fields x, y and z</source><translation>le fichier PCD n'a pas de champs x, y et z</translation></message>
<message><source>export the file with coordinates</source><translation>exportez le fichier avec des coordonnées</translation></message>
<message><source>the file ends before its compressed points</source><translation>le fichier finit avant ses points compressés</translation></message>
<message><source>promises %1 compressed bytes and holds %2</source><translation>annonce %1 octets compressés et en contient %2</translation></message>
<message><source>promises that %1 unpack to %2, which no scan does</source><translation>annonce que %1 se décompressent en %2, ce qu'aucun scan ne fait</translation></message>
<message><source>export the file again, uncompressed</source><translation>exportez à nouveau le fichier, sans compression</translation></message>
<message><source>the compressed points are damaged</source><translation>les points compressés sont endommagés</translation></message>
<message><source>the points</source><translation>les points</translation></message>
<message><source>the encoding "%1" is not ascii, binary or binary_compressed</source><translation>le codage « %1 » n'est ni ascii, ni binary, ni binary_compressed</translation></message>
<message><source>this header line of the PLY file is not understood</source><translation>cette ligne de l'en-tête du fichier PLY n'est pas comprise</translation></message>
<message><source>the PLY header has no end_header line</source><translation>l'en-tête PLY n'a pas de ligne end_header</translation></message>
<message><source>the file ends before its vertices</source><translation>le fichier finit avant ses sommets</translation></message>
<message><source>the header promises %1</source><translation>l'en-tête annonce %1</translation></message>
<message><source>check the file</source><translation>vérifiez le fichier</translation></message>
<message><source>the PLY file has no vertices</source><translation>le fichier PLY n'a pas de sommets</translation></message>
<message><source>The lists that each vertex of this file has were not read.</source><translation>Les listes que chaque sommet de ce fichier possède n'ont pas été lues.</translation></message>
<message><source>the header promises %1 and the file ends after %2</source><translation>l'en-tête annonce %1 et le fichier finit après %2</translation></message>
<message><source>%n vertex</source><translation>%n sommet</translation></message>
<message><source>%n vertices</source><translation>%n sommets</translation></message>
<message><source>the format "%1" is none that PLY knows</source><translation>PLY ne connaît pas le format « %1 »</translation></message>
<message><source>the header promises %1 and the file holds %2 bytes of them</source><translation>l'en-tête annonce %1 et le fichier en contient %2 octets</translation></message>
<message><source>the file is cut off in its last vertex</source><translation>le fichier est coupé dans son dernier sommet</translation></message>
<message><source>Each vertex has a byte that the header does not name, as PCL writes it behind colours: it was skipped.</source><translation>Chaque sommet a un octet que l'en-tête ne nomme pas, comme PCL l'écrit derrière les couleurs : il a été sauté.</translation></message>
<message><source>the vertices have no x, y and z</source><translation>les sommets n'ont pas x, y et z</translation></message>
<message><source>Only the vertices were read, not what follows them: %1.</source><translation>Seuls les sommets ont été lus, pas ce qui les suit : %1.</translation></message>
<message><source>say which columns are easting (x), northing (y) and elevation (z), by number or name: --columns 2,1,3</source><translation>dites quelles colonnes sont l'est (x), le nord (y) et l'altitude (z), par numéro ou par nom : --columns 2,1,3</translation></message>
<message><source>--columns %1 does not name three different ones of its %2%3</source><translation>--columns %1 n'en nomme pas trois différentes parmi ses %2%3</translation></message>
<message><source>give three numbers from 1, or three names, such as --columns 2,1,3</source><translation>donnez trois numéros à partir de 1, ou trois noms, comme --columns 2,1,3</translation></message>
<message><source>holds %1 where a point needs three</source><translation>contient %1 là où un point en demande trois</translation></message>
<message><source>%n number</source><translation>%n nombre</translation></message>
<message><source>%n numbers</source><translation>%n nombres</translation></message>
<message><source>choose a point list or a table of ranges</source><translation>choisissez une liste de points ou un tableau de distances</translation></message>
<message><source>its heading names %1 (%2), and points need x, y and z in metres</source><translation>son titre nomme %1 (%2), et les points demandent x, y et z en mètres</translation></message>
<message><source>write x, y and z, or ranges as a table with a row per scan line; or </source><translation>écrivez x, y et z, ou les distances en tableau avec une rangée par ligne ; ou </translation></message>
<message><source>its heading names axes (%1), and not all of x, y and z are understood</source><translation>son en-tête nomme des axes (%1), et x, y et z ne sont pas tous compris</translation></message>
<message><source>its heading names no x, y and z that are understood (%1)</source><translation>son en-tête ne nomme pas de x, y et z compris (%1)</translation></message>
<message><source>the second to the fourth</source><translation>de la deuxième à la quatrième</translation></message>
<message><source>the third to the fifth</source><translation>de la troisième à la cinquième</translation></message>
<message><source>the fourth to the sixth</source><translation>de la quatrième à la sixième</translation></message>
<message><source>the fifth to the seventh</source><translation>de la cinquième à la septième</translation></message>
<message><source>the first holds</source><translation>la première contient</translation></message>
<message><source>the first two hold</source><translation>les deux premières contiennent</translation></message>
<message><source>the first three hold</source><translation>les trois premières contiennent</translation></message>
<message><source>the first four hold</source><translation>les quatre premières contiennent</translation></message>
<message><source>No heading names the columns: the first two were taken for row and column of the grid, the third to the fifth for x, y and z.</source><translation>Aucun en-tête ne nomme les colonnes : les deux premières ont été prises pour rangée et colonne de la grille, la troisième à la cinquième pour x, y et z.</translation></message>
<message><source>No heading names the columns: %1 were taken for x, y and z, as %2 whole numbers only.</source><translation>Aucun titre ne nomme les colonnes : %1 ont été prises pour x, y et z, car %2 seulement des nombres entiers.</translation></message>
<message><source>The header names no x, y and z: the first three columns were taken for them (%1, %2, %3).</source><translation>L'en-tête ne nomme ni x, ni y, ni z : les trois premières colonnes ont été prises (%1, %2, %3).</translation></message>
<message><source>The heading does not name as many columns as there are (%1): the first three were taken for x, y and z.</source><translation>L'en-tête ne nomme pas autant de colonnes qu'il y en a (%1) : les trois premières ont été prises pour x, y et z.</translation></message>
<message><source>this is neither text nor any scan format that is known</source><translation>ceci n'est ni du texte ni un format de scan connu</translation></message>
<message><source>begins a further list, behind the %1 of the first</source><translation>commence une autre liste, derrière les %1 de la première</translation></message>
<message><source>save each scan in a file of its own</source><translation>enregistrez chaque scan dans un fichier à part</translation></message>
<message><source>holds %1 where a point needs %2</source><translation>contient %1 là où un point en demande %2</translation></message>
<message><source>the file may be cut off here, copy it again</source><translation>le fichier est peut-être coupé ici, copiez-le à nouveau</translation></message>
<message><source>promises %1 and holds %2</source><translation>annonce %1 et contient %2</translation></message>
<message><source>scan %1 of this PTX file promises %2 of %3, and the file ends before them</source><translation>le scan %1 de ce fichier PTX annonce %2 de %3, et le fichier finit avant</translation></message>
<message><source>behind the %1 of %2 that the header promises there are more</source><translation>derrière les %1 de %2 que l'en-tête annonce, il y en a d'autres</translation></message>
<message><source>scan %1 has no PTX header here</source><translation>le scan %1 n'a pas d'en-tête PTX ici</translation></message>
<message><source>the scan of this PTX file holds 0 points</source><translation>le scan de ce fichier PTX contient 0 point</translation></message>
<message><source>the %1 scans of this PTX file hold 0 points</source><translation>les %1 scans de ce fichier PTX contiennent 0 point</translation></message>
<message><source>the header promises %1 and the file holds %2</source><translation>l'en-tête annonce %1 et le fichier contient %2</translation></message>
<message><source>The matrix of the header has the scanner's place in its last column and not in its last row: it was read by columns.</source><translation>La matrice de l'en-tête a la place du scanner dans sa dernière colonne et non dans sa dernière rangée : elle a été lue par colonnes.</translation></message>
<message><source>Lines 4 to 6 of the header turn the scanner to another side than its matrix: the matrix was used.</source><translation>Les lignes 4 à 6 de l'en-tête tournent le scanner d'un autre côté que sa matrice : la matrice a été utilisée.</translation></message>
<message><source>Line 3 of the header puts the scanner %1 m from the place that its matrix gives: the matrix was used.</source><translation>La ligne 3 de l'en-tête met le scanner à %1 m de la place que donne sa matrice : la matrice a été utilisée.</translation></message>
<message><source>Behind the last of these scans there is text that is none.</source><translation>Derrière le dernier de ces scans il y a du texte qui n'en est pas un.</translation></message>
<message><source>PTX holds one point per cell, and points behind the nearest of their cell were asked for</source><translation>PTX contient un point par cellule, et les points derrière le plus proche de leur cellule ont été demandés</translation></message>
<message><source>use .pcd, .ply, .csv, .xyz, .las or .obj for them</source><translation>utilisez pour eux .pcd, .ply, .csv, .xyz, .las ou .obj</translation></message>
<message><source>column %1 holds %2, so this is not a table of ranges</source><translation>la colonne %1 contient %2, ce n'est donc pas un tableau de distances</translation></message>
<message><source>for a list of points call its columns x, y and z in a first row, and leave out --beam-step and --line-step</source><translation>pour une liste de points, nommez ses colonnes x, y et z dans une première ligne, et laissez de côté --beam-step et --line-step</translation></message>
<message><source>; or save it with a row per scan line: it has as many rows as an LMS511 has beams</source><translation> ; ou enregistrez-le avec une rangée par ligne : il a autant de rangées qu'un LMS511 a de faisceaux</translation></message>
<message><source>holds %1 where the first line holds %2</source><translation>contient %1 là où la première ligne contient %2</translation></message>
<message><source>%n range</source><translation>%n distance</translation></message>
<message><source>%n ranges</source><translation>%n distances</translation></message>
<message><source>copy or export the file again</source><translation>copiez ou exportez à nouveau le fichier</translation></message>
<message><source>%n column is not ranges, by the header, and not read: %1.</source><translation>%n colonne n'est pas de distances, d'après l'en-tête, et n'a pas été lue : %1.</translation></message>
<message><source>%n columns are not ranges, by the header, and not read: %1.</source><translation>%n colonnes ne sont pas de distances, d'après l'en-tête, et n'ont pas été lues : %1.</translation></message>
<message><source>The angles of the beams were taken from the header: %1 to %2 degrees.</source><translation>Les angles des faisceaux ont été pris de l'en-tête : de %1 à %2 degrés.</translation></message>
<message><source>The angles of the lines were taken from the first column: %1 to %2 degrees.</source><translation>Les angles des lignes ont été pris de la première colonne : de %1 à %2 degrés.</translation></message>
<message><source>Unit taken from a comment of the file: %1 mm per number.</source><translation>Unité prise d'un commentaire du fichier : %1 mm par unité.</translation></message>
<message><source>line %1, beam %2</source><translation>ligne %1, faisceau %2</translation></message>
<message><source> infinite ranges were taken as no return.</source><translation> distances infinies ont été prises comme sans retour.</translation></message>
<message><source> ranges below 0, all the same number, were taken as no return.</source><translation> distances inférieures à 0, toutes le même nombre, ont été prises comme sans retour.</translation></message>
<message><source> ranges longer than any scanner reaches were taken as no return.</source><translation> distances plus longues que la portée de tout scanner ont été prises comme sans retour.</translation></message>
<message><source>%1 holds %2, which is not a range</source><translation>%1 contient %2, qui n'est pas une distance</translation></message>
<message><source>check that these are ranges; points need columns x, y and z</source><translation>vérifiez que ce sont des distances ; des points demandent des colonnes x, y et z</translation></message>
<message><source>cells hold %1 in the numbers of the file</source><translation>cellules contiennent %1 dans les nombres du fichier</translation></message>
<message><source>give %1</source><translation>indiquez %1</translation></message>
<message><source>: those of an LMS511 were taken where none were given (beams from -5 degrees by 1/6 degree, lines from 0 by 0.18 degree, axis spin).</source><translation> : là où ils manquaient, ceux d'un LMS511 ont été pris (faisceaux à partir de -5 degrés par 1/6 de degré, lignes à partir de 0 par 0.18 degré, axe spin).</translation></message>
<message><source>The ranges reach %1 km: check %2.</source><translation>Les distances atteignent %1 km : vérifiez %2.</translation></message>
<message><source>All ranges are below 100 mm, so they may be metres: check %1.</source><translation>Toutes les distances sont inférieures à 100 mm, ce sont donc peut-être des mètres : vérifiez %1.</translation></message>
<message><source>All %1 lines are at one angle: check the step from line to line.</source><translation>Les %1 lignes sont toutes au même angle : vérifiez le pas de ligne à ligne.</translation></message>
<message><source>a table of %1 per line does not say its angles</source><translation>un tableau de %1 par ligne ne dit pas ses angles</translation></message>
<message><source>The table does not say its angles</source><translation>Le tableau ne dit pas ses angles</translation></message>
<message><source>a picture of %1 per line does not say its angles</source><translation>une image de %1 par ligne ne dit pas ses angles</translation></message>
<message><source>The picture does not say its angles</source><translation>L'image ne dit pas ses angles</translation></message>
<message><source>a numpy array of %1 per line does not say its angles</source><translation>un tableau numpy de %1 par ligne ne dit pas ses angles</translation></message>
<message><source>The numpy array does not say its angles</source><translation>Le tableau numpy ne dit pas ses angles</translation></message>
<message><source>%1 lines x %2 beams</source><translation>%1 lignes x %2 faisceaux</translation></message>
<message><source>holds %1 bytes where %2 need %3</source><translation>contient %1 octets là où %2 en demandent %3</translation></message>
<message><source>check lines and beams in the .json file</source><translation>vérifiez les lignes et faisceaux dans le fichier .json</translation></message>
<message><source>"beam_deg" is missing</source><translation>"beam_deg" manque</translation></message>
<message><source>"line_deg" is missing</source><translation>"line_deg" manque</translation></message>
<message><source>"axis" is missing</source><translation>"axis" manque</translation></message>
<message><source>add it to the .json file, or give --beam-start --beam-step --line-start --line-step --axis</source><translation>ajoutez-le au fichier .json, ou indiquez --beam-start --beam-step --line-start --line-step --axis</translation></message>
<message><source>"%1" is not a key of a raw grid and was not used: check its spelling.</source><translation>"%1" n'est pas une clé d'une grille brute et n'a pas été utilisé : vérifiez son orthographe.</translation></message>
<message><source>the file names the counts of missing returns</source><translation>le fichier indique les comptes des retours manquants</translation></message>
<message><source>The data file %1 is missing; %2 was read in its place.</source><translation>Le fichier de données %1 manque ; %2 a été lu à sa place.</translation></message>
<message><source>counts alone are not a raw grid</source><translation>des comptes seuls ne sont pas une grille brute</translation></message>
<message><source>give the description before them</source><translation>donnez la description avant eux</translation></message>
<message><source>these counts need their description %1 next to them, and it cannot be read</source><translation>ces valeurs demandent leur description %1 à côté d'elles, et elle est illisible</translation></message>
<message><source>copy it into the same folder</source><translation>copiez-la dans le même dossier</translation></message>
<message><source>save it as PCD, which carries every scan</source><translation>enregistrez-le en PCD, qui admet tout scan</translation></message>
<message><source>a raw grid needs beam and line angles and this cloud has none</source><translation>une grille brute demande des angles de faisceaux et de lignes et ce nuage n'en a pas</translation></message>
<message><source>a raw grid holds whole counts of its unit up to 65535, and the range at %1 is none or means no return</source><translation>une grille brute contient des comptes entiers de son unité jusqu'à 65535, et la distance en %1 n'en est pas un ou signifie sans retour</translation></message>
<message><source>%1, and %2</source><translation>%1, et %2</translation></message>
<message><source>a point of a string needs its number, northing, easting and elevation</source><translation>un point d'une chaîne demande son numéro, son nord, son est et son altitude</translation></message>
<message><source>copy the file again, it may be cut off or damaged here</source><translation>copiez à nouveau le fichier, il est peut-être coupé ou endommagé ici</translation></message>
<message><source>a Surpac string file is text, and this is none</source><translation>un fichier de chaînes de Surpac est du texte, et celui-ci n'en est pas</translation></message>
<message><source>Surpac strings</source><translation>Polylignes Surpac</translation></message>
<message><source>this Surpac file has no points</source><translation>ce fichier Surpac n'a pas de points</translation></message>
<message><source>The file does not end with END: it may have been cut off; compare it with the original.</source><translation>Le fichier ne finit pas par END : il a peut-être été coupé ; comparez-le à l'original.</translation></message>
<message><source>Descriptions of points (D1 and further) are not read.</source><translation>Les descriptions des points (D1 et suivantes) ne sont pas lues.</translation></message>
<message><source>%n line behind END was not read.</source><translation>%n ligne derrière END n'a pas été lue.</translation></message>
<message><source>%n lines behind END were not read.</source><translation>%n lignes derrière END n'ont pas été lues.</translation></message>
<message><source>open the scan as the scanner stored it, or with its record</source><translation>ouvrez le scan tel que le scanner l'a enregistré, ou avec sa fiche</translation></message>
<message><source>finding the axis</source><translation>recherche de l'axe</translation></message>
<message><source>they do not follow each other in scan lines that turn about an axis elsewhere</source><translation>ils ne se suivent pas en lignes qui tournent autour d'un axe ailleurs</translation></message>
<message><source>Each line has every %1th beam only, in turn: %2 lines that follow each other were put side by side.</source><translation>Chaque ligne n'a qu'un faisceau sur %1, à tour de rôle : %2 lignes qui se suivent ont été mises côte à côte.</translation></message>
<message><source>the %1 points do not lie on beam x line angles about the origin:</source><translation>les %1 points ne sont pas sur des angles faisceau x ligne autour de l'origine :</translation></message>
<message><source>about %1 no scan lines can be recognised</source><translation>autour de %1 aucune ligne de scan n'est reconnaissable</translation></message>
<message><source>about %1 %2 % lie on the best %3</source><translation>autour de %1, %2 % sont sur les meilleurs %3</translation></message>
<message><source>%n line angles</source><translation>%n angles de ligne</translation></message>
<message><source>%n beam angles</source><translation>%n angles de faisceau</translation></message>
<message><source> (99 % are needed)</source><translation> (il en faut 99 %)</translation></message>
<message><source>The list was not a full grid in order: %1 lines x %2 beams were recovered from the angles of its points.</source><translation>La liste n'était pas une grille complète en ordre : %1 lignes x %2 faisceaux ont été retrouvés d'après les angles de ses points.</translation></message>
<message><source> lines repeated the line before and were left out.</source><translation> lignes répétaient la ligne précédente et ont été laissées de côté.</translation></message>
<message><source> points stood in the list before, as when a driver stores lines twice, and were taken once.</source><translation> points étaient déjà dans la liste, comme quand un pilote enregistre des lignes deux fois, et ont été pris une fois.</translation></message>
<message><source> lines or beams without any point were put back empty, to keep the steps even.</source><translation> lignes ou faisceaux sans aucun point ont été remis vides, pour garder des pas égaux.</translation></message>
<message><source> points belong to no single cell of the grid (on the rotation axis, or off the grid) and were left out.</source><translation> points n'appartiennent à aucune cellule unique de la grille (sur l'axe de rotation, ou hors de la grille) et ont été laissés de côté.</translation></message>
<message><source> points lay in a cell with a nearer one, which was taken.</source><translation> points étaient dans une cellule avec un point plus proche, qui a été pris.</translation></message>
<message><source>The line angles are uneven: steps from %1 to %2 degrees, kept as they are.</source><translation>Les angles des lignes sont inégaux : pas de %1 à %2 degrés, gardés tels quels.</translation></message>
<message><source>The lines turn about the file's y axis, which became z: x is the file's z, y its x, z its y.</source><translation>Les lignes tournent autour de l'axe y du fichier, devenu z : x est le z du fichier, y son x, z son y.</translation></message>
<message><source>holds %1 with a return, too few to find a scanner's grid</source><translation>contient %1 avec retour, trop peu pour trouver la grille d'un scanner</translation></message>
<message><source>check that the file is complete</source><translation>vérifiez que le fichier est complet</translation></message>
<message><source>holds more points than can be put on a grid</source><translation>contient plus de points qu'une grille ne peut en recevoir</translation></message>
<message><source>split the file</source><translation>divisez le fichier</translation></message>
<message><source>finding the grid</source><translation>recherche de la grille</translation></message>
<message><source>open the scan as the scanner stored it, with its origin at the scanner</source><translation>ouvrez le scan tel que le scanner l'a enregistré, avec l'origine au scanner</translation></message>
<message><source>%1 x %2 degrees</source><translation>%1 x %2 degrés</translation></message>
<message><source>cells of %1 degrees over %2 would be %3 million cells</source><translation>des cellules de %1 degrés sur %2 feraient %3 millions de cellules</translation></message>
<message><source>give a larger --grid-step</source><translation>indiquez un --grid-step plus grand</translation></message>
<message><source>all %1 points lie in one direction from there, within %2 and %3 to %4 away</source><translation>les %1 points sont tous dans une seule direction depuis là, dans %2 et à %3 à %4</translation></message>
<message><source>%n point in, seen over %1 x %2 degrees; %3 of %4 cells filled (fill ratio %5 %; of the cells around a filled one %6 %), %7 attached to a cell with a nearer one</source><translation>%n point pris, vu sur %1 x %2 degrés ; %3 de %4 cellules remplies (taux de remplissage %5 % ; des cellules autour d'une remplie %6 %), %7 rattaché à une cellule qui en a un plus proche</translation></message>
<message><source>%n points in, seen over %1 x %2 degrees; %3 of %4 cells filled (fill ratio %5 %; of the cells around a filled one %6 %), %7 attached to a cell with a nearer one</source><translation>%n points pris, vus sur %1 x %2 degrés ; %3 de %4 cellules remplies (taux de remplissage %5 % ; des cellules autour d'une remplie %6 %), %7 rattachés à une cellule qui en a un plus proche</translation></message>
<message><source>%n point far from all others left out</source><translation>%n point loin de tous les autres laissé de côté</translation></message>
<message><source>%n points far from all others left out</source><translation>%n points loin de tous les autres laissés de côté</translation></message>
<message><source>a grid step of %1 degrees makes no grid</source><translation>un pas de grille de %1 degrés ne donne pas de grille</translation></message>
<message><source>give --grid-step between 0 and 45 degrees</source><translation>indiquez --grid-step entre 0 et 45 degrés</translation></message>
<message><source>only %1 a return, too few to make a grid of them</source><translation>seulement %1 un retour, trop peu pour en faire une grille</translation></message>
<message><source>%n point has</source><translation>%n point a</translation></message>
<message><source>%n points have</source><translation>%n points ont</translation></message>
<message><source>projecting the points</source><translation>projection des points</translation></message>
<message><source>seen from there the points make no picture: %1</source><translation>vus de là, les points ne font pas d'image : %1</translation></message>
<message><source>give a larger --grid-step, or another --sensor</source><translation>indiquez un --grid-step plus grand, ou un autre --sensor</translation></message>
<message><source>The file lists only points: </source><translation>Le fichier ne contient que des points : </translation></message>
<message><source>give --sensor X,Y,Z, the place in metres that the scan was taken from</source><translation>indiquez --sensor X,Y,Z,, la place en mètres d'où le scan a été pris</translation></message>
<message><source>Unit taken as millimetres</source><translation>Unité prise en millimètres</translation></message>
<message><source>Unit taken as centimetres</source><translation>Unité prise en centimètres</translation></message>
<message><source>Unit taken as metres</source><translation>Unité prise en mètres</translation></message>
<message><source>Ranges beyond 1,000 m: if the file is in millimetres, give --unit mm.</source><translation>Distances de plus de 1 000 m : si le fichier est en millimètres, donnez --unit mm.</translation></message>
<message><source>, in which every range is a whole number of millimetres.</source><translation>, unité dans laquelle chaque distance est un nombre entier de millimètres.</translation></message>
<message><source>, from the size of the numbers.</source><translation>, d'après la grandeur des nombres.</translation></message>
<message><source>a recording is being written already</source><translation>un enregistrement est déjà en cours</translation></message>
<message><source>stop it first</source><translation>arrêtez-le d'abord</translation></message>
<message><source> ranges are range_min or range_max of their messages, repeat, and were taken as no return.</source><translation> distances sont le range_min ou le range_max de leurs messages, se répètent et ont été prises comme sans retour.</translation></message>
<message><source>no return </source><translation>sans retour </translation></message>
<message><source>sweep complete</source><translation>balayage complet</translation></message>
<message><source>sweep ended</source><translation>balayage terminé</translation></message>
<message><source>window clean</source><translation>fenêtre propre</translation></message>
<message><source> earlier in this sweep</source><translation> plus tôt dans ce balayage</translation></message>
<message><source> scan telegrams since the start could not be decoded, so their lines are lost: </source><translation> télégrammes de scan depuis le début n'ont pas pu être décodés, leurs lignes sont donc perdues : </translation></message>
<message><source> bytes since the start were not a telegram and were skipped.</source><translation> octets depuis le début n'étaient pas un télégramme et ont été sautés.</translation></message>
<message><source>The sweep has ended; no line has come since.</source><translation>Le balayage est terminé ; aucune ligne n'est arrivée depuis.</translation></message>
<message><source>device ok</source><translation>appareil en ordre</translation></message>
<message><source>DEVICE ERROR earlier in this sweep</source><translation>ERREUR DE L'APPAREIL plus tôt dans ce balayage</translation></message>
<message><source>pose of unknown age</source><translation>pose d'âge inconnu</translation></message>
<message><source>beam %1 of %2 would be at %3 degrees</source><translation>le faisceau %1 de %2 serait à %3 degrés</translation></message>
<message><source>line %1 of %2 would be at %3 degrees</source><translation>la ligne %1 de %2 serait à %3 degrés</translation></message>
<message><source>give angles from %1 to %2 degrees</source><translation>indiquez des angles de %1 à %2 degrés</translation></message>
<message><source>a calibration alone gives no place</source><translation>un étalonnage seul ne donne pas de place</translation></message>
<message><source>give --pose POSE.json too</source><translation>indiquez aussi --pose POSE.json</translation></message>
<message><source>the format %1 does not have it</source><translation>le format %1 ne l'a pas</translation></message>
<message><source>%1 points lie farther than %2 from the sensor and were taken as no return: --sensor X,Y,Z says where it stood.</source><translation>%1 points sont à plus de %2 du capteur et ont été pris comme sans retour : --sensor X,Y,Z dit où il se trouvait.</translation></message>
<message><source>%1 cannot be a measured %2: %3 to %4</source><translation>%1 ne peut pas être une valeur mesurée de %2 : de %3 à %4</translation></message>
<message><source>%1 at %5 cannot be a measured %2: %3 to %4</source><translation>%1 à %5 ne peut pas être une valeur mesurée de %2 : de %3 à %4</translation></message>
<message><source>check the unit and the numbers of the file</source><translation>vérifiez l'unité et les nombres du fichier</translation></message>
<message><source>beam %1</source><translation>faisceau %1</translation></message>
<message><source>line %1</source><translation>ligne %1</translation></message>
<message><source>the skew of beam %1</source><translation>le décalage du faisceau %1</translation></message>
<message><source>all %1 beams look the same way</source><translation>les %1 faisceaux regardent tous dans la même direction</translation></message>
<message><source>give the step from beam to beam</source><translation>indiquez le pas de faisceau à faisceau</translation></message>
<message><source>all points are within %1 m of each other and at least %2 m away from the scanner, which no scanner measures</source><translation>tous les points sont à moins de %1 m les uns des autres et à %2 m au moins du scanner, ce qu'aucun scanner ne mesure</translation></message>
<message><source>give --sensor X,Y,Z, the place in metres that the scan was taken from, or check --unit</source><translation>indiquez --sensor X,Y,Z, la place en mètres d'où le scan a été pris, ou vérifiez --unit</translation></message>
<message><source>The sensor's place was found from the ranges that the file holds with its points.</source><translation>La place du capteur a été trouvée d'après les distances que le fichier contient avec ses points.</translation></message>
<message><source>The columns of lines and beams hold no grid and were not used.</source><translation>Les colonnes des lignes et des faisceaux ne forment pas de grille et n'ont pas été utilisées.</translation></message>
<message><source>too few points</source><translation>trop peu de points</translation></message>
<message><source>left-handed points</source><translation>des points de repère indirect</translation></message>
<message><source>their scan lines turn about another axis than --axis says</source><translation>leurs lignes de scan tournent autour d'un autre axe que celui de --axis</translation></message>
<message><source>their scan lines turn about an axis through the origin</source><translation>leurs lignes de scan tournent autour d'un axe qui passe par l'origine</translation></message>
<message><source>another grid</source><translation>une autre grille</translation></message>
<message><source>about the axis of their scan lines they are on no common beams</source><translation>autour de l'axe de leurs lignes de scan ils ne sont pas sur des faisceaux communs</translation></message>
<message><source>Lines and beams were exchanged: only that way the lines make fans about one axis.</source><translation>Les lignes et les faisceaux ont été échangés : c'est seulement ainsi que les lignes forment des éventails autour d'un axe.</translation></message>
<message><source>The rows of the file make no fans about one axis as they are stored: %1, and only that way the lines make fans.</source><translation>Les rangées du fichier, telles quelles, ne forment pas d'éventails autour d'un axe : %1, et c'est seulement ainsi que les lignes forment des éventails.</translation></message>
<message><source>they were taken as beams, and the columns as lines</source><translation>elles ont été prises comme faisceaux, et les colonnes comme lignes</translation></message>
<message><source>its counts of rows and columns were exchanged</source><translation>ses nombres de lignes et de colonnes ont été échangés</translation></message>
<message><source>its points were taken row by row, where the header says column by column</source><translation>ses points ont été pris ligne par ligne, là où l'en-tête dit colonne par colonne</translation></message>
<message><source>No cell of this scan has a range that was measured: check the file, the topic and the limits of the range.</source><translation>Aucune cellule de ce scan n'a de distance mesurée : vérifiez le fichier, le topic et les limites de distance.</translation></message>
<message><source>this folder holds several scans</source><translation>ce dossier contient plusieurs scans</translation></message>
<message><source>open one of them, or use edgescan-cli batch</source><translation>ouvrez l'un d'eux, ou utilisez edgescan-cli batch</translation></message>
<message><source>The pose in %1 replaces that in %2.</source><translation>La pose de %1 remplace celle de %2.</translation></message>
<message><source>The folder holds %1 besides this recording: name one file, or use edgescan-cli batch.</source><translation>Le dossier contient %1 en plus de cet enregistrement : nommez un fichier, ou utilisez edgescan-cli batch.</translation></message>
<message><source>%n scan</source><translation>%n scan</translation></message>
<message><source>%n scans</source><translation>%n scans</translation></message>
<message><source>a cell has the state %1, which does not exist</source><translation>une cellule a l'état %1, qui n'existe pas</translation></message>
<message><source>describes %1 and holds %2</source><translation>décrit %1 et contient %2</translation></message>
<message><source>describes %1 but has no columns range_mm and state</source><translation>décrit %1 mais n'a pas les colonnes range_mm et state</translation></message>
<message><source>save the scan again, or remove the comment lines</source><translation>enregistrez à nouveau le scan, ou supprimez les lignes de commentaire</translation></message>
<message><source>--unit does not apply: this program saved the file, in metres</source><translation>--unit ne s'applique pas : ce programme a enregistré le fichier, en mètres</translation></message>
<message><source>leave --unit out</source><translation>laissez --unit de côté</translation></message>
<message><source>a valid cell has a number that is not a range</source><translation>une cellule valide a un nombre qui n'est pas une distance</translation></message>
<message><source>the description in the comment lines has no angles</source><translation>la description dans les lignes de commentaire n'a pas d'angles</translation></message>
<message><source>%n point was filled and not measured, as filled_sd_mm says: it was taken as no return.</source><translation>%n point a été comblé et non mesuré, comme le dit filled_sd_mm : il a été pris comme sans retour.</translation></message>
<message><source>%n points were filled and not measured, as filled_sd_mm says: they were taken as no return.</source><translation>%n points ont été comblés et non mesurés, comme le dit filled_sd_mm : ils ont été pris comme sans retour.</translation></message>
<message><source>the file gives the grid of its cells</source><translation>le fichier donne la grille de ses cellules</translation></message>
<message><source>The matrix of the %1 file was not used: its points are in another frame than the scanner's.</source><translation>La matrice du fichier %1 n'a pas été utilisée : ses points sont dans un autre repère que celui du scanner.</translation></message>
<message><source>%1 cells hold status codes of an LMS2xx from %2 on instead of a range and were taken as such.</source><translation>%1 cellules contiennent des codes d'état d'un LMS2xx à partir de %2 au lieu d'une distance et ont été prises comme telles.</translation></message>
<message><source>The coordinates are rounded, and every point fits a whole number of millimetres along its beam: these were taken as ranges.</source><translation>Les coordonnées sont arrondies et chaque point tombe à un nombre entier de millimètres sur son faisceau : ceux-ci ont été pris comme distances.</translation></message>
<message><source>The file's coordinates are left-handed and were turned right-handed: y is mirrored.</source><translation>Les coordonnées du fichier forment un repère indirect et ont été rendues directes : y est inversé.</translation></message>
<message><source>%1 of %2 cells of the grid that was found have no point and count as no return.</source><translation>%1 de %2 cellules de la grille trouvée n'ont pas de point et comptent comme sans retour.</translation></message>
<message><source>the origin, because no sensor position is known (--sensor X,Y,Z gives it)</source><translation>l'origine, car aucune position du capteur n'est connue (--sensor X,Y,Z la donne)</translation></message>
<message><source>the sensor position given, (%1, %2, %3) m</source><translation>la position du capteur indiquée, (%1, %2, %3) m</translation></message>
<message><source>the sensor position in the file, (%1, %2, %3) m</source><translation>la position du capteur dans le fichier, (%1, %2, %3) m</translation></message>
<message><source>The points lie on no scanner grid and were projected about %1: %2.</source><translation>Les points ne sont sur aucune grille de scanner et ont été projetés autour de %1 : %2.</translation></message>
<message><source>The points were projected about %1: %2.</source><translation>Les points ont été projetés autour de %1 : %2.</translation></message>
<message><source>The cells have the given %1 degrees</source><translation>Les cellules ont les %1 degrés donnés</translation></message>
<message><source>The cells have %1 degrees, from the spacing of the points</source><translation>Les cellules ont %1 degrés, d'après l'écart des points</translation></message>
<message><source>, along lines that were recognised in the cloud.</source><translation>, le long de lignes reconnues dans le nuage.</translation></message>
<message><source>Edges of a projected cloud differ from those of its scan: a file with the points in the order of the scanner, or with its record, has the grid of the scan.</source><translation>Les arêtes d'un nuage projeté diffèrent de celles de son scan : un fichier avec les points dans l'ordre du scanner, ou avec sa fiche, a la grille du scan.</translation></message>
<message><source>projected about %1: %2</source><translation>projetés autour de %1 : %2</translation></message>
<message><source>The axis of the scan lines is %1 (in the numbers of the file) from the sensor position that was known.</source><translation>L'axe des lignes du scan est à %1 (dans les nombres du fichier) de la position connue du capteur.</translation></message>
<message><source>%n point is a later return of a pulse, as the file says: the first returns make the grid</source><translation>%n point est un retour ultérieur d'une impulsion, selon le fichier : les premiers retours font la grille</translation></message>
<message><source>%n points are later returns of a pulse, as the file says: the first returns make the grid</source><translation>%n points sont des retours ultérieurs d'une impulsion, selon le fichier : les premiers retours font la grille</translation></message>
<message><source>, and %1</source><translation>, et %1</translation></message>
<message><source>%n other was attached to its cell</source><translation>%n autre a été rattaché à sa cellule</translation></message>
<message><source>%n others were attached to their cells</source><translation>%n autres ont été rattachés à leurs cellules</translation></message>
<message><source>%n other has no cell of its own and was left out</source><translation>%n autre n'a pas de cellule à lui et a été laissé de côté</translation></message>
<message><source>%n others have no cell of their own and were left out</source><translation>%n autres n'ont pas de cellule à eux et ont été laissés de côté</translation></message>
<message><source>%1 lines, %2 beams and mounting %3 were found from them.</source><translation>%1 lignes, %2 faisceaux et le montage %3 ont été trouvés à partir d'eux.</translation></message>
<message><source>--unit does not apply: the file holds ranges that give the unit of its points</source><translation>--unit ne s'applique pas : le fichier contient des distances qui donnent l'unité de ses points</translation></message>
<message><source>the last scan line is not complete and the last row has no line end: the file was cut off</source><translation>la dernière ligne du scan est incomplète et la dernière rangée n'a pas de fin de ligne : le fichier a été coupé</translation></message>
<message><source>the file is in another frame than the scanner's, and %1 of its points share their line and beam with another</source><translation>le fichier est dans un autre repère que celui du scanner, et %1 de ses points partagent leur ligne et leur faisceau avec un autre</translation></message>
<message><source>The grid has as many lines and beams as the points name, %1 x %2: a line or beam behind the last point is not in the file.</source><translation>La grille a autant de lignes et de faisceaux que les points en nomment, %1 x %2 : une ligne ou un faisceau derrière le dernier point n'est pas dans le fichier.</translation></message>
<message><source>the points have a grid</source><translation>les points ont une grille</translation></message>
<message><source>The list holds returns only: a line or beam at the border without any return is not in it.</source><translation>La liste ne contient que des retours : une ligne ou un faisceau du bord sans aucun retour n'y est pas.</translation></message>
<message><source>points are one and the same,%1</source><translation>points sont un seul et même point,%1</translation></message>
<message><source>points are %1 (in the numbers of the file) from the sensor</source><translation>points sont à %1 (dans les nombres du fichier) du capteur</translation></message>
<message><source>its numbers are rounded to %1, and its points are within %2 of each other</source><translation>ses nombres sont arrondis à %1, et ses points sont à %2 au plus les uns des autres</translation></message>
<message><source>write the coordinates again with all their decimals</source><translation>écrivez à nouveau les coordonnées avec toutes leurs décimales</translation></message>
<message><source>its numbers were rounded to %1 digits, so that those near %2 step by %3: the digits that place the points are lost</source><translation>ses nombres ont été arrondis à %1 chiffres, si bien que ceux proches de %2 avancent par pas de %3 : les chiffres qui placent les points sont perdus</translation></message>
<message><source>write the coordinates again with all their decimals, as numbers and not in the form 1.23E+06</source><translation>réécrivez les coordonnées avec toutes leurs décimales, en nombres et non sous la forme 1.23E+06</translation></message>
<message><source>%1 numbers per line without names are a table of ranges only with its angles; as points, %2</source><translation>%1 nombres par ligne sans noms ne font un tableau de distances qu'avec ses angles ; comme points, %2</translation></message>
<message><source>give --beam-start --beam-step --line-start --line-step --axis, or name the columns x, y and z</source><translation>indiquez --beam-start --beam-step --line-start --line-step --axis, ou nommez les colonnes x, y et z</translation></message>
<message><source>%1 of the %2 of the file have no cell of their own.</source><translation>%1 des %2 du fichier n'ont pas de cellule à eux.</translation></message>
<message><source>the file holds 0 points with a return, out of %1</source><translation>le fichier contient 0 point avec retour, sur %1</translation></message>
<message><source>choose another file, or copy it again</source><translation>choisissez un autre fichier, ou copiez-le à nouveau</translation></message>
<message><source>Numbers up to %1 in this file have a resolution of about %2: it was written with 4-byte floats.</source><translation>Dans ce fichier, les nombres jusqu'à %1 ont une résolution d'environ %2 : il a été écrit avec des flottants de 4 octets.</translation></message>
<message><source>%n point with infinite or absurdly large coordinates was taken as no return.</source><translation>%n point aux coordonnées infinies ou absurdement grandes a été pris comme sans retour.</translation></message>
<message><source>%n points with infinite or absurdly large coordinates were taken as no return.</source><translation>%n points aux coordonnées infinies ou absurdement grandes ont été pris comme sans retour.</translation></message>
<message><source>the pose could not be removed (%1)</source><translation>la pose n'a pas pu être retirée (%1)</translation></message>
<message><source>remove the file by hand</source><translation>supprimez le fichier à la main</translation></message>
<message><source>the file name has no extension that names a format</source><translation>le nom du fichier n'a pas d'extension qui nomme un format</translation></message>
<message><source>"%1" is not a format that can be written</source><translation>« %1 » n'est pas un format qui peut être écrit</translation></message>
<message><source>use %1</source><translation>utilisez %1</translation></message>
<message><source>the edge mask has %1 x %2 cells and the scan %3 x %4</source><translation>le masque des arêtes a %1 x %2 cellules et le scan %3 x %4</translation></message>
<message><source>detect the edges of this scan again</source><translation>détectez à nouveau les arêtes de ce scan</translation></message>
<message><source>the scan has no pose, so its place in the mine grid is not known</source><translation>le scan n'a pas de pose, sa place dans la grille de la mine n'est donc pas connue</translation></message>
<message><source>give a pose and the robot's calibration, or save in the scanner's frame</source><translation>donnez une pose et l'étalonnage du robot, ou enregistrez dans le repère du scanner</translation></message>
<message><source>the scan has no cells</source><translation>le scan n'a pas de cellules</translation></message>
<message><source>a raw grid or a recording holds ranges and no coordinates</source><translation>une grille brute ou un enregistrement contient des distances et pas de coordonnées</translation></message>
<message><source>save it without a frame, or as %1</source><translation>enregistrez-le sans repère, ou en %1</translation></message>
<message><source>%n point behind the nearest of its cell is not in this file: --include-attached saves all points.</source><translation>%n point derrière le plus proche de sa cellule n'est pas dans ce fichier : --include-attached enregistre tous les points.</translation></message>
<message><source>%n points behind the nearest of their cell are not in this file: --include-attached saves all points.</source><translation>%n points derrière le plus proche de leur cellule ne sont pas dans ce fichier : --include-attached enregistre tous les points.</translation></message>
<message><source>The file holds points and no grid: %1 cells without a range are not in it.</source><translation>Le fichier contient des points et pas de grille : %1 cellules sans distance n'y sont pas.</translation></message>
<message><source>This file knows only points and no returns: %1 cells of other states become no returns.</source><translation>Ce fichier ne connaît que des points et des cellules sans retour : %1 cellules d'autres états deviennent sans retour.</translation></message>
<message><source>The file holds numbers only: keep %1.provenance.json next to it, which holds the grid, or write it with --comments.</source><translation>Le fichier ne contient que des nombres : gardez à côté %1.provenance.json, qui contient la grille, ou écrivez-le avec --comments.</translation></message>
<message><source>The file does not hold the intensities: .pcd, .ply, .las, .ptx and .csv do.</source><translation>Le fichier ne contient pas les intensités : .pcd, .ply, .las, .ptx et .csv les contiennent.</translation></message>
<message><source>The file rounds the points to whole steps of %1 mm.</source><translation>Le fichier arrondit les points à des pas entiers de %1 mm.</translation></message>
<message><source>The file is in the scanner's frame and does not hold the scan's place in the mine: --frame mine gives mine coordinates.</source><translation>Le fichier est dans le repère du scanner et ne contient pas la place du scan dans la mine : --frame mine donne des coordonnées de mine.</translation></message>
<message><source>The file has room for one place of the scanner, and this scanner moved by up to %1 mm: without %2.provenance.json its ranges are as much off; its points are exact.</source><translation>Le fichier a de la place pour un seul lieu du scanner, et ce scanner a bougé de jusqu'à %1 mm : sans %2.provenance.json ses distances diffèrent d'autant ; ses points sont exacts.</translation></message>
<message><source>This file is an export of edge points, not a scan: all other cells count as no return. Open the scan to find edges.</source><translation>Ce fichier est un export de points d'arête, pas un scan : toutes les autres cellules comptent comme sans retour. Ouvrez le scan pour chercher les arêtes.</translation></message>
<message><source>was written for another one</source><translation>a été écrit pour un autre</translation></message>
<message><source>describes no grid</source><translation>ne décrit pas de grille</translation></message>
<message><source>does not list the cells of the points</source><translation>n'énumère pas les cellules des points</translation></message>
<message><source>has a grid for which there is not enough memory</source><translation>a une grille pour laquelle il n'y a pas assez de mémoire</translation></message>
<message><source>describes a grid without angles and without a sensor</source><translation>décrit une grille sans angles et sans capteur</translation></message>
<message><source>lists other cells than the file has points</source><translation>énumère d'autres cellules que le fichier n'a de points</translation></message>
<message><source>does not hold the place of the scan in the mine</source><translation>ne contient pas la place du scan dans la mine</translation></message>
<message><source>cannot be read (%1)</source><translation>ne peut pas être lu (%1)</translation></message>
<message><source>The record next to the file %1, so the grid in it was not used.</source><translation>La fiche à côté du fichier ne convient pas (%1) ; sa grille n'a donc pas été utilisée.</translation></message>
<message><source>lists a cell twice</source><translation>énumère une cellule deux fois</translation></message>
<message><source>The file puts the sensor %1 away from its points, which are all within %2 of each other (in its own numbers): no scanner measures so, and the place was not used.</source><translation>Le fichier met le capteur à %1 de ses points, qui sont tous à moins de %2 les uns des autres (dans ses propres nombres) : aucun scanner ne mesure ainsi, et cette place n'a pas été utilisée.</translation></message>
<message><source>the %1 points of its grid lie in one direction from the origin, within %2 degrees and up to %3 away: the scanner stood elsewhere</source><translation>les %1 points de sa grille sont dans une seule direction depuis l'origine, dans %2 degrés et jusqu'à %3 : le scanner était ailleurs</translation></message>
<message><source>Unit taken as metres, in which the numbers fit the sensor position given.</source><translation>Le mètre a été pris comme unité : ainsi les nombres s'accordent avec la position du capteur indiquée.</translation></message>
<message><source>Unit taken as millimetres, in which the numbers fit the sensor position given.</source><translation>Le millimètre a été pris comme unité : ainsi les nombres s'accordent avec la position du capteur indiquée.</translation></message>
<message><source>numbers up to %1 in this file have a resolution of about %2</source><translation>les nombres jusqu'à %1 de ce fichier ont une résolution d'environ %2</translation></message>
<message><source>The text has two bytes per character (UTF-16) and was read as such.</source><translation>Le texte a deux octets par caractère (UTF-16) et a été lu ainsi.</translation></message>
<message><source>The text has four bytes per character (UTF-32) and was read as such.</source><translation>Le texte a quatre octets par caractère (UTF-32) et a été lu ainsi.</translation></message>
<message><source>%n byte of zero (NUL) follows the last row, as a power cut leaves them: rows that were not written are missing.</source><translation>%n octet nul (NUL) suit la dernière rangée, comme après une coupure de courant : les rangées non écrites manquent.</translation></message>
<message><source>%n bytes of zero (NUL) follow the last row, as a power cut leaves them: rows that were not written are missing.</source><translation>%n octets nuls (NUL) suivent la dernière rangée, comme après une coupure de courant : les rangées non écrites manquent.</translation></message>
<message><source>the file holds only zeros (NUL), as a power cut leaves them</source><translation>le fichier ne contient que des zéros (NUL), comme en laisse une coupure de courant</translation></message>
<message><source>copy it again from the scanner</source><translation>copiez-le à nouveau depuis le scanner</translation></message>
<message><source>The matrix in the file is not a rotation and shift, so the scan stays in the scanner's frame.</source><translation>La matrice du fichier n'est pas une rotation et une translation ; le scan reste donc dans le repère du scanner.</translation></message>
<message><source>The %1 file puts the scanner at %2, %3, %4 m, which is not a place on earth, so the scan stays in the scanner's frame.</source><translation>Le fichier %1 met le scanner à %2, %3, %4 m, ce qui n'est pas un lieu sur terre ; le scan reste donc dans le repère du scanner.</translation></message>
<message><source>as the %1 file has it</source><translation>comme l'a le fichier %1</translation></message>
<message><source>the header of %1</source><translation>l'en-tête de %1</translation></message>
<message><source>The place is the one written in the %1 file: whether that is the mine grid, who registered it knows.</source><translation>La place est celle écrite dans le fichier %1 : si c'est la grille de la mine, celui qui l'a recalé le sait.</translation></message>
<message><source>The points are in another frame than the scanner's. Their scan lines turn about one axis, at %1, %2, %3 m, and the mirror is %4 off the axis</source><translation>Les points sont dans un autre repère que celui du scanner. Leurs lignes de scan tournent autour d'un axe, en %1, %2, %3 m, et le miroir est à %4 de l'axe</translation></message>
<message><source>; the grid has the scale %1</source><translation> ; la grille a l'échelle %1</translation></message>
<message><source>%1. The points fit lines and beams within %2.</source><translation>%1. Les points tombent sur des lignes et des faisceaux à %2 près.</translation></message>
<message><source>That is more than the rounding of the numbers explains, %1 mm: ranges may be off, and edges may differ from those of the scan. The record of the file, or the scan as it was measured, has them exactly.</source><translation>C'est plus que ce qu'explique l'arrondi des nombres, %1 mm : des distances peuvent être fausses, et des arêtes différer de celles du scan. La fiche du fichier, ou le scan tel que mesuré, les a exactement.</translation></message>
<message><source>the scan lines of the points</source><translation>les lignes de scan des points</translation></message>
<message><source>The place was found from the scan lines of the points: whether their frame is the mine grid, the file does not say.</source><translation>La place a été trouvée à partir des lignes de scan des points : le fichier ne dit pas si leur repère est la grille de la mine.</translation></message>
<message><source>copy the capture again</source><translation>copiez à nouveau la capture</translation></message>
<message><source>the capture ends within its header</source><translation>la capture finit dans son en-tête</translation></message>
<message><source>is too short for a packet</source><translation>est trop court pour un paquet</translation></message>
<message><source>names an interface that the capture does not describe</source><translation>nomme une interface que la capture ne décrit pas</translation></message>
<message><source>promises more bytes of a packet than it has</source><translation>annonce plus d'octets d'un paquet qu'il n'en a</translation></message>
<message><source>a block of this PCAPNG capture %1</source><translation>un bloc de cette capture PCAPNG %1</translation></message>
<message><source>says that it has %1 bytes</source><translation>dit qu'il a %1 octets</translation></message>
<message><source>is too short for an interface</source><translation>est trop court pour une interface</translation></message>
<message><source>this is not a capture of network packets</source><translation>ce n'est pas une capture de paquets réseau</translation></message>
<message><source>The capture was cut off: everything up to the cut is here.</source><translation>La capture a été coupée : tout jusqu'à la coupure est là.</translation></message>
<message><source>%n packet has a time before 1970 or after 2262 and count as of 1970.</source><translation>%n paquet a une heure avant 1970 ou après 2262 et compte comme de 1970.</translation></message>
<message><source>%n packets have a time before 1970 or after 2262 and count as of 1970.</source><translation>%n paquets ont une heure avant 1970 ou après 2262 et comptent comme de 1970.</translation></message>
<message><source>%n byte that the scanner sent is missing in the capture, in %1: the telegrams there are lost.</source><translation>%n octet envoyé par le scanner manque dans la capture (%1) : les télégrammes y sont perdus.</translation></message>
<message><source>%n bytes that the scanner sent are missing in the capture, in %1: the telegrams there are lost.</source><translation>%n octets envoyés par le scanner manquent dans la capture (%1) : les télégrammes y sont perdus.</translation></message>
<message><source>%n place</source><translation>%n endroit</translation></message>
<message><source>%n places</source><translation>%n endroits</translation></message>
<message><source>%n byte that the scanner sent belongs to no whole telegram.</source><translation>%n octet envoyé par le scanner n'appartient à aucun télégramme entier.</translation></message>
<message><source>%n bytes that the scanner sent belong to no whole telegram.</source><translation>%n octets envoyés par le scanner n'appartiennent à aucun télégramme entier.</translation></message>
<message><source>%n packet came out of order and %1 brought bytes again; they were put in order.</source><translation>%n paquet est arrivé dans le désordre et %1 ont apporté des octets à nouveau ; ils ont été remis en ordre.</translation></message>
<message><source>%n packets came out of order and %1 brought bytes again; they were put in order.</source><translation>%n paquets sont arrivés dans le désordre et %1 ont apporté des octets à nouveau ; ils ont été remis en ordre.</translation></message>
<message><source>%n fragment of IP packets were not put together.</source><translation>%n fragment de paquets IP n'a pas été assemblé.</translation></message>
<message><source>%n fragments of IP packets were not put together.</source><translation>%n fragments de paquets IP n'ont pas été assemblés.</translation></message>
<message><source>putting packets together</source><translation>assemblage des paquets</translation></message>
<message><source>this capture holds no scan telegram of a SICK scanner, and %1</source><translation>cette capture ne contient aucun télégramme de scan d'un scanner SICK, et %1</translation></message>
<message><source>this capture holds %1, %2 of them TCP, and no scan telegram of a SICK scanner and no packet of a VLP-16 or an Ouster</source><translation>cette capture contient %1, dont %2 TCP, et aucun télégramme de scan d'un scanner SICK ni aucun paquet d'un VLP-16 ou d'un Ouster</translation></message>
<message><source>%n packet</source><translation>%n paquet</translation></message>
<message><source>%n packets</source><translation>%n paquets</translation></message>
<message><source>capture the connection to the scanner's port (2111 or 2112) while it scans</source><translation>capturez la connexion au port du scanner (2111 ou 2112) pendant qu'il scanne</translation></message>
<message><source>%n other sender has some too</source><translation>%n autre émetteur en a aussi</translation></message>
<message><source>%n other senders have some too</source><translation>%n autres émetteurs en ont aussi</translation></message>
<message><source>The capture holds %1 streams; that of %2 with %3 was opened, and %4.</source><translation>La capture contient %1 flux ; celui de %2 avec %3 a été ouvert, et %4.</translation></message>
<message><source>The capture holds %1 streams; that of %2 with %3 was opened.</source><translation>La capture contient %1 flux ; celui de %2 avec %3 a été ouvert.</translation></message>
<message><source>%n scan telegram</source><translation>%n télégramme de scan</translation></message>
<message><source>%n scan telegrams</source><translation>%n télégrammes de scan</translation></message>
<message><source>finding telegrams</source><translation>recherche des télégrammes</translation></message>
<message><source>these are %1 of a SICK device and none is a scan</source><translation>ce sont %1 d'un appareil SICK et aucun n'est un scan</translation></message>
<message><source>%n telegram</source><translation>%n télégramme</translation></message>
<message><source>%n telegrams</source><translation>%n télégrammes</translation></message>
<message><source>capture while the scanner sends scans (sEN LMDscandata 1)</source><translation>capturez pendant que le scanner envoie des scans (sEN LMDscandata 1)</translation></message>
<message><source>CoLa stream</source><translation>Flux CoLa</translation></message>
<message><source>%n byte of the stream belongs to no whole telegram.</source><translation>%n octet du flux n'appartient à aucun télégramme entier.</translation></message>
<message><source>%n bytes of the stream belong to no whole telegram.</source><translation>%n octets du flux n'appartiennent à aucun télégramme entier.</translation></message>
<message><source>radians</source><translation>radians</translation></message>
<message><source>hundredths of a degree</source><translation>centièmes de degré</translation></message>
<message><source>thousandths of a degree</source><translation>millièmes de degré</translation></message>
<message><source>milliradians</source><translation>milliradians</translation></message>
<message><source>%1 (azimuth) and %2 (elevation)</source><translation>%1 (azimut) et %2 (élévation)</translation></message>
<message><source>angles in %1, azimuths %2</source><translation>des angles en %1, des azimuts %2</translation></message>
<message><source>angles taken as %1, azimuths %2</source><translation>des angles pris comme %1, des azimuts %2</translation></message>
<message><source>clockwise from y</source><translation>dans le sens horaire depuis y</translation></message>
<message><source>counter-clockwise from x</source><translation>dans le sens antihoraire depuis x</translation></message>
<message><source>Points were computed from the columns of angles and ranges, with %1 and heights from the zenith.</source><translation>Les points ont été calculés à partir des colonnes d'angles et de distances, avec %1 et des hauteurs depuis le zénith.</translation></message>
<message><source>Points were computed from the columns of angles and ranges, with %1.</source><translation>Les points ont été calculés à partir des colonnes d'angles et de distances, avec %1.</translation></message>
<message><source>degrees of latitude and longitude</source><translation>degrés de latitude et de longitude</translation></message>
<message><source>angles and no ranges</source><translation>des angles et pas de distances</translation></message>
<message><source>angles and ranges</source><translation>des angles et des distances</translation></message>
<message><source>two coordinates of a point and not the third</source><translation>deux coordonnées d'un point et pas la troisième</translation></message>
<message><source>compare it with docs/reference/formats.md, "Raw grid"</source><translation>comparez-le avec docs/reference/formats.md, "Raw grid"</translation></message>
<message><source>this is a drawing of rocks (GeoJSON) and not a scan</source><translation>ceci est un dessin de rochers (GeoJSON) et non un scan</translation></message>
<message><source>open its scan</source><translation>ouvrez son scan</translation></message>
<message><source>this is a preset and not a scan</source><translation>ceci est un préréglage et non un scan</translation></message>
<message><source>choose it in the panel Edges, or give it with --preset</source><translation>choisissez-le dans le panneau Arêtes, ou donnez-le avec --preset</translation></message>
<message><source>this is a report of detect and not a scan</source><translation>ceci est un rapport de detect et non un scan</translation></message>
<message><source>this is a report of rocks and not a scan</source><translation>ceci est un rapport de rocks et non un scan</translation></message>
<message><source>this is a pose and not a scan</source><translation>ceci est une pose et non un scan</translation></message>
<message><source>open its scan and give it with --pose</source><translation>ouvrez son scan et donnez-le avec --pose</translation></message>
<message><source>this is a calibration and not a scan</source><translation>ceci est un étalonnage et non un scan</translation></message>
<message><source>open its scan and give it with --calibration</source><translation>ouvrez son scan et donnez-le avec --calibration</translation></message>
<message><source>this is a file of targets and not a scan</source><translation>ceci est un fichier de cibles et non un scan</translation></message>
<message><source>this is edits of rocks and not a scan</source><translation>ceci est une modification de roches et non un scan</translation></message>
<message><source>open its scan, or give it with --edits</source><translation>ouvrez son scan, ou donnez-les avec --edits</translation></message>
<message><source>this is a record of an export and not a scan</source><translation>ceci est un compte rendu d'export et non un scan</translation></message>
<message><source>open its scan, or check it with edgescan-cli verify</source><translation>ouvrez son scan, ou vérifiez-le avec edgescan-cli verify</translation></message>
<message><source>must hold counts</source><translation>doit contenir des comptes</translation></message>
<message><source>holds %1, and there are %2</source><translation>contient %1, et il y en a %2</translation></message>
<message><source>needs start and step</source><translation>demande start et step</translation></message>
<message><source>holds %1, %2 are needed</source><translation>contient %1, il en faut %2</translation></message>
<message><source>%n angle</source><translation>%n angle</translation></message>
<message><source>%n angles</source><translation>%n angles</translation></message>
<message><source>must be 1 or -1</source><translation>doit être 1 ou -1</translation></message>
<message><source>must be a list</source><translation>doit être une liste</translation></message>
<message><source>must hold ["state", first cell, cells]</source><translation>doit contenir ["state", première cellule, cellules]</translation></message>
<message><source>leaves the grid</source><translation>sort de la grille</translation></message>
<message><source>names cell %1 twice</source><translation>nomme deux fois la cellule %1</translation></message>
<message><source>must name a file in the same folder</source><translation>doit nommer un fichier du même dossier</translation></message>
<message><source>save the scan again, or remove "acquisition"</source><translation>enregistrez à nouveau le scan, ou supprimez "acquisition"</translation></message>
<message><source>"acquisition" must be an object {...}</source><translation>"acquisition" doit être un objet {...}</translation></message>
<message><source>must be greater than 0</source><translation>doit être supérieur à 0</translation></message>
<message><source>the header promises %1 of %2 bytes and the file holds %3 bytes of them, which is more</source><translation>l'en-tête annonce %1 de %2 octets et le fichier en contient %3 octets, ce qui est plus</translation></message>
<message><source>The last %1 of %2 points hold zeros in all bytes, as a power cut leaves them where a file was not written to its end: they count as no return.</source><translation>Les derniers %1 de %2 points contiennent des zéros dans tous les octets, comme en laisse une coupure de courant quand un fichier n'a pas été écrit jusqu'au bout : ils comptent comme sans retour.</translation></message>
<message><source>holds %1 where the header promises %2</source><translation>contient %1 là où l'en-tête annonce %2</translation></message>
<message><source>the header promises %1, and more text follows them here</source><translation>l'en-tête annonce %1, et d'autre texte suit ici</translation></message>
<message><source>, which repeats exactly and is far apart from the rest, as nothing measured is: taken as no return</source><translation>, qui se répète exactement et est loin du reste, comme rien de mesuré ne l'est : pris comme sans retour</translation></message>
<message><source> (--keep-repeated takes it as measured).</source><translation> (--keep-repeated le prend comme mesuré).</translation></message>
<message><source>holds decimal commas in quotes between commas</source><translation>contient des virgules décimales entre guillemets et entre virgules</translation></message>
<message><source>save the table with semicolons, or with decimal points</source><translation>enregistrez le tableau avec des points-virgules, ou avec des points décimaux</translation></message>
<message><source>holds decimal commas between commas</source><translation>contient des virgules décimales entre virgules</translation></message>
<message><source>The last row has no line end: the file may have been cut off there; compare it with the original.</source><translation>La dernière rangée n'a pas de fin de ligne : le fichier y a peut-être été coupé ; comparez-le à l'original.</translation></message>
<message><source>save the file with plain numbers, without separators of thousands</source><translation>enregistrez le fichier avec de simples nombres, sans séparateurs de milliers</translation></message>
<message><source>holds %1 in a column whose numbers have three digits behind their mark or no mark at all, so that it may separate decimals or thousands</source><translation>contient %1 dans une colonne dont les nombres ont trois chiffres derrière leur signe ou pas de signe, de sorte qu'il peut séparer des décimales ou des milliers</translation></message>
<message><source>save the file with the same count of decimals in each number, or without separators of thousands</source><translation>enregistrez le fichier avec le même nombre de décimales partout, ou sans séparateurs de milliers</translation></message>
<message><source>holds %1, a number whose thousands are set apart</source><translation>contient %1, un nombre dont les milliers sont séparés</translation></message>
<message><source>holds bytes of zero, as a file does that was not written to its end</source><translation>contient des octets nuls, comme un fichier qui n'a pas été écrit jusqu'au bout</translation></message>
<message><source>copy the file or export it again</source><translation>copiez ou exportez à nouveau le fichier</translation></message>
<message><source>%1 has a decimal comma</source><translation>%1 a une virgule décimale</translation></message>
<message><source>save the file with decimal points</source><translation>enregistrez le fichier avec des points décimaux</translation></message>
<message><source>%1 is more than one number between two separators</source><translation>%1 est plus d'un nombre entre deux séparateurs</translation></message>
<message><source>correct the line or export the file again</source><translation>corrigez la ligne ou exportez à nouveau le fichier</translation></message>
<message><source>%1 is not a number</source><translation>%1 n'est pas un nombre</translation></message>
<message><source>%1 is below x, y or z and is not a number</source><translation>%1 est sous x, y ou z et n'est pas un nombre</translation></message>
<message><source>save the file with plain numbers in these columns, without units or marks</source><translation>enregistrez le fichier avec de simples nombres dans ces colonnes, sans unités ni signes</translation></message>
<message><source>there are words among the numbers of its rows, and no heading names x, y and z</source><translation>il y a des mots parmi les nombres de ses rangées, et aucun en-tête ne nomme x, y et z</translation></message>
<message><source>write a first row with the names of the columns, such as id,x,y,z,code</source><translation>écrivez une première ligne avec les noms des colonnes, comme id,x,y,z,code</translation></message>
<message><source>its numbers are separated by "%1", which separates none here</source><translation>ses nombres sont séparés par « %1 », qui n'en sépare aucun ici</translation></message>
<message><source>save the file with commas, semicolons, tabs or blanks between its numbers</source><translation>enregistrez le fichier avec des virgules, points-virgules, tabulations ou espaces entre ses nombres</translation></message>
<message><source>this is text without a row of numbers, so no scan</source><translation>c'est du texte sans rangée de nombres, donc pas un scan</translation></message>
<message><source>choose a scan: E57, LAS, PTX, PCD, PLY, OBJ, CSV, XYZ, .3d, .str, .npy, a raw grid (.json), a range picture (.png, .tif), a recording (.mcap), a ROS bag or a network capture (.pcap)</source><translation>choisissez un scan : E57, LAS, PTX, PCD, PLY, OBJ, CSV, XYZ, .3d, .str, .npy, une grille brute (.json), une image de distances (.png, .tif), un enregistrement (.mcap), un bag ROS ou une capture réseau (.pcap)</translation></message>
<message><source>The recording describes another grid than its telegrams make: the telegrams count.</source><translation>L'enregistrement décrit une autre grille que celle de ses télégrammes : les télégrammes comptent.</translation></message>
<message><source>The recording was cut off: everything up to the cut is here.</source><translation>L'enregistrement a été coupé : tout jusqu'à la coupure est là.</translation></message>
<message><source>%1 times in the recording are after %2 and were read as this time.</source><translation>%1 instants de l'enregistrement sont après %2 et ont été lus comme cet instant.</translation></message>
<message><source>this MCAP file holds nothing that a laser scanner sent</source><translation>ce fichier MCAP ne contient rien qu'un scanner laser ait envoyé</translation></message>
<message><source>choose a recording of a sweep</source><translation>choisissez l'enregistrement d'un balayage</translation></message>
<message><source>nothing that a laser scanner sent can be read in this MCAP file%1</source><translation>rien de ce qu'un scanner laser a envoyé ne peut être lu dans ce fichier MCAP%1</translation></message>
<message><source>, and %1 more</source><translation>, et %1 de plus</translation></message>
<message><source>the recording's "%1" is "%2", which cannot be used.</source><translation>« %1 » de l'enregistrement est « %2 », ce qui ne peut pas être utilisé.</translation></message>
<message><source>%n reading of inclinometer or TALIN cannot be used.</source><translation>%n mesure d'inclinomètre ou de TALIN est inutilisable.</translation></message>
<message><source>%n readings of inclinometer or TALIN cannot be used.</source><translation>%n mesures d'inclinomètre ou de TALIN sont inutilisables.</translation></message>
<message><source>the recording's own readings</source><translation>les propres mesures de l'enregistrement</translation></message>
<message><source>The recording holds readings of TALIN and does not say where the boom pointed (boom_azimuth_deg).</source><translation>L'enregistrement contient des mesures de TALIN et ne dit pas où pointait la flèche (boom_azimuth_deg).</translation></message>
<message><source>the recording</source><translation>l'enregistrement</translation></message>
<message><source> with %1</source><translation> avec %1</translation></message>
<message><source>a pose needs the robot's calibration, and the recording holds none</source><translation>une pose demande l'étalonnage du robot, et l'enregistrement n'en contient pas</translation></message>
<message><source>give --calibration ROBOT.json too</source><translation>indiquez aussi --calibration ROBOT.json</translation></message>
<message><source>a calibration needs a pose, and the recording holds none that can be used</source><translation>un étalonnage demande une pose, et l'enregistrement n'en contient aucune utilisable</translation></message>
<message><source>The recording holds poses and not how the robot is built: --calibration ROBOT.json places the scan.</source><translation>L'enregistrement contient des poses mais pas la construction du robot : --calibration ROBOT.json place le scan.</translation></message>
<message><source>The pose in %1 replaces those of the recording.</source><translation>La pose de %1 remplace celles de l'enregistrement.</translation></message>
<message><source>The recording's pose cannot be used: %1.</source><translation>La pose de l'enregistrement ne peut pas être utilisée : %1.</translation></message>
<message><source>--unit does not apply: the telegrams of a recording say their unit themselves</source><translation>--unit ne s'applique pas : les télégrammes d'un enregistrement disent eux-mêmes leur unité</translation></message>
<message><source>one sweep</source><translation>un balayage</translation></message>
<message><source>%1 sweeps</source><translation>%1 balayages</translation></message>
<message><source>the %1 scan telegrams in this recording hold no line of ranges</source><translation>les %1 télégrammes de scan de cet enregistrement ne contiennent aucune ligne de distances</translation></message>
<message><source>no scan telegram in this recording can be decoded%1</source><translation>aucun télégramme de scan de cet enregistrement ne peut être décodé%1</translation></message>
<message><source>this recording holds no scan telegram%1</source><translation>cet enregistrement ne contient aucun télégramme de scan%1</translation></message>
<message><source>choose another recording</source><translation>choisissez un autre enregistrement</translation></message>
<message><source>The recording holds %1 sweeps; sweep %2 was opened; no other has more lines.</source><translation>L'enregistrement contient %1 balayages ; le balayage %2 a été ouvert ; aucun autre n'a plus de lignes.</translation></message>
<message><source>%1 scan telegrams could not be decoded: %2.</source><translation>%1 télégrammes de scan n'ont pas pu être décodés : %2.</translation></message>
<message><source>%n message holds bytes that are not a whole telegram: what was in it is lost.</source><translation>%n message contient des octets qui ne sont pas un télégramme entier : son contenu est perdu.</translation></message>
<message><source>%n messages hold bytes that are not a whole telegram: what was in them is lost.</source><translation>%n messages contiennent des octets qui ne sont pas un télégramme entier : leur contenu est perdu.</translation></message>
<message><source>INCOMPLETE: %1 lines are there, how many there were is not known.</source><translation>INCOMPLET : %1 lignes sont là, on ne sait pas combien il y en avait.</translation></message>
<message><source>a recording holds whole counts of its unit up to 65535, and the range at line %1, beam %2 is none</source><translation>un enregistrement contient des comptes entiers de son unité jusqu'à 65535, et la distance à la ligne %1, faisceau %2 n'en est pas un</translation></message>
<message><source>a recording needs beam and line angles and this cloud has none</source><translation>un enregistrement demande des angles de faisceaux et de lignes et ce nuage n'en a pas</translation></message>
<message><source>a recording holds at most %1 lines of %2 beams</source><translation>un enregistrement contient au plus %1 lignes de %2 faisceaux</translation></message>
<message><source>telegrams cannot describe this scan</source><translation>des télégrammes ne peuvent pas décrire ce scan</translation></message>
<message><source>the disk is %1 s behind (%2 MB)</source><translation>le disque a %1 s de retard (%2 Mo)</translation></message>
<message><source>the disk is slower than the scanner, telegrams are missing in the recording</source><translation>le disque est plus lent que le scanner, des télégrammes manquent dans l'enregistrement</translation></message>
<message><source>record on another disk</source><translation>enregistrez sur un autre disque</translation></message>
<message><source>the disk did not take the end of the recording, what it has is cut off</source><translation>le disque n'a pas pris la fin de l'enregistrement, ce qu'il a est coupé</translation></message>
<message><source>check the disk; the file opens with what was written</source><translation>vérifiez le disque ; le fichier s'ouvre avec ce qui a été écrit</translation></message>
<message><source>The bag is cut off or damaged at byte %1: the last %2.</source><translation>Le bag est coupé ou endommagé à l'octet %1 : les derniers %2.</translation></message>
<message><source>%n byte was not read</source><translation>%n octet n'a pas été lu</translation></message>
<message><source>%n bytes were not read</source><translation>%n octets n'ont pas été lus</translation></message>
<message><source>%n chunk is damaged and was left out (%1).</source><translation>%n bloc est endommagé et a été laissé de côté (%1).</translation></message>
<message><source>%n chunks are damaged and were left out (%1).</source><translation>%n blocs sont endommagés et ont été laissés de côté (%1).</translation></message>
<message><source>%n message belongs to no topic of the bag and was left out.</source><translation>%n message n'appartient à aucun topic du bag et a été laissé de côté.</translation></message>
<message><source>%n messages belong to no topic of the bag and were left out.</source><translation>%n messages n'appartiennent à aucun topic du bag et ont été laissés de côté.</translation></message>
<message><source>its records do not end with it</source><translation>ses enregistrements ne finissent pas avec lui</translation></message>
<message><source>it is a ROS bag of another version than 2.0</source><translation>c'est un bag ROS d'une autre version que 2.0</translation></message>
<message><source>convert it with "rosbag migrate"</source><translation>convertissez-le avec « rosbag migrate »</translation></message>
<message><source>it promises to unpack to more than a bag of this size holds</source><translation>il annonce qu'il se décompresse en plus qu'un bag de cette taille ne contient</translation></message>
<message><source>The bag was cut off: everything up to the cut is here.</source><translation>Le bag a été coupé : tout jusqu'à la coupure est là.</translation></message>
<message><source>%n message is compressed and damaged and was left out.</source><translation>%n message est compressé et endommagé et a été laissé de côté.</translation></message>
<message><source>%n messages are compressed and damaged and were left out.</source><translation>%n messages sont compressés et endommagés et ont été laissés de côté.</translation></message>
<message><source>this SQLite database is damaged: its tables give more than the file can hold</source><translation>cette base de données SQLite est endommagée : ses tables donnent plus que le fichier ne peut contenir</translation></message>
<message><source>this SQLite database is not a ROS bag: "%1" is not a plain table</source><translation>cette base de données SQLite n'est pas un bag ROS : « %1 » n'est pas une table simple</translation></message>
<message><source>this SQLite database is cut off or damaged: its tables cannot be read</source><translation>cette base SQLite est tronquée ou endommagée : ses tables sont illisibles</translation></message>
<message><source>this SQLite database is not a ROS bag: it has no table of topics</source><translation>cette base SQLite n'est pas un bag ROS : elle n'a pas de table de topics</translation></message>
<message><source>The database is cut off or damaged (%1): messages behind the first %2 were not read.</source><translation>La base de données est coupée ou endommagée (%1) : les messages après les %2 premiers n'ont pas été lus.</translation></message>
<message><source>this SQLite database cannot be opened</source><translation>cette base SQLite ne peut pas être ouverte</translation></message>
<message><source>%n byte behind the end of the database was not read.</source><translation>%n octet derrière la fin de la base de données n'a pas été lu.</translation></message>
<message><source>%n bytes behind the end of the database were not read.</source><translation>%n octets derrière la fin de la base de données n'ont pas été lus.</translation></message>
<message><source>this is a ROS 2 bag in SQLite, and this program was built without SQLite</source><translation>ceci est un bag ROS 2 en SQLite, et ce programme a été compilé sans SQLite</translation></message>
<message><source>convert it with "ros2 bag convert" to MCAP, or install libsqlite3-dev and build again</source><translation>convertissez-le avec "ros2 bag convert" en MCAP, ou installez libsqlite3-dev et compilez à nouveau</translation></message>
<message><source>The log %1 of the recorder could not be read: its messages are not in the scan.</source><translation>Le journal %1 de l'enregistreur n'a pas pu être lu : ses messages ne sont pas dans le scan.</translation></message>
<message><source>The recorder was not ended: its newest messages were read from %1.</source><translation>L'enregistreur n'a pas été arrêté : ses messages les plus récents ont été lus de %1.</translation></message>
<message><source>The recorder was ended within a change: the database was read as it was before it, by %1.</source><translation>L'enregistreur s'est arrêté au milieu d'un changement : la base de données a été lue telle qu'avant, au moyen de %1.</translation></message>
<message><source>The log %1 of the recorder ends with %2 pages that are not whole: their messages are not in the scan.</source><translation>Le journal %1 de l'enregistreur finit par %2 pages incomplètes : leurs messages ne sont pas dans le scan.</translation></message>
<message><source>The log %1 belongs to several databases and was not read: the last change may be in part.</source><translation>Le journal %1 appartient à plusieurs bases de données et n'a pas été lu : la dernière modification peut être partielle.</translation></message>
<message><source>the log %1 cannot be read: the folder for temporary files is missing</source><translation>le journal %1 ne peut pas être lu : le dossier des fichiers temporaires manque</translation></message>
<message><source>set TMPDIR to a folder</source><translation>mettez un dossier dans TMPDIR</translation></message>
<message><source>it is longer than a megabyte</source><translation>elle dépasse un mégaoctet</translation></message>
<message><source>a line of "=" is not followed by "MSG:"</source><translation>une ligne de "=" n'est pas suivie de "MSG:"</translation></message>
<message><source>it names more than 1000 types</source><translation>elle nomme plus de 1000 types</translation></message>
<message><source>the type %1 is not defined</source><translation>le type %1 n'est pas défini</translation></message>
<message><source>a type contains itself, or types are nested more than 32 deep</source><translation>un type se contient lui-même, ou des types sont imbriqués sur plus de 32 niveaux</translation></message>
<message><source>the definition of the message type %1 cannot be read: %2</source><translation>la définition du type de message %1 ne peut pas être lue : %2</translation></message>
<message><source>record the bag again, or convert it with the program that wrote it</source><translation>enregistrez à nouveau le bag, ou convertissez-le avec le programme qui l'a écrit</translation></message>
<message><source>a line has a type and no name: "%1"</source><translation>une ligne a un type et pas de nom : "%1"</translation></message>
<message><source>a field has no name: "%1"</source><translation>un champ n'a pas de nom : "%1"</translation></message>
<message><source>the length of "%1" is not a number</source><translation>la longueur de « %1 » n'est pas un nombre</translation></message>
<message><source>a message of type %1 is encoded in a way that is not read (PLAIN_CDR and PLAIN_CDR2 are)</source><translation>un message du type %1 est encodé d'une façon qui n'est pas lue (PLAIN_CDR et PLAIN_CDR2 le sont)</translation></message>
<message><source>record it with another middleware, or convert the bag</source><translation>enregistrez-le avec un autre middleware, ou convertissez le bag</translation></message>
<message><source>a message of type %1 ends too early or does not fit its definition</source><translation>un message du type %1 finit trop tôt ou ne correspond pas à sa définition</translation></message>
<message><source>copy the bag again</source><translation>copiez à nouveau le bag</translation></message>
<message><source>the bridge closed the connection</source><translation>le pont a fermé la connexion</translation></message>
<message><source>the bridge sends a message of more than 64 MB</source><translation>le pont envoie un message de plus de 64 Mo</translation></message>
<message><source>choose another topic</source><translation>choisissez un autre topic</translation></message>
<message><source>the connection broke (%1)</source><translation>la connexion s'est interrompue (%1)</translation></message>
<message><source>check power, cable and the address, and that this computer is in the robot's network</source><translation>vérifiez l'alimentation, le câble et l'adresse, et que cet ordinateur est dans le réseau du robot</translation></message>
<message><source>check the port (8765) and that foxglove_bridge runs on the robot</source><translation>vérifiez le port (8765) et que foxglove_bridge fonctionne sur le robot</translation></message>
<message><source>what answers there is not a Foxglove bridge</source><translation>ce qui répond là n'est pas un pont Foxglove</translation></message>
<message><source>check the port (8765) and that foxglove_bridge runs there; a scanner of SICK is HOST without ws://</source><translation>vérifiez le port (8765) et que foxglove_bridge y fonctionne ; un scanner SICK est HOST sans ws://</translation></message>
<message><source>the connection is closed</source><translation>la connexion est fermée</translation></message>
<message><source>the subscription cannot be sent (%1)</source><translation>l'abonnement ne peut pas être envoyé (%1)</translation></message>
<message><source>check the network</source><translation>vérifiez le réseau</translation></message>
<message><source>%1 accepts the connection; asking for its topics.</source><translation>%1 accepte la connexion ; demande de ses topics.</translation></message>
<message><source>the bridge says: %1</source><translation>le pont dit : %1</translation></message>
<message><source>check foxglove_bridge on the robot</source><translation>vérifiez foxglove_bridge sur le robot</translation></message>
<message><source>the bridge offers no topics</source><translation>le pont n'offre aucun topic</translation></message>
<message><source>check that the robot's programs run</source><translation>vérifiez que les programmes du robot fonctionnent</translation></message>
<message><source>no scan line of %1 for %2</source><translation>aucune ligne de scan de %1 pendant %2</translation></message>
<message><source>check whether the laser runs and publishes this topic</source><translation>vérifiez que le laser fonctionne et publie ce topic</translation></message>
<message><source>the bridge describes its topics in a text of more than 4 MB</source><translation>le pont décrit ses topics dans un texte de plus de 4 Mo</translation></message>
<message><source>choose another bridge, or let it offer fewer topics</source><translation>choisissez un autre pont, ou faites-lui offrir moins de topics</translation></message>
<message><source>what it sends is not the Foxglove WebSocket protocol</source><translation>ce qu'il envoie n'est pas le protocole WebSocket de Foxglove</translation></message>
<message><source>check the port (8765) and that foxglove_bridge runs there</source><translation>vérifiez le port (8765) et que foxglove_bridge y fonctionne</translation></message>
<message><source>%1 and others</source><translation>%1 et d'autres</translation></message>
<message><source>lines come, but their angle is not known: %1</source><translation>des lignes arrivent, mais leur angle n'est pas connu : %1</translation></message>
<message><source>give the joint that turns the laser (--joint), or the step from line to line (--line-step)</source><translation>indiquez l'articulation qui tourne le laser (--joint), ou le pas de ligne à ligne (--line-step)</translation></message>
<message><source>there is not enough memory for this cloud</source><translation>il n'y a pas assez de mémoire pour ce nuage</translation></message>
<message><source>the bridge offers no topic of a laser (sensor_msgs/LaserScan or PointCloud2)%1</source><translation>le pont n'offre aucun topic d'un laser (sensor_msgs/LaserScan ou PointCloud2)%1</translation></message>
<message><source>check that the laser's driver runs</source><translation>vérifiez que le pilote du laser fonctionne</translation></message>
<message><source>the bridge offers no topic of a laser called "%1"</source><translation>le pont n'offre aucun topic d'un laser nommé « %1 »</translation></message>
<message><source>choose one of %1</source><translation>choisissez l'un de %1</translation></message>
<message><source>GUESS: the topic %1 was taken; --topic chooses another: %2.</source><translation>SUPPOSITION : le topic %1 a été pris ; --topic en choisit un autre : %2.</translation></message>
<message><source>%1 messages of the topic %2 are in the bag twice: each was read once.</source><translation>%1 messages du topic %2 sont deux fois dans le bag : chacun a été lu une fois.</translation></message>
<message><source>it is not a file of a bag</source><translation>ce n'est pas un fichier d'un bag</translation></message>
<message><source>The part %1 of the bag could not be read (%2): its messages are not in the scan.</source><translation>La partie %1 du bag n'a pas pu être lue (%2) : ses messages ne sont pas dans le scan.</translation></message>
<message><source>The part %1 of the bag is missing: its messages are not in the scan.</source><translation>La partie %1 du bag manque : ses messages ne sont pas dans le scan.</translation></message>
<message><source>metadata.yaml does not name %1, a part of the bag by its name: its messages are not in the scan.</source><translation>metadata.yaml ne nomme pas %1, qui d'après son nom est une partie du bag : ses messages ne sont pas dans le scan.</translation></message>
<message><source>metadata.yaml names %1, whose name is not that of a file of messages (.mcap, .db3, .bag): it was not read.</source><translation>metadata.yaml nomme %1, dont le nom n'est pas celui d'un fichier de messages (.mcap, .db3, .bag) : il n'a pas été lu.</translation></message>
<message><source>no part of the bag is there</source><translation>aucune partie du bag n'est là</translation></message>
<message><source>this is not the metadata of an Ouster: beam angles or columns of a frame are missing</source><translation>ce ne sont pas les métadonnées d'un Ouster : les angles des faisceaux ou les colonnes d'une trame manquent</translation></message>
<message><source>save the sensor's metadata again</source><translation>enregistrez à nouveau les métadonnées du capteur</translation></message>
<message><source>the capture</source><translation>la capture</translation></message>
<message><source>%1 turns</source><translation>%1 tours</translation></message>
<message><source>The capture holds %1 turns of the scanner; turn %2, counted from 0, was opened. --scan chooses another.</source><translation>La capture contient %1 tours du scanner ; le tour %2, compté à partir de 0, a été ouvert. --scan en choisit un autre.</translation></message>
<message><source>%n packet came out of order and was put in the order of the scanner's clock.</source><translation>%n paquet est arrivé dans le désordre et a été remis dans l'ordre de l'horloge du scanner.</translation></message>
<message><source>%n packets came out of order and were put in the order of the scanner's clock.</source><translation>%n paquets sont arrivés dans le désordre et ont été remis dans l'ordre de l'horloge du scanner.</translation></message>
<message><source>%n packet is missing in part in the capture: its lines are lost.</source><translation>%n paquet manque en partie dans la capture : ses lignes sont perdues.</translation></message>
<message><source>%n packets are missing in part in the capture: their lines are lost.</source><translation>%n paquets manquent en partie dans la capture : leurs lignes sont perdues.</translation></message>
<message><source>%n packet is in the capture twice: it was read once.</source><translation>%n paquet est deux fois dans la capture : il a été lu une fois.</translation></message>
<message><source>%n packets are in the capture twice: each was read once.</source><translation>%n paquets sont deux fois dans la capture : chacun a été lu une fois.</translation></message>
<message><source>The capture holds packets of %1 scanners; the one with most of them was opened.</source><translation>La capture contient des paquets de %1 scanners ; celui qui en a le plus a été ouvert.</translation></message>
<message><source>The scanner sent two returns for each beam: the strongest ones are here, and %1 left out.</source><translation>Le scanner a envoyé deux retours par faisceau : les plus forts sont ici, et ont été laissés de côté %1.</translation></message>
<message><source>%n other of the capture was</source><translation>%n autre de la capture</translation></message>
<message><source>%n others of the capture were</source><translation>%n autres de la capture</translation></message>
<message><source>The beams of a VLP-16 begin up to 11 mm above and below its middle: points are that far off.</source><translation>Les faisceaux d'un VLP-16 commencent jusqu'à 11 mm au-dessus et au-dessous de son milieu : les points sont décalés d'autant.</translation></message>
<message><source>the packets of an Ouster do not say the angles of its beams</source><translation>les paquets d'un Ouster ne disent pas les angles de ses faisceaux</translation></message>
<message><source>save the sensor's metadata as %1 next to the capture</source><translation>enregistrez les métadonnées du capteur sous le nom %1 à côté de la capture</translation></message>
<message><source>no packet of the capture fits the sensor of %1</source><translation>aucun paquet de la capture ne correspond au capteur de %1</translation></message>
<message><source>save the metadata of the sensor that was captured</source><translation>enregistrez les métadonnées du capteur qui a été capturé</translation></message>
<message><source>The beams of an Ouster begin some centimetres away from its axis, and the ranges are as measured: points are that far off.</source><translation>Les faisceaux d'un Ouster commencent à quelques centimètres de son axe, et les distances sont telles que mesurées : les points sont décalés d'autant.</translation></message>
<message><source>%n line of the turn is missing in the capture and is shown as lost.</source><translation>%n ligne du tour manque dans la capture et est montrée comme perdue.</translation></message>
<message><source>%n lines of the turn are missing in the capture and are shown as lost.</source><translation>%n lignes du tour manquent dans la capture et sont montrées comme perdues.</translation></message>
<message><source>the capturing computer's clock, carried on by the scanner's</source><translation>l'horloge de l'ordinateur qui a capturé, prolongée par celle du scanner</translation></message>
<message><source>The cloud is of a scanner with several beams: its rings are the beams, and its firings the lines.</source><translation>Le nuage vient d'un scanner à plusieurs faisceaux : ses anneaux sont les faisceaux, et ses tirs les lignes.</translation></message>
<message><source>the cloud has no fields x, y and z</source><translation>le nuage n'a pas de champs x, y et z</translation></message>
<message><source>the cloud promises %1 x %2 points of %3 bytes and holds %4 bytes</source><translation>le nuage annonce %1 x %2 points de %3 octets et contient %4 octets</translation></message>
<message><source>choose another topic or message</source><translation>choisissez un autre topic ou un autre message</translation></message>
<message><source>the topic %1</source><translation>le topic %1</translation></message>
<message><source>one cloud</source><translation>un nuage</translation></message>
<message><source>%1 clouds</source><translation>%1 nuages</translation></message>
<message><source>The bag holds no definition of its messages: that of the ROS 2 release of 2022 was ASSUMED.</source><translation>Le bag ne contient pas la définition de ses messages : celle de ROS 2 de 2022 a été SUPPOSÉE.</translation></message>
<message><source>The topic %1 holds a cloud in each message; message %2, counted from 0, was opened. --scan chooses another.</source><translation>Le topic %1 contient un nuage par message ; le message %2, compté à partir de 0, a été ouvert. --scan en choisit un autre.</translation></message>
<message><source>no file of messages that metadata.yaml names is in this folder: %1%2</source><translation>aucun fichier de messages que nomme metadata.yaml n'est dans ce dossier : %1%2</translation></message>
<message><source> and %1 more</source><translation> et %1 de plus</translation></message>
<message><source>copy the files of the bag into it</source><translation>copiez-y les fichiers du bag</translation></message>
<message><source>this folder holds %1 of several bags</source><translation>ce dossier contient %1 de plusieurs bags</translation></message>
<message><source>%n file</source><translation>%n fichier</translation></message>
<message><source>%n files</source><translation>%n fichiers</translation></message>
<message><source>open one of them, as %1</source><translation>ouvrez l'un d'eux, comme %1</translation></message>
<message><source>This file is part %1 of %2 of a bag. Open %3 for all of it.</source><translation>Ce fichier est la partie %1 sur %2 d'un bag. Ouvrez %3 pour l'avoir en entier.</translation></message>
<message><source>%n message of the topic was left out: %1.</source><translation>%n message du topic a été laissé de côté : %1.</translation></message>
<message><source>%n messages of the topic were left out: %1.</source><translation>%n messages du topic ont été laissés de côté : %1.</translation></message>
<message><source>%n message has a time_increment that cannot be: the beams of a line count as measured at once.</source><translation>%n message a un time_increment impossible : les faisceaux d'une ligne comptent comme mesurés en même temps.</translation></message>
<message><source>%n messages have a time_increment that cannot be: the beams of a line count as measured at once.</source><translation>%n messages ont un time_increment impossible : les faisceaux d'une ligne comptent comme mesurés en même temps.</translation></message>
<message><source>%n line came out of order and was put in the order of its stamp</source><translation>%n ligne est arrivée dans le désordre et a été remise dans l'ordre de son heure</translation></message>
<message><source>%n lines came out of order and were put in the order of their stamps</source><translation>%n lignes sont arrivées dans le désordre et ont été remises dans l'ordre de leurs heures</translation></message>
<message><source>%n message of the topic is in the bag twice, with the same stamp and ranges: it was read once.</source><translation>%n message du topic est deux fois dans le bag, avec la même heure et les mêmes distances : il a été lu une fois.</translation></message>
<message><source>%n messages of the topic are in the bag twice, with the same stamp and ranges: each was read once.</source><translation>%n messages du topic sont deux fois dans le bag, avec la même heure et les mêmes distances : chacun a été lu une fois.</translation></message>
<message><source>In %1 angle_max is not where angle_min and angle_increment put the last beam: angle_increment was used, and the beams may be mirrored or turned.</source><translation>Dans %1 angle_max n'est pas là où angle_min et angle_increment mettent le dernier faisceau : angle_increment a servi, et les faisceaux peuvent être inversés ou tournés.</translation></message>
<message><source>%n message of joints is damaged and was left out.</source><translation>%n message d'articulations est endommagé et a été laissé de côté.</translation></message>
<message><source>%n messages of joints are damaged and were left out.</source><translation>%n messages d'articulations sont endommagés et ont été laissés de côté.</translation></message>
<message><source>GUESS: the angle of each line comes from %1.</source><translation>SUPPOSITION : l'angle de chaque ligne vient de %1.</translation></message>
<message><source>A joint does not say how the laser is mounted on it. ASSUMED: the axis (%1). Give --axis where that is wrong.</source><translation>Une articulation ne dit pas comment le laser y est monté. SUPPOSÉ : l'axe (%1). Indiquez --axis là où c'est faux.</translation></message>
<message><source>sweep, by the name of the joint</source><translation>sweep, d'après le nom de l'articulation</translation></message>
<message><source>The axis is %1 degrees out of the plane of the fan: points are that far off.</source><translation>L'axe est à %1 degrés du plan de l'éventail : les points sont décalés d'autant.</translation></message>
<message><source>The laser is %1 mm off its axis: ranges are as measured, and points are as if it were on the axis.</source><translation>Le laser est à %1 mm de son axe : les distances sont telles que mesurées, et les points comme s'il était sur l'axe.</translation></message>
<message><source>%n line was measured before the first or after the last angle and was left out.</source><translation>%n ligne a été mesurée avant le premier ou après le dernier angle et a été laissée de côté.</translation></message>
<message><source>%n lines were measured before the first or after the last angle and were left out.</source><translation>%n lignes ont été mesurées avant le premier ou après le dernier angle et ont été laissées de côté.</translation></message>
<message><source>%n line was measured while the laser did not turn and was left out.</source><translation>%n ligne a été mesurée pendant que le laser ne tournait pas et a été laissée de côté.</translation></message>
<message><source>%n lines were measured while the laser did not turn and were left out.</source><translation>%n lignes ont été mesurées pendant que le laser ne tournait pas et ont été laissées de côté.</translation></message>
<message><source>the laser did not turn while it measured</source><translation>le laser n'a pas tourné pendant la mesure</translation></message>
<message><source>choose another topic, or give the joint that turns it</source><translation>choisissez un autre topic, ou donnez l'articulation qui le tourne</translation></message>
<message><source>assembling lines</source><translation>assemblage des lignes</translation></message>
<message><source>no line of the topic %1 could be placed</source><translation>aucune ligne du topic %1 n'a pu être placée</translation></message>
<message><source>The topic holds %1 sweeps; sweep %2, counted from 0, was opened. --scan chooses another.</source><translation>Le topic contient %1 balayages ; le balayage %2, compté à partir de 0, a été ouvert. --scan en choisit un autre.</translation></message>
<message><source>the stamps of the messages</source><translation>les horodatages des messages</translation></message>
<message><source>%1 x %2 points with %3</source><translation>%1 x %2 points avec %3</translation></message>
<message><source>%1turn rates and accelerations, which are not used: transforms and joints turn the laser</source><translation>%1vitesses de rotation et accélérations, qui ne servent pas : les transformations et les articulations tournent le laser</translation></message>
<message><source>scan lines of %1 beams</source><translation>lignes de scan de %1 faisceaux</translation></message>
<message><source>poses in the frame %1</source><translation>poses dans le repère %1</translation></message>
<message><source> at %1 Hz</source><translation> à %1 Hz</translation></message>
<message><source>no topic of this %1 is a laser's%2%3</source><translation>aucun topic de ce %1 n'est d'un laser%2%3</translation></message>
<message><source>choose another bag</source><translation>choisissez un autre bag</translation></message>
<message><source>the bag has no topic "%1"</source><translation>le bag n'a pas de topic « %1 »</translation></message>
<message><source>the topic %1 holds no scan</source><translation>le topic %1 ne contient aucun scan</translation></message>
<message><source> messages of transforms are damaged and were left out.</source><translation> messages de transformations sont endommagés et ont été laissés de côté.</translation></message>
<message><source> transforms of the bag have no rotation, no name or no finite numbers and were left out.</source><translation> transformations du bag n'ont pas de rotation, pas de nom ou pas de nombres finis et ont été laissées de côté.</translation></message>
<message><source> transforms name another parent for their frame than the first one and were left out.</source><translation> transformations nomment un autre parent de leur repère que la première et ont été laissées de côté.</translation></message>
<message><source> transforms of the bag are of more frames than any robot has and were left out.</source><translation> transformations du bag concernent plus de repères qu'aucun robot n'en a et ont été laissées de côté.</translation></message>
<message><source>The transforms of the bag form a loop at the frame %1.</source><translation>Les transformations du bag forment une boucle au repère %1.</translation></message>
<message><source>The transforms of the bag form a chain of more than %1 frames: those above are not used.</source><translation>Les transformations du bag forment une chaîne de plus de %1 repères : ceux du dessus ne sont pas utilisés.</translation></message>
<message><source>ranges of the topic are %1 m, the range_min of their messages</source><translation>distances du sujet sont de %1 m, le range_min de leurs messages</translation></message>
<message><source>ranges of the topic are %1 m</source><translation>distances du topic sont %1 m</translation></message>
<message><source>it has no beams or no stamp</source><translation>il n'a pas de faisceaux ou pas d'horodatage</translation></message>
<message><source>its angle_increment does not give the step between beams</source><translation>son angle_increment ne donne pas le pas entre faisceaux</translation></message>
<message><source>its angle_min or angle_increment puts beams outside of one turn</source><translation>son angle_min ou angle_increment met des faisceaux hors d'un tour</translation></message>
<message><source>no message of the topic %1 is a line of ranges%2</source><translation>aucun message du topic %1 n'est une ligne de distances%2</translation></message>
<message><source>GUESS: the poses of the topic %1 are those of the frame %2.</source><translation>SUPPOSITION : les poses du topic %1 sont celles du repère %2.</translation></message>
<message><source>The transforms put the scanner at %1, %2, %3 m, where nothing on earth is: the scan stays in the scanner's frame.</source><translation>Les transformations mettent le scanner à %1, %2, %3 m, où il n'y a rien sur terre : le scan reste dans le repère du scanner.</translation></message>
<message><source>the frame %1 of the bag</source><translation>le repère %1 du bag</translation></message>
<message><source>the transforms of the bag</source><translation>les transformations du bag</translation></message>
<message><source>GUESS: the frame %1 of the bag is taken as the mine grid, with x to the east, y to the north and z up.</source><translation>SUPPOSITION : le repère %1 du bag est pris comme grille de la mine, x vers l'est, y vers le nord et z vers le haut.</translation></message>
<message><source>the transform of the frame %1 in %2</source><translation>la transformation du repère %1 dans %2</translation></message>
<message><source>%1 turns about more than one axis (%2 degrees off)</source><translation>%1 tourne autour de plus d'un axe (écart de %2 degrés)</translation></message>
<message><source>choose another topic, or give the joint that turns the laser</source><translation>choisissez un autre topic, ou indiquez l'articulation qui tourne le laser</translation></message>
<message><source>%1 turns the laser in the plane of its own fan: that is not a sweep</source><translation>%1 tourne le laser dans le plan de son propre éventail : ce n'est pas un balayage</translation></message>
<message><source>no transform turns the laser's frame %1 while it measures</source><translation>aucune transformation ne tourne le repère %1 du laser pendant la mesure</translation></message>
<message><source>give the joint that turns it (--joint), or the step from line to line (--line-step) and the axis (--axis)</source><translation>indiquez l'articulation qui le tourne (--joint), ou le pas de ligne à ligne (--line-step) et l'axe (--axis)</translation></message>
<message><source>no joint turned while the laser measured</source><translation>aucune articulation n'a tourné pendant la mesure du laser</translation></message>
<message><source>there is no joint called %1</source><translation>il n'y a pas d'articulation nommée %1</translation></message>
<message><source>give the step from line to line (--line-step), or choose another topic</source><translation>indiquez le pas de ligne à ligne (--line-step), ou choisissez un autre topic</translation></message>
<message><source>the joint %1</source><translation>l'articulation %1</translation></message>
<message><source>there are too many topics</source><translation>il y a trop de topics</translation></message>
<message><source>a line came out of order</source><translation>une ligne est arrivée dans le désordre</translation></message>
<message><source>the angle of a line is not known</source><translation>l'angle d'une ligne n'est pas connu</translation></message>
<message><source>the laser did not turn yet</source><translation>le laser n'a pas encore tourné</translation></message>
<message><source>%1 degrees</source><translation>%1 degrés</translation></message>
<message><source>, %1 times its uncertainty</source><translation>, %1 fois son incertitude</translation></message>
<message><source>odd beams lie %1 ahead of even ones%2</source><translation>les faisceaux impairs sont %1 en avance sur les pairs%2</translation></message>
<message><source>odd beams lie %1 behind even ones%2</source><translation>les faisceaux impairs sont %1 en retard sur les pairs%2</translation></message>
<message><source>, %1 times the usual unevenness of its steps</source><translation>, %1 fois l'irrégularité habituelle de ses pas</translation></message>
<message><source>the stepper slipped at %1 (first at line %2, by up to %3%4)</source><translation>le moteur pas à pas a glissé à %1 (d'abord à la ligne %2, jusqu'à %3%4)</translation></message>
<message><source>%n line</source><translation>%n ligne</translation></message>
<message><source>%n lines</source><translation>%n lignes</translation></message>
<message><source>the beams of %1 lines in turn lie %2 and %3 degrees ahead of where they should be%4</source><translation>les faisceaux de %1 lignes sont tour à tour %2 et %3 degrés en avance sur leur place%4</translation></message>
<message><source> At %1 of the first and last lines the stepper still swung back: folds there are left out.</source><translation> À %1 des premières et dernières lignes, le moteur pas à pas oscillait encore : les plis y sont laissés de côté.</translation></message>
<message><source>Not measured at the angles that the file gives: </source><translation>Non mesuré aux angles que le fichier donne : </translation></message>
<message><source>Not straightened: the scan has no lines with angles.</source><translation>Non redressé : le scan n'a pas de lignes avec des angles.</translation></message>
<message><source>Straightened: %1, and were put side by side: %2 lines make one.</source><translation>Redressé : %1, et ont été mises côte à côte : %2 lignes en font une.</translation></message>
<message><source>Straightened: no interlaced beams and no slips were found; the angles stay.</source><translation>Redressé : ni faisceaux entrelacés ni glissements trouvés ; les angles restent.</translation></message>
<message><source>%n slip was seen in every second beam only, and is left as it is.</source><translation>%n glissement n'a été vu que dans un faisceau sur deux et reste tel quel.</translation></message>
<message><source>%n slips were seen in every second beam only, and are left as they are.</source><translation>%n glissements n'ont été vus que dans un faisceau sur deux et restent tels quels.</translation></message>
<message><source>; edges across the lines are combed: --straighten (Scan &gt; Straighten Beams) puts these lines side by side as one.</source><translation> ; les arêtes en travers des lignes sont dentelées : --straighten (Scan &gt; Straighten Beams) met ces lignes côte à côte en une seule.</translation></message>
<message><source>; EdgeScan+ allows for it, but the cloud does not: --straighten (Scan &gt; Straighten Beams) corrects the angles.</source><translation> ; EdgeScan+ en tient compte, mais pas le nuage : --straighten (Scan &gt; Straighten Beams) corrige les angles.</translation></message>
<message><source>has no direction</source><translation>n'a pas de direction</translation></message>
<message><source>and "head_in_robot_m" exclude each other</source><translation>et "head_in_robot_m" s'excluent</translation></message>
<message><source>compare it with the example in docs/reference/coordinates.md</source><translation>comparez-le avec l'exemple de docs/reference/coordinates.md</translation></message>
<message><source>the inclinometer's two axes cannot be raised by %1 and %2 degrees at once</source><translation>les deux axes de l'inclinomètre ne peuvent pas être levés de %1 et %2 degrés à la fois</translation></message>
<message><source>check whether it reads pitch and roll instead of the elevations of its axes</source><translation>vérifiez s'il lit le tangage et le roulis au lieu des élévations de ses axes</translation></message>
<message><source>a boom slewed by %1 degrees on this robot cannot be raised by %2</source><translation>une flèche tournée de %1 degrés sur ce robot ne peut pas être levée de %2</translation></message>
<message><source>check the slew angle and the inclinometer</source><translation>vérifiez l'angle de rotation et l'inclinomètre</translation></message>
<message><source>RL, positive up [m]</source><translation>RL, positif vers le haut [m]</translation></message>
<message><source>Heading, clockwise from north [degrees]</source><translation>Cap, du nord dans le sens horaire [degrés]</translation></message>
<message><source>North of the heading</source><translation>Nord du cap</translation></message>
<message><source>Tilt: pitch, nose up [degrees]</source><translation>Inclinaison : tangage, nez vers le haut [degrés]</translation></message>
<message><source>Tilt: roll, right side down [degrees]</source><translation>Inclinaison : roulis, côté droit vers le bas [degrés]</translation></message>
<message><source>Zone or EPSG code</source><translation>Zone ou code EPSG</translation></message>
<message><source>Azimuth of the boom, positive to the left [degrees]</source><translation>Azimut de la flèche, positif vers la gauche [degrés]</translation></message>
<message><source>Robot's pitch, nose up [degrees]</source><translation>Tangage du robot, nez vers le haut [degrés]</translation></message>
<message><source>Robot's roll, right side down [degrees]</source><translation>Roulis du robot, côté droit vers le bas [degrés]</translation></message>
<message><source>Name of robot or scanner</source><translation>Nom du robot ou du scanner</translation></message>
<message><source>Boresight: roll, pitch, yaw [degrees]</source><translation>Visée : roulis, tangage, lacet [degrés]</translation></message>
<message><source>Lever arm of TALIN in the robot: forward, left, up [m]</source><translation>Bras de levier du TALIN dans le robot : avant, gauche, haut [m]</translation></message>
<message><source>Lever arm of the head in the robot: forward, left, up [m]</source><translation>Bras de levier de la tête dans le robot : avant, gauche, haut [m]</translation></message>
<message><source>Pivot of a boom in the robot, in place of the head [m]</source><translation>Pivot d'une flèche dans le robot, à la place de la tête [m]</translation></message>
<message><source>From pivot to head [m]</source><translation>Du pivot à la tête [m]</translation></message>
<message><source>The boom's azimuth turns about</source><translation>L'azimut de la flèche tourne autour de</translation></message>
<message><source>The scanner looks</source><translation>Le scanner regarde</translation></message>
<message><source>Looking direction: roll, pitch, yaw [degrees]</source><translation>Direction du regard : roulis, tangage, lacet [degrés]</translation></message>
<message><source>Looking direction: nine numbers by rows</source><translation>Direction du regard : neuf nombres par lignes</translation></message>
<message><source>Axis of the stepper from the inclinometer [m]</source><translation>Axe du moteur pas à pas depuis l'inclinomètre [m]</translation></message>
<message><source>Tilt is given as</source><translation>L'inclinaison est donnée par</translation></message>
<message><source>Scanner on the stepper: roll, pitch, yaw [degrees]</source><translation>Scanner sur le moteur : roulis, tangage, lacet [degrés]</translation></message>
<message><source>Scanner on the stepper: x, y, z [m]</source><translation>Scanner sur le moteur : x, y, z [m]</translation></message>
<message><source>Axis of the stepper</source><translation>Axe du moteur</translation></message>
<message><source>Zero of the stepper [degrees]</source><translation>Zéro du moteur [degrés]</translation></message>
<message><source>Direction of the stepper, 1 or -1</source><translation>Sens du moteur, 1 ou -1</translation></message>
<message><source>Step from line to line [degrees]</source><translation>Pas de ligne en ligne [degrés]</translation></message>
<message><source>Beam at the time stamp of a line [degrees]</source><translation>Faisceau à l'heure d'une ligne [degrés]</translation></message>
<message><source>Grid convergence [degrees]</source><translation>Convergence de la grille [degrés]</translation></message>
<message><source>Scale of the grid</source><translation>Échelle de la grille</translation></message>
<message><source>Largest change of tilt during a sweep [degrees]</source><translation>Plus grand changement d'inclinaison pendant un balayage [degrés]</translation></message>
<message><source>Largest age of a pose [s]</source><translation>Plus grand âge d'une pose [s]</translation></message>
<message><source>%1 is missing.</source><translation>%1 manque.</translation></message>
<message><source>%1: "%2" is not a number.</source><translation>%1 : « %2 » n'est pas un nombre.</translation></message>
<message><source>%1: "%2" is not three numbers.</source><translation>%1 : « %2 » n'est pas trois nombres.</translation></message>
<message><source>%1: "%2" is not nine numbers.</source><translation>%1 : « %2 » n'est pas neuf nombres.</translation></message>
<message><source>the file must hold an object {...}</source><translation>le fichier doit contenir un objet {...}</translation></message>
<message><source>choose a pose or calibration file</source><translation>choisissez un fichier de pose ou d'étalonnage</translation></message>
<message><source>the pose is of robot "%1" and the calibration of "%2"</source><translation>la pose est du robot « %1 » et l'étalonnage de « %2 »</translation></message>
<message><source>give the calibration of the robot that made the scan</source><translation>donnez l'étalonnage du robot qui a fait le scan</translation></message>
<message><source>the scan turns about %1 and the stepper of the calibration about another axis, %2 degrees away</source><translation>le scan tourne autour de %1 et le moteur pas à pas de l'étalonnage autour d'un autre axe, à %2 degrés</translation></message>
<message><source>x (sweep)</source><translation>x (sweep)</translation></message>
<message><source>z (spin)</source><translation>z (spin)</translation></message>
<message><source>open the scan with the right --axis, or correct "stepper.axis" of the calibration: [0, 0, 1] for a spin, [1, 0, 0] for a sweep</source><translation>ouvrez le scan avec le bon --axis, ou corrigez "stepper.axis" de l'étalonnage : [0, 0, 1] pour spin, [1, 0, 0] pour sweep</translation></message>
<message><source>%1 line times do not fit a scan of %2 lines</source><translation>%1 instants de ligne ne correspondent pas à un scan de %2 lignes</translation></message>
<message><source>give the times of this scan</source><translation>donnez les instants de ce scan</translation></message>
<message><source>OUT OF SPEC: </source><translation>HORS TOLÉRANCE : </translation></message>
<message><source>The pose carries no time, so its age is not known.</source><translation>La pose n'a pas d'heure, son âge n'est donc pas connu.</translation></message>
<message><source>The start of the scan is not known, so the age of the pose is not either.</source><translation>Le début du scan n'est pas connu, l'âge de la pose non plus.</translation></message>
<message><source>the pose is %1 s older than the start of the scan.</source><translation>la pose est plus ancienne de %1 s que le début du scan.</translation></message>
<message><source>the tilt of the head changed by %1 degrees while it scanned, more than %2.</source><translation>l'inclinaison de la tête a changé de %1 degrés pendant le scan, plus que %2.</translation></message>
<message><source>The calibration does not give %1, so 0 is used: add what is missing (Scan &gt; Pose and Mounting, page Mounting).</source><translation>L'étalonnage ne donne pas %1 ; 0 est utilisé : ajoutez ce qui manque (Scan &gt; Pose et montage, page Montage).</translation></message>
<message><source>%1 of %2 lines were measured before the first or after the last pose and were given the nearest one.</source><translation>%1 de %2 lignes ont été mesurées avant la première ou après la dernière pose et ont reçu la plus proche.</translation></message>
<message><source>the poses move the base at %1 m/s between two lines, faster than any machine under ground.</source><translation>les poses déplacent la base à %1 m/s entre deux lignes, plus vite que toute machine sous terre.</translation></message>
<message><source>the zone "%1" does not exist: UTM has zones 1 to 60.</source><translation>la zone "%1" n'existe pas : UTM a les zones 1 à 60.</translation></message>
<message><source>an easting of %1 m is outside of every UTM zone: check whether easting and northing are exchanged.</source><translation>une coordonnée est de %1 m est hors de toute zone UTM : vérifiez si est et nord sont échangés.</translation></message>
<message><source>there is no pose</source><translation>il n'y a pas de pose</translation></message>
<message><source>give readings of inclinometer and TALIN</source><translation>donnez des mesures d'inclinomètre et de TALIN</translation></message>
<message><source>the angles of the stepper are assumed, so E, N and RL may be wrong: give mounting, step and angle of the first line.</source><translation>les angles du moteur pas à pas sont supposés, E, N et RL peuvent donc être faux : indiquez le montage, le pas et l'angle de la première ligne.</translation></message>
<message><source>the base moved and the times of the lines are not known</source><translation>la base a bougé et les instants des lignes ne sont pas connus</translation></message>
<message><source>add "scan_start" and "scan_end" to the pose file</source><translation>ajoutez "scan_start" et "scan_end" au fichier de pose</translation></message>
<message><source>a pose needs the robot's calibration</source><translation>une pose demande l'étalonnage du robot</translation></message>
<message><source>--calibration replaces the calibration in %1.</source><translation>--calibration remplace l'étalonnage de %1.</translation></message>
<message><source>The pose in %1 replaces the place that the file gives: E %2, N %3 m in place of E %4, N %5 m.</source><translation>La pose de %1 remplace le lieu que donne le fichier: E %2, N %3 m au lieu de E %4, N %5 m.</translation></message>
<message><source>mine grid</source><translation>coordonnées de la mine</translation></message>
<message><source>local metres from the mine grid origin</source><translation>mètres locaux depuis l'origine de la grille de la mine</translation></message>
<message><source>save the scan again, or remove "placement"</source><translation>enregistrez à nouveau le scan, ou supprimez "placement"</translation></message>
<message><source>must not be where the pivot is</source><translation>ne doit pas être là où est le pivot</translation></message>
<message><source>"placement" must be an object {...}</source><translation>"placement" doit être un objet {...}</translation></message>
<message><source>must be a rotation and a translation, twelve numbers</source><translation>doit être une rotation et une translation, douze nombres</translation></message>
<message><source>must hold one pose or %1, one per line</source><translation>doit contenir une pose ou %1, une par ligne</translation></message>
<message><source>must hold rotations and translations, twelve numbers each</source><translation>doit contenir des rotations et des translations, douze nombres chacune</translation></message>
<message><source>and "%1" exclude each other</source><translation>et « %1 » s'excluent</translation></message>
<message><source>needs a "time" in every reading when "sweep" is "moving"</source><translation>demande un "time" dans chaque mesure quand "sweep" est "moving"</translation></message>
<message><source>must be in the order of time</source><translation>doit être dans l'ordre du temps</translation></message>
<message><source>comes before "scan_start"</source><translation>vient avant "scan_start"</translation></message>
<message><source>; a scanner that hangs has "viewing": "down" in its calibration</source><translation> ; un scanner suspendu a "viewing": "down" dans son étalonnage</translation></message>
<message><source>; a magnetic bearing is converted as the same page says</source><translation> ; un cap magnétique se convertit comme le dit la même page</translation></message>
<message><source>this is a pose of 3DTK and not of EdgeScan</source><translation>c'est une pose de 3DTK et non d'EdgeScan</translation></message>
<message><source>give a pose file as in docs/reference/coordinates.md</source><translation>indiquez un fichier de pose comme dans docs/reference/coordinates.md</translation></message>
<message><source>write easting, northing and level, such as 498765.432; 5150123.456; 287.654</source><translation>écrivez est, nord et niveau, comme 498765.432; 5150123.456; 287.654</translation></message>
<message><source>the line holds %1 and a place has three, with a heading four, with pitch and roll six</source><translation>la ligne contient %1 et un lieu en a trois, avec un cap quatre, avec tangage et roulis six</translation></message>
<message><source>the line is empty</source><translation>la ligne est vide</translation></message>
<message><source>%1 may be one number with a comma for thousands, or two numbers</source><translation>%1 peut être un nombre avec une virgule de milliers, ou deux nombres</translation></message>
<message><source>leave that comma out, or write blanks between the numbers</source><translation>enlevez cette virgule, ou écrivez des espaces entre les nombres</translation></message>
<message><source>the first of four whole numbers may be the point's or the easting</source><translation>le premier de quatre nombres entiers peut être celui du point ou l'est</translation></message>
<message><source>leave the point's number out, or write decimals</source><translation>enlevez le numéro du point, ou écrivez des décimales</translation></message>
<message><source>How a motor turned the scanner was not said in full. ASSUMED: </source><translation>La rotation du scanner par un moteur n'a pas été entièrement indiquée. SUPPOSÉ : </translation></message>
<message><source>the axis (</source><translation>l'axe (</translation></message>
<message><source>, seen in the ranges)</source><translation>, vu dans les distances)</translation></message>
<message><source>the step from line to line (</source><translation>le pas de ligne à ligne (</translation></message>
<message><source>the angle of the first line (</source><translation>l'angle de la première ligne (</translation></message>
<message><source>the file gives points and not angles</source><translation>le fichier donne des points et pas d'angles</translation></message>
<message><source>scan of a file</source><translation>scan d'un fichier</translation></message>
<message><source>no file holds more</source><translation>aucun fichier n'en contient plus</translation></message>
<message><source>Angle of the first beam [degrees]</source><translation>Angle du premier faisceau [degrés]</translation></message>
<message><source>Angle from beam to beam [degrees]</source><translation>Angle d'un faisceau à l'autre [degrés]</translation></message>
<message><source>Angle of the first line [degrees]</source><translation>Angle de la première ligne [degrés]</translation></message>
<message><source>Angle from line to line [degrees]</source><translation>Angle d'une ligne à l'autre [degrés]</translation></message>
<message><source>Unit of the numbers in the file; replaces the one that the file gives</source><translation>Unité des nombres du fichier ; remplace celle que donne le fichier</translation></message>
<message><source>Millimetres per number in the file</source><translation>Millimètres par nombre du fichier</translation></message>
<message><source>Cells of a cloud that is projected [degrees]; else from the spacing of its points</source><translation>Cellules d'un nuage qui est projeté [degrés] ; sinon d'après l'espacement de ses points</translation></message>
<message><source>What the stepper turns about: spin (viewing direction) or sweep (0/180 degree line)</source><translation>Ce autour de quoi le moteur pas à pas tourne : spin (direction de visée) ou sweep (ligne 0/180 degrés)</translation></message>
<message><source>Place of the scanner for a cloud without a grid, as X,Y,Z [m]</source><translation>Place du scanner pour un nuage sans grille, comme X,Y,Z [m]</translation></message>
<message><source>Points without a scanner grid: project them about the sensor (auto), do so without looking for a grid (always), or refuse them (never)</source><translation>Points qui ne sont sur aucune grille de scanner : les projeter autour du capteur (auto), le faire sans chercher de grille (always), ou les refuser (never)</translation></message>
<message><source>Correct the angles of beams that were interlaced from two passes, and of lines at which the stepper slipped</source><translation>Corriger les angles des faisceaux entrelacés de deux passages, et des lignes où le moteur pas à pas a glissé</translation></message>
<message><source>Which scan of a file that holds several, from 0</source><translation>Quel scan d'un fichier qui en contient plusieurs, à partir de 0</translation></message>
<message><source>Topic of a ROS bag that is the scan; otherwise a laser that is turned</source><translation>Sujet (topic) d'un bag ROS qui est le scan ; sinon un laser qui tourne</translation></message>
<message><source>Joint of a ROS bag that turns the laser; otherwise from the transforms</source><translation>Articulation (joint) d'un bag ROS qui tourne le laser ; sinon les transformations la donnent</translation></message>
<message><source>Columns of x, y and z in a list of points, by number from 1 or by name: 2,1,3</source><translation>Colonnes de x, y et z dans une liste de points, par numéro à partir de 1 ou par nom : 2,1,3</translation></message>
<message><source>Take a value or point that repeats exactly, far apart from the rest, as measured and not as no return</source><translation>Prendre une valeur ou un point qui se répète exactement, loin du reste, comme mesuré et non comme sans retour</translation></message>
<message><source>Pose file of the scan; a recording may hold its own</source><translation>Fichier de pose du scan ; un enregistrement peut contenir le sien</translation></message>
<message><source>Calibration file of the robot; a recording may hold its own</source><translation>Fichier d'étalonnage du robot ; un enregistrement peut contenir le sien</translation></message>
<message><source>must not be 0</source><translation>ne doit pas être 0</translation></message>
<message><source>%1, or a number of %2</source><translation>%1, ou un nombre de %2</translation></message>
<message><source>"%1" is not one of its values</source><translation>« %1 » n'est pas l'une de ses valeurs</translation></message>
<message><source>from %1 to %2%3</source><translation>de %1 à %2%3</translation></message>
<message><source>give three numbers %1: X,Y,Z</source><translation>donnez trois nombres %1 : X,Y,Z</translation></message>
<message><source>give a whole number %1</source><translation>donnez un nombre entier %1</translation></message>
<message><source>give a number %1</source><translation>donnez un nombre %1</translation></message>
<message><source> that is not 0</source><translation> qui ne soit pas 0</translation></message>
<message><source>"%1" is not three numbers</source><translation>« %1 » n'est pas trois nombres</translation></message>
<message><source>"%1" is not a number</source><translation>« %1 » n'est pas un nombre</translation></message>
<message><source>%1 is out of reason for a %2</source><translation>%1 est hors du raisonnable pour %2</translation></message>
<message><source>%1 holds %2</source><translation>%1 contient %2</translation></message>
<message><source>--scan %1</source><translation>--scan %1</translation></message>
<message><source>use --scan 0</source><translation>utilisez --scan 0</translation></message>
<message><source>use --scan 0 to %1</source><translation>utilisez --scan de 0 à %1</translation></message>
<message><source>--%1 %2 replaces %3, which the file gives.</source><translation>--%1 %2 remplace %3, que donne le fichier.</translation></message>
<message><source>--%1 has no effect: %2; leave it out.</source><translation>--%1 n'a pas d'effet : %2 ; laissez-le de côté.</translation></message>
<message><source>what the scan was opened with is damaged</source><translation>ce avec quoi le scan a été ouvert est endommagé</translation></message>
<message><source>export again</source><translation>exportez à nouveau</translation></message>
<message><source>verify with the version that made the export</source><translation>vérifiez avec la version qui a fait l'export</translation></message>
<message><source>the file</source><translation>le fichier</translation></message>
<message><source>one scan</source><translation>un scan</translation></message>
<message><source>%1 scans</source><translation>%1 scans</translation></message>
<message><source>the scanner</source><translation>le scanner</translation></message>
<message><source>the scanner's answer to %1</source><translation>la réponse du scanner à %1</translation></message>
<message><source>the code of a refusal</source><translation>le code d'un refus</translation></message>
<message><source>the number of sectors</source><translation>le nombre de secteurs</translation></message>
<message><source>the angle step</source><translation>le pas angulaire</translation></message>
<message><source>the start angle</source><translation>l'angle de début</translation></message>
<message><source>the stop angle</source><translation>l'angle de fin</translation></message>
<message><source>the value</source><translation>la valeur</translation></message>
<message><source>the text</source><translation>le texte</translation></message>
<message><source>the scan frequency</source><translation>la fréquence de balayage</translation></message>
<message><source>the channels</source><translation>les canaux</translation></message>
<message><source>the remission switch</source><translation>l'interrupteur de rémission</translation></message>
<message><source>the remission width</source><translation>la largeur de rémission</translation></message>
<message><source>the unit</source><translation>l'unité</translation></message>
<message><source>the encoders</source><translation>les codeurs</translation></message>
<message><source>the position switch</source><translation>l'interrupteur de position</translation></message>
<message><source>the name switch</source><translation>l'interrupteur de nom</translation></message>
<message><source>the comment switch</source><translation>l'interrupteur de commentaire</translation></message>
<message><source>the time switch</source><translation>l'interrupteur de temps</translation></message>
<message><source>the output interval</source><translation>l'intervalle de sortie</translation></message>
<message><source>the name</source><translation>le nom</translation></message>
<message><source>the version</source><translation>la version</translation></message>
<message><source>the state</source><translation>l'état</translation></message>
<message><source>the temperature range</source><translation>la plage de température</translation></message>
<message><source>the time</source><translation>l'heure</translation></message>
<message><source>the date</source><translation>la date</translation></message>
<message><source>this is not an answer of a scanner</source><translation>ceci n'est pas une réponse d'un scanner</translation></message>
<message><source>byte 0 of the telegram</source><translation>octet 0 du télégramme</translation></message>
<message><source>an answer without a name</source><translation>une réponse sans nom</translation></message>
<message><source>byte 4 of the telegram</source><translation>octet 4 du télégramme</translation></message>
<message><source>access to the method is denied, log in first</source><translation>l'accès à la méthode est refusé, connectez-vous d'abord</translation></message>
<message><source>the method is not known</source><translation>la méthode n'est pas connue</translation></message>
<message><source>the variable is not known</source><translation>la variable n'est pas connue</translation></message>
<message><source>not possible now, or a value is out of its range</source><translation>impossible maintenant, ou une valeur est hors de son intervalle</translation></message>
<message><source>the arguments are wrong in number or form</source><translation>les arguments sont faux en nombre ou en forme</translation></message>
<message><source>unknown error</source><translation>erreur inconnue</translation></message>
<message><source>the telegram is too long</source><translation>le télégramme est trop long</translation></message>
<message><source>the telegram is too short</source><translation>le télégramme est trop court</translation></message>
<message><source>the type is not known</source><translation>le type n'est pas connu</translation></message>
<message><source>writing the variable is denied, log in first</source><translation>écrire la variable est refusé, connectez-vous d'abord</translation></message>
<message><source>the command is not known to the name server</source><translation>le serveur de noms ne connaît pas la commande</translation></message>
<message><source>the CoLa command is not known</source><translation>la commande CoLa n'est pas connue</translation></message>
<message><source>the method is still busy</source><translation>la méthode est encore occupée</translation></message>
<message><source>an array is out of its bounds</source><translation>un tableau sort de ses limites</translation></message>
<message><source>the event is not known</source><translation>l'événement n'est pas connu</translation></message>
<message><source>a CoLa A value is too large</source><translation>une valeur CoLa A est trop grande</translation></message>
<message><source>a CoLa A character is invalid</source><translation>un caractère CoLa A n'est pas valide</translation></message>
<message><source>no message</source><translation>aucun message</translation></message>
<message><source>no answer</source><translation>aucune réponse</translation></message>
<message><source>internal error</source><translation>erreur interne</translation></message>
<message><source>hub address is corrupted</source><translation>l'adresse du hub est corrompue</translation></message>
<message><source>hub address cannot be decoded</source><translation>l'adresse du hub ne peut pas être décodée</translation></message>
<message><source>hub address is out of range</source><translation>l'adresse du hub est hors de son intervalle</translation></message>
<message><source>hub address expected</source><translation>adresse du hub attendue</translation></message>
<message><source>asynchronous methods are suppressed</source><translation>les méthodes asynchrones sont supprimées</translation></message>
<message><source>complex arrays are not supported</source><translation>les tableaux complexes ne sont pas pris en charge</translation></message>
<message><source>a reason that is not documented</source><translation>une raison qui n'est pas documentée</translation></message>
<message><source>byte %1 of the telegram</source><translation>octet %1 du télégramme</translation></message>
<message><source>is cut off</source><translation>est coupé</translation></message>
<message><source>is not a number of %1 bits</source><translation>n'est pas un nombre de %1 bits</translation></message>
<message><source>does not end after %1 characters</source><translation>ne finit pas après %1 caractères</translation></message>
<message><source>are cut off</source><translation>sont coupés</translation></message>
<message><source>bridges with encryption are not supported</source><translation>les ponts avec chiffrement ne sont pas pris en charge</translation></message>
<message><source>write ws://HOST or ws://HOST:PORT</source><translation>écrivez ws://HOST ou ws://HOST:PORT</translation></message>
<message><source>"%1://" is not known here</source><translation>« %1:// » n'est pas connu ici</translation></message>
<message><source>write HOST or HOST:PORT for a scanner, ws://HOST or ws://HOST:PORT for a robot's Foxglove bridge</source><translation>écrivez HOST ou HOST:PORT pour un scanner, ws://HOST ou ws://HOST:PORT pour le pont Foxglove d'un robot</translation></message>
<message><source>what follows the bracket is not a port</source><translation>ce qui suit le crochet n'est pas un port</translation></message>
<message><source>there is no port behind the colon</source><translation>il n'y a pas de port derrière les deux-points</translation></message>
<message><source>there is no host</source><translation>il n'y a pas d'hôte</translation></message>
<message><source>"%1" is not a port</source><translation>« %1 » n'est pas un port</translation></message>
<message><source>give a number from 1 to 65535</source><translation>donnez un nombre de 1 à 65535</translation></message>
<message><source>no scanner is given</source><translation>aucun scanner n'est indiqué</translation></message>
<message><source>give its IP address or host name</source><translation>donnez son adresse IP ou son nom d'hôte</translation></message>
<message><source>the host name is not known</source><translation>le nom d'hôte est inconnu</translation></message>
<message><source>check its spelling or use the scanner's IP address</source><translation>vérifiez son orthographe ou utilisez l'adresse IP du scanner</translation></message>
<message><source>the name server does not answer</source><translation>le serveur de noms ne répond pas</translation></message>
<message><source>use the scanner's IP address</source><translation>utilisez l'adresse IP du scanner</translation></message>
<message><source>nothing answers there</source><translation>rien ne répond à cette adresse</translation></message>
<message><source>the connection is refused</source><translation>la connexion est refusée</translation></message>
<message><source>there is no way to this address</source><translation>aucun chemin ne mène à cette adresse</translation></message>
<message><source>check the cable and the network settings of this computer</source><translation>vérifiez le câble et les réglages réseau de cet ordinateur</translation></message>
<message><source>cannot connect (%1)</source><translation>connexion impossible (%1)</translation></message>
<message><source>check the address and the network settings of this computer</source><translation>vérifiez l'adresse et les réglages réseau de cet ordinateur</translation></message>
<message><source>check power, cable and the address, and that this computer is in the scanner's network</source><translation>vérifiez l'alimentation, le câble et l'adresse, et que cet ordinateur est dans le réseau du scanner</translation></message>
<message><source>check the port (2111 or 2112) and that no other program holds the scanner</source><translation>vérifiez le port (2111 ou 2112) et qu'aucun autre programme n'occupe le scanner</translation></message>
<message><source>a command cannot be sent (%1)</source><translation>une commande ne peut pas être envoyée (%1)</translation></message>
<message><source>check the cable</source><translation>vérifiez le câble</translation></message>
<message><source>the scanner closed the connection</source><translation>le scanner a fermé la connexion</translation></message>
<message><source>check that a scanner of SICK answers there; a robot's Foxglove bridge is ws://HOST</source><translation>vérifiez qu'un scanner SICK y répond ; le pont Foxglove d'un robot est ws://HOST</translation></message>
<message><source>the name of a channel</source><translation>le nom d'un canal</translation></message>
<message><source>the scale of a channel</source><translation>l'échelle d'un canal</translation></message>
<message><source>the offset of a channel</source><translation>le décalage d'un canal</translation></message>
<message><source>the start angle of a channel</source><translation>l'angle de début d'un canal</translation></message>
<message><source>the angle step of a channel</source><translation>le pas angulaire d'un canal</translation></message>
<message><source>the number of values of a channel</source><translation>le nombre de valeurs d'un canal</translation></message>
<message><source>the values of a channel</source><translation>les valeurs d'un canal</translation></message>
<message><source>the number of channels</source><translation>le nombre de canaux</translation></message>
<message><source>the device number</source><translation>le numéro de l'appareil</translation></message>
<message><source>the serial number</source><translation>le numéro de série</translation></message>
<message><source>the device status</source><translation>l'état de l'appareil</translation></message>
<message><source>the telegram counter</source><translation>le compteur de télégrammes</translation></message>
<message><source>the scan counter</source><translation>le compteur de scans</translation></message>
<message><source>the time since start-up</source><translation>le temps depuis le démarrage</translation></message>
<message><source>the time of transmission</source><translation>l'heure de transmission</translation></message>
<message><source>the digital inputs</source><translation>les entrées numériques</translation></message>
<message><source>the digital outputs</source><translation>les sorties numériques</translation></message>
<message><source>the layer angle</source><translation>l'angle de la couche</translation></message>
<message><source>the measurement frequency</source><translation>la fréquence de mesure</translation></message>
<message><source>the number of encoders</source><translation>le nombre de codeurs</translation></message>
<message><source>an encoder position</source><translation>une position de codeur</translation></message>
<message><source>an encoder speed</source><translation>une vitesse de codeur</translation></message>
<message><source>the position</source><translation>la position</translation></message>
<message><source>the rotation</source><translation>la rotation</translation></message>
<message><source>the rotation type</source><translation>le type de rotation</translation></message>
<message><source>the year</source><translation>l'année</translation></message>
<message><source>the date and time</source><translation>la date et l'heure</translation></message>
<message><source>the microsecond</source><translation>la microseconde</translation></message>
<message><source>the event type</source><translation>le type d'événement</translation></message>
<message><source>the event's encoder</source><translation>le codeur de l'événement</translation></message>
<message><source>the event's time</source><translation>l'heure de l'événement</translation></message>
<message><source>the event's angle</source><translation>l'angle de l'événement</translation></message>
<message><source>the position flag</source><translation>l'indicateur de position</translation></message>
<message><source>the name flag</source><translation>l'indicateur de nom</translation></message>
<message><source>the device name</source><translation>le nom de l'appareil</translation></message>
<message><source>the comment flag</source><translation>l'indicateur de commentaire</translation></message>
<message><source>the comment</source><translation>le commentaire</translation></message>
<message><source>the time flag</source><translation>l'indicateur d'heure</translation></message>
<message><source>the event flag</source><translation>l'indicateur d'événement</translation></message>
<message><source>the offset of the channel %1 is %2, which no scanner uses</source><translation>le décalage du canal %1 est %2, qu'aucun scanner n'utilise</translation></message>
<message><source>the scale of the channel %1 is %2, which no scanner uses</source><translation>l'échelle du canal %1 est %2, qu'aucun scanner n'utilise</translation></message>
<message><source>the scan telegram</source><translation>le télégramme de scan</translation></message>
<message><source>this is not a scan telegram (LMDscandata)</source><translation>ceci n'est pas un télégramme de scan (LMDscandata)</translation></message>
<message><source>firmware %1</source><translation>micrologiciel %1</translation></message>
<message><source>%1 degrees from %2 to %3</source><translation>%1 degrés de %2 à %3</translation></message>
<message><source>something accepts the connection but does not answer in CoLa</source><translation>quelque chose accepte la connexion mais ne répond pas en CoLa</translation></message>
<message><source>check that it is a SICK scanner and the port is 2111 or 2112</source><translation>vérifiez que c'est un scanner SICK et que le port est 2111 ou 2112</translation></message>
<message><source>no answer to "%1"</source><translation>aucune réponse à « %1 »</translation></message>
<message><source>check the connection</source><translation>vérifiez la connexion</translation></message>
<message><source>no line was received</source><translation>aucune ligne n'a été reçue</translation></message>
<message><source>check that foxglove_bridge runs there; a scanner of SICK is HOST without ws://</source><translation>vérifiez que foxglove_bridge y fonctionne ; un scanner SICK est HOST sans ws://</translation></message>
<message><source>check cable, address and port</source><translation>vérifiez le câble, l'adresse et le port</translation></message>
<message><source>%1: disconnected.</source><translation>%1 : déconnecté.</translation></message>
<message><source>%1 Trying again in %2.</source><translation>%1 Nouvel essai dans %2.</translation></message>
<message><source>Connecting to %1.</source><translation>Connexion à %1.</translation></message>
<message><source> is sending.</source><translation> envoie.</translation></message>
<message><source> is sending again.</source><translation> envoie de nouveau.</translation></message>
<message><source>%1: no scan for %2.</source><translation>%1 : aucun scan depuis %2.</translation></message>
<message><source>%1 accepts the connection; asking what it is.</source><translation>%1 accepte la connexion ; demande de ce que c'est.</translation></message>
<message><source>the scanner refuses to send scans: %1</source><translation>le scanner refuse d'envoyer des scans : %1</translation></message>
<message><source>check what else uses it</source><translation>vérifiez ce qui l'utilise aussi</translation></message>
<message><source>no scan for %1</source><translation>aucun scan pendant %1</translation></message>
<message><source>check the cable and whether the scanner's mirror turns</source><translation>vérifiez le câble et que le miroir du scanner tourne</translation></message>
<message><source>A telegram came late and was put into its line</source><translation>Un télégramme est arrivé en retard et a été mis dans sa ligne</translation></message>
<message><source>telegrams came late and were put into their lines</source><translation>télégrammes sont arrivés en retard et ont été mis dans leurs lignes</translation></message>
<message><source>A telegram came after its sweep had ended</source><translation>Un télégramme est arrivé après la fin de son balayage</translation></message>
<message><source>telegrams came after their sweep had ended</source><translation>télégrammes sont arrivés après la fin de leur balayage</translation></message>
<message><source>: not used</source><translation> : non utilisé</translation></message>
<message><source>A telegram had other beams than the sweep, or was of another layer of the scanner</source><translation>Un télégramme avait d'autres faisceaux que le balayage, ou était d'une autre couche du scanner</translation></message>
<message><source>telegrams had other beams than the sweep, or were of another layer of the scanner</source><translation>télégrammes avaient d'autres faisceaux que le balayage, ou étaient d'une autre couche du scanner</translation></message>
<message><source>: no lines of this sweep</source><translation>: pas de lignes de ce balayage</translation></message>
<message><source>A telegram held no ranges</source><translation>Un télégramme ne contenait pas de distances</translation></message>
<message><source>telegrams held no ranges</source><translation>télégrammes ne contenaient pas de distances</translation></message>
<message><source>: their lines are lost</source><translation>: leurs lignes sont perdues</translation></message>
<message><source>The scanner's counters jumped ahead once</source><translation>Les compteurs du scanner ont sauté en avant une fois</translation></message>
<message><source>times the scanner's counters jumped ahead</source><translation>fois les compteurs du scanner ont sauté en avant</translation></message>
<message><source>, by more lines than its clock allows: whether lines were lost there is not known</source><translation>, de plus de lignes que son horloge ne le permet : on ne sait pas si des lignes y ont été perdues</translation></message>
<message><source>One of the scanner's counters was set back</source><translation>Un des compteurs du scanner a été remis en arrière</translation></message>
<message><source>times one of the scanner's counters was set back</source><translation>fois un des compteurs du scanner a été remis en arrière</translation></message>
<message><source>: lost lines there are counted by the other one and the clock</source><translation>: les lignes perdues y sont comptées par l'autre et l'horloge</translation></message>
<message><source>The scanner's counters stood still for a line</source><translation>Les compteurs du scanner se sont arrêtés pendant une ligne</translation></message>
<message><source>times the scanner's counters stood still from line to line</source><translation>fois les compteurs du scanner se sont arrêtés d'une ligne à l'autre</translation></message>
<message><source>: lost lines cannot be counted there</source><translation>: les lignes perdues ne peuvent pas y être comptées</translation></message>
<message><source>The scanner's clock was set while its counters ran on</source><translation>L'horloge du scanner a été réglée pendant que ses compteurs continuaient</translation></message>
<message><source>times the scanner's clock was set while its counters ran on</source><translation>fois l'horloge du scanner a été réglée pendant que ses compteurs continuaient</translation></message>
<message><source>: the times of lines there are reckoned</source><translation>: les heures des lignes y sont calculées</translation></message>
<message><source>The scanner's clock stood still for a line</source><translation>L'horloge du scanner s'est arrêtée pendant une ligne</translation></message>
<message><source>times the scanner's clock stood still from line to line</source><translation>fois l'horloge du scanner s'est arrêtée d'une ligne à l'autre</translation></message>
<message><source>The scanner paused for more than a second</source><translation>Le scanner s'est arrêté plus d'une seconde</translation></message>
<message><source>times the scanner paused for more than a second</source><translation>fois le scanner s'est arrêté plus d'une seconde</translation></message>
<message><source>, and its counters know of no lost line</source><translation>, et ses compteurs ne connaissent aucune ligne perdue</translation></message>
<message><source>The scanner restarted</source><translation>Le scanner a redémarré</translation></message>
<message><source>times the scanner restarted</source><translation>fois le scanner a redémarré</translation></message>
<message><source>: lines lost meanwhile are counted by this computer's clock</source><translation>: les lignes perdues entre-temps sont comptées par l'horloge de cet ordinateur</translation></message>
<message><source>A telegram brought other echoes than the first one</source><translation>Un télégramme a apporté d'autres échos que le premier</translation></message>
<message><source>telegrams brought other echoes than the first one</source><translation>télégrammes ont apporté d'autres échos que le premier</translation></message>
<message><source>: their ranges may be of another echo</source><translation>: leurs distances peuvent être d'un autre écho</translation></message>
<message><source>The telegrams come from another scanner</source><translation>Les télégrammes viennent d'un autre scanner</translation></message>
<message><source>times the telegrams came from another scanner</source><translation>fois les télégrammes sont venus d'un autre scanner</translation></message>
<message><source>: the sweep is not of one device</source><translation>: le balayage n'est pas d'un seul appareil</translation></message>
<message><source>A line was lost between two sweeps</source><translation>Une ligne a été perdue entre deux balayages</translation></message>
<message><source>lines were lost between two sweeps</source><translation>lignes ont été perdues entre deux balayages</translation></message>
<message><source> (first at line </source><translation> (d'abord à la ligne </translation></message>
<message><source> (%1 by the counters)</source><translation> (%1 d'après les compteurs)</translation></message>
<message><source>the recording computer's clock, carried on by the scanner's</source><translation>l'horloge de l'ordinateur qui a enregistré, prolongée par celle du scanner</translation></message>
<message><source> from line %1 on</source><translation> à partir de la ligne %1</translation></message>
<message><source>window too dirty to measure through</source><translation>fenêtre trop sale pour mesurer à travers</translation></message>
<message><source>dirty window</source><translation>fenêtre sale</translation></message>
<message><source>none reported</source><translation>aucune signalée</translation></message>
<message><source>first echo that the scanner sent</source><translation>premier écho que le scanner a envoyé</translation></message>
<message><source>last echo that the scanner sent</source><translation>dernier écho que le scanner a envoyé</translation></message>
<message><source>, the motor turning on while a line is measured)</source><translation>, le moteur continuant à tourner pendant la mesure d'une ligne)</translation></message>
<message><source>%1. Give %2 where that is wrong.</source><translation>%1. Indiquez %2 là où c'est faux.</translation></message>
<message><source>lines %1 and others</source><translation>lignes %1 et d'autres</translation></message>
<message><source>lines %1</source><translation>lignes %1</translation></message>
<message><source>The encoder count of the first line received is taken as the first angle of the sweep.</source><translation>Le compte de l'encodeur à la première ligne reçue est pris comme premier angle du balayage.</translation></message>
<message><source>The first line received is taken as line 0 of the sweep.</source><translation>La première ligne reçue est prise comme ligne 0 du balayage.</translation></message>
<message><source>Telegrams were lost: %1 (%2 in all).</source><translation>Des télégrammes ont été perdus : %1 (%2 en tout).</translation></message>
<message><source>Telegrams had fewer beams than the sweep, the others are lost: %1 (%2 in all).</source><translation>Des télégrammes avaient moins de faisceaux que le balayage, les autres sont perdus : %1 (%2 en tout).</translation></message>
<message><source>The line angles are computed from time alone: a change of speed bends the cloud.</source><translation>Les angles des lignes sont calculés d'après le temps seul : un changement de vitesse courbe le nuage.</translation></message>
<message><source>The telegrams carry encoder counts, but the number of counts per degree was not given: angles do not follow them.</source><translation>Les télégrammes portent des impulsions d'encodeur, mais le nombre d'impulsions par degré n'a pas été donné : les angles ne les suivent pas.</translation></message>
<message><source>The scanner lost its encoder count when it restarted: the line angles after that are computed.</source><translation>Le scanner a perdu le compte de l'encodeur au redémarrage : les angles des lignes suivantes sont calculés.</translation></message>
<message><source> (from line %1 on).</source><translation> (à partir de la ligne %1).</translation></message>
<message><source>The scanner reported an error or was not ready</source><translation>Le scanner a signalé une erreur ou n'était pas prêt</translation></message>
<message><source>The scanner reported a window too dirty to measure through</source><translation>Le scanner a signalé une fenêtre trop sale pour mesurer</translation></message>
<message><source>The scanner reported a dirty window</source><translation>Le scanner a signalé une fenêtre sale</translation></message>
</context>
</TS>
