"""Why an equation is wrong: its wrong entries, their causes, a counterexample."""
