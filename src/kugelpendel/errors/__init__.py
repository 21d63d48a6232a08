"""What is raised: errors by type, each with its kind, the values seen, and a sentence."""

from kugelpendel.errors._extras import require_extra as require_extra
from kugelpendel.errors._extras import with_extra as with_extra
from kugelpendel.errors._kinds import problem_kinds as problem_kinds
from kugelpendel.errors._seen import Door as Door
from kugelpendel.errors._seen import FileLine as FileLine
from kugelpendel.errors._seen import Language as Language
from kugelpendel.errors._seen import Seen as Seen
from kugelpendel.errors._seen import Told as Told
from kugelpendel.errors._types import EventNotFound as EventNotFound
from kugelpendel.errors._types import InvalidInput as InvalidInput
from kugelpendel.errors._types import KugelpendelError as KugelpendelError
from kugelpendel.errors._types import MissingExtra as MissingExtra
from kugelpendel.errors._types import MotionEnded as MotionEnded
