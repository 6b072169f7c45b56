"""The sandbox of one submission: bubblewrap makes it, the run joins it, and the kernel limits what it takes."""
