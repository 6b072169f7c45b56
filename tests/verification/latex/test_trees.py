"""What a display is read as: the tree of each notation, written out, and the place at which each of its nodes stands."""

from __future__ import annotations

import pytest

from armproof.verification.errors import ReadError
from armproof.verification.latex import nodes as n
from armproof.verification.latex.items import Differential
from armproof.verification.latex.reader import Reader

SIGNS = {"": " ", "⋅": " ⋅ ", "×": " × "}


def shown(node: object) -> str:
    """Return a tree as text, every node of it in its own brackets."""
    match node:
        case n.Number():
            return str(node.value)
        case n.Name():
            return repr(node.text) if node.base == "words" else node.key
        case n.JointAngles():
            return "".join(f"{'+' if sign > 0 else '-'}{index}" for sign, index in node.terms)
        case n.Call():
            return f"{node.function}({', '.join(map(shown, node.arguments))})"
        case n.Sum():
            return "(" + " ".join(f"{sign} {shown(term)}" for sign, term in node.terms) + ")"
        case n.Product():
            operators = (*(SIGNS[each] for each in node.operators), "")
            return "(" + "".join(f"{shown(f)}{o}" for f, o in zip(node.factors, operators, strict=True)) + ")"
        case n.Quotient():
            return f"({shown(node.numerator)} / {shown(node.denominator)})"
        case n.Ambiguous():
            return " or ".join(map(shown, node.readings))
        case n.Power():
            return f"{shown(node.base)}**{shown(node.exponent)}"
        case n.Postfix():
            return f"{shown(node.base)}^<{node.operator}>"
        case n.Group():
            return f"{node.brackets[0]}{shown(node.inner)}{node.brackets[1]}"
        case n.Sequence():
            return f"{node.brackets[0]}{', '.join(map(shown, node.items))}{node.brackets[1]}"
        case n.Matrix():
            return f"{node.environment}[{'; '.join(', '.join(map(shown, row)) for row in node.rows)}]"
        case n.Derivative():
            return f"d{node.order}({shown(node.operand)})/d({shown(node.variable)})"
        case Differential():
            return f"∂{node.order}({shown(node.operand) if node.operand else ''})"
        case n.Labelled():
            label = [shown(node.label)] if node.label is not None else []
            return f"{shown(node.inner)}_[{', '.join([*label, *map(str, node.size or ())])}{node.unread}]"
        case n.At():
            return f"{shown(node.inner)}|({', '.join(f'{shown(a)} = {shown(b)}' for a, b in node.values)})"
        case n.Cases():
            return "{" + "; ".join(f"{shown(value)} : {condition}" for value, condition in node.branches) + "}"
        case n.Dots():
            return "…"
        case n.Layout():
            return "<" + "; ".join(map(shown, node.statements)) + ">"
        case n.Chain():
            relations = (*(f" {each} " for each in node.relations), "")
            return "".join(f"{shown(m)}{r}" for m, r in zip(node.members, relations, strict=True))
        case n.Connective():
            return f"[{node.kind}{f' {node.text}' if node.text != node.kind else ''}]"
    raise AssertionError(node)


def read(latex: str, reader: Reader | None = None) -> str:
    """Return what a display is read as."""
    return "; ".join(map(shown, (reader or Reader()).read(latex)))


READ = {
    "sums and products": r"""
a - b + c \pm d \mp e  ⟶  (+ a - b + c ± d ∓ e)
-a + b  ⟶  (- a + b)
a b \cdot c d  ⟶  (a b ⋅ c d)
a \cdot b c \times d  ⟶  ((a ⋅ b c) × d)
a \cdot -b  ⟶  (a ⋅ (- b))
a . b \quad a * b \quad a \bullet b \quad a \circ b \quad a \wedge b \quad a \div b \quad a. \quad a .  ⟶  (a ⋅ b); (a ⋅ b); (a ⋅ b); (a ⋅ b); (a × b); (a / b); a; a
a \times b c \cdot (d \times e) f  ⟶  (a × (b c) ⋅ ((d × e)) f)
a \cdot b \times c \cdot d  ⟶  ((a ⋅ b) × c ⋅ d)
""",
    "quotients": r"""
a / b c  ⟶  ((a / b) c) or (a / (b c))
a b / c  ⟶  ((a b) / c)
a / 2 c \quad 2 a / 3 b \quad a b / c d  ⟶  (a / (2 c)) or ((a / 2) c); ((2 a) / (3 b)) or (((2 a) / 3) b); (((a b) / c) d) or ((a b) / (c d))
2/3 b  ⟶  ((2 / 3) b)
a/b/c  ⟶  ((a / b) / c)
a/(b c) \quad (a b)/c  ⟶  (a / ((b c))); (((a b)) / c)
\frac12x \quad \frac123 \quad \frac1{ab} \quad \frac ab \quad \dfrac{a + b}{2} \quad \frac{a = b}{2}  ⟶  ((1 / 2) x); ((1 / 2) 3); (1 / (a b)); (a / b); ((+ a + b) / 2); (<a = b> / 2)
\frac a2 x \quad \frac a{b} x \quad \cos(\text{pitch})  ⟶  ((a / 2) x); ((a / b) x); cos(pitch)
{a \over b} {a + 1 \over {b \over c}}  ⟶  ({(a / b)} {((+ a + 1) / {(b / c)})})
{2 a \over b + 1} \quad \sqrt{{a \over b}} = {a \over b}  ⟶  {((2 a) / (+ b + 1))}; sqrt({(a / b)}) = {(a / b)}
""",
    "powers and what is applied from above": r"""
x^2 y_1^3 (a + b)^2 {x}^2 {2}^3 {a + b}^2 {\cos x}^2 [a]^2  ⟶  (x**2 y_1^3 ((+ a + b))**2 x**2 2**3 {(+ a + b)}**2 cos(x)**2 [a]**2)
a^{-1} A^{-T} J^{+} J^\dagger J^{\#} 90^\circ 30^o 45\degree  ⟶  (a^<-1> A^<-T> J^<+> J^<+> J^<+> 90^<deg> 30^<deg> 45^<deg>)
a^{b + 1} a^b a^{1/2} (a)^b  ⟶  (a**(+ b + 1) a**b a**(1 / 2) (a)**b)
\theta_1^* c^* x^* \quad \cos^*\theta_1  ⟶  (theta_1 c x^*); cos(theta_1)
(x)_2 \quad x'{}_2 \quad 3_2 \quad \sqrt{x}_1 \quad (a)_{(0)}  ⟶  '(x)_2'; x'_2; '3_2'; '\\sqrt{x}_1'; (a)
R{}^T \quad R{}^T \cdot p  ⟶  R^<T>; (R^<T> ⋅ p)
[a b]^T \quad [a + b]^T \quad [a b] \quad [a \cdot b]^T \quad [-1 0]^T \quad [c_1 2 x]^T \quad (a b)^T \quad [a (b + d) c]^T \quad [a b]^{-1}  ⟶  [a, b]^<T>; [(+ a + b)]^<T>; [(a b)]; [(a ⋅ b)]^<T>; [(- (1 0))]^<T>; [cos(+1), 2, x]^<T>; ((a b))^<T>; [(a ((+ b + d)) c)]^<T>; [(a b)]^<-1>
""",
    "names": r"""
T^0_1 T_1^0 {}^0T_1 {}^0_1T {}_1^0T ^0T_1 ^0_1T  ⟶  (T_1^0 T_1^0 {}^0T_1 {}^0_1T {}^0_1T {}^0T_1 {}^0_1T)
{}^0T_{04} {}^0\!A_{06} {}^{i-1}T_{i-1,i} {}^0T_{0E} {}^0p_{0,4} {}^0R_{0n}  ⟶  ({}^0T_4 {}^0A_6 {}^i-1T_i {}^0T_E {}^0p_0,4 {}^0R_n)
{}^0T_{14} {}^eT_{ee} {}^BT_{Base} {}^0T_0 {}^0_1T_{04}  ⟶  ({}^0T_14 {}^eT_ee {}^BT_Base {}^0T_0 {}^0_1T_04)
^0_1T^1_2T \quad ^0T_1^1T_2 \quad {}^0T_1 {}^1T_2^{-1}  ⟶  ({}^0_1T {}^1_2T); ({}^0T_1 {}^1T_2); ({}^0T_1 {}^1T_2^<-1>)
^0T_1^T \quad ^0T_1^2 \quad ^0_1T_2 \quad ^0T^1T \quad ^0_1T^{1}_{2}T^2_3T  ⟶  {}^0T_1^<T>; {}^0T_1**2; {}^0_1T_2; ({}^0T {}^1T); ({}^0_1T {}^1_2T {}^2_3T)
p_1^2 p_x^2 p_1^0 p_{i-1}^2 l_1^2 {}^0p_2^2  ⟶  (p_1^2 p_x**2 p_1^0 p_i-1^2 l_1**2 {}^0p_2**2)
p_1^{i} p_{1x}^2 p_a^2 v_1^{12} T_1^{ab} A^2 A_1^2 R^2 x_1^n x_a^{bcde} x^b l_1^n l_1^k l_1^{ab} l_1^{abcd} l^0 \quad {}^0R_1^2 \quad {}^0p_1^{i}  ⟶  (p_1^i p_1x**2 p_a**2 v_1^12 T_1^ab A**2 A_1^2 R**2 x_1^n x_a^bcde x**b l_1**n l_1**k l_1^ab l_1**abcd l^0); {}^0R_1**2; {}^0p_1^i
z_{1(0)} O_{2(1)} \theta_{1(0)}  ⟶  ({}^0z_1 {}^1O_2 theta_1(0))
R_{3\times 3} I_{3\times 3} p_{3\times 1} J_{6\times n} 0_{3\times 1} 0_{2 \times 2} 1_{2\times 2}  ⟶  (R I_3x3 p J_6xn zeros[0; 0; 0] zeros[0, 0; 0, 0] 1)
\theta_2^{(+)} \theta_2^{(-)} \theta_2^{(\pm)} \theta_2^{(\mp)}  ⟶  (theta_2^(+) theta_2^(-) theta_2^(pm) theta_2^(mp))
\theta_4^{(a)} \theta_5^{(II)} q_1^{(up)} q_1^{(\text{down})} \theta_2^{A} \theta_2^{down} x^{(a)}  ⟶  (theta_4^(a) theta_5^(II) q_1^(up) q_1^(down) theta_2^A theta_2^down x^(a))
e^{(a)} \quad l_1^{(\alpha)} \quad R_1^{(T)} \quad l_1^{down} \quad l_1^{(a+b)} \quad 2^{(n)}  ⟶  e**(a); l_1**(alpha); R_1**(T); l_1**down; l_1**((+ a + b)); 2**(n)
x_1' x'_1 x'' x^{\prime} x'''  ⟶  (x'_1 x'_1 x'' x' x''')
x_1_2 T_1^0^2  ⟶  (x_1,2 T_1^0,2)
x_{\text{max}} x_{\mathrm{tool}} x_{a,b} x_{i+1} x_{ 1 } T_{\mathrm{A}}^{\mathrm{B}}  ⟶  (x_max x_tool x_a,b x_i+1 x_1 T_A^B)
\dot x \ddot{y}_1 \dddot{q} \dot{x_1} \dot{\mathbf{p}} \dot{\theta}_1^2 {\dot x}_1 \dot{x}_1'  ⟶  (dot x dotdot y_1 dotdotdot q dot x_1 dot p dot theta_1**2 dot x_1 dot x'_1)
\overset{.}{x} \overset{\cdot\cdot}{y} \stackrel{.}{x} \underset{n}{x} \overset{\rightarrow}{x} \underset{n}{a b}  ⟶  (dot x dotdot y dot x x_n x (a b))
\mathbf{J} \mathrm{J}_v \mathbf{R}_1^T \boldsymbol\theta_1 \vec{p} \mathrm{tool} \mathcal{F}  ⟶  (J J_v R_1^<T> theta_1 p tool F)
\msf{T}_{03} \mathbfit{p}_3 \mat{R}_1 \vect{p}_2 \vb{x} \bs\theta_1 \mat{T_3}^{-1}  ⟶  (T_03 p_3 R_1 p_2 x theta_1 T_3^<-1>)
\est{q}_1 \foo{T}_3^0 \inv{R} \des{\theta}_{2} \est{q}_1'  ⟶  (est q_1 foo T_3^0 inv R des theta_2 est q'_1)
\hat{x} \hat{T} \bar{x} \tilde{y}_1 \hat{\theta} \widehat{z} \hat\omega \hat q  ⟶  (hat x T bar x tilde y_1 hat theta z omega hat q)
\alpha \varphi \vartheta \ell_2 \varepsilon \pi \infty  ⟶  (alpha phi theta l_2 epsilon pi infty)
theta_1 theta1 alpha WC_x  ⟶  (theta_1 theta_1 alpha WC_x)
l1 q12 C12 q3x x2.5 \theta_1 2 x3 \pi 2  ⟶  (l_1 q_12 cos(+1+2) q_3 x x 5/2 theta_1 2 x_3 pi 2)
elbow up \quad mass \quad abc \quad abcd \quad xyzw  ⟶  (elbow u p); mass; (a b c); abcd; xyzw
x_\mathrm{ab} x_\text{max} x^\alpha y_\alpha \boxed x + {a} \vec{AB} \hat{xy} \vec{p}  ⟶  (+ (x_ab x_max x**alpha y_alpha x) + (a {(A B)} {(hat x y)} p))
\angle ABC \angle x  ⟶  (angleABC angle x)
{{}^0T}_1 {{}_1^0T} {{}_1T}  ⟶  ({}^0T_1 {}^0_1T {}_1T)
{C}_1 {T}^0_1 {x_1}^2 {^0}T_1 {_1^0}T {^{i-1}}T_i {^0p}_2  ⟶  (cos(+1) T_1^0 x_1**2 {}^0T_1 {}^0_1T {}^i-1T_i {}^0p_2)
R[0,1] R[0,1]^T T[0, 2] R[0,x] R(0,1) R_1[0,1] Q[0,1]  ⟶  (R_0,1 R_0,1^<T> T_0,2 R [0, x] name(R, 0, 1) name(R_1, 0, 1) name(Q, 0, 1))
\underset{\text{wrist}}{p} \quad \underset{{\text{tool}}}{{p}} \quad p^{\text{des}} \quad p^{\text{T}} \quad x^{\text{ab}}_1 \quad x_12 \quad x^12  ⟶  p_wrist; p_tool; p^des; p^<T>; x_1^ab; x_12; (x**1 2)
MGDpos = p_4 \quad TCPpose = x \quad x = MGDpos  ⟶  MGD_pos = p_4; TCP_pose = x; x = (M G D p o s)
""",
    "cosines": r"""
c_1 s_{12} C_{123} S_{1-2} c_{-1} c_{1,2} c_{1+2} C12 s3  ⟶  (cos(+1) sin(+1+2) cos(+1+2+3) sin(+1-2) cos(-1) cos(+1+2) cos(+1+2) cos(+1+2) sin(+3))
c_i s_{i-1} c_{n-1} c_k c_x s_l c_{ij}  ⟶  (cos(theta_i) sin(theta_i-1) cos(theta_n-1) cos(theta_k) c_x s_l c_ij)
c_{\theta_1} s_{\alpha_i} c_{\theta_1 + \theta_2} c_{q_1 q_2} s_{\theta 1} c_{q1} c_{\theta_1 a} c_{\cos\theta_1} c_{\theta_1 + \pi}  ⟶  (cos(theta_1) sin(alpha_i) cos((+ theta_1 + theta_2)) cos((+ q_1 + q_2)) sin(theta_1) cos(q_1) c_theta_1a c_costheta_1 cos((+ theta_1 + pi)))
c_2^{(a)} s_{23}^{(2)} c_{1-2}^{(up)} c_2^{(x+1)}  ⟶  (cos(theta_2^(a)) sin((+ theta_2^(2) + theta_3^(2))) cos((+ theta_1^(up) - theta_2^(up))) cos(+2)**((+ x + 1)))
c_1^2 s^2_1 c_{1}^{-1} C_1^T  ⟶  (cos(+1)**2 sin(+1)**2 cos(+1)^<-1> cos(+1)^<T>)
c\theta_1 s\alpha_i C\theta s(\theta_1) C(\theta_1 + \theta_2)^2 c{\theta_1} s[\theta_1] c^2\theta_1 s^2(\theta_1) c\theta_1^2  ⟶  (cos(theta_1) sin(alpha_i) cos(theta) sin(theta_1) cos((+ theta_1 + theta_2))**2 cos(theta_1) sin(theta_1) cos(theta_1)**2 sin(theta_1)**2 c theta_1**2)
c x s(x) c(2) c(\pi) c(\theta_1 a) c(\cos\theta_1)  ⟶  (c x s (x) c (2) cos(pi) c ((theta_1 a)) c (cos(theta_1)))
c\dot\theta_1 s \dot{q}_1 s  ⟶  (c dot theta_1 s dot q_1 s)
c'_1 c {}^0c_1 \dot c_1  ⟶  (c'_1 c {}^0c_1 dot c_1)
\cos\theta_1 \sin(\theta_1) \tan\left(x\right) \cot[x] \sec x \csc x  ⟶  (cos(theta_1) sin(theta_1) tan(x) cot(x) sec(x) csc(x))
\cos 2\theta_1 \sin 2(x) \cos 3 \cos 2 \sin x \cos 2 \frac{x}{3}  ⟶  (cos((2 theta_1)) sin((2 (x))) cos(3) cos(2) sin(x) cos((2 (x / 3))))
\cos^2\theta_1 \sin^2(x) \cos^{-1}x \tan^{-1}(y, x) \sin^{-1}(x)^2 \cot^{-1}x \sin(x)^2 \sin x^2  ⟶  (cos(theta_1)**2 sin(x)**2 acos(x) atan2(y, x) asin(x)**2 cot(x)^<-1> sin(x)**2 sin(x**2))
\cos_1 \sin_{12} \cos_{\theta_1} \cos_i \cos_1^2  ⟶  (cos(+1) sin(+1+2) cos(theta_1) cos(theta_i) cos(+1)**2)
\arctan(y, x) \arctan(y) \arctan2(y, x) \operatorname{atan}_2(y, x) \arctan 2 x \text{Atan2}(y, x)  ⟶  (atan2(y, x) atan(y) atan2(y, x) atan2(y, x) atan((2 x)) atan2(y, x))
a\tan 2(y, x) a \tan 2(y + x) A\tan2(y, x) a \tan x a\,\tan 2 (f(y, x), (z)) a \tan 2 ((y, x))  ⟶  (atan2(y, x) a tan((2 ((+ y + x)))) atan2(y, x) a tan(x) atan2((f (y, x)), (z)) a tan((2 ((y, x)))))
cos(x) sin x acos(x)  ⟶  (cos(x) sin(x) acos(x))
\sqrt{x} \sqrt x \sqrt2 \sqrt(x) \sqrt[2]{x} \sqrt{x}^2  ⟶  (sqrt(x) sqrt(x) sqrt(2) sqrt(x) sqrt(x) sqrt(x)**2)
\det J \det(J)^2 \det A B \operatorname{tr}(R) \operatorname{rank} J \det 2 J  ⟶  (det(J) det(J)**2 det(A) B tr(R) rank(J) det(2) J)
c_θ \quad s_{θ} \quad c_φ \quad S(\theta_2) \quad S(a) \quad S(\alpha) \quad 0\sin35 \quad \sin 35^\circ \quad \cos 3x  ⟶  cos(theta); sin(theta); cos(phi); sin(theta_2); name(S, a); sin(alpha); (0 sin(35)); sin(35^<deg>); cos((3 x))
\det_1 s \quad \det{A} B \quad \det A^T \quad \det A_1^2  ⟶  '\\det_1 s'; (det(A) B); det(A^<T>); det(A_1^2)
""",
    "rotations and applied names": r"""
R_z(\theta_1) R_{z,\theta_1} R_{x, \alpha_1}^T R_{z;\theta} R_z(\theta)^{-1} R_{z_1}(\theta) R_{X}(\theta) R_z^T(\theta)  ⟶  (Rot3(z, theta_1) Rot3(z, theta_1) Rot3(x, alpha_1)^<T> Rot3(z, theta) Rot3(z, theta)^<-1> Rot3(z, theta) Rot3(x, theta) name(R_z, theta)^<T>)
Rot_z(\theta_1) Rot_{z,\theta_1} Rot_{z,\theta_1}^T Rot(z, \theta_1) Trans_{x, a_1} Trans_x(a) Rot_z^T(\theta) Rot_{z}(\theta)^{-1}  ⟶  (Rot(z, theta_1) Rot(z, theta_1) Rot(z, theta_1)^<T> Rot(z, theta_1) Trans(x, a_1) Trans(x, a) Rot(z, theta)^<T> Rot(z, theta)^<-1>)
T_x(a_1) T_x(\theta_1) D_z(d_1) R_w(x) R_{x}(a, b) {}^0R_z(\theta)  ⟶  (Trans(x, a_1) name(T_x, theta_1) Trans(z, d_1) name(R_w, x) name(R_x, a, b) name({}^0R_z, theta))
R_{0,1} R_{ab} R_{x,a} R_{x, y\alpha}  ⟶  (R_0,1 R_ab R_x,a Rot3(x, (y alpha)))
J(q) J(\theta_1, \theta_2) f(x) f(x, y) g(q, t) f_1(x) a_1(x) T(\theta) J^T(q) J(q)^T J^{-1}(\theta_1) J'(q)  ⟶  (name(J, q) name(J, theta_1, theta_2) name(f, x) f (x, y) name(g, q, t) name(f_1, x) name(a_1, x) name(T, theta) name(J, q)^<T> name(J, q)^<T> name(J, theta_1)^<-1> name(J', q))
p(0) x(1) w(2)  ⟶  (p (0) x (1) w (2))
p(0, 0) p_1(\theta_1) w(0, 0) x(t) x(y) p_x(q) h(a + b) K(x) K(a + b) d(t) p(x, y) a(x, y) a(q)  ⟶  (name(p, 0, 0) name(p_1, theta_1) w (0, 0) name(x, t) name(x, y) name(p_x, q) h ((+ a + b)) name(K, x) K ((+ a + b)) name(d, t) name(p, x, y) a (x, y) name(a, q))
S(v) S(\theta) S_1(v) C(v) R(\phi, \theta)  ⟶  (name(S, v) sin(theta) sin(+1) (v) C (v) name(R, phi, theta))
A_1(0) A_1(90^\circ) T(1, 2) T(\pi/2) T(2 \theta_1) T(2\theta_1, 0) J(x_1, 0) l(2) \theta_1(0) J(2 l) T(30^{-1})  ⟶  (name(A_1, 0) name(A_1, 90^<deg>) name(T, 1, 2) name(T, (pi / 2)) T ((2 theta_1)) name(T, (2 theta_1), 0) J (x_1, 0) l (2) theta_1 (0) J ((2 l)) T (30^<-1>))
{T_1^0}(\theta_1) {J}(q) {x_1}(y)  ⟶  (name(T_1^0, theta_1) name(J, q) name(x_1, y))
J^2(q) \quad {[a]}^T(q) \quad \alpha(\theta_1) \quad \mathrm{pos}(\theta_1) \quad \theta(t) \quad \mathrm{pos}(x + y) \quad \alpha(x, y)  ⟶  (J**2 (q)); ({[a]}^<T> (q)); name(alpha, theta_1); name(pos, theta_1); name(theta, t); (pos ((+ x + y))); (alpha (x, y))
""",
    "derivatives": r"""
\frac{\partial x}{\partial y} \frac{\partial}{\partial y} x \frac{\partial^2 x}{\partial y^2} \frac{\partial^3}{\partial y^3} x  ⟶  (d1(x)/d(y) d1(x)/d(y) d2(x)/d(y) d3(x)/d(y))
\frac{\partial x y}{\partial t} \quad \partial x / \partial y \quad \partial x \quad \frac{\partial x_1}{\partial q} a  ⟶  d1((x y))/d(t); d1(x)/d(y); ∂1(x); (d1(x_1)/d(q) a)
\frac{dx}{dt} \quad \frac{d x y}{dt} \quad \frac{d^2 x}{dt^2} \quad \frac{d}{dt} x \quad \frac{d^2}{dt^2} x \quad \frac{\delta x}{\delta y} \quad \frac{d^3 x}{dt^3} \quad \frac{d x \cdot y}{dt}  ⟶  d1(x)/d(t); d1((x y))/d(t); d2(x)/d(t); d1(x)/d(t); d2(x)/d(t); d1(x)/d(y); d3(x)/d(t); d1((x ⋅ y))/d(t)
\frac{d^2 x}{dt} \quad \frac{dx}{dy z} \quad \frac{d x}{\delta y} \quad \frac{x}{dt} \quad \frac{d^4 x}{dt^4} \quad \frac{d}{t} \quad \frac{d_1 x}{d_1 t}  ⟶  ((d**2 x) / (d t)); ((d x) / (d y z)); ((d x) / (delta y)); (x / (d t)); ((d**4 x) / (d t**4)); (d / t); ((d_1 x) / (d_1 t))
\dot{a b} \quad \ddot{(x y)} \quad \dot{2}  ⟶  d1((a b))/d(t); d1(d1(((x y)))/d(t))/d(t); d1(2)/d(t)
\frac{\partial^2 x}{\partial y \partial z} \quad \frac{\partial^3 x}{\partial y \partial z \partial w} \quad \frac{\partial^3 x}{\partial\theta_1^2 \partial\theta_2}  ⟶  d1(d1(x)/d(z))/d(y); d1(d1(d1(x)/d(w))/d(z))/d(y); d2(d1(x)/d(theta_2))/d(theta_1)
""",
    "brackets, bars and braces": r"""
(a, b) \quad [a, b] \quad \{a, b\} \quad \left\{a\right\} \quad (a; b) \quad (a) \quad \left[a\right. \quad \left( a \right] \quad \left.a\right) \quad \{a, b\}^2 \quad \left\{a, b\right\}  ⟶  (a, b); [a, b]; {a, b}; {a}; (a, b); (a); [a]; (a); {a}; {a, b}**2; {a, b}
|x| \quad |x + y|^2 \quad \lVert p \rVert \quad \|p\| \quad ||p|| \quad \left|x\right| \quad |A| \quad l |s| \quad \lvert x \rvert \quad a|b|c \quad a |b \quad \abs{x} \quad \norm{p}  ⟶  abs(x); abs((+ x + y))**2; norm(p); norm(p); norm(p); abs(x); abs(A); (l abs(s)); abs(x); (a abs(b) c); a; [words |]; b; abs(x); norm(p)
a |b| |c| d |e| \quad |a| + |b| \quad |a||b| \quad \left|a\right| |b| \quad a |b| = |c|  ⟶  (a abs(b) abs(c) d abs(e)); (+ abs(a) + abs(b)); (abs(a) abs(b)); (abs(a) abs(b)); (a abs(b)) = abs(c)
F|_{x = 0} \quad \left. F \right|_{x = 0, y = 1} \quad (a b)|_{x=1} \quad F_{x=0} \quad F_1^2|_{x = 0}  ⟶  F|(x = 0); F|(x = 0, y = 1); ((a b))|(x = 1); F_x=0; F_1**2|(x = 0)
\underbrace{a}_{b} \overbrace{a + b}^{c} \underbrace{T}_{4 \times 4} \underbrace{a}_{\text{term 1}} \underbrace{a}_{\text{zero}} \underbrace{a}_{0} \underbrace{a}_{=b} \underbrace{a}_{2} \underbrace{x}_{a + } \underbrace{x}_{(2\times 3)} \underbrace{x}  ⟶  (a_[b] (+ a + b)_[c] T_[4, 4] a_[] a_[\text{zero}] a_[0] a_[b] a_[] x_[a + ] x_[2, 3] x_[])
\|p_2\|_2 \quad \|p_2\|^2_2 \quad \|p\|_1 \quad \|p\|_x \quad |x|_2 \quad p|_{x=0, y=1}^2 \quad |a|_1 = |b|  ⟶  norm(p_2); norm(p_2)**2; '\\|p\\|_1'; '\\|p\\|_x'; '|x|_2'; p|(x = 0, y = 1)**2; '|a|_1' = abs(b)
a \| b \quad \|a\| b \|c\| \quad l \|s\| \quad a || b || c \quad s ‖p‖ \quad 2\|p_2\| = 0 \quad a |b| = c |d|  ⟶  a; [words |]; b; (norm(a) b norm(c)); (l norm(s)); (a norm(b) c); (s norm(p)); (2 norm(p_2)) = 0; (a abs(b)) = (c abs(d))
""",
    "matrices and lines": r"""
\begin{bmatrix} a & b \\ c & d \end{bmatrix}^T \begin{array}{cc} a & b \end{array} \left[\begin{matrix} a \\ b \end{matrix}\right]  ⟶  (bmatrix[a, b; c, d]^<T> array[a, b] [matrix[a; b]])
\begin{bmatrix} a && b \\ \\ c && d \end{bmatrix} \quad \begin{bmatrix} a, & b, \\ c & d \end{bmatrix}  ⟶  bmatrix[a, b; c, d]; bmatrix[a, b; c, d]
\begin{bmatrix} \text{if so} x & y \end{bmatrix} \quad \begin{bmatrix} \cdot & a \\ \vdots & \ddots \end{bmatrix}  ⟶  bmatrix['if so', y]; bmatrix[…, a; …, …]
\matrix{a & b \cr c & d} \quad \pmatrix{a \cr b}  ⟶  matrix[a, b; c, d]; pmatrix[a; b]
\begin{vmatrix} a & b \\ c & d \end{vmatrix} \quad \left|\begin{matrix} a & b \\ c & d \end{matrix}\right| \quad \left[\begin{bmatrix} a \end{bmatrix}\right]  ⟶  vmatrix[a, b; c, d]; det(matrix[a, b; c, d]); [bmatrix[a]]
\begin{cases} a & x > 0 \\ b & \text{otherwise} \end{cases} \quad \begin{cases} a = b \\ c = d \end{cases} \quad \begin{cases} a \\ b, & x = 1 \end{cases}  ⟶  {a : x > 0; b : \text{otherwise}}; a = b; c = d; {a : ; b : x = 1}
\begin{aligned} a \end{aligned} \quad \begin{aligned} a &= b \\ &= c \end{aligned} \quad \begin{array}{l} a = b \\ c = d \end{array}  ⟶  a; a = b = c; a = b; c = d
x = \left\{ \begin{array}{l} b \\ c \end{array} \right. \quad \left\{ \begin{array}{l} b = 1 \\ c = 2 \end{array} \right. \quad x = \begin{aligned} & a + b \end{aligned}  ⟶  x = array[b; c]; b = 1; c = 2; x = (+ a + b)
\begin{array}{rcl} a = 0 & \text{and} & b = 0 \end{array} \quad \begin{array}{ll} a = 0, & b = 0 \\ c & = d \end{array}  ⟶  a = 0; [and]; b = 0; a = 0; b = 0; c = d
\begin{bmatrix} a \quad \text{so} & b \end{bmatrix} \quad \begin{bmatrix} \text{if} \quad \text{so} & b \end{bmatrix}  ⟶  bmatrix['so', b]; bmatrix['if so', b]
""",
    "statements": r"""
a = b = c \quad a \approx b \quad a \le b < c \quad a \in b \quad a \neq b \quad a := b \quad a \triangleq b \quad a \overset{!}{=} b \quad a \overset{\text{def}}{=} b \quad a \not= b  ⟶  a = b = c; a ≈ b; a ≤ b < c; a ∈ b; a ≠ b; a = b; a = b; a ≟ b; a = b; a ≠ b
= a  ⟶  = = a
a = b \\ = c \\ d = e  ⟶  a = b = c; d = e
a =  ⟶  a; [unread =]
a = \\ b = c \quad a = b = \\ c  ⟶  a = b = c; a = b = c
a \Rightarrow b \iff c \quad a \therefore b \lor c \land d \Leftarrow e \to f  ⟶  a; [⇒]; b; [⇔]; c; a; [⇒]; b; [or]; c; [and]; d; [⇐]; e; [⇒]; f
a = b \text{ and } c = d \text{ or } e \text{ if } f \text{ some words } g  ⟶  a = b; [and]; c = d; [or]; e; [if]; f; [words some words]; g
a = b, c = d; e = f \\ g = h  ⟶  a = b; c = d; e = f; g = h
a = b \\ + c \\ - d \quad e = f \\ - f = g  ⟶  a = (+ b + c); (- d); e = f; (- f) = g
a \\ + c \quad d  ⟶  (+ a + c); d
a = b - x \\ \quad + c  ⟶  a = (+ b - x + c)
a = b \text{ thus } = c  ⟶  [words thus]; a = b = c
\text{so } = c  ⟶  [words so]; = = c
\text{Position} = x \quad \text{so we have } x = y \quad y = \frac{\text{distance}}{\text{time}} \quad \text{where $D = x$, which is}  ⟶  Position = x; [words so we have]; x = y; y = (distance / time); [words where]; D = x; [words , which is]
\text{mass} \times \text{time} \quad \text{a} = b \quad 2 \text{ mass} \quad \text{l1} \quad \text{in the plane} \quad \text{speed}^2  ⟶  (mass × time); a = b; '2 \\text{ mass}'; l_1; [words in the plane]; speed**2
{x_{i=1} y} z \quad {x = {y}} \quad {\begin{bmatrix} a \end{bmatrix} = b}  ⟶  ({(x_i=1 y)} z); x = y; bmatrix[a] = b
x \text{ } y \quad x \text{: } = y \quad \text{, } z  ⟶  (x y); x = y; z
a = b, \\ + c  ⟶  a = (+ b + c)
a = \quad b \quad c = , d  ⟶  a = b; c = d
a = b \\ c + d  ⟶  a = b; (+ c + d)
a = b \\ +c , \quad d  ⟶  a = (+ b + c); d
a (i = 1, 2) \quad a (s_2 \neq 0)  ⟶  a; [words (i = 1, 2)]; a; [if]; sin(+2) ≠ 0
{x = y} \quad {\large x}  ⟶  x = y; x
\begin{aligned} a &= b, & c &= d \\ e &= f \end{aligned}  ⟶  a = b; c = d; e = f
\text{where $D = x$ and $y > 0$, so} \quad \text{$x$ and $y$} \quad \text{(}x\text{)} \quad \text{ ( } x \text{ ) } \quad \text{a and} b \quad \text{if $x = y$}  ⟶  [words where]; D = x; [and]; y > 0; [words , so]; [words $x$ and $y$]; x; x; [words a and]; b; [if]; x = y
a = b \\ \text{so} \\ c = d \quad = e  ⟶  a = b; [words so]; c = d = e
\begin{aligned} a &= b \\ & \text{so} \\ &= c \end{aligned}  ⟶  [words so]; a = b = c
a = \quad \Rightarrow b = c \quad \Rightarrow \quad d  ⟶  a; [unread =]; [⇒]; b = c; [⇒]; d
""",
    "numbers and units": r"""
1 2.5 0{,}5 .5 x 10  ⟶  (1 5/2 1/2 1/2 x 10)
0,5 \quad (0,5) \quad f(1,2) \quad 0,5,7 \quad x = 0,5  ⟶  '0,5'; (0, 5); (f (1, 2)); 0; 5; 7; x = '0,5'
3 \text{ m} \quad 4\,\mathrm{mm} \quad 5 \text{cm} \quad 30 \text{ deg} \quad x \text{ m} \quad 2^2 \mathrm{m} \quad \pi\,\text{rad} \quad 2^2 \text{mm} \quad (2) \text{mm}  ⟶  3; 4^<mm>; 5^<cm>; 30^<deg>; (x m); (2**2 m); pi; [words rad]; 2**2^<mm>; (2)^<mm>
\SI{500}{\milli\metre} x \quad \num{1.5e-3} x \quad \ang{90} + y  ⟶  (500^<mm> x); (3/2000 x); (+ 90^<deg> + y)
\SI{2}{\degree} + \qty{-2}{m}  ⟶  (+ 2^<deg> + ((- 2)))
\qty{1,5}{cm} + \SI{3}{\kilo\gram}  ⟶  (+ 3/2^<cm> + 3)
\SI[a=b]{+2.5}{\centi\meter}  ⟶  5/2^<cm>
2 \text{s}^{-1} \quad 2\,\mathrm{rad/s} \quad 5 \text{ m}^2 \quad \frac{1,8}{2} \quad \{1,5\} \quad [1,5; 2] \quad 1,5 x \quad x(\theta_1 = 0) = l_1 \quad k(\theta_1 = 0)  ⟶  2; 2; 5; ('1,8' / 2); {1, 5}; [1, 5, 2]; ('1,5' x); x|(theta_1 = 0) = l_1; k; [if]; theta_1 = 0
""",
    "what prints nothing": r"""
x \tag{1} \label{a} \quad x \eqref{e} \quad \boxed{x = 1} \quad \color{red} x \quad \textcolor{red}{x} \quad \ref{a}  ⟶  x; x; [words eqref]; x = 1; x; x; [words ref]
\cdots a + \dots \prod_{i=1}^n A_i \sum x \int_0^1 y  ⟶  (+ (… a) + (… … A_i … x … y))
x\xspace \pause y \arraycolsep=2pt z \hphantom{-}a \vspace{2mm}b \newcommand{\c}[1]{d}e \setlength{\f}{1pt}g  ⟶  (x y z a b e g)
\resizebox{2cm}{!}{$x$} \scalebox{2}{y} \mathclap{z} \alert<2>{a} \only<1>{b}\only<2>{c} \alt<2>{d}{e} \alt<1>{f}{g} \uncover<2->{h} \visible<1>{k}  ⟶  (x y z a c d g h)
\only<1>{b}k\only<2>{c}d \alt<2>{d}{e}f \alt<1>{f}{g}h  ⟶  (k c d d f g h)
\mathrm{c o s}(x) \operatorname{s i n} x  ⟶  (cos(x) sin(x))
a\_1 \* \(b\) x^\degree \dd x \not= \R  ⟶  (a_1 ⋅ (b) x^<deg> d x) ≠ R
\hspace{2cm} x \hspace{1mm} y \, z ~ a \hspace{2em} b \hspace{12pt} c \hspace{0.5cm} d \hspace{5mm} e \hspace{.1in} f  ⟶  (x y z a); b; c; d; (e f)
""",
}


def lines_of(readings: str) -> list[tuple[str, str]]:
    """Return the lines "display ⟶ tree" of a text."""
    pairs = (line.split("⟶") for line in readings.strip().splitlines())
    return [(latex.strip(), tree.strip()) for latex, tree in pairs]


@pytest.mark.parametrize("theme", READ)
def test_each_notation_is_read_as_the_tree_that_is_meant(theme: str) -> None:
    for latex, tree in lines_of(READ[theme]):
        assert read(latex) == tree, latex


def bare(node: n.Node) -> n.Node:
    """Return a tree without brackets, powers and what else stands round or above it."""
    while isinstance(node, n.Group | n.Labelled | n.Power | n.Postfix):
        node = node.base if isinstance(node, n.Power | n.Postfix) else node.inner
    return node


PLACES = r"""
{}^0T_1 {}^{1}_{2}T^T + A_1^{-1} - x''
-2 l_1 \cos(\theta_1 + \theta_2)^2 \sin^2\theta_1 / 3
\frac{\partial p_x}{\partial \theta_1} + \frac{d}{dt}(l_1 c_1) - \frac{\partial}{\partial x} x^2
\frac{d x}{d \theta_1} - \frac{d^2 x}{d t^2} \pm \frac{d x y}{d t}
\operatorname{atan2}(\pm\sqrt{1 - D^2}, D) \mp \arccos D
\sqrt{a^2 + \sqrt{b}} \sqrt 2
R_z(\theta_1) R_{x,\alpha_1} Rot(z, \theta_1) Rot_z(\theta_1) Rot_{z,\theta_1} Trans_{x, a_1}
R_{z,\theta_1}^T R_z(\theta_1)^{-1} Rot_{z,\theta_1}^T
\begin{bmatrix} c_1 & -s_{12} \\ \frac{1}{2} & x^{2} \end{bmatrix}^T \begin{pmatrix} 1 \\ 2 \end{pmatrix}
\underbrace{a + b}_{k} + \overbrace{l_1 c}^{m}
\dot\theta_1 + \ddot{q}_2 + \dot{\mathbf{p}}_3
|a + b|^2 + \lVert p \rVert + l |s|
J(q) \dot{q} + \mathbf{J}(\theta_1, \theta_2)^{-1}
C\theta_1 S(\theta_1 + \theta_2)^2 c_{\theta_1} c_{1-2} C^2\theta_1 c_1^2
2 \cdot 3 \times x / y
[a, b, c]^T (x, y) \{a\}
R[0,1] R^0_2 - R[1,2]^T
90^\circ + 3^{-1} + e^{x} - a^{b + 1}
\cos 2\theta_1 + \tan^{-1} x + \cos^{-1}(x)
\det(A) + \operatorname{tr} A + \det A^2
x_{max} + l_{\text{tool}} + \theta_1^* + \theta_2^{(+)}
{T_1^0}(\theta_1) + {x}^2 + {}_0^1R
\vec{p}_3 \times \hat{z}_0 + \overset{\rightarrow}{p}
a \tan 2(y, x) - \theta
^0_1T^1_2T
^0T_1^1T_2
R{}^T
A_1 \cdots A_n
3.5 x + .5 y + 1{,}5
0_{3\times 1} I_{3\times 3}
\frac12 x + \frac34 + \frac1{ab}
"""


@pytest.mark.parametrize("latex", PLACES.strip().splitlines())
def test_what_stands_at_the_place_of_a_node_is_the_node(latex: str) -> None:
    """But for indices, which need the letter before them."""
    whole = Reader().read_expression(latex)
    assert whole.span == (0, len(latex))
    for node in n.walk(whole):
        start, end = node.span
        if isinstance(node, n.Name):
            assert node.text in latex[start:end]
        if latex[start] == "_":
            assert latex[start + 1 : end] in (latex[start + 1], f"{{{latex[start + 2 : end - 1]}}}")
            assert not isinstance(node, n.JointAngles) or node in n.walk(
                Reader().read_expression(f"c{latex[start:end]}")
            )
        else:
            assert bare(Reader().read_expression(latex[start:end])) == bare(node)


def test_a_place_is_told_from_the_beginning_of_the_display() -> None:
    first, second = Reader().read(r"a = b \quad \text{so } c = 2 d")[0::2]
    assert (first.span, second.span) == ((0, 5), (23, 30))


def test_a_name_at_a_configuration_ends_before_the_bar() -> None:
    latex = r"J_v|_{\theta_1 = 0} + x"
    names = [node for node in n.walk(Reader().read_expression(latex)) if isinstance(node, n.Name)]
    assert [latex[slice(*name.span)] for name in names if name.base in "Jx"] == ["J_v", "x"]


@pytest.mark.parametrize(
    "first",
    [r"\pmatrix{a \cr b}", r"{a \over b}", r"\begin{bmatrix} a \end{bmatrix}", "(a)", r"\left(a\right)", "{a + b}^2"],
)
def test_a_blank_line_ends_an_equation_once_all_is_closed(first: str) -> None:
    assert read(f"{first} = c\n\nd = e") == f"{read(first)} = c; d = e"


@pytest.mark.parametrize(
    ("latex", "offset"),
    [("(a { b ) }", None), ("{ (a } b )", 2), (r"(a \\ b) ] c", 0), (r"\begin{bmatrix} (a \\ b) \end{bmatrix}", 16), (r"x = ((a + b) \\ c", 4), ("{a + (b}", 5)],
)  # fmt: skip
def test_of_parentheses_without_a_partner_the_one_that_is_open_is_told(latex: str, offset: int | None) -> None:
    with pytest.raises(ReadError) as caught:
        Reader().read(latex)
    opened = "is opened here and never closed" in str(caught.value)
    assert opened == (offset is not None) and (not opened or caught.value.offset == offset)


def test_the_key_of_a_bare_name_is_that_without_its_brackets() -> None:
    keys = {
        "((x_1))": "x_1",
        r"\underbrace{J(q)}_{n}": "J(q)",
        "J(q, t)": "J(q,t)",
        "2 x": None,
        r"\cos x": None,
        "J(0, 1)": None,
    }
    assert {latex: n.bare_key(Reader().read_expression(latex)) for latex in keys} == keys


REFUSED = r"""
\frac{d}{dt}  ⟶  0 a derivative of nothing
a \frac{\partial}{\partial x}  ⟶  2 a derivative of nothing
\frac{\partial x}{\partial}  ⟶  18 a derivative with respect to nothing
\frac{\partial^2 x}{\partial y \partial z^2}  ⟶  20 a higher derivative is with respect to one variable
\frac{\partial^3 x}{\partial y^2}  ⟶  20 a higher derivative is with respect to one variable
\frac{\partial^2 x}{\partial y^n}  ⟶  20 a higher derivative is with respect to one variable
(x)'  ⟶  3 a prime on an expression
(x)^*  ⟶  3 a star on an expression
\left. c \right|  ⟶  0 '\left. c \right|' does not say at which values
a \cos^2  ⟶  2 '\cos^2' has no argument
(x + y)^{25}  ⟶  7 the exponent 25 is larger than 24
x = \overset{0}{x}  ⟶  4 what does '0' above a name mean?
x = \begin{bmatrix} \end{bmatrix}  ⟶  4 a matrix without cells
\frac{\partial^2}{\partial y \partial z} x  ⟶  18 a higher derivative is with respect to one variable
x \quad \sin_x  ⟶  8 '\sin_x' has no angle
x = 12345678901234567890123456789012345678901  ⟶  4 a number of more than 40 digits
x = \frac{}{x}  ⟶  9 an argument is empty
"""


@pytest.mark.parametrize(("latex", "message"), lines_of(REFUSED))
def test_what_has_no_tree_is_refused_at_its_place(latex: str, message: str) -> None:
    with pytest.raises(ReadError) as caught:
        Reader().read(latex)
    assert f"{caught.value.offset} {caught.value}".startswith(message)


def test_equations_in_cells_before_an_arrow_hold_together() -> None:
    array = r"\begin{array}{rcl} a = 0 & b = 0 & %s & c = 0 \end{array}"
    assert read(array % r"\Rightarrow") == "a = 0; [and ]; b = 0; [⇒]; c = 0"
    assert read(array % "d = 0") == "a = 0; b = 0; d = 0; c = 0"


def test_a_brace_that_is_printed_closes_no_other() -> None:
    for latex in (r"\boxed{a \{b + c\}} = d", r"\boxed{a \{b + c\} = d}", r"{a \{b + c\}} = d"):
        assert read(latex) == read(r"a \{b + c\} = d") == "(a {(+ b + c)}) = d"


def test_what_stands_for_a_name_is_placed_where_the_name_is() -> None:
    """All of it: rows of a matrix, terms with their signs, the letters of an index."""
    tree = Reader().read_expression(r"\begin{bmatrix} a - b & \frac{c}{2} \\ \sin(x)^2 & J_{n} \end{bmatrix}^T")
    moved = n.placed(tree, (3, 5))
    assert {below.span for below in n.walk(moved)} == {(3, 5)} and shown(moved) == shown(tree)


def test_the_largest_exponent_and_the_longest_number_are_read() -> None:
    assert read("(x)^{24}") == "(x)**24" and read("1" * 40) == "1" * 40


@pytest.mark.parametrize(
    ("one", "other", "false"),
    [
        ("0.5 x", r" 0.50 \, x", "0.05 x"),
        (r"\mathbf{x} + 1", "x + 1", r"\mathbf{y} + 1"),
        (r"\cos\theta_1 \sin(\theta_2)", r"\cos(\theta_1) s\theta_2", r"\cos(\theta_1) s\theta_1"),
        (r"\frac{a}{b}", r"\dfrac{a}{b}", r"\frac{b}{a}"),
        (r"\frac{a}{b}", "a/b", "b/a"),
        ("a/2b", " a / 2 b", "b/2a"),
    ],
)
def test_two_trees_are_equal_however_they_are_written(one: str, other: str, false: str):
    first, second, third = map(Reader().read_expression, (one, other, false))
    assert first == second != third and hash(first) == hash(second)
