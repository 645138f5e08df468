package org.u2sa.planning.rightofway;

/**
 * An encounter with one vessel, from the first risk of collision until the vessel is past and
 * clear. Its rule is decided once: no later change of bearing changes the vehicle's part in it
 * (rule 13(d)).
 */
final class Encounter {
  private static final double MAX_DOUBT_RAD = Math.toRadians(5.0);
  private static final double MIN_DOUBT_RAD = Math.toRadians(0.5); // of any course

  private final Rule rule;
  private double courseRad; // vehicle's course when the rule was decided, or later resumed
  private Target target; // newest
  private double seenS; // time of the newest track
  private boolean actsItself; // stands on, but the other vessel does not give way
  private final Lasting clear = new Lasting(5.0);

  private Encounter(Rule rule, double courseRad, Target target, double nowS) {
    this.rule = rule;
    this.courseRad = courseRad;
    this.target = target;
    seenS = nowS;
  }

  /**
   * Begins an encounter.
   *
   * @param courseRad course of the vehicle
   * @param approach motion of the target relative to the vehicle
   */
  static Encounter begin(Target target, Approach approach, double courseRad, double nowS) {
    double bearing = approach.bearingRad();
    double doubt =
        Math.hypot(
            target.sigmaM() / Math.max(1.0, approach.rangeM()),
            target.sigmaMps() / Math.max(0.1, target.speedMps()));
    Rule rule =
        Rule.of(
            bearing - courseRad,
            bearing + Math.PI - target.courseRad(),
            Math.min(MAX_DOUBT_RAD, MIN_DOUBT_RAD + doubt));
    return new Encounter(rule, courseRad, target, nowS);
  }

  Rule rule() {
    return rule;
  }

  /** Course that the vehicle holds if it stands on [rad]. */
  double courseRad() {
    return courseRad;
  }

  void hold(double newCourseRad) {
    courseRad = newCourseRad;
  }

  Target target() {
    return target;
  }

  void see(Target newest, double nowS) {
    target = newest;
    seenS = nowS;
  }

  /** Moves a target that has no new track along its course; returns the age of its track [s]. */
  double unseen(double sinceS, double nowS) {
    target = target.after(sinceS);
    return nowS - seenS;
  }

  /** Whether the vehicle must act: it gives way, or the other vessel should but does not. */
  boolean mustAct() {
    return rule.givesWay() || actsItself;
  }

  boolean actsItself() {
    return actsItself;
  }

  void actItself() {
    actsItself = true;
  }

  /** Whether it is over: the target has been past and clear for some seconds. */
  boolean isOver(boolean isClear, double nowS) {
    return clear.lasts(isClear, nowS);
  }

  @Override
  public String toString() {
    return "\"" + target.name() + "\": " + rule;
  }
}
