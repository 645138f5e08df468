package org.u2sa.benchmarks.chain;

import java.util.Locale;

/**
 * What the chain runs beside.
 *
 * @param hz measurements of the IMU a second
 * @param neighbours services that publish and listen at 50 Hz
 * @param company "none", "slow" (a slow subscriber), or "recorder"
 */
record Scenario(int hz, int neighbours, String company) {
  @Override
  public String toString() {
    String beside = company.equals("none") ? "" : ", " + company;
    return String.format(Locale.ROOT, "%d Hz, %d neighbours%s", hz, neighbours, beside);
  }
}
