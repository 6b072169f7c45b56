"""An arm that a figure tells by vectors, in the notation of the kinematics of solids: what holds of it is proved, and a slip refuted."""

from __future__ import annotations

import pytest

from armproof import verify_text

TOLD = r"""
On pose $\overrightarrow{OA} = a\,\vec{x}_1$ et $\overrightarrow{AB} = b\,\vec{x}_2$, avec $\theta_1 = (\vec{x}_0,\vec{x}_1) = (\vec{y}_0,\vec{y}_1)$ et $\theta_2 = (\vec{x}_1,\vec{x}_2) = (\vec{y}_1,\vec{y}_2)$.
"""
SPATIAL = r"""
On a $\overrightarrow{AB}=H\vec{j}_1+R\vec{i}_1$ et $\overrightarrow{BC}=L\vec{i}_2$. On note $\theta = (\vec{i}_0,\vec{i}_1) = (\vec{k}_0,\vec{k}_1)$ et $\varphi = (\vec{i}_1,\vec{i}_2) = (\vec{j}_1,\vec{j}_2)$.
"""
SLIDES = r"""
Le solide 1 tourne : $\theta = (\vec x_0, \vec x_1)$. Le solide 2 coulisse : $\overrightarrow{OA} = z\,\vec z_0$ ; le solide 3 aussi : $\overrightarrow{AB} = r\,\vec x_1$.
"""
SHOWN = r"""
On a $\overrightarrow{AB}=R\overrightarrow{i_1}$ et $\overrightarrow{BC}=L\overrightarrow{i_2}$.
"""
ANCHORS = {  # two equations that hold, by which the arm is taken
    TOLD: r"""
$$ \vec\Omega_{2/0} = (\dot\theta_1 + \dot\theta_2)\,\vec z_0 $$

$$ \vec x_2 = \cos(\theta_1+\theta_2)\,\vec x_0 + \sin(\theta_1+\theta_2)\,\vec y_0 $$

$$ \vec V(B, 2/0) = a\dot\theta_1\,\vec y_1 + b(\dot\theta_1 + \dot\theta_2)\,\vec y_2 $$
""",
    SPATIAL: r"""
$$ \vec\Omega(2/0) = \dot\theta\,\vec j_1 + \dot\varphi\,\vec k_2 $$

$$ \vec i_2 = \cos\varphi\,\vec i_1 + \sin\varphi\,\vec j_1 $$

$$ \vec V(C, 1/0) = -\dot\theta(R + L\cos\varphi)\,\vec k_1 $$
""",
    SLIDES: r"""
$$ \vec V(B,2/1) = \dot z\,\vec z_0 $$

$$ \vec\Omega(3/0) = \dot\theta\,\vec z_0 $$

$$ \overrightarrow{OB} = z\,\vec z_0 + r\cos\theta\,\vec x_0 + r\sin\theta\,\vec y_0 $$

$$ \vec V(B,3/2) = \dot r\,\vec x_1 $$
""",
    SHOWN: r"""
$$ \overrightarrow{AC} = R(\cos\theta\,\overrightarrow{i_0} + \sin\theta\,\overrightarrow{j_0}) + L\,\overrightarrow{i_2} $$

$$ \overrightarrow{BC} = L\cos(\theta+\varphi)\,\overrightarrow{i_0} + L\sin(\theta+\varphi)\,\overrightarrow{j_0} $$

$$ \overrightarrow{\Omega(2/0)} = (\dot\theta + \dot\varphi)\,\overrightarrow{k_0} $$
""",
}
CLAIMS = [
    (TOLD, r"\vec y_1 = «-¦»\sin\theta_1\,\vec x_0 + \cos\theta_1\,\vec y_0"),
    (TOLD, r"\overrightarrow{OB} = \overrightarrow{OA} + \overrightarrow{AB} = a\,\vec x_1 + «b¦a»\,\vec x_2"),
    (TOLD, r"\vec x_1 \cdot \vec x_2 = «\cos¦\sin»\theta_2"),
    (TOLD, r"\vec x_1 \wedge \vec x_2 = «\sin¦\cos»\theta_2\,\vec z_0"),
    (TOLD, r"\overrightarrow{V_{B \in 2/1}} = b\,«\dot\theta_2¦\dot\theta_1»\,\vec y_2"),
    (TOLD, r"\vec V(B \in S_1/R_0) = \dot\theta_1\,(a\,\vec y_1 + b\,\vec y_«2¦1»)"),
    (TOLD, r"\left.\frac{\mathrm{d}\overrightarrow{OB}}{\mathrm{d}t}\right|_{\mathcal{R}_0} = a\dot\theta_1\,\vec y_1 + b(\dot\theta_1«+¦-»\dot\theta_2)\,\vec y_2"),
    (TOLD, r"\left\{\mathcal{V}_{2/1}\right\} = \left\{\begin{matrix} \dot\theta_2\,\vec z_0 \\ «b¦a»\dot\theta_2\,\vec y_2 \end{matrix}\right\}_B"),
    (TOLD, r"\left\{\mathcal{V}_{2/1}\right\} = \left\{\begin{matrix} \dot\theta_2\,\vec z_0 \\ «\vec 0¦b\dot\theta_2\,\vec y_2» \end{matrix}\right\}_A"),
    (TOLD, r"\vec\Gamma(A, 1/0) = a\ddot\theta_1\,\vec y_1 «-¦+» a\dot\theta_1^2\,\vec x_1"),
    (SPATIAL, r"\vec V(C,2/0) = -R\dot\theta\,\vec k_1 + L(«-¦»\dot\theta\cos\varphi\,\vec k_1 + \dot\varphi\,\vec j_2)"),
    (SPATIAL, r"\left[\frac{d\vec i_1}{dt}\right]_{R_0} = \vec\Omega(1/0)\wedge\vec i_1 = «-¦»\dot\theta\,\vec k_1"),
    (SLIDES, r"\vec V(B,3/0) = \dot z\,\vec z_0 + \dot r\,\vec x_1 + r\dot\theta\,\vec «y¦x»_1"),
    (SHOWN, r"\overrightarrow{V(C,2/0)} = R\dot\theta\,\overrightarrow{j_1} + L(\dot\theta «+¦-» \dot\varphi)\,\overrightarrow{j_2}"),
]  # fmt: skip


def twin(claim: str, is_wrong: bool) -> str:
    for part in claim.split("«")[1:]:
        both = part.partition("»")[0]
        claim = claim.replace(f"«{both}»", both.split("¦")[is_wrong])
    return claim


def verdicts(text: str) -> list[str]:
    return [record.verdict.value for record in verify_text(text).equations]


@pytest.mark.parametrize(("told", "claim"), CLAIMS, ids=[claim for _, claim in CLAIMS])
def test_what_holds_of_the_figure_is_proved_and_its_slip_refuted(told: str, claim: str) -> None:
    for is_wrong, verdict in ((False, "proved"), (True, "refuted")):
        assert verdicts(f"{told}{ANCHORS[told]}\n$$ {twin(claim, is_wrong)} $$\n")[-1] == verdict


def test_the_arm_is_that_of_the_figure() -> None:
    (arm,) = verify_text(TOLD + ANCHORS[TOLD]).arms
    assert (arm.source, arm.line) == ("figure", 2)


OTHERS = {
    "an angle from the vertical": r"""
On a $\overrightarrow{OA}=a\,\vec{x_1}$ et $\overrightarrow{AB}=b\,\vec{x_2}$. L'angle $\theta$ est repéré par rapport à la verticale, $\varphi$ entre les bras.

$$ \vec\Omega_{2/0} = (\dot\theta + \dot\varphi)\,\vec z_0 $$

$$ \vec V(A,1/0) = a\dot\theta\,\vec y_1 $$

$$ \vec x_1 = -\sin\theta\,\vec x_0 + \cos\theta\,\vec y_0 $$
""",
    "an angle between other axes": r"""
On a $\overrightarrow{OA}=a\,\vec x_1$, $\overrightarrow{AB}=b\,\vec x_2$, $\theta_1 = (\vec y_0,\vec x_1)$ et $\theta_2 = (\vec x_1,\vec x_2)$.

$$ \vec V(B,2/0) = a\dot\theta_1\,\vec y_1 + b(\dot\theta_1+\dot\theta_2)\,\vec y_2 $$

$$ \vec\Omega_{2/0} = (\dot\theta_1+\dot\theta_2)\,\vec z_0 $$

$$ \vec x_1 = -\sin\theta_1\,\vec x_0 + \cos\theta_1\,\vec y_0 $$
""",
    "a base that is solid 1": r"""
Le bâti est noté 1.

$$ x_B = l_1\cos\theta_1 + l_2\cos(\theta_1+\theta_2), \quad y_B = l_1\sin\theta_1 + l_2\sin(\theta_1+\theta_2) $$

$$ \vec\Omega_{2/1} = \dot\theta_1\,\vec z_1 $$

$$ \vec\Omega_{3/2} = \dot\theta_2\,\vec z_1 $$
""",
    "links along y": r"""
On pose $\theta_1 = (\vec x_0,\vec x_1)$ et $\theta_2=(\vec x_1,\vec x_2)$ ; les bras sont portés par $\vec y_1$ et $\vec y_2$.

$$ x = -l_1\sin\theta_1 - l_2\sin(\theta_1+\theta_2) $$

$$ y = l_1\cos\theta_1 + l_2\cos(\theta_1+\theta_2) $$

$$ \vec x_1 = \cos\theta_1\,\vec x_0 + \sin\theta_1\,\vec y_0 $$

$$ \vec V(A,1/0) = -l_1\dot\theta_1\,\vec x_1 $$
""",
    "another exercise": f"# Exercice 1\n{TOLD}{ANCHORS[TOLD]}" + r"""
# Exercice 2
Le solide 2 coulisse dans le solide 1, qui tourne d'un angle $\theta_1$.

$$ \vec\Omega_{2/0} = \dot\theta_1\,\vec z_0 $$

$$ \vec V(A,1/0) = \vec 0 $$
""",
    "a torsor at two points": f"{TOLD}{ANCHORS[TOLD]}" + r"""
$$ \{\mathcal{V}_{2/1}\} = \left\{\begin{matrix} \dot\theta_2\vec z_0 \\ \vec 0 \end{matrix}\right\}_A = \left\{\begin{matrix} \dot\theta_2\vec z_0 \\ b\dot\theta_2\vec y_2 \end{matrix}\right\}_B $$
""",
    "letters of points that are coefficients": f"{TOLD}{ANCHORS[TOLD]}" + r"""
On pose

$$ A = a + b\cos\theta_2, \quad B = b\sin\theta_2 $$

$$ x_B = A\cos\theta_1 - B\sin\theta_1 $$
""",
}  # fmt: skip


@pytest.mark.parametrize("kind", OTHERS)
def test_nothing_that_is_right_is_refuted(kind: str) -> None:
    assert "refuted" not in verdicts(OTHERS[kind])
    assert "unreadable" not in verdicts(OTHERS[kind])
