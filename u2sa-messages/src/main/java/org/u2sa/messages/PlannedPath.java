package org.u2sa.messages;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/** The Path Planner's path to its goal and its cost, for display. */
public final class PlannedPath extends U2SAData {
  private static final Schema<PlannedPath> SCHEMA =
      Schema.of(PlannedPath.class, PlannedPath::new, U2SAData.TYPE).since(3);
  private static final ValueField<PlannedPath, String> SUBSYSTEM =
      SCHEMA.name("subsystem", "VEHICLE");
  private static final ValueField<PlannedPath, String> GOAL = SCHEMA.id("goal", "");
  private static final ValueField<PlannedPath, String> PLANNER = SCHEMA.requiredName("planner");
  private static final ValueField<PlannedPath, PathStatus> STATUS =
      SCHEMA.requiredChoice("status", PathStatus.class);
  private static final ValueField<PlannedPath, String> REASON = SCHEMA.optionalNote("reason");
  private static final ValueField<PlannedPath, ReferenceFrame> REFERENCE_FRAME =
      SCHEMA.frame("referenceFrame", ReferenceFrame.GLOBAL);
  private static final ValueField<PlannedPath, List<Point>> POINTS = SCHEMA.points("points", "m");
  private static final NumberField<PlannedPath> COST = SCHEMA.optionalNumber("cost", "m", 0.0);

  public static final MessageType<PlannedPath> TYPE = SCHEMA.build();

  @Override
  public MessageType<PlannedPath> type() {
    return TYPE;
  }

  /** Subsystem to move; defaults to "VEHICLE". */
  public String subsystem() {
    return require(SUBSYSTEM);
  }

  public PlannedPath subsystem(String value) {
    return put(SUBSYSTEM, value);
  }

  /** UID of the goal; empty if none. */
  public String goal() {
    return get(GOAL);
  }

  public PlannedPath goal(String uid) {
    return put(GOAL, uid);
  }

  /** Planner that found it, as named by the variable PLANNER. */
  public String planner() {
    return require(PLANNER);
  }

  public PlannedPath planner(String name) {
    return put(PLANNER, name);
  }

  /** Vehicle's reaction to the path. */
  public PathStatus status() {
    return require(STATUS);
  }

  public PlannedPath status(PathStatus value) {
    return put(STATUS, value);
  }

  /** Reason, for the operator; empty if all is well. */
  public Optional<String> reason() {
    return Optional.ofNullable(get(REASON));
  }

  public PlannedPath reason(String text) {
    return put(REASON, text);
  }

  /** Axes of the points; defaults to GLOBAL. */
  public ReferenceFrame referenceFrame() {
    return get(REFERENCE_FRAME);
  }

  public PlannedPath referenceFrame(ReferenceFrame frame) {
    return put(REFERENCE_FRAME, frame);
  }

  /** Corners of the path, from the vehicle's position at planning time to the goal. */
  public List<Point> points() {
    return require(POINTS);
  }

  public PlannedPath points(List<Point> value) {
    return put(POINTS, value);
  }

  /**
   * Path cost: its length with each metre weighted by the local cost [m]; empty if there is no
   * path.
   */
  public OptionalDouble cost() {
    return get(COST);
  }

  public PlannedPath cost(double metres) {
    return put(COST, metres);
  }
}
