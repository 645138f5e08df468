package org.u2sa.world;

/** How many measurements found their way into the map, for the health report. */
final class SightingCount {
  private long sightings;
  private long scans;
  private long stateless;
  private long untimed;
  private long badStates;

  /** What one sensor saw at one moment was used. */
  void used() {
    sightings++;
  }

  /** A scan was used. */
  void scan() {
    scans++;
  }

  /** A measurement was dropped: where the vehicle was at its time is not known. */
  void stateless() {
    stateless++;
  }

  /** A measurement was dropped: it does not say when it was made. */
  void untimed() {
    untimed++;
  }

  /** A state was dropped: it lacks place, heading or time. */
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
        + badStates
        + " states without place or heading";
  }
}
