package org.u2sa.report.score;

/** Kind of vehicle of a run, which determines what is measured and the scale of distances. */
public enum Domain {
  /**
   * An aircraft, over kilometres. After flying over a waypoint it needs some distance to settle on
   * the next leg: one radius of a coordinated turn, r = V² / (g tan φ) = 636 m at 60 m/s and 30° of
   * bank, plus about 360 m for rolling in and out (3 s each).
   */
  AIR(1000.0, 500.0, "flown"),
  /**
   * A ground vehicle, over metres. It turns beside the waypoint, up to 2 m away if the mission
   * allows it, and then needs about a metre to settle on the line.
   */
  GROUND(3.0, 10.0, "driven"),
  /**
   * A boat, over tens of metres. Without wheels it drifts outwards in turns and needs several boat
   * lengths (2 m each) to settle.
   */
  WATER(10.0, 20.0, "sailed"),
  /** A submarine, over tens of metres: like {@link #WATER}, with depth. */
  UNDERWATER(10.0, 20.0, "dived"),
  /** A multirotor or a small aeroplane, over tens or hundreds of metres. */
  SMALL_AIRCRAFT(20.0, 30.0, "flown");

  private final double settlingDistanceM;
  private final double leastMapM;
  private final String moved;

  Domain(double settlingDistanceM, double leastMapM, String moved) {
    this.settlingDistanceM = settlingDistanceM;
    this.leastMapM = leastMapM;
    this.moved = moved;
  }

  /** Whether the vehicle is in the air. */
  public boolean flies() {
    return this == AIR || this == SMALL_AIRCRAFT;
  }

  /** Distance after a waypoint that still counts as turn [m]. */
  public double settlingDistanceM() {
    return settlingDistanceM;
  }

  /** Minimum extent of a map [m]. */
  public double leastMapM() {
    return leastMapM;
  }

  /** Verb for the vehicle's motion, e.g. {@code flown}. */
  public String moved() {
    return moved;
  }
}
