"""The course as static pages: each lesson executed, typeset and illustrated, to be read without a network or a script."""
