"""How an arm is drawn: projection, symbols, labels, dimensions, plots, one style."""
