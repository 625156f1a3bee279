# The determinant of three differences, as src/exact/sign/plain_signs.hpp computes it: a normal of three minors, then a dot
# product with the third difference.
#
# Each operation is (a op b)(1 + e), |e| <= 2^-52: any rounding mode. The differences are scaled by their bounds to
# |x|, |y|, |z| <= 1; the determinant is homogeneous in each of them, so the bound scales with Ex Ey Ez.
# Proved: |D - E| <= 28.125 * 2^-52. (filter_bound.hpp uses 30.)
p1 = y1*z2*(1+e1); p2 = z1*y2*(1+e2); nx = (p1-p2)*(1+e3);
p3 = z1*x2*(1+e4); p4 = x1*z2*(1+e5); ny = (p3-p4)*(1+e6);
p5 = x1*y2*(1+e7); p6 = y1*x2*(1+e8); nz = (p5-p6)*(1+e9);
m1 = nx*x3*(1+f1); m2 = ny*y3*(1+f2); m3 = nz*z3*(1+f3);
s1 = (m1+m2)*(1+g1); D = (s1+m3)*(1+g2);
E = ((y1*z2 - z1*y2)*x3 + (z1*x2 - x1*z2)*y3) + (x1*y2 - y1*x2)*z3;
# The error, product by product: each meets at most five factors.
T = y1*z2*x3*((1+e1)*(1+e3)*(1+f1)*(1+g1)*(1+g2)-1) - z1*y2*x3*((1+e2)*(1+e3)*(1+f1)*(1+g1)*(1+g2)-1)
  + z1*x2*y3*((1+e4)*(1+e6)*(1+f2)*(1+g1)*(1+g2)-1) - x1*z2*y3*((1+e5)*(1+e6)*(1+f2)*(1+g1)*(1+g2)-1)
  + x1*y2*z3*((1+e7)*(1+e9)*(1+f3)*(1+g2)-1) - y1*x2*z3*((1+e8)*(1+e9)*(1+f3)*(1+g2)-1);
{ x1 in [-1,1] /\ y1 in [-1,1] /\ z1 in [-1,1] /\ x2 in [-1,1] /\ y2 in [-1,1] /\ z2 in [-1,1]
  /\ x3 in [-1,1] /\ y3 in [-1,1] /\ z3 in [-1,1]
  /\ e1 in [-1b-52,1b-52] /\ e2 in [-1b-52,1b-52] /\ e3 in [-1b-52,1b-52] /\ e4 in [-1b-52,1b-52]
  /\ e5 in [-1b-52,1b-52] /\ e6 in [-1b-52,1b-52] /\ e7 in [-1b-52,1b-52] /\ e8 in [-1b-52,1b-52]
  /\ e9 in [-1b-52,1b-52] /\ f1 in [-1b-52,1b-52] /\ f2 in [-1b-52,1b-52] /\ f3 in [-1b-52,1b-52]
  /\ g1 in [-1b-52,1b-52] /\ g2 in [-1b-52,1b-52]
  -> |D - E| <= 225b-55 }
D - E -> T;
