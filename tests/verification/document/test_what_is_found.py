"""What a text holds: each display and table with its line, its section, and the place of every part in the file."""

from __future__ import annotations

from pathlib import Path

import pytest

from armproof.verification.document import parse_document
from armproof.verification.document.model import Display, Piece, Table

FOUND = {
    ("page.md", "marks"): (
r"""$$ a = 1 $$ $$ b = 1 $$ and $$ a = 1 $$

Words $$a$$ words
$$a$$ and $$ c
= 2 $$ words

> $$
> a = 1
>   + b
> $$

$$

d = 3

$$

$$ e = 4 $$ {#eq-four}
""",
r"""
1 $$ ' a = 1 ' 1:3+5
1 $$ ' b = 1 ' 1:15+5
1 $$ ' a = 1 ' 1:31+5
3 $$ 'a' 3:8+1
4 $$ 'a' 4:2+1
4 $$ ' c\n= 2 ' 4:13+1 5:0+3
7 $$ 'a = 1\n  + b' 8:2+5 9:4+3
12 $$ 'd = 3' 14:0+5
18 $$ ' e = 4 ' 18:3+5
"""),
    ("page.md", "brackets"): (
r"""Words
\[ a = 1 \]
and
> \\[
> b = 2
> \\]

$$
c \\
\[1ex] d
$$
""",
r"""
2 $$ ' a = 1 ' 2:3+5
4 $$ 'b = 2' 5:2+5
8 $$ 'c \\\\\n\\[1ex] d' 9:0+4 10:0+8
"""),
    ("page.md", "headings"): (
r"""# One

$$ a = 1 $$

## Two

$$ b = 1 $$

<h2 class="x">Three <b>bold</b></h2>

$$ c = 1 $$

# Four

$$ d = 1 $$

| $a$ | b |
|---|---|
| 1 | $l_1$ |
""",
r"""
3 $$ ' a = 1 ' [One] 3:3+5
7 $$ ' b = 1 ' [Two] 7:3+5
11 $$ ' c = 1 ' [Three bold] 11:3+5
15 $$ ' d = 1 ' [Four] 15:3+5
17 table [Four] a@17:3+1$ | b@17:8+1 / 1@19:2+1 | l_1@19:7+3$
"""),
    ("page.md", "errata"): (
r"""> **Erratum** It is
>
> $$ a = 1 $$
>
> | x | $y$ |
> |---|---|
> | 1 | $l_1$ |

> no
> $$ b = 1 $$
>
> > errata: that
> > $$ c = 1 $$

:::{admonition} Erratum
$$ d = 1 $$

| x | y |
|---|---|
| 1 | 2 |
:::

:::{note}
*Errata*

$$ e = 1 $$
:::

:::{note}
$$ f = 1 $$
:::

```{python}
$$ no $$
```

:::{tip}
:::{note}
$$ g = 1 $$
:::
:::
""",
r"""
3 $$ ' a = 1 ' erratum 3:5+5
10 $$ ' b = 1 ' 10:5+5
13 $$ ' c = 1 ' erratum 13:7+5
16 $$ ' d = 1 ' erratum 16:3+5
26 $$ ' e = 1 ' erratum 26:3+5
30 $$ ' f = 1 ' 30:3+5
39 $$ ' g = 1 ' 39:3+5
5 table erratum x@5:4+1 | y@5:9+1$ / 1@7:4+1 | l_1@7:9+3$
18 table erratum x@18:2+1 | y@18:6+1 / 1@20:2+1 | 2@20:6+1
"""),
    ("page.md", "directives"): (
r"""```{math}
:label: one

a = 1
```

```{math}
---
label: two
---
b = 1

c = 1
```

```math
d = 1
```

:::{math}
e = 1
:::

```{math}
:label: none
```
""",
r"""
1 ```{math} 'a = 1' 4:0+5
7 ```{math} 'b = 1\n\nc = 1' 11:0+5 13:0+5
16 ```math 'd = 1' 17:0+5
20 :::{math} 'e = 1' 21:0+5
"""),
    ("page.md", "alone"): (
r"""$a = 1$
$b$
$c \in (0, \pi)$

Text $d = 1$ and `$e$` $f$ cm

$`g = 1`$

$h = 1$.

$x = 1$
$x = 1$ ,

- $k = 1$
""",
r"""
1 $  'a = 1' behind d = 1 1:1+5
3 $  'c \\in (0, \\pi)' behind d = 1 3:1+14
7 $` 'g = 1' said d = 1 (0, 0) behind k = 1 7:2+5
9 $  'h = 1' behind k = 1 9:1+5
11 $  'x = 1' behind k = 1 11:1+5
12 $  'x = 1' behind k = 1 12:1+5
"""),
    ("page.md", "open"): (
r"""<div>
$$ a = 1
</div>

Words
$$b$$ then $$ c = 1

words
""",
r"""
2 $$ ' a = 1\n</div>\n' open
6 $$ 'b' 6:2+1
6 $$ ' c = 1' open
"""),
    ("page.md", "environments"): (
r"""Words
\begin{align}
a &= 1 \\
b &= 2
\end{align}
words

> \begin{equation}
> c = 1
> \end{equation} .

\begin{equation}

d = 1
\end{equation}
""",
r"""
2 \begin '\\begin{align}\na &= 1 \\\\\nb &= 2\n\\end{align}' 2:0+13 3:0+9 4:0+6 5:0+11
8 \begin '\\begin{equation}\nc = 1\n\\end{equation} .' 8:2+16 9:2+5 10:2+16
"""),
    ("page.md", "tables"): (
r"""| $i$ | $a_{i}$ | d |
|:-:|---|---|
| 1 |  | $l_1$ |
| 2 | x \| y | |

 i | a
---|---
 1 | $0$
 2

<table><tr><th>i</th><th>a</th></tr>
<tr><td>1</td><td>l_1</td></tr></table>
""",
r"""
1 table i@1:3+1$ | a_{i}@1:9+5$ | d@1:18+1 / 1@3:2+1 | @3:6+0 | l_1@3:10+3$ / 2@4:2+1 | x | y@nowhere | @4:15+0
6 table i@6:1+1 | a@6:5+1 / 1@8:1+1 | 0@8:6+1$ / 2@9:1+1 | @nowhere
11 table i@11:15+1 | a@nowhere / 1@nowhere | l_1@nowhere
"""),
    ("page.md", "pictures"): (
r"""Words
<img src="https://latex.codecogs.com/gif.latex?a=1"/>

> **Erratum**
>
> <img src="https://latex.codecogs.com/gif.latex?b=1"/>
""",
r"""
2 <img 'a=1'
6 <img 'b=1' erratum
"""),
    ("page.md", "said"): (
r"""# One

With $l_1 = 2$ and the arm stretched out:

$$ a = 1 $$

where $b = 2$.

## Two

Let $c = 3$.

# Three

Let $d = 4$ cm.

$$ e = 1 $$
""",
r"""
5 $$ ' a = 1 ' [One] said l_1 = 2 \text{stretched} (0, 0) behind b = 2 5:3+5
17 $$ ' e = 1 ' [Three] said b = 2 c = 3 d = 4\,\text{cm} (2, 2) 17:3+5
"""),
    ("page.tex", "main"): (
r"""% arm: planar_2r
\documentclass{article}
\title{Of $t = 1$}
\newcommand{\cc}[1]{\cos\theta_{#1}}
\begin{document}
\section{One}
With $l_1 = 2$, see \eqref{a} % no $c = 1$
\begin{equation} \label{a}
a = \cc1 % more
 + b
\end{equation}
where $b = 3$.
\[ c = 1 \] and \(d = 2\) $$ e = 3 $$
\subsection*{Two $x$}
\begin{align*}
a &= 1 \\
b &= 2
\end{align*}
\begin{verbatim}
$$ no = 1 $$
\end{verbatim}
\section{Three}
\begin{quote} \textbf{Erratum} \[ f = 1 \] \end{quote}
\begin{tabular}{cc} $i$ & $a_i$ \\ \hline 1 & $l_1$ \\ 2 & \\ \end{tabular}
\begin{displaymath} g = 1 \end{displaymath}
\end{document}
\[ h = 1 \]
""",
r"""
front arm 1
8 \begin{equation} ' \\label{a}\na = \\cos\\theta_{1}       \n + b' [One] said l_1 = 2 (0, 0) behind b = 3 8:16+10 9:0+4 9:4+12! 9:7+1 9:4+1! 9:8+7! 10:0+4
13 \[ ' c = 1 ' [One] said b = 3 (0, 0) behind d = 2 13:2+7
13 $$ ' e = 3 ' [One] said d = 2 (0, 0) 13:28+7
15 \begin{align*} 'a &= 1 \\\\\nb &= 2' [Two $x$] 16:0+9 17:0+6
23 \[ ' f = 1 ' erratum [Three] 23:33+7
25 \begin{displaymath} ' g = 1 ' [Three] 25:19+7
24 table [Three] i@24:21+1$ | a_i@24:27+3$ / 1@24:42+1 | l_1@24:47+3$ / 2@24:55+1 | @24:59+0
"""),
    ("page.tex", "macros"): (
r"""% arm: planar_2r
\def\a{l_1} \def\b#1#2{#1 + #2} \newcommand\c[2][x]{#1 = #2} \DeclareMathOperator{\rk}{rank}
\newcommand{\R}{\mathbf{R}} \let\d\R \renewcommand{\a}{l_2}
$$ \a = \b{c}{d} $$
$$ \c{y} $$ $$ \c[z]{y} $$
$$ \rk J = 1 $$
$$ \R = \d $$
\begin{align} \a &= \b 12 \nonumber \end{align}
""",
r"""
front arm 1
4 $$ ' l_2= c + d ' 4:2+1 4:3+3! 4:6+2 4:11+1 4:8+3! 4:14+1 4:16+1
5 $$ ' x = y ' 5:2+2! 5:3+3! 5:6+1 5:8+1
5 $$ ' z = y ' 5:14+1 5:18+1 5:15+3! 5:21+1 5:23+1
6 $$ ' \\operatorname{rank}J = 1 ' 6:2+1 6:3+19! 6:7+6
7 $$ ' \\mathbf{R}= \\mathbf{R}' 7:2+1 7:3+10! 7:6+2 7:8+10!
8 \begin{align} ' l_2&= 1 + 2 \\nonumber ' 8:13+1 8:14+3! 8:17+3 8:23+1 8:20+3! 8:24+12
"""),
    ("page.rst", "main"): (
r"""One
===

With :math:`l_1 = 2` here.

.. math:: a = 1
   :label: one

.. math::
   :label: two

   b = 1

   c = 1 \\
     + d

Two
---

.. admonition:: Erratum

   .. math:: d = 1

.. note::

   .. math:: e = 1

.. code::

   .. math:: no = 1

Three
=====

Behind it::

   .. math:: no = 1

| :math:`g = 1`
:math:`h` = :math:`k_1`.

1. .. math:: l = 1

.. raw:: html

   .. math:: no = 1

.. a comment

   .. math:: no = 1

* item

  .. math:: f = 1

""",
r"""
6 .. math:: 'a = 1' [One] said l_1 = 2 (0, 0) 6:10+5
9 .. math:: 'b = 1' [One] 12:3+5
14 .. math:: 'c = 1 \\\\\n+ d' [One] 14:3+8 15:5+3
22 .. math:: 'd = 1' erratum [Two] 22:13+5
26 .. math:: 'e = 1' [Two] 26:13+5
39 :math: 'g = 1' [Three] 39:9+5
40 :math: 'h = k_1' [Three] 40:7+1 40:10+1 40:19+3
42 .. math:: 'l = 1' [Three] 42:13+5
54 .. math:: 'f = 1' [Three] 54:12+5
"""),
    ("page.tex", "odd"): (
r"""% arm: planar_2r
\$ $a = 1$ \\[2pt] \[ b = 1 \]
\begin{eqnarray} c & = & 1 \end{eqnarray}
\begin{comment} \[ no = 1 \] \end{comment}
\begin{gather} d = 1 \\ e = 2 \end{gather} \verb|$$ no $$|
\begin{tabular}{|c|c|}
\multicolumn{2}{c}{x} \\
1 & \multirow{2}{*}{$l_1$} \\
\end{tabular}
$$ f = 1
""",
r"""
front arm 1
2 \[ ' b = 1 ' said a = 1 (0, 0) 2:21+7
3 \begin{eqnarray} ' c & = & 1 ' 3:16+11
5 \begin{gather} ' d = 1 \\\\ e = 2 ' 5:14+16
10 $$ ' f = 1\n' open
"""),
    ("page.tex", "exercises"): (
r"""%! TeX root
%
% ---
% arm: planar_2r
% ---
\section{One}
\begin{problem}
\[ a = 1 \]
\subsection{Two}
\[ b = 1 \]
\end{problem}
\[ c = 1 \]
\begin{homeworkProblem}[Question 4 (10 points)] \[ d = 1 \] \end{homeworkProblem}
\begin{exercise} The manipulator of Question 4. \[ e = 1 \] \begin{itemize} \end{exercise}
\[ f = 1 \]
""",
r"""
front arm 4
8 \[ ' a = 1 ' [Exercise 1] 8:2+7
10 \[ ' b = 1 ' [Exercise 1: Two] 10:2+7
12 \[ ' c = 1 ' [One] 12:2+7
13 \[ ' d = 1 ' [Exercise 2] 13:50+7
14 \[ ' e = 1 ' [Exercise 2] 14:50+7
15 \[ ' f = 1 ' [One] 15:2+7
"""),
    ("page.tex", "errata"): (
r"""
% arm: planar_2r
% source: a book
no front
\[ a = 1 \]
% Erratum
\[ b = 1 \] \[ c = 1 \]
\begin{errata} \begin{quote} $x = 1$ \end{quote} \[ d = 1 \] \begin{tabular}{c} 1 \\ 2 \\ \end{tabular} \end{errata}
% erratum
\begin{tabular}{cc} i & \cc \\ 1 & $l_1$ \end{tabular}
\[ e = 1 \]
""",
r"""
front arm 2
front source 3
5 \[ ' a = 1 ' behind x = 1 5:2+7
7 \[ ' b = 1 ' erratum behind x = 1 7:2+7
7 \[ ' c = 1 ' behind x = 1 7:14+7
8 \[ ' d = 1 ' erratum said x = 1 (0, 0) 8:51+7
11 \[ ' e = 1 ' 11:2+7
8 table erratum 1@8:80+1 / 2@8:85+1
10 table erratum i@10:20+1 | \cc@10:24+3 / 1@10:31+1 | l_1@10:36+3$
"""),
    ("page.tex", "open"): (
r"""% arm: planar_2r
\[ a = 1

words \[ b = 1 \] \begin{align} c = 1

\begin{align} d = 1 \end{align} \( e = 1 $ f = 1 $ words \$ $$

g = 1

$$ \begin{tabular}{c} i \\ 1
\section{One
\[ h = 1 \]
""",
r"""
front arm 1
2 \[ ' a = 1' open behind  f = 1
4 \[ ' b = 1 ' behind  f = 1  4:8+7
4 \begin{align} ' c = 1' open behind  f = 1
6 \begin{align} ' d = 1 ' behind  f = 1  6:13+7
6 $$ 'g = 1' said  f = 1  (0, 0) 8:0+5
12 \[ ' h = 1 ' [One \[ h = 1 \]] 12:2+7
"""),
    ("page.tex", "of the author's own"): (
r"""% arm: planar_2r
\newcommand{\be}{\begin{equation}} \newcommand{\ee}{\end{equation}} \newenvironment{mine}{\begin{align}}{\end{align}}
\be a = 1 \ee \begin{mine} b &= 1 \end{mine} \begin{alignat}{2} c &= 1 \end{alignat}
\chapter{A} \section{B} \paragraph{C} \[ d = 1 \] \subsubsection{D} \[ e = 1 \]
""",
r"""
front arm 1
3 \be ' a = 1 ' 3:3+7
3 \begin{mine} ' b &= 1 ' 3:26+8
3 \begin{alignat} ' c &= 1 ' 3:63+8
4 \[ ' d = 1 ' [C] 4:40+7
4 \[ ' e = 1 ' [D] 4:70+7
"""),
    ("page.tex", "hidden"): (
r"""% arm: planar_2r
Code \verb|$ no = 1 $| and \begin{lstlisting} $$ no = 1 $$ \end{lstlisting}
100\% $a = 1$ % $ no = 1 $
the arm stretched out \section{The zero configuration} \[ b = 1 \]
""",
r"""
front arm 1
4 \[ ' b = 1 ' [The zero configuration] said a = 1 \text{stretched} \text{zero configuration} (2, 0) 4:57+7
"""),
    ("page.md", "front"): (
r"""---
arm: planar_2r

source: a book
---

$$ a = 1 $$
""",
r"""
front arm 2
front source 4
7 $$ ' a = 1 ' 7:3+5
"""),
    ("page.rst", "front"): (
r"""=====
Title
=====

..
   arm: planar_2r
   source: a book

.. math:: a = 1
""",
r"""
front arm 6
front source 7
9 .. math:: 'a = 1' [Title] 9:10+5
"""),
    ("page.rst", "fields"): (
r"""Title
-----

:arm: planar_2r
:source: a book
   of two lines

.. erratum:: It is

   .. math:: a = 1

.. math:: b = 1

Words

    **Erratum**

    It is

    .. math::

       c = 1

       \begin{matrix}

       d \end{matrix}

 text
""",
r"""
front arm 4
front source 5
10 .. math:: 'a = 1' erratum [Title] 10:13+5
12 .. math:: 'b = 1' [Title] 12:10+5
20 .. math:: 'c = 1' erratum [Title] 22:7+5
24 .. math:: '\\begin{matrix}\nd \\end{matrix}' erratum [Title] 24:7+14 26:7+14
"""),
    ("page.rst", "inline"): (
r"""- :math:`a = 1` cm and :math:`b = 2`
- stretched out

  2. .. math:: c = 1
      d

    :math:`e = 1`
""",
r"""
4 .. math:: 'c = 1\nd' said a = 1\,\text{cm} b = 2 \text{stretched} (0, 0) 4:15+5 5:6+1
7 :math: 'e = 1' 7:11+5
"""),
    ("page.py", "cells"): (
r"""# ---
# arm: planar_2r
# ---
# %% [markdown]
# # One
#
# $$ a = 1 $$ and
# $$
# b = 2
# $$
#
# | x | y |
# |---|---|
# | 1 | $l_1$ |
# | 2 |

# %%
text = "$$ no = 1 $$"

# %% [markdown]
# 
# > **Erratum** $$ c = 3 $$
# 
""",
r"""
7 $$ ' a = 1 ' [One] 7:5+5
8 $$ 'b = 2' [One] 9:2+5
22 $$ ' c = 3 ' erratum 22:19+5
12 table [One] x@12:4+1 | y@12:8+1 / 1@14:4+1 | l_1@14:9+3$ / 2@15:4+1 | @15:7+0
"""),
}  # fmt: skip


def shown(name: str, text: str) -> str:
    """Return a line for each display and table of a document, with what stands at the places that it names."""
    document = parse_document(Path(name), text)
    lines = text.split("\n")
    found = [_display(each, lines) for each in document.displays] + [_table(each, lines) for each in document.tables]
    return "\n".join([*(f"front {key} {line}" for key, line in document.lines.items()), *found])


def _display(display: Display, lines: list[str]) -> str:
    marks = (
        ["erratum"] * display.erratum
        + ["open"] * (not display.closed)
        + [f"[{display.section}]"] * bool(display.section)
    )
    said = [f"said {' '.join(display.said)} ({display.said_above}, {display.said_outside})"] * bool(display.said)
    behind = [f"behind {' '.join(display.said_behind)}"] * bool(display.said_behind)
    places = " ".join(_place(piece, display.latex, lines) for piece in display.pieces)
    return " ".join([f"{display.line} {display.opening} {display.latex!r}", *marks, *said, *behind, places]).rstrip()


def _table(table: Table, lines: list[str]) -> str:
    marks = ["erratum"] * table.erratum + [f"[{table.section}]"] * bool(table.section)
    rows = zip((table.header, *table.rows), table.pieces, strict=True)
    cells = (
        " | ".join(f"{cell}{_cell(piece, cell, lines)}" for cell, piece in zip(row, pieces, strict=True))
        for row, pieces in rows
    )
    return " ".join([f"{table.line} table", *marks, " / ".join(cells)])


def _place(piece: Piece, latex: str, lines: list[str]) -> str:
    there = lines[piece.line - 1][piece.column : piece.column + piece.length]
    return f"{piece.line}:{piece.column}+{piece.length}" + "!" * (there != latex[piece.at : piece.at + piece.length])


def _cell(piece: Piece | None, cell: str, lines: list[str]) -> str:
    return f"@{_place(piece, cell, lines)}" + "$" * piece.in_dollars if piece is not None else "@nowhere"


@pytest.mark.parametrize(("name", "about"), FOUND)
def test_what_a_text_holds_stands_where_it_is_said_to(name: str, about: str) -> None:
    text, found = FOUND[name, about]
    assert shown(name, text) == found.strip("\n")
