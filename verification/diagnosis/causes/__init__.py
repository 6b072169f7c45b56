"""The likely mistake behind a matrix that is wrong as a whole."""
