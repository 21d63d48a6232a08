"""Many pendulums at once: sweeps over what varies, kept in a store that nothing is lost from.

What a sweep is, and its cases from their index, are in `cases`; `_store` keeps what is done,
`_chunk` does some cases at a time, `_run` has this process do them and `_cluster` others.
"""

from kugelpendel.sweeps._chunk import chunk_for as chunk_for
from kugelpendel.sweeps._chunk import results_of as results_of
from kugelpendel.sweeps._chunk import why as why
from kugelpendel.sweeps._dataset import dataset_of as dataset_of
from kugelpendel.sweeps._dataset import read as read
from kugelpendel.sweeps._quantities import QUANTITIES as QUANTITIES
from kugelpendel.sweeps._quantities import Quantity as Quantity
from kugelpendel.sweeps._reductions import QUANTILE_ERROR as QUANTILE_ERROR
from kugelpendel.sweeps._run import Progressed as Progressed
from kugelpendel.sweeps._run import progressed as progressed
from kugelpendel.sweeps._run import sweep as sweep
from kugelpendel.sweeps._store import STATUS as STATUS
from kugelpendel.sweeps._store import SweepStore as SweepStore
from kugelpendel.sweeps._store import kept_store as kept_store
from kugelpendel.sweeps.cases import UNITS as UNITS
from kugelpendel.sweeps.cases import Law as Law
from kugelpendel.sweeps.cases import Listed as Listed
from kugelpendel.sweeps.cases import Normal as Normal
from kugelpendel.sweeps.cases import Spaced as Spaced
from kugelpendel.sweeps.cases import Sweep as Sweep
from kugelpendel.sweeps.cases import Uniform as Uniform
from kugelpendel.sweeps.cases import assembled as assembled
