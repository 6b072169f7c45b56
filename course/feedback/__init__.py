"""Tasks that know whether an answer is right: opened in a lesson, checked in a notebook, read by grading."""

from armproof.course.errors import AnswerError, LessonError
from armproof.course.feedback.answer import WithSympy
from armproof.course.feedback.choice import Choice, Number
from armproof.course.feedback.derivation import Derivation, Line
from armproof.course.feedback.formula import Formula
from armproof.course.feedback.lesson import Lesson, lessons, open_lesson, results
from armproof.course.feedback.outcome import Feedback, Outcome, Row
from armproof.course.feedback.overview import course
from armproof.course.feedback.own_numbers import drawn, picked
from armproof.course.feedback.placement import Placement
from armproof.course.feedback.quantity import Quantity
from armproof.course.feedback.table import Table
from armproof.course.feedback.task import Task, Wrong
from armproof.course.figures.facts.placing import Scheme

__all__ = [
    "AnswerError",
    "Choice",
    "Derivation",
    "Feedback",
    "Formula",
    "Lesson",
    "LessonError",
    "Line",
    "Number",
    "Outcome",
    "Placement",
    "Quantity",
    "Row",
    "Scheme",
    "Table",
    "Task",
    "WithSympy",
    "Wrong",
    "course",
    "drawn",
    "lessons",
    "open_lesson",
    "picked",
    "results",
]
