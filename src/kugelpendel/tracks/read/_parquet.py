"""Parquet files, by pandas."""

# pandas has no types.
# pyright: reportMissingTypeStubs=false, reportUnknownVariableType=false
# pyright: reportUnknownMemberType=false, reportUnknownArgumentType=false
from __future__ import annotations

from pathlib import Path

import numpy as np

from kugelpendel.errors import InvalidInput, require_extra
from kugelpendel.tracks.read._sheet import Column, Sheet


def read_parquet(file: Path) -> Sheet:
    """The columns of a Parquet file; an index with a name is one of them.

    Raises
    ------
    InvalidInput
        It cannot be read, or has no rows.
    """
    require_extra("fit", file.name, "pandas", "pyarrow")
    import pandas as pd

    try:
        table = pd.read_parquet(file)
    except (OSError, ValueError) as error:
        raise InvalidInput.of("track_not_read", file=str(file), what=str(error)) from error
    if table.index.name:
        table = table.reset_index()
    if not len(table.columns) or not len(table):
        raise InvalidInput.of("track_empty", file=file.name)
    columns: list[Column] = []
    for name in table.columns:
        series = table[name]
        if pd.api.types.is_datetime64_any_dtype(series) or pd.api.types.is_timedelta64_dtype(
            series
        ):
            since = series - series.min()
            columns.append(Column(str(name), "s", "", since.dt.total_seconds().to_numpy(float)))
        elif pd.api.types.is_numeric_dtype(series):
            columns.append(Column(str(name), "", "", series.to_numpy(float, na_value=np.nan)))
        else:
            texts = [str(value) for value in series.fillna("")]
            columns.append(Column(str(name), "", "", np.full(len(texts), np.nan), texts))
    return Sheet(columns)
