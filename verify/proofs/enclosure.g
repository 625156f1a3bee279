# The two ends of an enclosure, as src/exact/measure/distance/enclose_distance.cpp computes them.
#
# Each operation is (a op b)(1 + e), |e| <= 2^-52: any rounding mode. A product of two vectors meets three factors on
# the way of a term, a coordinate of the difference of two points five. Proved: the factors are off by no more than
# 3.0001 and 5.0001 times 2^-52. And the length of a vector times 1 + 8 * 2^-52 is not below the true one: of its square
# three factors on the way of a term, two of the root, and two of that product.
F = (1+e1)*(1+e2)*(1+e3) - 1;
G = (1+e1)*(1+e2)*(1+e3)*(1+e4)*(1+e5) - 1;
S = (1+e1)*(1+e2)*(1+e3)*((1+e4)*(1+e4))*((1+1b-49)*(1+1b-49))*((1+e5)*(1+e5)) - 1;
{ e1 in [-1b-52,1b-52] /\ e2 in [-1b-52,1b-52] /\ e3 in [-1b-52,1b-52]
  /\ e4 in [-1b-52,1b-52] /\ e5 in [-1b-52,1b-52]
  -> |F| <= 49153b-66 /\ |G| <= 81921b-66 /\ S >= 0 }
