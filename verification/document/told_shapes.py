"""Sentences that put an arm in a posture without its name: the corners of an equilateral triangle, bars that enclose an angle, a level line from shoulder to hand."""

from __future__ import annotations

from collections.abc import Iterator

from armproof.verification.document.word_lists import WordLists
from armproof.verification.patterns import regex

MAY_SHAPE = regex(  # what no such sentence lacks, in small letters
    r"equilater|équilat|equilát|equilát|gleichseitig|isoscel|isósceles|isocèle|gleichschenk|set square|carpenter|équerre|geodreieck|winkelhaken|escuadra|squadra|esquadro|rhomb|losange|raute|rombo|losango|hexagon|sechseck|hexágono|esagono"
    r"|enclos|includ|form|make|span|fait|font|schließ|bilde|encierr|hacen|hace|fanno|racchiud|fazem|encerr"
    r"|horizontal|waagerecht|waagrecht|orizzontal|vertical|senkrecht|lotrecht|vertikal|same height|même hauteur|gleicher höhe|misma altura|stessa altezza|mesma altura"
)
_BARS = r"(?:bars?|links?|arms?|rods?|segments?|forearm|barres?|bras|stäbe|stangen|glieder|arme|barras?|eslabones|brazos|aste|bracci|elos|braços)"
_NUMBER = r"(?:-?\d+(?:[.,]\d+)? ?(?:°|degrees|degrés|grad|grados|gradi|graus)|right angle|angle droit|rechten winkel|ángulo recto|angolo retto|ângulo reto)"
_ENCLOSED = regex(
    rf"(?<!\w){_BARS} (?:\w+ ){{0,3}}?(?:enclose|include|form|make|span|forment|font|schließen|bilden|encierran|forman|hacen|racchiudono|formano|fanno|formam|fazem|encerram) "
    rf"(?:(?:an?|the|un|une|einen|ein|uno|uma?|l') )*(?:(?:inner|interior|winkel|angle|ángulo|angolo|ângulo)(?: (?:of|de|von|di))? )*{_NUMBER}"
)
LEADS_TO_ANGLE = rf"{_BARS} (?:(?!and\b|et\b)\w+ )?(?:enclose|include|form|make|span|forment|font|schließen|bilden|encierran|forman|hacen|racchiudono|formano|fanno|formam|fazem|encerram) (?:an?|un|une|einen|uno|um) (?:angle|winkel|ángulo|angolo|ângulo) (?:of|de|von|di)"
_is = WordLists("""
SHAPE equilateral~ équilatéra~ equiláter~ equilátero gleichseitig~ equilater~ isoscel~ isóscel~ isocèle~ gleichschenkl~ rhombus losange raute rombo losango hexagon~ sechseck~ hexágono esagono set-square équerre geodreieck~ winkelhaken~ escuadra squadra esquadro
LEVEL horizontal~ waagerecht~ waagrecht~ orizzontal~ vertical~ senkrecht~ lotrecht~ vertikal~ same-height
PART shoulder~ elbow~ hand tool base wrist~ tip gripper bars bar links rods épaule coude main outil base poignet barres bras schulter~ ellbogen~ ellenbogen~ hand werkzeug~ greifer~ handgelenk stäbe stangen hombro codo mano herramienta muñeca barras spalla gomito mano utensile polso aste ombro cotovelo mão ferramenta punho
OTHER plane plan ebene plano piano axis axes axe achse~ eje ejes asse assi eixo~ gravity pesanteur schwerkraft gravedad gravità gravidade gravitation project~ projekt~ proyec~ proiez~ proje~ component~ composante~ komponente~ componente~ force~ kraft fuerza forza força distance~ abstand distancia distanza distância coordinate~ coordonnée~ koordinate~ coordenada~ coordinat~ direction~ richtung dirección direzione direção axial joint joints motion~ move~ turn~ slide~ slid~ glissi~ lift~ velocity speed angle~ winkel ángulo angolo ângulo if when si wenn quand cuando quando se position~
""").holds
_JOINED = regex(r"\b(?:same height|même hauteur|gleicher höhe|misma altura|stessa altezza|mesma altura)\b")
_SET_SQUARE = regex(r"\b(?:set|carpenter(?:'s|s'?)?|try|engineer'?s?) square")
_SENTENCE = regex(r"[^.;!?]+")
_WORD = regex(r"[\w'-]+")
_FEWEST = 2  # parts of the arm that a level line joins


def shapes(text: str) -> Iterator[tuple[int, str]]:
    """Yield the words of a text that put the arm in a posture by a shape, by the angle that its bars enclose, or by what is level, each with its place."""
    small = text.lower()
    if not MAY_SHAPE.search(small):
        return
    for sentence in _SENTENCE.finditer(small):
        plain = _SET_SQUARE.sub("set-square", _JOINED.sub("same-height", sentence.group()))
        said = _WORD.findall(plain)
        parts = {word for word in said if _is(word, "PART")}
        shape = next((word for word in said if _is(word, "SHAPE")), None)
        level = next((word for word in said if _is(word, "LEVEL")), None)
        if shape is not None and parts:
            yield sentence.start(), shape
        elif (enclosed := _ENCLOSED.search(plain)) is not None:
            yield sentence.start(), enclosed.group()
        elif level is not None and len(parts) >= _FEWEST and not any(_is(word, "OTHER") for word in said):
            yield sentence.start(), level
