package org.u2sa.scenarios.roboboat.subvehicle;

import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;

/**
 * An object to be fetched by a hovering aircraft: fly there, grip it, and land at the starting
 * point, or where the deck has moved to (thesis 4.2.1.3). The position is that of the aircraft when
 * it grips, including z; both thresholds apply to it. {@link #arrivedAt} is when the gripper first
 * reached the object.
 */
public final class FetchGoal extends Waypoint {
  private static final Schema<FetchGoal> SCHEMA =
      Schema.of(FetchGoal.class, FetchGoal::new, Waypoint.TYPE);
  private static final NumberField<FetchGoal> HEIGHT = SCHEMA.optionalNumber("height", "m", 0.0);
  private static final NumberField<FetchGoal> GRIP_TIME =
      SCHEMA.optionalNumber("gripTime", "s", 0.0);
  private static final NumberField<FetchGoal> LIMIT = SCHEMA.optionalNumber("limit", "s", 0.0);

  private static final NumberField<FetchGoal> DECK_NORTH = SCHEMA.optionalNumber("deckNorth", "m");
  private static final NumberField<FetchGoal> DECK_EAST = SCHEMA.optionalNumber("deckEast", "m");

  private static final double USUAL_HEIGHT_M = 2.0;
  private static final double USUAL_GRIP_S = 2.0;
  private static final double USUAL_LIMIT_S = 60.0;

  public static final MessageType<FetchGoal> TYPE = SCHEMA.build();

  @Override
  public MessageType<FetchGoal> type() {
    return TYPE;
  }

  /** Flight height above the start or the object, whichever is higher [m]; defaults to 2. */
  public double height() {
    return get(HEIGHT).orElse(USUAL_HEIGHT_M);
  }

  public FetchGoal height(double metres) {
    return put(HEIGHT, metres);
  }

  /** Time for which the gripper must stay at the object [s]; defaults to 2. */
  public double gripTime() {
    return get(GRIP_TIME).orElse(USUAL_GRIP_S);
  }

  public FetchGoal gripTime(double seconds) {
    return put(GRIP_TIME, seconds);
  }

  /** Time after take-off at which the aircraft returns without the object [s]; defaults to 60. */
  public double limit() {
    return get(LIMIT).orElse(USUAL_LIMIT_S);
  }

  public FetchGoal limit(double seconds) {
    return put(LIMIT, seconds);
  }

  /** How far north the deck has moved since the take-off [m]; defaults to 0. */
  public double deckNorth() {
    return get(DECK_NORTH).orElse(0.0);
  }

  public FetchGoal deckNorth(double metres) {
    return put(DECK_NORTH, metres);
  }

  /** How far east the deck has moved since the take-off [m]; defaults to 0. */
  public double deckEast() {
    return get(DECK_EAST).orElse(0.0);
  }

  public FetchGoal deckEast(double metres) {
    return put(DECK_EAST, metres);
  }

  @Override
  public FetchGoal copy() {
    return (FetchGoal) super.copy();
  }
}
