package org.u2sa.scenarios.vrx;

import java.util.List;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.ValueField;

/** Gates to be found by the colours of their markers, and passed in order, each once. */
public final class GateCourse extends GoalInformation {
  private static final int TYPES = 4;
  private static final Schema<GateCourse> SCHEMA =
      Schema.of(GateCourse.class, GateCourse::new, GoalInformation.TYPE);
  private static final ValueField<GateCourse, List<String>> OBJECT_TYPES =
      SCHEMA.optionalTexts("objectTypes");
  private static final NumberField<GateCourse> SPEED = SCHEMA.optionalNumber("speed", "m/s", 0.01);

  public static final MessageType<GateCourse> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends GateCourse> type() {
    return TYPE;
  }

  /**
   * Types of the markers to port of the first gate, of those in between and of the last one, and to
   * starboard of all.
   *
   * @throws IllegalArgumentException unless there are four
   */
  public List<String> objectTypes() {
    List<String> types = get(OBJECT_TYPES);
    if (types == null || types.size() != TYPES) {
      throw new IllegalArgumentException(
          "goal \"" + uid() + "\", objectTypes: " + types + ": expected four types of markers");
    }
    return types;
  }

  /** Speed [m/s]; 3 if unset. */
  public double speed() {
    return get(SPEED).orElse(3.0);
  }
}
