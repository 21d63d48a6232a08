"""From the files of cameras, phones, sensors and spreadsheets to tracks."""

from kugelpendel.tracks.read._appended import Appended as Appended
from kugelpendel.tracks.read._appended import Place as Place
from kugelpendel.tracks.read._read import read as read
