package org.u2sa.scenarios.roboboat;

import java.util.List;
import java.util.OptionalDouble;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.ValueField;

/** A task near an approximately known position, with the objects that it needs (thesis 4.2.1.3). */
public class BoatTask extends GoalInformation {
  private static final Schema<BoatTask> SCHEMA =
      Schema.of(BoatTask.class, BoatTask::new, GoalInformation.TYPE);
  private static final NumberField<BoatTask> X = SCHEMA.requiredCoordinate("x");
  private static final NumberField<BoatTask> Y = SCHEMA.requiredCoordinate("y");
  private static final NumberField<BoatTask> EXPECTED_TIME =
      SCHEMA.optionalNumber("expectedTime", "s", 0.0);
  private static final NumberField<BoatTask> SUCCESS =
      SCHEMA.optionalNumber("successProbability", "", 0.01, 1.0);
  private static final NumberField<BoatTask> PSI = SCHEMA.optionalNumber("psi", "rad");
  private static final NumberField<BoatTask> END_BY = SCHEMA.optionalNumber("endBy", "s", 0.0);
  private static final ValueField<BoatTask, Boolean> FALLBACK = SCHEMA.optionalFlag("fallback");
  private static final ValueField<BoatTask, List<String>> OBJECT_TYPES =
      SCHEMA.optionalTexts("objectTypes");

  public static final MessageType<BoatTask> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends BoatTask> type() {
    return TYPE;
  }

  /** Longitude of the station [deg]. */
  public double x() {
    return require(X);
  }

  /** Latitude of the station [deg]. */
  public double y() {
    return require(Y);
  }

  /** The station in GLOBAL. */
  Point place() {
    return Point.of(x(), y(), 0.0);
  }

  public BoatTask place(double longitudeDeg, double latitudeDeg) {
    return put(X, longitudeDeg).put(Y, latitudeDeg);
  }

  /** Usual duration of the task at its station [s]; 0 if unknown. */
  public double expectedTime() {
    return get(EXPECTED_TIME).orElse(0.0);
  }

  /** Probability that the task succeeds, 0…1; 1 if unknown. */
  public double successProbability() {
    return get(SUCCESS).orElse(1.0);
  }

  /** Heading at the station that faces its objects, clockwise from north [rad]; empty: any. */
  public OptionalDouble psi() {
    return get(PSI);
  }

  /**
   * Mission time by which the task must be finished to leave enough time to get home [s]; empty:
   * any.
   */
  public OptionalDouble endBy() {
    return get(END_BY);
  }

  /** Whether the task is chosen only if no other current goal can be finished in time. */
  public boolean fallback() {
    return Boolean.TRUE.equals(get(FALLBACK));
  }

  /** Types of objects that the task needs, such as "orange buoy"; empty: all. */
  public List<String> objectTypes() {
    List<String> types = get(OBJECT_TYPES);
    return types == null ? List.of() : types;
  }

  @Override
  public BoatTask copy() {
    return (BoatTask) super.copy();
  }
}
