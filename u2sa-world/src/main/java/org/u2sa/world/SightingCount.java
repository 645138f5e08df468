package org.u2sa.world;

/** Numbers of measurements used and dropped, for the health report. */
final class SightingCount {
  long sightings; // one sensor's detections at one time
  long scans;
  long stateless; // dropped: no vehicle state at their time
  long untimed; // dropped: no timestamp
  long early; // dropped: timestamp in the future
  long crowded; // objects dropped: more than a step has time for
  long badScans; // without beams, or longer than a scan can take
  long badStates; // states without position, heading or time

  @Override
  public String toString() {
    return String.format(
        "%s sightings, %s scans, %s without a state at their time, %s without a time, %s%s%s"
            + "%s states without position or heading",
        sightings,
        scans,
        stateless,
        untimed,
        early == 0 ? "" : early + " from the future, ",
        crowded == 0 ? "" : crowded + " objects too many at once, ",
        badScans == 0 ? "" : badScans + " scans without beams or too long, ",
        badStates);
  }
}
