# A coordinate of a posed point, as src/exact/point/point.hpp computes it: three products and a translation.
#
# Each operation is (a op b)(1 + e), |e| <= 2^-52: any rounding mode. The translation d itself is a rounded difference
# of two, d = (t - t0)(1 + g); here t stands for t - t0. Terms are scaled by S = |p0| + |p1| + |p2| + |t|, with
# p_j = r_j v_j, so that S = 1; the claim is about each term's factor, and their weighted sum is no larger than the
# largest. Proved: no factor is off by more than 4.25 * 2^-52, the factor in filter_bound.hpp.
F0 = (1+e0)*(1+f1)*(1+f2)*(1+f3) - 1;
F1 = (1+e1)*(1+f1)*(1+f2)*(1+f3) - 1;
F2 = (1+e2)*(1+f2)*(1+f3) - 1;
Ft = (1+g)*(1+f3) - 1;
{ e0 in [-1b-52,1b-52] /\ e1 in [-1b-52,1b-52] /\ e2 in [-1b-52,1b-52] /\ g in [-1b-52,1b-52]
  /\ f1 in [-1b-52,1b-52] /\ f2 in [-1b-52,1b-52] /\ f3 in [-1b-52,1b-52]
  -> F0 in [-17b-54,17b-54] /\ F1 in [-17b-54,17b-54] /\ F2 in [-17b-54,17b-54] /\ Ft in [-17b-54,17b-54] }
