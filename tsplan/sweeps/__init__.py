"""Many runs of missions: what is varied, one row of results for each, and resuming them."""
