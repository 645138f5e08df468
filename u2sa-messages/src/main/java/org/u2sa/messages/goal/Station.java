package org.u2sa.messages.goal;

import java.util.List;
import java.util.OptionalDouble;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.ValueField;

/**
 * A position to keep, with a heading if {@link #psi} is given: for station keeping, or for a berth
 * entered along its axis. It is reached when the vehicle has stayed within both thresholds and on
 * its heading for the {@link #duration}. A vehicle that cannot stop circles around the position; it
 * is reached after duration and {@link #turns}, counted from its arrival on the circle at the
 * altitude.
 */
public class Station extends Waypoint {
  private static final Schema<Station> SCHEMA =
      Schema.of(Station.class, Station::new, Waypoint.TYPE).since(3);
  private static final NumberField<Station> DURATION = SCHEMA.optionalNumber("duration", "s", 0.0);
  private static final NumberField<Station> APPROACH = SCHEMA.optionalNumber("approach", "m", 0.0);
  private static final ValueField<Station, Boolean> BACKWARDS = SCHEMA.optionalFlag("backwards");
  private static final NumberField<Station> RADIUS = SCHEMA.optionalNumber("radius", "m");
  private static final NumberField<Station> TURNS =
      SCHEMA.optionalNumber("turns", "1", 0.0, 1000.0);
  private static final ValueField<Station, Boolean> TOWARDS_NEXT =
      SCHEMA.optionalFlag("towardsNext");

  public static final MessageType<Station> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends Station> type() {
    return TYPE;
  }

  /** Time to stay there [s]; empty: until the mission changes. */
  public OptionalDouble duration() {
    return get(DURATION);
  }

  public Station duration(double seconds) {
    return put(DURATION, seconds);
  }

  /**
   * Length of the straight way that ends at the position, along {@link #psi} [m]; empty: the
   * position is approached from any side. Ignored without psi.
   */
  public OptionalDouble approach() {
    return get(APPROACH);
  }

  public Station approach(double metres) {
    return put(APPROACH, metres);
  }

  /** Whether the straight way is travelled in reverse, stern first; defaults to false. */
  public boolean backwards() {
    return Boolean.TRUE.equals(get(BACKWARDS));
  }

  public Station backwards(boolean value) {
    return put(BACKWARDS, value);
  }

  /**
   * Radius of the circle of a vehicle that cannot stop [m]; positive clockwise, negative
   * counter-clockwise, empty or 0: the planner's, in the direction of arrival.
   */
  public OptionalDouble radius() {
    return get(RADIUS);
  }

  public Station radius(double metres) {
    return put(RADIUS, metres);
  }

  /** Number of turns of a vehicle that cannot stop; empty: none are counted. */
  public OptionalDouble turns() {
    return get(TURNS);
  }

  public Station turns(double number) {
    return put(TURNS, number);
  }

  /**
   * Whether a vehicle that cannot stop leaves its circle only when its course leads to the next
   * goal; defaults to false.
   */
  public boolean towardsNext() {
    return Boolean.TRUE.equals(get(TOWARDS_NEXT));
  }

  public Station towardsNext(boolean value) {
    return put(TOWARDS_NEXT, value);
  }

  @Override
  public Station uid(String uid) {
    return (Station) super.uid(uid);
  }

  @Override
  public Station next(List<String> uids) {
    return (Station) super.next(uids);
  }
}
