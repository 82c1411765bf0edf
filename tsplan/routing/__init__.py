"""Ways of single agents around each other: what makes a plan of flows fit into narrow places."""
