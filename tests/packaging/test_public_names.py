"""The public name space is complete and sorted, and is what the stub promises."""

import ast
from importlib.resources import files

import kugelpendel


def test_all_is_sorted_and_every_name_is_there() -> None:
    assert list(kugelpendel.__all__) == sorted(kugelpendel.__all__)
    for name in kugelpendel.__all__:
        assert getattr(kugelpendel, name).__name__.removeprefix("kugelpendel.") == name


def test_all_is_what_the_stub_imports() -> None:
    stub = ast.parse(files(kugelpendel).joinpath("__init__.pyi").read_text(encoding="utf-8"))
    imports = [node for node in ast.walk(stub) if isinstance(node, ast.ImportFrom)]
    names = {alias.asname or alias.name for node in imports for alias in node.names}
    assert names == set(kugelpendel.__all__)
    assert names <= set(dir(kugelpendel))


def test_package_says_that_it_is_typed() -> None:
    assert files(kugelpendel).joinpath("py.typed").is_file()
