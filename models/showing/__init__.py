"""An arm in Drake's visualizer, as a picture, as a page that moves."""
