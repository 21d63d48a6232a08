"""Rules for every test: in CI nothing is skipped but what reads the optional folder ../shared."""

import os
import signal
from collections.abc import Generator
from pathlib import Path

import pytest

# One thread of linear algebra in each worker and in each program that a test starts: the matrices
# are small, and threads of several processes wait for one another. (The process that pytest begins
# in is not reached: its plugin pytest-randomly loads NumPy before this file.)
for _variable in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
    os.environ.setdefault(_variable, "1")

IN_CI = os.environ.get("CI", "").lower() not in ("", "0", "false")
REPOSITORY = Path(__file__).resolve().parent.parent


# A shell that starts the tests in the background lets SIGINT be ignored, by what they start too.
signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture(scope="session")
def repository() -> Path:
    """The root of the checkout."""
    return REPOSITORY


@pytest.fixture(scope="session")
def shared() -> Path:
    """The folder ../shared: recordings and reference launches that the project does not contain."""
    folder = REPOSITORY.parent / "shared"
    if not folder.is_dir():
        pytest.skip(f"the optional folder {folder.name}/ does not lie beside the checkout")
    return folder


def _reason(report: pytest.TestReport | pytest.CollectReport) -> str:
    longrepr = report.longrepr
    return str(longrepr[2]) if isinstance(longrepr, tuple) else str(longrepr)


def _refuse_skip(report: pytest.TestReport | pytest.CollectReport) -> None:
    report.outcome = "failed"
    report.longrepr = f"skipped in CI, where every tool and oracle must be there: {_reason(report)}"


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(
    item: pytest.Item,
) -> Generator[None, pytest.TestReport, pytest.TestReport]:
    report = yield
    optional = item.get_closest_marker("shared") or "shared" in getattr(item, "fixturenames", ())
    if IN_CI and report.skipped and not optional and not hasattr(report, "wasxfail"):
        _refuse_skip(report)
    return report


@pytest.hookimpl(wrapper=True)
def pytest_make_collect_report() -> Generator[None, pytest.CollectReport, pytest.CollectReport]:
    report = yield
    if IN_CI and report.skipped:
        _refuse_skip(report)
    return report
