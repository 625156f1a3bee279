# Monomials of vectors that are off by up to C * 2^-52 of their size, as src/exact/measure/distance/triangle_vectors.hpp computes
# them for its certain signs; C = 1/2: points that are exact.
#
# Each operation is (a op b)(1 + e), |e| <= 2^-52: any rounding mode. Coordinates are scaled by their size to |x| <= 1;
# x + d is the true one. Proved: a monomial of degree g with r roundings on its way is off by no more than
# (g C + r) * 2^-52 (1 + 2^-20), for (g, r) = (2, 3), (3, 5), (4, 7) and (4, 8).
P23 = x1*x2*((1+e1)*(1+e2)*(1+e3));
Q2 = (x1+d1)*(x2+d2);
T23 = x1*x2*((1+e1)*(1+e2)*(1+e3)-1) - d1*x2 - (x1+d1)*d2;
P35 = x1*x2*x3*((1+e1)*(1+e2)*(1+e3)*(1+e4)*(1+e5));
Q3 = (x1+d1)*(x2+d2)*(x3+d3);
T35 = x1*x2*x3*((1+e1)*(1+e2)*(1+e3)*(1+e4)*(1+e5)-1) - d1*x2*x3 - (x1+d1)*d2*x3 - (x1+d1)*(x2+d2)*d3;
Q4 = (x1+d1)*(x2+d2)*(x3+d3)*(x4+d4);
P47 = x1*x2*x3*x4*((1+e1)*(1+e2)*(1+e3)*(1+e4)*(1+e5)*(1+e6)*(1+e7));
T47 = x1*x2*x3*x4*((1+e1)*(1+e2)*(1+e3)*(1+e4)*(1+e5)*(1+e6)*(1+e7)-1)
  - d1*x2*x3*x4 - (x1+d1)*d2*x3*x4 - (x1+d1)*(x2+d2)*d3*x4 - (x1+d1)*(x2+d2)*(x3+d3)*d4;
P48 = x1*x2*x3*x4*((1+e1)*(1+e2)*(1+e3)*(1+e4)*(1+e5)*(1+e6)*(1+e7)*(1+e8));
T48 = x1*x2*x3*x4*((1+e1)*(1+e2)*(1+e3)*(1+e4)*(1+e5)*(1+e6)*(1+e7)*(1+e8)-1)
  - d1*x2*x3*x4 - (x1+d1)*d2*x3*x4 - (x1+d1)*(x2+d2)*d3*x4 - (x1+d1)*(x2+d2)*(x3+d3)*d4;
{ x1 in [-1,1] /\ x2 in [-1,1] /\ x3 in [-1,1] /\ x4 in [-1,1]
  /\ d1 in [-1b-53,1b-53] /\ d2 in [-1b-53,1b-53] /\ d3 in [-1b-53,1b-53] /\ d4 in [-1b-53,1b-53]
  /\ e1 in [-1b-52,1b-52] /\ e2 in [-1b-52,1b-52] /\ e3 in [-1b-52,1b-52] /\ e4 in [-1b-52,1b-52]
  /\ e5 in [-1b-52,1b-52] /\ e6 in [-1b-52,1b-52] /\ e7 in [-1b-52,1b-52] /\ e8 in [-1b-52,1b-52]
  -> |P23 - Q2| <= 8388609b-73
  /\ |P35 - Q3| <= 13631489b-73
  /\ |P47 - Q4| <= 18874369b-73
  /\ |P48 - Q4| <= 20971521b-73 }
P23 - Q2 -> T23;
P35 - Q3 -> T35;
P47 - Q4 -> T47;
P48 - Q4 -> T48;
