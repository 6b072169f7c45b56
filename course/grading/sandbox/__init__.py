"""The sandbox of one submission: each protection in a file of its own, all of them optional, none taken on trust."""
