"""What is given: frozen, checked, in SI."""

from kugelpendel.errors import InvalidInput as InvalidInput
from kugelpendel.parameters._bob import Bob as Bob
from kugelpendel.parameters._drag import Drag as Drag
from kugelpendel.parameters._drive import Drive as Drive
from kugelpendel.parameters._forces import FORCE_PARTS as FORCE_PARTS
from kugelpendel.parameters._forces import ActedOn as ActedOn
from kugelpendel.parameters._forces import ForceParts as ForceParts
from kugelpendel.parameters._forces import Forces as Forces
from kugelpendel.parameters._forces import gathered as gathered
from kugelpendel.parameters._forces import require_given as require_given
from kugelpendel.parameters._forces import unfit_parts as unfit_parts
from kugelpendel.parameters._given import Given as Given
from kugelpendel.parameters._given import require_type as require_type
from kugelpendel.parameters._launch import Launch as Launch
from kugelpendel.parameters._numbers import Numbers as Numbers
from kugelpendel.parameters._numbers import Scalars as Scalars
from kugelpendel.parameters._numbers import as_array as as_array
from kugelpendel.parameters._numbers import as_numbers as as_numbers
from kugelpendel.parameters._numbers import column as column
from kugelpendel.parameters._numbers import common_shape as common_shape
from kugelpendel.parameters._numbers import one_number as one_number
from kugelpendel.parameters._numbers import unfit as unfit
from kugelpendel.parameters._pendulum import Pendulum as Pendulum
from kugelpendel.parameters._site import Site as Site
from kugelpendel.parameters._suspension import Suspension as Suspension
from kugelpendel.parameters._wire import Wire as Wire
