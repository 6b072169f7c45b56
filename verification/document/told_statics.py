r"""What is said of the balance of an arm: "$f$ acts on the tool from outside", "the torques which the drives must deliver so that the arm stays at rest", \tau^T δq + F^T δx = 0.

Torques that hold a force on the tool are -J^T F; J^T F are those with which the tool exerts F. A sentence, or two of a section, that
tell of a force on the tool and of torques that hold it, and a sum of both virtual works that is printed as zero, tell the first.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from armproof.verification.document.word_lists import WordLists
from armproof.verification.patterns import regex

FORCE_ELSEWHERE = "force elsewhere"

MAY_TELL_BALANCE = regex(  # what no such sentence lacks, in small letters
    r"act|exert|push|press|pull|appl|weigh|load|felt|extern|outside|exerc|pouss|appu|agi|subi|appliq|poids|charge|effort|balanc|equilib|équilib|resist|résist|oppos|counter|hold|keep|rest|still|maint|mainten|bouge|immobil|compens|support|along|across|sensor|capteur|component|composante|zieh|tire|tira|puxa"
)
_TOOL = r"(?:tool|tip|hand|gripper|end[ -]?effector|effector|flange|fingers?|arm|robot|manipulator|outil|main|pince|effecteur|organe terminal|bras|robot|préhenseur|extrémité)"
_TO = r"(?:the |its |an? |l' |le |la |son |sa |un |une )?(?:robot' s |last |\S+' s )?"
_FORCE = r"(?:force|wrench|load|weight|push|pull|effort|torseur|poids|charge|poussée|moment|¤)"
_ACTS_ON = regex(
    rf"(?<!\S)(?:acts?|acting|exert(?:s|ed)?|push(?:es|ed|ing)?|press(?:es|ed|ing)?|impos(?:es|ed)|weighs?|pulls?|bears|agit|agissant|s' exerce(?:nt)?|exercée?s?|exerce(?:nt)?|appuie|pousse(?:nt)?|tire) (?:(?!by the )\S+ ){{0,4}}?(?:on|upon|against|sur|contre|à) {_TO}{_TOOL}(?!\w)"
    rf"|(?<!\S)(?:push(?:es|ed|ing)?|press(?:es|ed|ing)?|pulls?|loads?|pousse(?:nt)?|tire(?:nt)? sur) {_TO}{_TOOL} (?:with|by|along|down|up|avec|de|vers)"
    rf"|(?<!\S)(?:{_FORCE} (?:\S+ ){{0,3}}?(?:felt|suffered|received|subie?|ressentie?) (?:by|at|par)|(?:from outside|de l' extérieur)(?= )|(?:external|extérieure?|externe) {_FORCE}|{_FORCE} (?:extérieure?|externe|from outside))"
    rf"|(?<!\S)(?:load|weight|poids|charge) (?:\S+ ){{0,5}}?(?:pulls?|hangs?|tire|pend|acts?|agit)(?= )"
)
_HOLDS = regex(
    r"(?<!\S)(?:balance[sd]?|balancing|equilibrat\S*|resist(?:s|ing)?|opposes?|oppose to|counteract\S*|counterbalance\S*|compensat\S*|withstand|support(?:s|ing)?|(?:s'y |s' y |s' )?oppos\S*|résist\S*|équilibr(?:e|ent|er|ant)|compens\S*|maint(?:ient|iennent|enir)|supporter"
    r"|(?:hold|keep|holds|keeps|holding|keeping) (?:\S+ ){0,5}?(?:still|at rest|in place|immobile|in equilibrium|steady|position|pose|load|force|it|arm|robot)|(?:stays?|remains?|is|be) (?:\S+ )?(?:at rest|still|in equilibrium|motionless|immobile)|(?:does|do) not move|ne (?:bouge|bougent) pas|reste(?:nt)? immobile|au repos|en équilibre)(?!\w)"
)
_IN_EQUILIBRIUM = regex(
    r"(?<!\S)(?:(?:at|in|for|static) (?:\S+ )?equilibrium|equilibrium (?:needs|requires|demands|asks|gives|then|of)|(?:à|en) (?:l' )?équilibre|l' équilibre (?:exige|demande|impose|donne|s' écrit))(?!\w)"
)
_TORQUES = regex(
    r"(?<!\S)(?:torques?|motors?|drives?|actuators?|joints?|controller|couples?|moteurs?|actionneurs?|\\tau|articulaires?)(?!\w)"
)
_LINK = r"(?:(?:first|second|third|last|outer|inner|upper|lower) (?:link|bar|rod|segment|arm|member)|forearm|upper-arm|(?:hand|gripper|tool|sensor|wrist|end-effector|effector|flange)(?: frame| axes|' s (?:frame|axes))?|deuxième (?:segment|barre|bras)|dernier (?:segment|bras)|avant-bras|outil|pince|capteur|unterarms?|greifers?|werkzeugs?)"
_OTHER_AXES = regex(  # of which components are: "along the axes of the gripper", "across the last link"
    rf"(?<!\S)(?:along|across|parallel to|perpendicular to|normal to|selon|suivant|le long (?:de|du)|perpendiculaire(?:ment)? (?:à|au)|längs|entlang|quer zu[mr]?) (?:the |its |l' |la |le |des |den |der |du )*(?:(?:axes|directions?|frame|coordinates|achsen) (?:of |de |du |des )?(?:the |its |l' |la |le )*)?{_LINK}(?!\w)"
    rf"|(?<!\S)(?:in|into|dans) (?:the |its |le |l' )*(?:(?:frame|axes|coordinates|repère) (?:of |de |du )(?:the |its |l' |la |le )*{_LINK}|(?:hand|gripper|tool|sensor|wrist|end-effector|forearm)(?:' s)? (?:frame|axes))(?!\w)"
)
_ELSEWHERE = regex(  # where a force acts that is not on the tool
    r"(?<!\S)(?:acts?|acting|pulls?|pulling|push(?:es|ing)?|press(?:es|ing)?|hangs?|hanging|applied|attacks?|engages?|attached|agit|tire|pousse|appliquée?|greift|wirkt|zieht|angreifend) (?:\S+ ){0,2}?(?:at|on|to|in|against|from|sur|à|au|en|am|an|auf) (?:the |l' |le |la |dem |den |der )*"
    r"(?:elbow|knee|middle|mid-?point|half-?way|centre of|center of|(?:end of the )?(?:first|upper|inner) (?:link|bar|rod|segment|arm)|second joint|joint ¤|forearm|coude|milieu|genou|ellbogen|ellenbogen|mitte)(?!\w)"
)
_is = WordLists("""
FIXED tied fixed fastened hooked knotted suspended hung attached clamped screwed attaché~ fixé~ noué~ accroché~ suspendu~ gebunden befestigt gehängt eingehängt angebracht angebunden geknotet atad~ sujeto sujeta enganchad~ fijad~ legat~ fissat~ appes~ agganciat~ amarrad~ preso presa fixad~ pendurad~
TO to at on onto in around à au aux sur dans autour an am auf um ans en a al alrededor alla allo all' nel nella sul sulla ao na no
INNER hinge~ pivot~ elbow~ knee~ middle midpoint mid-point halfway half-way centre center upper-arm forearm joint charnière~ pivot coude~ genou milieu avant-bras articulation scharnier~ gelenk~ ellbogen~ ellenbogen~ knie mitte oberarm~ unterarm~ bisagra~ codo rodilla mitad medio antebrazo articulación cerniera gomito ginocchio metà mezzo avambraccio giunto dobradiça~ cotovelo joelho meio antebraço junta
TOOL hand hand's tool~ tip gripper~ end-effector effector flange main outil~ pince effecteur greifer~ werkzeug~ endeffektor flansch mano herramienta pinza efector utensile ferramenta garra mão ponta
WALL wall~ floor ceiling table ground mur sol plafond wand boden decke tisch pared suelo techo mesa parete pavimento soffitto parede chão teto
""").holds
_BEHIND = 6  # words within which the place stands
_IS_FORCE = regex(
    r"(?<!\S)(?:forces?|wrench|loads?|weights?|effort|torseur|charge|poids|kraft|kräfte|last|gewicht|fuerza|forza)(?!\w)"
)
_LETTER = regex(r"(?:\\(?:vec|mathbf|boldsymbol|bm|mathrm|mathcal)\s*\{?\s*)*([FfWwHh])(?![A-Za-z])")

_BLANK = regex(r"\\(?:,|;|:|!|\s|left|right|quad)|[\s{}()]|\\(?:mathbf|boldsymbol|bm|mathrm|vec|mathcal)(?![A-Za-z])")
_MOTION = r"(?:\\delta|\\dot|\\Delta|d)?(?:q|\\theta|x|X|p|r)(?:_\w+)?"
_WORK_OF_TORQUES = rf"\\tau(?:_\w+)?\^(?:T|\\top|\\intercal)(?:{_MOTION})?"
_WORK_OF_FORCE = rf"([FfWwHh])(?:_\w+)?\^(?:T|\\top|\\intercal)(?:J)?(?:{_MOTION})?"
_BALANCE = regex(rf"(?:{_WORK_OF_TORQUES}\+{_WORK_OF_FORCE}|{_WORK_OF_FORCE}\+{_WORK_OF_TORQUES})(?:{_MOTION})?=0")


def acts_on_tool(words: str, formulas: Sequence[str]) -> Iterator[str]:
    """Yield the letters of the force of which a sentence says that it acts on the tool; an empty one where it gives it none."""
    if _ACTS_ON.search(words.lower()):
        found = dict.fromkeys(each[1] for formula in formulas if (each := _LETTER.match(formula.strip())) is not None)
        yield from found or ("",)


def is_force_elsewhere(words: str, formulas: Sequence[str]) -> bool:
    """Whether a sentence has the components of a force along a link or in the tool's frame, or the force act on another place than the tool."""
    small = words.lower()
    is_of_force = _IS_FORCE.search(small) is not None or any(_LETTER.match(each.strip()) for each in formulas)
    is_elsewhere = (_OTHER_AXES.search(small) or _ELSEWHERE.search(small)) is not None
    return is_of_force and (is_elsewhere or _is_fixed_to_inner(small.split()))


def _is_fixed_to_inner(said: Sequence[str]) -> bool:
    """Whether something is fixed to an inner part of the arm, in a sentence without its tool: "a rope tied to the hinge between the bars"."""
    if any(_is(word, "TOOL") for word in said):
        return False
    fixed = [place for place, word in enumerate(said) if _is(word, "FIXED")]
    spans = [span for at in fixed for span in (said[at + 1 : at + 1 + _BEHIND], said[max(0, at - _BEHIND) : at])]
    return any(map(_leads_inside, spans))


def _leads_inside(said: Sequence[str]) -> bool:
    """Whether words lead to an inner part of an arm, and to no wall beside it: "to the hinge", "am Gelenk"."""
    to = next((place for place, word in enumerate(said) if _is(word, "TO")), len(said))
    inner = next((place for place, word in enumerate(said) if place > to and _is(word, "INNER")), None)
    return inner is not None and not any(_is(word, "WALL") or word in ",;" for word in said[to:inner])


def holds_arm(words: str) -> bool:
    """Whether a sentence tells of torques, or of motors, that hold the arm against a force."""
    small = words.lower()
    is_of_torques = _HOLDS.search(small) is not None and _TORQUES.search(small) is not None
    return is_of_torques or _IN_EQUILIBRIUM.search(small) is not None


def force_of_balance(latex: str) -> str | None:
    r"""Return the letter of the force in \tau^T δq + F^T δx = 0; None of another equation."""
    found = _BALANCE.fullmatch(_BLANK.sub("", latex.strip().rstrip(".,;")))
    return None if found is None else found[1] or found[2]
