"""Submissions that harm: each kind, what is to become of it, and what must hold before it may be run at all.

A cell prints ESCAPED where it gets through. What could do damage is tried only after something harmless of the same kind was
refused in the same run; `{scratch}` is a folder that the test made for this, `{process}` the test's own process.
"""

from __future__ import annotations

from dataclasses import dataclass

from armproof.course.grading.results import Status

GRADED, TIMED_OUT, MEMORY = Status.GRADED, Status.TIMED_OUT, Status.OUT_OF_MEMORY
CRASHED, OUTPUT, UNREADABLE = Status.CRASHED, Status.TOO_MUCH_OUTPUT, Status.UNREADABLE


@dataclass(frozen=True)
class Hostile:
    """A kind: its cell, the statuses of which it gets one, and the protections without which it is not run."""

    cell: str
    statuses: tuple[Status, ...]
    needs: tuple[str, ...] = ()


KINDS = {
    "endless": Hostile("while True: pass", (TIMED_OUT,)),
    "endless-in-c": Hostile("sum(iter(int, 1))", (TIMED_OUT,)),
    "power": Hostile("10 ** 10 ** 9", (TIMED_OUT, MEMORY)),
    "swallows-everything": Hostile(
        "while True:\n    try:\n        while True: pass\n    except BaseException: pass", (TIMED_OUT,)
    ),
    "sleeps": Hostile("import time; time.sleep(10 ** 6)", (TIMED_OUT,)),
    "stops-itself": Hostile("import os, signal; os.kill(os.getpid(), signal.SIGSTOP)", (TIMED_OUT, GRADED), ("signal",)),
    "10-gb": Hostile("import numpy; numpy.ones(10 ** 10 // 8)", (MEMORY,)),
    "grows": Hostile("kept = []\nwhile True: kept.append(bytearray(10 ** 7))", (MEMORY,)),
    "many-processes-grow": Hostile(
        "import os, time\nfor _ in range(6):\n    if not os.fork():\n        kept = bytearray(4 * 10 ** 8)\n"
        "        kept[::4096] = bytes(len(kept[::4096])).replace(b'\\0', b'1')\n        time.sleep(60)\ntime.sleep(60)",
        (MEMORY,),
        ("processes",),
    ),
    "exits": Hostile("import os; os._exit(0)", (CRASHED,)),
    "sys-exit": Hostile("import sys; sys.exit(3)", (GRADED,)),
    "aborts": Hostile("import os; os.abort()", (CRASHED,)),
    "segfault": Hostile("import ctypes; ctypes.string_at(0)", (CRASHED,)),
    "recursion": Hostile("import sys\nsys.setrecursionlimit(10 ** 9)\ndef f(): return f() + 1\nf()", (CRASHED, MEMORY, GRADED, TIMED_OUT)),
    "recursion-in-c": Hostile(
        "import sys\nsys.setrecursionlimit(10 ** 9)\nclass A:\n    def __add__(self, other): return self + other\nA() + A()",
        (CRASHED, MEMORY, GRADED, TIMED_OUT),
    ),
    "prints-1-gb": Hostile("for _ in range(1000): print('x' * 10 ** 6)", (OUTPUT,)),
    "prints-1-gb-of-errors": Hostile("import os\nwhile True: os.write(2, b'x' * 10 ** 6)", (OUTPUT,)),
    "prints-much": Hostile("print('x' * 10 ** 6)", (OUTPUT,)),
    "fills-the-disk": Hostile(
        "for number in range(100):\n    open(f'f{{number}}', 'wb').write(bytes(range(256)) * 4 * 10 ** 4)\nimport time; time.sleep(60)",
        (OUTPUT,),
    ),
    "many-files": Hostile("for number in range(30000): open(f'f{{number}}', 'wb').close()\nimport time; time.sleep(60)", (OUTPUT,)),
    "deep-folders": Hostile("import os\nfor _ in range(3000):\n    os.mkdir('d')\n    os.chdir('d')", (GRADED, OUTPUT)),
    "deletes-a-folder": Hostile("import shutil\nshutil.rmtree({scratch!r})", (GRADED,), ("write",)),
    "deletes-everything": Hostile(
        "import os, shutil\ntry:\n    os.listdir({scratch!r})\n    print('ESCAPED')\nexcept OSError:\n    shutil.rmtree('/')",
        (GRADED,),
        ("write", "read"),
    ),
    "writes-elsewhere": Hostile(
        "for place in ('/tmp', '/var/tmp', '/dev/shm', {scratch!r}, '..'):\n    try:\n"
        "        open(place + '/armproof-escaped', 'w').close()\n        print('ESCAPED')\n    except OSError: pass",
        (GRADED,),
        ("write",),
    ),
    "overwrites": Hostile("open({scratch!r} + '/precious', 'w').write('ESCAPED')\nprint('ESCAPED')", (GRADED,), ("write",)),
    "renames": Hostile("import os\nos.rename({scratch!r}, {scratch!r} + '2')\nprint('ESCAPED')", (GRADED,), ("write",)),
    "changes-modes": Hostile("import os\nos.chmod({scratch!r} + '/precious', 0)\nprint('ESCAPED')", (GRADED,), ("mode",)),
    "reads-others": Hostile("print('ESCAPED' + open({scratch!r} + '/precious').read())", (GRADED,), ("read",)),
    "lists-others": Hostile("import os\nprint('ESCAPED', os.listdir({scratch!r}), os.listdir('..'))", (GRADED,), ("read",)),
    "links-out": Hostile("import os\nos.symlink({scratch!r}, 'l')\nprint('ESCAPED' + open('l/precious').read())", (GRADED,), ("read",)),
    "reads-processes": Hostile("import os\nprint('ESCAPED', open('/proc/%d/environ' % {process}).read())", (GRADED,), ("read",)),
    "fork-bomb": Hostile("import os\nwhile True: os.fork()", (GRADED, TIMED_OUT, CRASHED, MEMORY), ("processes",)),
    "leaves-children": Hostile(
        "import os\nfor _ in range(10):\n    if not os.fork():\n        os.setsid()\n        while True: pass",
        (GRADED,),
        ("processes",),
    ),
    "leaves-grandchildren": Hostile(
        "import os, signal\nif not os.fork():\n    os.setsid()\n    if not os.fork():\n        for number in range(1, 32):\n"
        "            try: signal.signal(number, signal.SIG_IGN)\n            except (OSError, ValueError): pass\n"
        "        while True: pass\n    os._exit(0)",
        (GRADED,),
        ("processes",),
    ),
    "hogs-the-processors": Hostile(
        "import os, time\nfor _ in range(25):\n    if not os.fork():\n        os.setsid()\n        while True: pass\ntime.sleep(10 ** 6)",
        (TIMED_OUT,),
        ("processes",),
    ),
    "starts-programs": Hostile("import subprocess\nfor _ in range(5): subprocess.Popen(['sleep', '1000'])", (GRADED,)),
    "starts-threads": Hostile(
        "import threading, time\nfor _ in range(1000): threading.Thread(target=time.sleep, args=(10 ** 6,)).start()", (GRADED,)
    ),
    "opens-sockets": Hostile(
        "import socket\nfor family in (socket.AF_INET, socket.AF_INET6, socket.AF_UNIX):\n"
        "    for kind in (socket.SOCK_STREAM, socket.SOCK_DGRAM):\n        try:\n            one = socket.socket(family, kind)\n"
        "            one.settimeout(1)\n"
        "            one.connect(('192.0.2.1', 9) if family == socket.AF_INET else ('2001:db8::1', 9) if family == socket.AF_INET6 else '\\0x')\n"
        "            print('ESCAPED')\n        except OSError: pass",
        (GRADED,),
        ("network", "unix"),
    ),
    "asks-the-network": Hostile(
        "import urllib.request\nurllib.request.urlopen('http://127.0.0.1:9')\nprint('ESCAPED')", (GRADED,), ("network",)
    ),
    "kills-its-parent": Hostile(
        "import os\ntry:\n    os.kill({process}, 0)\n    print('ESCAPED')\nexcept OSError:\n    os.kill(os.getppid(), 9)",
        (GRADED, CRASHED),
        ("signal",),
    ),
    "kills-everybody": Hostile(
        "import os\ntry:\n    os.kill({process}, 0)\n    print('ESCAPED')\nexcept OSError:\n    os.kill(-1, 9)",
        (GRADED, CRASHED),
        ("signal",),
    ),
    "kills-its-group": Hostile("import os\nos.killpg(0, 9)", (GRADED, CRASHED), ("signal",)),
    "closes-everything": Hostile("import os\nos.closerange(0, 4096)", (CRASHED, GRADED)),
    "raises-its-limits": Hostile(
        "import resource\nfor what in (resource.RLIMIT_AS, resource.RLIMIT_CPU, resource.RLIMIT_NPROC):\n    try:\n"
        "        resource.setrlimit(what, (-1, -1))\n        print('ESCAPED')\n    except (OSError, ValueError): pass",
        (GRADED,),
    ),
    "breaks-python": Hostile("import builtins, sys\nsys.stdout = None\nbuiltins.len = None\nsys.modules.clear()", (GRADED, CRASHED)),
    "error-without-text": Hostile("class E(Exception):\n    def __str__(self): raise ValueError\nraise E", (GRADED,)),
    "error-of-markup": Hostile("raise type('<script>alert(1)</script>', (Exception,), {{}})('<img src=x onerror=alert(1)>')", (GRADED,)),
    "asks-for-input": Hostile("input()", (GRADED,)),
    "forges-reports": Hostile(
        "import os\nline = b'{{\"results\": [{{\"lesson\": \"scara_jacobian\", \"task\": \"jacobian\", \"outcome\": \"correct (proved)\", \"message\": \"\"}}]}}\\n'\n"
        "for number in range(3, 70):\n    try: os.write(number, line)\n    except OSError: pass",
        (GRADED, CRASHED),
    ),
    "forges-feedback": Hostile(
        "from armproof.course.feedback import Feedback, Outcome, open_lesson\nlesson = open_lesson('scara_jacobian')\n"
        "lesson._keep(Feedback(Outcome.PROVED, task='jacobian', lesson='scara_jacobian'))\n"
        "lesson._results['jacobian'] = Feedback(Outcome.PROVED)",
        (GRADED,),
    ),
    "patches-the-check": Hostile(
        "from armproof.course.feedback import Feedback, Outcome, Task, open_lesson\n"
        "Task._judge = lambda task, answer: Feedback(Outcome.PROVED)\nopen_lesson('scara_jacobian').jacobian.check(1)",
        (GRADED,),
    ),
    "patches-a-task": Hostile(
        "from armproof.course.feedback import Feedback, Outcome, open_lesson\ntask = open_lesson('scara_jacobian').jacobian\n"
        "task._judge = lambda answer: Feedback(Outcome.PROVED)\ntask.check(1)",
        (GRADED,),
    ),
}  # fmt: skip

BROKEN = {
    "not-json": b"{",
    "empty": b"",
    "not-utf-8": '{"cells": [], "é": 1}'.encode("latin-1"),
    "no-cells": b"{}",
    "wrong-cells": b'{"cells": [1, "x", null]}',
    "source-of-numbers": b'{"cells": [{"cell_type": "code", "source": [1, 2]}]}',
    "nested": b"[" * 100_000,
    "giant": b'{"cells": []}' + b" " * (21 << 20),
}
