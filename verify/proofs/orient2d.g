# The minor of two differences, as src/exact/sign/plain_signs.hpp computes it: a difference of two products.
#
# Each operation is (a op b)(1 + e), |e| <= 2^-52: any rounding mode. The differences are scaled by their bounds to
# |x|, |y| <= 1; the minor is homogeneous in each of them, so the bound scales with Ei Ej.
# Proved: |D - E| <= 4.25 * 2^-52, the factor in filter_bound.hpp.
p1 = x1*y2*(1+e1); p2 = y1*x2*(1+e2); D = (p1-p2)*(1+e3);
E = x1*y2 - y1*x2;
T = x1*y2*((1+e1)*(1+e3)-1) - y1*x2*((1+e2)*(1+e3)-1);
{ x1 in [-1,1] /\ y1 in [-1,1] /\ x2 in [-1,1] /\ y2 in [-1,1]
  /\ e1 in [-1b-52,1b-52] /\ e2 in [-1b-52,1b-52] /\ e3 in [-1b-52,1b-52]
  -> |D - E| <= 17b-54 }
D - E -> T;
