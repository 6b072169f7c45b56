"""Tasks that know whether an answer is right: opened in a lesson, checked in a notebook, read by grading."""

from course.feedback.answer import WithSympy
from course.feedback.choice import Choice, Number
from course.feedback.errors import AnswerError, LessonError
from course.feedback.formula import Formula
from course.feedback.lesson import Lesson, lessons, open_lesson, results
from course.feedback.outcome import Feedback, Outcome, Row
from course.feedback.quantity import Quantity
from course.feedback.table import Table
from course.feedback.task import Task, Wrong

__all__ = [
    "AnswerError",
    "Choice",
    "Feedback",
    "Formula",
    "Lesson",
    "LessonError",
    "Number",
    "Outcome",
    "Quantity",
    "Row",
    "Table",
    "Task",
    "WithSympy",
    "Wrong",
    "lessons",
    "open_lesson",
    "results",
]
