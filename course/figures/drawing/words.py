"""The catalogue of all words that figures write, by a key: (English, French), with {placeholders} for what is put in."""

from __future__ import annotations

WORDS: dict[str, tuple[str, str]] = {
    # -- titles of the kinds --
    "sketch": ("Kinematic sketch", "Schéma cinématique"),
    "singular": ("Singular configurations", "Configurations singulières"),
    "postures": ("Postures of the inverse solution", "Postures de la solution inverse"),
    # -- all figures --
    "generic_pose": ("generic pose", "pose générique"),
    "nothing_to_draw": ("Nothing to draw", "Rien à tracer"),
    "figure_of": ("{title}: {arm}.", "{title} : {arm}."),
    # -- sketch --
    "dh_classic": ("Denavit–Hartenberg frames (classic)", "Repères de Denavit–Hartenberg (classiques)"),
    "dh_modified": ("Denavit–Hartenberg frames (modified)", "Repères de Denavit–Hartenberg (modifiés)"),
    "drawn_at": ("Drawn at {pose}.", "Tracé pour {pose}."),
    "lengths_are": ("Lengths: {lengths}.", "Longueurs : {lengths}."),
    "frames_classic": (
        "Frames of the classic Denavit–Hartenberg convention.",
        "Repères de la convention de Denavit–Hartenberg classique.",
    ),
    "frames_modified": (
        "Frames of the modified Denavit–Hartenberg convention.",
        "Repères de la convention de Denavit–Hartenberg modifiée (Khalil–Kleinfinger).",
    ),
    "frames_own": (
        "The frames are those of the model, not of Denavit and Hartenberg.",
        "Les repères sont ceux du modèle, pas de Denavit et Hartenberg.",
    ),
    # -- singular configurations --
    "lost_velocity": ("lost velocity", "vitesse perdue"),
    "lost_rotation": ("lost rotation", "rotation perdue"),
    "rank": ("rank $J$ = {rank}", "rang $J$ = {rank}"),
    "boundary": ("on the boundary", "sur la frontière"),
    "inside": ("inside the workspace", "dans l'espace de travail"),
    "boundary in part": ("in part on the boundary", "en partie sur la frontière"),
    "not decided": ("", ""),
    "beyond_limits": ("beyond the joint limits", "hors des butées"),
    "always_regular": (
        "The Jacobian has full rank at every configuration: there is nothing singular.",
        "La jacobienne est de rang plein pour toute configuration : il n'y a rien de singulier.",
    ),
    "not_analysed": (
        "The singular configurations could not be found: {reason}",
        "Les configurations singulières n'ont pu être trouvées : {reason}",
    ),
    "generic_caption": (
        "Left: a generic pose ({pose}), where $J$ has rank {rank}.",
        "À gauche : une pose générique ({pose}), où $J$ est de rang {rank}.",
    ),
    "family_caption": (
        "{letter}) ${condition}$ at {pose}: rank {rank}.",
        "{letter}) ${condition}$, pour {pose} : rang {rank}.",
    ),
    "ellipse_caption": (
        "Shaded: the velocities of the point for joint rates of norm 1; the arrow is the direction that is lost.",
        "En grisé : les vitesses du point pour des vitesses articulaires de norme 1 ; la flèche est la direction perdue.",
    ),
    # -- postures --
    "all_postures": ("all {count} postures", "les {count} postures"),
    "posture": ("posture", "posture"),
    "target": ("target", "cible"),
    "one_posture": (
        "Each target is reached in one posture only: there is nothing to overlay.",
        "Chaque cible n'est atteinte que dans une posture : il n'y a rien à superposer.",
    ),
    "many_postures": (
        "The arm has {joints} joints for {rows} numbers of a target: infinitely many postures reach it.",
        "Le bras a {joints} articulations pour {rows} nombres d'une cible : une infinité de postures l'atteignent.",
    ),
    "postures_caption": (
        "The {count} postures that reach the target {target}.",
        "Les {count} postures qui atteignent la cible {target}.",
    ),
    "by_formula": (
        "They are the branches of the closed-form inverse.",
        "Ce sont les branches de l'inverse analytique.",
    ),
    "by_iteration": (
        "They were found by Newton's method from {starts} starts.",
        "Elles ont été trouvées par la méthode de Newton depuis {starts} départs.",
    ),
    "posture_caption": ("{number}) {pose}.", "{number}) {pose}."),
    "frame_column": ("$i$", "$i$"),
    # -- arms of the catalogue (an English title stands in arm.yaml) --
    "arm kr210": ("", "KUKA KR 210 avec préhenseur"),
    "arm planar_2r": ("", "Bras plan 2R"),
    "arm planar_3r": ("", "Bras plan 3R"),
    "arm polar_rp": ("", "Bras polaire RP"),
    "arm rx90": ("", "Stäubli RX-90, repères de DH modifiés"),
    "arm scara": ("", "SCARA, repères de DH classiques, outil vers le bas"),
    "arm scara_column": ("", "SCARA sur colonne, repères de DH classiques, outil vers le bas"),
    "arm scara_modified": ("", "SCARA, repères de DH modifiés, tous les z vers le haut"),
    "arm spatial_rrr": ("", "Bras spatial RRR, repères de DH classiques"),
    "arm spherical_wrist": ("", "Poignet sphérique, repères de DH classiques"),
    "arm DH table": ("", "Bras donné par une table de DH"),
    # -- maps and trajectories --
    "workspace": ("Workspace and manipulability", "Espace de travail et manipulabilité"),
    "manipulability_word": ("manipulability", "manipulabilité"),
    "tool_point": ("tool point", "point de l’outil"),
    "wrist_centre": ("centre of the wrist", "centre du poignet"),
    "million": ("a million", "un million de"),
    "workspace_is": (
        "Where the {point} is at {count} configurations within the joint limits; colour and level lines: the highest manipulability $w$ of its velocity there, up to {best}.",
        "Positions du {point} pour {count} configurations dans les limites articulaires ; couleurs et lignes de niveau : la plus grande manipulabilité $w$ de sa vitesse, jusqu’à {best}.",
    ),
    "workspace_reach": (
        "Its distance from the first axis goes from {near} to {far}.",
        "Sa distance au premier axe va de {near} à {far}.",
    ),
    "singular_curves": ("Singular curves: {curves}.", "Courbes singulières : {curves}."),
    "no_singular_curves": (
        "No singular configuration of it is within the limits.",
        "Aucune configuration singulière n’est dans les limites.",
    ),
    "no_plane": (
        "The tool moves neither in a plane nor, while the first joint rests, in a section through its axis.",
        "L’outil ne se déplace ni dans un plan ni, la première articulation bloquée, dans une section par son axe.",
    ),
    "manipulability": ("Manipulability", "Manipulabilité"),
    "w_over": (
        "Yoshikawa's measure $w = \\sqrt{{\\det(J J^T)}}$ over {joints} within the joint limits, at ${count}$ configurations.",
        "Mesure de Yoshikawa $w = \\sqrt{{\\det(J J^T)}}$ en fonction de {joints} dans les limites articulaires, pour ${count}$ configurations.",
    ),
    "w_highest": ("Its highest value is {value}, at {at}.", "Son maximum vaut {value}, pour {at}."),
    "other_joints": ("Here {values}.", "Ici {values}."),
    "determinant_is": ("$\\det J = {latex}$.", "$\\det J = {latex}$."),
    "crossing": ("Passing a singular configuration", "Passage près d’une configuration singulière"),
    "pseudo_inverse": ("pseudo-inverse: $\\dot{{q}} = J^{{+}} v$", "pseudo-inverse : $\\dot{{q}} = J^{{+}} v$"),
    "damped_inverse": (
        "damped least squares: $\\lambda = {damping}$",
        "moindres carrés amortis : $\\lambda = {damping}$",
    ),
    "damped_error": ("error of the tool, damped", "erreur de l’outil, cas amorti"),
    "moves_at": (
        "moves on a straight line from $A$ to $B$ at {speed} m/s",
        "va en ligne droite de $A$ à $B$ à {speed} m/s",
    ),
    "turns_at": (
        "turns about one axis from $A$ to $B$ at {speed} rad/s",
        "tourne autour d’un axe fixe de $A$ à $B$ à {speed} rad/s",
    ),
    "passes": (
        "The tool {moving} and passes ${family}$, where the least singular value of $J$ falls to {least} (drawn dark, dotted line).",
        "L’outil {moving} et passe près de ${family}$, où la plus petite valeur singulière de $J$ tombe à {least} (en noir, trait pointillé).",
    ),
    "comes_near": (
        "The tool {moving} and ends beside ${family}$, where the least singular value of $J$ falls to {least} (drawn dark).",
        "L’outil {moving} et s’arrête près de ${family}$, où la plus petite valeur singulière de $J$ tombe à {least} (en noir).",
    ),
    "highest_rates": (
        "With the pseudo-inverse {joint} reaches {pseudo}, with damped least squares ($\\lambda$ = ${damping}$) {damped};",
        "Avec la pseudo-inverse, {joint} atteint {pseudo} ; avec les moindres carrés amortis ($\\lambda$ = ${damping}$), {damped} ;",
    ),
    "and_error": ("the tool is then off by up to {errors}.", "l’outil s’écarte alors jusqu’à {errors}."),
    "no_crossing": (
        "No singular configuration within the joint limits is neared by a straight motion of the tool.",
        "Aucun mouvement rectiligne de l’outil ne s’approche d’une configuration singulière dans les limites articulaires.",
    ),
    "tracking": ("Simulated tracking", "Suivi simulé"),
    "tool_error_title": ("error of the tool", "erreur de l’outil"),
    "masses_right": ("right masses", "masses exactes"),
    "masses_wrong": ("masses at {part}%", "masses à {part} %"),
    "joint_error_title": ("errors of the joints, masses at {part}%", "erreurs articulaires, masses à {part} %"),
    "effort_title": ("efforts of the drives, masses at {part}%", "efforts des moteurs, masses à {part} %"),
    "tracking_is": (
        "A quintic motion of {t_f} s tracked in simulation by inverse dynamics control (bandwidth {bandwidth} rad/s, period {period} ms). The tool is off by up to {right} with the right masses in the controller, and by up to {wrong} with {part}% of them.",
        "Mouvement de degré cinq de {t_f} s suivi en simulation par une commande à dynamique inverse (bande passante {bandwidth} rad/s, période {period} ms). L’outil s’écarte de {right} au plus avec les masses exactes dans la commande, de {wrong} au plus avec {part} % de ces masses.",
    ),
    "effort_is": (
        "The drive of {joint} comes nearest to its limit, {use}% of it.",
        "Le moteur de {joint} s’approche le plus de sa limite, {use} % de celle-ci.",
    ),
    "no_masses": (
        "The links have no mass: the arm cannot be simulated.",
        "Les corps n’ont pas de masse : le bras ne peut pas être simulé.",
    ),
    "rendering": ("3D picture", "Vue 3D"),
    "axes_colours": ("Axes $x$ red, $y$ green, $z$ blue.", "Axes $x$ rouge, $y$ vert, $z$ bleu."),
    "no_shape": (
        "An arm that is given by a DH table has no shape.",
        "Un bras donné par une table de DH n’a pas de forme.",
    ),
    "no_renderer": (
        "3D pictures need Mesa's EGL library and a driver for it; on Debian and Ubuntu: apt install libegl1 libgl1-mesa-dri.",
        "Les vues 3D demandent la bibliothèque EGL de Mesa et un pilote ; sous Debian et Ubuntu : apt install libegl1 libgl1-mesa-dri.",
    ),
    "time": ("time", "temps"),
    "time_is": ("$t$ = {time} s", "$t$ = {time} s"),
    "path": ("Path of the tool", "Trajectoire de l’outil"),
    "joint_motion": ("joint-space motion", "mouvement articulaire"),
    "line_motion": ("straight-line motion", "mouvement rectiligne"),
    "turn_motion": ("turn about one axis", "rotation autour d’un axe fixe"),
    "below_rates": (
        "Below, the joint velocities as parts of their limits $k_v$.",
        "En bas, les vitesses articulaires rapportées à leurs maximums $k_v$.",
    ),
    "A_to_B": (
        "From $A$ ({start}) to $B$ ({end}) in $t_f$ = {t_f} s, from rest to rest; the arm at {count} equally spaced times, dots twelve a motion.",
        "De $A$ ({start}) à $B$ ({end}) en $t_f$ = {t_f} s, vitesse nulle aux extrémités ; le bras à {count} instants équidistants, douze intervalles entre les points.",
    ),
    "line_path": (
        "The tool travels {joint} in joint space and {line} on the straight line, along which the least singular value of $J$ is {least}.",
        "L’outil parcourt {joint} dans l’espace articulaire et {line} en ligne droite, où la plus petite valeur singulière de $J$ vaut {least}.",
    ),
    "turn_path": (
        "The tool point travels {joint} in joint space and {line} turning about one axis, on the way of which the least singular value of $J$ is {least}.",
        "Le point de l’outil parcourt {joint} dans l’espace articulaire et {line} autour d’un axe fixe, où la plus petite valeur singulière de $J$ vaut {least}.",
    ),
    "no_line": (
        "The tool travels {joint}; the arm cannot follow the straight line from $A$ to $B$.",
        "L’outil parcourt {joint} ; le bras ne peut pas suivre le segment de $A$ à $B$.",
    ),
    "quintic": ("Quintic motion", "Mouvement polynomial de degré cinq"),
    "from_to": ("From {start} to {end} in $t_f$ = {t_f} s.", "De {start} à {end} en $t_f$ = {t_f} s."),
    "peak_speed": (
        "Peak speeds $15\\,\\Delta q / (8\\,t_f)$ at $t_f/2$ = {time} s: {values}.",
        "Vitesses maximales $15\\,\\Delta q / (8\\,t_f)$ à $t_f/2$ = {time} s : {values}.",
    ),
    "peak_acceleration": (
        "Peak accelerations $10\\,\\Delta q / (\\sqrt{{3}}\\,t_f^2)$ at $t_1$ = {first} s, opposite at $t_2$ = {second} s: {values}.",
        "Accélérations maximales $10\\,\\Delta q / (\\sqrt{{3}}\\,t_f^2)$ à $t_1$ = {first} s, opposées à $t_2$ = {second} s : {values}.",
    ),
}
