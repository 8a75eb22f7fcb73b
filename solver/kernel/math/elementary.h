/* Elementary functions with the same bits on every machine, to less than 1 ulp. Special values are
   those of C99. */
#ifndef HOLONOM_ELEMENTARY_H
#define HOLONOM_ELEMENTARY_H

double hm_sin(double x);
double hm_cos(double x);
double hm_tan(double x);
double hm_asin(double x);
double hm_acos(double x);
double hm_atan(double x);
double hm_atan2(double y, double x);
double hm_exp(double x);
double hm_log(double x);
double hm_pow(double x, double y);
double hm_hypot(double x, double y);
double hm_sinh(double x);
double hm_cosh(double x);
double hm_tanh(double x);
double hm_atanh(double x);

#endif
