package org.u2sa.world;

/** Counts measurements used and dropped, for the health report. */
final class SightingCount {
  private long sightings;
  private long scans;
  private long stateless;
  private long untimed;
  private long early;
  private long badStates;

  /** Counts one sensor's detections of one time as used. */
  void used() {
    sightings++;
  }

  /** Counts a scan as used. */
  void scan() {
    scans++;
  }

  /** Counts a measurement dropped because the vehicle state of its time is unknown. */
  void stateless() {
    stateless++;
  }

  /** Counts a measurement dropped because it has no timestamp. */
  void untimed() {
    untimed++;
  }

  /** Counts a measurement dropped because its timestamp is in the future. */
  void early() {
    early++;
  }

  /** Counts a state dropped because it lacks position, heading or time. */
  void badState() {
    badStates++;
  }

  @Override
  public String toString() {
    return sightings
        + " sightings, "
        + scans
        + " scans, "
        + stateless
        + " without a state of their time, "
        + untimed
        + " without a time, "
        + (early == 0 ? "" : early + " from the future, ")
        + badStates
        + " states without place or heading";
  }
}
