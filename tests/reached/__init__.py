"""Documents found by search that few others are like: what conditions of the trusted base came out as."""
