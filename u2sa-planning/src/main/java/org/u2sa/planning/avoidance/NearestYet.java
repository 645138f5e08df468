package org.u2sa.planning.avoidance;

/**
 * The nearest that a vehicle has come to its goal: along its routes, and in height, because a climb
 * or descent in place is progress, too. The two are not added: an error of the altitude would
 * outweigh progress along the route.
 */
final class NearestYet {
  private double wayM = Double.POSITIVE_INFINITY;
  private double heightM = Double.POSITIVE_INFINITY;

  /**
   * Whether the vehicle has come nearer in either way.
   *
   * @param remainingM way to the goal along the route [m]
   */
  boolean isNearer(double remainingM, Situation now) {
    boolean isNearer = remainingM < wayM - now.progressM();
    boolean isLevel = now.heightM() < heightM - now.progressM();
    wayM = isNearer ? remainingM : wayM;
    heightM = isLevel ? now.heightM() : heightM;
    return isNearer || isLevel;
  }
}
