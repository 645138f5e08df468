package org.u2sa.messages.mission;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/** Mission progress, in answer to a {@link MissionRequest}. */
public final class MissionReport extends U2SAData {
  private static final Schema<MissionReport> SCHEMA =
      Schema.of(MissionReport.class, MissionReport::new, U2SAData.TYPE).since(3);
  private static final ValueField<MissionReport, String> REQUEST_ID =
      SCHEMA.requiredId("requestId");
  private static final ValueField<MissionReport, String> SERVICE_NAME =
      SCHEMA.requiredName("serviceName");
  private static final ValueField<MissionReport, String> MISSION = SCHEMA.text("mission", "");
  private static final ValueField<MissionReport, List<GoalInformation>> GOALS =
      SCHEMA.messages("goals", GoalInformation.TYPE);
  private static final ValueField<MissionReport, List<Double>> FINISHED =
      SCHEMA.numbers("finished", "");
  private static final ValueField<MissionReport, List<String>> CURRENT = SCHEMA.ids("current");
  private static final ValueField<MissionReport, List<String>> UPCOMING = SCHEMA.ids("upcoming");
  private static final ValueField<MissionReport, List<String>> SEQUENCE = SCHEMA.ids("sequence");
  private static final ValueField<MissionReport, String> FAILSAFE = SCHEMA.optionalNote("failsafe");
  private static final NumberField<MissionReport> ELAPSED = SCHEMA.number("elapsed", "s", 0.0, 0.0);
  private static final NumberField<MissionReport> TIME_LIMIT =
      SCHEMA.optionalNumber("timeLimit", "s", 0.0);
  private static final ValueField<MissionReport, Long> BEGAN = SCHEMA.optionalCount("began", "µs");
  private static final ValueField<MissionReport, String> RESUMABLE =
      SCHEMA.optionalNote("resumable");
  private static final ValueField<MissionReport, Boolean> PAUSED = SCHEMA.optionalFlag("paused");

  private static final NumberField<MissionReport> HOME_ALTITUDE =
      SCHEMA.optionalNumber("homeAltitude", "m");

  public static final MessageType<MissionReport> TYPE = SCHEMA.build();

  @Override
  public MessageType<MissionReport> type() {
    return TYPE;
  }

  /** ID of the request answered. */
  public String requestId() {
    return require(REQUEST_ID);
  }

  public MissionReport requestId(String value) {
    return put(REQUEST_ID, value);
  }

  /** The service that answers. */
  public String serviceName() {
    return require(SERVICE_NAME);
  }

  public MissionReport serviceName(String value) {
    return put(SERVICE_NAME, value);
  }

  /** Name of the mission file in the Mission Manager. */
  public String mission() {
    return require(MISSION);
  }

  public MissionReport mission(String value) {
    return put(MISSION, value);
  }

  /** All goals, each with the result of its last pursuit. */
  public List<GoalInformation> goals() {
    return require(GOALS);
  }

  public MissionReport goals(List<GoalInformation> value) {
    return put(GOALS, List.copyOf(value));
  }

  /** How often each of {@link #goals()} was completed or abandoned, in the same order. */
  public List<Double> finished() {
    return require(FINISHED);
  }

  public MissionReport finished(List<Double> value) {
    return put(FINISHED, List.copyOf(value));
  }

  /** UIDs of the goals being pursued; empty: the mission is over. */
  public List<String> current() {
    return require(CURRENT);
  }

  public MissionReport current(List<String> value) {
    return put(CURRENT, List.copyOf(value));
  }

  /** UIDs of the goals that follow once the current one is completed. */
  public List<String> upcoming() {
    return require(UPCOMING);
  }

  public MissionReport upcoming(List<String> value) {
    return put(UPCOMING, List.copyOf(value));
  }

  /** UIDs of the goals in default order, which applies unless overridden by a goal's next. */
  public List<String> sequence() {
    return require(SEQUENCE);
  }

  public MissionReport sequence(List<String> value) {
    return put(SEQUENCE, List.copyOf(value));
  }

  /** Failsafe whose goals are pursued instead of the mission's goals; empty: none. */
  public Optional<String> failsafe() {
    return Optional.ofNullable(get(FAILSAFE));
  }

  public MissionReport failsafe(String value) {
    return put(FAILSAFE, value);
  }

  /** Elapsed mission time [s]. */
  public double elapsed() {
    return require(ELAPSED);
  }

  public MissionReport elapsed(double value) {
    return put(ELAPSED, value);
  }

  /** Time limit of the mission [s]; empty: unlimited. */
  public OptionalDouble timeLimit() {
    return get(TIME_LIMIT);
  }

  public MissionReport timeLimit(double value) {
    return put(TIME_LIMIT, value);
  }

  /** Start of the mission time [µs of the run's clock]; empty before. */
  public OptionalLong began() {
    return optionalCount(BEGAN);
  }

  public MissionReport began(long value) {
    return put(BEGAN, value);
  }

  /** Description of the position to which RESUME would return; empty: none. */
  public Optional<String> resumable() {
    return Optional.ofNullable(get(RESUMABLE));
  }

  public MissionReport resumable(String value) {
    return put(RESUMABLE, value);
  }

  /** Whether the mission is paused. False from senders that predate the field. */
  public boolean paused() {
    return Boolean.TRUE.equals(get(PAUSED));
  }

  public MissionReport paused(boolean value) {
    return put(PAUSED, value);
  }

  /**
   * Altitude of the ground at the home, in the home's frame [m]; empty if the mission does not
   * state it. The home among the {@link #goals()} has none, because a vehicle returns above it.
   */
  public OptionalDouble homeAltitude() {
    return get(HOME_ALTITUDE);
  }

  public MissionReport homeAltitude(double value) {
    return put(HOME_ALTITUDE, value);
  }
}
