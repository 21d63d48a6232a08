"""A short form of ``make fuzz``, with a seed of its own."""

import pytest
from tests.fuzz.calls import call_faults
from tests.fuzz.in_process import all_faults, fault
from tests.fuzz.processes import kill_faults, process_faults


@pytest.fixture
def seed() -> int:
    return 1851


def test_spoilt_files_end_in_an_answer_or_a_sentence(seed: int) -> None:
    assert (seed, all_faults(150, seed, lambda: None)) == (seed, [])


def test_processes_do_so_too(seed: int) -> None:
    assert (seed, process_faults(6, seed, lambda: None)) == (seed, [])


def test_calls_end_in_an_answer_or_a_sentence(seed: int) -> None:
    assert (seed, call_faults(300, seed, lambda: None)) == (seed, [])


def test_a_kill_leaves_the_old_files_or_the_new(seed: int) -> None:
    assert (seed, kill_faults(3, seed, lambda: None)) == (seed, [])


def test_the_fuzzer_sees_a_fault(monkeypatch: pytest.MonkeyPatch) -> None:
    def broken(arguments: list[str]) -> int:
        raise ZeroDivisionError

    monkeypatch.setattr("tests.fuzz.in_process.main", broken)
    assert "ZeroDivisionError" in (fault("run", b"") or "")
    monkeypatch.setattr("tests.fuzz.in_process.main", lambda arguments: print('{"a": NaN}') or 0)
    assert "NaN" in (fault("run", b"") or "")
    monkeypatch.setattr("tests.fuzz.in_process.main", lambda arguments: 2)
    assert fault("run", b"") == "exit code 2 without a sentence"
