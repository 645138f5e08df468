package org.u2sa.core.planning;

import org.u2sa.messages.frame.Point;

/** How a vehicle is led onto a line and along it. */
interface LineLaw {
  /**
   * The point to go to now: north, east [m] from the vehicle, z 0.
   *
   * @param leg with the vehicle at the origin; not a point
   * @param lookAheadM how far ahead the point is to lie [m], positive
   */
  Point pointAhead(Leg leg, double lookAheadM);
}
