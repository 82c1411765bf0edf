"""From missions to models: flows, the logic's rows, objectives, and the searches on them."""
