"""Parts of the geometric Jacobian that names imply: J_1 its column, J_{12} its entry, J where only some rows are printed."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace

from verification.algebras import Value
from verification.evaluate_zero import is_zero
from verification.latex import nodes as n
from verification.matrix import Matrix
from verification.names import Names
from verification.quantities import ANGULAR, LINEAR, Quantity
