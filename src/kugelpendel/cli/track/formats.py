"""The formats of a track. Each writer lends a function that appends one block.

Of a track whose length is not known beforehand the count is None.
"""

# pyarrow and h5netcdf have no types.
# pyright: reportMissingTypeStubs=false, reportUnknownMemberType=false
# pyright: reportUnknownVariableType=false, reportUnknownArgumentType=false
# pyright: reportUnknownParameterType=false, reportUnknownLambdaType=false

from __future__ import annotations

from contextlib import contextmanager
from typing import TYPE_CHECKING

import numpy as np

from kugelpendel.cli.track.block import COLUMNS

if TYPE_CHECKING:
    from collections.abc import Callable, Generator
    from pathlib import Path

    import pyarrow as pa

    from kugelpendel.cli.track.block import Block

    Write = Callable[[Block], None]

_VARIABLES = (
    ("time", ("time",), "s", "time since the launch"),
    (
        "position",
        ("time", "axis"),
        "m",
        "position from the support; z points down, (x, y) is the plan view from above",
    ),
    ("velocity", ("time", "axis"), "m/s", "velocity"),
    ("tension", ("time",), "N", "pull of thread or rod; negative where a thread would be slack"),
)


@contextmanager
def csv(path: Path, count: int | None) -> Generator[Write]:
    """Text, one row a sample; numbers are the shortest that read back as the same binary64."""
    import pyarrow as pa
    from pyarrow.csv import CSVWriter, WriteOptions

    header = ",".join(f"{name} ({unit})" for name, unit in COLUMNS.items())
    schema = pa.schema([(name, pa.float64()) for name in COLUMNS])
    with path.open("wb") as file:
        file.write(f"{header}\n".encode())
        with CSVWriter(file, schema, write_options=WriteOptions(include_header=False)) as table:
            yield lambda block: table.write_batch(_batch(block, schema))


@contextmanager
def parquet(path: Path, count: int | None) -> Generator[Write]:
    """Columns, with the unit in the metadata of each field."""
    import pyarrow as pa
    from pyarrow.parquet import ParquetWriter

    schema = pa.schema(
        [pa.field(name, pa.float64(), metadata={"units": unit}) for name, unit in COLUMNS.items()]
    )
    with ParquetWriter(path, schema, use_dictionary=False) as table:
        yield lambda block: table.write_batch(_batch(block, schema))


@contextmanager
def netcdf(path: Path, count: int | None) -> Generator[Write]:
    """NetCDF 4: position and velocity by time and axis, units and meanings in the attributes."""
    import h5netcdf

    with h5netcdf.File(path, "w") as file:
        file.dimensions = {"time": count, "axis": 3}
        axis = file.create_variable("axis", ("axis",), dtype="S1")
        axis[:] = np.array([b"x", b"y", b"z"])
        variables = {}
        for name, dimensions, unit, meaning in _VARIABLES:
            variable = file.create_variable(name, dimensions, dtype="f8")
            variable.attrs["units"] = unit
            variable.attrs["long_name"] = meaning
            variables[name] = variable

        def write(block: Block) -> None:
            rows = slice(block.first, block.first + len(block.time))
            if count is None:
                file.resize_dimension("time", rows.stop)
            for name, variable in variables.items():
                variable[rows] = getattr(block, name)

        yield write


def _batch(block: Block, schema: pa.Schema) -> pa.RecordBatch:
    """The block as a table. From buffers, since ``pa.array`` would import pandas to look for it."""
    import pyarrow as pa

    arrays = [
        pa.Array.from_buffers(
            pa.float64(), len(column), [None, pa.py_buffer(np.ascontiguousarray(column))]
        )
        for column in block.columns()
    ]
    return pa.RecordBatch.from_arrays(arrays, schema=schema)
