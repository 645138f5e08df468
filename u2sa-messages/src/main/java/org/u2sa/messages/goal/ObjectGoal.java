package org.u2sa.messages.goal;

import java.util.List;
import java.util.OptionalDouble;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.ValueField;

/**
 * Goal to approach an object of a given type wherever the World Modeler detects one; needs no State
 * Estimator (thesis 4.3.2).
 */
public class ObjectGoal extends GoalInformation {
  private static final Schema<ObjectGoal> SCHEMA =
      Schema.of(ObjectGoal.class, ObjectGoal::new, GoalInformation.TYPE).since(3);
  private static final ValueField<ObjectGoal, String> OBJECT_TYPE =
      SCHEMA.requiredName("objectType");
  private static final NumberField<ObjectGoal> WITHIN =
      SCHEMA.requiredNumber("within", "m", 0.0, Double.POSITIVE_INFINITY);
  private static final NumberField<ObjectGoal> SPEED = SCHEMA.optionalNumber("speed", "m/s", 0.0);
  private static final ValueField<ObjectGoal, List<String>> POINTED = SCHEMA.ids("pointed");

  public static final MessageType<ObjectGoal> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends ObjectGoal> type() {
    return TYPE;
  }

  /** Type of the object, such as "buoy"; the nearest one counts. */
  public String objectType() {
    return require(OBJECT_TYPE);
  }

  public ObjectGoal objectType(String type) {
    return put(OBJECT_TYPE, type);
  }

  /** Distance to the object's surface at which the goal is reached [m]. */
  public double within() {
    return require(WITHIN);
  }

  public ObjectGoal within(double metres) {
    return put(WITHIN, metres);
  }

  /** Approach speed [m/s]; empty: unspecified. */
  public OptionalDouble speed() {
    return get(SPEED);
  }

  public ObjectGoal speed(double value) {
    return put(SPEED, value);
  }

  /** Subsystems to point at the object during the approach, such as "GIMBAL" or "ARM". */
  public List<String> pointed() {
    return get(POINTED);
  }

  public ObjectGoal pointed(List<String> subsystems) {
    return put(POINTED, subsystems);
  }

  @Override
  public ObjectGoal uid(String uid) {
    return (ObjectGoal) super.uid(uid);
  }
}
