// Weighted signal temporal logic: STL with weights, F[0,5]^w (x >= 3 &&^[0.2, 0.8] y <= 1).
grammar wstl;

import weighted, stl;
