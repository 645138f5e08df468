package org.u2sa.planning.rightofway;

/** The vehicle's part in an encounter with another vessel (COLREGs 13 to 17). */
public enum Rule {
  /** Another vessel overtakes: stand on (rules 13 and 17). */
  OVERTAKEN("being overtaken", "13, 17", false),
  /** Overtakes another vessel: keep clear on either side (rule 13). */
  OVERTAKING("overtaking", "13", true),
  /** Reciprocal or nearly reciprocal courses: alter course to starboard (rule 14). */
  HEAD_ON("head-on", "14", true),
  /** The other vessel crosses from starboard: keep clear, pass astern (rules 15 and 16). */
  CROSSING_GIVE_WAY("crossing", "15, 16", true),
  /** The other vessel crosses from port: stand on (rules 15 and 17). */
  CROSSING_STAND_ON("crossing", "15, 17", false);

  /** Relative bearing beyond which a vessel is abaft the beam by more than 22.5° (rule 13(b)). */
  private static final double ABAFT_RAD = Math.toRadians(112.5);

  /** Relative bearing up to which the vessel ahead is overtaken. */
  private static final double AHEAD_RAD = Math.toRadians(67.5);

  /** Sector of reciprocal or nearly reciprocal courses (rule 14(a)). */
  private static final double NEARLY_AHEAD_RAD = Math.toRadians(5.0);

  private final String words;
  private final String numbers;
  private final boolean givesWay;

  Rule(String words, String numbers, boolean givesWay) {
    this.words = words;
    this.numbers = numbers;
    this.givesWay = givesWay;
  }

  public String numbers() {
    return numbers;
  }

  /** Whether the vehicle has to keep out of the way. */
  public boolean givesWay() {
    return givesWay;
  }

  /**
   * Classifies an encounter by the sectors of dnv-opensource/ship-traffic-generator (MIT, {@code
   * determine_colreg}). In doubt the rules for head-on and for overtaking apply (rules 13(c) and
   * 14(c)).
   *
   * @param bearingRad bearing of the other vessel relative to the vehicle's course, clockwise [rad,
   *     any]
   * @param aspectRad bearing of the vehicle relative to the other vessel's course, clockwise [rad,
   *     any]
   * @param doubtRad uncertainty of both [rad]
   */
  public static Rule of(double bearingRad, double aspectRad, double doubtRad) {
    double bearing = Angles.wrapped(bearingRad);
    double aspect = Angles.wrapped(aspectRad);
    double nearly = NEARLY_AHEAD_RAD + doubtRad;
    if (Math.abs(bearing) > ABAFT_RAD && Math.abs(aspect) <= AHEAD_RAD) {
      return OVERTAKEN;
    }
    if (Math.abs(aspect) > ABAFT_RAD - doubtRad && Math.abs(bearing) <= AHEAD_RAD) {
      return OVERTAKING;
    }
    if (Math.abs(bearing) <= nearly && Math.abs(aspect) <= nearly) {
      return HEAD_ON;
    }
    if (bearing > 0.0 && bearing <= ABAFT_RAD && aspect <= nearly && aspect > -ABAFT_RAD) {
      return CROSSING_GIVE_WAY;
    }
    if (aspect > 0.0 && aspect <= ABAFT_RAD && bearing <= nearly && bearing > -ABAFT_RAD) {
      return CROSSING_STAND_ON;
    }
    if (Math.abs(bearing) > ABAFT_RAD) {
      return OVERTAKEN;
    }
    return Math.abs(aspect) > ABAFT_RAD ? OVERTAKING : HEAD_ON; // green to green or red to red
  }

  @Override
  public String toString() {
    return words + (givesWay ? ", gives way" : ", stands on") + " (rule " + numbers + ")";
  }
}
