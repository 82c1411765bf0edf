// Weighted metric temporal logic: counts of agents with weights, G[0,9]^w (sum(a) >= 2 ||^2 b).
grammar wmtl;

import weighted, mtl;
