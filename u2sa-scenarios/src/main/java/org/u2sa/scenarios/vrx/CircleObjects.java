package org.u2sa.scenarios.vrx;

import java.util.List;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.ValueField;

/** Objects to be circled once each, and others to be avoided; all of them may move. */
public final class CircleObjects extends GoalInformation {
  private static final Schema<CircleObjects> SCHEMA =
      Schema.of(CircleObjects.class, CircleObjects::new, GoalInformation.TYPE);
  private static final ValueField<CircleObjects, List<String>> CLOCKWISE =
      SCHEMA.texts("clockwise");
  private static final ValueField<CircleObjects, List<String>> ANTICLOCKWISE =
      SCHEMA.texts("anticlockwise");
  private static final ValueField<CircleObjects, List<String>> AVOIDED = SCHEMA.texts("avoided");
  private static final NumberField<CircleObjects> RADIUS =
      SCHEMA.requiredNumber("radius", "m", 0.1, 1000.0);
  private static final NumberField<CircleObjects> WITHIN =
      SCHEMA.requiredNumber("within", "m", 0.1, 1000.0);
  private static final NumberField<CircleObjects> CLEARANCE =
      SCHEMA.requiredNumber("clearance", "m", 0.0, 1000.0);

  public static final MessageType<CircleObjects> TYPE = SCHEMA.build();

  @Override
  public MessageType<? extends CircleObjects> type() {
    return TYPE;
  }

  /** Types of objects to circle clockwise, seen from above. */
  public List<String> clockwise() {
    return get(CLOCKWISE);
  }

  /** Types of objects to circle anticlockwise. */
  public List<String> anticlockwise() {
    return get(ANTICLOCKWISE);
  }

  /** Types of objects to keep away from. */
  public List<String> avoided() {
    return get(AVOIDED);
  }

  /** Radius of the circles [m]. */
  public double radius() {
    return require(RADIUS);
  }

  /** Maximum distance from the object while circling it [m]. */
  public double within() {
    return require(WITHIN);
  }

  /** Distance to keep from objects to be avoided [m]. */
  public double clearance() {
    return require(CLEARANCE);
  }
}
