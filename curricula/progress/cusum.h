// Cumulative sums of success and failure: when is a procedure mastered, when does something go wrong.
#pragma once

#include <vector>

namespace vallecula::curricula {

/// The test that a failure rate is acceptable against that it is not: Wald's sequential probability ratio, as used for
/// procedures (Bolsin and Colson, Int J Qual Health Care 2000;12:433; Williams et al., BMJ 1992;304:1359). With
///   P = ln(p1/p0), Q = ln((1-p0)/(1-p1)), s = Q/(P+Q), a = ln((1-beta)/alpha), b = ln((1-alpha)/beta)
/// a success takes s off the sum, a failure adds 1-s; h0 = b/(P+Q) below where it began the failure rate is p0 or
/// better, h1 = a/(P+Q) above it is p1 or worse. Competence in neonatal intubation: 80 % success within two attempts
/// (PMC8290971), so p0 = 0.2. p1 = 0.4 and both errors 0.1 are usual and (assumed) here; with them the fewest
/// procedures that reach h0 are 8, as they were there.
struct CusumRule {
  double acceptable_failure_rate = 0.2;    ///< p0
  double unacceptable_failure_rate = 0.4;  ///< p1; 0 < p0 < p1 < 1
  double alpha = 0.1;                      ///< chance to call p0 unacceptable
  double beta = 0.1;                       ///< chance to call p1 acceptable; alpha + beta < 1
};

struct CusumLimits {
  double success_step = 0.0;  ///< s
  double failure_step = 0.0;  ///< 1 - s
  double competent = 0.0;     ///< h0
  double deficient = 0.0;     ///< h1
};
/// Throws std::invalid_argument for a rule outside the ranges above.
CusumLimits cusum_limits(const CusumRule& rule = {});

enum class CusumVerdict { undecided, competent, deficient };

struct CusumCurve {
  std::vector<double> sum;  ///< after each procedure; it began at 0
  /// Index of the procedure with which competence was shown first: the sum fell by h0 from where it began, or from a
  /// limit it had crossed (each crossing decides, and the test begins anew from there, Bolsin and Colson). -1: not yet.
  int competent_at = -1;
  int deficient_at = -1;                        ///< likewise, risen by h1
  CusumVerdict last = CusumVerdict::undecided;  ///< of the last crossing
};
/// `success`: one entry a procedure, in order.
CusumCurve cusum(const std::vector<bool>& success, const CusumRule& rule = {});

/// Procedures up to and with the n-th success in a row; -1: not reached. Throws std::invalid_argument for n < 1.
int procedures_to_consecutive(const std::vector<bool>& success, int n);

}  // namespace vallecula::curricula
