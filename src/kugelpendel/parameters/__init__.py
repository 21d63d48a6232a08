"""What is given: frozen, checked, in SI."""

from ._bob import Bob as Bob
from ._drag import Drag as Drag
from ._drive import Drive as Drive
from ._invalid import InvalidInput as InvalidInput
from ._launch import Launch as Launch
from ._numbers import Numbers as Numbers
from ._numbers import Scalars as Scalars
from ._numbers import as_array as as_array
from ._numbers import as_numbers as as_numbers
from ._numbers import common_shape as common_shape
from ._numbers import unfit as unfit
from ._pendulum import Pendulum as Pendulum
from ._site import Site as Site
from ._suspension import Suspension as Suspension
from ._wire import Wire as Wire
