"""What `make test` runs: of a law with many cases some, the rest in `make test-rest`; on every document or arm it is shown in `make sweep`."""

import atexit
import gc
import os
import re
import shutil
import signal
import time
from collections import defaultdict
from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager, ExitStack
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest
from _pytest.runner import runtestprotocol
from xdist.remote import Producer
from xdist.scheduler import LoadFileScheduling
from xdist.workermanage import WorkerController

from tests.laws import PART, SWEEP, UNTIL, is_in_part

if TYPE_CHECKING:
    from tests.clusters import Running
    from tests.verification.report.browser import Browser

TESTS = Path(__file__).parent
gc.set_threshold(
    100_000, 50, 100
)  # of thousands of tests and modules nothing is garbage: to look through them took a sixth of the time
DOCUMENTS = ("scara-000", "dh-modified-001", "spherical-wrist-inverse")
ARMS = ("planar_2r", "scara", "rx90")
OTHERS = ("odd table", "puma table", "slanted")  # arms of tests/course/figures that are not of the catalogue
# Files that share what is long in starting or reading. One worker runs them all.
TOGETHER = {
    "Chromium, and the report of the course": (
        "tests/verification/report/",
        "tests/course/grading/test_class.py",
        "tests/course/printing/test_in_browser.py",
        "tests/course/site/test_in_browser.py",
        "tests/course/site/test_moving.py",
    ),
    "a Dask cluster": (
        "tests/course/grading/test_on_workers.py",
        "tests/verification/running/test_cluster.py",
    ),
    "the trees of all sources": (
        "tests/models/test_errors.py",
        "tests/test_repository.py",
        "tests/translations/",
        "tests/verification/test_bad_input.py",
    ),
}
# Files of few tests that take long: they are begun first, so that no worker is left with one of them at the end.
LONG = (
    *list(TOGETHER)[:2],  # Chromium and the cluster
    "tests/course/authoring/test_checking.py",
    "tests/course/authoring/test_new.py",
    "tests/course/feedback/test_placement.py",
    "tests/course/figures/test_animation.py",
    "tests/course/figures/test_command.py",
    "tests/course/figures/test_explaining.py",
    "tests/course/figures/test_files.py",
    "tests/course/figures/test_legibility.py",
    "tests/course/grading/",
    "tests/course/site/test_build.py",
    "tests/labelled/test_labelled.py",
    "tests/mutation/",
    "tests/sweeps/",
    "tests/test_installed.py",
    "tests/verification/cli/test_lsp.py",
    "tests/verification/functions/test_mistakes.py",
    "tests/verification/running/test_watch.py",
    "tests/verification/singularities/test_other_arms.py",
    "tests/verification/test_without_numpy.py",
)
# Of these tests, the ones whose parameters name another document or arm wait for the sweep; () leaves none. The equations
# of every document are tests of their own, and each has the verdict that it should have.
SWEPT = {
    "course/authoring/test_checking.py::test_two_lessons": (),
    "course/authoring/test_checking.py::test_what_is_wrong_is_found_in_a_kernel": (),
    "course/authoring/test_lessons.py": (),
    "course/authoring/test_new.py::test_a_handout": ("planar-2r-002",),
    "course/authoring/test_new.py::test_the_answers": ("polar_rp",),
    "course/authoring/test_new.py::test_slips": ("planar_2r",),
    "course/authoring/test_new.py::test_a_new_lesson_passes_as_it_is_written": (),
    "course/figures/test_command.py": ("odd table",),
    "course/figures/test_crossing.py": ("slanted",),
    "course/figures/test_files.py::test_the_same_figure_gives_the_same_bytes": (),  # another process gives them, too
    "course/figures/test_legibility.py": ("scara",),
    "course/figures/": ("scara", "slanted"),
    "course/test_words_decide_nothing.py": ("scara-004", "scara_jacobian"),
    "course/translation/test_french.py::test_a_french": ("scara-000", "16_proofread"),
    "course/printing/test_handouts.py": ("scara-000",),
    **{
        f"{test}[{hard}": ()  # long ones, of which others like them are shown
        for test, hard in (
            ("sweeps/test_mutants_of_displays.py::test_a_hard_display_is_borne", "kr210_2"),
            (
                "verification/singularities/test_other_arms.py::test_an_analysis_ends_in_time_and_says_what_it_left_out",
                "wrist",
            ),
            ("verification/singularities/test_other_arms.py::test_a_search_finds_none_off_the_families", "wrist"),
            ("verification/inverse/test_proof.py::test_a_slip_in_a_textbook_solution_is_refuted", "4-"),
            ("verification/inverse/test_proof.py::test_a_slip_in_a_textbook_solution_is_refuted", "9-"),
            ("models/exact/test_trace.py::test_exact_poses_are_those_of_the_double_plant", "classic table"),
            ("models/exact/test_trace.py::test_exact_jacobians_are_those_of_the_double_plant", "classic table"),
            ("models/exact/test_value.py::test_what_is_read_is_the_arm_that_was_written", "classic table"),
        )
    },
    "models/": (*ARMS, "polar_rp", "slanted"),
    "mutation/test_mutation.py::test_slips_are_refuted": ("scara-000", "spherical-wrist-inverse"),
    "mutation/test_mutation.py": DOCUMENTS,
    "test_arms_documents.py": (*ARMS, "polar_rp"),
    "verification/algebra/test_closed_form.py": ARMS,
    "verification/correction/test_copy.py": ("scara-000", "spherical-wrist-inverse"),
    "verification/document/test_formats.py::test_a_handout_in_another_format": ("scara-000", "spherical-wrist-inverse"),
    "verification/functions/test_mistakes.py": ("scara",),
    "verification/functions/test_styles.py": ("scara",),
    "verification/inverse/test_proof.py::test_every_inverse": ARMS,
    "verification/report/test_in_browser.py::test_axe_finds_nothing_serious_in_the_course": (),
    "verification/running/test_incremental.py::test_a_handout_changed_at_random": DOCUMENTS,
    "verification/singularities/test_singularities.py": (*ARMS, "spherical_wrist"),
    "verification/tables/test_origin_tables.py::test_every_change": ("planar_2r", "scara"),
    "verification/tables/test_origin_tables.py::test_the_cause": (*ARMS, "kr210"),
    "verification/tables/test_origin_tables.py": ARMS,
    "verification/tables/test_tables.py::test_every_change": ("planar_2r", "scara"),
    "verification/test_handouts.py::test_one_flipped": ("scara-000",),
    "verification/test_handouts.py": ("scara-000", "spherical-wrist-inverse"),
}
# These draw by themselves from what they judge.
BOTH = (
    "labelled/test_labelled.py::test_no_verdict_is_wrong_that_is_not_on_the_list",
    "labelled/test_labelled.py::test_what_is_mended_has_left_the_list",
    "labelled/test_labelled.py::test_what_is_said_is_what_is_on_record",
    "labelled/test_spellings.py::test_no_verdict_is_wrong_that_is_not_on_the_list_nor_one_on_it_mended",
)
# What takes long and is seldom broken alone waits for the rest.
LATER = (
    "course/authoring/test_checking.py::test_a_good_lesson_passes_in_a_kernel",
    "course/feedback/test_worked.py::test_a_number_of_few_digits_is_seldom_explained",
    "course/figures/test_animation.py::test_the_command_writes_films_beside_figures_and_leaves_out_what_an_arm_has_not",
    "course/figures/test_files.py::test_another_process_at_another_time_gives_the_same_bytes",
    "course/figures/test_files.py::test_a_trimmed_figure_loses_nothing_but_empty_paper",
    "course/figures/test_manipulability.py::test_the_rx90_has_its_elbow_and_shoulder_curves_and_a_million_configurations_in_time",
    "course/figures/test_workspace.py::test_each_cell_holds_what_the_plant_has_there",
    "course/grading/test_runs.py::test_what_was_checked_before_the_time_was_up_counts",
    "course/grading/test_on_workers.py::test_a_class_has_the_results_of_a_local_run_byte_for_byte_but_for_the_times",
    "course/site/test_in_browser.py::test_pages_are_read_anywhere",
    "course/test_words_decide_nothing.py",
    "labelled/test_bare.py::test_most_claims_are_decided",
    "reached/test_derived.py",
    "reached/test_reached.py",
    "sweeps/test_mutants_of_displays.py::test_a_hard_display_is_borne",
    "verification/report/test_in_browser.py::test_axe_finds_nothing_serious_in_an_errata_sheet_with_its_formulas",
    "test_installed.py::test_a_foreign_repository_with_packages_of_the_same_names_is_tested",
    "test_installed.py::test_a_notebook_stands_beside_modules_of_the_same_names",
    "test_installed.py::test_the_wheel_holds_code_and_data",
    "test_installed.py::test_the_wheel_works_alone",
    "verification/correction/test_corrector.py::test_a_condition_that_no_small_slip_explains_is_left_alone",
    "verification/running/test_watch.py::test_the_command_tells_verdicts_until_it_is_ended",
    "verification/singularities/test_singularities.py::test_intersections_have_the_rank_stated",
    "verification/check/test_document.py::test_two_of_anything_get_a_verdict",
    "verification/test_without_numpy.py::test_a_handout_is_proved_and_its_errata_refuted_without_numpy_and_drake",
    "verification/report/test_folder.py::test_kills_at_random_leave_a_whole_report",
    "verification/test_cli.py::test_a_report_that_nobody_takes_ends_without_a_traceback",
)


@dataclass
class Shared:
    """What the files of one entry of TOGETHER share: the first test that asks for it begins it, it ends behind their last."""

    opened: ExitStack = field(default_factory=ExitStack)
    begun: dict[str, Any] = field(default_factory=dict)

    def begin(self, what: str, run: Callable[[Path], AbstractContextManager[Any]], folder: Path) -> Any:
        if what not in self.begun:
            self.begun[what] = self.opened.enter_context(run(folder))
        return self.begun[what]

    def end(self) -> None:
        self.begun.clear()
        self.opened.close()


SHARED = Shared()


@pytest.fixture(scope="module")
def running(tmp_path_factory: pytest.TempPathFactory) -> "Running":
    """A Dask cluster: its address, and its workers."""
    from tests.clusters import run_cluster

    if shutil.which("openssl") is None:
        missing("no openssl, which writes the cluster's certificate")
    return SHARED.begin("cluster", run_cluster, tmp_path_factory.mktemp("cluster"))


@pytest.fixture(scope="module")
def browser(tmp_path_factory: pytest.TempPathFactory) -> "Browser":
    """A headless Chromium, one for all pages that a process looks at."""
    from tests.verification.report.browser import CHROMIUM, DRIVER, Browser

    if not (CHROMIUM and DRIVER):
        missing("needs Chromium and its driver: apt install chromium chromium-driver")
    return SHARED.begin("browser", Browser, tmp_path_factory.mktemp("profile"))


def missing(what: str) -> None:
    """Skip a test that needs what is not installed; `.ci/run` installs it, and there it fails."""
    (pytest.fail if os.environ.get("CI") else pytest.skip)(what)


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_setup() -> None:
    """Leave out what a slow machine has no time for: the summary counts it."""
    if time.time() > UNTIL:
        pytest.skip("of the rest, no more was begun when the time was over")


@pytest.hookimpl(trylast=True)  # behind the test's own fixtures
def pytest_runtest_teardown(item: pytest.Item, nextitem: pytest.Item | None) -> None:
    if nextitem is None or shared_by(nextitem.nodeid) != shared_by(item.nodeid):
        SHARED.end()


def pytest_configure(config: pytest.Config) -> None:
    signal.signal(signal.SIGINT, signal.default_int_handler)  # ignored in the background, and tests send it
    if hasattr(config, "workerinput"):  # not a pytest that a test starts: the code of its end is asked for
        atexit.register(os._exit, 0)  # the reports are sent: to take all that was loaded apart would take seconds


@pytest.hookimpl(tryfirst=True)  # no other need look at what waits
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    if SWEEP:
        return
    drawn = of_part([item for item in items if not waits_for_the_sweep(item.nodeid, parameters(item))])
    taken = set(drawn)
    config.hook.pytest_deselected(items=[item for item in items if item not in taken])
    items[:] = drawn


def pytest_collection_finish() -> None:
    gc.freeze()  # nor is what has been loaded and collected


def pytest_runtest_protocol(item: pytest.Item, nextitem: pytest.Item | None) -> bool | None:
    """Tell the process that counts of a test once, and of its phases where they fail: five messages a test took its time."""
    if not hasattr(item.config, "workerinput") or item.config.getoption("verbose") > 0:
        return None
    for report in runtestprotocol(item, log=False, nextitem=nextitem):
        if report.when == "call" or not report.passed:
            item.ihook.pytest_runtest_logreport(report=report)
    return True


def shared_by(nodeid: str) -> str:
    """Return what the files share among which a test's stands, "" for the others."""
    return next((what for what, files in TOGETHER.items() if nodeid.startswith(files)), "")


class Together(LoadFileScheduling):
    """Give the tests of a file, and those of the files that share something, to one worker."""

    def _split_scope(self, nodeid: str) -> str:
        return shared_by(nodeid) or super()._split_scope(nodeid)

    def _assign_work_unit(self, node: WorkerController) -> None:
        for scope in [scope for scope in self.workqueue if scope.startswith(LONG)][:1]:
            self.workqueue.move_to_end(scope, last=False)
        super()._assign_work_unit(node)


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config: pytest.Config, log: Producer) -> LoadFileScheduling | None:
    return Together(config, log) if config.getvalue("dist") == "loadfile" else None


def of_part(items: Sequence[pytest.Item], part: str = PART) -> list[pytest.Item]:
    """Return the tests of a part: of the cases of a law one in so many as `one_in` says in some, the others in the rest."""
    laws: defaultdict[str, list[pytest.Item]] = defaultdict(list)
    for item in items:
        laws[law(item)].append(item)
    taken = {
        item
        for name, cases in laws.items()
        for i, item in enumerate(cases)
        if name.startswith(BOTH) or is_in_part(i, one_in(name, len(cases)), part)
    }
    return [item for item in items if item in taken]


def one_in(name: str, cases: int) -> int:
    """Return of how many cases of a law `make test` shows one, 0 for none."""
    if name.startswith(LATER):
        return 0
    return 12 if cases >= 40 else 6 if cases >= 12 else 4 if cases >= 5 else 2


def law(item: pytest.Item) -> str:
    """Return what a test is a case of; an equation of a handout is one of its own."""
    return item.nodeid.removeprefix("tests/").partition("[" if parameters(item) else "\n")[0]


def parameters(item: pytest.Item) -> str:
    return item.callspec.id if isinstance(item, pytest.Function) and hasattr(item, "callspec") else ""


def waits_for_the_sweep(nodeid: str, named: str) -> bool:
    place = nodeid.removeprefix("tests/")
    if not place.startswith(tuple(SWEPT)):
        return False
    kept = next(kept for start, kept in SWEPT.items() if place.startswith(start))
    if kept and not (named and members().search(named)):  # others are never swept
        return False
    return not (kept and holding(kept).search(named))


@cache
def members() -> re.Pattern[str]:
    """The documents and the arms that there are."""
    documents = {path.stem for path in (TESTS.parent / "course/handouts").glob("*.md")}
    arms = {path.parent.name for path in (TESTS.parent / "models").glob("*/arm.yaml")}
    return re.compile("|".join(map(re.escape, sorted(documents | arms | set(OTHERS)))))


@cache
def holding(kept: tuple[str, ...]) -> re.Pattern[str]:
    """One of these names as a whole, among the parameters of a test."""
    names = "|".join(map(re.escape, kept))
    return re.compile(rf"(?<![\w-])(?:{names})(?![\w-])|(?:^|-)(?:{names})(?:$|-|\.)")
