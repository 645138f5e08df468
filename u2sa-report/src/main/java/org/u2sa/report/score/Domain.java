package org.u2sa.report.score;

/** What kind of vehicle a run is of: what is measured, and how far apart things are. */
public enum Domain {
  /**
   * An aircraft, over kilometres. A vehicle that flies over a waypoint cannot be on the next
   * straight at once: one radius of a coordinated turn, r = V² / (g tan φ) = 636 m at 60 m/s and
   * 30° of bank, and some 360 m for rolling in and out (3 s each).
   */
  AIR(1000.0, 500.0, "flown"),
  /**
   * A ground vehicle, over metres. It turns beside the waypoint, up to 2 m away where a mission
   * allows that much, and then needs about a metre to be on the line.
   */
  GROUND(3.0, 10.0, "driven");

  private final double settlingDistanceM;
  private final double leastMapM;
  private final String moved;

  Domain(double settlingDistanceM, double leastMapM, String moved) {
    this.settlingDistanceM = settlingDistanceM;
    this.leastMapM = leastMapM;
    this.moved = moved;
  }

  /** How far beyond the last waypoint a leg counts as turn [m]. */
  public double settlingDistanceM() {
    return settlingDistanceM;
  }

  /** Least extent of a map [m]. */
  public double leastMapM() {
    return leastMapM;
  }

  /** How the vehicle went, e.g. {@code flown}. */
  public String moved() {
    return moved;
  }
}
