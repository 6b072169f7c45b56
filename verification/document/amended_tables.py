r"""Sentences that amend a DH table: "In the second row read $-\theta_2$", "* row 3: add 90° to the angle", "The printer has swapped $l_1$ and $l_2$ in this table".

What they make of the arm is not computed: what is written with it is left open.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from armproof.verification.document.model import Document
from armproof.verification.document.word_lists import WordLists
from armproof.verification.patterns import regex

AMENDED = "amended"  # the table of the arm is, with what the text says
MAY_AMEND = regex(  # what no such sentence lacks, in small letters
    r"table|tableau|\brows?\b|lignes?\b|zeile|tabla|tabela|\bfilas?\b|tabella|\brigh?[ae]\b|linha|these (?:length|angle)|ces (?:longueur|angle)|diese[rn]? (?:länge|winkel)|headings?\b|headers?\b|en-t[êe]tes?|überschrift|cabecera|encabez|intestazion|column|colonne|spalte|colonna|coluna|est[ao]s (?:longitud|ángul|comprim|ângul)|quest[ei] (?:lunghezz|angol)"
    r"|(?:angle|twist|offset|length|winkel|länge|longueur|ángulo|longitud|angolo|lunghezza|ângulo) (?:of|de|du|von|des|del|della|do) .{0,20}?(?:link|joint|segment|corps|articulation|glied|gelenk|eslabón|articulación|giunto|membro|junta)|^\W*[*†‡§¹²³]"
)
_lists = WordLists(r"""
TABLE table tables tableau tabelle tabellen tabla tabella tabela
ROW row rows ligne lignes zeile zeilen fila filas riga righe linha linhas
COLUMN column columns colonne colonnes spalte spalten columna columnas colonna coluna
OTHER_ROWS matrix matrice matriz jacob~ vector vecteur vektor vettore determinant~ système system sistema screw
ENTRY entry entries parameter~ paramètre~ angle~ winkel~ ángul~ angol~ ângul~ twist~ offset~ décalage versatz length~ longueur~ länge~ longitud~ lunghezz~ comprim~ distance~ sign signe vorzeichen signo segno sinal ¤
SIZES length lengths longueur longueurs länge längen longitudes longitud lunghezze lunghezza comprimentos comprimento angle angles winkel ángulos angoli ângulos twists offsets distances entries
OF_ROWS these those ces celles diese dieser diesen estas estos esas queste questi quelle
INSTEAD instead statt anstatt anstelle lieu lugar vez invece posto rather stattdessen plutôt
READ read lies lese lesen gelesen lire lisez lis léase leer leggere leggasi leggi legga ler leia
READER we you one on man can may nous ich wir si se uno i
ADD add added adding addieren addiert addiere addieren hinzu dazu hinzuzufügen zuzählen ajouter ajouté ajoutez ajoutée ajoute sumar suma súmese añadir añada añádase sumarse aggiungere aggiunto aggiunga sommare somar some adicionar plus minus moins más menos più meno mais subtract subtracted subtract~ abziehen abzuziehen soustraire retrancher retranchez restar réstese sottrarre subtrair increase increased decrease decreased increas~ augmenter augmenté erhöhen vergrößer~ aumentar aumentado aumentare diminu~ diminish~ verringer~ shift shifted shift~ verschoben décalé
HAS contains contain contient enthält contiene contém includes inclut
ERROR misprint~ misprinted typo~ mistake wrong incorrect~ erroneous errat~ erreur erreurs faux fausse incorrecte fehler falsch druckfehler tippfehler error erróneo equivocad~ errore sbagliat~ errato erro errad~ swapped exchanged interchanged swap~ interverti~ échangé~ permuté~ inversé~ vertauscht verwechselt intercambi~ scambi~ trocad~ confused confondu~ coquille refuso forgot forgotten forgets missing oublié~ manque vergessen fehlt olvid~ falta dimentic~ manca esquec~
PLAIN common often typical typically avoid careful carefully easily beware likely not no don' never would could if compare check find souvent facilement attention-à évite~ häufig oft leicht si wenn falls nicht kein keine pas aucun aucune ne frecuente comprob~ spesso non não nunca nie nessun ningún nenhum tracking rounding numerical measurement positioning without sans ohne sin senza sem
CHANGED half halved halves twice double doubled doubles triple tripled negative negated negativ negativen moitié double doublées doublés divisées négatives négatifs négatif hälfte halb halbe halben doppelt doppelte doppelten verdoppelt mitad doble dobles duplicadas negativas negativos negativo metà doppio doppie negative negativi raddoppiate metade dobro dobradas negativos opposite opposés opposées entgegengesetzt~ opuest~ oppost~ opost~ reversed inverted flipped multiplied scaled multipliées multipliziert multiplicad~ multiplicar moltiplicat~ multiply multiplied
INSERT insert inserted insérer insérez intercaler einfügen einzufügen eingefügt insertar intercalar inserire inserir
HEADING heading headings header headers title titles titre titres en-tête en-têtes überschrift überschriften cabecera cabeceras encabezado~ intestazion~ cabeçalho~
IGNORE ignore ignored omit omitted delete deleted remove removed disregard drop dropped discard strike crossed ignorer ignorez ignoriere~ omettre omettez supprimer supprimez supprimée weglassen weggelassen streichen gestrichen ignorar ignore ignórese omitir omítase suprimir borrar ignorare ignorate omettere cancellare tralasciare omitir apagar
SHOULD should must ought doit doivent faut soll sollte muss müssen debe deben debería deve devono dovrebbe devem
REPLACE replace replaced change changed correct corrected remplacer remplacé remplacez changer corriger corrigé ersetze ersetzen ersetzt ändere ändern korrigiere korrigieren reemplazar reemplácese sustituir sustitúyase cambiar corregir sostituire sostituisci sostituito cambiare correggere substituir substitua trocar corrigir
BE be être sein werden ser essere have
VALUES value values number numbers numerical valeur valeurs nombres wert werte werten zahlen zahlenwerte valor valores números valori numeri reference link joint frame index
SAME same identical même gleiche gleichen selbe dieselbe derselben misma mismo stessa stesso medesima mesma
BUT but except aber jedoch mais sauf außer nur pero salvo excepto ma però tranne porém exceto apart however only
WITH with avec mit con com
COUNTS counts counted count measured compté comptée compte mesuré mesurée gezählt gemessen zählt contado medido cuenta contato misurato conta
IN_SPACE vertical horizontal~ verticale horizontale senkrechten vertikalen waagerechten verticale orizzontale ground floor sol boden
UNLIKE unlike contrary contrairement anders entgegen diferencia differenza contrariamente contrario contraire contrário diferente differs differ differently abweichend
""")
_is, _has = _lists.holds, _lists.has  # fmt: skip
_MARK = regex(r"\W*(?:\*|†|‡|§|¹|²|³)")
_AMOUNT = regex(r"\d+\s*(?:°|\^|\\circ|deg|grad|rad)|\\pi|π|\d\s*\\?(?:mm|cm|m)\b|^\s*[-−+]?\s*\d+(?:\.\d+)?\s*$")
_IN_WORDS = regex(
    r"(?<!\S)[-−+±]?\d+(?:[.,]\d+)? ?(?:°|degrees?|degrés|grad|grados|gradi|graus|mm|cm) |(?<!\S)[-−+±]\d|π|right angle|quarter turn|angle droit|rechten winkel|ángulo recto|angolo retto"
)
_QUARTERS = {"90": r"\pi/2", "180": r"\pi", "45": r"\pi/4", "270": r"3\pi/2"}
_RIGHT = regex(r"\\d?frac\s*\{?(\d*)\s*\\pi\s*\}?\s*\{?\s*(\d)\s*\}?|\\tfrac\s*\{?(\d*)\\pi\}?\s*\{?(\d)\}?")
_TOO = regex(
    r"(?<!\S)(?:too (?:large|big|small|long|short|high|low|great)|trop (?:grande?|petite?|longue?|courte?|haute?)|zu (?:groß|klein|lang|kurz)|demasiado (?:grande|pequeñ[oa]|larg[oa]|cort[oa])|troppo (?:grande|piccol[oa]|lung[oa]|cort[oa])) "
)
_OF_ERRATUM = regex(r"\W*errat", re.IGNORECASE)  # what is quoted as such, and no sentence
_FAR = 4  # words between what is ignored and its noun
_NEAR_ABOVE, _NEAR_BELOW = 8, 12  # lines between a sentence of rows, or a note, and its table
_OF_ARM = regex(r"alpha|α|theta|θ|twist", re.IGNORECASE)  # in the header of a DH table


@dataclass(frozen=True)
class Cells:
    """Where the table of an arm stands, its last line, and what its cells say."""

    line: int
    end: int
    text: str


def cells_of_tables(document: Document) -> Iterator[Cells]:
    """Yield what the tables of a document that may be of its arm say, in their order; none where the front matter names the arm."""
    if "arm" in document.front or "arms" in document.front:
        return
    arrays = (
        Cells(each.line, each.line + each.latex.count("\n"), each.latex)
        for each in document.displays
        if "array" in each.latex and "alpha" in each.latex
    )
    tables = (
        Cells(each.line, each.line + len(each.rows) + 1, " & ".join(cell for row in each.rows for cell in row))
        for each in (*document.tables, *document.in_code)
        if not each.erratum and _OF_ARM.search(" ".join((*each.header, *(row[0] for row in each.rows if row))))
    )
    yield from sorted((*arrays, *tables), key=lambda each: each.line)


def amends_table(words: str, formulas: Sequence[str], table: Cells, line: int) -> bool:
    """Whether a sentence on a line amends the table of an arm: one that tells what stands there does not."""
    said, shown = words.lower().split(), table.text
    if said[-1:] == ["?"] or (_OF_ERRATUM.match(words) and "printed" in said):
        return False
    is_near = table.line - _NEAR_ABOVE <= line <= table.end + _NEAR_BELOW
    has_table = _has(said, "TABLE")
    if not has_table and _has(said, "OTHER_ROWS"):
        return False
    if not (has_table or is_near):
        return False
    if _MARK.match(words) and _amounts(words, formulas) - _amounts_shown(shown):
        return True
    has_row = has_table or _has(said, "ROW")
    has_row |= _has(said, "COLUMN")
    if not (has_row or MAY_AMEND.search(words.lower())):
        return False
    return any((
        has_row and _reads_otherwise(said),
        _adds(said, words, formulas, shown),
        has_row and (_is_wrong(said) or _TOO.search(words.lower()) is not None),
        _counts_otherwise(said),
        _changes_all(said, has_table),
        has_row and (_ignores(said) or _has(said, "INSERT")),
        _has(said, "HEADING") and _is_wrong(said),
        has_row and _is_replaced(said),
        has_table and _has(said, "UNLIKE"),
    ))  # fmt: skip


def has_same_table(words: str) -> bool:
    """Whether a sentence gives an arm the table of another one, "but" with something else: "The second robot has the same table, but …"."""
    said = words.lower().split()
    place = next((at for at, each in enumerate(said) if _is(each, "SAME")), len(said))
    if not _has(said[place : place + _FAR], "TABLE"):
        return False
    return any(_is(each, "BUT") or _is(each, "WITH") for each in said[place:])


def _reads_otherwise(said: Sequence[str]) -> bool:
    """Whether something is to be read, or taken, instead of what stands there: "read ¤", "¤ instead of ¤"."""
    if _has(said, "INSTEAD") and _has(said, "ENTRY"):
        return True
    places = [at for at, each in enumerate(said) if _is(each, "READ")]
    by_reader = _has(said[: places[0]], "READER") if places else False
    return any("¤" in said[at + 1 : at + 3] or _has(said[max(0, at - 3) : at], "SHOULD") for at in places) and not (
        by_reader or "off" in said or "from" in said or "ab" in said
    )


def _adds(said: Sequence[str], words: str, formulas: Sequence[str], shown: str) -> bool:
    """Whether a size is added that the table has not: "add 90° to the angle"."""
    if not _has(said, "ADD") or _has(said, "HAS"):
        return False
    return bool(_amounts(words, formulas) - _amounts_shown(shown))


def _amounts(words: str, formulas: Sequence[str]) -> set[str]:
    """Return the sizes that a sentence names, as a table would have them."""
    found = {_RIGHT.sub(r"\1\3\\pi/\2\4", each).strip() for each in formulas if _AMOUNT.search(each)}
    found |= {each.group().strip(" +-−±") for each in _IN_WORDS.finditer(words.lower())}
    return {_bare(each) for each in found}


def _amounts_shown(shown: str) -> set[str]:
    plain = _RIGHT.sub(r"\1\3\\pi/\2\4", shown).replace("π", r"\pi")
    numbers = {*re.findall(r"\d+(?:\.\d+)?", shown)} | {degrees for degrees, part in _QUARTERS.items() if part in plain}
    return (
        numbers
        | {_QUARTERS[each] for each in numbers & _QUARTERS.keys()}
        | {"right angle"} & {"right angle" if "90" in numbers else ""}
    )


def _bare(amount: str) -> str:
    """Return the number of an amount, or its part of π."""
    plain = amount.replace("π", r"\pi").replace(" ", "").lstrip("+-−±")
    part = re.search(r"\d*\\pi(?:/\d)?", plain)
    number = re.match(r"\d+(?:\.\d+)?", plain)
    return part.group() if part is not None else number.group() if number is not None else amount


def _is_wrong(said: Sequence[str]) -> bool:
    """Whether something in the table is said to be wrong, or missing, or in another's place."""
    at = [place for place, each in enumerate(said) if _is(each, "ERROR")]
    return bool(at) and not _has(said, "PLAIN")


def _counts_otherwise(said: Sequence[str]) -> bool:
    """Whether an angle in a row counts from a direction in space: no angle of a table does."""
    counted = next((at for at, each in enumerate(said) if _is(each, "COUNTS")), len(said))
    is_in_row = any(_is(each, "ROW") and said[at + 1 : at + 2] != ["¤"] for at, each in enumerate(said))
    return is_in_row and _has(said[counted : counted + _FAR + 2], "IN_SPACE") and not _has(said, "PLAIN")


def _changes_all(said: Sequence[str], has_table: bool) -> bool:
    """Whether the lengths or the angles of the table have another size or sign: "half of these lengths"."""
    for place, word in enumerate(said):
        before, near = said[max(0, place - 2) : place], said[max(0, place - 8) : place + 9]
        of_table = has_table or _has(before, "OF_ROWS")
        if _is(word, "SIZES") and of_table and _has(near, "CHANGED"):
            return not _has(said, "PLAIN")
    return False


def _ignores(said: Sequence[str]) -> bool:
    """Whether a row is to be left out: "Ignore the last row of the table"."""
    for place, word in enumerate(said):
        near = [*said[max(0, place - _FAR) : place], *said[place + 1 : place + 1 + _FAR]]
        if _is(word, "IGNORE") and any(_is(each, "ROW") or _is(each, "COLUMN") for each in near):
            return not _has(said, "PLAIN")
    return False


def _is_replaced(said: Sequence[str]) -> bool:
    """Whether an entry is to be another one: "in row 2 replace ¤ by ¤", "the first length of the table should be zero"."""
    if not _has(said, "ENTRY") or any(_is(each, "PLAIN") or _is(each, "VALUES") for each in said):
        return False
    is_order = _has(said, "REPLACE") and "¤" in said
    should_be = any(
        _is(each, "SHOULD") and (_has(said[at + 1 : at + 4], "BE") or "¤" in said[at + 1 : at + 4])
        for at, each in enumerate(said)
    )
    return is_order or should_be
