package org.u2sa.messages.mission;

import java.util.List;
import org.u2sa.messages.contract.ConfigurationVariable;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/**
 * Describes a class of goals that the Mission Manager reads, possibly from a jar, so that a ground
 * station can show a form for its fields. Sent in answer to a {@link MissionRequest}.
 */
public final class GoalClass extends U2SAData {
  private static final Schema<GoalClass> SCHEMA =
      Schema.of(GoalClass.class, GoalClass::new, U2SAData.TYPE).since(3);
  private static final ValueField<GoalClass, String> SERVICE_NAME =
      SCHEMA.requiredName("serviceName");
  private static final ValueField<GoalClass, String> CLASS_NAME = SCHEMA.requiredName("className");
  private static final ValueField<GoalClass, List<ConfigurationVariable>> VARIABLES =
      SCHEMA.messages("variables", ConfigurationVariable.TYPE);
  private static final ValueField<GoalClass, List<String>> REQUIRED = SCHEMA.ids("required");

  public static final MessageType<GoalClass> TYPE = SCHEMA.build();

  @Override
  public MessageType<GoalClass> type() {
    return TYPE;
  }

  /** The Mission Manager that reads it. */
  public String serviceName() {
    return require(SERVICE_NAME);
  }

  public GoalClass serviceName(String value) {
    return put(SERVICE_NAME, value);
  }

  /** Name in mission files, such as "Waypoint". */
  public String className() {
    return require(CLASS_NAME);
  }

  public GoalClass className(String value) {
    return put(CLASS_NAME, value);
  }

  /**
   * Fields that a mission file may set: "double", "int", "boolean", "string", "texts", "point" or
   * "points", with unit in the frame GLOBAL, range, choices, and the default as value.
   */
  public List<ConfigurationVariable> variables() {
    return require(VARIABLES);
  }

  public GoalClass variables(List<ConfigurationVariable> value) {
    return put(VARIABLES, List.copyOf(value));
  }

  /** Names of the fields that a goal of this class must have. */
  public List<String> required() {
    return require(REQUIRED);
  }

  public GoalClass required(List<String> value) {
    return put(REQUIRED, List.copyOf(value));
  }
}
